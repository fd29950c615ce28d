"""Statistics of a survey's line scans from what is stored: errors, speeds, gaps, the paper's layout."""

from __future__ import annotations

from sightline.coverage import expanded
from sightline.infra.database import Session
from sightline.scans.heights.store import list_line_heights
from sightline.scans.records import Scan
from sightline.scans.statistics.heights import HeightSeen, ScannedHeights, scanned_heights
from sightline.scans.statistics.service import GAPS, MOTION, ScanStatistics, VehicleMotion, statistics_of_seen
from sightline.scans.store import list_scans
from sightline.scans.vehicles.listing import ShownVehicle, shown
from sightline.scans.vehicles.store import list_scan_vehicles


def scan_statistics(session: Session, survey_id: int, *, accepted_only: bool) -> ScanStatistics:
    """Statistics of a survey's line scans; rejected vehicles never count, unreviewed ones where asked for."""
    found = [
        _seen(scan, one)
        for scan in list_scans(session, survey_id)
        for one in shown(scan, list_scan_vehicles(session, scan.id))
    ]
    return statistics_of_seen(found, accepted_only=accepted_only)


def scan_height_statistics(
    session: Session, survey_id: int, *, accepted_only: bool
) -> tuple[ScannedHeights, ...]:
    """The heights of a survey's line scans, target by target; rejected ones never count."""
    seen = []
    for scan in list_scans(session, survey_id):
        for one in list_line_heights(session, scan.id):
            values, u95 = one.values, expanded(one.values.u_height_m)
            if not values.withdrawn and values.height_m is not None and u95 is not None:
                seen.append(HeightSeen(values.target, one.review.verdict, values.height_m, u95))
    return scanned_heights(seen, accepted_only=accepted_only)


def _seen(scan: Scan, one: ShownVehicle) -> VehicleMotion:
    vehicle = one.vehicle
    values = None if vehicle.measurement is None else vehicle.measurement.values
    rig = values.rig if values else {"baseline_m": 1.0, "u_baseline_m": 0.0}
    gap = {name: getattr(one.gap, name) for name in GAPS} if one.gap else {}
    return VehicleMotion(
        vehicle_id=vehicle.id,
        scan_id=vehicle.scan_id,
        number=vehicle.number,
        state=vehicle.state,
        measured=values is not None and values.status == "ok",
        lighting=vehicle.lighting or scan.lighting or "unknown",
        values={**({name: getattr(values, name) for name in MOTION} if values else {}), **gap},
        known={
            "length_m": vehicle.true_length_m,
            "u_length_m": vehicle.u_true_length_m,
            "wheelbase_m": vehicle.true_wheelbase_m,
            "u_wheelbase_m": vehicle.u_true_wheelbase_m,
        },
        rig_baseline_m=rig["baseline_m"],
        rig_u_baseline_m=rig["u_baseline_m"],
        status=values.status if values else "not_measurable",
        reason=values.reason if values else None,
    )
