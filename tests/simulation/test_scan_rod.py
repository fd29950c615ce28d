"""The line scan's rod and the depth of its vehicles: drawn by similar triangles, measured as it is."""

from dataclasses import replace

import numpy as np
import pytest

from sightline.demo.made import HeldRod as SeenRod
from sightline.demo.scan_heights import CLICK_SIGMA_PX, clicked_rod
from sightline.linescan.line_height import line_height
from sightline.scans.heights.poses import preview_line_pose, solve
from tests.simulation.make import contact_of, held_rods, targets_of
from tests.simulation.scan_rod import LIGHT_DN, HeldRod, row_of
from tests.simulation.scan_strips import empty_line, strips
from tests.simulation.scan_traffic import ScanSite, demo_traffic, truths
from tests.simulation.truth import spots_of

SITE = ScanSite(rows=256, line_rate_hz=2441.4, read_noise_dn=0.5, row_gain=0.0, plane_m=3.0)
INSETS = {"roof": (0.30, 0.10), "driver_eye": (0.45, 0.10), "taillight": (0.05, 0.05)}

pytestmark = pytest.mark.once


def edge_near(line: np.ndarray, row: float, level: float) -> float:
    """Where a line of pixels crosses a level, to a fraction of a row, nearest to a row."""
    above = line > level
    at = np.flatnonzero(above[1:] != above[:-1])
    places = at + (level - line[at]) / (line[at + 1] - line[at])
    return float(places[np.argmin(np.abs(places - row))])


def test_the_rods_bands_are_drawn_where_they_are() -> None:
    rods = (HeldRod(2.7, 0.05, 0.15), HeldRod(4.5, 0.2, 0.3))
    first, second = strips(SITE, (), 0.4, rods)
    for rod, inside in zip(rods, (slice(150, 340), slice(510, 700)), strict=True):
        line = first[inside].mean(0)
        for height_m in (0.25, 0.5, 1.0, 1.75):
            row = row_of(SITE, rod.distance_m, height_m)
            assert edge_near(line, row, line[int(row) - 8 : int(row) + 9].mean()) == pytest.approx(
                row, abs=0.35
            )
    # nothing stands in camera 2's plane
    assert second.max() < 1.1 * empty_line(SITE, 2).max() < 1.1 * LIGHT_DN


def test_a_roof_is_seen_where_its_inset_puts_it() -> None:
    car = replace(demo_traffic()[0], front_s=0.2, speed_mps=15.0, acceleration_mps2=0.0)
    true = truths(SITE, (car,))[0]
    line, row = targets_of(SITE, true)["roof"]
    first, _ = strips(SITE, (car,))
    empty = first[5:200].mean(0)
    column = first[int(line) - 15 : int(line) + 15].mean(0)
    top = int(np.flatnonzero(np.abs(column - empty) > 6)[0])
    assert abs(top - row) < 1.6
    flat, _ = strips(replace(SITE, plane_m=None), (car,))
    flat_top = int(np.flatnonzero(np.abs(flat[int(line) - 15 : int(line) + 15].mean(0) - empty) > 6)[0])
    assert top > flat_top  # what lies deeper and above the camera is seen lower


def test_heights_of_all_its_vehicles_are_the_truth_within_their_uncertainty() -> None:
    rng = np.random.default_rng(5)
    rods = [SeenRod(**rod) for rod in held_rods(SITE)]
    shares, distances = [], []
    for true in truths(SITE, demo_traffic()):
        rod = clicked_rod(rods, rng)
        assert preview_line_pose(rod).status == "ok" and preview_line_pose(rod).warnings == ()
        pose = solve(rod)
        heights = {spot.name: spot.height_m for spot in spots_of(true.vehicle.vehicle)}
        for name, (_, row) in targets_of(SITE, true).items():
            inset_m, u_inset_m = INSETS[name]
            contact = contact_of(SITE, true)[1] + float(rng.normal(0, CLICK_SIGMA_PX))
            found = line_height(
                pose,
                contact,
                row + float(rng.normal(0, CLICK_SIGMA_PX)),
                inset_m=inset_m,
                u_inset_m=u_inset_m,
            )
            assert found.status == "ok" and found.height_m is not None and found.U95_height_m is not None
            shares.append((found.height_m - heights[name]) / found.U95_height_m)
            assert found.distance_m is not None and found.u_distance_m is not None
            distances.append((found.distance_m - 3.0) / found.u_distance_m)
    assert len(shares) > 35
    assert np.mean(np.abs(shares) < 1) >= 0.9 and np.max(np.abs(shares)) < 1.8
    assert 0.6 < np.sqrt(np.mean(np.square(distances))) < 1.4
