"""How long the statistics of many measurements take: `python tests/bench/bench_statistics.py [COUNT ...]`.

CPU seconds, for the machine may be busy, with the wall's beside them (on PostgreSQL the server's own work is
only in those). On a SQLite of its own; SIGHTLINE_BENCH_DATABASE_URL names another database, which must be
empty, for one COUNT. SIGHTLINE_BENCH_PROFILE=1 prints where the time goes.
"""

from __future__ import annotations

import cProfile
import gc
import os
import pstats
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from time import perf_counter, process_time

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.infra.database.engine import SessionFactory, make_engine, migrate, reading, session_factory
from sightline.results import survey_statistics
from sightline.results.routes import statistics_body
from sightline.results.survey_statistics import Filter, StatisticsOptions
from tests.bench.seed import seed

GOALS_S = {100_000: 1.0, 1_000_000: 5.0}


def fresh(folder: Path) -> SessionFactory:
    """A migrated database."""
    url = os.environ.get("SIGHTLINE_BENCH_DATABASE_URL") or f"sqlite:///{folder / 'bench.sqlite3'}"
    engine = make_engine(url)
    migrate(engine)
    return session_factory(engine)


def timed(action: Callable[[], object]) -> tuple[float, float]:
    """(CPU, wall) seconds of this process."""
    gc.collect()
    cpu, wall = process_time(), perf_counter()
    action()
    return process_time() - cpu, perf_counter() - wall


def answer(factory: SessionFactory, chosen: Filter) -> int:
    """What the route does, from the database to the text that goes out; its length."""
    with reading(factory) as session:
        found = survey_statistics.survey_statistics(session, chosen, StatisticsOptions())
    assert found.counted.measurements > 0
    return len(statistics_body(found, "inset").model_dump_json())


def main(counts: list[int]) -> int:
    for count in counts:
        with tempfile.TemporaryDirectory() as folder:
            factory = fresh(Path(folder))
            spent = timed(lambda factory=factory, count=count: seed(factory, count))  # type: ignore[misc]
            print(f"{count} measurements seeded: {spent[0]:.1f} s CPU, {spent[1]:.1f} s")
            for kept in (survey_statistics._compute_statistics, survey_statistics._columns):
                kept.cache_clear()  # as a new process begins
            profile = cProfile.Profile()
            if os.environ.get("SIGHTLINE_BENCH_PROFILE"):
                profile.enable()
            cold = timed(lambda factory=factory: answer(factory, Filter()))  # type: ignore[misc]
            profile.disable()
            other = timed(lambda factory=factory: answer(factory, Filter(lighting="daytime")))  # type: ignore[misc]
            again = timed(lambda factory=factory: answer(factory, Filter()))  # type: ignore[misc]
            goal = GOALS_S.get(count)
            missed = goal is not None and cold[0] > goal
            limit = f" <= {goal:g} s" if goal else ""
            print(f"statistics of {count}, cold{limit}: {cold[0]:.2f} s CPU, {cold[1]:.2f} s", end="")
            print("   <-- missed" if missed else "")
            print(f"  another filter: {other[0]:.2f} s CPU; the same again: {again[0]:.3f} s CPU")
            if os.environ.get("SIGHTLINE_BENCH_PROFILE"):
                pstats.Stats(profile).sort_stats("cumulative").print_stats(35)
    return 0


if __name__ == "__main__":
    sys.exit(main([int(word) for word in sys.argv[1:]] or [100_000]))
