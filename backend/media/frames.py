"""Stills by frame number: warm decoders, a window of decoded frames, and caches bounded in bytes."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from pathlib import Path

import av
import numpy as np

from backend.errors import BadInput, NotFound
from backend.media.caches import DiskCache, MemoryCache
from backend.media.images import jpeg, png
from backend.media.picture import Bgr, Gray, Layout, upright, upright_gray
from backend.media.seeker import Decoded, RecordingMedia, Seeker

JPEG_QUALITY = 95
MOST_CROP_PX = 4096 * 4096
MOST_CROP_SCALE = 16
__all__ = ["FrameServer", "RecordingMedia"]

Wanted = Callable[[], bool]


def always() -> bool:
    return True


class NotWanted(NotFound):
    """The asker went away while the frame was being looked for."""

    code = "not_wanted"


class _Desk:
    """One open recording: its seeker, and the lock that lets one thread at a time use it."""

    def __init__(self, seeker: Seeker) -> None:
        self.seeker = seeker
        self.lock = threading.Lock()
        self.closed = False


class FrameServer:
    """Serves frame n of a recording as it was numbered at ingest, or an error; never another picture.

    Decoded frames are kept as the decoder gave them (YUV), so that a step back costs a conversion and
    not a group of pictures. Memory holds frames (three quarters) and JPEGs (a quarter); the disk holds
    JPEGs. At most `max_open` decoders stay open. Thread-safe. `wanted` (asked between frames) lets a
    caller give up: the answer is then NotWanted.

    All methods raise NotFound for an n outside the table, Damaged if the file does not give the frame whose
    checksum is in the table, or is missing.
    """

    def __init__(self, cache_dir: Path, memory_bytes: int, disk_bytes: int, *, max_open: int = 4) -> None:
        self._frames: MemoryCache[Decoded] = MemoryCache(memory_bytes * 3 // 4)
        self._jpegs: MemoryCache[bytes] = MemoryCache(memory_bytes // 4)
        self._disk = DiskCache(cache_dir / "stills", disk_bytes)
        self._max_open = max_open
        self._desks: OrderedDict[str, _Desk] = OrderedDict()
        self._lock = threading.Lock()

    def still(self, media: RecordingMedia, n: int, wanted: Wanted = always) -> bytes:
        """Frame n as JPEG, quality 95, 4:4:4, upright with square pixels."""
        _check(media, n)
        key = f"{media.identity}/{n // 1000}/{n}-{int(media.crc[n]):08x}.jpg"
        data = self._jpegs.get(key)
        if data is None:
            data = self._disk.get(key)
            if data is None:
                data = jpeg(self.bgr(media, n, wanted), JPEG_QUALITY)
                self._disk.put(key, data)
            self._jpegs.put(key, data, len(data))
        return data

    def bgr(self, media: RecordingMedia, n: int, wanted: Wanted = always) -> Bgr:
        """Frame n, (height_px, width_px, 3) BGR."""
        return upright(*self._decoded(media, n, wanted))

    def gray(self, media: RecordingMedia, n: int, wanted: Wanted = always) -> Gray:
        """Frame n, (height_px, width_px) luminance."""
        return upright_gray(*self._decoded(media, n, wanted))

    def crop_png(
        self, media: RecordingMedia, n: int, x: int, y: int, w: int, h: int, scale: int = 1
    ) -> bytes:
        """The rectangle of w x h pixels whose top-left pixel is (x, y), lossless; each pixel `scale`
        times as large.

        What lies outside the picture is black, so the crop always has the size that was asked for.
        Raises BadInput for a size or scale out of bounds.
        """
        if not 1 <= scale <= MOST_CROP_SCALE or w < 1 or h < 1 or w * h * scale * scale > MOST_CROP_PX:
            raise BadInput(
                f"A crop of {w} x {h} pixels at scale {scale} is out of bounds; ask for a smaller one."
            )
        crop = _cut(self.bgr(media, n), x, y, w, h)
        if scale > 1:
            crop = np.repeat(np.repeat(crop, scale, axis=0), scale, axis=1)
        return png(crop)

    def is_warm(self, media: RecordingMedia, n: int) -> bool:
        """Whether frame n can be answered without decoding."""
        return (media.identity, n, int(media.crc[n])) in self._frames

    @property
    def memory_bytes(self) -> int:
        """What the caches in memory hold now."""
        return self._frames.held_bytes + self._jpegs.held_bytes

    def close(self) -> None:
        """Close all decoders; caches stay. The server opens them again when asked."""
        with self._lock:
            desks = list(self._desks.values())
            self._desks.clear()
        for desk in desks:
            _shut(desk)

    def _decoded(self, media: RecordingMedia, n: int, wanted: Wanted) -> Decoded:
        _check(media, n)
        identity = media.identity
        key = (identity, n, int(media.crc[n]))
        while True:
            found = self._frames.get(key)
            if found is not None:
                return found
            desk = self._desk(media, identity)
            with desk.lock:
                if desk.closed:
                    continue
                found = self._frames.get(key)
                return found or self._seek(desk, media, identity, n, wanted)

    def _seek(self, desk: _Desk, media: RecordingMedia, identity: str, n: int, wanted: Wanted) -> Decoded:
        """Under the desk's lock: let the seeker find frame n; all it passes on the way goes to the cache."""

        def keep(m: int, frame: av.VideoFrame, layout: Layout) -> None:
            self._frames.put((identity, m, int(media.crc[m])), (frame, layout), _size(frame))

        desk.seeker.keep = keep
        found = desk.seeker.find(n, wanted)
        if found is None:
            raise NotWanted(f"Frame {n} was no longer wanted.")
        return found

    def _desk(self, media: RecordingMedia, identity: str) -> _Desk:
        with self._lock:
            desk = self._desks.get(identity)
            if desk is not None:
                self._desks.move_to_end(identity)
                return desk
            desk = self._desks[identity] = _Desk(Seeker(media))
            over = [self._desks.popitem(last=False)[1] for _ in range(len(self._desks) - self._max_open)]
        for old in over:
            _shut(old)
        return desk


def _shut(desk: _Desk) -> None:
    with desk.lock:
        desk.closed = True
        desk.seeker.close()


def _check(media: RecordingMedia, n: int) -> None:
    if not 0 <= n < len(media):
        raise NotFound(f"There is no frame {n}; this recording has frames 0 to {len(media) - 1}.")


def _size(frame: av.VideoFrame) -> int:
    return sum(plane.buffer_size for plane in frame.planes)


def _cut(image: Bgr, x: int, y: int, w: int, h: int) -> Bgr:
    height, width = image.shape[:2]
    out = np.zeros((h, w, 3), np.uint8)
    x0, y0, x1, y1 = max(x, 0), max(y, 0), min(x + w, width), min(y + h, height)
    if x0 < x1 and y0 < y1:
        out[y0 - y : y1 - y, x0 - x : x1 - x] = image[y0:y1, x0:x1]
    return out
