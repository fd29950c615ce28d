"""How often total intervals hold the truth: `bench_coverage.py [SAMPLES] [--full] [--write] [--seed N]`.

Fleets whose percentiles are known are drawn, measured with errors that sites share and with random ones, and
the share of samples whose 95 % interval holds the truth is printed, for each percentile, the mean and the SD.
Goal: 0.95 +- 0.01 for P2.5 to P97.5; a share of SAMPLES samples has itself a standard error of 0.22 /
sqrt(SAMPLES). The default is a few worlds of every kind; `--full`: the whole grid, each fleet with each n,
sites, shared and random error; `--gap`: P95 where there is no vehicle, and beside it fleets without a gap;
`--apart`: sites that differ more and more, up to twice as much as their vehicles.
`--write` puts the table of either into docs/proofs.md. The method was made on
other seeds than any that `--seed` gives (its worlds had the same numbers and no seed before them).
"""

from __future__ import annotations

import argparse
import itertools
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import integrate, optimize, stats

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.statistics.distributions import vehicles_for_interval
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty
from tests.bench.proofs_page import put_section

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
    one error, not each its own; said: whether the sites are named to the estimate. lorries_sd: of the share
    of lorries from site to site, where the fleet is "5 % lorries".
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
    lorries_sd: float = 0.0


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

GAPS = [
    World(fleet, 1000, j, 10, 10, lorries_sd=sd)
    for fleet, sd in (("5 % lorries", 0.0), ("5 % lorries", 0.02), ("normal", 0.0), ("skewed", 0.0))
    for j in (1, 3, 5, 20)
    if j > 1 or not sd
]
GAPS += [World("normal", 1000, j, 10, 10, apart_mm=apart) for apart in (20, 50) for j in (3, 5)]
APART = [
    World(fleet, 1000, j, 10, 0, apart_mm=apart)
    for fleet in ("normal", "skewed")
    for apart in (0, 20, 35, 50, 80, 150)
    for j in (3, 5, 10, 20)
]
GRID = [World(*one) for one in itertools.product(FLEETS, (100, 400, 2000), (1, 2, 5, 20), (0, 15), (0, 20))]
FACTORS = ("fleet", "n", "sites", "shared_mm", "random_mm")


def truth_of(world: World, percents: tuple[float, ...] = PERCENTS) -> np.ndarray:
    """Percentiles, mean and SD of the fleet over all sites that there might be."""
    fleet, apart = FLEETS[world.fleet], world.apart_mm / 1000
    nodes, weights = np.polynomial.hermite_e.hermegauss(41)

    def below(x: float) -> float:
        return float(weights @ fleet.below(x - apart * nodes) / weights.sum())

    found = [optimize.brentq(lambda x, p=p: below(x) - p / 100, 0.0, 4.0) for p in percents]
    mean = integrate.quad(lambda x: 1.0 - below(x), 0.0, 4.0, limit=400)[0]
    square = 2.0 * integrate.quad(lambda x: x * (1.0 - below(x)), 0.0, 4.0, limit=400)[0]
    return np.array([*found, mean, np.sqrt(square - mean**2)])


def sample_of(world: World, rng: Rng) -> HeightSample:
    share = np.arange(1.0, world.sites + 1.0) if world.uneven else np.ones(world.sites)
    site = np.sort(rng.choice(world.sites, world.n, p=share / share.sum()))
    if not world.uneven:
        site = np.sort(np.arange(world.n) % world.sites)
    true = FLEETS[world.fleet].draw(rng, world.n)
    if world.lorries_sd:
        sure = 0.05 * 0.95 / world.lorries_sd**2 - 1.0
        lorry = rng.random(world.n) < rng.beta(0.05 * sure, 0.95 * sure, world.sites)[site]
        true = np.where(lorry, rng.normal(2.3, 0.12, world.n), rng.normal(1.14, 0.05, world.n))
    true = true + rng.normal(0.0, 1.0, world.sites)[site] * world.apart_mm / 1000
    group = np.zeros_like(site) if world.common else site
    u_shared, u_random = world.shared_mm / 1000, world.random_mm / 1000
    error = rng.normal(0.0, 1.0, world.sites)[group] * u_shared + rng.normal(0.0, 1.0, world.n) * u_random
    shared = (SharedErrors(group, np.full(world.n, u_shared)),) if u_shared else ()
    return HeightSample(true + error, np.full(world.n, u_random), shared, site if world.said else None)


def coverage(
    world: World, samples: int, seed: int = 1, percents: tuple[float, ...] = PERCENTS
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(share held, mean error of the values mm, median half width mm), each for percentiles, mean, SD."""
    rng = np.random.default_rng([seed, world.n, world.sites, int(world.shared_mm), int(world.random_mm)])
    truth = truth_of(world, percents)
    held, error, half = [], [], []
    for _ in range(samples):
        found = TotalUncertainty(sample_of(world, rng))
        figures = [*(found.percentile(p) for p in percents), found.mean(), found.sd()]
        value, low, high = (
            np.array([getattr(one, name) for one in figures], dtype=np.float64)  # NaN without support
            for name in ("value", "U95_low", "U95_high")
        )
        held.append(np.where(np.isnan(low), np.nan, (low <= truth) & (truth <= high)))
        error.append(value - truth)
        half.append(0.5 * (high - low))
    return np.mean(held, axis=0), 1000 * np.mean(error, axis=0), 1000 * np.median(half, axis=0)


def main(worlds: list[World], samples: int, seed: int, write: bool) -> int:
    heads = [*(f"P{p:g}" for p in PERCENTS), "mean", "SD"]
    print(f"{samples} samples each, seed {seed}; standard error {_error(samples):.4f}")
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
    found = np.array(shares)
    lines = summary(worlds, found, samples)
    print("\n".join(lines))
    if write:
        put_section(page(worlds, found, samples, seed))
    return 0


def show_sites(worlds: list[World], introduction: list[str], samples: int, seed: int, write: bool) -> int:
    """P5 to P95 by what sites differ in and by their number."""
    percents = (5.0, 15.0, 50.0, 85.0, 90.0, 95.0)
    names = " | ".join(f"P{p:g}" for p in percents)
    lines = [
        f"| fleet | SD of lorries | between sites mm | sites | {names} | half of P95 mm |",
        "| --- " + "| ---: " * (4 + len(percents)) + "|",
    ]
    print("\n".join(lines))
    for world in worlds:
        held, _, half = coverage(world, samples, seed, percents)
        *shares, wide = *(f"{one:.3f}" for one in held[: len(percents)]), f"{half[len(percents) - 1]:.0f}"
        between = f"{world.apart_mm:g}"
        cells = [world.fleet, f"{world.lorries_sd:g}", between, str(world.sites), *shares, wide]
        lines.append(f"| {' | '.join(cells)} |")
        print(lines[-1], flush=True)
    if write:
        told = f"{samples} samples each, seed {seed}: a share has a standard error of {_error(samples):.3f}."
        put_section("\n".join([*introduction, "", told, "", *lines, ""]))
    return 0


def _error(samples: float) -> float:
    """Standard error of a share of so many samples that is as it should be."""
    return float(np.sqrt(GOAL * (1 - GOAL) / samples))


def summary(worlds: list[World], shares: np.ndarray, samples: int) -> list[str]:
    """All coverages, then those of each level of each factor: means of many samples tell 0.01 apart."""
    there = shares[np.isfinite(shares)]
    within = np.abs(there - GOAL) <= AWAY
    plain = np.abs(there - GOAL) <= AWAY + 2.0 * _error(samples)
    lines = [
        f"{there.size} coverages: mean {there.mean():.4f}, {there.min():.3f} to {there.max():.3f};",
        f"{within.mean():.0%} within {AWAY:g} of {GOAL:g}, {plain.mean():.1%} so or within 2 standard errors "
        "more.",
    ]
    for name, level, mean, error in levels(worlds, shares, samples):
        told = "".join(f"{one:>7.3f}" for one in mean)
        lines.append(f"{name:>12} {level!s:>11} {told}  each +- {error:.4f} (k = 1)")
    return lines


def levels(
    worlds: list[World], shares: np.ndarray, samples: int
) -> Iterator[tuple[str, object, np.ndarray, float]]:
    """(factor, level, mean coverage of each percentile, its standard error where all have support)."""
    for name in FACTORS:
        for level in dict.fromkeys(getattr(one, name) for one in worlds):
            rows = np.array([getattr(one, name) == level for one in worlds])
            there = np.isfinite(shares[rows])
            total = np.nansum(np.where(there, shares[rows], 0.0), axis=0)
            n = there.sum(axis=0)
            mean = np.where(n > 0, total / np.maximum(n, 1), np.nan)
            yield name, level, mean, _error(samples * rows.sum())


def page(worlds: list[World], shares: np.ndarray, samples: int, seed: int) -> str:
    """docs/proofs.md: the table, what misses, and how it is made again."""
    error = _error(samples)
    missed = [
        f"- {world.fleet}, n {world.n}, {world.sites} sites, shared {world.shared_mm:g} mm, random "
        f"{world.random_mm:g} mm, P{percent:g}: {share:.3f}"
        for world, row in zip(worlds, shares, strict=True)
        for percent, share in zip(PERCENTS, row, strict=True)
        if abs(share - GOAL) > AWAY + 2.0 * error
    ]
    of_levels = list(levels(worlds, shares, samples))
    far = [
        f"- {name.removesuffix('_mm')} {level}, P{percent:g}: {share:.3f} (standard error {own:.3f})"
        for name, level, mean, own in of_levels
        for percent, share in zip(PERCENTS, mean, strict=True)
        if abs(share - GOAL) > AWAY
    ]
    chance = stats.norm.sf(2.0 + AWAY / error) * 2.0 * np.isfinite(shares).sum()
    percents = " | ".join(f"P{p:g}" for p in PERCENTS)
    head = f"| fleet | n | sites | shared mm | random mm | {percents} |"
    drawn = f"{len(worlds)} worlds" + ("" if len(worlds) == len(GRID) else f" of {len(GRID)}")
    rule = "| --- " + "| ---: " * (4 + len(PERCENTS)) + "|"
    return "\n".join(
        [
            *_INTRODUCTION,
            "",
            f"{samples} samples of each of {drawn}, seed {seed}. A share has itself a standard error of "
            f"{error:.3f}.",
            *summary(worlds, shares, samples)[:2],
            "",
            "## What misses 0.95 ± 0.01",
            "",
            "By factor, the mean over all worlds of a level, which many samples tell apart:",
            "",
            *(far or ["- none"]),
            "",
            f"Single cells beyond 0.01 and two standard errors more ({chance:.0f} would be by chance alone):",
            "",
            *(missed or ["- none"]),
            "",
            "## By factor",
            "",
            f"| factor | level | {percents} |",
            "| --- | ---: " + "| ---: " * len(PERCENTS) + "|",
            *(
                f"| {name.replace('_mm', ', mm')} | {level} | {' | '.join(map(_cell, mean, PERCENTS))} |"
                for name, level, mean, _ in of_levels
            ),
            "",
            "## Every cell",
            "",
            head,
            rule,
            *(
                f"| {one.fleet} | {one.n} | {one.sites} | {one.shared_mm:g} | {one.random_mm:g} | "
                + " | ".join(map(_cell, row, PERCENTS))
                + " |"
                for one, row in zip(worlds, shares, strict=True)
            ),
            "",
        ]
    )


def _cell(share: float, percent: float) -> str:
    return f"needs {vehicles_for_interval(percent)}" if np.isnan(share) else f"{share:.3f}"


_INTRODUCTION = """
# Proofs

How often total 95 % intervals of percentiles hold the truth, by simulation: fleets whose percentiles are
known are measured with errors that all heights of a site share and with random ones. Goal: 0.95 ± 0.01.
Made by `python tests/bench/bench_coverage.py SAMPLES --full --write`; do not edit by hand.

One engine gives the figures of a survey and of a study (a survey is a study of one stratum in which all
heights weigh alike). Values and ends of percentiles are put in order from the median outwards, so that none
runs backwards. A percentile that has fewer heights than an interval of order statistics needs has no
value; the cell says how many it needs.

""".strip("\n").splitlines()


_GAPS = """
# Percentiles in a gap

How often the same intervals hold P95 where it lies between two kinds of vehicles (5 % lorries among cars: no
vehicle is as high), and other percentiles of the same samples: 1,000 heights, errors of 10 mm that a site
shares and random ones of 10 mm. Made by `python tests/bench/bench_coverage.py SAMPLES --gap --write`.

**Derivation.** Let F(x) be the share of heights below x on all roads, q its percentile p, z = Φ⁻¹(F(x)) the
normal score of a height. q lies below x exactly where p lies below F(x): limits of the rank p, carried back
by the sample's quantiles, are limits of q whatever the distribution (Woodruff 1952; Francisco and Fuller
1991; Särndal, Swensson and Wretman 1992, 5.11). So the error of the rank, with the variance that the design
gives the share below (within sites that of p (1 - p), between them what they differ by) and Student's t, is
laid off from Φ⁻¹(p) on the scale of scores and read as heights there. Every distribution is normal on that
scale: where heights are normal the limits are those of the linear influence, and those of any other are their
image; where sites differ in nothing, a percentile in a gap is held as often as one of normal heights. Beyond
the outermost height the scale is that of a normal distribution through it and the median, no wider than at
the percentile.

Errors of pose and clicks that a site shares move heights, not ranks. They make the part b² of the variance σ²
between sites (their known u). With T and T' a pair of Student's t over one estimate of σ (Ding 2016), the
error of the rank is (1 - b²) T - b √(1 - b²) T' and the shift b² T + b √(1 - b²) T', in σ: uncorrelated, of
variances 1 - b² and b², and their sum is T. Where the quantiles are a line nothing changes by it; at a gap
the rank jumps and the shift is no more than it is. Errors that sites do not show are added in metres.

Where sites differ by more than the vehicles of one do, the highest heights all come of one site, and its
quantiles say nothing of heights that no site has. So sites are compared by a narrow window of scores and by a
wide one (half a score), of which the larger variance counts, and on either side of the percentile the error
as it is, in metres, counts where it goes further than the one read through the quantiles.
""".strip("\n").splitlines()

_APART = """
# Sites that differ as their vehicles do

How often the same intervals hold percentiles where sites differ more and more, by a normal distribution:
1,000 heights, 60 mm (standard deviation) at a site, errors of 10 mm that a site shares. Few sites say little
of how far sites lie apart, and their highest heights are those of one of them: from some half of the
vehicles' spread on, that on the narrower side of a skewed fleet, intervals far from the median hold less
often than they say, which is said beside them (`TotalUncertainty.sites_are_unlike`). To leave such intervals
out would not do: where five unlike sites lie near each other by chance, their intervals are the worst. Made
by `python tests/bench/bench_coverage.py SAMPLES --apart --write`.
""".strip("\n").splitlines()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("samples", nargs="?", type=int, default=20)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--gap", action="store_true")
    parser.add_argument("--apart", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    if given.gap or given.apart:
        worlds, introduction = (GAPS, _GAPS) if given.gap else (APART, _APART)
        sys.exit(show_sites(worlds, introduction, given.samples, given.seed, given.write))
    chosen = GRID if given.full else GRID[::7] if given.write else WORLDS
    sys.exit(main(chosen, given.samples, given.seed, given.write))
