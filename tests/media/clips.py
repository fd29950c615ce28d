"""Synthetic clips whose every frame carries its number in black and white bars, as recorders write them."""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import av
import cv2
import numpy as np
from numpy.typing import NDArray

BITS = 12
#: Most claims do not depend on the size of the picture, and this one is coded in a third of the time.
SMALL, QVGA = (192, 144), (320, 240)
TICKS = Fraction(1, 90_000)


def painted(n: int, width: int = 320, height: int = 240) -> NDArray[np.uint8]:
    """A moving, textured picture with the number n in two rows of bars (the second one inverted)."""
    x, y = np.arange(width), np.arange(height)[:, None]
    gray = (110 + 40 * np.sin((x + 3 * n) / 17.0) + 30 * np.cos((y - 2 * n) / 23.0)).astype(np.uint8)
    image = np.repeat(gray[:, :, None], 3, axis=2)
    image[..., 2] = np.minimum(gray.astype(np.int16) + (n * 7) % 40, 255)
    cell, bar = width // BITS, height // 8
    for bit in range(BITS):
        value = 235 if n >> bit & 1 else 20
        image[0:bar, bit * cell : (bit + 1) * cell] = value
        image[bar : 2 * bar, bit * cell : (bit + 1) * cell] = 255 - value
    return image


def read_number(image: NDArray[np.uint8]) -> int:
    """The number painted into an upright BGR or luminance picture; fails if the bars contradict."""
    gray = image if image.ndim == 2 else cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    height, width = gray.shape
    cell, bar = width / BITS, height / 8
    n = 0
    for bit in range(BITS):
        x = slice(int((bit + 0.3) * cell), int((bit + 0.7) * cell))
        first = float(gray[int(0.3 * bar) : int(0.7 * bar), x].mean())
        second = float(gray[int(1.3 * bar) : int(1.7 * bar), x].mean())
        assert abs(first - second) > 80, f"bars cannot be read: {first:.0f} against {second:.0f} in bit {bit}"
        n |= (first > second) << bit
    return n


@dataclass(frozen=True)
class Spec:
    """How to write a clip; `pts_of` gives the time stamp of frame n in 1/90000 s."""

    name: str
    codec: str = "libx264"
    pix_fmt: str = "yuv420p"
    options: tuple[tuple[str, str], ...] = (("preset", "superfast"),)
    gop: int = 24
    b_frames: int = 0
    rate: Fraction = Fraction(25)
    pts_of: Callable[[int], int] | None = None
    container: str | None = None
    aspect: Fraction | None = None
    rotation: int = 0
    size: tuple[int, int] = SMALL
    count: int = 80
    muxer: tuple[tuple[str, str], ...] = ()


def write(path: Path, spec: Spec, count: int | None = None) -> Path:
    """Encode `count` painted frames (by default as many as the spec says)."""
    with closing(av.open(str(path), "w", format=spec.container, options=dict(spec.muxer))) as out:
        stream = out.add_stream(spec.codec, rate=spec.rate)
        stream.width, stream.height = spec.size
        stream.pix_fmt = spec.pix_fmt
        stream.gop_size = spec.gop
        stream.max_b_frames = spec.b_frames
        stream.options = dict(spec.options)
        stream.codec_context.thread_count = THREADS
        if spec.aspect:
            stream.codec_context.sample_aspect_ratio = spec.aspect
        if spec.rotation:
            stream.set_display_rotation(spec.rotation)
        if spec.pts_of:
            stream.codec_context.time_base = TICKS
            stream.time_base = TICKS
        for n in range(spec.count if count is None else count):
            frame = av.VideoFrame.from_ndarray(painted(n, *spec.size), format="bgr24")
            frame.pts = spec.pts_of(n) if spec.pts_of else n
            frame.time_base = TICKS if spec.pts_of else 1 / spec.rate
            out.mux(stream.encode(frame))
        out.mux(stream.encode(None))
    return path


def tagged(path: Path, tags: dict[str, str], rate: int = 30) -> Path:
    """Forty small frames in a file that carries these tags."""
    with closing(av.open(str(path), "w", options={"movflags": "use_metadata_tags"})) as out:
        stream = out.add_stream("libx264", rate=rate)
        stream.width, stream.height, stream.pix_fmt = 320, 240, "yuv420p"
        stream.options = {"preset": "superfast"}
        stream.codec_context.thread_count = THREADS
        out.metadata.update(tags)
        for n in range(40):
            out.mux(stream.encode(av.VideoFrame.from_ndarray(painted(n), format="bgr24")))
        out.mux(stream.encode(None))
    return path


def short_clip(path: Path, of_file: dict[str, str], of_stream: dict[str, str]) -> Path:
    """Four frames in a container that states this."""
    options = {"movflags": "use_metadata_tags"}
    with av.open(str(path), "w", options=options) as out:
        stream = out.add_stream("libx264", rate=25)
        stream.width, stream.height, stream.pix_fmt = 320, 240, "yuv420p"
        out.metadata.update(of_file)
        stream.metadata.update(of_stream)
        for n in range(4):
            out.mux(stream.encode(av.VideoFrame.from_ndarray(painted(n), format="bgr24")))
        out.mux(stream.encode(None))
    return path


def uneven(n: int) -> int:
    """Time stamps of a telephone: 20 to 60 ms apart, in order."""
    return sum(1800 + (k * 7919) % 3600 for k in range(n))


def cut_copy(source: Path, target: Path, from_s: float) -> Path:
    """The file from `from_s` on without encoding: the muxer hides the frames before it with an edit list."""
    with closing(av.open(str(source))) as read, closing(av.open(str(target), "w")) as out:
        stream = read.streams.video[0]
        copy = out.add_stream_from_template(stream)
        shift = round(from_s / stream.time_base)
        read.seek(shift, stream=stream)
        for packet in read.demux(stream):
            if packet.dts is None:
                continue
            packet.pts -= shift
            packet.dts -= shift
            packet.stream = copy
            out.mux(packet)
    return target


def _boxed(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I4s", 8 + len(content), kind) + content


def _boxes(content: bytes) -> list[tuple[bytes, bytes]]:
    """Kind and content of the boxes in a piece of an MP4 file."""
    found, at = [], 0
    while at < len(content):
        size, kind = struct.unpack_from(">I4s", content, at)
        found.append((kind, content[at + 8 : at + size]))
        at += size
    return found


def edited(
    source: Path, target: Path, edits: Sequence[tuple[float, float | None]], track: int | None = None
) -> Path:
    """An MP4 file with another edit list: how many seconds each edit lasts, and from what second of the
    picture on it plays (None: it is empty). track: of that one alone, from 1.
    """
    every = _boxes(source.read_bytes())
    assert every[-1][0] == b"moov", "so that no picture is moved"
    inside = _boxes(every[-1][1])
    movie_hz = struct.unpack_from(">I", dict(inside)[b"mvhd"], 12)[0]
    out, nth = b"", 0
    for kind, content in inside:
        nth += kind == b"trak"
        if kind == b"trak" and track in (None, nth):
            parts = [one for one in _boxes(content) if one[0] != b"edts"]
            own_hz = struct.unpack_from(">I", dict(_boxes(dict(parts)[b"mdia"]))[b"mdhd"], 12)[0]
            rows = [
                struct.pack(">IiI", round(last * movie_hz), -1 if at is None else round(at * own_hz), 1 << 16)
                for last, at in edits
            ]
            listed = _boxed(b"elst", struct.pack(">II", 0, len(rows)) + b"".join(rows))
            parts.insert(1, (b"edts", listed))
            content = b"".join(_boxed(*one) for one in parts)
        out += _boxed(kind, content)
    target.write_bytes(b"".join(_boxed(*one) for one in [*every[:-1], (b"moov", out)]))
    return target


# What an encoder writes depends on how many threads it has, which it takes from the processors otherwise.
THREADS = 2
X264_B = (("preset", "superfast"), ("x264-params", "keyint=24:min-keyint=24:scenecut=0:bframes=3:b-adapt=0"))
X264_OPEN = (
    ("preset", "superfast"),
    ("x264-params", "keyint=24:min-keyint=24:scenecut=0:bframes=3:b-adapt=0:open-gop=1"),
)
SPECS = (
    Spec("cfr.mp4"),
    Spec("bframes.mp4", options=X264_B, b_frames=3),
    Spec("vfr.mp4", pts_of=uneven, options=X264_B, b_frames=3),
    Spec("vfr.mkv", pts_of=uneven, options=X264_B, b_frames=3),
    Spec("one_key.mp4", gop=250),
    Spec("every_key.mp4", gop=1),
    Spec("ntsc.mov", rate=Fraction(30_000, 1001), options=X264_B, b_frames=3),
    Spec("open_gop.mp4", options=X264_OPEN, b_frames=3),
    Spec("open_gop.mkv", options=X264_OPEN, b_frames=3),
    Spec("open_gop.ts", options=X264_OPEN, b_frames=3),
    Spec("bframes.ts", options=X264_B, b_frames=3),
    Spec("bframes.h264", options=X264_B, b_frames=3, container="h264"),
    Spec("plain.h264", container="h264"),
    Spec("mjpeg.avi", codec="mjpeg", pix_fmt="yuvj420p", options=()),
    Spec("mpeg4.avi", codec="mpeg4", options=(("qscale", "3"),)),
    Spec("mpeg4_b.avi", codec="mpeg4", options=(), b_frames=2),
    Spec("mpeg4_b.mp4", codec="mpeg4", options=(), b_frames=2),
    Spec("h264_b.avi", options=X264_B, b_frames=3),
    Spec("hevc.mp4", codec="libx265", options=(("preset", "ultrafast"), ("x265-params", "log-level=none"))),
    Spec(
        "hevc.mkv",
        codec="libx265",
        options=(("preset", "ultrafast"), ("x265-params", "log-level=none")),
        b_frames=3,
    ),
    Spec(
        "hevc.ts",
        codec="libx265",
        options=(("preset", "ultrafast"), ("x265-params", "log-level=none:keyint=20")),
    ),
    Spec("ten_bit.mkv", pix_fmt="yuv420p10le", options=X264_B, b_frames=3),
    Spec("full_range.mp4", pix_fmt="yuvj420p"),
    Spec("cinepak.avi", codec="cinepak", pix_fmt="rgb24", options=(), size=(144, 96), count=12),
    Spec("lossless.mkv", codec="ffv1", pix_fmt="yuv420p", options=()),
    Spec("mpeg2.mpg", codec="mpeg2video", options=(), b_frames=2, container="mpeg"),
    Spec("wide_pixels.mp4", aspect=Fraction(4, 3), size=QVGA),
    Spec("tall_pixels.mkv", aspect=Fraction(8, 9), size=(360, 288)),
    Spec("turned90.mp4", rotation=90),
    Spec("turned180.mov", rotation=180),
    Spec("turned270.mp4", rotation=-90, aspect=Fraction(4, 3)),
    Spec("fragmented.mp4", muxer=(("movflags", "frag_keyframe+empty_moov"),), options=X264_B, b_frames=3),
)
