"""Cameras: images with their detection; calibrations from images, a clip, and other tools' files."""

import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from sightline.cameras.calibrations import images
from sightline.cameras.calibrations.calibrating import CalibrationRequest, frames_of
from sightline.errors import Away
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.media.store.local import LocalStore
from sightline.recordings.calibrating import calibrate_job
from tests.support.app import Client, error_of, upload
from tests.support.boards import COLUMNS, FOCAL_PX, HEIGHT, POSES, ROWS, SQUARE_M, WIDTH, picture_bytes, view
from tests.support.waiting import NEVER_S

pytestmark = pytest.mark.once

Work = Callable[[], list[Job]]
BOARD = {"columns": COLUMNS, "rows": ROWS, "square_m": SQUARE_M}
OPENCV = """%YAML:1.0
---
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 535.9, 0., 342.3, 0., 535.9, 235.6, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -0.266, -0.0386, 0.00178, -0.00028, 0.238 ]
"""


@pytest.fixture
def camera_id(operator: Client, survey_id: int) -> int:
    return int(operator.made(f"/surveys/{survey_id}/cameras", {"name": "Left"})["id"])


def drop(client: Client, camera_id: int, content: bytes, name: str = "a.png", columns: int = COLUMNS) -> Any:
    path = f"/cameras/{camera_id}/images?columns={columns}&rows={ROWS}"
    return client.post(path, files={"file": (name, content)})


def test_an_image_says_at_once_what_was_found(operator: Client, viewer: Client, camera_id: int) -> None:
    answer = drop(operator, camera_id, picture_bytes(view(POSES[0])))
    assert answer.status_code == 201
    image = answer.json()
    assert image["found"] and image["reason"] is None
    assert (image["columns"], image["rows"]) == (COLUMNS, ROWS)
    assert (image["width_px"], image["height_px"]) == (WIDTH, HEIGHT)
    corners = np.array(image["corners_px"]).reshape(ROWS, COLUMNS, 2)
    # The board faces the camera: the middle of its corners is the middle of the picture.
    assert np.allclose(corners.mean(axis=(0, 1)), [(WIDTH - 1) / 2, (HEIGHT - 1) / 2], atol=0.1)
    assert np.all(np.diff(corners[..., 0], axis=1) > 0) and np.all(np.diff(corners[..., 1], axis=0) > 0)
    picture = viewer.http.get(image["url"])
    shown = cv2.imdecode(np.frombuffer(picture.content, np.uint8), cv2.IMREAD_COLOR)
    assert shown.shape == (HEIGHT, WIDTH, 3)
    known = {"If-None-Match": picture.headers["etag"]}
    assert viewer.http.get(image["url"], headers=known).status_code == 304
    detail = viewer.seen(f"/cameras/{camera_id}")
    assert [one["id"] for one in detail["images"]] == [image["id"]]


def test_an_image_without_a_board_is_kept_with_its_reason(operator: Client, camera_id: int) -> None:
    plain = np.full((HEIGHT, WIDTH, 3), 128, np.uint8)
    image = drop(operator, camera_id, picture_bytes(plain), "wall.png").json()
    assert image["found"] is False and image["reason"] and image["corners_px"] == []


@pytest.mark.parametrize("content", [b"", b"no picture", b"\x89PNG\r\n\x1a\n" + b"\x00" * 40])
def test_what_is_no_picture_is_refused_by_name(operator: Client, camera_id: int, content: bytes) -> None:
    answer = drop(operator, camera_id, content, "holiday.png")
    assert answer.status_code == 422
    assert "holiday.png" in error_of(answer)
    assert operator.seen(f"/cameras/{camera_id}")["images"] == []
    missing = operator.post(f"/cameras/{camera_id}/images")
    assert missing.status_code == 422
    error_of(missing)


def test_another_board_is_looked_for_again(operator: Client, camera_id: int) -> None:
    content = picture_bytes(view(POSES[0]))
    assert drop(operator, camera_id, content, columns=12).json()["found"] is False
    (image,) = operator.made(f"/cameras/{camera_id}/images/detect", {"columns": COLUMNS, "rows": ROWS})
    assert image["found"] is True
    wrong = operator.post(f"/cameras/{camera_id}/images/detect", {"columns": 2, "rows": 6})
    assert wrong.status_code == 422
    assert "2x6" in error_of(wrong)


def test_removing_an_image(operator: Client, camera_id: int, work: Work) -> None:
    content = picture_bytes(view(POSES[0]))
    first, second = drop(operator, camera_id, content).json(), drop(operator, camera_id, content).json()
    assert operator.delete(f"/calibration-images/{first['id']}").status_code == 204
    work()
    assert operator.http.get(first["url"]).status_code == 404
    # The same content was there twice and stored once: the other one keeps it.
    assert operator.http.get(second["url"]).status_code == 200


def test_an_image_removed_while_its_twin_is_added_leaves_the_file(
    operator: Client, camera_id: int, services: Services, work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = picture_bytes(view(POSES[0]))
    first, put_file = drop(operator, camera_id, content).json(), LocalStore.put_file
    removed = list[bool]()

    def meanwhile(store: LocalStore, key: str, path: Path, **how: bool) -> None:
        put_file(store, key, path, **how)
        if not removed:
            removed.append(True)
            images.remove_image(services, first["id"], None)
            assert [job.state for job in work()] == ["done"] and not store.exists(key)

    monkeypatch.setattr(LocalStore, "put_file", meanwhile)
    second = drop(operator, camera_id, content).json()
    assert operator.http.get(first["url"]).status_code == 404
    assert operator.http.get(second["url"]).status_code == 200


@pytest.mark.parametrize("lost", ["put_file", "exists"])
def test_an_image_is_stored_only_where_the_store_says_that_its_file_is_there(
    operator: Client,
    camera_id: int,
    services: Services,
    work: Work,
    monkeypatch: pytest.MonkeyPatch,
    lost: str,
) -> None:
    """The store does what it is asked, and the answer is lost."""
    done = getattr(LocalStore, lost)

    def away(store: LocalStore, key: str, *given: object, **more: object) -> bool:
        done(store, key, *given, **more)
        raise Away("store-no-answer", key=key, name="Timeout")

    content = picture_bytes(view(POSES[0]))
    with monkeypatch.context() as outage:
        outage.setattr(LocalStore, lost, away)
        answer = drop(operator, camera_id, content)
    assert answer.status_code == 503 and "did not answer" in error_of(answer)
    assert operator.seen(f"/cameras/{camera_id}")["images"] == []
    assert [job.kind for job in work()] == ["tidy"] and not list(services.media.listing())
    kept = drop(operator, camera_id, content).json()
    assert [one["id"] for one in operator.seen(f"/cameras/{camera_id}")["images"]] == [kept["id"]]
    assert operator.http.get(kept["url"]).status_code == 200 and not work()


def test_nobody_waits_to_write_while_an_image_goes_to_the_store(
    operator: Client, camera_id: int, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    put_file, written = LocalStore.put_file, list[bool]()

    def write() -> None:
        with services.writing():
            written.append(True)

    def slow(store: LocalStore, key: str, path: Path, **how: bool) -> None:
        before, other = len(written), threading.Thread(target=write)
        other.start()
        other.join(NEVER_S)
        assert len(written) > before
        put_file(store, key, path, **how)

    monkeypatch.setattr(LocalStore, "put_file", slow)
    assert drop(operator, camera_id, picture_bytes(view(POSES[0]))).status_code == 201
    assert written


def test_calibration_from_images(operator: Client, camera_id: int, work: Work) -> None:
    few = operator.post(f"/cameras/{camera_id}/calibrations", BOARD)
    assert few.status_code == 422
    assert "at least three" in error_of(few)
    for pose in POSES:
        drop(operator, camera_id, picture_bytes(view(pose)), "board.png")
    drop(operator, camera_id, picture_bytes(np.full((HEIGHT, WIDTH, 3), 128, np.uint8)), "wall.png")
    small = cv2.resize(view(POSES[0]), (320, 240), interpolation=cv2.INTER_AREA)
    drop(operator, camera_id, picture_bytes(np.asarray(small, np.uint8)), "small.png")
    job = operator.post(f"/cameras/{camera_id}/calibrations", BOARD)
    assert job.status_code == 202
    followed = operator.seen(f"/cameras/{camera_id}")["calibrating"]
    assert followed["id"] == job.json()["id"] and followed["state"] == "queued"
    (done,) = work()
    assert done.state == "done" and done.result is not None
    assert operator.seen(f"/cameras/{camera_id}")["calibrating"] is None
    calibration = operator.seen(f"/calibrations/{done.result['calibration_id']}")
    document = calibration["document"]
    assert "checks" not in document
    crossed = calibration["cross_validation"]
    assert crossed["reason"] is None and crossed["views"] == [5, 5]
    assert document["rms_px"] == pytest.approx(crossed["fit_rms_px"], rel=1e-6)
    assert crossed["fit_rms_px"] < crossed["held_out_rms_px"]
    assert [d["distance_m"] for d in crossed["height_differences"]] == [2.0, 3.0, 5.0]
    known = [d for d in crossed["height_differences"] if d["difference_m"] is not None]
    assert known and all(d["expected_m"] > 0 for d in known)
    assert calibration["board_shape"]["solved"] is False and calibration["board_shape"]["bow_m"] < SQUARE_M
    assert any("Images of several sizes" in warning["message"] for warning in calibration["warnings"])
    assert document["name"] == "Left"
    assert document["fx_px"] == pytest.approx(FOCAL_PX, rel=0.01)
    assert document["rms_px"] < 0.15
    assert calibration["source"] == "images"
    assert np.array(calibration["coverage"]).shape == (12, 16)
    views = {one["file"]: one for one in calibration["views"]}
    assert len(views) == 12
    assert not views["wall.png"]["used"] and views["wall.png"]["reason"]
    assert not views["small.png"]["used"] and "320" in views["small.png"]["reason"]["message"]
    used = views["board.png (4)"]
    residuals = np.array(used["residuals_px"])
    assert residuals.shape == (ROWS * COLUMNS, 2) and used["image_id"]
    assert np.sqrt((residuals**2).sum(axis=1).mean()) == pytest.approx(used["rms_px"], rel=1e-6)
    camera = operator.seen(f"/cameras/{camera_id}")
    assert camera["current_calibration_id"] == calibration["id"]
    assert "10 of 12 views" in camera["calibrations"][0]["summary"]["message"]


def test_an_image_removed_while_a_calibration_runs_is_in_none(
    operator: Client, camera_id: int, work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, *_ = [drop(operator, camera_id, picture_bytes(view(pose))).json() for pose in POSES[:4]]
    operator.post(f"/cameras/{camera_id}/calibrations", BOARD)
    fit = calibrate_job.calibrate_and_check

    def meanwhile(*given: Any) -> Any:
        assert operator.delete(f"/calibration-images/{first['id']}").status_code == 204
        return fit(*given)

    monkeypatch.setattr(calibrate_job, "calibrate_and_check", meanwhile)
    (job,) = work()
    assert job.state == "failed" and "removed while the calibration ran" in str(job.error)
    assert operator.seen(f"/cameras/{camera_id}")["calibrations"] == []


def test_calibration_from_a_clip(
    operator: Client, survey_id: int, camera_id: int, boards: Path, work: Work
) -> None:
    recording_id = upload(operator, survey_id, boards)
    early = operator.post(f"/cameras/{camera_id}/calibrations", {**BOARD, "recording_id": recording_id})
    assert early.status_code == 422
    assert "wait" in error_of(early)
    work()
    wish = {**BOARD, "recording_id": recording_id, "every": 2}
    outside = operator.post(f"/cameras/{camera_id}/calibrations", {**wish, "last_frame": 20})
    assert outside.status_code == 422
    assert "0 to 19" in error_of(outside)
    operator.made(f"/cameras/{camera_id}/calibrations", wish)
    (done,) = work()
    assert done.state == "done" and done.result is not None
    calibration = operator.seen(f"/calibrations/{done.result['calibration_id']}")
    assert calibration["source"] == "clip" and calibration["recording_id"] == recording_id
    assert [one["frame"] for one in calibration["views"]] == list(range(0, 20, 2))
    assert calibration["document"]["fx_px"] == pytest.approx(FOCAL_PX, rel=0.02)


def test_a_calibration_that_cannot_work_fails_with_a_sentence(
    operator: Client, survey_id: int, camera_id: int, recording_id: int, work: Work
) -> None:
    operator.made(f"/cameras/{camera_id}/calibrations", {**BOARD, "recording_id": recording_id, "every": 4})
    (done,) = work()
    assert done.state == "failed" and done.error is not None
    assert "at least 3 are needed" in str(done.error)
    assert operator.seen(f"/cameras/{camera_id}")["calibrations"] == []


def test_frames_are_spread_and_bounded() -> None:
    from sightline.errors import BadInput

    asked = {**BOARD, "model": "brown", "recording_id": 1}
    wish = CalibrationRequest(**asked)
    assert len(frames_of(wish, 10_000)) <= 24
    assert frames_of(wish, 3) == [0, 1, 2]
    with pytest.raises(BadInput, match="every 167th"):
        frames_of(CalibrationRequest(**asked, every=1), 10_000)


def test_import_and_choice(operator: Client, camera_id: int, survey_id: int) -> None:
    path = f"/cameras/{camera_id}/calibrations/import"
    made = operator.post(path, files={"file": ("left.yml", OPENCV.encode())})
    assert made.status_code == 201
    first = made.json()
    assert first["source"] == "import" and first["document"]["fx_px"] == 535.9
    assert first["warnings"] and first["coverage"] == [] and first["views"] == []
    four = OPENCV.replace("rows: 5", "rows: 4").replace(", 0.238 ]", " ]")
    guessed = operator.post(path, files={"file": ("four.yml", four.encode())}).json()
    assert any("does not name its distortion model" in warning["message"] for warning in guessed["warnings"])
    second = operator.post(path, files={"file": ("left.yml", OPENCV.replace("535.9", "540").encode())}).json()
    assert operator.seen(f"/cameras/{camera_id}")["current_calibration_id"] == second["id"]
    choice = f"/cameras/{camera_id}/current-calibration"
    chosen = operator.put(choice, {"calibration_id": first["id"]}).json()
    assert chosen["current_calibration_id"] == first["id"]
    other = operator.made(f"/surveys/{survey_id}/cameras", {"name": "Right"})
    answer = operator.put(f"/cameras/{other['id']}/current-calibration", {"calibration_id": first["id"]})
    assert answer.status_code == 422
    for name, content in (("x.yml", b"\xff\xfe\x00"), ("x.yml", b"a: [1"), ("x.json", b"{}"), ("x.txt", b"")):
        bad = operator.post(path, files={"file": (name, content)})
        assert bad.status_code == 422, content
        assert name in error_of(bad)
