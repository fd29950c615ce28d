"""How often total intervals hold the truth: `bench_coverage.py [SAMPLES] [--grid] [--seed N]`.

Fleets whose percentiles are known are drawn, measured with errors that sites share and with random ones, and
the share of samples whose 95 % interval holds the truth is printed, for each percentile, the mean and the SD.
Goal: 0.95 +- 0.01 for P2.5 to P97.5; a share of SAMPLES samples has itself a standard error of 0.22 /
sqrt(SAMPLES). `--grid`: the corners and middle of the goal's ranges, each with each. The method was made on
other seeds than any that `--seed` gives (its worlds had the same numbers and no seed before them).
"""

from __future__ import annotations

import argparse
import itertools
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import integrate, optimize, stats

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

PERCENTS = (2.5, 10.0, 50.0, 90.0, 97.5)
GOAL, AWAY = 0.95, 0.01
Rng = np.random.Generator


@dataclass(frozen=True)
class Fleet:
    """Heights of vehicles, metres: draws, and the share below a height."""

    draw: Callable[[Rng, int], np.ndarray]
    below: Callable[[np.ndarray], np.ndarray]


def _mixture(share: float, one: tuple[float, float], other: tuple[float, float]) -> Fleet:
    def draw(rng: Rng, n: int) -> np.ndarray:
        return np.where(rng.random(n) < share, rng.normal(*one, n), rng.normal(*other, n))

    return Fleet(draw, lambda x: share * stats.norm.cdf(x, *one) + (1 - share) * stats.norm.cdf(x, *other))


FLEETS = {
    "normal": Fleet(lambda rng, n: rng.normal(1.16, 0.06, n), lambda x: stats.norm.cdf(x, 1.16, 0.06)),
    "skewed": Fleet(
        lambda rng, n: 1.0 + 0.03 * rng.gamma(4.0, 1.0, n), lambda x: stats.gamma.cdf((x - 1.0) / 0.03, 4.0)
    ),
    "two kinds": _mixture(0.7, (1.12, 0.045), (1.32, 0.07)),
    "5 % lorries": _mixture(0.95, (1.14, 0.05), (2.3, 0.12)),
}


@dataclass(frozen=True)
class World:
    """n heights at `sites`, whose fleets lie apart by `apart_mm` (SD); errors in mm. common: all sites share
    one error, not each its own; said: whether the sites are named to the estimate.
    """

    fleet: str
    n: int
    sites: int
    shared_mm: float
    random_mm: float
    apart_mm: float = 0.0
    common: bool = False
    said: bool = True
    uneven: bool = False


WORLDS = [
    *(World("normal", n, 1, s, r) for n in (100, 400, 2000) for s, r in ((0, 0), (0, 20), (15, 10))),
    *(World("normal", n, j, s, 20) for n in (100, 400, 2000) for j in (2, 5, 20) for s in (0, 15)),
    *(World("normal", 600, j, 5, 10, apart_mm=15) for j in (2, 3, 5, 10, 20)),
    World("normal", 600, 10, 15, 10, said=False),
    World("normal", 600, 5, 10, 10, apart_mm=10, common=True),
    World("normal", 600, 8, 10, 10, apart_mm=10, uneven=True),
    *(World("skewed", n, j, 5, 20) for n in (100, 400, 2000) for j in (1, 10)),
    *(World("two kinds", n, j, 5, 20) for n in (100, 400, 2000) for j in (1, 10)),
    World("5 % lorries", 400, 1, 5, 20),
    World("5 % lorries", 2000, 10, 5, 20),
]

GRID = [World("normal", *one) for one in itertools.product((100, 400, 2000), (1, 2, 5, 20), (0, 15), (0, 20))]


def truth_of(world: World) -> np.ndarray:
    """Percentiles, mean and SD of the fleet over all sites that there might be."""
    fleet, apart = FLEETS[world.fleet], world.apart_mm / 1000
    nodes, weights = np.polynomial.hermite_e.hermegauss(41)

    def below(x: float) -> float:
        return float(weights @ fleet.below(x - apart * nodes) / weights.sum())

    found = [optimize.brentq(lambda x, p=p: below(x) - p / 100, 0.0, 4.0) for p in PERCENTS]
    mean = integrate.quad(lambda x: 1.0 - below(x), 0.0, 4.0, limit=400)[0]
    square = 2.0 * integrate.quad(lambda x: x * (1.0 - below(x)), 0.0, 4.0, limit=400)[0]
    return np.array([*found, mean, np.sqrt(square - mean**2)])


def sample_of(world: World, rng: Rng) -> HeightSample:
    share = np.arange(1.0, world.sites + 1.0) if world.uneven else np.ones(world.sites)
    site = np.sort(rng.choice(world.sites, world.n, p=share / share.sum()))
    if not world.uneven:
        site = np.sort(np.arange(world.n) % world.sites)
    true = FLEETS[world.fleet].draw(rng, world.n)
    true = true + rng.normal(0.0, 1.0, world.sites)[site] * world.apart_mm / 1000
    group = np.zeros_like(site) if world.common else site
    u_shared, u_random = world.shared_mm / 1000, world.random_mm / 1000
    error = rng.normal(0.0, 1.0, world.sites)[group] * u_shared + rng.normal(0.0, 1.0, world.n) * u_random
    shared = (SharedErrors(group, np.full(world.n, u_shared)),) if u_shared else ()
    return HeightSample(true + error, np.full(world.n, u_random), shared, site if world.said else None)


def coverage(world: World, samples: int, seed: int = 1) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(share held, mean error of the values mm, median half width mm), each for percentiles, mean, SD."""
    rng = np.random.default_rng([seed, world.n, world.sites, int(world.shared_mm), int(world.random_mm)])
    truth = truth_of(world)
    held, error, half = [], [], []
    for _ in range(samples):
        found = TotalUncertainty(sample_of(world, rng))
        figures = [*(found.percentile(p) for p in PERCENTS), found.mean(), found.sd()]
        low = np.array([one.U95_low for one in figures])
        high = np.array([one.U95_high for one in figures])
        held.append((low <= truth) & (truth <= high))
        error.append(np.array([one.value for one in figures]) - truth)
        half.append(0.5 * (high - low))
    return np.mean(held, axis=0), 1000 * np.mean(error, axis=0), 1000 * np.median(half, axis=0)


def main(worlds: list[World], samples: int, seed: int) -> int:
    heads = [*(f"P{p:g}" for p in PERCENTS), "mean", "SD"]
    print(f"{samples} samples each, seed {seed}; standard error {np.sqrt(GOAL * (1 - GOAL) / samples):.4f}")
    print(
        f"{'fleet':<12}{'n':>5}{'sites':>6}{'shared':>7}{'random':>7}{'apart':>6} "
        + "".join(f"{h:>7}" for h in heads)
    )
    shares = []
    for world in worlds:
        held, error, half = coverage(world, samples, seed)
        shares.append(held[: len(PERCENTS)])
        said = ("" if world.said else " sites not named") + (" one error" if world.common else "")
        line = f"{world.fleet:<12}{world.n:>5}{world.sites:>6}{world.shared_mm:>7g}{world.random_mm:>7g}"
        print(line + f"{world.apart_mm:>6g} " + "".join(f"{one:>7.3f}" for one in held) + said, flush=True)
        print(f"{'  U95 mm':<44}" + "".join(f"{one:>7.1f}" for one in half))
        print(f"{'  bias mm':<44}" + "".join(f"{one:>7.1f}" for one in error))
    _summary(worlds, np.array(shares), samples)
    return 0


def _summary(worlds: list[World], shares: np.ndarray, samples: int) -> None:
    """All coverages, then those of each level of each factor: means of many samples tell 0.01 apart."""
    noise = np.sqrt(GOAL * (1 - GOAL) / samples)
    within = np.abs(shares - GOAL) <= AWAY
    plain = np.abs(shares - GOAL) <= AWAY + 2.0 * noise
    print(f"{shares.size} coverages: mean {shares.mean():.4f}, {shares.min():.3f} to {shares.max():.3f};")
    print(
        f"{within.mean():.0%} within {AWAY:g} of {GOAL:g}, "
        f"{plain.mean():.1%} so or within 2 standard errors more"
    )
    for name in ("n", "sites", "shared_mm", "random_mm"):
        for level in sorted({getattr(one, name) for one in worlds}):
            rows = np.array([getattr(one, name) == level for one in worlds])
            own = noise / np.sqrt(rows.sum())
            told = "".join(f"{one:>7.3f}" for one in shares[rows].mean(axis=0))
            print(f"{name:>12} {level:>5g} {told}  each +- {own:.4f} (k = 1)")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("samples", nargs="?", type=int, default=1000)
    parser.add_argument("--grid", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--to", dest="last", type=int)
    given = parser.parse_args()
    chosen = (GRID if given.grid else WORLDS)[given.first : given.last]
    sys.exit(main(chosen, given.samples, given.seed))
