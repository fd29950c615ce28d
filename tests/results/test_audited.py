"""The audit trail as people read it: names instead of rows, by person, day and vehicle."""

from typing import Any

import pytest

from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, lay_ground, measure

pytestmark = pytest.mark.dialect


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def told(found: list[dict[str, Any]]) -> list[tuple[str, int | None, str | None]]:
    return [(one["event"]["action"], one["subject"]["vehicle"], one["subject"]["target"]) for one in found]


def test_events_name_their_vehicle_and_target_and_are_found_by_person_day_and_vehicle(
    operator: Client, reviewer: Client, ground: Ground
) -> None:
    first, second = (add_vehicle(operator, ground.recording_id) for _ in range(2))
    roof = measure(operator, first["id"])
    measure(operator, second["id"], target="taillight")
    reviewer.made(f"/measurements/{roof['id']}/reviews", {"revision": 1, "verdict": "accepted"})
    address = f"/audit/events?survey_id={ground.survey_id}"
    of_first = operator.seen(f"{address}&vehicle={first['number']}")
    assert told(of_first) == [("review", 1, "roof"), ("create", 1, "roof"), ("create", 1, None)]
    assert of_first[0]["subject"]["measurement_id"] == roof["id"]
    assert of_first[0]["subject"]["survey"] is not None
    judge = of_first[0]["event"]["actor"]["id"]
    assert [one["event"]["action"] for one in operator.seen(f"{address}&person_id={judge}")] == ["review"]
    day = of_first[0]["event"]["at"][:10]
    assert len(operator.seen(f"{address}&day={day}&limit=1000")) >= 5
    assert operator.seen(f"{address}&day=1999-12-31") == []
    assert operator.seen(f"{address}&vehicle=77") == []
    page = operator.seen(f"{address}&vehicle=1&before_id={of_first[1]['event']['id']}")
    assert told(page) == [("create", 1, None)]
    assert {"Reviewer", "Operator"} <= {one["name"] for one in operator.seen("/audit/people")}


def test_what_has_a_name_is_called_by_it(operator: Client, ground: Ground) -> None:
    found = operator.seen(f"/audit/events?survey_id={ground.survey_id}&entity=camera")
    assert [one["subject"]["name"] for one in found] == ["Test camera"]
