"""How often a study's intervals hold the truth of a nation: `bench_nations.py [NATIONS] [--seed N]`.

Nations of strata with a known number of sites are made, each site with its own mix of two classes and its own
offset; some sites of each stratum are drawn, vehicles at each, measured with an error that a site shares, one
that all share and a random one; weights follow the draw and are then made to meet the nation's fleet. Truth
is the nation's own percentile, over all its sites. Goal: 0.95 +- 0.01; a share of N nations has itself a
standard error of 0.22 / sqrt(N).
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import optimize, stats

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.statistics.drawn import Drawn, share_of
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.survey_design import Design
from sightline.statistics.survey_weights import Margin, calibrate_weights
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

PERCENTS = (2.5, 10.0, 50.0, 90.0, 97.5)
CLASS_M = np.array([1.13, 1.30])  # mean height of cars, of tall ones
SPREAD_M = 0.055


@dataclass(frozen=True)
class Nation:
    """Sites of each stratum there are and are drawn, vehicles at each; errors and differences in mm."""

    there: tuple[int, ...]
    drawn: tuple[int, ...]
    vehicles: int
    apart_mm: float = 15.0
    pose_mm: float = 5.0
    all_mm: float = 3.0
    random_mm: float = 10.0
    to_fleet: bool = True


NATIONS = [
    Nation((4000,), (8,), 60),
    Nation((4000,), (20,), 30, to_fleet=False),
    Nation((16,), (8,), 60),
    Nation((8,), (8,), 60),
    Nation((900, 300, 100), (6, 4, 4), 60),
    Nation((900, 300, 100), (20, 10, 10), 25),
    Nation((12, 9, 6), (6, 5, 3), 60),
    Nation((40, 20), (5, 5), 100, apart_mm=0.0),
    Nation((400, 100), (12, 6), 100, pose_mm=15.0, random_mm=20.0),
]


def simulated(
    nation: Nation, rng: np.random.Generator
) -> tuple[np.ndarray, HeightSample, Design, np.ndarray]:
    """(truth of each percentile, the mean and the share of the tall), the sample, its design, who is tall."""
    offset, tall, stratum, weight = [], [], [], []
    for h, there in enumerate(nation.there):
        offset.append(rng.normal(0.0, nation.apart_mm / 1000, there) + 0.01 * h)
        tall.append(rng.beta(8.0 * (0.2 + 0.1 * h), 8.0 * (0.8 - 0.1 * h), there))
    all_offset, all_tall = np.concatenate(offset), np.concatenate(tall)

    def below(x: float) -> float:
        car = stats.norm.cdf(x, CLASS_M[0] + all_offset, SPREAD_M)
        high = stats.norm.cdf(x, CLASS_M[1] + all_offset, SPREAD_M)
        return float(np.mean((1.0 - all_tall) * car + all_tall * high))

    truth = [optimize.brentq(lambda x, p=p: below(x) - p / 100, 0.5, 2.5) for p in PERCENTS]
    truth += [float(np.mean((1 - all_tall) * CLASS_M[0] + all_tall * CLASS_M[1] + all_offset))]
    truth += [float(all_tall.mean())]
    heights, site, which, classes = [], 0, [], []
    common = rng.normal(0.0, nation.all_mm / 1000)
    for h, (there, drawn) in enumerate(zip(nation.there, nation.drawn, strict=True)):
        for one in rng.choice(there, drawn, replace=False):
            n = nation.vehicles
            is_tall = rng.random(n) < tall[h][one]
            true = CLASS_M[is_tall.astype(int)] + offset[h][one] + rng.normal(0.0, SPREAD_M, n)
            error = rng.normal(0.0, nation.pose_mm / 1000) + common
            heights.append(true + error + rng.normal(0.0, nation.random_mm / 1000, n))
            classes.append(is_tall)
            which.append(np.full(n, site))
            stratum.append(np.full(n, h))
            weight.append(np.full(n, there / drawn / n))
            site += 1
    height, code = np.concatenate(heights), np.concatenate(which)
    is_tall, drawn_weight = np.concatenate(classes), np.concatenate(weight)
    shared = [SharedErrors(code, np.full(len(height), nation.pose_mm / 1000))]
    shared.append(SharedErrors(np.zeros(len(height), np.int64), np.full(len(height), nation.all_mm / 1000)))
    sample = HeightSample(height, np.full(len(height), nation.random_mm / 1000), tuple(shared))
    fleet = (Margin(is_tall.astype(np.int64), np.array([1.0 - truth[-1], truth[-1]])),)
    to_fleet = calibrate_weights(drawn_weight, fleet) if nation.to_fleet else drawn_weight
    assert to_fleet is not None
    design = Design(
        weight=to_fleet,
        stratum=np.concatenate(stratum),
        site=code,
        sites_there=np.array(nation.there, dtype=float),
        margins=fleet if nation.to_fleet else (),
        drawn=drawn_weight,
    )
    return np.array(truth), sample, design, is_tall


def coverage(nation: Nation, nations: int, seed: int = 13) -> tuple[np.ndarray, np.ndarray]:
    """(share held, median half width mm) of percentiles, mean, and of the share of the tall if it is free."""
    rng = np.random.default_rng([seed, *nation.there, *nation.drawn, nation.vehicles])
    held, half = [], []
    for _ in range(nations):
        truth, sample, design, is_tall = simulated(nation, rng)
        figures = TotalUncertainty(sample, design)
        found = [*(figures.percentile(p) for p in PERCENTS), figures.mean(), share_of(Drawn(design), is_tall)]
        low = np.array([one.U95_low for one in found])
        high = np.array([one.U95_high for one in found])
        held.append((low <= truth + 1e-12) & (truth <= high + 1e-12))
        half.append(0.5 * (high - low))
    return np.mean(held, axis=0), 1000 * np.median(half, axis=0)


def main(nations: int, seed: int, only: int | None) -> int:
    print(f"{nations} nations each, seed {seed}; standard error {0.218 / np.sqrt(nations):.4f}")
    heads = [*(f"P{p:g}" for p in PERCENTS), "mean", "tall"]
    print(f"{'sites':<26}{'each':>5}" + "".join(f"{one:>8}" for one in heads) + "   half widths mm")
    every = []
    for nation in NATIONS if only is None else NATIONS[only : only + 1]:
        held, half = coverage(nation, nations, seed)
        every.append(held[:6])
        said = f"{'+'.join(map(str, nation.drawn))} of {'+'.join(map(str, nation.there))}"
        print(
            f"{said:<26}{nation.vehicles:>5}" + "".join(f"{one:>8.3f}" for one in held),
            " ",
            " ".join(f"{one:.0f}" for one in half[:6]),
            flush=True,
        )
    print(f"mean {np.mean(every):.4f}, least {np.min(every):.3f}, most {np.max(every):.3f}")
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("nations", nargs="?", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1, help="the method was made on 13")
    parser.add_argument("--only", type=int, help="one of the nations, by its place from 0")
    given = parser.parse_args()
    sys.exit(main(given.nations, given.seed, given.only))
