"""Working copies: the same packets in a container that can be addressed exactly.

Transport streams have no index and raw streams no time stamps; seeking in them gave wrong frames without
an error in every reader tried. Nothing is encoded anew, so the pictures are the original's bit for bit.
"""

from __future__ import annotations

import errno
import itertools
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import av
from av.container import InputContainer
from av.video.stream import VideoStream

from sightline.errors import BadInput, NoRoom
from sightline.media.atomic import atomic_file
from sightline.media.cancelling import Cancelled, check_cancelled
from sightline.media.store.local import check_room
from sightline.media.video.decode import Damage, frame_pts, frames_of_packet, open_container, video_stream

TICKS_HZ = 90_000
CLOCK_TICKS = 2**33  # an MPEG clock has 33 bits: at 90 kHz it begins again after 26.5 hours
_LONGEST_STEP = 2**31 - 1  # ticks between two samples that an MP4 reader understands: 6.6 hours
_NO_INDEX = {"mpegts", "mpeg", "h264", "hevc"}
#: the endings of working copies
COPY_SUFFIXES = (".mp4", ".mkv")
_IN_MP4 = {"h264", "hevc", "mpeg4", "mpeg1video", "mpeg2video"}
if TYPE_CHECKING:
    _VideoPacket: TypeAlias = av.Packet[VideoStream]


@dataclass(frozen=True)
class WorkingCopy:
    """Where the copy is, and whether its time stamps had to be made from an assumed rate."""

    path: Path
    assumed_rate_hz: float | None


@dataclass(frozen=True)
class _Read:
    """What is copied, what people call it, and which of its pictures."""

    path: Path
    name: str
    stream_number: int | None
    is_cancelled: Cancelled


def needs_copy(container_name: str) -> bool:
    """Whether files of this container are addressed through a working copy."""
    return container_name in _NO_INDEX


def make_copy(
    path: Path,
    folder: Path,
    name: str,
    is_cancelled: Cancelled,
    *,
    keep_times: bool,
    stream_number: int | None = None,
) -> WorkingCopy:
    """Write the working copy of `path` into `folder`, of the one picture that `video_stream` takes; whole
    or not at all.

    With `keep_times`, time stamps are taken over where they are complete and in order; otherwise they
    are made from the frame rate of the header and the order in which a decoder shows the packets. Raises
    BadInput.
    """
    folder.mkdir(parents=True, exist_ok=True)
    check_room(folder, path.stat().st_size)
    read = _Read(path, name, stream_number, is_cancelled)
    if keep_times and (copy := _try_with_times(read, folder)):
        return copy
    order, rate = _display_order(read)
    ranks = _ranks(order)
    delay = max((i - rank for i, rank in enumerate(ranks)), default=0)

    def number(i: int, packet: _VideoPacket) -> bool | None:
        packet.pts, packet.dts, packet.duration = ranks[i] + delay, i, 1
        packet.time_base = 1 / rate
        return True

    try:
        return WorkingCopy(_write(read, folder, number), float(rate))
    except (av.error.FFmpegError, ValueError) as error:
        if isinstance(error, OSError) and error.errno == errno.ENOSPC:
            raise NoRoom("video-disk-full", name=name) from error
        raise BadInput("video-not-addressable", name=name) from error


def _try_with_times(read: _Read, folder: Path) -> WorkingCopy | None:
    last_dts: int | None = None
    turn = 0

    def check(_: int, packet: _VideoPacket) -> bool | None:
        nonlocal last_dts, turn
        if packet.pts is None or packet.dts is None:
            # A trimmed stream may begin within a picture, whose time went with its beginning.
            return None if last_dts is None and not packet.is_keyframe else False
        if last_dts is None and min(packet.pts, packet.dts) < 0:
            turn = CLOCK_TICKS  # the reader counts down to 0 what comes before the clock's end
        elif last_dts is not None and packet.dts + turn < last_dts - CLOCK_TICKS // 2:
            turn += CLOCK_TICKS
        packet.pts, packet.dts = packet.pts + turn, packet.dts + turn
        if last_dts is not None and not 0 < packet.dts - last_dts <= _LONGEST_STEP:
            return False
        last_dts = packet.dts
        return True

    try:
        return WorkingCopy(_write(read, folder, check), None)
    except (av.error.FFmpegError, ValueError):
        return None


def _write(read: _Read, folder: Path, prepare: Callable[[int, _VideoPacket], bool | None]) -> Path:
    """Copy packets, but those to which `prepare` says None; ValueError if it says no to one."""
    with closing(open_container(read.path, read.name)) as source:
        stream = video_stream(source, read.name, number=read.stream_number)
        suffix = ".mp4" if stream.codec_context.name in _IN_MP4 else ".mkv"
        target = folder / f"{read.path.stem}.work{suffix}"
        with (
            atomic_file(target) as part,
            closing(av.open(str(part), "w", format="mp4" if suffix == ".mp4" else "matroska")) as container,
        ):
            out = container.add_stream_from_template(stream)
            out.time_base = Fraction(1, TICKS_HZ)
            for i, packet in enumerate(_packets(source, stream)):
                check_cancelled(read.is_cancelled, read.name)
                wanted = prepare(i, packet)
                if wanted is None:
                    continue
                if not wanted:
                    raise ValueError("time stamps are not in order")
                packet.stream = out
                container.mux(packet)
    return target


def _packets(source: InputContainer, stream: VideoStream) -> Iterator[_VideoPacket]:
    """The stream's packets up to where the file ends or can no longer be read."""
    with suppress(av.error.FFmpegError):
        for packet in source.demux(stream):
            if packet.size:
                yield packet


def _display_order(read: _Read) -> tuple[list[int | None], Fraction]:
    """For each packet the place of its frame in the decoder's order (None: no frame), and the rate in Hz.

    Each packet carries its own number through the decoder as its time stamp; the decoder hands it on
    with the frame, so the order is the decoder's own and not an estimate.
    """
    with closing(open_container(read.path, read.name)) as source:
        stream = video_stream(source, read.name, number=read.stream_number)
        rate = Fraction(stream.average_rate or stream.guessed_rate or 25)
        order: list[int | None] = []
        shown = 0
        for packet in itertools.chain(_packets(source, stream), [None]):
            if packet is not None:
                packet.pts, packet.dts = len(order), None
                order.append(None)
            for frame in frames_of_packet(stream, packet, Damage()):
                index = frame_pts(frame)
                if 0 <= index < len(order):
                    order[index] = shown
                    shown += 1
            check_cancelled(read.is_cancelled, read.name)
    return order, rate


def _ranks(order: list[int | None]) -> list[int]:
    """A place for every packet: those without a frame come right after the packet before them.

    In a stream that reorders, those right behind the first frame's are its leading pictures, which refer to
    one that was cut away: they come before it, or it would be shown too early by as many frames.
    """
    shown = [place for place in order if place is not None]
    first = next((i for i, place in enumerate(order) if place is not None), 0)
    second = next((i for i, place in enumerate(order) if place is not None and i > first), 0)
    leading = range(first + 1, second) if shown != sorted(shown) else range(0)
    places: list[tuple[int, int]] = []
    last = -1
    for i, place in enumerate(order):
        last = place if place is not None else last
        places.append((-1 if i in leading else last, 0 if place is not None else i + 1))
    ranks = [0] * len(order)
    for rank, i in enumerate(sorted(range(len(order)), key=lambda j: places[j])):
        ranks[i] = rank
    return ranks
