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
    KNOWN_SIZES,
    MOTION,
    ScanStatistics,
    VehicleMotion,
    statistics_of_seen,
    when_passed,
)
from sightline.scans.statistics.traffic import Seen, Watched, seen_in_each
from sightline.scans.store import list_scans
from sightline.scans.vehicles.listing import ShownVehicle, vehicles_of


def scan_statistics(
    session: Session, survey_id: int, *, accepted_only: bool, filmed: FilmedWithin = FilmedWithin()
) -> ScanStatistics:
    """Statistics of a survey's line scans; rejected vehicles never count, unreviewed ones where asked for."""
    found = [
        _motion_of_vehicle(scan, one)
        for scan in list_scans(session, survey_id)
        for one in vehicles_of(session, scan.id)
    ]
    return statistics_of_seen(found, accepted_only=accepted_only, filmed=filmed)


def scans_seen(session: Session, survey_id: int, filmed: FilmedWithin = FilmedWithin()) -> list[Seen]:
    """A survey's line scans with their vehicles, as their traffic is counted."""
    motions, watched = [], []
    for scan in list_scans(session, survey_id):
        motions += [_motion_of_vehicle(scan, one) for one in vehicles_of(session, scan.id)]
        watched_s = scan.lines and scan.lines / scan.rig.line_rate_hz
        clock = None if scan.clock is None else scan.clock.filming
        strip, video = scan.first_sha256 or "", str(scan.recording_id or "")
        watched.append(
            Watched(scan.id, scan.name, clock, watched_s, rig=scan.rig, strip_sha256=strip, video=video)
        )
    return seen_in_each(watched, motions, filmed)


def scan_height_statistics(
    session: Session, survey_id: int, *, accepted_only: bool, filmed: FilmedWithin = FilmedWithin()
) -> tuple[ScannedHeights, ...]:
    """The heights of a survey's line scans, target by target; rejected ones never count."""
    heights = []
    for scan in list_scans(session, survey_id):
        passed = vehicles_of(session, scan.id) if filmed.limits_time else ()
        within = {one.vehicle.id for one in passed if filmed.holds(_filmed_at(one))}
        for height in list_scan_heights(session, scan.id):
            values, u95 = height.values, height.values.U95_height_m
            stands = not height.withdrawn and (not filmed.limits_time or height.vehicle_id in within)
            if stands and values.height_m is not None and u95 is not None:
                heights.append(HeightSeen(values.target, height.review.verdict, values.height_m, u95))
    return scanned_heights(heights, accepted_only=accepted_only)


def _filmed_at(one: ShownVehicle) -> str:
    return "" if one.passing is None else one.passing.filmed_at


def _motion_of_vehicle(scan: Scan, shown: ShownVehicle) -> VehicleMotion:
    vehicle = shown.vehicle
    values = None if vehicle.measurement is None else vehicle.measurement.values
    gap = {name: getattr(shown.gap, name) for name in GAPS} if shown.gap else {}
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
        known={name: getattr(vehicle, column) for name, column in KNOWN_SIZES.items()},
        status=values.status if values else "not_measurable",
        reason=values.reason if values else None,
        filmed_at=_filmed_at(shown),
        u_filmed_at_s=None if shown.passing is None else shown.passing.u_filmed_at_s,
        run_of=vehicle.run_of,
        references=tuple(given.values for given in shown.references),
        direction=None if values is None else values.direction,
        lane=None if values is None else values.lane,
        axles=None if values is None else values.axles,
        **where,
    )
