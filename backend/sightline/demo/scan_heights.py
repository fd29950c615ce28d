"""The demonstration's heights in its line scan: one clicks rod marks, roofs, eyes and lamps, one reviews."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

import numpy as np

from sightline.enums import DriverSide, Target
from sightline.infra.database import Session
from sightline.measurements.records import Clicks
from sightline.scans.heights import poses
from sightline.scans.heights.poses import Mark, Rod
from sightline.scans.heights.service import review_scan_height, store_scan_height
from sightline.scans.heights.store import list_scan_heights
from sightline.scans.vehicles.store import list_scan_vehicles
from sightline.simulation.scan_rod import HeldRod, row_of
from sightline.simulation.scan_traffic import ScanSite, ScanTruth
from sightline.simulation.truth import TARGETS, spots_of

# Held up before the first vehicle: the nearest at which its foot and top are in the field, and the far edge.
RODS = (HeldRod(2.7, 1.3, 2.0), HeldRod(4.5, 2.9, 3.6))
MARK_SIGMA_PX, CLICK_SIGMA_PX, TAPE_SIGMA_M = 0.5, 1.0, 0.005
# by the order of passing: those whose heights are clicked
CLICKED = range(6)
# those of the vehicle that was clicked last wait for a verdict
_WAITING = 1
_MARGIN_ROWS = 4.0


def store_heights(
    session: Session, scan_id: int, site: ScanSite, truth: Sequence[ScanTruth], operator: int
) -> None:
    """Store the rod's calibration and the heights of some vehicles, clicked with the scatter of a hand."""
    rng = np.random.default_rng(20261109)
    poses.store_line_pose(session, scan_id, clicked_rod(site, rng), seen_revision=0, actor=operator)
    for one in list_scan_vehicles(session, scan_id):
        if one.measurement is None:
            continue
        front = one.measurement.values.front_line_1
        order, true = min(enumerate(truth), key=lambda each: abs(each[1].front_line_1 - front))
        if order not in CLICKED:
            continue
        contact = _off(contact_of(site, true), rng)
        for name, spot in targets_of(site, true).items():
            clicked = Clicks(target=name, contact=contact, target_point=_off(spot, rng), side=_side(name))
            store_scan_height(session, one.id, clicked, seen_revision=0, actor=operator)


def review_heights(session: Session, scan_id: int, reviewer: int) -> None:
    """The other person accepts the heights, but for those of the vehicle that was clicked last."""
    heights = [one for one in list_scan_heights(session, scan_id) if one.values.status == "ok"]
    clicked = list(dict.fromkeys(one.vehicle_id for one in heights))
    for one in heights:
        if one.vehicle_id in clicked[:-_WAITING]:
            review_scan_height(session, one.id, revision=one.revision, verdict="accepted", actor=reviewer)


def _side(name: Target) -> DriverSide | None:
    """The operator sees the drivers of the scan on the side of the camera."""
    return "near" if name == "driver_eye" else None


def clicked_rod(site: ScanSite, rng: np.random.Generator) -> Rod:
    """The rod's marks as a person taped and clicked them."""
    marks = []
    for rod in RODS:
        taped_m = round(rod.distance_m + float(rng.normal(0.0, TAPE_SIGMA_M)), 3)
        line = (rod.from_s + rod.to_s) / 2 * site.line_rate_hz
        for height_m in rod.marks_m:
            row = row_of(site, rod.distance_m, height_m) + float(rng.normal(0.0, MARK_SIGMA_PX))
            marks.append(Mark(taped_m, height_m, round(row, 2), round(line, 1)))
    return Rod(tuple(marks), sigma_px=MARK_SIGMA_PX, u_distance_m=TAPE_SIGMA_M)


def contact_of(site: ScanSite, true: ScanTruth) -> tuple[float, float]:
    """(line, row) in strip 1 where the rear wheel stands on the road."""
    assert site.plane_m is not None
    return true.wheel_lines_1[1], row_of(site, site.plane_m, 0.0)


def targets_of(site: ScanSite, true: ScanTruth) -> dict[Target, tuple[float, float]]:
    """(line, row) in strip 1 of each target that the field of view holds."""
    assert site.plane_m is not None
    found: dict[Target, tuple[float, float]] = {}
    for spot in spots_of(true.vehicle.vehicle):
        row = row_of(site, site.plane_m + spot.inset_m, spot.height_m)
        if spot.name in TARGETS and row > _MARGIN_ROWS:
            time_s = true.vehicle.time_s(true.vehicle.length_m - spot.along_m)
            found[cast(Target, spot.name)] = (time_s * site.line_rate_hz, row)
    return found


def _off(place: tuple[float, float], rng: np.random.Generator) -> tuple[float, float]:
    """A click beside a place; a line is a twentieth of a row wide."""
    line = place[0] + float(rng.normal(0.0, 2.0))
    return round(line, 1), round(place[1] + float(rng.normal(0.0, CLICK_SIGMA_PX)), 2)
