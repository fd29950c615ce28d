"""Memory and time of an export: `python tests/bench/bench_export.py [COUNT ...]`, without crops.

Each in a process of its own on a SQLite of its own, so that the peak is the export's;
SIGHTLINE_BENCH_DATABASE_URL names another database, which must be empty, for one COUNT. The peak is that of
the whole process, NumPy, SciPy, Matplotlib and Typst with it.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter, process_time
from types import SimpleNamespace
from typing import cast

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.export.build import build
from sightline.geometry.documents import camera_to_dict, pose_to_dict
from sightline.infra.csv_package.files import Staging, zip_folder
from sightline.infra.database.engine import (
    SessionFactory,
    make_engine,
    migrate,
    reading,
    session_factory,
    writing,
)
from sightline.infra.services import Services
from tests.bench.seed import seed
from tests.support import samples
from tests.support.ground import flat_camera, pose_above_road

GOAL_MB = {100_000: 700, 1_000_000: 1500}


def with_real_set_up() -> None:
    """The sample's pose and calibration are stubs; a report needs a camera that exists."""
    add_calibration, add_pose = samples.add_calibration, samples.add_pose

    def lens(*args, **values):  # type: ignore[no-untyped-def]
        return add_calibration(*args, **{**values, "document": camera_to_dict(flat_camera())})

    def pose(*args, **values):  # type: ignore[no-untyped-def]
        return add_pose(*args, **{**values, "document": pose_to_dict(pose_above_road()), "expected": []})

    samples.add_calibration, samples.add_pose = lens, pose  # type: ignore[assignment]


def peak_mb() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def fresh(url: str) -> SessionFactory:
    engine = make_engine(url)
    migrate(engine)
    return session_factory(engine)


def make(url: str, count: int) -> None:
    """A process that seeds."""
    with_real_set_up()
    seed(fresh(url), count)


def measure(url: str, folder: Path) -> None:
    """A process that exports and tells what it took."""
    factory = fresh(url)
    staging = Staging(folder / "package")
    staging.folder.mkdir()
    before = peak_mb()
    cpu, wall = process_time(), perf_counter()
    with reading(factory) as session:
        # no photographs and no crops: of the services only the seal's transaction is asked
        services = cast(Services, SimpleNamespace(writing=lambda: writing(factory)))
        built = build(staging, session, 1, services, told, crops=False)
    rows = peak_mb()
    zip_folder(staging, folder / "package.zip")
    size = sum(one.size for one in staging.written.values()) / 1e6
    packed = (folder / "package.zip").stat().st_size / 1e6
    print(
        f"  {built.measurements} measurements: {process_time() - cpu:.0f} s CPU, "
        f"{perf_counter() - wall:.0f} s; {len(staging.written)} files, {size:.0f} MB, ZIP {packed:.0f} MB\n"
        f"  memory before {before:.0f} MB, building {rows:.0f} MB, in the end {peak_mb():.0f} MB",
        flush=True,
    )


_last = ""


def told(fraction: float, words: str) -> None:
    global _last
    if words != _last:
        print(
            f"  {100 * fraction:3.0f} % {words} ({peak_mb():.0f} MB, {process_time():.0f} s CPU)", flush=True
        )
        _last = words


def main(counts: list[int]) -> int:
    for count in counts:
        goal = GOAL_MB.get(count)
        print(
            f"export of {count} measurements, asked: bounded memory{f' (<= {goal} MB)' if goal else ''}",
            flush=True,
        )
        with tempfile.TemporaryDirectory() as place:
            url = os.environ.get("SIGHTLINE_BENCH_DATABASE_URL") or f"sqlite:///{place}/bench.sqlite3"
            for step in (["seed", url, str(count)], ["export", url, place]):
                subprocess.run([sys.executable, __file__, *step], check=True)
    return 0


if __name__ == "__main__":
    if sys.argv[1:2] == ["seed"]:
        make(sys.argv[2], int(sys.argv[3]))
    elif sys.argv[1:2] == ["export"]:
        measure(sys.argv[2], Path(sys.argv[3]))
    else:
        sys.exit(main([int(word) for word in sys.argv[1:]] or [100_000]))
