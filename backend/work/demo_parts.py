"""What the demonstration survey is made of, before it is stored: videos, lab pictures, calibration, poses."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from backend.demonstration import (
    LAB_COLUMNS,
    LAB_COUNT,
    LAB_ROWS,
    LAB_SQUARE_M,
    PassTruth,
    Scene,
    lab_image,
    truth,
    truth_document,
)
from backend.geometry.calibration import CalibrationResult, calibrate
from backend.geometry.corners import Board, Corners, Gray, detect
from backend.geometry.road_pose import Reference
from backend.media.decode import frames_of
from backend.media.images import png, read_image
from backend.media.ingest import Ingested, ingest
from backend.media.store import key_of, sha256_of
from backend.media.writer import write_mp4
from backend.work.calibrating import Seen
from backend.work.demo_rendering import SCENES, Image, rendered, scene_named
from backend.work.ingesting import pack_thumbnails, thumbnails_key_of
from backend.work.packaging import json_bytes
from backend.work.posing import Solved, frames_to_try, solve
from backend.work.services import Services

FILES = {"day": "daytime.mp4", "low_light": "low-light.mp4"}
RENDERING, READING = 0.80, 0.90
LAB_BOARD = Board(LAB_COLUMNS, LAB_ROWS, LAB_SQUARE_M)

Progress = Callable[[float, str], None]


@dataclass(frozen=True, eq=False)
class Video:
    """One rendered and ingested video, already in the media store."""

    scene: Scene
    name: str
    media_key: str
    sha256: str
    size_bytes: int
    found: Ingested
    still: tuple[Corners, ...]
    truth: tuple[PassTruth, ...]


@dataclass(frozen=True, eq=False)
class LabPicture:
    """One lab checkerboard, already in the media store."""

    seen: Seen
    media_key: str


@dataclass(frozen=True, eq=False)
class Parts:
    """Everything that the survey needs; `poses` are one a video."""

    videos: tuple[Video, ...]
    lab: tuple[LabPicture, ...]
    calibration: CalibrationResult
    poses: tuple[Solved, ...]


def make_parts(
    services: Services,
    progress: Progress,
    is_cancelled: Callable[[], bool],
    scenes: Sequence[str] = SCENES,
) -> Parts:
    """Render, encode, ingest, calibrate and pose; files of an earlier, interrupted try are thrown away.

    Everything slow is done here, so that the transaction that stores the survey is short.
    """
    scratch = services.scratch / "demonstration"
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    try:
        paths = render_videos(scratch, progress, scenes)
        videos = tuple(
            _read(services, name, path, scratch, progress, is_cancelled) for name, path in paths.items()
        )
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    progress(READING, "Calibrating the demonstration's lens.")
    lab = tuple(_lab_picture(services, index) for index in range(LAB_COUNT))
    calibration = calibrate(
        [(one.seen.name, one.seen.corners, one.seen.size) for one in lab], LAB_BOARD, "brown"
    )
    progress(0.96, "Solving for the demonstration's road poses.")
    poses = tuple(_pose(video, calibration) for video in videos)
    return Parts(videos, lab, calibration, poses)


def render_videos(folder: Path, progress: Progress, scenes: Sequence[str]) -> dict[str, Path]:
    """The videos as files, by what the scenes were asked for as."""
    total = sum(scene_named(name).frames for name in scenes)
    done = 0

    def told(frames: Iterator[Image], name: str) -> Iterator[Image]:
        nonlocal done
        for frame in frames:
            yield frame
            done += 1
            if done % 10 == 0:
                progress(
                    RENDERING * done / total, f"Drawing {file_of(name)}: frame {done} of {total} in all."
                )

    paths = {}
    for name in scenes:
        paths[name] = folder / file_of(name)
        with closing(rendered(name)) as frames:
            write_mp4(paths[name], told(frames, name), scene_named(name).fps)
    return paths


def file_of(name: str) -> str:
    """The video's file name."""
    return FILES[scene_named(name).name]


def _read(
    services: Services,
    name: str,
    path: Path,
    scratch: Path,
    progress: Progress,
    is_cancelled: Callable[[], bool],
) -> Video:
    """Ingest a video and put it, with its thumbnails, into the media store."""
    scene = scene_named(name)
    progress(RENDERING, f"Reading {path.name}.")
    thumbs = scratch / f"thumbs-{scene.name}"
    found = ingest(path, lambda _: None, is_cancelled, thumbs, work_dir=scratch, name=path.name)
    sha256 = sha256_of(path)
    key = key_of(sha256, path.suffix)
    services.media.put_file(key, path)
    services.media.put_file(thumbnails_key_of(sha256), pack_thumbnails(thumbs, found))
    still = board_corners(path, scene)
    return Video(scene, path.name, key, sha256, path.stat().st_size, found, still, truth(scene))


def board_corners(path: Path, scene: Scene) -> tuple[Corners, ...]:
    """The board as our own detector sees it in the decoded video, in some of its frames."""
    wanted = set(frames_to_try(0, scene.board_frames - 1))
    board = Board(scene.board.columns, scene.board.rows, scene.board.square_m)
    pictures: Iterator[tuple[int, int, Gray]] = islice(frames_of(path), scene.board_frames)
    return tuple(detect(gray, board) for n, _pts, gray in pictures if n in wanted)


def _lab_picture(services: Services, index: int) -> LabPicture:
    """One lab checkerboard: left as a file for visitors, stored, and looked at as an upload would be."""
    name = f"lab-{index + 1:02d}.png"
    content = png(lab_image(index))
    folder = demonstration_folder(services) / "lab"
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / name
    path.write_bytes(content)
    key = key_of(sha256_of(path), path.suffix)
    services.media.put_file(key, path)
    gray = read_image(content, name)
    corners = detect(gray, LAB_BOARD)
    return LabPicture(Seen(name, corners, (int(gray.shape[1]), int(gray.shape[0]))), key)


def demonstration_folder(services: Services) -> Path:
    """Where what visitors and tests may look at is left."""
    return services.settings.data_dir / "demonstration"


def _pose(video: Video, calibration: CalibrationResult) -> Solved:
    board = video.scene.board
    return solve(
        calibration.camera,
        video.still,
        Board(board.columns, board.rows, board.square_m),
        Reference("top", board.reference_height_m),
    )


def write_truth(services: Services, parts: Parts, numbers: Mapping[str, Sequence[int]]) -> None:
    """The scenes' truth as JSON, for tests only; `numbers` are the vehicles' numbers in the survey."""
    documents: dict[str, Any] = {}
    for video in parts.videos:
        document = truth_document(video.scene)
        passes = document["passes"]
        assert isinstance(passes, list)
        for one, number in zip(passes, numbers[video.scene.name], strict=True):
            one["vehicle_number"] = number
        documents[video.scene.name] = {**document, "recording": video.name}
    folder = demonstration_folder(services)
    folder.mkdir(parents=True, exist_ok=True)
    half = folder / ".truth.json.part"
    half.write_bytes(json_bytes(documents))
    half.replace(folder / "truth.json")
