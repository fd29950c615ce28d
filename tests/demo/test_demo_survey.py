"""The demonstration survey, cut to two vehicles: whole or not there, made once, and true to its scene."""

import io
import json
import math
import threading
import zipfile
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from sightline.demo import build, parts
from sightline.demo.request import ensure_requested
from sightline.errors import SightlineError
from sightline.geometry.board import Board
from sightline.geometry.corners import find_board
from sightline.infra.audit.verification import verify_records
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Cancelled
from sightline.infra.services import Services
from sightline.media.cancelling import IngestCancelled
from sightline.media.images import read_image
from sightline.simulation.scan_art import EYE_M
from sightline.simulation.scan_traffic import demo_traffic
from sightline.simulation.truth import spots_of
from sightline.surveys.store import demo_survey_id
from tests.support.app import Client

SCENE, SCAN_VEHICLES = "day:2", 2


def request(services: Services) -> Job | None:
    with services.writing() as session:
        return ensure_requested(session, scenes=[SCENE], scan_vehicles=SCAN_VEHICLES)


@pytest.mark.once  # rendering and measuring take most of it
def test_it_is_made_once_and_its_heights_are_the_truth(
    services: Services,
    admin: Client,
    nobody: Client,
    work: Callable[[], list[Job]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made: list[parts.Parts] = []

    def make_once(*arguments: Any) -> parts.Parts:
        made.extend([] if made else [parts.make_parts(*arguments)])
        return made[0]

    monkeypatch.setattr(build, "make_parts", make_once)
    monkeypatch.setattr("sightline.demo.parts.os.cpu_count", lambda: 1)  # one child draws: two import twice
    first, again = request(services), request(services)
    assert first is not None and again is not None and first.id == again.id

    def break_off(*_arguments: Any, **_more: Any) -> None:
        raise SightlineError("said", sentence="The lamp fell over; put it up again.")

    with monkeypatch.context() as broken:
        broken.setattr(build, "judge", break_off)
        assert [job.error for job in work()] == ["The lamp fell over; put it up again."]
    # nothing of the try that broke off is left, so the next one starts clean
    assert admin.seen("/surveys") == [] and admin.seen("/catalogue?q=cor") == []
    assert admin.seen("/session")["demo_survey_id"] is None
    assert admin.seen("/samples")["clip"] is None

    second = request(services)
    assert second is not None and second.id != first.id
    ended = work()
    assert [job.state for job in ended] == ["done"], ended[0].error
    assert request(services) is None
    survey_id = admin.seen("/session")["demo_survey_id"]
    assert ended[0].result == {"survey_id": survey_id}
    check_truth(services, admin, survey_id)
    check_scan(admin, survey_id)
    check_people(nobody, admin)
    check_samples(admin, survey_id)
    with services.reading() as session:
        assert demo_survey_id(session) == survey_id
        assert verify_records(session).ok


def check_truth(services: Services, admin: Client, survey_id: int) -> None:
    """Lens, pose and heights as our own code found them, against the scene they were rendered from."""
    folder = parts.demonstration_folder(services)
    truth = json.loads((folder / "truth.json").read_text())["day"]
    assert len(list((folder / "lab").glob("*.png"))) == truth["lab"]["images"]
    camera = admin.seen(f"/surveys/{survey_id}/cameras")[0]
    document = admin.seen(f"/calibrations/{camera['current_calibration_id']}")["document"]
    assert document["fx_px"] == pytest.approx(truth["camera"]["fx_px"], rel=0.005)
    pose = admin.seen(f"/poses/{admin.seen(f'/surveys/{survey_id}/poses')[0]['id']}")["document"]
    rotation = np.array(pose["cam_from_road"]["rotation"])
    centre = -rotation.T @ np.array(pose["cam_from_road"]["translation_m"])
    assert centre == pytest.approx(np.array(truth["camera"]["centre_m"]), abs=0.01)
    vehicles = admin.seen(f"/surveys/{survey_id}/vehicles")
    assert [one["number"] for one in vehicles] == [one["vehicle_number"] for one in truth["passes"]]
    apart = [
        (measured["height_m"] - one["true_heights_m"][measured["target"]]) / measured["u_height_m"]
        for vehicle, one in zip(vehicles, truth["passes"], strict=True)
        for measured in vehicle["measurements"]
        if measured["status"] == "ok" and measured["review"]["verdict"] != "rejected"
    ]
    assert len(apart) >= 4
    assert max(abs(value) for value in apart) < 3.5, apart
    assert math.sqrt(sum(value**2 for value in apart) / len(apart)) < 2.0, apart
    recording = admin.seen(f"/surveys/{survey_id}/recordings")[0]
    assert recording["state"] == "ready" and recording["thumbs"]
    assert admin.http.get(recording["thumbs"][0]["url"]).status_code == 200
    still = admin.get(f"/recordings/{recording['id']}/frames/{vehicles[0]['best_frame']}.jpg")
    assert still.status_code == 200


def check_samples(admin: Client, survey_id: int) -> None:
    """What a newcomer drops calibrates a camera, is read as a recording, and fills the catalogue."""
    found = admin.seen("/samples")
    board = Board(found["pictures"]["columns"], found["pictures"]["rows"], found["pictures"]["square_m"])
    with zipfile.ZipFile(io.BytesIO(admin.get("/samples/pictures.zip").content)) as archive:
        names = archive.namelist()
        assert len(names) == found["pictures"]["count"] >= 10
        assert find_board(read_image(archive.read(names[0]), names[0]), board) is not None
    assert found["clip"] == admin.seen(f"/surveys/{survey_id}/recordings")[0]["id"]
    assert admin.get(f"/recordings/{found['clip']}/video").content[4:8] == b"ftyp"
    models = admin.get("/samples/catalogue.csv").content
    plan = admin.post("/catalogue/import/preview", files={"file": ("cars.csv", models, "text/csv")}).json()
    # the models are those that the demonstration put into the catalogue
    assert plan["problem"] is None and plan["counts"]["refused"] == 0 and plan["counts"]["same"] > 5


def check_scan(admin: Client, survey_id: int) -> None:
    """The line scan's vehicles as our own code found them, against the motion that they were made with."""
    (scan,) = admin.seen(f"/surveys/{survey_id}/scans")
    assert (scan["state"], scan["counts"]["accepted"]) == ("ready", 2)
    found = admin.seen(f"/scans/{scan['id']}/vehicles")
    for one, car in zip(found, demo_traffic()[:SCAN_VEHICLES], strict=True):
        motion = one["measurement"]
        assert motion["speed_mps"] == pytest.approx(car.speed_mps, rel=0.002)
        assert one["make"] == car.vehicle.model.make
        assert abs(one["length_error_m"]) < 0.02 and abs(one["wheelbase_error_m"]) < 0.06
    assert admin.get(f"/scans/{scan['id']}/tiles/1/0/0").status_code == 200
    heights_of_the_scan(admin, scan["id"], found)
    told = admin.seen(f"/surveys/{survey_id}/scan-statistics")
    assert told["counted"]["used"] == 2 and len(told["paper"]) == 15
    overall = next(one for one in told["length_errors"] if one["group"] == "overall")
    errors = [one["length_error_m"] for one in found]
    assert overall["figures"]["mae_m"]["value"] == pytest.approx(sum(map(abs, errors)) / 2)
    spreads = {one["quantity"]: one for one in told["spreads"]}
    assert spreads["time_gap"]["n"] == 1 and spreads["speed"]["n"] == 2
    assert 85.0 in [one["percent"] for one in spreads["speed"]["percentiles"]]


def heights_of_the_scan(admin: Client, scan_id: int, found: list[Any]) -> None:
    """The rod gives the camera's height, and the clicks the heights that the vehicles were drawn with."""
    pose = admin.seen(f"/scans/{scan_id}/line-pose")["current"]["solved"]
    assert abs(pose["camera_height_m"] - EYE_M) < 1.5 * pose["U95_camera_height_m"] and pose["warnings"] == []
    true = {
        (one["id"], spot.name): spot.height_m
        for one, car in zip(found, demo_traffic()[:SCAN_VEHICLES], strict=True)
        for spot in spots_of(car.vehicle)
    }
    heights = admin.seen(f"/scans/{scan_id}/heights")
    assert len(heights) == 6
    apart = [
        (one["height_m"] - true[one["vehicle_id"], one["target"]]) / one["U95_height_m"] for one in heights
    ]
    # one in twenty lies outside
    assert max(map(abs, apart)) < 1.5 and sum(abs(one) < 1 for one in apart) >= 5, apart
    assert max(one["U95_height_m"] for one in heights) < 0.05


def check_people(nobody: Client, admin: Client) -> None:
    """The two names at the work are no accounts anybody could use."""
    for person in admin.seen("/people"):
        if person["email"].startswith("demonstration-"):
            assert not person["active"] and not person["has_password"]
            answer = nobody.post("/session", {"email": person["email"], "password": "demonstration"})
            assert answer.status_code == 401


def test_cancelled_by_somebody_it_ends_as_cancelled(
    services: Services, work: Callable[[], list[Job]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whichever of its threads says first that it stopped."""

    def stopped(*_: object) -> None:
        raise IngestCancelled("said", sentence="The ingest of the demonstration was cancelled.")

    monkeypatch.setattr(build, "make_parts", stopped)
    request(services)
    (job,) = work()
    assert (job.state, job.error) == ("cancelled", None)
    assert not [one for one in threading.enumerate() if one.name.startswith("demonstration")]


@pytest.mark.once
def test_cancelled_in_the_middle_it_leaves_nothing(
    services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sightline.demo.parts.os.cpu_count", lambda: 1)

    def cancelled(_fraction: float, _message: str) -> None:
        raise Cancelled("said", sentence="Cancelled.")

    with pytest.raises(Cancelled):
        parts.make_parts(services, cancelled, (SCENE,))
    assert not any(services.scratch.iterdir())
    assert not [one for one in threading.enumerate() if one.name.startswith("demonstration")]
