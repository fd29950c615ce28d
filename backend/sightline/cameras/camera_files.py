"""Pictures and clips of a checkerboard, read for the command line's `calibrate` and `pose`."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from hashlib import sha256
from pathlib import Path
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.geometry.board import Board
from sightline.geometry.calibration import NamedCorners
from sightline.geometry.camera import Camera, require_size
from sightline.geometry.corners import Corners, Gray, find_board, not_found
from sightline.geometry.mean_picture import MeanPicture
from sightline.geometry.tracking import track
from sightline.media.images import HEIF, read_image
from sightline.media.video.decode import frames_of
from sightline.media.video.endings import VIDEO_ENDINGS
from sightline.messages.said import Said

Frames = Callable[[Path, int | None], Iterator[tuple[str, Gray]]]

CLIP_VIEWS = 24  # views taken from a clip for a calibration: enough, and little alike
POSE_FRAMES = 150  # frames of a clip that a pose looks at before it skips some
SEARCH_S = 8.0  # how long frames are searched in vain, all together
_IMAGE_ENDINGS = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp", ".pgm", ".ppm", ".pnm", ".jp2"}


def pictures_of(path: Path, frames: Frames, stream_number: int | None) -> Iterator[tuple[str, Gray]]:
    """The picture in a file, or those `frames` takes of a clip's track (`decode.video_stream`), each with its
    name.

    Raises BadInput in one sentence that names the file; also where a track is asked for of a picture.
    """
    if not path.is_file():
        raise BadInput("cameras-not-a-file", path=path)
    ending = path.suffix.lower()
    if ending in VIDEO_ENDINGS:
        yield from frames(path, stream_number)
        return
    try:
        picture = read_image(path)
    except BadInput as error:
        if ending in _IMAGE_ENDINGS or error.code == HEIF:
            raise
        yield from frames(path, stream_number)
        return
    if stream_number is not None:
        raise BadInput("cameras-still-without-tracks", path=path)
    yield path.name, picture


def spread_frames(path: Path, stream_number: int | None) -> Iterator[tuple[str, Gray]]:
    """At most twice `CLIP_VIEWS` frames, evenly: the step doubles, for a clip tells its length at its end."""
    held: list[tuple[int, Gray]] = []
    step = 1
    for n, _, gray in frames_of(path, number=stream_number):
        if n % step == 0:
            held.append((n, gray))
        if len(held) >= 2 * CLIP_VIEWS:
            held = held[::2]
            step *= 2
    for n, gray in held:
        yield f"{path.name} frame {n}", gray


def early_frames(path: Path, stream_number: int | None) -> Iterator[tuple[str, Gray]]:
    """Every frame of a short clip; of a long one every second, then every fourth: none is held."""
    step, taken = 1, 0
    for n, _, gray in frames_of(path, number=stream_number):
        if n % step:
            continue
        yield f"{path.name} frame {n}", gray
        taken += 1
        if taken == 2 * POSE_FRAMES:
            step, taken = 2 * step, POSE_FRAMES


def calibration_views(
    paths: Sequence[Path], board: Board, stream_number: int | None = None
) -> list[NamedCorners]:
    """One detection per picture or chosen frame, as `geometry.calibration.calibrate` takes them."""
    views: list[NamedCorners] = []
    for path in paths:
        for name, gray in pictures_of(path, spread_frames, stream_number):
            views.append((name, find_board(gray, board), (gray.shape[1], gray.shape[0])))
    return views


def pose_detections(
    paths: Sequence[Path], camera: Camera, board: Board, stream_number: int | None = None
) -> tuple[list[Corners], NDArray[np.float64] | None, tuple[Said, ...]]:
    """The board in every picture or frame, in time order, found once and then followed; the mean picture of
    the frames in which it stood still; and what was given before, which counts once.

    A span without the board is searched for a bounded time. Raises BadInput where a picture has another
    size than the camera's.
    """
    seen, twice, frames_twice = dict[bytes, int](), list[Said](), Counter[str]()
    detections: list[Corners] = []
    last: Corners | None = None
    mean = MeanPicture()
    searched_s = 0.0
    for number, path in enumerate(paths):
        for name, gray in pictures_of(path, early_frames, stream_number):
            require_size(camera, gray.shape[1], gray.shape[0], name)
            before = seen.setdefault(sha256(gray.tobytes()).digest(), number)
            if before != number:
                # counted again it would make the pose look better known than it is
                if name == path.name:  # no frame of a clip
                    twice.append(Said("pose-image-twice", name=name, file=paths[before].name))
                else:
                    frames_twice[path.name] += 1
                continue
            corners = not_found(board, Said("board-search-stopped")) if last is None else track(gray, last)
            if not corners.found and searched_s < SEARCH_S:
                started = perf_counter()
                corners = find_board(gray, board)
                searched_s += 0.0 if corners.found else perf_counter() - started
            detections.append(corners)
            if corners.found:
                last = corners
                mean.add(gray, corners)
    twice += [Said("pose-frames-twice", name=name, count=count) for name, count in frames_twice.items()]
    return detections, mean.result(), tuple(twice)
