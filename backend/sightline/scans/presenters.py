"""Scans and their vehicles as they go out."""

from dataclasses import asdict
from typing import Any, get_args

from sightline.coverage import expanded
from sightline.enums import MatchPicture
from sightline.infra.database.types import now
from sightline.linescan.parts import Entry, Rig
from sightline.media.strips.stored_writer import STEP, TILE_LINES, level_lines
from sightline.recordings.csv import started_text
from sightline.scans.bodies import (
    LevelBody,
    MatchBody,
    ProfileBody,
    ScanBody,
    ScanMotionBody,
    ScanReviewBody,
    ScanRunBody,
    ScanVehicleBody,
    ScanVehicleDetailBody,
)
from sightline.scans.clock import Passing
from sightline.scans.live.state import live_state
from sightline.scans.match import window_of
from sightline.scans.records import Scan, ScanMeasurement, ScanRun, ScanValues
from sightline.scans.references.presenters import reference_body
from sightline.scans.store import rig_for
from sightline.scans.vehicles.listing import ShownDetail, ShownVehicle

_DERIVED = ("started_local", "stream_state", "duration_s", "tile_lines", "tiles_version", "levels", "run")
_U95 = ("speed_mps", "acceleration_mps2", "length_m", "wheelbase_m")
_PASSED = (*Passing.__slots__, "U95_filmed_at_s")
_OF_REVISION = ("id", "revision", "created_by", "created_at", "review")


def scan_body(scan: Scan) -> ScanBody:
    """A scan with its zoom levels."""
    values: dict[str, Any] = {
        name: getattr(scan, name) for name in ScanBody.model_fields if name not in _DERIVED
    }
    lines = scan.lines or 0
    levels = [
        LevelBody(level=n, lines=count, step=STEP**n, tiles=-(-count // TILE_LINES))
        for n, count in enumerate(level_lines(lines) if lines else [])
    ]
    return ScanBody.model_validate(
        {
            **values,
            "stream_state": scan.heard_at and live_state(scan.heard_at, None, now()),
            "started_local": started_text(scan.started_at, scan.time_zone),
            "duration_s": scan.lines and scan.lines / scan.rig.line_rate_hz,
            "tile_lines": TILE_LINES,
            "tiles_version": scan.first_sha256 and f"{scan.first_sha256[:8]}{(scan.second_sha256 or '')[:8]}",
            "levels": levels,
            "run": None if scan.run is None else run_body(scan.run),
        }
    )


def run_body(run: ScanRun) -> ScanRunBody:
    """A run of the finder with what it says about the cameras."""
    told = ("misalignment_px", "u_misalignment_px", "misalignment_words")
    shared = [name for name in ScanRunBody.model_fields if name not in told]
    values = {name: getattr(run, name) for name in shared}
    return ScanRunBody.model_validate({**values, **{name: run.summary.get(name) for name in told}})


def motion_body(one: ScanMeasurement, rig: Rig, asker: int) -> ScanMotionBody:
    """One revision; `rig` is the scan's as it is now."""
    values = one.values
    body: dict[str, Any] = {
        name: getattr(values, name) for name in ScanMotionBody.model_fields if name in ScanValues.__slots__
    }
    body |= {name: getattr(one, name) for name in _OF_REVISION}
    for name in _U95:
        body[f"U95_{name}"] = expanded(getattr(values, f"u_{name}"))
    body["older"] = values.rig != rig_for(rig, values.lane, values.direction)
    body["time_s"] = values.front_line_1 / values.rig["line_rate_hz"]
    body["placed_by_person"] = values.placed_by is not None
    body["mine"] = values.placed_by == asker
    return ScanMotionBody.model_validate(body)


def vehicle_body(shown: ShownVehicle, asker: int) -> ScanVehicleBody:
    """A vehicle with its current measurement and the gap before it."""
    vehicle = shown.vehicle
    left_out = ("measurement", *_PASSED, "gap", "length_error_m", "wheelbase_error_m", "references")
    body: dict[str, Any] = {
        name: getattr(vehicle, name) for name in ScanVehicleBody.model_fields if name not in left_out
    }
    measured = vehicle.measurement
    body["measurement"] = None if measured is None else motion_body(measured, shown.rig, asker)
    passing = shown.passing
    body |= dict.fromkeys(_PASSED) if passing is None else asdict(passing)
    body["U95_filmed_at_s"] = None if passing is None else expanded(passing.u_filmed_at_s)
    body["gap"] = shown.gap
    body |= {"length_error_m": shown.length_error_m, "wheelbase_error_m": shown.wheelbase_error_m}
    body["references"] = [reference_body(one, shown.agreement(one)) for one in shown.references]
    return ScanVehicleBody.model_validate(body)


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
        reviews=[ScanReviewBody.model_validate(one) for one in detail.reviews],
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
