"""The server's clock goes back by an hour: order is by number, nothing is lost, no figure or chain breaks."""

import datetime as real
from collections.abc import Callable
from pathlib import Path

import pytest

from sightline.export.verify.package import verify_package
from sightline.infra.audit.verification import verify_records
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.database import types
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, clicks, lay_ground, measure
from tests.support.packages import written

pytestmark = pytest.mark.dialect


class AnHourBack(real.datetime):
    @classmethod
    def now(cls, tz: real.tzinfo | None = None) -> real.datetime:  # type: ignore[override]
        return real.datetime.now(tz) - real.timedelta(hours=1)


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def test_what_comes_later_counts_though_its_time_is_earlier(
    operator: Client,
    reviewer: Client,
    ground: Ground,
    services: Services,
    work: Callable[[], list[Job]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
    first = measure(operator, vehicle_id)
    reviewer.made(f"/measurements/{first['id']}/reviews", {"revision": 1, "verdict": "accepted"})

    monkeypatch.setattr(types, "datetime", AnHourBack)
    revised = operator.put(f"/measurements/{first['id']}", {**clicks(1.3), "revision": 1})
    assert revised.status_code == 200, revised.text
    now = operator.seen(f"/measurements/{first['id']}")
    assert now["created_at"] < first["created_at"]
    assert (now["revision"], now["review"]["verdict"]) == (2, "to_review")
    assert operator.seen(f"/vehicles/{vehicle_id}")["measurements"][0]["revision"] == 2
    reviewer.made(
        f"/measurements/{first['id']}/reviews", {"revision": 2, "verdict": "rejected", "reason": "blurred"}
    )
    assert operator.seen(f"/measurements/{first['id']}")["review"]["verdict"] == "rejected"

    numbers = [one["number"] for one in reviewer.seen(f"/audit?survey_id={ground.survey_id}")]
    assert numbers == sorted(numbers, reverse=True)
    with services.reading() as session:
        assert verify_records(session).ok
    job = reviewer.made(f"/surveys/{ground.survey_id}/exports")
    assert [one.state for one in work()] == ["done"], job
    found = verify_package(FolderFiles(written(services, ground.survey_id, tmp_path / "package")))
    assert found.ok, found.problem
