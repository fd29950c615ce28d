"""How quick a catalogue of 20,000 models comes in by a CSV: `python tests/bench/bench_catalogue.py`.

CPU seconds of this process, for the machine may be busy, on a SQLite of its own: the preview, the import of
all rows with their events, the same file once more, and one in which every size contradicts the catalogue's.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from time import process_time

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.vehicles.catalogue.import_csv import Choices, import_csv, plan_import
from sightline.vehicles.catalogue.store import page_of_catalogue, search_catalogue
from tests.bench.bench_storage import fresh
from tests.bench.goals import Row, report, row

ROWS = 20_000
GOAL_S = 5.0
HEADER = "make,model,year_from,year_to,category,height_m,u_height_m,wheelbase_m,length_m,width_m,source"


def catalogue(moved_m: float = 0.0) -> bytes:
    """A CSV of so many models, every size drawn by a fixed seed and moved by so much."""
    drawn = np.random.default_rng(7).uniform([1.3, 2.3, 3.6, 1.6], [2.1, 3.3, 5.4, 2.1], (ROWS, 4)) + moved_m
    lines = [HEADER]
    for number, (height, wheelbase, length, width) in enumerate(drawn):
        sizes = f"{height:.3f},0.010,{wheelbase:.3f},{length:.3f},{width:.3f}"
        lines.append(f"Make {number % 60},Model {number},{1990 + number % 30},,suv,{sizes},maker's sheet")
    return "\n".join(lines).encode()


def imports(factory: SessionFactory) -> Iterator[Row]:
    with reading(factory) as session:
        begin = process_time()
        plan = plan_import(session, catalogue(), "models.csv", Choices({}, None))
        took = process_time() - begin
    assert plan.problem is None, plan.problem
    yield row(f"preview of {ROWS:,} rows", f"{GOAL_S:.0f} s", f"{took:.2f} s", took <= GOAL_S)
    for name, moved_m in (
        ("import of new models", 0.0),
        ("the same file again", 0.0),
        ("all contradicted", 0.1),
    ):
        with writing(factory) as session:
            begin = process_time()
            done = import_csv(session, catalogue(moved_m), "models.csv", Choices({}, None), actor=None)
            took = process_time() - begin
        said = f"{took:.2f} s ({done.added:,} added)"
        yield row(f"{name}, {ROWS:,} rows", f"{GOAL_S:.0f} s", said, took <= GOAL_S)


def looking(factory: SessionFactory) -> Iterator[Row]:
    with reading(factory) as session:
        for name, ask in (
            ("completing what is typed", lambda: search_catalogue(session, "make 7 mod")),
            (
                "page 300 of the catalogue",
                lambda: page_of_catalogue(session, "", retired=False, offset=15_000),
            ),
        ):
            begin = process_time()
            ask()
            took = process_time() - begin
            yield row(f"{name}, {ROWS:,} models", "0.3 s", f"{took:.3f} s", took <= 0.3)


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        factory = fresh(Path(folder))
        parts = [partial(imports, factory), partial(looking, factory)]
        return report(parts, ())


if __name__ == "__main__":
    sys.exit(main())
