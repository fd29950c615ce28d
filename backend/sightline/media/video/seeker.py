"""A warm decoder of one recording that finds frame n of the frame table again, or says that it cannot.

A decoder after a seek says where it is by time stamp only, and time stamps may be missing, doubled or
out of order. So every decoded frame is matched against the table by time stamp *and* checksum; what does
not match (the leading frames of an open group, say) is never taken for a frame of the recording.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import Literal

import av
import numpy as np
from av.container import InputContainer
from av.video.stream import VideoStream
from numpy.typing import NDArray

from sightline.errors import BadInput, Damaged
from sightline.media.video.decode import (
    DECODER_THREADS,
    NO_PTS,
    decode_frames,
    frame_pts,
    open_container,
    same_size,
    video_stream,
)
from sightline.media.video.picture import Layout, layout_of, luma_crc

SEEK_TRIES = 3
STRAYS = 64
FROM_START = 3000
# Up to so many frames before the one that is looked for, the decoder may leave out frames no other needs.
WHOLE = 8
Decoded = tuple[av.VideoFrame, Layout]
Skip = Literal["DEFAULT", "NONREF", "BIDIR"]


@dataclass(frozen=True, eq=False)
class RecordingMedia:
    """A recording's file and its frame table as stored: arrays of shape (N,), int64, uint32 and bool.

    `stream_number`: which of the file's pictures, where a person may have chosen (`decode.video_stream`).
    """

    path: Path
    pts: NDArray[np.int64]
    crc: NDArray[np.uint32]
    key: NDArray[np.bool_]
    stream_number: int | None = None

    def __len__(self) -> int:
        return len(self.pts)

    @cached_property
    def identity(self) -> str:
        """Names file and table together: another table of the same file shares no cache with this one."""
        digest = hashlib.sha256(str(self.path.resolve()).encode())
        for array in (self.pts, self.crc):
            digest.update(np.ascontiguousarray(array).data)
        return digest.hexdigest()[:24]


@dataclass(frozen=True)
class _Attempt:
    """From frame `start` on: by a seek, by going on or opening anew; `skip`: frames left out on the way."""

    start: int
    go_on: bool = False
    from_start: bool = False
    threads: int = DECODER_THREADS
    skip: Skip = "DEFAULT"


class Seeker:
    """Not thread-safe: one thread at a time. `keep` is told every frame that was identified, with its n; of
    those that a jump does not leave out, only what steps can use.
    """

    def __init__(self, media: RecordingMedia) -> None:
        self.keep: Callable[[int, av.VideoFrame, Layout], None] = lambda n, frame, layout: None
        self._media = media
        self._by_pts = np.argsort(media.pts, kind="stable")
        self._sorted_pts = media.pts[self._by_pts]
        self._keys = np.flatnonzero(media.key)
        self._at: int | None = None
        self._lost: set[int] = set()
        self._container: InputContainer | None = None
        self._threads = DECODER_THREADS
        self._skips: list[Skip] = ["BIDIR", "NONREF"]
        self._skip: Skip = "DEFAULT"
        self._whole_from = NO_PTS

    def _open(self, threads: int = DECODER_THREADS) -> None:
        """Open the file, at the first request and for a decode from the start."""
        self.close()
        name = self._media.path.name
        try:
            self._container = open_container(self._media.path, name)
            self._stream: VideoStream = video_stream(
                self._container, name, threads, self._media.stream_number
            )
        except BadInput as error:
            raise Damaged("video-stored-missing", name=name) from error
        self._threads = threads
        self._frames: Iterator[av.VideoFrame] = self._from_here(self._container)
        self._layout: Layout | None = None
        self._at = None

    def close(self) -> None:
        if self._container is not None:
            self._container.close()
            self._container = None

    def find(
        self, n: int, wanted: Callable[[], bool] = lambda: True, *, jump: bool = False
    ) -> Decoded | None:
        """Frame n, 0 <= n < N, identified by its checksum; None if it is no longer `wanted` on the way.

        Decodes on from where it stands if no key frame lies nearer, else from the key frame before n, then
        from earlier ones; at last the same with one thread, as damaged recordings were taken in. A `jump`
        leaves out on its way what the decoder can do without; where that changes a picture, its checksum
        tells, and all is decoded from then on. Raises Damaged if the file does not give that frame any more.
        """
        if n in self._lost:
            raise self._damaged(n)
        if self._container is None:
            self._open()
        for attempt in chain(self._short_cuts(n) if jump else (), self._attempts(n)):
            self._skip, self._whole_from = attempt.skip, int(self._media.pts[max(0, n - WHOLE)])
            if not self._go_to(attempt):
                continue
            found = self._roll(n, attempt, wanted)
            if found is not None or not wanted():
                return found
            if attempt.skip in self._skips:
                self._skips.remove(attempt.skip)
        self._lost.add(n)
        raise self._damaged(n)

    def _damaged(self, n: int) -> Damaged:
        return Damaged("video-frame-changed", n=n)

    def _short_cuts(self, n: int) -> Iterator[_Attempt]:
        """The nearest start with frames left out, where the way is long."""
        for skip in tuple(self._skips):
            first = next(self._attempts(n))
            if first.from_start or first.start + WHOLE >= n or self._media.pts[n - WHOLE] == NO_PTS:
                return
            yield replace(first, skip=skip)

    def _from_here(self, container: InputContainer) -> Iterator[av.VideoFrame]:
        """Frames from where the container stands; what is to be left out is looked up packet by packet."""
        context = self._stream.codec_context

        def look(packet: av.Packet[VideoStream]) -> None:
            pts = packet.pts if packet.pts is not None else packet.dts
            early = pts is not None and pts < self._whole_from
            context.skip_frame = self._skip if early else "DEFAULT"

        return decode_frames(container, self._stream, look=look)

    def _attempts(self, n: int) -> Iterator[_Attempt]:
        """Where to begin and how, the quickest first."""
        before = self._keys[: np.searchsorted(self._keys, n, side="right")]
        nearest = int(before[-1]) if len(before) else 0
        if self._at is not None and nearest - 1 <= self._at < n:
            yield _Attempt(self._at, go_on=True)
        stamped = [int(k) for k in before[::-1][:SEEK_TRIES] if self._media.pts[k] != NO_PTS]
        yield from (_Attempt(key) for key in stamped)
        if not stamped:
            yield _Attempt(0, from_start=True)
        yield from (_Attempt(key, threads=1) for key in stamped[:1])
        if n <= FROM_START or not stamped:
            yield _Attempt(0, from_start=True, threads=1)

    def _go_to(self, attempt: _Attempt) -> bool:
        if attempt.go_on:
            return True
        if attempt.from_start or attempt.threads < self._threads:
            self._open(min(attempt.threads, self._threads))
        if attempt.from_start:
            return True
        assert self._container is not None
        try:
            self._container.seek(int(self._media.pts[attempt.start]), stream=self._stream)
        except av.error.FFmpegError:
            return False
        self._frames = self._from_here(self._container)
        self._at = None
        return True

    def _roll(self, n: int, attempt: _Attempt, wanted: Callable[[], bool]) -> Decoded | None:
        """Decode until frame n is identified; None if it was passed or nothing known came for too long."""
        strays = 0
        limit = len(self._media) if attempt.from_start else STRAYS + n - attempt.start
        while strays <= limit and wanted():
            frame = next(self._frames, None)
            if frame is None:
                self._at = None
                return None
            m = self._identify(frame)
            if m is None:
                if attempt.skip != "DEFAULT" and self._is_spoilt(frame, attempt):
                    self._at = None
                    return None
                strays += 1
                continue
            alone = self._at is not None and m != self._at + 1
            self._at = m
            assert self._layout is not None
            # Single frames far from n go back to the decoder: new memory costs more than they are worth.
            if not alone or m + WHOLE >= n:
                self.keep(m, frame, self._layout)
            if m == n:
                return frame, self._layout
            if m > n:
                return None
        return None

    def _identify(self, frame: av.VideoFrame) -> int | None:
        """The n of a decoded frame, by time stamp and checksum; the one that follows is looked at first."""
        self._layout = self._layout or layout_of(frame, self._stream.sample_aspect_ratio)
        if not same_size(frame, self._layout):
            return None
        pts, crc = frame_pts(frame), luma_crc(frame)
        after = 0 if self._at is None else self._at + 1
        if after < len(self._media) and (
            int(self._media.pts[after]) == pts and int(self._media.crc[after]) == crc
        ):
            return after
        low, high = np.searchsorted(self._sorted_pts, [pts, pts + 1])
        matches = [int(m) for m in self._by_pts[low:high] if self._media.crc[m] == crc]
        return min(matches, key=lambda m: (m < after, abs(m - after)), default=None)

    def _is_spoilt(self, frame: av.VideoFrame, attempt: _Attempt) -> bool:
        """Whether a frame that nothing was to be left out for is not what it was: no use in going on."""
        return int(self._media.pts[attempt.start]) <= frame_pts(frame) < self._whole_from
