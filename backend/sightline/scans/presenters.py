"""Scans and their vehicles as they go out."""

from typing import get_args

from sightline.coverage import expanded
from sightline.enums import MatchPicture
from sightline.infra.by_name import filled_from
from sightline.infra.database.types import now
from sightline.infra.services import Services
from sightline.infra.web.bodies import JobBody
from sightline.linescan.parts import Entry, Gap, Rig
from sightline.media.strips.stored_writer import STEP, TILE_LINES, level_lines
from sightline.recordings.csv import started_text
from sightline.scans.bodies import (
    GapBody,
    LevelBody,
    MatchBody,
    ProfileBody,
    ScanBody,
    ScanMotionBody,
    ScanVehicleBody,
    ScanVehicleDetailBody,
)
from sightline.scans.live.state import live_state
from sightline.scans.match import window_of
from sightline.scans.records import Scan, ScanMeasurement, ScanReviewFacts, ScanValues
from sightline.scans.references.service import shown_reference
from sightline.scans.store import rig_for
from sightline.scans.vehicles.listing import ShownDetail, ShownVehicle, one_of


def scan_body(scan: Scan) -> ScanBody:
    """A scan with its zoom levels."""
    lines = scan.lines or 0
    return filled_from(
        ScanBody,
        scan,
        job=None if scan.job is None else JobBody.model_validate(scan.job),
        stream_state=scan.heard_at and live_state(scan.heard_at, None, now()),
        started_local=started_text(scan.started_at, scan.time_zone),
        duration_s=scan.lines and scan.lines / scan.rig.line_rate_hz,
        tile_lines=TILE_LINES,
        tiles_version=scan.first_sha256 and f"{scan.first_sha256[:8]}{(scan.second_sha256 or '')[:8]}",
        levels=[
            LevelBody(level=n, lines=count, step=STEP**n, tiles=-(-count // TILE_LINES))
            for n, count in enumerate(level_lines(lines) if lines else [])
        ],
    )


def motion_body(measurement: ScanMeasurement, rig: Rig, asker: int) -> ScanMotionBody:
    """One revision; `rig` is the scan's as it is now."""
    values = measurement.values
    return filled_from(
        ScanMotionBody,
        measurement,
        values,
        U95_speed_mps=expanded(values.u_speed_mps),
        U95_acceleration_mps2=expanded(values.u_acceleration_mps2),
        U95_length_m=expanded(values.u_length_m),
        U95_wheelbase_m=expanded(values.u_wheelbase_m),
        older=values.rig != rig_for(rig, values.lane, values.direction),
        time_s=values.front_line_1 / values.rig["line_rate_hz"],
        placed_by_person=values.placed_by is not None,
        mine=values.placed_by == asker,
    )


def vehicle_body(shown: ShownVehicle, asker: int) -> ScanVehicleBody:
    """A vehicle with its current measurement and the gap before it."""
    vehicle, passing = shown.vehicle, shown.passing
    measured = vehicle.measurement
    ours = None if measured is None else measured.values
    return filled_from(
        ScanVehicleBody,
        vehicle,
        state=vehicle.state,
        measurement=None if measured is None else motion_body(measured, shown.rig, asker),
        filmed_at=None if passing is None else passing.filmed_at,
        u_filmed_at_s=None if passing is None else passing.u_filmed_at_s,
        U95_filmed_at_s=None if passing is None else expanded(passing.u_filmed_at_s),
        gap=shown.gap and _gap(shown.gap),
        length_error_m=shown.error_m("length"),
        wheelbase_error_m=shown.error_m("wheelbase"),
        references=[shown_reference(one, ours) for one in shown.references],
    )


def changed_vehicle(services: Services, vehicle_id: int, asker: int) -> ScanVehicleBody:
    """The answer to a change of a vehicle."""
    with services.reading() as session:
        return vehicle_body(one_of(session, vehicle_id), asker)


def detail_body(detail: ShownDetail, asker: int) -> ScanVehicleDetailBody:
    """A vehicle with profile, budget, pictures of the match, history and reviews."""
    shown = detail.shown
    measured = shown.vehicle.measurement
    return ScanVehicleDetailBody(
        vehicle=vehicle_body(shown, asker),
        profile=None if measured is None else _profile(measured.values),
        budget=[] if measured is None else [Entry(**one) for one in measured.values.budget],
        match=None if measured is None else _match(measured, detail.scan),
        history=[motion_body(one, shown.rig, asker) for one in detail.history],
        reviews=[filled_from(ScanReviewFacts, one) for one in detail.reviews],
    )


def _gap(gap: Gap) -> GapBody:
    return filled_from(
        GapBody,
        gap,
        U95_time_gap_s=expanded(gap.u_time_gap_s),
        U95_distance_gap_m=expanded(gap.u_distance_gap_m),
    )


def _profile(values: ScanValues) -> ProfileBody | None:
    if values.profile is None:
        return None
    columns = values.profile
    rate_hz = values.rig["line_rate_hz"]
    return ProfileBody(
        **columns,
        time_s=[(line - values.front_line_1) / rate_hz for line in columns["line_1"]],
        residual_mps=[
            speed - fitted for speed, fitted in zip(columns["speed_mps"], columns["fitted_mps"], strict=True)
        ],
    )


def _match(measured: ScanMeasurement, scan: Scan) -> MatchBody | None:
    if measured.values.status != "ok" or scan.lines is None or scan.rows_px is None:
        return None
    first, stop, step = window_of(measured.values, scan.lines)
    address = f"/api/scan-vehicles/{measured.vehicle_id}/match"
    return MatchBody(
        first_line=first,
        lines=stop - first,
        step=step,
        rows_px=scan.rows_px,
        **{f"{word}_url": f"{address}/{word}?v={measured.id}" for word in get_args(MatchPicture)},
    )
