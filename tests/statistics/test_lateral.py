"""Lateral positions: one of each vehicle, by lane and class, against plain Python on a drawn fleet."""

import statistics
from collections import defaultdict

import numpy as np
import pytest

from sightline.statistics.lateral import lateral_positions

LANES, CLASSES = ("right", "left"), ("hatchback", "van")


def test_one_of_each_vehicle_by_lane_and_class() -> None:
    rng = np.random.default_rng(5)
    rows = []
    for vehicle in range(60):
        lane, of = int(rng.integers(-1, 2)), int(rng.integers(-1, 2))
        place = (3.2, 6.4, 5.0)[lane] + 0.2 * rng.standard_normal()
        for _ in range(int(rng.integers(1, 4))):
            rows.append((place + 0.01 * rng.standard_normal(), vehicle, lane, of))
    rows.append((float("nan"), 99, 0, 0))
    rng.shuffle(rows)
    across, vehicle, lane, of = (np.array(one) for one in zip(*rows, strict=True))
    found = lateral_positions(across, vehicle.astype(int), lane.astype(int), of.astype(int), LANES, CLASSES)
    seen: dict[tuple[int, int, int], list[float]] = defaultdict(list)
    for at, which, l_, c_ in rows:
        if at == at:
            seen[int(which), int(l_), int(c_)].append(at)
    middle = {key: statistics.median(places) for key, places in seen.items()}
    assert found.all.n == 60
    assert found.all.mean_m == pytest.approx(statistics.fmean(middle.values()))
    for k, word in enumerate(LANES):
        mine = [at for (_, l_, _), at in middle.items() if l_ == k]
        assert found.lanes.of[word].n == len(mine)
        assert found.lanes.of[word].sd_m == pytest.approx(statistics.stdev(mine))
        for j, name in enumerate(CLASSES):
            few = [at for (_, l_, c_), at in middle.items() if (l_, c_) == (k, j)]
            assert found.classes[word].of[name].mean_m == pytest.approx(statistics.fmean(few))


def test_nothing_known_gives_nothing() -> None:
    none = np.zeros(0, dtype=int)
    found = lateral_positions(np.zeros(0), none, none, none, LANES, CLASSES)
    assert (found.all.n, found.lanes.of, found.classes) == (0, {}, {})
