"""Mutated recordings, taken in and served: `python -m tests.media.fuzz FOLDER FIRST_SEED COUNT`, prints JSON.

Each file must be refused in one sentence or taken in; each frame asked for must be the one in the table or an
error. Anything else ends the program, as a crash of a decoder would.
"""

from __future__ import annotations

import json
import random
import sys
import time
from pathlib import Path

from sightline.errors import SightlineError
from sightline.media.video.frames import FrameServer
from sightline.media.video.ingest import ingest
from sightline.media.video.seeker import RecordingMedia
from tests.media.clips import X264_B, Spec, write

SPECS = (
    Spec("b.mp4", options=X264_B, b_frames=3),
    Spec("p.mkv"),
    Spec("j.avi", codec="mjpeg", pix_fmt="yuvj420p", options=()),
    Spec("m.avi", codec="mpeg4", options=(), b_frames=2),
    Spec("b.ts", options=X264_B, b_frames=3),
    Spec("r.h264", container="h264"),
    Spec("h.mkv", codec="libx265", options=(("preset", "ultrafast"), ("x265-params", "log-level=none"))),
)


def mutated(whole: bytes, rng: random.Random) -> bytes:
    """Flipped bytes anywhere or in the header, a piece lost, a piece written over another, or cut off."""
    data = bytearray(whole)
    kind = rng.randrange(5)
    if kind <= 1:
        reach = len(data) if kind == 0 else min(3000, len(data))
        for _ in range(rng.choice([1, 5, 50, 300])):
            data[rng.randrange(reach)] = rng.randrange(256)
    elif kind == 2:
        at = rng.randrange(len(data))
        del data[at : at + rng.randrange(1, 5000)]
    elif kind == 3:
        here, there = rng.randrange(len(data)), rng.randrange(len(data))
        data[here : here + 2000] = data[there : there + 2000]
    else:
        del data[rng.randrange(1, len(data)) :]
    return bytes(data)


def try_one(path: Path, folder: Path, rng: random.Random, tally: dict[str, float]) -> None:
    try:
        found = ingest(path, lambda _: None, lambda: False, folder / "thumbs", work_dir=folder / "work")
    except SightlineError as error:
        assert error.message.startswith(path.name) and error.message.endswith("."), error.message
        tally["refused"] += 1
        return
    tally["taken"] += 1
    media = RecordingMedia(found.media_path, found.frames.pts, found.frames.crc32, found.frames.key)
    server = FrameServer(folder / "cache", 1_000_000, 1_000_000)
    for n in rng.sample(range(len(media)), min(5, len(media))):
        try:
            server.still(media, n)
            tally["served"] += 1
        except SightlineError:
            tally["damaged"] += 1
    server.close()


def main(folder: Path, first: int, count: int) -> dict[str, float]:
    sources = [write(folder / spec.name, spec, 40).read_bytes() for spec in SPECS]
    tally: dict[str, float] = dict.fromkeys(("refused", "taken", "served", "damaged", "slowest_s"), 0)
    for seed in range(first, first + count):
        rng = random.Random(seed)
        kind = rng.randrange(len(SPECS))
        path = folder / f"{seed}_{SPECS[kind].name}"
        path.write_bytes(mutated(sources[kind], rng))
        start = time.monotonic()
        try_one(path, folder, rng, tally)
        tally["slowest_s"] = max(tally["slowest_s"], time.monotonic() - start)
        path.unlink()
    tally["memory_mb"] = peak_mb()
    return tally


def peak_mb() -> float:
    """Most memory this program ever held; getrusage tells that of the starting one where it is more."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return int(next(line for line in lines if line.startswith("VmHWM")).split()[1]) / 1000


if __name__ == "__main__":
    print(json.dumps(main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))))
