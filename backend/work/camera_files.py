"""Pictures and clips of a checkerboard, read for the command line's `calibrate` and `pose`."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from backend.errors import BadInput
from backend.geometry.calibration import NamedCorners
from backend.geometry.camera import Camera, require_size
from backend.geometry.corners import Board, Corners, Gray, detect, not_found
from backend.geometry.mean_picture import MeanPicture
from backend.geometry.tracking import track
from backend.media.decode import frames_of
from backend.media.images import read_image

CLIP_VIEWS = 24  # views taken from a clip for a calibration: enough, and little alike
POSE_FRAMES = 150  # frames of a clip that a pose looks at
SEARCH_S = 8.0  # how long frames are searched in vain, all together
_IMAGE_ENDINGS = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp", ".pgm", ".ppm", ".pnm", ".jp2"}
_CLIP_ENDINGS = {
    ".mp4",
    ".mov",
    ".m4v",
    ".avi",
    ".mkv",
    ".webm",
    ".ts",
    ".mts",
    ".mpg",
    ".mpeg",
    ".h264",
    ".hevc",
}


def pictures_of(path: Path, most: int) -> Iterator[tuple[str, Gray]]:
    """The picture in a file, or up to `most` frames spread over a clip, each with its name.

    Raises BadInput in one sentence that names the file.
    """
    if not path.is_file():
        raise BadInput(f"{path} is not a file; give picture files or a clip.")
    ending = path.suffix.lower()
    if ending in _CLIP_ENDINGS:
        yield from _frames(path, most)
        return
    try:
        picture = read_image(path)
    except BadInput:
        if ending in _IMAGE_ENDINGS:
            raise
        yield from _frames(path, most)
        return
    yield path.name, picture


def _frames(path: Path, most: int) -> Iterator[tuple[str, Gray]]:
    """Frames at an even step, which doubles whenever twice `most` are held: a clip tells its length at the
    end.
    """
    held: list[tuple[int, Gray]] = []
    step = 1
    for n, _, gray in frames_of(path):
        if n % step == 0:
            held.append((n, gray))
        if len(held) >= 2 * most:
            held = held[::2]
            step *= 2
    for n, gray in held:
        yield f"{path.name} frame {n}", gray


def calibration_views(paths: Sequence[Path], board: Board) -> list[NamedCorners]:
    """One detection per picture or chosen frame, as `geometry.calibration.calibrate` takes them."""
    views: list[NamedCorners] = []
    for path in paths:
        for name, gray in pictures_of(path, CLIP_VIEWS):
            views.append((name, detect(gray, board), (gray.shape[1], gray.shape[0])))
    return views


def pose_detections(
    paths: Sequence[Path], camera: Camera, board: Board
) -> tuple[list[Corners], NDArray[np.float64] | None]:
    """The board in every picture or frame, in time order, found once and then followed; and the mean
    picture of the frames in which it stood still.

    A span without the board is searched for a bounded time. Raises BadInput where a picture has another
    size than the camera's.
    """
    found: list[Corners] = []
    last: Corners | None = None
    mean = MeanPicture()
    searched_s = 0.0
    for path in paths:
        for name, gray in pictures_of(path, POSE_FRAMES):
            require_size(camera, gray.shape[1], gray.shape[0], name)
            corners = not_found(board, "The search was given up.") if last is None else track(gray, last)
            if not corners.found and searched_s < SEARCH_S:
                started = perf_counter()
                corners = detect(gray, board)
                searched_s += 0.0 if corners.found else perf_counter() - started
            found.append(corners)
            if corners.found:
                last = corners
                mean.add(gray, corners)
    return found, mean.result()
