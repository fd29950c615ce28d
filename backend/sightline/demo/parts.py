"""What the demonstration survey is made of, before it is stored: read, calibrated, posed, searched."""

import tempfile
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from threading import Event
from typing import Any

from sightline.cameras.calibrations.calibrating import DetectedView
from sightline.demo.made import FOLDER, SceneTruth, lab_images, truth
from sightline.demo.scan import ScanParts, make_scan
from sightline.geometry.calibration_checks import CheckedCalibration, calibrate_and_check
from sightline.geometry.corners import find_board
from sightline.geometry.road_pose import Reference
from sightline.infra.services import Services
from sightline.media.cancelling import check_cancelled
from sightline.media.images import read_image
from sightline.media.store.local import key_of, sha256_of
from sightline.media.video.decode import frames_of
from sightline.media.video.ingest import Ingested, ingest
from sightline.messages.said import Said
from sightline.poses.records import SolvedPose
from sightline.poses.service import BoardSeen, frames_to_try, preview_board, solve
from sightline.recordings.ingest_job import pack_thumbnails, thumbnails_key_of

Progress = Callable[[float, Said], None]
Cancelled = Callable[[], bool]


@dataclass(frozen=True, eq=False)
class Film:
    """One ingested video, already in the media store."""

    name: str
    media_key: str
    sha256: str
    size_bytes: int
    found: Ingested


@dataclass(frozen=True, eq=False)
class Video(Film):
    """One of a board and vehicles, and what is true of them."""

    still: BoardSeen
    truth: SceneTruth


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
    poses: tuple[SolvedPose, ...]
    scan: ScanParts

    @property
    def keys(self) -> list[str]:
        """Of all its files in the media store."""
        videos = [key for one in self.videos for key in (one.media_key, thumbnails_key_of(one.sha256))]
        return [*videos, *(one.media_key for one in self.lab), *self.scan.keys]


def make_parts(services: Services, progress: Progress) -> Parts:
    """Ingest, calibrate, pose and search, all at once, so that the transaction that stores them is short."""
    stop = Event()
    with (
        tempfile.TemporaryDirectory(prefix="demonstration-", dir=services.scratch) as scratch,
        ThreadPoolExecutor(4, "demonstration") as pool,
    ):
        scenes = truth().scenes.values()
        videos = [pool.submit(_video, services, scene, Path(scratch), stop.is_set) for scene in scenes]
        lens = pool.submit(_lens, services, stop.is_set)
        scan = pool.submit(make_scan, services, stop.is_set)
        try:
            waited: list[Future[Any]] = [*videos, lens, scan]
            for n, done in enumerate(as_completed(waited), 1):
                done.result()
                progress(0.9 * n / len(waited), Said("job-demo-videos"))
        except BaseException:
            stop.set()
            raise
        lab, calibration = lens.result()
        read = tuple(one.result() for one in videos)
        progress(0.9, Said("job-demo-poses"))
        poses = tuple(_pose(video, calibration) for video in read)
        return Parts(videos=read, lab=lab, calibration=calibration, poses=poses, scan=scan.result())


def store_film(
    services: Services, path: Path, scratch: Path, is_cancelled: Cancelled = lambda: False
) -> Film:
    """Ingest a video and put it, with its thumbnails, into the media store, as an upload would be."""
    thumbs = scratch / f"thumbs-{path.name}"
    ingested = ingest(path, lambda _: None, is_cancelled, thumbs, work_dir=scratch, name=path.name)
    sha256 = sha256_of(path)
    key = key_of(sha256, path.suffix)
    services.media.put_file(key, path)
    services.media.put_file(thumbnails_key_of(sha256), pack_thumbnails(thumbs, ingested))
    return Film(path.name, key, sha256, path.stat().st_size, ingested)


def _video(services: Services, scene: SceneTruth, scratch: Path, is_cancelled: Cancelled) -> Video:
    film = store_film(services, FOLDER / scene.video, scratch, is_cancelled)
    return Video(**vars(film), still=_board_corners(scene), truth=scene)


def _board_corners(scene: SceneTruth) -> BoardSeen:
    """The board as our own detector sees it in the decoded video, in some of its frames."""
    last = scene.board.last_frame
    wanted = set(frames_to_try(0, last))
    pictures = islice(frames_of(FOLDER / scene.video), last + 1)
    return preview_board((gray for n, _pts, gray in pictures if n in wanted), scene.board.board)


def _lens(services: Services, is_cancelled: Cancelled) -> tuple[tuple[LabPicture, ...], CheckedCalibration]:
    """The lab images and the calibration from them. Raises Stopped when it is to stop."""
    lab = []
    for path in lab_images():
        check_cancelled(is_cancelled, "the demonstration")
        lab.append(_lab_picture(services, path))
    seen = [(one.seen.name, one.seen.corners, one.seen.size) for one in lab]
    return tuple(lab), calibrate_and_check(seen, truth().lab, "brown")


def _lab_picture(services: Services, path: Path) -> LabPicture:
    """One lab checkerboard: stored, and looked at as an upload would be."""
    key = key_of(sha256_of(path), path.suffix)
    services.media.put_file(key, path)
    gray = read_image(path)
    corners = find_board(gray, truth().lab)
    return LabPicture(DetectedView(path.name, corners, (int(gray.shape[1]), int(gray.shape[0]))), key)


def _pose(video: Video, calibration: CheckedCalibration) -> SolvedPose:
    board = video.truth.board
    reference = Reference("top", board.reference_height_m)
    return solve(calibration.result.camera, video.still, board.board, reference)
