"""What the demonstration survey is made of, before it is stored: videos, lab pictures, calibration, poses."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import closing
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from threading import Event, Lock
from typing import Any

from sightline.cameras.calibrations.calibrating import DetectedView
from sightline.demo.rendering import SCENES, Image, rendered, scene_named
from sightline.geometry.board import Board
from sightline.geometry.calibration import CalibrationResult
from sightline.geometry.calibration_checks import CheckedCalibration, calibrate_and_check
from sightline.geometry.corners import Gray, find_board
from sightline.geometry.road_pose import Reference
from sightline.infra.csv_package.schema import json_bytes
from sightline.infra.services import Services
from sightline.media.atomic import atomic_file
from sightline.media.cancelling import check_cancelled
from sightline.media.images import png, read_image
from sightline.media.store.local import key_of, sha256_of
from sightline.media.video.decode import frames_of
from sightline.media.video.ingest import Ingested, ingest
from sightline.media.video.writer import write_mp4
from sightline.poses.service import BoardSeen, Solved, frames_to_try, preview_board, solve
from sightline.recordings.ingest_job import pack_thumbnails, thumbnails_key_of
from sightline.simulation import truth
from sightline.simulation.board import LAB_COLUMNS, LAB_COUNT, LAB_ROWS, LAB_SQUARE_M, lab_image
from sightline.simulation.scene import Scene
from sightline.simulation.truth import PassTruth, truth_document

FILES = {"day": "daytime.mp4", "low_light": "low-light.mp4"}
READ = 0.95
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
    still: BoardSeen
    truth: tuple[PassTruth, ...]


@dataclass(frozen=True, eq=False)
class LabPicture:
    """One lab checkerboard, already in the media store."""

    seen: DetectedView
    media_key: str


@dataclass(frozen=True, eq=False)
class Parts:
    """Everything that the survey needs; `poses` are one a video."""

    videos: tuple[Video, ...]
    lab: tuple[LabPicture, ...]
    calibration: CheckedCalibration
    poses: tuple[Solved, ...]


@dataclass(eq=False)
class _Drawing:
    """What the threads that draw share: how far they are, and whether to stop."""

    total: int
    drawn: int = 0
    stop: Event = field(default_factory=Event)
    _counting: Lock = field(default_factory=Lock)

    def counted(self, frames: Iterator[Image]) -> Iterator[Image]:
        """The frames, counted. Raises IngestCancelled when it is to stop."""
        for frame in frames:
            check_cancelled(self.stop.is_set, "the demonstration")
            with self._counting:
                self.drawn += 1
            yield frame


def make_parts(services: Services, progress: Progress, scenes: Sequence[str] = SCENES) -> Parts:
    """Render, encode, ingest, calibrate and pose.

    Everything slow is done here, so that the transaction that stores the survey is short.
    """
    with tempfile.TemporaryDirectory(prefix="demonstration-", dir=services.scratch) as scratch:
        videos, (lab, calibration) = _side_by_side(services, Path(scratch), progress, scenes)
    progress(0.96, "Computing the camera poses.")
    poses = tuple(_pose(video, calibration.result) for video in videos)
    return Parts(videos, lab, calibration, poses)


def _side_by_side(
    services: Services, scratch: Path, progress: Progress, scenes: Sequence[str]
) -> tuple[tuple[Video, ...], tuple[tuple[LabPicture, ...], CheckedCalibration]]:
    """A thread for each video, and the lens for the one that ends first: no core waits for another.

    The shorter video is read while the longer one is still drawn, and each scene's road and vehicles are
    painted by as few processes as there are cores for.
    """
    drawing = _Drawing(sum(scene_named(name).frames for name in scenes))
    with ThreadPoolExecutor(len(scenes), "demonstration") as pool:
        try:
            videos = [pool.submit(_video, services, name, scratch, drawing, len(scenes)) for name in scenes]
            lens = pool.submit(_lens, services, drawing.stop.is_set)
            _watch([*videos, lens], drawing, progress)
        except BaseException:
            drawing.stop.set()
            lens.cancel()
            raise
    return tuple(video.result() for video in videos), lens.result()


def _watch(futures: Sequence[Future[Any]], drawing: _Drawing, progress: Progress) -> None:
    """Tell how far it is until all are done. Raises what one of them raised, or what `progress` does."""
    waiting = set(futures)
    while waiting:
        done, waiting = wait(waiting, timeout=0.5, return_when=FIRST_COMPLETED)
        for one in done:
            one.result()
        if drawing.drawn < drawing.total:
            told = f"Drawing the videos: frame {drawing.drawn} of {drawing.total}."
        else:
            told = "Reading the videos."
        progress(READ * drawing.drawn / drawing.total, told)


def _video(services: Services, name: str, scratch: Path, drawing: _Drawing, side_by_side: int) -> Video:
    """Draw a scene, encode it, and read it as an upload would be."""
    path = scratch / file_of(name)
    cores = max(1, (os.cpu_count() or 1) // side_by_side)
    with closing(rendered(name, cores)) as frames:
        write_mp4(path, drawing.counted(frames), scene_named(name).fps)
    return _read(services, name, path, scratch, drawing.stop.is_set)


def _lens(
    services: Services, is_cancelled: Callable[[], bool]
) -> tuple[tuple[LabPicture, ...], CheckedCalibration]:
    """The lab pictures and the calibration from them. Raises IngestCancelled when it is to stop."""
    lab = []
    for index in range(LAB_COUNT):
        check_cancelled(is_cancelled, "the demonstration")
        lab.append(_lab_picture(services, index))
    seen = [(one.seen.name, one.seen.corners, one.seen.size) for one in lab]
    return tuple(lab), calibrate_and_check(seen, LAB_BOARD, "brown")


def file_of(name: str) -> str:
    """The video's file name."""
    return FILES[scene_named(name).name]


def _read(
    services: Services,
    name: str,
    path: Path,
    scratch: Path,
    is_cancelled: Callable[[], bool],
) -> Video:
    """Ingest a video and put it, with its thumbnails, into the media store."""
    scene = scene_named(name)
    thumbs = scratch / f"thumbs-{scene.name}"
    found = ingest(path, lambda _: None, is_cancelled, thumbs, work_dir=scratch, name=path.name)
    sha256 = sha256_of(path)
    key = key_of(sha256, path.suffix)
    services.media.put_file(key, path)
    services.media.put_file(thumbnails_key_of(sha256), pack_thumbnails(thumbs, found))
    still = board_corners(path, scene)
    return Video(
        scene=scene,
        name=path.name,
        media_key=key,
        sha256=sha256,
        size_bytes=path.stat().st_size,
        found=found,
        still=still,
        truth=truth(scene),
    )


def board_corners(path: Path, scene: Scene) -> BoardSeen:
    """The board as our own detector sees it in the decoded video, in some of its frames."""
    wanted = set(frames_to_try(0, scene.board_frames - 1))
    board = Board(scene.board.columns, scene.board.rows, scene.board.square_m)
    pictures: Iterator[tuple[int, int, Gray]] = islice(frames_of(path), scene.board_frames)
    return preview_board((gray for n, _pts, gray in pictures if n in wanted), board)


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
    corners = find_board(gray, LAB_BOARD)
    return LabPicture(DetectedView(name, corners, (int(gray.shape[1]), int(gray.shape[0]))), key)


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
    with atomic_file(demonstration_folder(services) / "truth.json") as part:
        part.write_bytes(json_bytes(documents))
