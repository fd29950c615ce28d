"""What points are clicked on: a recording with its pose, and a vehicle that passes in twelve frames."""

import pytest

from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, lay_ground


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


@pytest.fixture
def vehicle_id(operator: Client, ground: Ground) -> int:
    return int(add_vehicle(operator, ground.recording_id, last_frame=11)["id"])
