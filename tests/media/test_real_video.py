"""Real recordings (never committed): each is served exactly or refused with a sentence."""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.media.video.decode import frames_of
from sightline.media.video.frames import FrameServer
from sightline.media.video.ingest import Ingested, ingest
from sightline.media.video.picture import Gray
from tests.media.conftest import Ingest, media_of

KNOWN = {  # frames, upright size, variable rate
    "video/car-detection.mp4": (377, (768, 432), False),
    "video/cars_truck_roadside.mp4": (60, (800, 600), False),
    "video/cars_truck_roadside.avi": (60, (800, 600), False),
    "video/cars_truck_roadside.mkv": (60, (800, 600), False),
    "video/cars_truck_roadside_raw.h264": (60, (800, 600), False),
    "video/cars_truck_roadside_rotate90.mov": (60, (600, 800), False),
    "video/odd/vtest_msmpeg4.avi": (795, (768, 576), False),
    "video/odd/tree_cinepak_vfr.avi": (68, (320, 240), True),
    "video/odd/smallcar_unordered_pts.mp4": (867, (480, 560), True),
    "video/odd/drop_indeo4.avi": (182, (256, 240), False),
    "linescan/train_day.mp4": (183, (300, 300), False),
    "linescan/train_snow.mp4": (89, (300, 300), False),
    "linescan/train_platform_portrait_vfr.mov": (420, (360, 640), True),
    "calibration/clip_screen_board/chessboard.mp4": (283, (1280, 720), False),
}

# Long ones, or large: `make proofs`.
LONG = {
    "video/car-detection.mp4",
    "video/odd/vtest_msmpeg4.avi",
    "video/odd/smallcar_unordered_pts.mp4",
    "linescan/train_platform_portrait_vfr.mov",
    "calibration/clip_screen_board/chessboard.mp4",
}


@pytest.fixture(scope="module")
def taken(shared_data: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Ingested]:
    """Recordings by their name, taken in once for all tests."""
    found: dict[str, Ingested] = {}

    def get(name: str) -> Ingested:
        if name not in found:
            here = tmp_path_factory.mktemp("taken")
            path = shared_data / name
            found[name] = ingest(path, lambda _: None, lambda: False, here / "thumbs", work_dir=here / "work")
        return found[name]

    return get


def sequential(path: Path, wanted: set[int]) -> dict[int, Gray]:
    """Frames by a plain decode from the start, by another reader than the frame server."""
    head = itertools.islice(frames_of(path), max(wanted) + 1)
    return {n: gray for n, _, gray in head if n in wanted}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.proof if name in LONG else ()) for name in KNOWN]
)
def test_served_as_a_plain_decode_gives_it(
    name: str, shared_data: Path, tmp_path: Path, taken: Callable[[str], Ingested]
) -> None:
    path = shared_data / name
    count, size, vfr = KNOWN[name]
    result = taken(name)
    media = media_of(result)
    assert len(media) == count
    assert (result.facts.width_px, result.facts.height_px) == size
    assert result.report.vfr == vfr, result.report
    assert not result.report.damaged
    numbers = random.Random(2).sample(range(count), 12)
    numbers += [k for k in range(count // 2, count // 2 + 4)] + [count - 1, count - 2, 0]
    truth = sequential(path, set(numbers))
    server = FrameServer(tmp_path / "cache", 3_000_000, 1_000_000)
    wrong = [n for n in numbers if not np.array_equal(server.gray(media, n), truth[n])]
    assert wrong == []


def test_the_rotated_copy_shows_the_same_scene_as_opencv_turns_it(
    shared_data: Path, taken: Callable[[str], Ingested], server: FrameServer
) -> None:
    name = "video/cars_truck_roadside_rotate90.mov"
    theirs = cv2.VideoCapture(str(shared_data / name)).read()[1]
    ours = server.bgr(media_of(taken(name)), 0)
    assert ours.shape == theirs.shape
    assert np.abs(ours.astype(int) - theirs.astype(int)).mean() < 3


def test_the_same_frames_in_five_files_have_the_same_checksums(taken: Callable[[str], Ingested]) -> None:
    tables = [
        taken(f"video/cars_truck_roadside{end}").frames.crc32.tolist()
        for end in (".mp4", ".avi", ".mkv", "_raw.h264", "_rotate90.mov")
    ]
    assert all(table == tables[0] for table in tables)


def test_the_drawing_named_mp4_is_refused(shared_data: Path, take_in: Ingest) -> None:
    with pytest.raises(BadInput, match=r"^webp_named_as\.mp4 is a WebP image"):
        take_in(shared_data / "video" / "odd" / "webp_named_as.mp4")


def test_nothing_in_the_folder_is_left_out(shared_data: Path, take_in: Ingest) -> None:
    for path in sorted((shared_data / "video").rglob("*")):
        relative = path.relative_to(shared_data).as_posix()
        if path.is_dir() or relative in KNOWN:
            continue
        with pytest.raises(BadInput) as caught:
            take_in(path)
        assert caught.value.message.startswith(path.name) and caught.value.message.endswith(".")
