"""The tables of line-scan recordings in an export: what every column holds, and the rows."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from sqlalchemy.orm import Session

from sightline.coverage import expanded
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.schema import Cells, Column, Table, when
from sightline.linescan.parts import Gap
from sightline.scans.heights import csv
from sightline.scans.records import Scan, ScanMeasurement, ScanReview
from sightline.scans.store import list_scans, rig_columns
from sightline.scans.vehicles.listing import ShownVehicle, shown
from sightline.scans.vehicles.measurement_store import scan_measurement_history
from sightline.scans.vehicles.review_store import list_scan_reviews
from sightline.scans.vehicles.store import list_scan_vehicles


def _id(name: str, meaning: str, required: bool = True) -> Column:
    return Column(name, "integer", meaning, required=required)


def _number(name: str, meaning: str, unit: str) -> Column:
    return Column(name, "number", meaning, unit)


def _with_u(name: str, meaning: str, unit: str) -> tuple[Column, Column, Column]:
    return (
        _number(name, meaning, unit),
        _number(f"u_{name}", f"standard uncertainty of {name} (k = 1)", unit),
        _number(f"U95_{name}", f"half-width of the 95 % interval of {name}", unit),
    )


_RIG = (
    _number("baseline_m", "between both scanning planes at the road", "m"),
    _number("u_baseline_m", "standard uncertainty of the baseline (k = 1)", "m"),
    _number("line_rate_hz", "lines a second of either camera", "Hz"),
    _number("u_line_rate_ratio", "standard uncertainty of the line rate over the line rate (k = 1)", ""),
    _number("divergence_rad", "angle by which the scanning planes open towards the vehicles", "rad"),
    _number("u_divergence_rad", "standard uncertainty of the divergence (k = 1)", "rad"),
    _number("distance_m", "from the cameras to the vehicles' side, where it is known", "m"),
    _number("misalignment_px", "a point's row in strip 2 minus its row in strip 1, where it was given", "px"),
    _number("u_misalignment_px", "standard uncertainty of the misalignment (k = 1)", "px"),
)
_MOTION = (
    _number("front_line_1", "line of strip 1 at which the front crosses camera 1, fractional, from 0", ""),
    _number("rear_line_1", "line of strip 1 at which the rear crosses camera 1", ""),
    _number("front_line_2", "line of strip 2 at which the front crosses camera 2", ""),
    _number("rear_line_2", "line of strip 2 at which the rear crosses camera 2", ""),
    *_with_u("speed_mps", "speed when the front reaches camera 1", "m/s"),
    *_with_u("acceleration_mps2", "acceleration, constant over the passage", "m/s2"),
    *_with_u("length_m", "length from front to rear, acceleration compensated", "m"),
    _number("front_wheel_line", "line of strip 1 of the middle of the front wheel, as clicked", ""),
    _number("rear_wheel_line", "line of strip 1 of the middle of the rear wheel, as clicked", ""),
    *_with_u("wheelbase_m", "distance between both wheels' middles", "m"),
    _number("fit_error_percent", "scatter of the speed profile about its fit", "%"),
    Column("status", "string", "whether there is a motion", required=True, enum=("ok", "not_measurable")),
    Column("reason", "string", "why there is no motion"),
    Column("warnings", "string", "what is to be said of this result, separated by semicolons"),
    Column("method", "string", "how the strips were matched", required=True, enum=("direct", "paper")),
    Column(
        "cause",
        "string",
        "what made this revision",
        required=True,
        enum=("found", "added", "boundaries", "wheels", "again"),
    ),
    Column("code_version", "string", "version of the program that computed it", required=True),
    _id("created_by_id", "who made it; empty for the program itself", required=False),
    Column("created_at", "datetime", "when the revision was stored (ISO 8601, UTC)"),
)
_VERDICT = (
    Column(
        "verdict",
        "string",
        "state of the review of this revision",
        required=True,
        enum=("to_review", "accepted", "rejected", "reopened"),
    ),
    Column("review_reason", "string", "the reviewer's reason"),
    _id("reviewer_id", "who reviewed", required=False),
    Column("reviewed_at", "datetime", "when it was reviewed (ISO 8601, UTC)"),
)
# A vehicle that was never measured has none of these.
_MOTION_OF_VEHICLE = tuple(replace(column, required=False) for column in _MOTION)
_VERDICT_OF_VEHICLE = tuple(replace(column, required=False) for column in _VERDICT)
_PEOPLE = ((("created_by_id",), "people", ("id",)), (("reviewer_id",), "people", ("id",)))

LINE_SCANS = Table(
    "line_scans",
    "Line-scan recordings: pairs of strips with the rig that took them. Camera 1 is reached first.",
    (
        _id("id", "line-scan recording"),
        Column("name", "string", "its name", required=True),
        Column("source", "string", "strips of cameras, or columns of a video", enum=("strips", "video")),
        _id("recording_id", "video that the strips were cut from", required=False),
        Column("rows_px", "integer", "pixels a line", "px"),
        _id("lines", "lines of either strip", required=False),
        _id("bits", "bits a pixel", required=False),
        Column("first_sha256", "string", "SHA-256 of camera 1's stored strip"),
        Column("second_sha256", "string", "SHA-256 of camera 2's stored strip"),
        *_RIG,
        Column("lighting", "string", "lighting", enum=("daytime", "low_light")),
        Column("notes", "string", "what the reading said, separated by semicolons"),
        Column("created_at", "datetime", "when it was made (ISO 8601, UTC)"),
    ),
    primary=("id",),
    foreign=((("recording_id",), "recordings", ("id",)),),
)
SCAN_VEHICLES = Table(
    "scan_vehicles",
    "Vehicles of line-scan recordings in the order of passing, with the current revision of their motion.",
    (
        _id("id", "vehicle of a line-scan recording"),
        _id("scan_id", "line-scan recording"),
        _id("number", "number of the vehicle in its recording"),
        Column("origin", "string", "found by the program or marked by a person", enum=("found", "person")),
        Column("make", "string", "make"),
        Column("model", "string", "model"),
        Column("year", "integer", "year of the model"),
        Column("category", "string", "kind of vehicle"),
        _number("true_length_m", "the manufacturer's length", "m"),
        _number("u_true_length_m", "standard uncertainty of the manufacturer's length (k = 1)", "m"),
        _number("true_wheelbase_m", "the manufacturer's wheelbase", "m"),
        _number("u_true_wheelbase_m", "standard uncertainty of the manufacturer's wheelbase (k = 1)", "m"),
        Column("facts_source", "string", "where the manufacturer's values come from"),
        Column("lighting", "string", "lighting, where it differs from the recording's"),
        Column("notes", "string", "notes"),
        _id("measurement_id", "current revision, in scan_measurements", required=False),
        _id("revision", "its number, from 1", required=False),
        *_MOTION_OF_VEHICLE,
        _number("time_gap_s", "from the rear of the vehicle before to this front, at camera 1", "s"),
        _number("u_time_gap_s", "standard uncertainty of the time gap (k = 1)", "s"),
        _number(
            "distance_gap_m",
            "between the same two points when this front reaches camera 1, by the leader's own motion",
            "m",
        ),
        _number("u_distance_gap_m", "standard uncertainty of the distance gap (k = 1)", "m"),
        _number("headway_s", "from front to front at camera 1", "s"),
        _number("paper_distance_gap_m", "the paper's D: time gap times the mean of both speeds", "m"),
        Column("gap_reason", "string", "why a gap is missing"),
        *_VERDICT_OF_VEHICLE,
    ),
    primary=("id",),
    foreign=(
        (("scan_id",), "line_scans", ("id",)),
        (("measurement_id",), "scan_measurements", ("id",)),
        *_PEOPLE,
    ),
)
SCAN_MEASUREMENTS = Table(
    "scan_measurements",
    "Every revision of every scanned vehicle's motion, with the rig that it was computed with.",
    (
        _id("id", "revision"),
        _id("vehicle_id", "vehicle of a line-scan recording"),
        _id("revision", "number of the revision, from 1"),
        *_MOTION,
        *_RIG,
        *_VERDICT,
    ),
    primary=("id",),
    foreign=((("vehicle_id",), "scan_vehicles", ("id",)), *_PEOPLE),
)
SCAN_REVIEWS = Table(
    "scan_reviews",
    "Every verdict given on a scanned vehicle's revision, oldest first.",
    (
        _id("id", "verdict"),
        _id("measurement_id", "revision that was judged, in scan_measurements"),
        Column("verdict", "string", "verdict", required=True, enum=("accepted", "rejected", "reopened")),
        Column("reason", "string", "the reviewer's reason"),
        _id("reviewer_id", "who reviewed", required=False),
        Column("at", "datetime", "when (ISO 8601, UTC)"),
    ),
    primary=("id",),
    foreign=(
        (("measurement_id",), "scan_measurements", ("id",)),
        (("reviewer_id",), "people", ("id",)),
    ),
)
TABLES = (LINE_SCANS, SCAN_VEHICLES, SCAN_MEASUREMENTS, SCAN_REVIEWS, *csv.TABLES)


def rows_of(session: Session, survey_id: int) -> tuple[dict[str, list[Cells]], dict[int, str]]:
    """The rows of each table by its name, and the people who stand in them (name by id).

    Deleted scans and vehicles are left out with all that belongs to them, as for heights.
    """
    found: dict[str, list[Cells]] = {table.name: [] for table in TABLES}
    people: dict[int, str] = {}
    kept: set[int] = set()
    for scan in list_scans(session, survey_id):
        found["line_scans"].append(scan_row(scan))
        passed = shown(scan, list_scan_vehicles(session, scan.id))
        for one in passed:
            found["scan_vehicles"].append(vehicle_row(one))
            for revision in scan_measurement_history(session, one.vehicle.id):
                kept.add(revision.id)
                found["scan_measurements"].append(measurement_row(revision))
                _name(people, (revision.created_by, revision.review.reviewer))
        ids = [one.vehicle.id for one in passed]
        _name(people, csv.add_scan(session, scan.id, ids, found))
    found["line_heights"].sort(key=lambda row: int(row["id"] or 0))
    found["scan_measurements"].sort(key=lambda row: int(row["id"] or 0))
    for review in list_scan_reviews(session, survey_id):
        if review.measurement_id in kept:
            found["scan_reviews"].append(review_row(review))
            _name(people, (review.reviewer,))
    return found, people


def scan_row(scan: Scan) -> Cells:
    """One row of line_scans."""
    names = ("id", "name", "source", "recording_id", "rows_px", "lines", "bits", "first_sha256")
    row: Cells = {name: getattr(scan, name) for name in (*names, "second_sha256", "lighting")}
    return {
        **row,
        **rig_columns(scan.rig),
        "notes": "; ".join(scan.notes),
        "created_at": when(scan.created_at),
    }


def vehicle_row(one: ShownVehicle) -> Cells:
    """One row of scan_vehicles; the motion's cells are empty where the vehicle was never measured."""
    vehicle = one.vehicle
    row: Cells = dict.fromkeys(SCAN_VEHICLES.header)
    row |= {name: getattr(vehicle, name) for name in _OF_VEHICLE}
    if vehicle.measurement is not None:
        row |= {"measurement_id": vehicle.measurement.id, "revision": vehicle.measurement.revision}
        row |= _measured(vehicle.measurement)
    return {**row, **_gap(one.gap)}


def measurement_row(one: ScanMeasurement) -> Cells:
    """One row of scan_measurements."""
    head: Cells = {"id": one.id, "vehicle_id": one.vehicle_id, "revision": one.revision}
    return {**head, **_measured(one), **one.values.rig}


def review_row(one: ScanReview) -> Cells:
    """One row of scan_reviews."""
    row: Cells = {name: getattr(one, name) for name in ("id", "measurement_id", "verdict", "reason")}
    return {**row, "reviewer_id": one.reviewer.id if one.reviewer else None, "at": when(one.at)}


def _measured(one: ScanMeasurement) -> Cells:
    values, review = one.values, one.review
    row: Cells = {}
    for column in _MOTION:
        name = column.name
        if name.startswith("U95_"):
            row[name] = expanded(getattr(values, f"u_{name.removeprefix('U95_')}"))
        elif name not in ("created_by_id", "created_at", "warnings"):
            row[name] = getattr(values, name)
    row["warnings"] = "; ".join(values.warnings)
    row["created_by_id"] = one.created_by.id if one.created_by else None
    row["created_at"] = when(one.created_at)
    row |= {"verdict": review.verdict, "review_reason": review.reason}
    row["reviewer_id"] = review.reviewer.id if review.reviewer else None
    row["reviewed_at"] = when(review.at)
    return row


def _gap(gap: Gap | None) -> Cells:
    names = ("time_gap_s", "u_time_gap_s", "distance_gap_m", "u_distance_gap_m", "headway_s")
    row: Cells = {name: None if gap is None else getattr(gap, name) for name in names}
    row["paper_distance_gap_m"] = None if gap is None else gap.paper_distance_gap_m
    return {**row, "gap_reason": None if gap is None else gap.reason}


def _name(people: dict[int, str], found: Iterable[Who | None]) -> None:
    people.update({one.id: one.name for one in found if one is not None})


_OF_VEHICLE = SCAN_VEHICLES.header[: SCAN_VEHICLES.header.index("measurement_id")]
