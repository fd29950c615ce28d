"""How fast frames come out: `python tests/bench/bench_media.py [seconds of video] [--ten-minutes]`, medians.

Our server beside OpenCV's set(POS_FRAMES) and a bare PyAV seek in the same run; on a busy machine trust the
ratios, not the milliseconds. Clips are rendered first, with a key frame every 250 frames unless said. Steps
are measured at an operator's speed, with time in between in which the server works ahead, and as fast as
they come. With `--ten-minutes` a ten-minute recording in 1080p is ingested too, beside a plain decode of it.
"""

from __future__ import annotations

import random
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from pathlib import Path

import av
import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.media.video.decode_host import DecodeHost
from sightline.media.video.frames import FrameServer
from sightline.media.video.ingest import ingest
from sightline.media.video.picture import luma_crc
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.writer import write_mp4

SIZES = ((640, 480), (1920, 1080), (3840, 2160))
RATE = 25
GOP = 250
STEPS_HZ = 8
PACES = ((f"{STEPS_HZ} a second", STEPS_HZ), ("as fast as they come", 0))
TEN_MINUTES_S = 600
Draw = Callable[[int, int, int], Iterator[NDArray[np.uint8]]]


def standing(count: int, width: int, height: int) -> Iterator[NDArray[np.uint8]]:
    """A camera that stands: a still, textured road under sensor noise of 3.5 DN, and a box that drives by."""
    rng = np.random.default_rng(1)
    base = cv2.resize(rng.integers(60, 190, (height // 8, width // 8, 3), np.uint8), (width, height))
    noise = rng.normal(0, 3.5, (height + 64, width + 64, 1)).astype(np.int16)
    box = (slice(height // 3, 2 * height // 3), slice(0, width // 4))
    for n in range(count):
        y, x = rng.integers(0, 64, 2)
        picture = base + noise[y : y + height, x : x + width]
        x = (n * width // 50) % (width * 3 // 4)
        picture[box[0], x : x + width // 4] = base[box]
        yield np.clip(picture, 0, 255).astype(np.uint8)


def scene(count: int, width: int, height: int) -> Iterator[NDArray[np.uint8]]:
    """A textured, noisy road that moves as a whole: harder to code than what a standing camera sees."""
    rng = np.random.default_rng(1)
    base = cv2.resize(rng.integers(60, 190, (height // 8, width // 4, 3), np.uint8), (width * 2, height))
    noise = rng.integers(0, 40, (height + 64, width + 64, 3), np.uint8)
    for n in range(count):
        shift = (3 * n) % width
        y, x = (17 * n) % 61, (29 * n) % 59
        yield cv2.add(base[:, shift : shift + width], noise[y : y + height, x : x + width])


def median_ms(action: Callable[[int], object], numbers: Sequence[int], steps_hz: float = 0) -> float:
    """Median wall time of one call, in ms; `steps_hz` calls a second, or one right after the other."""
    times = []
    begun = time.perf_counter()
    for k, n in enumerate(numbers):
        if steps_hz:
            time.sleep(max(0.0, begun + (k + 1) / steps_hz - time.perf_counter()))
        start = time.perf_counter()
        action(n)
        times.append(1000 * (time.perf_counter() - start))
    return statistics.median(times)


def measured(action: Callable[[], object]) -> tuple[float, float]:
    """Wall and processor time in s, the better of two runs each."""
    runs = []
    for _ in range(2):
        wall, processor = time.perf_counter(), time.process_time()
        action()
        runs.append((time.perf_counter() - wall, time.process_time() - processor))
    return min(w for w, _ in runs), min(p for _, p in runs)


def plain_decode(path: Path) -> int:
    """Nothing but decoding, with as many threads as ingest uses."""
    with closing(av.open(str(path))) as container:
        stream = container.streams.video[0]
        stream.codec_context.thread_type = "AUTO"
        stream.codec_context.thread_count = 4
        return sum(1 for _ in container.decode(stream))


def bare_seek(path: Path, media: RecordingMedia) -> Callable[[int], object]:
    """The least that PyAV needs to show frame n, checked by its checksum, without any window or cache."""
    container = av.open(str(path))
    stream = container.streams.video[0]
    stream.codec_context.thread_type = "AUTO"

    def show(n: int) -> object:
        container.seek(int(media.pts[n]), stream=stream)
        for frame in container.decode(stream):
            if frame.pts == media.pts[n]:
                assert luma_crc(frame) == media.crc[n]
                return frame.to_ndarray(format="bgr24")
        raise AssertionError(n)

    return show


def opencv_seek(path: Path) -> Callable[[int], object]:
    reader = cv2.VideoCapture(str(path))

    def show(n: int) -> object:
        reader.set(cv2.CAP_PROP_POS_FRAMES, n)
        return reader.read()

    return show


def bench(what: str, draw: Draw, width: int, height: int, duration_s: int, folder: Path) -> None:
    path = folder / f"{what}-{width}x{height}.mp4"
    write_mp4(path, draw(duration_s * RATE, width, height), RATE, crf=23, gop=GOP)
    found = ingest(path, lambda _: None, lambda: False, folder / "thumbs")
    plain = measured(lambda: plain_decode(path))
    ours = measured(lambda: ingest(path, lambda _: None, lambda: False, folder / "thumbs"))
    count = len(found.frames)
    rate_mbps = 8e-6 * path.stat().st_size * RATE / count
    print(f"{what}, {width}x{height}, {count} frames, key every {GOP}, {rate_mbps:.1f} Mb/s")
    for clock, mine, theirs in (("wall", ours[0], plain[0]), ("processor", ours[1], plain[1])):
        print(f"  ingest {mine:.2f} s {clock}, plain decode {theirs:.2f} s, ratio {mine / theirs:.2f}")
    show_table(RecordingMedia(path, found.frames.pts, found.frames.crc32, found.frames.key), folder)


def show_table(media: RecordingMedia, folder: Path) -> None:
    """Stills of the frame server, decoded in a child as in the server, beside two readers without a cache."""
    count = len(media)
    jumps = random.Random(3).sample(range(count), 5)
    on = list(range(count // 2, count // 2 + 15))
    back = on[-2:2:-1]
    pyav, opencv = bare_seek(media.path, media), opencv_seek(media.path)
    theirs = median_ms(opencv, on[:2]), median_ms(pyav, on[:2])
    print(f"  {'ms':<40} {'Sightline':>10} {'OpenCV':>10} {'bare PyAV':>10}   goal")
    for how, hz in PACES:
        print_row(f"next frame, {how}", "50", steps_on(media, folder, on, hz), *theirs)
    theirs = median_ms(opencv, back[:2]), median_ms(pyav, back[:2])
    for how, hz in PACES:
        print_row(f"back step in the window, {how}", "10", steps_back(media, folder, back, hz), *theirs)
    print_row(
        "cold jump, decoder closed",
        "300 at 1080p",
        median_ms(cold_jump(media, folder), jumps),
        median_ms(lambda n: opencv_seek(media.path)(n), jumps),
        median_ms(lambda n: bare_seek(media.path, media)(n), jumps),
    )


def steps_on(media: RecordingMedia, folder: Path, numbers: Sequence[int], hz: float) -> float:
    """Median ms of steps on after a jump."""
    with closing(served(folder / f"{media.path.stem}-on-{hz}")) as server:
        server.still(media, numbers[0] - 1)
        return median_ms(lambda n: server.still(media, n), numbers, hz)


def steps_back(media: RecordingMedia, folder: Path, numbers: Sequence[int], hz: float) -> float:
    """Median ms of steps back through frames that are decoded already and of which no still was ever made."""
    with closing(served(folder / f"{media.path.stem}-back-{hz}")) as server:
        for n in reversed(numbers):
            server.gray(media, n)
        server.still(media, numbers[0] + 1)
        return median_ms(lambda n: server.still(media, n), numbers, hz)


def served(cache: Path) -> FrameServer:
    """As the server has it: decoding in a child that has started."""
    made = FrameServer(cache, 256_000_000, 512_000_000, pictures=DecodeHost(192_000_000))
    made.start()
    return made


def cold_jump(media: RecordingMedia, folder: Path) -> Callable[[int], object]:
    """A recording that no decoder has open, in a server that runs: under another name each time."""
    server = served(folder / f"{media.path.stem}-jumps")
    other = RecordingMedia(media.path, media.pts[:2], media.crc[:2], media.key[:2])
    server.gray(other, 0)

    def jump(n: int) -> object:
        link = media.path.with_name(f"{n}-{media.path.name}")
        link.hardlink_to(media.path)
        return server.still(RecordingMedia(link, media.pts, media.crc, media.key), n)

    return jump


def print_row(what: str, goal: str, ours: float, opencv: float, pyav: float) -> None:
    print(f"  {what:<40} {ours:10.1f} {opencv:10.1f} {pyav:10.1f}   {goal}")


def repeated(source: Path, target: Path, duration_s: int) -> Path:
    """The recording again and again until it lasts so long; nothing is encoded anew."""
    with closing(av.open(str(target), "w")) as out:
        copy = None
        shift = 0
        while copy is None or shift * copy.time_base < duration_s:
            with closing(av.open(str(source))) as read:
                stream = read.streams.video[0]
                copy = copy or out.add_stream_from_template(stream)
                for packet in read.demux(stream):
                    if packet.dts is None:
                        continue
                    packet.pts += shift
                    packet.dts += shift
                    packet.stream = copy
                    out.mux(packet)
                shift += int(stream.duration)
    return target


def ten_minutes(folder: Path) -> None:
    """Ingest beside the mean of a plain decode before and one after it."""
    short = folder / "short.mp4"
    write_mp4(short, scene(12 * RATE, 1920, 1080), RATE, crf=23, gop=GOP)
    path = repeated(short, folder / "long.mp4", TEN_MINUTES_S)
    walls = []
    for action in (plain_decode, take_in, plain_decode):
        begun = time.perf_counter()
        count = action(path)
        walls.append(time.perf_counter() - begun)
    plain = (walls[0] + walls[2]) / 2
    print(f"1920x1080, ten minutes, {count} frames, {path.stat().st_size / 1e6:.0f} MB")
    print(f"  ingest {walls[1]:.0f} s, plain decode {plain:.0f} s, ratio {walls[1] / plain:.2f}   goal 1.2")


def take_in(path: Path) -> int:
    found = ingest(path, lambda _: None, lambda: False, path.with_name("thumbs"))
    assert len(found.frames) >= TEN_MINUTES_S * RATE
    return len(found.frames)


def main(wanted: list[str]) -> None:
    """Render, measure, print."""
    seconds = [int(one) for one in wanted if one.isdigit()]
    duration_s = seconds[0] if seconds else 10
    with tempfile.TemporaryDirectory() as folder:
        if "--ten-minutes" in wanted:
            ten_minutes(Path(folder))
        for what, draw in (("camera stands", standing), ("all of it moves", scene)):
            for width, height in SIZES:
                bench(what, draw, width, height, max(2, duration_s * 1080 // max(1080, height)), Path(folder))


if __name__ == "__main__":
    main(sys.argv[1:])
