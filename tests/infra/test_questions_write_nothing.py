"""GET and HEAD ask: whatever is asked of the whole API, no statement writes."""

import re
from uuid import uuid4

import pytest
from fastapi import FastAPI
from sqlalchemy import event

from sightline.infra.services import Services
from tests.support.app import TUS, Client, announce
from tests.support.ground import Ground, add_vehicle, lay_ground, measure

pytestmark = pytest.mark.once

_WRITES = re.compile(r"\s*(INSERT|UPDATE|DELETE|REPLACE|COPY|BEGIN IMMEDIATE)", re.IGNORECASE)
# Whatever else a path wants: these words.
_WORDS = {"name": "road.mp4", "target": "roof", "kind": "pose", "method": "direct"}


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def test_questions_write_nothing(
    app: FastAPI, admin: Client, operator: Client, services: Services, ground: Ground
) -> None:
    vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
    first = measure(operator, vehicle_id)
    measure(operator, vehicle_id, client_key=str(uuid4()), repeat_of=first["id"], inset_m=None)
    location = announce(operator, ground.survey_id, "b.mp4", 9).headers["Location"]
    ids = {"n": 2, "upload_id": int(location.rpartition("/")[2])}
    written: list[str] = []

    def note(*given: object) -> None:
        if _WRITES.match(str(given[2])):
            written.append(str(given[2]))

    event.listen(services.engine, "before_cursor_execute", note)
    answered: dict[str, int] = {}
    for path, methods in app.openapi()["paths"].items():
        for method in {"get", "head"} & set(methods):
            address = re.sub(r"{(\w+)}", lambda found: str({**_WORDS, **ids}.get(found[1], 1)), path)
            answer = admin.http.request(method, address, headers=TUS)
            answered[f"{method} {path}"] = answer.status_code
            assert not written, (method, address, written)
    event.remove(services.engine, "before_cursor_execute", note)
    good = [place for place, status in answered.items() if status == 200]
    assert all(status < 500 for status in answered.values()), answered
    assert {"get /api/session", "head /api/uploads/{upload_id}"} <= set(good), answered
    # the rest wants line scans, photographs and exports, of which this ground has none
    assert len(good) >= 0.6 * len(answered), {k: v for k, v in answered.items() if v != 200}
