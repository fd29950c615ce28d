"""All hostile input there is, from a seed, into a report: `make hostile HOSTILE="--seed 7 --cases 1000"`.

Rooms run in processes of their own: one that ends, hangs for a minute or holds more than a gigabyte is a
failure, named with its seed, and the room goes on behind it. Requests by and against the description of the
API are schemathesis's, in `tests/infra/test_openapi.py`. Meant for the night: the whole takes about an hour.
"""

from __future__ import annotations

import argparse
import json
import os
import select
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from tests.load.hostile.rooms import PACKAGE, ROOMS

ROOT = Path(__file__).resolve().parents[3]
HANG_S, MOST_MB = 60, 1000
OPERATIONS = 170


@dataclass
class Told:
    """What came of a room."""

    room: str
    came: Counter[str] = field(default_factory=Counter)
    slowest_s: float = 0.0
    memory_mb: float = 0.0
    took_s: float = 0.0
    failures: list[str] = field(default_factory=list)


def through(room: str, first: int, count: int) -> Told:
    """All cases of a room."""
    told, at = Told(room), first
    start = time.monotonic()
    while at < first + count:
        at = _until_it_ends(told, room, at, first + count - at)
    told.took_s = time.monotonic() - start
    return told


def _until_it_ends(told: Told, room: str, first: int, count: int) -> int:
    """One process; the seed that the next one begins with."""
    at = first
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(
            [sys.executable, "-m", "tests.load.hostile.rooms", room, str(first), str(count)],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=errors,
        )
        assert process.stdout is not None
        hangs = False
        while not hangs:
            hangs = not select.select([process.stdout], [], [], HANG_S)[0]
            line = b"" if hangs else process.stdout.readline()
            if not line:
                break
            case = json.loads(line)
            told.came[case["came"]] += 1
            told.slowest_s, told.memory_mb = max(told.slowest_s, case["s"]), max(told.memory_mb, case["mb"])
            at = case["seed"] + 1
        process.kill() if hangs else None
        status = process.wait()
        process.stdout.close()
        if status == 0:
            return first + count
        errors.seek(0)
        words = errors.read().decode(errors="replace").strip().splitlines() or [f"status {status}"]
        told.failures.append(f"{room} {at}: " + ("hangs" if hangs else words[-1][:300]))
    return at + 1


def requests(cases: int, seed: int) -> Told:
    """Random requests; the test fails at the first answer that is not as described."""
    told = Told("requests")
    each = max(1, round(cases / OPERATIONS / 2))
    start = time.monotonic()
    run = subprocess.run(
        [sys.executable, "-m", "pytest", "-x", "-s", "tests/infra/test_openapi.py", "-k", "breaks"],
        cwd=ROOT,
        env={**os.environ, "SIGHTLINE_REQUESTS_EACH": str(each), "SIGHTLINE_REQUESTS_SEED": str(seed)},
        capture_output=True,
        text=True,
        check=False,
    )
    told.took_s = time.monotonic() - start
    for line in run.stdout.splitlines():
        word, _, number = line.strip(".").partition(" requests answered: ")
        if number:
            told.came[word] += int(number)
    if run.returncode:
        told.failures += [line for line in run.stdout.splitlines() if line.startswith("E  ")][:5] or [
            "failed"
        ]
    return told


def package_in(folder: Path) -> Path:
    """An export of a small demonstration."""
    from tests.browser.conftest import made_once

    path = folder / "package"
    command = [sys.executable, "-m", "sightline.cli", "export", "--survey", "1", "-o", str(path)]
    made = made_once(folder / "small")
    subprocess.run([*command, "--data-dir", str(made)], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    return path


def report(told: list[Told], seed: int) -> str:
    lines = [f"# Hostile input, seed {seed}", ""]
    lines += ["| room | cases | what came of them | slowest | memory | took | failures |"]
    lines += ["| --- | --- | --- | --- | --- | --- | --- |"]
    for one in told:
        came = ", ".join(f"{count} {word}" for word, count in one.came.most_common())
        lines.append(
            f"| {one.room} | {one.came.total()} | {came} | {one.slowest_s:.1f} s | {one.memory_mb:.0f} MB | "
            f"{one.took_s:.0f} s | {len(one.failures)} |"
        )
    lines += ["", *(f"- {failure}" for one in told for failure in one.failures)]
    return "\n".join(lines) + "\n"


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seed", type=int, default=0)
    options.add_argument("--cases", type=int, default=1000, help="of each room; ten times as many requests")
    options.add_argument("--rooms", default=",".join((*ROOMS, "requests")))
    options.add_argument("-o", "--output", type=Path, default=ROOT / ".build" / "hostile.md")
    chosen = options.parse_args()
    told = []
    with tempfile.TemporaryDirectory() as made:
        for room in chosen.rooms.split(","):
            if room == "packages" and PACKAGE not in os.environ:
                os.environ[PACKAGE] = str(package_in(Path(made)))
            if room == "requests":
                told.append(requests(10 * chosen.cases, chosen.seed))
            else:
                told.append(through(room, 1_000_000 * chosen.seed, chosen.cases))
            if told[-1].memory_mb > MOST_MB:
                told[-1].failures.append(f"{room}: held {told[-1].memory_mb:.0f} MB")
            print(report(told[-1:], chosen.seed), flush=True)
    chosen.output.parent.mkdir(parents=True, exist_ok=True)
    chosen.output.write_text(report(told, chosen.seed))
    sys.exit(1 if any(one.failures for one in told) else 0)


if __name__ == "__main__":
    main()
