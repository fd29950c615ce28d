"""Looking for vehicle passes in a video: one decode from first frame to last."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from pathlib import Path

from sightline.detection.classify import FoundPass
from sightline.detection.finder import PassFinder, downsample
from sightline.errors import BadInput
from sightline.media.cancelling import Cancelled
from sightline.media.video.decode import Damage, decoded, open_container, same_size, video_stream
from sightline.media.video.picture import layout_of, upright_gray

PICTURES_HZ = 60.0
Progress = Callable[[float], None]


class PassesCancelled(BadInput):
    """Nobody wants the passes any more."""

    kind = "cancelled"


def find_passes(
    path: Path,
    *,
    rate_hz: float | None = None,
    square_at: float = 0.5,
    on_progress: Progress = lambda _: None,
    is_cancelled: Cancelled = lambda: False,
    threads: int = 1,
    name: str | None = None,
) -> tuple[tuple[FoundPass, ...], int]:
    """The vehicle passes of a recording in order of their first frame, and how many frames it has.

    Frames count as in its frame table. `rate_hz` is the mean frame rate (default: what the file says, else
    25), `square_at` the fraction of the picture's width where the camera looks square at the road.
    `on_progress` gets a fraction 0..1; `is_cancelled` is asked at every frame. Two vehicles side by side that
    go the same way and cover each other all the way are one pass. Raises BadInput (not a video),
    PassesCancelled.
    """
    name = name or path.name
    with closing(open_container(path, name)) as container:
        stream = video_stream(container, name, threads)
        rate = rate_hz or float(stream.average_rate or 25)
        stride = max(1, round(rate / PICTURES_HZ))
        damage, size, layout, n = Damage(), max(path.stat().st_size, 1), None, -1
        finder: PassFinder | None = None
        for frame in decoded(container, stream, damage):
            if is_cancelled():
                raise PassesCancelled("video-search-passes-cancelled-nothing-kept", name=name)
            layout = layout or layout_of(frame, stream.sample_aspect_ratio)
            if not same_size(frame, layout):
                continue
            n += 1
            if n % stride:
                continue
            gray = upright_gray(frame, layout)
            finder = finder or PassFinder((gray.shape[1], gray.shape[0]), rate, stride, square_at)
            finder.offer(downsample(n, gray))
            if n % 30 == 0 and damage.position is not None:
                on_progress(min(0.99, damage.position / size))
    if finder is None:
        raise BadInput("video-holds-no-picture-decoded-copy-again", name=name)
    on_progress(1.0)
    return finder.finish(), n + 1
