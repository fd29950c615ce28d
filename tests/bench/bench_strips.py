"""Line-scan strips end to end: `python tests/bench/bench_strips.py [seconds of road]`.

Traffic of about 60 vehicles a minute at 1024 rows is made first (20 s of it by default, which takes a
minute), and once more eleven times as long, over a million lines. The command line runs in
processes of its own, held to one processor; processor time counts, wall time stands beside it, for other
programs share the machine.
"""

from __future__ import annotations

import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path

import cv2
import numpy as np
import tifffile

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from sightline.media.strips.reader import open_strip  # noqa: E402
from sightline.media.strips.stored_reader import StripReader  # noqa: E402
from sightline.media.strips.stored_writer import store_strip  # noqa: E402
from tests.bench.goals import Row, report, row  # noqa: E402
from tests.media.scans import Fed, stored_pair  # noqa: E402
from tests.simulation.scan_traffic import ScanSite, ScanVehicle, traffic  # noqa: E402

ROWS = 1024
TIMES = 11
REAL_TIME_HZ = 4882.8
FOLDER = Path(tempfile.mkdtemp(prefix="bench-strips-"))
# the kernel's own peak of the command's memory alone: what wait4 says starts from this process's
RUNNER = """
import os, sys
os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])
from sightline.cli import main
status = main(sys.argv[1:])
about = dict(line.split(":", 1) for line in open("/proc/self/status"))
print(about["VmHWM"].split()[0], file=sys.stderr)
sys.exit(status)
"""
SECONDS = float(sys.argv[1]) if len(sys.argv) > 1 else 20.0


def busy_road(site: ScanSite) -> tuple[ScanVehicle, ...]:
    """One vehicle a second, all clear of both ends, so that the recording can be repeated."""
    many = traffic(3, int(2 * SECONDS), speeds_mps=(10.0, 30.0), gaps_s=(0.45, 0.75))
    return tuple(car for car in many if car.clear_s(site.baseline_m) < SECONDS - 0.3)


@cache
def short() -> tuple[Path, Path, int]:
    """The pair of strips, and how many vehicles are in it."""
    site = ScanSite(rows=ROWS, drift_period_s=SECONDS)
    cars = busy_road(site)
    one, two = stored_pair(FOLDER / "short", site, cars, SECONDS)
    return one.path, two.path, len(cars)


@cache
def long() -> tuple[Path, Path]:
    """The same road TIMES over."""
    made = []
    for path in short()[:2]:
        reader = StripReader(path)
        strip = Fed(path.stem, reader.lines, ROWS, partial(reader.chunks, 1024), TIMES)
        made.append(store_strip(strip, FOLDER / "long" / path.name).path)
    return made[0], made[1]


def run(first: Path, second: Path, method: str) -> tuple[dict, float, float, float]:
    """One run of the command: what it says, wall and processor time in s, peak memory in MiB."""
    arguments = ["linescan", str(first), str(second), "--time-axis", "height", "--baseline", "0.593"]
    arguments += ["--line-rate", str(REAL_TIME_HZ), "--method", method, "--json"]
    out, peak = FOLDER / "said.json", FOLDER / "peak.txt"
    start = time.perf_counter()
    with out.open("w") as said, peak.open("w") as told:
        process = subprocess.Popen(
            [sys.executable, "-c", RUNNER, *arguments], stdout=said, stderr=told, cwd=ROOT
        )
        _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0, peak.read_text()
    wall = time.perf_counter() - start
    return json.loads(out.read_text()), wall, used.ru_utime + used.ru_stime, float(peak.read_text()) / 1024


def end_to_end() -> Iterator[Row]:
    first, second, cars = short()
    first_long, second_long = long()
    peaks = {}
    for method in ("direct", "paper"):
        _, _, cpu_1, peaks[method, 1] = run(first, second, method)
        said, wall, cpu, peaks[method, TIMES] = run(first_long, second_long, method)
        road_s = said["lines"] / REAL_TIME_HZ
        found = len(said["vehicles"])
        measured = sum(one["status"] == "ok" for one in said["vehicles"])
        name = f"linescan --method {method}, {ROWS} rows, {60 * cars / SECONDS:.0f} vehicles/min"
        share = 2 * said["lines"] / cpu / 1e3
        yield row(
            f"{name}: x real time of 2 x 4,883 lines/s",
            ">= 15" if method == "direct" else "-",
            f"{road_s / cpu:.1f} ({share:.0f} klines/s; wall {road_s / wall:.1f}; start included)",
            method == "paper" or road_s / cpu >= 15,
        )
        rest = (said["lines"] * (1 - 1 / TIMES)) / REAL_TIME_HZ / (cpu - cpu_1)
        yield row(f"{name}: without starting", "-", f"{rest:.1f} x real time", True)
        readers = [StripReader(path) for path in (first_long, second_long)]
        _, reading_ms, _ = timed(lambda some=readers: [len(c) for one in some for c in one.chunks()], 1)
        speed = 2 * said["lines"] * ROWS / reading_ms / 1e3
        share = reading_ms / 10 / cpu
        yield row(
            f"{name}: of it, reading", "-", f"{share:.0f} % ({speed:.0f} MB/s, an idle core: 900)", True
        )
        yield row(
            f"{name}: found, measured, of",
            "all",
            f"{found}, {measured}, {cars * TIMES}",
            found == cars * TIMES,
        )
    for method in ("direct", "paper"):
        one, many = peaks[method, 1], peaks[method, TIMES]
        goal = f"peak memory, {method}, {SECONDS:.0f} s and {TIMES} times that"
        yield row(
            goal, "<= 300 MiB, <= 1.1 x", f"{one:.0f}, {many:.0f} MiB", many <= 300 and many <= 1.1 * one
        )


def timed(action: Callable[[], object], repeats: int) -> tuple[float, float, float]:
    """Median wall, median and largest processor time of one call, ms."""
    walls, cpus = [], []
    for _ in range(repeats):
        wall, cpu = time.perf_counter(), time.process_time()
        action()
        walls.append(1000 * (time.perf_counter() - wall))
        cpus.append(1000 * (time.process_time() - cpu))
    return statistics.median(walls), statistics.median(cpus), max(cpus)


def pictures() -> Iterator[Row]:
    path = long()[0]
    reader = StripReader(path)
    rng = np.random.default_rng(1)
    wall, cpu, most = timed(lambda: StripReader(path).tile(len(reader.levels) - 1, 0), 5)
    lines = f"{reader.lines / 1e6:.2f} million lines"
    yield row(f"first picture of {lines}", "<= 1000 ms", f"{cpu:.1f} ms (wall {wall:.1f})", wall <= 1000)
    for level, count in enumerate(reader.levels):
        tiles = -(-count // 1024)

        def show(level: int = level, tiles: int = tiles) -> None:
            reader.tile(level, int(rng.integers(tiles)))

        wall, cpu, most = timed(show, 25)
        reached = f"{cpu:.1f} ms (largest {most:.1f}, wall {wall:.1f})"
        yield row(f"tile of 1024 x {ROWS}, 1/{4**level}", "<= 15 ms", reached, cpu <= 15)


def speeds() -> Iterator[Row]:
    """Lines a second of one camera; its real time is 4.9 klines/s."""
    reader = StripReader(short()[0])
    pixels = reader.read(0, min(reader.lines, 50_000))
    upright = np.ascontiguousarray(pixels.T)
    cv2.imwrite(str(FOLDER / "width.png"), upright)
    cv2.imwrite(str(FOLDER / "height.png"), pixels)
    tifffile.imwrite(FOLDER / "plain width.tif", upright)
    tifffile.imwrite(FOLDER / "deflate width.tif", upright, compression="zlib", predictor=True)
    tifffile.imwrite(FOLDER / "lzw height.tif", pixels, compression="lzw", rowsperstrip=8)
    for name in ("width.png", "height.png", "plain width.tif", "deflate width.tif", "lzw height.tif"):
        strip = open_strip(FOLDER / name, "width" if "width" in name else "height", work_dir=FOLDER)
        _, cpu, _ = timed(lambda strip=strip: sum(len(one) for one in strip.chunks()), 1)
        yield row(f"reading {name.replace('.', ', ')}", "-", f"{len(pixels) / cpu:.0f} klines/s", True)
        strip.close()
    _, cpu, _ = timed(lambda: sum(len(one) for one in reader.chunks()), 1)
    yield row("reading the stored form", "-", f"{reader.lines / cpu:.0f} klines/s", True)
    _, cpu, _ = timed(lambda: store_strip(reader, FOLDER / "again.strip.tif"), 1)
    ratio = reader.lines * ROWS / (FOLDER / "again.strip.tif").stat().st_size
    reached = f"{reader.lines / cpu:.0f} klines/s, packed 1:{ratio:.2f} with overviews"
    yield row("storing, from the stored form", "-", reached, True)


if __name__ == "__main__":
    try:
        sys.exit(report((pictures, speeds, end_to_end), sys.argv[2:]))
    finally:
        shutil.rmtree(FOLDER, ignore_errors=True)
