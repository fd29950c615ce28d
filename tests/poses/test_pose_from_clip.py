"""A road pose from frames: the board found and drawn, the pose as the scene has it, refusals in words."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.geometry.board import Board
from sightline.geometry.corners import Corners
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.poses.service import StillSpan, still_span
from tests.support import boards
from tests.support.app import Client, error_of, upload
from tests.support.ground import flat_camera, store_calibration

pytestmark = pytest.mark.once

REFERENCE_M = 0.05
BOARD = Board(9, 6, 0.1)
# The first pose of the clip: square-on, 0.4 m away, its centre on the optical axis.
CAMERA_HEIGHT_M = REFERENCE_M + (boards.ROWS - 1) / 2 * boards.SQUARE_M


@pytest.fixture
def clip_id(operator: Client, survey_id: int, boards: Path, work: Callable[[], list[Job]]) -> int:
    made = upload(operator, survey_id, boards)
    assert [job.state for job in work()] == ["done"]
    return made


@pytest.fixture
def calibration_id(services: Services, survey_id: int) -> int:
    camera = flat_camera(boards.WIDTH, boards.HEIGHT, boards.FOCAL_PX)
    return store_calibration(services, survey_id, camera)[1]


def wish(calibration_id: int, **more: Any) -> dict[str, Any]:
    body = {
        "calibration_id": calibration_id,
        "first_frame": 0,
        "last_frame": 1,
        "columns": boards.COLUMNS,
        "rows": boards.ROWS,
        "square_m": boards.SQUARE_M,
        "reference": "bottom",
        "reference_height_m": REFERENCE_M,
    }
    return {**body, **more}


def test_the_board_is_found_in_the_order_as_seen(operator: Client, clip_id: int) -> None:
    body = {"frame": 0, "columns": boards.COLUMNS, "rows": boards.ROWS}
    found = operator.made(f"/recordings/{clip_id}/board", body)
    grid = np.array(found["corners_px"]).reshape(boards.ROWS, boards.COLUMNS, 2)
    assert found["found"] and found["reason"] is None
    assert (np.diff(grid[..., 0], axis=1) > 0).all() and (np.diff(grid[..., 1], axis=0) > 0).all()
    assert found["outline_px"][0] == found["corners_px"][0] == found["outline_px"][-1]
    missing = operator.made(f"/recordings/{clip_id}/board", {"frame": 0, "columns": 12, "rows": 4})
    assert not missing["found"] and "12x4" in missing["reason"]["message"]


def test_the_span_of_a_board_that_stands_still_is_found_by_itself(operator: Client, clip_id: int) -> None:
    body = {"frame": 0, "columns": boards.COLUMNS, "rows": boards.ROWS}
    frames = operator.seen(f"/recordings/{clip_id}")["frame_count"]
    found = operator.made(f"/recordings/{clip_id}/board/span", body)
    assert found["first_frame"] == 0 and 0 <= found["last_frame"] < frames
    assert operator.made(f"/recordings/{clip_id}/board/span", {**body, "columns": 12, "rows": 4}) is None


@given(
    st.integers(0, 400).flatmap(
        lambda last: st.tuples(st.just(last), *(st.integers(0, last) for _ in range(3)))
    )
)
def test_the_span_is_that_of_the_frames_which_look_alike(drawn: tuple[int, int, int, int]) -> None:
    last, *ends = drawn
    first, frame, end = sorted(ends)
    looked = []

    def look(n: int) -> Corners:
        looked.append(n)
        moved = 0.0 if first <= n <= end else 5.0
        return Corners(True, np.zeros((6, 9, 2)) + moved, BOARD, None, 0.0, "")

    assert still_span(look, frame, last) == StillSpan(first, end)
    assert len(looked) <= 1 + 4 * 10 and all(0 <= n <= last for n in looked)


def test_a_pose_is_solved_drawn_and_used(
    operator: Client, survey_id: int, clip_id: int, calibration_id: int, work: Callable[[], list[Job]]
) -> None:
    job = operator.made(f"/recordings/{clip_id}/poses", wish(calibration_id))
    assert job["state"] == "queued"
    assert [one.state for one in work()] == ["done"]
    pose_id = operator.seen(f"/jobs/{job['id']}")["result"]["pose_id"]
    pose = operator.seen(f"/poses/{pose_id}")
    rotation = np.array(pose["document"]["cam_from_road"]["rotation"])
    centre = -rotation.T @ np.array(pose["document"]["cam_from_road"]["translation_m"])
    assert centre[2] == pytest.approx(CAMERA_HEIGHT_M, abs=0.001)
    assert centre[1] == pytest.approx(-0.4, abs=0.002)
    assert pose["overlay"]["grid"] and pose["overlay"]["iso_heights"]
    assert [one["distance_m"] for one in pose["expected"]] == [2.0, 3.0, 5.0]
    assert all(one["u_height_m"] is not None or one["reason"] for one in pose["expected"])
    recording = operator.seen(f"/recordings/{clip_id}")
    assert recording["pose_id"] == pose_id and recording["camera_id"] is not None
    assert [one["id"] for one in operator.seen(f"/surveys/{survey_id}/poses")] == [pose_id]
    # a corner of the board's top row, above the foot of its column: five squares above the reference
    corners = np.array(pose["overlay"]["corners_px"]).reshape(boards.ROWS, boards.COLUMNS, 2)
    scale = (corners[-1, 4, 1] - corners[0, 4, 1]) / ((boards.ROWS - 1) * boards.SQUARE_M)
    foot = [corners[-1, 4, 0], corners[-1, 4, 1] + REFERENCE_M * scale]
    body = {
        "contact": foot,
        "target_point": corners[0, 4].tolist(),
        "target": "other",
        "inset_m": 0.0,
        "u_inset_m": 0.0,
    }
    height = operator.made(f"/recordings/{clip_id}/geometry/height", body)
    assert height["height_m"] == pytest.approx(REFERENCE_M + 5 * boards.SQUARE_M, abs=0.001)


def test_what_cannot_work_is_refused_before_any_frame_is_read(
    operator: Client, services: Services, survey_id: int, clip_id: int, calibration_id: int
) -> None:
    _, other = store_calibration(services, survey_id, flat_camera(1280, 720, 900.0))
    for body, word in (
        (wish(other), "1280 x 720"),
        (wish(calibration_id, last_frame=999), "frames 0 to 19"),
        (wish(calibration_id, first_frame=5, last_frame=2), "are not in"),
        (wish(calibration_id, square_m=-1.0), "square_m"),
        (wish(calibration_id, reference="left"), "reference"),
        (wish(calibration_id, rows=1), "rows"),
    ):
        answer = operator.post(f"/recordings/{clip_id}/poses", body)
        assert answer.status_code == 422, answer.text
        assert word in error_of(answer)
    assert operator.post(f"/recordings/{clip_id}/poses", wish(99999)).status_code == 404
    assert operator.seen(f"/surveys/{survey_id}/poses") == []


def test_a_board_that_moves_or_is_not_there_fails_with_the_reason(
    operator: Client, survey_id: int, clip_id: int, calibration_id: int, work: Callable[[], list[Job]]
) -> None:
    moving = operator.made(f"/recordings/{clip_id}/poses", wish(calibration_id, last_frame=19))
    absent = operator.made(f"/recordings/{clip_id}/poses", wish(calibration_id, columns=13, rows=4))
    assert [one.state for one in work()] == ["failed", "failed"]
    assert "move" in operator.seen(f"/jobs/{moving['id']}")["error"]["message"]
    assert "No board of" in operator.seen(f"/jobs/{absent['id']}")["error"]["message"]
    assert operator.seen(f"/surveys/{survey_id}/poses") == []
    assert operator.seen(f"/recordings/{clip_id}")["pose_id"] is None
