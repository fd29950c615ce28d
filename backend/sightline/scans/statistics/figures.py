"""Statistics of a survey's line scans from what is stored: errors, speeds, gaps, the paper's layout."""

from typing import Any

from sightline.infra.database import Session
from sightline.linescan.rig import rig_from
from sightline.recordings.filming import FilmedWithin
from sightline.scans.heights.store import list_scan_heights
from sightline.scans.records import Scan
from sightline.scans.statistics.heights import HeightSeen, ScannedHeights, scanned_heights
from sightline.scans.statistics.service import (
    GAPS,
    MOTION,
    ScanStatistics,
    VehicleMotion,
    statistics_of_seen,
    when_passed,
)
from sightline.scans.statistics.traffic import ScanTraffic, Watched, traffic_of_seen
from sightline.scans.store import list_scans
from sightline.scans.vehicles.listing import ShownVehicle, vehicles_of


def scan_statistics(
    session: Session, survey_id: int, *, accepted_only: bool, filmed: FilmedWithin = FilmedWithin()
) -> ScanStatistics:
    """Statistics of a survey's line scans; rejected vehicles never count, unreviewed ones where asked for."""
    found = [
        _seen(scan, one) for scan in list_scans(session, survey_id) for one in vehicles_of(session, scan.id)
    ]
    return statistics_of_seen(found, accepted_only=accepted_only, filmed=filmed)


def scan_traffic(
    session: Session,
    survey_id: int,
    minutes: int,
    *,
    accepted_only: bool,
    filmed: FilmedWithin = FilmedWithin(),
) -> tuple[ScanTraffic, ...]:
    """The traffic of a survey's line scans; speeds of unreviewed vehicles count where asked for."""
    found, watched = [], []
    for scan in list_scans(session, survey_id):
        found += [_seen(scan, one) for one in vehicles_of(session, scan.id)]
        watched_s = scan.lines and scan.lines / scan.rig.line_rate_hz
        clock = None if scan.clock is None else scan.clock.filming
        watched.append(Watched(scan.id, scan.name, clock, watched_s, scan.rig.line_rate_hz))
    return traffic_of_seen(watched, found, minutes, accepted_only=accepted_only, filmed=filmed)


def scan_height_statistics(
    session: Session, survey_id: int, *, accepted_only: bool, filmed: FilmedWithin = FilmedWithin()
) -> tuple[ScannedHeights, ...]:
    """The heights of a survey's line scans, target by target; rejected ones never count."""
    seen = []
    for scan in list_scans(session, survey_id):
        passed = vehicles_of(session, scan.id) if filmed.limits_time else ()
        within = {one.vehicle.id for one in passed if filmed.holds(_filmed_at(one))}
        for one in list_scan_heights(session, scan.id):
            values, u95 = one.values, one.values.U95_height_m
            stands = not one.withdrawn and (not filmed.limits_time or one.vehicle_id in within)
            if stands and values.height_m is not None and u95 is not None:
                seen.append(HeightSeen(values.target, one.review.verdict, values.height_m, u95))
    return scanned_heights(seen, accepted_only=accepted_only)


def _filmed_at(one: ShownVehicle) -> str:
    return "" if one.passing is None else one.passing.filmed_at


def _seen(scan: Scan, one: ShownVehicle) -> VehicleMotion:
    vehicle = one.vehicle
    values = None if vehicle.measurement is None else vehicle.measurement.values
    gap = {name: getattr(one.gap, name) for name in GAPS} if one.gap else {}
    where: dict[str, Any] = {}
    if values:
        ends = values.front_line_1, values.rear_line_1
        where = when_passed(rig_from(values.rig), *ends, values.reason)
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
        status=values.status if values else "not_measurable",
        reason=values.reason if values else None,
        filmed_at=_filmed_at(one),
        u_filmed_at_s=None if one.passing is None else one.passing.u_filmed_at_s,
        run_of=vehicle.run_of,
        references=tuple(given.values for given in one.references),
        direction=None if values is None else values.direction,
        lane=None if values is None else values.lane,
        axles=None if values is None else values.axles,
        **where,
    )
