"""What a line camera is shown of a vehicle: as long as it is said to be, smooth, under a photograph."""

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.simulation.models import MODELS
from tests.simulation.scan_art import outline_ends, ribbon_of, row_edges_m
from tests.simulation.scan_traffic import Photograph, ScanSite, ScanVehicle, scan_body

pytestmark = pytest.mark.once
SITE = ScanSite(rows=64)


def grey(folder: Path) -> Photograph:
    """A photograph of one grey value, 77."""
    path = folder / "grey.png"
    cv2.imwrite(str(path), np.full((40, 60), 77, np.uint8))
    return Photograph(str(path), 0, 0, 20.0)


def vehicle(category: str, seed: int = 1) -> ScanVehicle:
    model = next(one for one in MODELS if one.category == category)
    return ScanVehicle(scan_body(1, model, np.random.default_rng(seed)), 1.0, 10.0, 0.0)


def lorry() -> ScanVehicle:
    return vehicle("lorry")


@pytest.mark.parametrize("photographed", [False, True], ids=["drawn", "photographed"])
@pytest.mark.parametrize(
    "category", ["hatchback", *(pytest.param(one, marks=pytest.mark.proof) for one in ("van", "lorry"))]
)
def test_half_of_what_is_drawn_lies_where_the_ends_are_said_to(
    category: str, photographed: bool, tmp_path: Path
) -> None:
    """Rows that lie within 2 cm of an end, each against the outline's mean in it."""
    car, site = vehicle(category), replace(SITE, rows=256)
    if photographed:
        car = replace(car, skin=grey(tmp_path))
    edges = row_edges_m(site, 1)
    parts = (edges[:-1, None] + np.diff(edges)[:, None] * (np.arange(8) + 0.5) / 8).ravel()
    ribbon = ribbon_of(car, site, 1)
    rear, front = (car.length_m - one.reshape(-1, 8).mean(axis=1) for one in outline_ends(car.shape, parts))
    inwards = np.arange(-0.02, 0.02, 0.0002)
    for truth_m, end, way in ((front, 0.0, 1), (rear, car.length_m, -1)):
        rows = np.flatnonzero(np.abs(truth_m - end) < 0.02)
        assert len(rows) > 20 and np.abs(truth_m[rows] - end).min() < 1e-4
        off = []
        for row in rows:
            along = truth_m[row] + way * inwards
            light, through = ribbon.mean(along - 5e-5, along + 5e-5)
            covered = light[:, row] / 77.0 if photographed else 1 - through[:, row]
            off.append(np.interp(0.5, covered, inwards))
        assert np.median(off) == pytest.approx(0.0, abs=1e-4)
        assert np.abs(np.percentile(off, (5, 95))).max() < 3e-4


def test_lines_finer_than_the_texture_change_by_little_from_one_to_the_next() -> None:
    edges = np.linspace(1.0, 2.0, 4001)
    light, _ = ribbon_of(lorry(), SITE, 1).mean(edges[:-1], edges[1:])
    change = np.abs(np.diff(light, axis=0))
    # upright bars would change in one line of ten
    assert change.max() < 6 * np.percentile(change, 98)


def test_a_photograph_covers_the_side(tmp_path: Path) -> None:
    car = replace(lorry(), skin=grey(tmp_path))
    light, through = ribbon_of(car, SITE, 1).mean(np.array([3.0, 4.0]), np.array([3.01, 4.01]))
    assert light[:, 20:28] == pytest.approx(77.0, abs=0.5)
    assert through[:, 20:28] == pytest.approx(0.0, abs=1e-3)
    with pytest.raises(FileNotFoundError):
        ribbon_of(replace(car, skin=Photograph(str(tmp_path / "none.png"), 0, 0, 20.0)), SITE, 1)
