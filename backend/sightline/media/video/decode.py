"""Opening and decoding a recording: whitelists, facts, and one sequential decode that skips damage."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import islice
from pathlib import Path

import av
from av.container import InputContainer
from av.video.stream import VideoStream

from sightline.errors import BadInput
from sightline.media.video.picture import Gray, Layout, layout_of, upright_gray
from sightline.media.video.sniff import played_in_parts, why_not_video
from sightline.messages.said import Said

#: What is said of a file that is no video, by what it is.
_PROBLEMS = defaultdict(
    lambda: "video-is-no-video",
    empty="video-is-empty",
    cut_before_index="video-is-cut-off",
    cut_in_index="video-is-cut-off",
)
FORMATS = "mov,mp4,m4a,3gp,3g2,mj2,matroska,webm,avi,mpegts,mpeg,h264,hevc"
MAX_SIDE_PX = 16_384
MAX_PIXELS = 100_000_000
MAX_ASPECT = 4
DECODER_THREADS = 4
NO_PTS = -(2**63)
_READ_FAILURES = 8
_LOOKED_AT = 1000  # packets of several pictures that are looked at to see which of them move


@dataclass(frozen=True)
class Picture:
    """One of a file's pictures; `still`: it does not move; `off`: the file switches it off."""

    codec: str | None
    width_px: int
    height_px: int
    still: bool
    off: bool

    def said(self, number: int) -> Said:
        """As "2 (h264, 640x480)"."""
        if self.codec is None:
            return Said("video-track-unknown", number=number)
        states = [name for name, holds in (("still", self.still), ("off", self.off)) if holds]
        return Said(
            "video-track",
            number=number,
            codec=self.codec,
            width_px=self.width_px,
            height_px=self.height_px,
            kind="_".join(states) or "moving",
        )


@dataclass(frozen=True, kw_only=True)
class VideoFacts(Layout):
    """What a container says of its picture; sizes are upright and in square pixels, counts are only claims.

    `stream`: the picture that was read, from 1, of those in the file; `pictures`: what they all are, in
    order, where there are several.
    `rotation_deg` is the clockwise turn applied to the decoded frame, `sample_aspect` the width of a
    coded pixel over its height. `rate_hz`, `duration_s` and `reported_frames` are the header's and None
    where it is silent.
    """

    container: str
    codec: str
    rate_hz: float | None
    time_base: Fraction
    reported_frames: int | None
    duration_s: float | None
    pixel_format: str
    full_range: bool
    interlaced: bool
    stream: int = 1
    pictures: tuple[Picture, ...] = ()

    @property
    def shown_upright(self) -> list[Said]:
        """What was done to the decoded picture to show it upright; empty if nothing."""
        done = []
        if self.sample_aspect != 1:
            done.append(Said("video-stretched", aspect=str(self.sample_aspect)))
        if self.rotation_deg:
            done.append(Said("video-turned", degrees=self.rotation_deg))
        if self.mirrored:
            done.append(Said("video-mirrored"))
        return done


@dataclass
class Damage:
    """What a sequential decode had to skip, and the byte it has come to; filled while it runs.

    `patched`: numbers of the frames that the decoder itself calls damaged and has filled up with guesses.
    """

    packets: int = 0
    reads: int = 0
    other_size: int = 0
    patched: list[int] = field(default_factory=list)
    position: int | None = None
    kinds: set[str] = field(default_factory=set)

    @property
    def any(self) -> bool:
        return bool(self.packets or self.reads or self.other_size or self.patched)


def open_container(path: Path, name: str | None = None) -> InputContainer:
    """Open a recording for reading, with format and protocol whitelists: a playlist is never followed.

    `name` is what people call the file (it is named so in errors). The caller closes what it gets.
    Raises BadInput with one sentence if this is no video that can be read.
    """
    name = name or path.name
    if not path.is_file():
        raise BadInput("video-not-a-file", name=name)
    if kind := why_not_video(path):
        raise BadInput(_PROBLEMS[kind], name=name, kind=kind)
    options = {"format_whitelist": FORMATS, "protocol_whitelist": "file", "max_pixels": str(MAX_PIXELS)}
    try:
        return av.open(f"file:{path}", options=options)
    except (av.error.FFmpegError, ValueError, UnicodeError) as error:
        raise BadInput("video-not-a-video", name=name) from error


def require_whole(path: Path, name: str, number: int | None = None) -> None:
    """Raise BadInput before times of a picture (`video_stream`) that an edit list makes of parts are read."""
    tracks = played_in_parts(path)
    if not tracks:
        return
    with closing(open_container(path, name)) as container:
        if video_stream(container, name, number=number).id in tracks:
            raise BadInput("video-in-parts", name=name)


def video_stream(
    container: InputContainer, name: str, threads: int = DECODER_THREADS, number: int | None = None
) -> VideoStream:
    """The stream that holds the picture, checked before anything is decoded: the `number`-th of the file's
    pictures, from 1, or else the first that moves and is not switched off (where all are off, the first that
    moves).

    How a decoder fills up damaged pictures depends on the race of its threads; with `threads` = 1 it is the
    same every time. Sound pictures never differ.

    Raises BadInput for sound without a picture, no, a still or a switched-off picture of that number, a codec
    nobody here can decode, and dimensions out of bounds.
    """
    moving = _moving(container)
    if not moving:
        raise BadInput("video-no-video-track", name=name)
    on = [one for one in moving if not _is_off(container, one)] or moving
    stream = on[0]
    if number is not None:
        every = container.streams.video
        if not 1 <= number <= len(every):
            raise BadInput("video-no-such-stream", name=name, number=number, count=len(every))
        stream = every[number - 1]
        if stream not in moving:
            raise BadInput("video-track-is-still", name=name, number=number)
        if stream not in on:
            raise BadInput("video-stream-is-off", name=name, number=number)
    context = stream.codec_context
    if context is None:
        raise BadInput("video-codec-unsupported", name=name)
    _check_size(name, context.width, context.height, stream.sample_aspect_ratio)
    context.thread_type = "AUTO"
    context.thread_count = threads
    context.options = {"max_pixels": str(MAX_PIXELS)}
    return stream


def _is_cover(stream: VideoStream) -> bool:
    """A cover picture in a sound file counts as a video stream in FFmpeg."""
    kinds = av.stream.Disposition
    return bool(stream.disposition & (kinds.attached_pic | kinds.timed_thumbnails | kinds.still_image))


def _moving(container: InputContainer) -> list[VideoStream]:
    """The file's pictures but for covers; of several, those of more than one frame, if any has.

    Some programs write a cover as an ordinary first stream. The packets are looked at in a second reader, so
    that this one stays where it is.
    """
    streams = [one for one in container.streams.video if not _is_cover(one)]
    if len(streams) < 2:
        return streams
    counts = dict.fromkeys((one.index for one in streams), 0)
    options = {"format_whitelist": FORMATS, "protocol_whitelist": "file", "max_pixels": str(MAX_PIXELS)}
    with suppress(av.error.FFmpegError), closing(av.open(container.name, options=options)) as again:
        wanted = [one for one in again.streams.video if one.index in counts]
        for packet in islice(again.demux(wanted), _LOOKED_AT):
            counts[packet.stream.index] += packet.size > 0
            if min(counts.values()) > 1:
                break
    return [one for one in streams if counts[one.index] > 1] or streams


def _is_off(container: InputContainer, stream: VideoStream) -> bool:
    """Whether an MP4 or QuickTime track is not enabled (FFmpeg tells that as its default); no other container
    that is read here switches tracks off.
    """
    return "mp4" in container.format.name and not stream.disposition & av.stream.Disposition.default


def picture_read(
    container: InputContainer, name: str, number: int | None = None
) -> tuple[int, tuple[Picture, ...]]:
    """The picture that `video_stream` takes, by number, and what all are, where the file has several."""
    stream = video_stream(container, name, number=number)
    return 1 + list(container.streams.video).index(stream), _pictures(container)


def _pictures(container: InputContainer) -> tuple[Picture, ...]:
    """What the file's pictures are, where there are several."""
    streams = container.streams.video
    if len(streams) < 2:
        return ()
    moving, pictures = _moving(container), []
    for stream in streams:
        context, moves = stream.codec_context, stream in moving
        size = (0, 0) if context is None else (context.width, context.height)
        name = None if context is None else context.name
        pictures.append(Picture(name, *size, still=not moves, off=moves and _is_off(container, stream)))
    return tuple(pictures)


def _check_size(name: str, width: int, height: int, aspect: Fraction | None) -> None:
    if width <= 0 or height <= 0:
        raise BadInput("video-size-missing", name=name)
    if width > MAX_SIDE_PX or height > MAX_SIDE_PX or width * height > MAX_PIXELS:
        raise BadInput(
            "video-size-too-large",
            name=name,
            width=width,
            height=height,
            max_side_px=MAX_SIDE_PX,
            max_pixels=MAX_PIXELS // 1000000,
        )
    if aspect and not Fraction(1, MAX_ASPECT) <= aspect <= MAX_ASPECT:
        raise BadInput("video-aspect-implausible", name=name, aspect=aspect)


def decode_frames(
    container: InputContainer,
    stream: VideoStream,
    damage: Damage | None = None,
    look: Callable[[av.Packet[VideoStream]], None] = lambda packet: None,
) -> Iterator[av.VideoFrame]:
    """Every frame from where the container stands, in the decoder's order; damaged packets are skipped
    and counted.

    `look` sees each packet before it is decoded. The end of a cut-off file is an end like any other. After a
    seek, call this again.
    """
    damage = damage if damage is not None else Damage()
    failures = 0
    while failures < _READ_FAILURES:
        try:
            for packet in container.demux(stream):
                failures = 0
                damage.position = packet.pos if packet.pos is not None else damage.position
                look(packet)
                yield from frames_of_packet(stream, packet, damage)
            return
        except av.error.FFmpegError as error:
            failures += 1
            damage.reads += 1
            damage.kinds.add(type(error).__name__)
    yield from frames_of_packet(stream, None, damage)


def frames_of_packet(
    stream: VideoStream, packet: av.Packet[VideoStream] | None, damage: Damage
) -> list[av.VideoFrame]:
    """The frames that come out of the decoder for one packet (None: the last ones); damage is counted."""
    try:
        return stream.codec_context.decode(packet)
    except EOFError:
        return []
    except (av.error.FFmpegError, MemoryError) as error:
        damage.packets += 1
        damage.kinds.add(type(error).__name__)
        return []


def frame_pts(frame: av.VideoFrame) -> int:
    """The frame's time stamp in the stream's time base: presentation, else decoding time, else `NO_PTS`."""
    if frame.pts is not None:
        return frame.pts
    return frame.dts if frame.dts is not None else NO_PTS


def same_size(frame: av.VideoFrame, layout: Layout) -> bool:
    """Whether a frame is of the recording's own size; those of another size do not count as its frames."""
    return frame.width == layout.coded_width_px and frame.height == layout.coded_height_px


def facts_of(container: InputContainer, stream: VideoStream, first: av.VideoFrame) -> VideoFacts:
    """The facts of an open stream and its first decoded frame."""
    layout = layout_of(first, stream.sample_aspect_ratio)
    rate = stream.average_rate
    return VideoFacts(
        **vars(layout),
        container=container.format.name,
        codec=stream.codec_context.name,
        rate_hz=float(rate) if rate else None,
        time_base=Fraction(stream.time_base or Fraction(1, 1)),
        reported_frames=stream.frames if stream.frames > 0 else None,
        duration_s=_duration_s(container, stream),
        pixel_format=first.format.name,
        full_range=int(first.color_range) == 2 or first.format.name.startswith("yuvj") or first.format.is_rgb,
        interlaced=bool(first.interlaced_frame),
    )


def _duration_s(container: InputContainer, stream: VideoStream) -> float | None:
    if stream.duration and stream.time_base and stream.duration > 0:
        return float(stream.duration * stream.time_base)
    if container.duration and container.duration > 0:
        return container.duration / av.time_base
    return None


def frames_of(
    path: Path, name: str | None = None, number: int | None = None
) -> Iterator[tuple[int, int, Gray]]:
    """Frame by frame (n, pts, gray) from the first to the last, upright, of the picture that `video_stream`
    takes; for command-line clips.

    Where the stream holds no time stamps, pts is n. Raises BadInput with one sentence that names
    the file for everything that is not a video: empty, text, sound alone, a still picture or a playlist under
    a video's name, cut off before its index, absurd dimensions.
    """
    name = name or path.name
    n = None
    with closing(open_container(path, name)) as container:
        for n, frame, layout in number_frames(container, video_stream(container, name, number=number), name):
            pts = frame_pts(frame)
            yield n, n if pts == NO_PTS else pts, upright_gray(frame, layout)
    if n is None:
        raise BadInput("video-no-frame", name=name)


def number_frames(
    container: InputContainer,
    stream: VideoStream,
    name: str,
    size_px: tuple[int, int] | None = None,
    look: Callable[[int | None], None] = lambda position: None,
    damage: Damage | None = None,
) -> Iterator[tuple[int, av.VideoFrame, Layout]]:
    """The frames by their numbers in the frame table, with their layout; one of another size than the first
    counts for none.

    `look` gets at every frame how many bytes of the file are read; `damage` is counted. Raises BadInput where
    the pictures are not of `size_px`, which a camera pose is for.
    """
    damage, layout, n = damage or Damage(), None, 0
    for frame in decode_frames(container, stream, damage):
        look(damage.position)
        if layout is None:
            layout = layout_of(frame, stream.sample_aspect_ratio)
            if size_px is not None and size_px != (layout.width_px, layout.height_px):
                raise BadInput(
                    "measurements-pose-image-size", name=name, size_px=size_px[0], size_px_2=size_px[1]
                )
        if not same_size(frame, layout):
            damage.other_size += 1
            continue
        yield n, frame, layout
        n += 1
