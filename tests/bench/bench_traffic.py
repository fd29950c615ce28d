"""Months of traffic asked beside reached: `bench_traffic.py`, SITES (100) of a year with 1e6 vehicles each.

One site is made by the archive's own means, a recording a day; the others are links to its files, so that
1e8 rows are read and grouped though 1e6 were drawn. Wall time on two threads; longer on a busy machine.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from resource import RUSAGE_SELF, getrusage
from time import perf_counter

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.traffic.archive import add_recorded
from sightline.traffic.query import ArchiveTables
from sightline.traffic.records import Asked, Stood
from tests.bench.goals import Row, report, row
from tests.traffic.samples import recorded

SITES = int(os.environ.get("SITES", "100"))
DAYS, A_DAY = 365, 2740


def traffic() -> Iterator[Row]:
    """Hourly figures of a year of one site, and of all."""
    with tempfile.TemporaryDirectory(prefix="sightline-bench-") as place:
        folder = Path(place)
        _build(folder)
        with ArchiveTables(folder) as tables:
            began = perf_counter()
            counted = sum(1 for _ in tables.intervals(Asked(sites=("s000",))))
            one_s = perf_counter() - began
            assert counted == 24 * DAYS
            yield row("hourly flows and percentiles, a year of a site", "5 s", f"{one_s:.2f} s", one_s <= 5)
            began = perf_counter()
            vehicles = sum(one["vehicles"] for one in tables.intervals(Asked()))
            all_s = perf_counter() - began
        assert vehicles == SITES * DAYS * A_DAY
        yield row(f"the same of {SITES} sites, {vehicles:.3g} rows", "60 s", f"{all_s:.1f} s", all_s <= 60)
        memory_gb = getrusage(RUSAGE_SELF).ru_maxrss / 1e6
        yield row("memory", "2 GB", f"{memory_gb:.2f} GB", memory_gb <= 2)


def _build(folder: Path) -> None:
    for day in range(DAYS):
        start = datetime(2025, 1, 1, tzinfo=UTC) + timedelta(days=day)
        add_recorded(folder, recorded(day, A_DAY, 86400.0), Stood("s000", "", "UTC", start, 0.0))
    for table in ("vehicles", "watched"):
        for at in range(1, SITES):
            here, there = folder / table / "site=s000", folder / table / f"site=s{at:03}"
            shutil.copytree(here, there, copy_function=os.link)


if __name__ == "__main__":
    raise SystemExit(report([traffic], sys.argv[1:]))
