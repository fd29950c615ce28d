"""A camera that was bumped: found by a job, measurements flagged, a person decides, and takes it back."""

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
from sqlalchemy import select

from sightline.infra.audit import trail
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.measurements.tables import measurements
from sightline.media.video.writer import write_mp4
from sightline.quality.checks.turning import store_turned
from sightline.recordings.csv import RECORDINGS, describe_recording
from sightline.recordings.store import get_recording, list_recordings
from tests.support.app import FRAME_HEIGHT, FRAME_WIDTH, Client, error_of, upload
from tests.support.ground import Ground, add_pose, add_vehicle, clicks, flat_camera, lay_ground, measure

BUMP, COUNT = 17, 40


def textured(n: int) -> np.ndarray:
    """A rough wall, moved by (2, -1.5) px from frame BUMP on, with noise of its own in each frame."""
    rng = np.random.default_rng(1)
    wall = cv2.GaussianBlur(rng.uniform(0, 255, (FRAME_HEIGHT + 40, FRAME_WIDTH + 40)), (0, 0), 2.0)
    wall = np.clip((wall - 127.5) * 5 + 127.5, 20, 235).astype(np.float32)
    x, y = (2.0, -1.5) if n >= BUMP else (0.0, 0.0)
    matrix = np.array([[1, 0, x - 20], [0, 1, y - 20]], np.float32)
    seen = cv2.warpAffine(wall, matrix, (FRAME_WIDTH, FRAME_HEIGHT), flags=cv2.INTER_CUBIC)
    seen = seen + np.random.default_rng(n).normal(0, 2, seen.shape)
    return np.repeat(np.clip(seen, 0, 255).astype(np.uint8)[:, :, None], 3, axis=2)


@pytest.fixture(scope="session")
def bumped_clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("bumped") / "bumped.mp4"
    write_mp4(path, (textured(n) for n in range(COUNT)), 25, crf=12, gop=10)
    return path


@pytest.fixture
def ground(
    operator: Client,
    services: Services,
    survey_id: int,
    bumped_clip: Path,
    work: Callable[[], list[Job]],
) -> Ground:
    recording_id = upload(operator, survey_id, bumped_clip)
    assert [job.state for job in work()] == ["done"]
    return lay_ground(services, survey_id, recording_id)


def errors(client: Client, measurement_id: int) -> list[float]:
    found = client.seen(f"/measurements/{measurement_id}")["flags"]
    return [one["values"]["error_m"] for one in found if one["code"] == "height-flag-camera-moved-height"]


def flags(client: Client, measurement_id: int) -> list[str]:
    found = [one["message"] for one in client.seen(f"/measurements/{measurement_id}")["flags"]]
    return [one for one in found if "after the pose was computed" in one]


def test_a_bump_flags_what_comes_after_it_until_somebody_decides(
    operator: Client,
    viewer: Client,
    services: Services,
    work: Callable[[], list[Job]],
    ground: Ground,
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, last_frame=COUNT - 1)["id"]
    early = measure(operator, vehicle, frame=BUMP - 1)["id"]
    late = measure(operator, vehicle, frame=BUMP, target="taillight")["id"]
    path = f"/recordings/{ground.recording_id}/drift"
    assert viewer.seen(path)["check"] is None and flags(viewer, late) == []

    operator.made(path, {})
    assert [job.state for job in work()] == ["done"]
    found = viewer.seen(path)
    check = found["check"]
    assert check["state"] == "moved" and check["pose_id"] == ground.pose_id
    assert [(bump["after"], bump["frame"]) for bump in check["bumps"]] == [(BUMP - 1, BUMP)]
    assert check["bumps"][0]["by_px"] == pytest.approx(2.5, abs=0.05)
    assert f"(frame {BUMP}) by 2.5 px (height error up to" in check["words"][0]["message"]
    assert check["looks"][0]["frame"] == 0 and len(check["looks"]) == 24
    assert flags(viewer, early) == [] and len(flags(viewer, late)) == 1
    assert {one["distance_m"] for one in found["flagged"]} == {check["distance_m"]}
    # moved 1.5 px up the picture, seen from 3 m: D = C f / y and h = C - D y / f with the motion undone
    back_m = 1.5 - 1.5 / (75.0 + 1.5) * (15.0 + 1.5)
    assert errors(viewer, late) == [pytest.approx(abs(1.2 - back_m), abs=0.002)]
    stored = viewer.seen(f"/measurements/{late}/history")["revisions"]
    assert len(stored) == 1, "a flag makes no revision"

    assert operator.put(f"{path}/decision", {"reason": " "}).status_code == 422
    decided = operator.put(f"{path}/decision", {"reason": "Checked on the kerb."}).json()
    assert decided["flagged"] == [] and decided["decision"]["holds"] is True
    assert flags(viewer, late) == []
    with services.reading() as session:
        recording = describe_recording(get_recording(session, ground.recording_id))
        cells = {column.name: column.of(recording) for column in RECORDINGS.columns if column.of}
        assert {"drift_state": "moved", "drift_decision": "Checked on the kerb."}.items() <= cells.items()
        assert (
            cells["drift_moved_px"] == pytest.approx(2.5, abs=0.05)
            and str(cells["drift_decided_at"])[-1] == "Z"
        )
        events = [event.action for event in trail.listing(session, entity="recording")]
    assert events[:2] == ["decide_drift", "check_drift"]

    back = operator.delete(f"{path}/decision").json()
    assert back["decision"] is None and len(back["flagged"]) == 1
    assert len(flags(viewer, late)) == 1
    assert operator.delete(f"{path}/decision").status_code == 409
    earlier = {**clicks(frame=BUMP - 1, target="taillight"), "revision": 1}
    clicked_anew = operator.put(f"/measurements/{late}", earlier).json()
    assert not [one for one in clicked_anew["flags"] if "camera-moved" in one["code"]]


def test_withdrawing_stores_no_derived_flag_and_a_new_pose_ends_it(
    operator: Client, services: Services, work: Callable[[], list[Job]], ground: Ground
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, last_frame=COUNT - 1)["id"]
    late = measure(operator, vehicle, frame=BUMP + 3)
    operator.made(f"/recordings/{ground.recording_id}/drift", {})
    work()
    assert len(flags(operator, late["id"])) == 1
    operator.delete(f"/measurements/{late['id']}?revision=1")
    operator.made(f"/measurements/{late['id']}/restore", {"revision": 2})
    with services.reading() as session:
        kept = session.execute(select(measurements.c.flags)).scalars().all()
    assert all("camera-moved" not in flag["code"] for one in kept for flag in one)

    renewed = add_pose(services, ground.recording_id, ground.calibration_id, flat_camera())
    seen = operator.seen(f"/recordings/{ground.recording_id}/drift")
    assert seen["pose_id"] == renewed and seen["check"] is None
    # what was measured with the old pose stays flagged; what is measured with the new one is not
    assert len(flags(operator, late["id"])) == 1
    assert flags(operator, measure(operator, vehicle, frame=BUMP + 3, target="taillight")["id"]) == []


def test_choosing_a_pose_looks_by_itself_and_without_one_there_is_nothing_to_look_at(
    operator: Client, services: Services, work: Callable[[], list[Job]], survey_id: int, bumped_clip: Path
) -> None:
    recording_id = upload(operator, survey_id, bumped_clip)
    work()
    answer = operator.post(f"/recordings/{recording_id}/drift")
    assert answer.status_code == 409 and "no camera pose" in error_of(answer)
    assert operator.put(f"/recordings/{recording_id}/drift/decision", {"reason": "x"}).status_code == 409
    ground = lay_ground(services, survey_id, recording_id)
    answer = operator.put(f"/recordings/{recording_id}", {"pose_id": ground.pose_id})
    assert answer.status_code == 200
    waiting = operator.seen(f"/recordings/{recording_id}/drift")
    assert waiting["check"] is None and waiting["job"]["state"] == "queued"
    assert [(job.kind, job.state) for job in work()] == [("drift", "done")]
    looked = operator.seen(f"/recordings/{recording_id}/drift")
    assert looked["job"] is None and looked["check"] is not None


def test_a_pose_that_was_turned_is_looked_at_again_and_flags_what_is_computed_with_it(
    operator: Client, services: Services, work: Callable[[], list[Job]], ground: Ground
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, last_frame=COUNT - 1)["id"]
    late = measure(operator, vehicle, frame=BUMP + 3)["id"]
    operator.made(f"/recordings/{ground.recording_id}/drift", {})
    work()
    assert len(flags(operator, late)) == 1
    with services.writing() as session:
        users = list_recordings(session, ground.survey_id)
        made = store_turned(session, ground.pose_id, users, 0.001, 0.0001, 5, actor=None)
    operator.made(f"/surveys/{ground.survey_id}/computings")
    assert [job.state for job in work()] == ["done", "done"]
    assert operator.seen(f"/measurements/{late}")["pose_id"] == made.id
    assert len(flags(operator, late)) == 1


def test_a_pose_made_of_another_recordings_keeps_the_frames_in_which_its_board_stood(
    operator: Client, services: Services, recording_id: int, ground: Ground, work: Callable[[], list[Job]]
) -> None:
    operator.put(f"/recordings/{recording_id}", {"pose_id": ground.pose_id})
    add_pose(services, ground.recording_id, ground.calibration_id, flat_camera())
    for gone in (False, True):
        if gone:
            assert operator.delete(f"/recordings/{ground.recording_id}").status_code == 204
        with services.writing() as session:
            (user,) = (one for one in list_recordings(session, ground.survey_id) if one.id == recording_id)
            assert user.pose_id is not None
            made = store_turned(session, user.pose_id, [user], 0.001, 0.0001, 5, actor=None)
        assert operator.seen(f"/recordings/{recording_id}")["pose_id"] == made.id
        assert (made.recording_id, made.first_frame, made.last_frame) == (ground.recording_id, 0, 3)
    work()
    operator.made(f"/recordings/{recording_id}/drift", {})
    (job,) = work()
    assert job.state == "failed" and "its recording was deleted" in str(job.error)
