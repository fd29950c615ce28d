"""Passes looked for in the background, split and joined: nothing doubled, torn or lost."""

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.media.video.writer import write_mp4
from sightline.messages.said import Said
from tests.media.street import car, street
from tests.support.app import Client, error_of, upload
from tests.support.ground import Ground, add_vehicle, lay_ground, measure
from tests.support.working import run_jobs

Work = Callable[[], list[Job]]


@pytest.fixture(scope="session")
def street_clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two cars, one each way."""
    path = tmp_path_factory.mktemp("street") / "street.mp4"
    cars = [car(15), car(55, right=False, near=False, grey=40)]
    write_mp4(path, (np.repeat(g[..., None], 3, 2) for g in street(100, cars)), 30, crf=18)
    return path


@pytest.fixture
def street_id(operator: Client, survey_id: int, street_clip: Path, work: Work) -> int:
    recording_id = upload(operator, survey_id, street_clip)
    work()
    return recording_id


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def search(operator: Client, recording_id: int, work: Work) -> dict[str, Any]:
    operator.made(f"/recordings/{recording_id}/find-passes")
    job = work()[-1]
    assert job.state == "done" and job.kind == "passes", job
    assert job.result is not None
    shown = operator.seen(f"/jobs/{job.id}")["result"]["message"]
    assert [one["message"] for one in shown] == [str(Said.read(one)) for one in job.result["message"]]
    return job.result


def test_what_is_found_is_stored_once_and_leaves_alone_what_people_did(
    operator: Client, survey_id: int, street_id: int, work: Work
) -> None:
    result = search(operator, street_id, work)
    assert (result["found"], result["added"]) == (2, 2)
    assert [str(Said.read(one)) for one in result["message"]] == ["2 passes were found."]
    first, second = operator.seen(f"/surveys/{survey_id}/vehicles")
    assert (first["origin"], first["direction"], second["direction"]) == ("found", "right", "left")
    assert first["lighting"] is None and first["detection"]["lighting_proposed"] == "daytime"
    assert first["first_frame"] <= first["best_frame"] <= first["last_frame"] < second["last_frame"]
    made = [e for e in operator.seen(f"/audit?survey_id={survey_id}") if e["entity"] == "vehicle"]
    assert [one["action"] for one in made] == ["create", "create"]

    edit = {"version": 1, "make": "Corvane", "first_frame": first["first_frame"] + 2}
    edited = operator.put(f"/vehicles/{first['id']}", edit).json()
    assert operator.delete(f"/vehicles/{second['id']}").status_code == 204
    again = search(operator, street_id, work)
    assert (again["found"], again["added"]) == (2, 0)
    (told,) = map(Said.read, again["message"])
    assert str(told) == "2 passes were found: none new, 2 known or discarded before."
    assert operator.seen(f"/surveys/{survey_id}/vehicles") == [edited]


def test_a_search_is_asked_for_once_by_an_operator_and_can_be_cancelled(
    operator: Client, viewer: Client, street_id: int, work: Work
) -> None:
    path = f"/recordings/{street_id}/find-passes"
    assert viewer.post(path).status_code == 403
    job = operator.made(path)
    assert "already" in error_of(operator.post(path))
    assert operator.made(f"/jobs/{job['id']}/cancel")["state"] == "cancelled"
    work()
    assert operator.made(path)["state"] == "queued"
    assert "no recording" in error_of(operator.post("/recordings/999/find-passes"))


def test_a_pass_is_split_and_joined_again(operator: Client, survey_id: int, recording_id: int) -> None:
    whole = add_vehicle(operator, recording_id, first_frame=0, last_frame=8, best_frame=2, lighting="daytime")
    path = f"/vehicles/{whole['id']}"
    parts = operator.made(f"{path}/split", {"frame": 5, "version": 1})
    earlier, later = parts["earlier"], parts["later"]
    assert earlier["id"] == whole["id"]
    assert (earlier["first_frame"], earlier["last_frame"], earlier["best_frame"]) == (0, 4, 2)
    assert (later["first_frame"], later["last_frame"], later["best_frame"]) == (5, 8, None)
    assert later["lighting"] == "daytime"
    old = operator.post(f"{path}/split", {"frame": 3, "version": 1})
    assert old.status_code == 409 and "Operator" in error_of(old)
    for frame in (0, 5):
        assert "cannot split" in error_of(operator.post(f"{path}/split", {"frame": frame, "version": 2}))
    wish = {"other_id": later["id"], "version": 2, "other_version": 1}
    joined = operator.made(f"{path}/join", wish)
    assert (joined["id"], joined["first_frame"], joined["last_frame"]) == (whole["id"], 0, 8)
    assert [one["id"] for one in operator.seen(f"/surveys/{survey_id}/vehicles")] == [whole["id"]]


def test_measurements_keep_their_vehicle(operator: Client, ground: Ground) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, first_frame=0, last_frame=8)
    measure(operator, vehicle["id"], frame=6)
    version = operator.seen(f"/vehicles/{vehicle['id']}")["version"]
    parts = operator.made(f"/vehicles/{vehicle['id']}/split", {"frame": 4, "version": version})
    earlier, later = parts["earlier"], parts["later"]
    assert later["id"] == vehicle["id"] and len(later["measurements"]) == 1
    assert earlier["measurements"] == [] and (earlier["first_frame"], earlier["last_frame"]) == (0, 3)

    measure(operator, earlier["id"], frame=2)
    wish = {"other_id": later["id"], "version": earlier["version"], "other_version": later["version"]}
    assert "both have measurements" in error_of(operator.post(f"/vehicles/{earlier['id']}/join", wish))

    measure(operator, vehicle["id"], frame=5, target="taillight")
    torn = operator.post(f"/vehicles/{vehicle['id']}/split", {"frame": 6, "version": later["version"]})
    assert torn.status_code == 409 and "before and after frame 6" in error_of(torn)


def test_the_pass_with_measurements_stays_when_two_are_joined(operator: Client, ground: Ground) -> None:
    empty = add_vehicle(operator, ground.recording_id, first_frame=0, last_frame=3)
    measured = add_vehicle(operator, ground.recording_id, first_frame=4, last_frame=8)
    measure(operator, measured["id"], frame=5)
    wish = {"other_id": measured["id"], "version": 1, "other_version": 1}
    joined = operator.made(f"/vehicles/{empty['id']}/join", wish)
    assert joined["id"] == measured["id"] and (joined["first_frame"], joined["last_frame"]) == (0, 8)
    assert operator.get(f"/vehicles/{empty['id']}").status_code == 404


def test_passes_are_looked_for_after_an_upload_where_the_setting_says_so(
    operator: Client, services: Services, survey_id: int, street_clip: Path
) -> None:
    asked = dataclasses.replace(services, settings=services.settings.model_copy(update={"find_passes": True}))
    upload(operator, survey_id, street_clip)
    assert [job.kind for job in run_jobs(asked)] == ["ingest"]
    assert [(job.kind, job.state) for job in run_jobs(asked)] == [("passes", "done")]
    assert len(operator.seen(f"/surveys/{survey_id}/vehicles")) == 2


def test_recordings_tell_how_many_passes_they_have(
    operator: Client, viewer: Client, survey_id: int, recording_id: int
) -> None:
    def counted() -> list[dict[str, int]]:
        found: list[dict[str, int]] = viewer.seen(f"/surveys/{survey_id}/pass-counts")
        return found

    assert counted() == [{"recording_id": recording_id, "passes": 0}]
    first, _ = [add_vehicle(operator, recording_id) for _ in range(2)]
    assert counted() == [{"recording_id": recording_id, "passes": 2}]
    body = {"version": first["version"], "discarded": "no_vehicle"}
    assert operator.put(f"/vehicles/{first['id']}", body).status_code == 200
    assert counted() == [{"recording_id": recording_id, "passes": 1}]
