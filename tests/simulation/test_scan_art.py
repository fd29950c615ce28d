"""What a line camera is shown of a vehicle: as long as it is said to be, smooth, under a photograph."""

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.simulation.models import MODELS
from tests.simulation.scan_art import ribbon_of
from tests.simulation.scan_traffic import Photograph, ScanSite, ScanVehicle, scan_body

pytestmark = pytest.mark.once
SITE = ScanSite(rows=64)


def lorry() -> ScanVehicle:
    model = next(one for one in MODELS if one.category == "lorry")
    return ScanVehicle(scan_body(1, model, np.random.default_rng(1)), 1.0, 10.0, 0.0)


def test_a_flat_front_and_rear_lie_where_they_are_said_to() -> None:
    car = lorry()
    ribbon = ribbon_of(car, SITE, 1)
    # rows of the cab's front and of the box's rear
    for truth_m, inwards, rows in ((0.0, 1, range(36, 44)), (car.length_m, -1, range(10, 30))):
        along = truth_m + inwards * np.arange(-0.02, 0.03, 0.0002)
        _, through = ribbon.mean(along - 5e-5, along + 5e-5)
        half = [np.interp(0.5, 1 - through[:, row], along * inwards) for row in rows]
        assert np.median(half) == pytest.approx(truth_m * inwards, abs=5e-4)


def test_lines_finer_than_the_texture_change_by_little_from_one_to_the_next() -> None:
    edges = np.linspace(1.0, 2.0, 4001)
    light, _ = ribbon_of(lorry(), SITE, 1).mean(edges[:-1], edges[1:])
    change = np.abs(np.diff(light, axis=0))
    # upright bars would change in one line of ten
    assert change.max() < 6 * np.percentile(change, 98)


def test_a_photograph_covers_the_side(tmp_path: Path) -> None:
    path = tmp_path / "grey.png"
    cv2.imwrite(str(path), np.full((40, 60), 77, np.uint8))
    car = replace(lorry(), skin=Photograph(str(path), 0, 0, 20.0))
    light, through = ribbon_of(car, SITE, 1).mean(np.array([3.0, 4.0]), np.array([3.01, 4.01]))
    assert light[:, 20:28] == pytest.approx(77.0, abs=0.5)
    assert through[:, 20:28] == pytest.approx(0.0, abs=1e-3)
    with pytest.raises(FileNotFoundError):
        ribbon_of(replace(car, skin=Photograph(str(tmp_path / "none.png"), 0, 0, 20.0)), SITE, 1)
