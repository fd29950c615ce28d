"""Small pictures for the timeline, with the mean luminance of each."""

from dataclasses import dataclass
from pathlib import Path

import av
import cv2
import numpy as np

from sightline.media.atomic import atomic_file
from sightline.media.images import jpeg
from sightline.media.video.picture import Layout, mean_luminance, upright_small

WIDTH_PX = 160
MOST = 400
AT_LEAST = 20
QUALITY = 80
# what they need at most on disk: a noisy picture of this size and quality takes about 12 kB
ROOM_BYTES = MOST * 16_000


@dataclass(frozen=True)
class Thumbnail:
    """A thumbnail of frame n: file `name` in the thumbnail folder, mean luminance 0-255 of the frame."""

    n: int
    name: str
    luminance: float


class ThumbnailWriter:
    """Takes about one picture a second, more for short clips, never more than `MOST` in all.

    How long a recording is turns out only at its end, so when there are too many, every other one is
    dropped and the step doubles.
    """

    def __init__(self, folder: Path, layout: Layout, duration_s: float | None) -> None:
        self._folder = folder
        self._layout = layout
        self._step_s = min(1.0, (duration_s or AT_LEAST) / AT_LEAST)
        self._next_s = 0.0
        self._kept: list[Thumbnail] = []
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("*.jpg"):
            old.unlink()

    def offer(self, n: int, frame: av.VideoFrame) -> None:
        """Look at frame n and keep a thumbnail if it is time for one; cheap when it is not."""
        time_s = frame.time if frame.time is not None else n / 25.0
        if self._kept and abs(time_s - self._next_s) >= 2 * self._step_s:
            self._next_s = time_s  # the clock jumped: go on from where it is now
        if self._kept and time_s < self._next_s:
            return
        self._next_s = (self._next_s if self._kept else time_s) + self._step_s
        self._keep(n, frame)
        if len(self._kept) > MOST:
            self._thin()

    def finish(self) -> tuple[Thumbnail, ...]:
        """The thumbnails kept, in order of n."""
        return tuple(self._kept)

    def _keep(self, n: int, frame: av.VideoFrame) -> None:
        small = upright_small(frame, self._layout, WIDTH_PX)
        name = f"{n:08d}.jpg"
        with atomic_file(self._folder / name, lasting=False) as part:
            part.write_bytes(jpeg(small, QUALITY))
        gray = np.asarray(cv2.cvtColor(small, cv2.COLOR_BGR2GRAY), np.uint8)
        self._kept.append(Thumbnail(n, name, mean_luminance(gray)))

    def _thin(self) -> None:
        for dropped in self._kept[1::2]:
            (self._folder / dropped.name).unlink(missing_ok=True)
        self._kept = self._kept[::2]
        self._step_s *= 2
