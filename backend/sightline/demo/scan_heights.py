"""The demonstration's heights in its line scan: one clicks rod marks, roofs, eyes and lamps, one reviews."""

from collections.abc import Sequence

import numpy as np

from sightline.demo.made import HeldRod, truth
from sightline.enums import DriverSide
from sightline.infra.database import Session
from sightline.measurements.records import Clicks
from sightline.reviews.store import add_review
from sightline.scans.heights import poses
from sightline.scans.heights.poses import Mark, Rod
from sightline.scans.heights.service import store_scan_height
from sightline.scans.heights.store import list_scan_heights
from sightline.scans.vehicles.store import list_scan_vehicles

MARK_SIGMA_PX, CLICK_SIGMA_PX, TAPE_SIGMA_M = 0.5, 1.0, 0.005
# by the order of passing: those whose heights are clicked
CLICKED = range(6)
# those of the vehicle that was clicked last wait for a verdict
_WAITING = 1


def store_heights(session: Session, scan_id: int, operator: int) -> None:
    """Store the rod's calibration and the heights of some vehicles, clicked with the scatter of a hand."""
    rng = np.random.default_rng(20261109)
    true_of = truth().scan
    rod = clicked_rod(true_of.rods, rng)
    poses.store_line_pose(session, scan_id, rod, seen_revision=0, actor=operator)
    for vehicle in list_scan_vehicles(session, scan_id):
        if vehicle.measurement is None:
            continue
        order, true = true_of.nearest(vehicle.measurement.values.front_line_1)
        if order not in CLICKED:
            continue
        contact = _scatter_click(true.contact, rng)
        for name, spot in true.targets.items():
            # the operator sees the drivers of the scan on the side of the camera
            side: DriverSide | None = "near" if name == "driver_eye" else None
            spot = _scatter_click(spot, rng)
            clicked = Clicks(target=name, contact=contact, target_point=spot, side=side)
            store_scan_height(session, vehicle.id, clicked, seen_revision=0, actor=operator)


def review_heights(session: Session, scan_id: int, reviewer: int) -> None:
    """The other person accepts the heights, but for those of the vehicle that was clicked last."""
    heights = [one for one in list_scan_heights(session, scan_id) if one.values.status == "ok"]
    clicked = list(dict.fromkeys(one.vehicle_id for one in heights))
    for one in heights:
        if one.vehicle_id in clicked[:-_WAITING]:
            add_review(session, one.id, seen_revision=one.revision, verdict="accepted", actor=reviewer)


def clicked_rod(rods: Sequence[HeldRod], rng: np.random.Generator) -> Rod:
    """The rod's marks as a person taped and clicked them."""
    marks = []
    for rod in rods:
        taped_m = round(rod.distance_m + float(rng.normal(0.0, TAPE_SIGMA_M)), 3)
        for height_m, row in rod.marks:
            clicked = row + float(rng.normal(0.0, MARK_SIGMA_PX))
            marks.append(Mark(taped_m, height_m, round(clicked, 2), round(rod.line, 1)))
    return Rod(tuple(marks), sigma_px=MARK_SIGMA_PX, u_distance_m=TAPE_SIGMA_M)


def _scatter_click(place: tuple[float, float], rng: np.random.Generator) -> tuple[float, float]:
    """A click beside a place; a line is a twentieth of a row wide."""
    line = place[0] + float(rng.normal(0.0, 2.0))
    return round(line, 1), round(place[1] + float(rng.normal(0.0, CLICK_SIGMA_PX)), 2)
