"""Decoded frames of recordings: warm decoders and a window of frames, bounded in bytes. In this process."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from typing import cast

import av
import numpy as np
from numpy.typing import NDArray

from sightline.enums import Display
from sightline.errors import NotFound
from sightline.media.images import jpeg, no_larger, png, read_image, read_image_bgr
from sightline.media.video.caches import MemoryCache
from sightline.media.video.display import shown_as
from sightline.media.video.picture import Bgr, Gray, Layout, has_half_chroma, upright_gray, upright_picture
from sightline.media.video.seeker import WHOLE, Decoded, RecordingMedia, Seeker

JPEG_QUALITY = 95
# What an open decoder holds beside the window: reference frames and those of its threads, 16 as measured.
FRAMES_OF_DECODER = 20
OPEN_BYTES = 1_000_000_000
CancelCheck = Callable[[], bool]
Rectangle = tuple[int, int, int, int, int]


def is_always_wanted() -> bool:
    return True


class NoLongerWanted(NotFound):
    """The asker went away while the frame was being looked for."""

    kind = "not_wanted"


class _OpenDecoder:
    """One open recording: its seeker, and the lock that lets one thread at a time use it."""

    def __init__(self, seeker: Seeker) -> None:
        self.seeker = seeker
        self.lock = threading.Lock()
        self.closed = False
        self.held_bytes = 0


class Window:
    """Pictures of frame n, decoded here; a DecodeHost has them decoded in a child, by the same methods.

    All raise Damaged if the file does not give the frame whose checksum is in the table, or is missing;
    NoLongerWanted once `wanted` (asked between frames) says no. A Rectangle: x, y, w, h in px and the scale.

    Decoded frames are kept as the decoder gave them (YUV), so that a step back costs a conversion and not a
    group of pictures. At most `max_open` decoders stay open, fewer where they hold more than `open_bytes`.
    Thread-safe. What is asked for `ahead` of the operator has a decoder and a small window of its own, so
    that it never throws out what the operator sees.
    """

    def __init__(self, memory_bytes: int, *, max_open: int = 4, open_bytes: int = OPEN_BYTES) -> None:
        self._frames: MemoryCache[Decoded] = MemoryCache(memory_bytes, _bytes_of)
        self._max_open = max_open
        self._open_bytes = open_bytes
        self._desks: OrderedDict[str, _OpenDecoder] = OrderedDict()
        self._lock = threading.Lock()
        self._ahead: Window | None = None

    def still(
        self, media: RecordingMedia, n: int, wanted: CancelCheck, display: Display, *, ahead: bool = False
    ) -> bytes:
        """Frame n as JPEG, quality 95, colour sampled as in the recording; "bright": to look at only."""
        where = self._prefetch_window() if ahead and n not in self.warm(media) else self
        frame, layout = where._decoded(media, n, wanted)
        picture = shown_as(upright_picture(frame, layout), display)
        return jpeg(picture, JPEG_QUALITY, half_chroma=has_half_chroma(frame, layout))

    def crop_png(
        self, media: RecordingMedia, n: int, rectangle: Rectangle, wanted: CancelCheck, display: Display
    ) -> bytes:
        """A rectangle of frame n, lossless; black where it reaches out of the picture."""
        *place, scale = rectangle
        crop = _cut(shown_as(self.bgr(media, n, wanted), display), *place)
        if scale > 1:
            crop = np.repeat(np.repeat(crop, scale, axis=0), scale, axis=1)
        return png(crop)

    def bgr(self, media: RecordingMedia, n: int, wanted: CancelCheck) -> Bgr:
        """Frame n, (height_px, width_px, 3) BGR."""
        return upright_picture(*self._decoded(media, n, wanted))

    def gray(self, media: RecordingMedia, n: int, wanted: CancelCheck) -> Gray:
        """Frame n, (height_px, width_px) luminance."""
        return upright_gray(*self._decoded(media, n, wanted))

    def image(self, data: bytes, name: str, *, colour: bool, most_px: int | None = None) -> NDArray[np.uint8]:
        """A still, BGR or luminance, no side longer than `most_px`. Raises BadInput as `read_image` does."""
        image = read_image_bgr(data, name) if colour else read_image(data, name)
        return image if most_px is None else no_larger(image, most_px)

    def warm(self, media: RecordingMedia) -> list[int]:
        """The frames that are answered without decoding, in order."""
        identity = media.identity
        keys = cast("list[tuple[str, int, int]]", self._frames.keys())
        return sorted(n for one, n, _ in keys if one == identity)

    @property
    def memory_bytes(self) -> int:
        """What the window holds now."""
        return self._frames.held_bytes

    def start(self) -> None:
        """Nothing: this process runs already."""

    def close(self) -> None:
        """Close all decoders; frames stay. They are opened again when asked."""
        with self._lock:
            desks = list(self._desks.values())
            self._desks.clear()
            ahead = self._ahead
        for desk in desks:
            _shut(desk)
        if ahead is not None:
            ahead.close()

    def _prefetch_window(self) -> Window:
        with self._lock:
            if self._ahead is None:
                self._ahead = Window(self._frames.most_bytes // 8, max_open=1)
            return self._ahead

    def _decoded(self, media: RecordingMedia, n: int, wanted: CancelCheck) -> Decoded:
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

    def _seek(
        self, desk: _OpenDecoder, media: RecordingMedia, identity: str, n: int, wanted: CancelCheck
    ) -> Decoded:
        """Under the desk's lock: let the seeker find frame n; all it passes on the way goes to the cache.

        Who steps back out of the window wants all the frames before n next; after a jump a few of them do.
        """

        def keep(m: int, frame: av.VideoFrame, layout: Layout) -> None:
            desk.held_bytes = FRAMES_OF_DECODER * _size(frame)
            self._frames.put((identity, m, int(media.crc[m])), (frame, layout))

        desk.seeker.keep = keep
        after = range(n + 1, min(n + 1 + WHOLE, len(media)))
        is_step_back = any((identity, m, int(media.crc[m])) in self._frames for m in after)
        found = desk.seeker.find(n, wanted, jump=not is_step_back)
        if found is None:
            raise NoLongerWanted("video-numbered-frame-unwanted", n=n)
        return found

    def _desk(self, media: RecordingMedia, identity: str) -> _OpenDecoder:
        with self._lock:
            desk = self._desks.pop(identity, None) or _OpenDecoder(Seeker(media))
            self._desks[identity] = desk
            over = []
            while len(self._desks) > 1 and self._is_too_much():
                over.append(self._desks.popitem(last=False)[1])
        for old in over:
            _shut(old)
        return desk

    def _is_too_much(self) -> bool:
        held = sum(desk.held_bytes for desk in self._desks.values())
        return len(self._desks) > self._max_open or held > self._open_bytes


def _shut(desk: _OpenDecoder) -> None:
    with desk.lock:
        desk.closed = True
        desk.seeker.close()


def _bytes_of(decoded: Decoded) -> int:
    return _size(decoded[0])


def _size(frame: av.VideoFrame) -> int:
    return sum(plane.buffer_size for plane in frame.planes)


def _cut(image: Bgr, x: int, y: int, w: int, h: int) -> Bgr:
    height, width = image.shape[:2]
    out = np.zeros((h, w, 3), np.uint8)
    x0, y0, x1, y1 = max(x, 0), max(y, 0), min(x + w, width), min(y + h, height)
    if x0 < x1 and y0 < y1:
        out[y0 - y : y1 - y, x0 - x : x1 - x] = image[y0:y1, x0:x1]
    return out
