"""Everything that takes a night, one after the other, with one seed: `make nightly`
(python -m tests.load.nightly [--seed N] [--share S] [--only NAME,NAME]).

Kills on both databases, several machines with parts away, hostile files and requests, forged packages, clicks
under load. Each has a limit of
hours; what it printed and how it ended stand in the report (.build/nightly.md), which is written anew after
each. Ends with status 1 where one failed. `--share 0.01` does a hundredth of each.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LAST_SIGNS = 6000


@dataclass(frozen=True)
class Ended:
    """How one of them ended; `status` None: it took too long."""

    name: str
    status: int | None
    took_s: float
    printed: str

    @property
    def ok(self) -> bool:
        return self.status == 0


def commands(seed: int, share: float, package: Path) -> Mapping[str, Sequence[str]]:
    """What is run, by name."""

    def times(whole: int) -> str:
        return str(max(1, round(whole * share)))

    faults = ["-m", "tests.load.faults", "--kills", times(1000), "--seed", str(seed)]
    hostile = ["-m", "tests.load.hostile.run", "--cases", times(1000), "--seed", str(seed)]
    return {
        "faults on SQLite": faults,
        "faults on PostgreSQL": [*faults, "--postgresql"],
        "several machines": ["-m", "tests.load.machines"],
        "hostile input": hostile,
        "forged packages": ["tests/bench/bench_forgery.py", str(package), times(10_000), str(seed)],
        "clicks under load": ["-m", "tests.load.soak", "--seconds", times(3600)],
    }


def run(name: str, command: Sequence[str], hours: float) -> Ended:
    """One of them, with a limit."""
    start = time.monotonic()
    try:
        done = subprocess.run(
            [sys.executable, *command],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=hours * 3600,
            check=False,
        )
    except subprocess.TimeoutExpired as late:
        return Ended(name, None, time.monotonic() - start, (late.stdout or b"").decode(errors="replace"))
    return Ended(name, done.returncode, time.monotonic() - start, done.stdout.decode(errors="replace"))


def report(ended: Sequence[Ended], seed: int) -> str:
    """Markdown: a table, then what each printed last."""
    lines = [f"# Night of {datetime.now(UTC):%Y-%m-%d}, seed {seed}", "", "| what | ended | took |"]
    lines.append("| --- | --- | --- |")
    for one in ended:
        how = "good" if one.ok else "took too long" if one.status is None else f"status {one.status}"
        lines.append(f"| {one.name} | {how} | {one.took_s:.0f} s |")
    for one in ended:
        lines += ["", f"## {one.name}", "", "```", one.printed[-LAST_SIGNS:].strip(), "```"]
    return "\n".join(lines) + "\n"


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seed", type=int, default=int(f"{datetime.now(UTC):%Y%m%d}"))
    options.add_argument("--share", type=float, default=1.0)
    options.add_argument("--hours", type=float, default=4.0, help="at most, of each")
    options.add_argument("--only", default="", help="some of them, by the first words of their names")
    options.add_argument("-o", "--output", type=Path, default=ROOT / ".build" / "nightly.md")
    chosen = options.parse_args()
    wanted = tuple(one for one in chosen.only.split(",") if one) or ("",)
    ended: list[Ended] = []
    with tempfile.TemporaryDirectory() as made:
        package = Path(made) / "package"
        for name, command in commands(chosen.seed, chosen.share, package).items():
            if not name.startswith(wanted):
                continue
            if str(package) in command:
                from tests.load.hostile.run import package_in

                package_in(Path(made))
            ended.append(run(name, command, chosen.hours))
            chosen.output.parent.mkdir(parents=True, exist_ok=True)
            chosen.output.write_text(report(ended, chosen.seed))
            print(f"{name}: {'good' if ended[-1].ok else 'see ' + str(chosen.output)}", flush=True)
    sys.exit(0 if all(one.ok for one in ended) else 1)


if __name__ == "__main__":
    main()
