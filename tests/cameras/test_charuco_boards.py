"""ChArUco boards over the API: images seen in part, calibrations from them and from a clip, a road pose."""

from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import numpy as np
import pytest

from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.media.video.writer import write_mp4
from tests.support.app import Client, error_of, upload
from tests.support.boards import (
    COLUMNS,
    FOCAL_PX,
    HEIGHT,
    POSES,
    ROWS,
    SQUARE_M,
    WIDTH,
    Picture,
    charuco_print,
    picture_bytes,
    view,
)
from tests.support.ground import flat_camera, store_calibration

pytestmark = pytest.mark.once

Work = Callable[[], list[Job]]
MARKERS = {"board_kind": "charuco", "dictionary": "4X4_50", "marker_m": 0.75 * SQUARE_M}
BOARD = {"columns": COLUMNS, "rows": ROWS, "square_m": SQUARE_M, **MARKERS}
REFERENCE_M = 0.05


@pytest.fixture(scope="module")
def pictures() -> list[Picture]:
    """The board in each pose; in the last three its right part is hidden."""
    print_ = charuco_print()
    views = [view(pose, print_) for pose in POSES]
    for one in views[-3:]:
        one[:, 380:] = 150
    return views


@pytest.fixture
def camera_id(operator: Client, survey_id: int) -> int:
    return int(operator.made(f"/surveys/{survey_id}/cameras", {"name": "Left"})["id"])


def drop(client: Client, camera_id: int, content: Picture, **told: Any) -> Any:
    path = f"/cameras/{camera_id}/images?{urlencode({**BOARD, **told})}"
    return client.post(path, files={"file": ("a.png", picture_bytes(content))})


def test_calibration_from_images_that_show_part_of_the_board(
    operator: Client, camera_id: int, work: Work, pictures: list[Picture]
) -> None:
    for one in pictures:
        made = drop(operator, camera_id, one)
        assert made.status_code == 201 and made.json()["found"], made.text
    images = operator.seen(f"/cameras/{camera_id}")["images"]
    assert {(one["dictionary"], one["marker_share"]) for one in images} == {("4X4_50", 0.75)}
    assert images[0]["ids"] is None and len(images[0]["corners_px"]) == COLUMNS * ROWS
    part = images[-1]
    assert 6 <= len(part["ids"]) == len(part["corners_px"]) < COLUMNS * ROWS
    assert max(x for x, _ in part["corners_px"]) < 380
    job = operator.made(f"/cameras/{camera_id}/calibrations", BOARD)
    (done,) = work()
    assert done.state == "done" and done.id == job["id"] and done.result is not None, done.error
    made = operator.seen(f"/calibrations/{done.result['calibration_id']}")
    assert made["document"]["fx_px"] == pytest.approx(FOCAL_PX, abs=3.0)
    last = made["views"][-1]
    assert last["used"] and len(last["corners_px"]) == len(last["residuals_px"]) == len(part["ids"])
    # The same pictures hold no plain board, and are found again when the markers are told again.
    plain = {"columns": COLUMNS, "rows": ROWS}
    seen = operator.made(f"/cameras/{camera_id}/images/detect", plain)
    assert all(one["dictionary"] is None and one["ids"] is None for one in seen)
    again = operator.made(f"/cameras/{camera_id}/images/detect", BOARD)
    assert [one["ids"] for one in again] == [one["ids"] for one in images]


def test_calibration_and_pose_from_a_clip(
    operator: Client, services: Services, survey_id: int, camera_id: int, tmp_path: Path, work: Work,
    pictures: list[Picture],
) -> None:  # fmt: skip
    clip = tmp_path / "markers.mp4"
    write_mp4(clip, (one for one in pictures for _ in range(2)), 25, crf=8)
    clip_id = upload(operator, survey_id, clip)
    assert [job.state for job in work()] == ["done"]
    wish = {**BOARD, "recording_id": clip_id, "every": 2}
    operator.made(f"/cameras/{camera_id}/calibrations", wish)
    (done,) = work()
    assert done.state == "done" and done.result is not None, done.error
    made = operator.seen(f"/calibrations/{done.result['calibration_id']}")
    assert made["document"]["fx_px"] == pytest.approx(FOCAL_PX, abs=6.0)

    last = 2 * len(pictures) - 1
    found = operator.made(f"/recordings/{clip_id}/board", {**BOARD, "frame": 0})
    assert found["found"] and found["ids"] is None and len(found["corners_px"]) == COLUMNS * ROWS
    part = operator.made(f"/recordings/{clip_id}/board", {**BOARD, "frame": last})
    assert part["found"] and len(part["ids"]) == len(part["corners_px"]) < COLUMNS * ROWS
    assert "a camera pose needs all of them" in part["order_notes"][0]["message"]
    assert part["outline_px"][0] == part["outline_px"][-1]

    camera = flat_camera(WIDTH, HEIGHT, FOCAL_PX)
    known = {"calibration_id": store_calibration(services, survey_id, camera)[1], "reference": "bottom"}
    asked = {**BOARD, **known, "reference_height_m": REFERENCE_M}
    operator.made(f"/recordings/{clip_id}/poses", {**asked, "first_frame": 0, "last_frame": 1})
    operator.made(f"/recordings/{clip_id}/poses", {**asked, "first_frame": last - 1, "last_frame": last})
    whole, hidden = work()
    assert whole.result is not None, whole.error
    document = operator.seen(f"/poses/{whole.result['pose_id']}")["document"]["cam_from_road"]
    centre = -np.array(document["rotation"]).T @ np.array(document["translation_m"])
    assert centre[2] == pytest.approx(REFERENCE_M + (ROWS - 1) / 2 * SQUARE_M, abs=0.001)
    assert hidden.state == "failed" and "show the whole board" in str(hidden.error)


def test_half_told_boards_are_refused_in_words(operator: Client, camera_id: int, survey_id: int) -> None:
    blank = np.full((HEIGHT, WIDTH, 3), 128, np.uint8)
    for told, word in (
        ({"dictionary": "4X4_7"}, "4X4_7"),
        ({"marker_m": 0.9}, "fit squares"),
        ({"dictionary": "APRILTAG_16H5"}, "35 markers"),
        ({"board_kind": "checkerboard"}, "no markers"),
    ):
        answer = drop(operator, camera_id, blank, **told)
        assert answer.status_code == 422 and word in error_of(answer), answer.text
    body = {"columns": COLUMNS, "rows": ROWS, "board_kind": "charuco"}
    half = operator.post(f"/cameras/{camera_id}/images/detect", body)
    assert half.status_code == 422 and "all three" in error_of(half)
    wish = operator.post(f"/cameras/{camera_id}/calibrations", {**BOARD, "marker_m": 2.0})
    assert wish.status_code == 422 and "fit squares" in error_of(wish)
    assert operator.seen(f"/cameras/{camera_id}")["images"] == []
