"""How quick a large survey is: `python tests/bench/bench_storage.py`, CPU seconds, on a SQLite of its own.

SIGHTLINE_BENCH_DATABASE_URL names another database, which must be empty.
"""

from __future__ import annotations

import gc
import os
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.infra.database.engine import (
    SessionFactory,
    make_engine,
    migrate,
    reading,
    session_factory,
    writing,
)
from sightline.measurements.sheets.query import list_sheets
from sightline.measurements.store import list_measurements
from sightline.recordings.frames.store import get_frame_table
from sightline.recordings.store import note_ingested
from sightline.results.overview.query import survey_overview
from sightline.reviews.store import review_queue
from tests.bench.goals import Row, report, row
from tests.support import samples
from tests.support.samples import Sample

VEHICLES = 5000
FRAMES = 20_000


def cpu_s(function: Callable[[], object]) -> float:
    """CPU seconds of this process, for the machine may be busy."""
    gc.collect()
    started = time.process_time()
    function()
    return time.process_time() - started


def fresh(folder: Path) -> SessionFactory:
    """A migrated database."""
    url = os.environ.get("SIGHTLINE_BENCH_DATABASE_URL") or f"sqlite:///{folder / 'bench.sqlite3'}"
    engine = make_engine(url)
    migrate(engine)
    return session_factory(engine)


def lists(factory: SessionFactory, one: Sample) -> Iterator[Row]:
    survey_id = one.survey.id
    with reading(factory) as session:
        wanted: tuple[tuple[str, float, Callable[[], object]], ...] = (
            (
                f"{VEHICLES} vehicles with measurements",
                1.0,
                lambda: list_sheets(session, survey_id),
            ),
            ("counts and steps of that survey", 0.3, lambda: survey_overview(session, survey_id)),
            ("review queue of that survey", 1.5, lambda: review_queue(session, survey_id, actor=1)),
            ("all its measurements", 1.0, lambda: list_measurements(session, survey_id)),
        )
        for words, goal_s, action in wanted:
            spent_s = cpu_s(action)
            yield row(f"{words} <= {goal_s} s", "", f"{spent_s:.2f} s", spent_s <= goal_s)


def writes(factory: SessionFactory, one: Sample) -> Iterator[Row]:
    with writing(factory) as session:
        spent = [cpu_s(partial(samples.measure, session, one, key=900_000 + key)) for key in range(50)]
    middle_ms = 1000 * statistics.median(spent)
    yield row("a measurement with its event <= 30 ms", "", f"{middle_ms:.1f} ms", middle_ms <= 30)


def bulk_frames(factory: SessionFactory, one: Sample) -> Iterator[Row]:
    table = samples.frame_table(FRAMES)
    with writing(factory) as session:
        made = samples.add_recording(session, one.survey.id, None)
        spent_s = cpu_s(lambda: note_ingested(session, made.id, samples.facts(), table, actor=None))
    yield row(f"{FRAMES} frames written <= 1 s", "", f"{spent_s:.2f} s", spent_s <= 1)
    with reading(factory) as session:
        spent_s = cpu_s(lambda: get_frame_table(session, made.id))
    yield row(f"{FRAMES} frames read <= 0.5 s", "", f"{spent_s:.2f} s", spent_s <= 0.5)


def main(wanted: list[str]) -> int:
    with tempfile.TemporaryDirectory() as folder:
        factory = fresh(Path(folder))
        one = samples.fill(factory, VEHICLES)

        def rows() -> Iterator[Row]:
            for part in (lists, writes, bulk_frames):
                yield from part(factory, one)

        return report([rows], wanted)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
