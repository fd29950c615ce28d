"""The demonstration survey: whole or not there, made once, and true to its scene."""

import io
import json
import math
import threading
import zipfile
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from sightline.demo import build, made, parts
from sightline.demo import scan as scan_demo
from sightline.demo.request import ensure_requested
from sightline.errors import SightlineError, Stopped
from sightline.export.verify.package import verify_package
from sightline.geometry.board import Board
from sightline.geometry.corners import find_board
from sightline.infra.audit.verification import verify_records
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.media.images import read_image
from sightline.surveys.store import demo_survey_id
from tests.simulation.make import SCAN_VEHICLES
from tests.simulation.scan_art import EYE_M
from tests.simulation.truth import spots_of
from tests.support.app import Client
from tests.support.packages import written

pytestmark = pytest.mark.once
TRUTH: dict[str, Any] = json.loads(made.TRUTH.read_text())


def request(services: Services) -> Job | None:
    with services.writing() as session:
        return ensure_requested(session)


def test_it_is_made_once_and_its_heights_are_the_truth(
    services: Services,
    admin: Client,
    nobody: Client,
    work: Callable[[], list[Job]],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    found: list[parts.Parts] = []

    def make_once(*arguments: Any) -> parts.Parts:
        found.extend([] if found else [parts.make_parts(*arguments)])
        return found[0]

    monkeypatch.setattr(build, "make_parts", make_once)
    first, again = request(services), request(services)
    assert first is not None and again is not None and first.id == again.id

    def break_off(*_arguments: Any, **_more: Any) -> None:
        raise SightlineError("said", sentence="The lamp fell over; put it up again.")

    with monkeypatch.context() as broken:
        broken.setattr(build, "judge", break_off)
        assert [str(job.error) for job in work()] == ["The lamp fell over; put it up again."]
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
    check_truth(admin, survey_id)
    check_shown(admin, survey_id)
    check_scan(admin, survey_id)
    check_people(nobody, admin)
    check_samples(admin, survey_id)
    with services.reading() as session:
        assert demo_survey_id(session) == survey_id
        assert verify_records(session).ok
    check = verify_package(FolderFiles(written(services, survey_id, tmp_path / "package")))
    assert check.ok, check.problem


def check_truth(admin: Client, survey_id: int) -> None:
    """Lens, poses and heights as our own code found them, against the scenes they were rendered from."""
    scenes = list(TRUTH["scenes"].values())
    camera = admin.seen(f"/surveys/{survey_id}/cameras")[0]
    document = admin.seen(f"/calibrations/{camera['current_calibration_id']}")["document"]
    assert document["fx_px"] == pytest.approx(scenes[0]["camera"]["fx_px"], rel=0.005)
    poses = admin.seen(f"/surveys/{survey_id}/poses")
    by_recording = sorted(poses, key=lambda one: int(one["recording_id"]))
    for one, scene in zip(by_recording, scenes, strict=True):
        pose = admin.seen(f"/poses/{one['id']}")["document"]
        rotation = np.array(pose["cam_from_road"]["rotation"])
        centre = -rotation.T @ np.array(pose["cam_from_road"]["translation_m"])
        assert centre == pytest.approx(np.array(scene["camera"]["centre_m"]), abs=0.01)
    passes = [one for scene in scenes for one in scene["passes"]]
    vehicles = admin.seen(f"/surveys/{survey_id}/vehicles")
    apart = [
        (measured["height_m"] - one["true_heights_m"][measured["target"]]) / measured["u_height_m"]
        for vehicle, one in zip(vehicles, passes, strict=True)
        for measured in vehicle["measurements"]
        if measured["status"] == "ok" and measured["review"]["verdict"] != "rejected"
    ]
    assert len(apart) >= 30
    assert max(abs(value) for value in apart) < 3.5, apart
    assert math.sqrt(sum(value**2 for value in apart) / len(apart)) < 2.0, apart


def check_shown(admin: Client, survey_id: int) -> None:
    """What the description promises is there, and pictures can be looked at."""
    survey, vehicles = admin.seen(f"/surveys/{survey_id}"), admin.seen(f"/surveys/{survey_id}/vehicles")
    lighting = [one["lighting"] for one in vehicles]
    by_day, low = lighting.count("daytime"), lighting.count("low_light")
    assert f"{by_day} vehicles of invented makes in daylight, {low} in low light" in survey["description"]
    measured = sum(bool(one["measurements"]) for one in vehicles)
    assert f"{measured} of them are measured" in survey["description"]
    again = sum(any(m["review"]["verdict"] == "rejected" for m in one["measurements"]) for one in vehicles)
    other = len(vehicles) - measured
    assert f"{again} has a rejected height and is to be measured again" in survey["description"]
    assert f"That one and the other {other} are for you to try" in survey["description"]
    assert survey["counts"]["vehicles_measured"] == len(vehicles) - again - other
    verdicts = {m["review"]["verdict"] for one in vehicles for m in one["measurements"]}
    assert verdicts == {"accepted", "fixed", "rejected", "to_review"}
    # one truth, heights of frames and of line scans: Overview and Review
    counts, work = survey["counts"], admin.seen(f"/surveys/{survey_id}/review-work")
    assert counts["to_review"] == work["to_review"] + work["own"] + work["in_lots"]
    assert (counts["accepted"], counts["rejected"]) == (work["accepted"], work["rejected"])
    assert (
        counts["measurements"]
        < work["heights"]
        == sum(counts[one] for one in ("to_review", "accepted", "rejected"))
    )
    # results are of frames alone: the overview, whose words the package page repeats, tells both apart
    results, scans = admin.seen(f"/statistics?survey_id={survey_id}")["counted"], survey["scans"]
    review = next(one["summary"] for one in survey["steps"] if one["key"] == "review")
    told = {one["code"]: one["values"] for one in review}
    assert told["overview-accepted"] == {"count": results["measurements"], "scans": scans["heights_accepted"]}
    assert told["overview-review"]["count"] == results["left_out"]["to_review"]
    assert told["overview-review-line-heights"]["count"] == scans["heights_to_review"]
    assert counts["to_review"] == results["left_out"]["to_review"] + scans["heights_to_review"]
    for recording in admin.seen(f"/surveys/{survey_id}/recordings"):
        assert recording["state"] == "ready" and recording["thumbs"]
        assert admin.http.get(recording["thumbs"][0]["url"]).status_code == 200
        best = next(one["best_frame"] for one in vehicles if one["recording_id"] == recording["id"])
        assert admin.get(f"/recordings/{recording['id']}/frames/{best}.jpg").status_code == 200


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
    assert (scan["state"], scan["counts"]["accepted"], scan["counts"]["rejected"]) == ("ready", 7, 1)
    found = admin.seen(f"/scans/{scan['id']}/vehicles")
    assert f"{len(found)} more vehicles" in admin.seen(f"/surveys/{survey_id}")["description"]
    for n, (one, car) in enumerate(zip(found, SCAN_VEHICLES, strict=True)):
        motion = one["measurement"]
        assert motion["speed_mps"] == pytest.approx(car.speed_mps, rel=0.002) or n == scan_demo.SLIPPED
        if n in scan_demo.PLAIN:
            continue
        assert one["make"] == car.vehicle.model.make
        assert abs(one["length_error_m"]) < 0.02 or n == scan_demo.SLIPPED
        if n in (*scan_demo.UNWHEELED, scan_demo.SLIPPED):
            continue
        # wheelbases are off by the operator's clicks alone, most of them to one side: no bias of the rig
        front, rear = made.truth().scan.vehicles[n].wheel_lines_1
        clicked = (motion["rear_wheel_line"] - rear) - (motion["front_wheel_line"] - front)
        by_clicks_m = clicked / scan_demo.RIG.line_rate_hz * car.speed_mps
        assert one["wheelbase_error_m"] == pytest.approx(by_clicks_m, abs=0.001)
    assert admin.get(f"/scans/{scan['id']}/tiles/1/0/0").status_code == 200
    heights_of_the_scan(admin, scan["id"], found)
    told = admin.seen(f"/surveys/{survey_id}/scan-statistics")
    assert told["counted"]["used"] == 7 and len(told["paper"]) == 15
    overall = next(one for one in told["length_errors"] if one["group"] == "overall")
    errors = [abs(one["length_error_m"]) for n, one in enumerate(found) if n in range(6)]
    assert overall["figures"]["mae_m"]["value"] == pytest.approx(sum(errors) / 6)
    spreads = {one["quantity"]: one for one in told["spreads"]}
    assert spreads["time_gap"]["n"] == 6 and spreads["speed"]["n"] == 7
    assert 85.0 in [one["percent"] for one in spreads["speed"]["percentiles"]]


def heights_of_the_scan(admin: Client, scan_id: int, found: list[Any]) -> None:
    """The rod gives the camera's height, and the clicks the heights that the vehicles were drawn with."""
    pose = admin.seen(f"/scans/{scan_id}/line-pose")["current"]["solved"]
    assert abs(pose["camera_height_m"] - EYE_M) < 1.5 * pose["U95_camera_height_m"] and pose["warnings"] == []
    true = {
        (one["id"], spot.name): spot.height_m
        for one, car in zip(found, SCAN_VEHICLES, strict=True)
        for spot in spots_of(car.vehicle)
    }
    heights = admin.seen(f"/scans/{scan_id}/heights")
    assert len(heights) == 17
    apart = [
        (one["height_m"] - true[one["vehicle_id"], one["target"]]) / one["U95_height_m"] for one in heights
    ]
    # one in twenty lies outside
    assert max(map(abs, apart)) < 1.5 and sum(abs(one) < 1 for one in apart) >= 15, apart
    u95_m = {id_: [one["U95_height_m"] for one in heights if one["vehicle_id"] == id_] for id_, _ in true}
    first_two = [one["id"] for one in found[:2]]
    assert max(value for id_ in first_two for value in u95_m[id_]) < 0.05
    assert max(value for of_one in u95_m.values() for value in of_one) < 0.06


def check_people(nobody: Client, admin: Client) -> None:
    """The two names at the work are no accounts anybody could use."""
    for person in admin.seen("/people"):
        if person["email"].startswith("demonstration-"):
            assert not person["active"] and not person["has_password"]
            answer = nobody.post("/session", {"email": person["email"], "password": "demonstration"})
            assert answer.status_code == 401


def test_a_file_that_went_with_an_earlier_one_is_made_again(
    services: Services, work: Callable[[], list[Job]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The deletion of an earlier demonstration was waiting."""
    made_parts = SimpleNamespace(keys=["ab/cd/abcd.mp4"])
    monkeypatch.setattr(build, "make_parts", lambda *_: made_parts)
    request(services)
    (job,) = work()
    assert (job.state, job.error) == ("queued", None)


def test_cancelled_by_somebody_it_ends_as_cancelled(
    services: Services, work: Callable[[], list[Job]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whichever of its threads says first that it stopped."""

    def stopped(*_: object) -> None:
        raise Stopped("said", sentence="The ingest of the demonstration was cancelled.")

    monkeypatch.setattr(build, "make_parts", stopped)
    request(services)
    (job,) = work()
    assert (job.state, job.error) == ("cancelled", None)
    assert not [one for one in threading.enumerate() if one.name.startswith("demonstration")]


@pytest.mark.once
def test_cancelled_in_the_middle_it_leaves_nothing(
    services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    def cancelled(_fraction: float, _message: str) -> None:
        raise Stopped("said", sentence="Cancelled.")

    monkeypatch.setattr(parts, "_lens", lambda *_: ((), None))  # the first that ends, with all others begun
    with pytest.raises(Stopped):
        parts.make_parts(services, cancelled)
    assert not any(services.scratch.iterdir())
    assert not [one for one in threading.enumerate() if one.name.startswith("demonstration")]
