"""How often total intervals of errors hold the truth: `bench_error_coverage.py [SAMPLES] [WORD] [--seed N]`.

Surveys are drawn whose errors against known heights are known: errors that a pose shares, random ones, those
of the known heights, sites that differ. The share of surveys whose 95 % interval holds the figure's mean over
all such surveys is printed, with how often it lay below and above. Goal: 0.95 +- 0.01 where errors have no
bias but what their budgets say; a share of SAMPLES surveys has itself a standard error of 0.22 /
sqrt(SAMPLES). The method was made on other seeds than any that `--seed` gives.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import stats

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.statistics.error_totals import ErrorTotals
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

FIGURES = ("bias", "MAE", "RMSE", "SD", "<=20mm")
GOAL, AWAY = 0.95, 0.01
Rng = np.random.Generator


@dataclass(frozen=True)
class World:
    """n vehicles at `sites`; errors in mm (SD): shared by the heights of a site (by all: `common`), random,
    of the known heights, sites apart by more than their budgets; and a bias that no budget has.
    """

    n: int
    sites: int
    shared: float
    random: float
    known: float = 10.0
    apart: float = 0.0
    bias: float = 0.0
    common: bool = False
    group: str = "goal"


WORLDS = [
    *(
        World(n, j, s, r)
        for n in (100, 400, 2000)
        for j in (1, 5, 20)
        for s, r in ((0, 10), (5, 20), (15, 0))
    ),
    *(World(400, 2, s, r) for s, r in ((0, 20), (5, 10), (15, 0), (15, 20))),
    World(400, 5, 10, 10, common=True),
    *(World(400, j, 15, 10, bias=b, group="bias") for j in (1, 5) for b in (10, 30)),
    *(World(400, j, 5, 10, apart=10, group="apart") for j in (2, 5, 20)),
]


def truth_of(world: World) -> np.ndarray:
    """The figures' means over all such surveys, mm."""
    own2 = world.random**2 + world.known**2
    between2 = world.apart**2 + (0.0 if world.common else world.shared**2)
    whole = np.sqrt(own2 + world.apart**2 + world.shared**2)
    z = world.bias / whole
    mae = whole * np.sqrt(2 / np.pi) * np.exp(-z * z / 2) + world.bias * (1 - 2 * stats.norm.cdf(-z))
    within = stats.norm.cdf((20 - world.bias) / whole) - stats.norm.cdf((-20 - world.bias) / whole)
    sd = np.sqrt(own2 + between2 * (1 - 1 / world.sites))
    return np.array([world.bias, mae, np.hypot(whole, world.bias), sd, within])


def intervals(world: World, rng: Rng) -> np.ndarray:
    """(5, 2), mm."""
    site = np.arange(world.n) % world.sites
    group = np.zeros_like(site) if world.common else site
    error = world.bias + rng.normal(0.0, world.shared, world.sites)[group]
    error = error + rng.normal(0.0, world.apart, world.sites)[site]
    error = error + rng.normal(0.0, world.random, world.n) + rng.normal(0.0, world.known, world.n)
    error = error / 1000
    shared = (SharedErrors(group, np.full(world.n, world.shared / 1000)),) if world.shared else ()
    bias = TotalUncertainty(HeightSample(error, np.zeros(world.n), shared, site)).mean()
    totals = ErrorTotals(error, shared, site)
    lengths = ((bias.U95_low, bias.U95_high), totals.mae(), np.sqrt(totals.mse()), totals.sd())
    return np.array([*(np.asarray(one) * 1000 for one in lengths), totals.share_within(0.02)])


def main(worlds: list[World], samples: int, seed: int) -> int:
    print(f"{samples} surveys each, seed {seed}; standard error {np.sqrt(GOAL * (1 - GOAL) / samples):.4f}")
    print("    n sites shared random apart bias " + "".join(f"{one:>22}" for one in FIGURES))
    held = []
    for k, world in enumerate(worlds):
        rng = np.random.default_rng([seed, k])
        found = np.array([intervals(world, rng) for _ in range(samples)])
        truth = truth_of(world)
        above, below = (found[:, :, 0] > truth).mean(0), (found[:, :, 1] < truth).mean(0)
        held.append(1.0 - above - below)
        cells = zip(held[-1], above, below, strict=True)
        head = f"{world.n:>5}{world.sites:>6}{world.shared:>7g}{world.random:>7g}{world.apart:>6g}"
        said = "".join(f"   {a:.3f} (-{b:.3f} +{c:.3f})" for a, b, c in cells)
        print(f"{head}{world.bias:>5g} {said}{' one error' if world.common else ''}", flush=True)
        middle = np.median(found, axis=0)
        ends = "".join(
            f"{f'{a:.4g} to {b:.4g} ({t:.4g})':>22}" for (a, b), t in zip(middle, truth, strict=True)
        )
        print(f"{'':37}{ends}", flush=True)
    for group in dict.fromkeys(world.group for world in worlds):
        rows = np.array([one for one, world in zip(held, worlds, strict=True) if world.group == group])
        for name, column in zip(FIGURES, rows.T, strict=True):
            inside = int(np.count_nonzero(np.abs(column - GOAL) <= AWAY))
            print(
                f"{group} {name}: mean {column.mean():.4f}, {column.min():.3f} to {column.max():.3f}; "
                f"{inside} of {len(column)} within {AWAY}"
            )
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("samples", type=int, nargs="?", default=1000)
    parser.add_argument("group", nargs="?", choices=("goal", "bias", "apart"))
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    chosen = [one for one in WORLDS if asked.group in (None, one.group)]
    sys.exit(main(chosen, asked.samples, asked.seed))
