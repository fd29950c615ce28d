"""How often a test fails by chance: `make flakes N=20` (python -m tests.load.flakes N [FILE ...]).

The browser's files and those that kill, wait or take turns are run N times on one core beside five busy
loops, where what depends on time fails soon: one such run stands for many on a machine that rests. No second
try. Give files to run them alone. `make flakes MINUTES=60` takes file after file until the time is over, the
next time begins where it stopped and adds to the counts in .build/flakes.json (remove it to begin anew).
Prints the failures per 1,000 of each test that failed, writes the same to .build/flakes.md, and ends with
status 1 where there was one.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
BUSY_LOOPS = 5
STOPPING_S = 120  # a test that is broken off stops its server and its browser
STATE = ROOT / ".build" / "flakes.json"
FILES = (
    "tests/infra/test_guard.py",
    "tests/infra/test_turns.py",
    "tests/infra/test_write_gate.py",
    "tests/infra/test_backup.py",
    "tests/infra/test_dead_connections.py",
    "tests/infra/test_idempotency.py",
    "tests/infra/test_watching.py",
    "tests/infra/jobs",
    "tests/media/test_onward.py",
    "tests/media/test_decode_host.py",
    "tests/media/test_uploads.py",
    "tests/recordings/test_frames_ahead.py",
    "tests/scans/test_live_run.py",
    "tests/scans/test_live_survey.py",
    "tests/commands/test_import.py",
    "tests/commands/test_stream.py",
    "tests/commands/test_serve_first_start.py",
    "tests/browser",
)


def main(arguments: Sequence[str]) -> int:
    if arguments[0] == "--minutes":
        return for_minutes(float(arguments[1]), arguments[2:] or FILES)
    times, files = int(arguments[0]), arguments[1:] or FILES
    runs: Counter[str] = Counter()
    failures: Counter[str] = Counter()
    one_core = {min(os.sched_getaffinity(0))}
    os.sched_setaffinity(0, one_core)
    with busy_loops():
        for n in range(1, times + 1):
            began = time.monotonic()
            for name, failed in results(files):
                runs[name] += 1
                failures[name] += failed
            print(f"{n} of {times}: {time.monotonic() - began:.0f} s, {failures.total()} failed", flush=True)
            write_table(runs, failures)
    print(table(runs, failures))
    return 1 if failures.total() or not runs else 0


def for_minutes(minutes: float, places: Sequence[str]) -> int:
    """File after file until the time is over; begins with the one that the last time broke off."""
    until = time.monotonic() + 60 * minutes
    files = one_by_one(places)
    kept = json.loads(STATE.read_text("utf-8")) if STATE.exists() else {}
    runs, failures = Counter(kept.get("runs", {})), Counter(kept.get("failures", {}))
    at = files.index(kept["next"]) if kept.get("next") in files else 0
    STATE.parent.mkdir(exist_ok=True)
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    with busy_loops():
        while (left := until - time.monotonic()) > 0:
            for name, failed in results([files[at]], left):
                runs[name] += 1
                failures[name] += failed
            if time.monotonic() < until:
                at = (at + 1) % len(files)
            print(f"{files[at]} is next, {failures.total()} failed so far", flush=True)
            told = {"next": files[at], "runs": runs, "failures": failures}
            STATE.write_text(json.dumps(told), "utf-8")
            write_table(runs, failures)
    print(table(runs, failures))
    return 1 if failures.total() or not runs else 0


def one_by_one(places: Sequence[str]) -> list[str]:
    """The test files of folders and files."""
    found = [sorted((ROOT / place).glob("test_*.py")) or [ROOT / place] for place in places]
    return [str(file.relative_to(ROOT)) for files in found for file in files]


@contextmanager
def busy_loops() -> Iterator[None]:
    """Loops on the core of this process, until the end."""
    loops = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(BUSY_LOOPS)]
    try:
        yield
    finally:
        for loop in loops:
            loop.kill()
            loop.wait()


def results(files: Sequence[str], seconds: float | None = None) -> list[tuple[str, bool]]:
    """One run, broken off after so many seconds: each test that ended by name, and whether it failed.

    A run that ends by itself and leaves no results counts as one failure of its files.
    """
    with tempfile.NamedTemporaryFile(suffix=".xml") as report:
        command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--durations=0"]
        run = subprocess.Popen(
            [*command, f"--junitxml={report.name}", *files],
            cwd=ROOT,
            stdout=subprocess.DEVNULL,
            start_new_session=True,
        )
        broken_off = False
        try:
            run.wait(seconds)
        except subprocess.TimeoutExpired:
            broken_off = True
            run.send_signal(signal.SIGINT)
            try:
                run.wait(STOPPING_S)
            except subprocess.TimeoutExpired:
                os.killpg(run.pid, signal.SIGKILL)
                run.wait()
        if not Path(report.name).stat().st_size:
            return [] if broken_off else [(f"{' '.join(files)} ended without results", True)]
        cases = list(ElementTree.parse(report.name).getroot().iter("testcase"))
    return [
        (f"{case.get('classname')}::{case.get('name')}", any(one.tag in ("failure", "error") for one in case))
        for case in cases
    ]


def table(runs: Counter[str], failures: Counter[str]) -> str:
    """Markdown: what failed, the most frequent first."""
    lines = [f"{len(runs)} tests, {runs.total()} runs of a test, {failures.total()} failed.", ""]
    if failures.total():
        lines += ["| test | failures | per 1,000 |", "| --- | --- | --- |"]
    for name, failed in failures.most_common():
        if failed:
            lines.append(f"| {name} | {failed} of {runs[name]} | {1000 * failed / runs[name]:.0f} |")
    return "\n".join(lines)


def write_table(runs: Counter[str], failures: Counter[str]) -> None:
    """What is known so far, for a run that is broken off."""
    place = ROOT / ".build" / "flakes.md"
    place.parent.mkdir(exist_ok=True)
    place.write_text(table(runs, failures) + "\n", encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
