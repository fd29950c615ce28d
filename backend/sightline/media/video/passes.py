"""Looking for vehicle passes in a video: one decode of all frames, two where the traffic runs down it."""

from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from sightline.detection.classify import FoundPass
from sightline.detection.finder import PassFinder, downsample
from sightline.detection.steadiness import Wander
from sightline.errors import BadInput, Stopped
from sightline.media.cancelling import Cancelled, Progress, Watch
from sightline.media.video.decode import number_frames, open_container, video_stream
from sightline.media.video.picture import upright_gray
from sightline.messages.said import Said

PICTURES_HZ = 60.0


@dataclass(frozen=True)
class PassSearch:
    """The passes of a recording by first frame, how many frames it has, and what to say of the search."""

    passes: tuple[FoundPass, ...]
    frames: int
    notes: tuple[Said, ...]


def find_passes(
    path: Path,
    *,
    rate_hz: float | None = None,
    square_at: float = 0.5,
    on_progress: Progress = lambda _: None,
    is_cancelled: Cancelled = lambda: False,
    threads: int = 1,
    name: str | None = None,
    stream_number: int | None = None,
) -> PassSearch:
    """The vehicle passes of a recording.

    Frames count as in its frame table. `rate_hz` is the mean frame rate (default: what the file says, else
    25), `square_at` the fraction of the picture's width where the camera looks square at the road.
    `on_progress` gets a fraction 0..1; `is_cancelled` is asked at every frame. Two vehicles side by side that
    go the same way and cover each other all the way are one pass. Where the traffic runs down the picture it
    is searched a second time with rows and columns exchanged. A camera that wanders is followed, and the
    notes say so; one that wanders too far gives no passes. Raises BadInput (not a video), Stopped.
    """
    name = name or path.name
    how = (is_cancelled, threads, stream_number)
    finder, frames, width_px = _searched(path, name, rate_hz, square_at, on_progress, *how)
    wander = finder.wander
    passes = () if wander.hopeless else finder.finish()
    if not wander.hopeless and finder.runs_down:
        finder, _, _ = _searched(path, name, rate_hz, None, lambda _: None, *how)
        passes = finder.finish()
    on_progress(1.0)
    return PassSearch(passes, frames, _notes(wander, width_px))


def _searched(
    path: Path,
    name: str,
    rate_hz: float | None,
    square_at: float | None,
    on_progress: Progress,
    is_cancelled: Cancelled,
    threads: int,
    stream_number: int | None,
) -> tuple[PassFinder, int, int]:
    """A finder after every picture, their number and width; `square_at` None: rows and columns exchanged."""
    with closing(open_container(path, name)) as container:
        stream = video_stream(container, name, threads, stream_number)
        rate = rate_hz or float(stream.average_rate or 25)
        stride = max(1, round(rate / PICTURES_HZ))
        n = width_px = 0
        finder: PassFinder | None = None
        stopped = partial(Stopped, "video-search-cancelled")
        watch = Watch(on_progress, is_cancelled, name, path.stat().st_size, stopped)
        for n, frame, layout in number_frames(container, stream, name, look=watch.look):
            if n % stride:
                continue
            gray = upright_gray(frame, layout)
            width_px = gray.shape[1]
            if square_at is None:
                gray = np.ascontiguousarray(gray.T)
            finder = finder or PassFinder(
                (gray.shape[1], gray.shape[0]),
                rate,
                stride,
                0.5 if square_at is None else square_at,
                square_at is None,
            )
            finder.offer(downsample(n, gray))
    if finder is None:
        raise BadInput("video-no-frame-readable", name=name)
    return finder, n + 1, width_px


def _notes(wander: Wander, width_px: int) -> tuple[Said, ...]:
    """What a wandering camera means for the passes."""
    far_px = round(max(1.0, wander.usual * width_px))
    if wander.hopeless:
        return (Said("passes-camera-moves-too-far", far_px=far_px),)
    return () if wander.still else (Said("passes-camera-moves", far_px=far_px),)
