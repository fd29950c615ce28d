"""Which car is it? Share of vehicles whose own row is among the first five, and what is said without it.

    python tests/bench/bench_which_car.py [VEHICLES]

A vehicle is a row of the catalogue off by the row's u; it is measured with the u given. Half of the variance
of the heights' and the wheelbase's errors is shared, as one pose makes it. Leave-one-out: its row is taken
away, and every row that is left has to be said not to fit. Tables: the demonstration's (15 invented models)
and the shared public one (length, width, height of models; no wheelbase, no lamp; `SIGHTLINE_SHARED_DATA`).
Nothing was set on these seeds.
"""

from __future__ import annotations

import csv
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from sightline.statistics.agreement import U_MANUFACTURER_M  # noqa: E402
from sightline.statistics.which_model import ModelFits, fit_models  # noqa: E402
from tests.bench.goals import Row, report, row  # noqa: E402
from tests.simulation.models import MODELS  # noqa: E402

VEHICLES = 4000
SHARED = 0.5
Floats = NDArray[np.float64]


def demonstration() -> Iterator[Row]:
    """Roof, rear lamp and wheelbase."""
    sizes = np.array([[m.height_m, m.tail_lamp_m, m.wheelbase_m] for m in MODELS])
    u, u_row = np.array([0.02, 0.02, 0.045]), np.array([U_MANUFACTURER_M, 0.02, 0.01])
    yield from played("demonstration, roof", sizes[:, :1], u[:1], u_row[:1], 7001)
    yield from played("demonstration, roof, rear lamp, wheelbase", sizes, u, u_row, 7002)


def public() -> Iterator[Row]:
    """Roof from video, with length from line scans."""
    folder = Path(os.environ.get("SIGHTLINE_SHARED_DATA", ROOT.parent / "shared" / "data"))
    table = folder / "tables" / "qatarcars.csv"
    if not table.exists():
        print(f"left out: the public table is not there ({table.name})")
        return
    with table.open(newline="", encoding="utf-8") as lines:
        sizes = np.array([[float(one["height"]), float(one["length"])] for one in csv.DictReader(lines)])
    u, u_row = np.array([0.02, 0.03]), np.array([U_MANUFACTURER_M, 0.01])
    yield from played(f"public, {len(sizes)} models, roof", sizes[:, :1], u[:1], u_row[:1], 7003)
    yield from played(f"public, {len(sizes)} models, roof and length", sizes, u, u_row, 7004)


def played(name: str, sizes: Floats, u: Floats, u_row: Floats, seed: int) -> Iterator[Row]:
    rng = np.random.default_rng(seed)
    u_rows = np.broadcast_to(u_row, sizes.shape)
    hits = first = own = alone = 0
    for _ in range(VEHICLES):
        index = int(rng.integers(len(sizes)))
        common = np.sqrt(SHARED) * rng.normal() + np.sqrt(1.0 - SHARED) * rng.normal(size=len(u))
        measured = sizes[index] + rng.normal(0.0, u_row) + u * common
        found = fit_models(measured, u, sizes, u_rows)
        assert isinstance(found, ModelFits)
        hits += index in found.order[:5]
        first += found.order[0] == index
        own += bool(found.cannot[index])
        alone += bool(np.delete(found.cannot, index).all())
    share = {"5": hits / VEHICLES, "1": first / VEHICLES, "own": own / VEHICLES, "out": alone / VEHICLES}
    yield row(f"{name}: own row among five", "reported", f"{share['5']:.3f}; first {share['1']:.3f}", True)
    yield row(f"{name}: own row said not to fit", "0.002", f"{share['own']:.4f}", share["own"] <= 0.002)
    yield row(f"{name}: left out, nothing fits", "reported", f"{share['out']:.3f}", True)


if __name__ == "__main__":
    VEHICLES = int(sys.argv[1]) if len(sys.argv) > 1 else VEHICLES
    sys.exit(report([demonstration, public], []))
