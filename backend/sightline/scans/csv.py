"""The tables of line-scan recordings in an export: what every column holds, and what rows they have."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, get_args

from sightline.coverage import expanded
from sightline.enums import (
    AxlesBy,
    Cause,
    JsonObject,
    LaneBy,
    Lighting,
    MeasurementStatus,
    ScanDirection,
    ScanMethod,
    ScanSource,
    ScanVerdict,
    VehicleOrigin,
)
from sightline.infra.audit.hashing import canonical_json
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.columns import (
    integer,
    joined,
    key,
    metres,
    moment,
    number,
    of_part,
    person,
    said,
    text,
)
from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.schema import Cell, Column, Table
from sightline.infra.database import Session
from sightline.linescan.parts import Gap
from sightline.measurements.csv import given_verdict, standing_verdict
from sightline.messages.said import Said
from sightline.recordings.csv import started_column
from sightline.scans.clock import Passing
from sightline.scans.heights.csv import TABLES as HEIGHT_TABLES
from sightline.scans.heights.csv import HeightRecords
from sightline.scans.records import Scan, ScanMeasurement, ScanReview
from sightline.scans.references.csv import SCAN_REFERENCES, ListedReference, listed_references
from sightline.scans.references.store import reference_history_of_scan, standing_references
from sightline.scans.rig.csv import TABLES as RIG_TABLES
from sightline.scans.rig.csv import RigRecords
from sightline.scans.store import list_scans, rig_columns
from sightline.scans.vehicles.listing import ShownVehicle, shown
from sightline.scans.vehicles.measurement_store import scan_measurement_history
from sightline.scans.vehicles.review_store import list_scan_reviews
from sightline.scans.vehicles.store import list_scan_vehicles
from sightline.surveys.store import get_survey

Rig = Mapping[str, Cell]


def _reason(one: ScanMeasurement) -> Said | None:
    return one.values.reason


def _warnings(one: ScanMeasurement) -> list[Said]:
    return one.values.warnings


def _import_notes(one: Scan) -> list[Said]:
    return one.notes


def _gap_reason(one: Gap) -> Said | None:
    return one.reason


def axle_words(lines: list[float] | None) -> str | None:
    """Lines of wheels as a cell has them."""
    return None if lines is None else joined([f"{line:.3f}" for line in lines])


def lanes_text(lanes: list[JsonObject] | None) -> str | None:
    """Lanes of a rig as a cell has them: canonical JSON, as the audit chain hashes them."""
    return canonical_json(lanes) if lanes else None


def _with_u(
    name: str,
    meaning: str,
    unit: str,
    value: Callable[[ScanMeasurement], float | None],
    u: Callable[[ScanMeasurement], float | None],
) -> tuple[Column[ScanMeasurement], ...]:
    return (
        number(name, meaning, unit, value),
        number(f"u_{name}", f"standard uncertainty of {name} (k = 1)", unit, u),
        number(f"U95_{name}", f"half-width of the 95 % interval of {name}", unit, lambda m: expanded(u(m))),
    )


def _of_rig(name: str, meaning: str, unit: str) -> Column[Rig]:
    return number(name, meaning, unit, lambda rig: rig[name])


_RIG: tuple[Column[Rig], ...] = (
    _of_rig("baseline_m", "between both scanning planes at the road", "m"),
    _of_rig("u_baseline_m", "standard uncertainty of the baseline (k = 1)", "m"),
    _of_rig("line_rate_hz", "lines a second of either camera", "Hz"),
    _of_rig("u_line_rate_ratio", "standard uncertainty of the line rate over the line rate (k = 1)", ""),
    _of_rig("divergence_rad", "angle by which the scanning planes open towards the vehicles", "rad"),
    _of_rig("u_divergence_rad", "standard uncertainty of the divergence (k = 1)", "rad"),
    _of_rig("distance_m", "from the cameras to the vehicles' side, where it is known", "m"),
    _of_rig("misalignment_px", "row of a point in strip 2 minus its row in strip 1, as entered", "px"),
    _of_rig("u_misalignment_px", "standard uncertainty of the misalignment (k = 1)", "px"),
    _of_rig("shadow_share", "share of the rows, from the bottom, in which no vehicle was looked for", ""),
    _of_rig("baseline_correlation", "of the errors of baseline_m and divergence_rad", ""),
    _of_rig("u_distance_m", "standard uncertainty of a vehicle's distance_m (k = 1)", "m"),
)
_MOTION: tuple[Column[ScanMeasurement], ...] = (
    text(
        "direction",
        "which camera it reached first; speed and gaps are those at camera 1 all the same",
        lambda m: m.values.direction,
        required=True,
        enum=get_args(ScanDirection),
    ),
    number(
        "front_line_1",
        "line of strip 1 at which the front crosses camera 1, fractional, from 0",
        "",
        lambda m: m.values.front_line_1,
    ),
    number(
        "rear_line_1",
        "line of strip 1 at which the rear crosses camera 1",
        "",
        lambda m: m.values.rear_line_1,
    ),
    number(
        "front_line_2",
        "line of strip 2 at which the front crosses camera 2",
        "",
        lambda m: m.values.front_line_2,
    ),
    number(
        "rear_line_2",
        "line of strip 2 at which the rear crosses camera 2",
        "",
        lambda m: m.values.rear_line_2,
    ),
    *_with_u(
        "speed_mps",
        "speed when the front reaches camera 1",
        "m/s",
        lambda m: m.values.speed_mps,
        lambda m: m.values.u_speed_mps,
    ),
    *_with_u(
        "acceleration_mps2",
        "acceleration, constant over the passage",
        "m/s2",
        lambda m: m.values.acceleration_mps2,
        lambda m: m.values.u_acceleration_mps2,
    ),
    *_with_u(
        "length_m",
        "length from front to rear, acceleration compensated",
        "m",
        lambda m: m.values.length_m,
        lambda m: m.values.u_length_m,
    ),
    number(
        "front_wheel_line",
        "line of strip 1 of the middle of the front wheel, as clicked",
        "",
        lambda m: m.values.front_wheel_line,
    ),
    number(
        "rear_wheel_line",
        "line of strip 1 of the middle of the rear wheel, as clicked",
        "",
        lambda m: m.values.rear_wheel_line,
    ),
    *_with_u(
        "wheelbase_m",
        "distance between both wheels' middles",
        "m",
        lambda m: m.values.wheelbase_m,
        lambda m: m.values.u_wheelbase_m,
    ),
    integer(
        "axles",
        "how many axles it has, counted by its wheels; empty: none was found",
        lambda m: m.values.axles,
    ),
    text(
        "axle_lines",
        "lines of strip 1 of the wheels' hubs, separated by semicolons",
        lambda m: axle_words(m.values.axle_lines),
    ),
    text("axles_by", "who found the wheels", lambda m: m.values.axles_by, enum=get_args(AxlesBy)),
    text("lane", "of the rig's lanes; empty: not known, or it has none", lambda m: m.values.lane),
    text("lane_by", "who assigned the lane", lambda m: m.values.lane_by, enum=get_args(LaneBy)),
    number(
        "tyres_px",
        "row of strip 1 at which its tyres meet the road, if the lane was assigned by it",
        "px",
        lambda m: m.values.tyres_px,
    ),
    metres(
        "u_boundaries_m",
        "what the doubt about boundaries that were found brings to u_length_m; 0 for a person's",
        lambda m: m.values.u_boundaries_m,
    ),
    number(
        "fit_error_percent",
        "scatter of the speed profile about its fit",
        "%",
        lambda m: m.values.fit_error_percent,
    ),
    text(
        "status",
        "whether there is a motion",
        lambda m: m.values.status,
        required=True,
        enum=get_args(MeasurementStatus),
    ),
    *said("reason", "why there is no motion", _reason),
    *said("warnings", "warnings on this result, separated by semicolons", _warnings),
    text(
        "method",
        "how the strips were matched",
        lambda m: m.values.method,
        required=True,
        enum=get_args(ScanMethod),
    ),
    text("cause", "what made this revision", lambda m: m.values.cause, required=True, enum=get_args(Cause)),
    text(
        "code_version",
        "version of the program that computed it",
        lambda m: m.values.code_version,
        required=True,
    ),
    person("created_by_id", "who made it; empty for the program itself", lambda m: m.created_by),
    moment("created_at", "when the revision was stored", lambda m: m.created_at),
)
_VERDICT: tuple[Column[ScanMeasurement], ...] = of_part(
    standing_verdict(("to_review", *get_args(ScanVerdict))), lambda m: m.review
)


def _motion(shown: ShownVehicle) -> ScanMeasurement | None:
    """The current revision; a vehicle that was never measured has none."""
    return shown.vehicle.measurement


def _gap(shown: ShownVehicle) -> Gap | None:
    """The gap before a vehicle; the first has none."""
    return shown.gap


def _passing(shown: ShownVehicle) -> Passing | None:
    """When it passed, where the recording's start was confirmed."""
    return shown.passing


def _rig_of_scan(scan: Scan) -> Rig:
    return rig_columns(scan.rig)


def _rig_of_motion(measurement: ScanMeasurement) -> Rig:
    return measurement.values.rig


_PASSING: tuple[Column[Passing], ...] = (
    Column(
        "filmed_at",
        "datetime",
        "when its front reached camera 1, by the clocks of the place (ISO 8601 with offset): started_at of "
        "its recording and front_line_1 over the line rate later; empty until a person confirmed the start",
        of=lambda p: p.filmed_at,
    ),
    number(
        "u_filmed_at_s",
        "standard uncertainty of filmed_at (k = 1): of the start, which all vehicles of a recording share, "
        "of the line rate, and of the front; empty without a motion",
        "s",
        lambda p: p.u_filmed_at_s,
    ),
)
_GAP: tuple[Column[Gap], ...] = (
    number(
        "time_gap_s",
        "from the rear of the vehicle before it of its direction and lane to this front, at camera 1",
        "s",
        lambda g: g.time_gap_s,
    ),
    number(
        "u_time_gap_s",
        "standard uncertainty of the time gap (k = 1)",
        "s",
        lambda g: g.u_time_gap_s,
    ),
    metres(
        "distance_gap_m",
        "between the same two points when this front reaches camera 1, by the leader's own motion",
        lambda g: g.distance_gap_m,
    ),
    metres(
        "u_distance_gap_m",
        "standard uncertainty of the distance gap (k = 1)",
        lambda g: g.u_distance_gap_m,
    ),
    number("headway_s", "from front to front at camera 1", "s", lambda g: g.headway_s),
    metres(
        "paper_distance_gap_m",
        "the paper's D: time gap times the mean of both speeds",
        lambda g: g.paper_distance_gap_m,
    ),
    *said("gap_reason", "why a gap is missing", _gap_reason),
)
_PEOPLE = ((("created_by_id",), "people", ("id",)), (("reviewer_id",), "people", ("id",)))

LINE_SCANS: Table[Scan] = Table(
    "line_scans",
    "Line-scan recordings: pairs of strips with the rig that took them. Camera 1 is reached first.",
    (
        key("id", "line-scan recording", lambda s: s.id),
        text("name", "its name", lambda s: s.name, required=True),
        text(
            "source",
            "strips of cameras, or columns of a video",
            lambda s: s.source,
            enum=get_args(ScanSource),
        ),
        integer("recording_id", "video that the strips were cut from", lambda s: s.recording_id),
        integer("rows_px", "pixels a line", lambda s: s.rows_px, unit="px"),
        integer("lines", "lines of either strip", lambda s: s.lines),
        integer("bits", "bits of the cameras, as their brightest pixels tell", lambda s: s.bits),
        text("first_sha256", "SHA-256 of camera 1's stored strip", lambda s: s.first_sha256),
        text("second_sha256", "SHA-256 of camera 2's stored strip", lambda s: s.second_sha256),
        *of_part(_RIG, _rig_of_scan),
        text("lighting", "lighting", lambda s: s.lighting, enum=get_args(Lighting)),
        started_column("when line 0 was taken", lambda s: s.started_at, lambda s: s.time_zone),
        text("time_zone", "time zone of these times (IANA)", lambda s: s.time_zone),
        number("u_start_s", "standard uncertainty of started_at (k = 1)", "s", lambda s: s.u_start_s),
        *said("notes", "notes of the import, separated by semicolons", _import_notes),
        moment("created_at", "when it was made", lambda s: s.created_at),
        text(
            "lanes",
            "lanes of the rig as a JSON list, each with its name, distance_m, u_distance_m (k = 1), "
            "direction, the rows between which its tyres meet the road, and shadow_share; empty: none",
            lambda s: lanes_text(rig_columns(s.rig)["lanes"]),
        ),
    ),
    primary=("id",),
    foreign=((("recording_id",), "recordings", ("id",)),),
)
SCAN_VEHICLES: Table[ShownVehicle] = Table(
    "scan_vehicles",
    "Vehicles of line-scan recordings in the order of passing, with the current revision of their motion.",
    (
        key("id", "vehicle of a line-scan recording", lambda s: s.vehicle.id),
        key("scan_id", "line-scan recording", lambda s: s.vehicle.scan_id),
        key("number", "number of the vehicle in its recording", lambda s: s.vehicle.number),
        text(
            "origin",
            "found by the program or marked by a person",
            lambda s: s.vehicle.origin,
            enum=get_args(VehicleOrigin),
        ),
        text("make", "make", lambda s: s.vehicle.make),
        text("model", "model", lambda s: s.vehicle.model),
        integer("year", "year of the model", lambda s: s.vehicle.year),
        text("category", "kind of vehicle", lambda s: s.vehicle.category),
        metres("true_length_m", "the manufacturer's length", lambda s: s.vehicle.true_length_m),
        metres(
            "u_true_length_m",
            "standard uncertainty of the manufacturer's length (k = 1)",
            lambda s: s.vehicle.u_true_length_m,
        ),
        metres("true_wheelbase_m", "the manufacturer's wheelbase", lambda s: s.vehicle.true_wheelbase_m),
        metres(
            "u_true_wheelbase_m",
            "standard uncertainty of the manufacturer's wheelbase (k = 1)",
            lambda s: s.vehicle.u_true_wheelbase_m,
        ),
        text("facts_source", "where the manufacturer's values come from", lambda s: s.vehicle.facts_source),
        text("run_of", "name of the car of which this is one run of several", lambda s: s.vehicle.run_of),
        text("lighting", "lighting, where it differs from the recording's", lambda s: s.vehicle.lighting),
        text("notes", "notes", lambda s: s.vehicle.notes),
        *of_part(
            (
                key("measurement_id", "current revision, in scan_measurements", lambda m: m.id),
                key("revision", "its number, from 1", lambda m: m.revision),
                *_MOTION,
            ),
            _motion,
            required=False,
        ),
        *of_part(_PASSING, _passing),
        *of_part(_GAP, _gap),
        *of_part(_VERDICT, _motion, required=False),
    ),
    primary=("id",),
    foreign=(
        (("scan_id",), "line_scans", ("id",)),
        (("measurement_id",), "scan_measurements", ("id",)),
        *_PEOPLE,
    ),
)
SCAN_MEASUREMENTS: Table[ScanMeasurement] = Table(
    "scan_measurements",
    "Every revision of every scanned vehicle's motion, with the rig that it was computed with.",
    (
        key("id", "revision", lambda m: m.id),
        key("vehicle_id", "vehicle of a line-scan recording", lambda m: m.vehicle_id),
        key("revision", "number of the revision, from 1", lambda m: m.revision),
        *_MOTION,
        *of_part(_RIG, _rig_of_motion),
        *_VERDICT,
        integer(
            "verdict_of_id",
            "of a motion that was put back: the revision before it whose verdict holds for it too",
            lambda m: m.verdict_of_id,
        ),
    ),
    primary=("id",),
    foreign=(
        (("vehicle_id",), "scan_vehicles", ("id",)),
        (("verdict_of_id",), "scan_measurements", ("id",)),
        *_PEOPLE,
    ),
)
SCAN_REVIEWS: Table[ScanReview] = Table(
    "scan_reviews",
    "Every verdict given on a scanned vehicle's revision, oldest first.",
    (
        key("id", "verdict", lambda r: r.id),
        key("measurement_id", "revision that was judged, in scan_measurements", lambda r: r.measurement_id),
        *given_verdict(get_args(ScanVerdict)),
    ),
    primary=("id",),
    foreign=(
        (("measurement_id",), "scan_measurements", ("id",)),
        (("reviewer_id",), "people", ("id",)),
    ),
)
TABLES: tuple[Table[Any], ...] = (
    LINE_SCANS,
    SCAN_VEHICLES,
    SCAN_MEASUREMENTS,
    SCAN_REVIEWS,
    SCAN_REFERENCES,
    *HEIGHT_TABLES,
    *RIG_TABLES,
)


@dataclass(eq=False)
class ScanRecords:
    """What the tables of line scans are made of, and the people who stand in it (name by id)."""

    scans: list[Scan] = field(default_factory=list)
    vehicles: list[ShownVehicle] = field(default_factory=list)
    measurements: list[ScanMeasurement] = field(default_factory=list)
    reviews: list[ScanReview] = field(default_factory=list)
    references: list[ListedReference] = field(default_factory=list)
    heights: HeightRecords = field(default_factory=HeightRecords)
    rigs: RigRecords = field(default_factory=RigRecords)
    people: dict[int, str] = field(default_factory=dict)

    def name(self, people: Iterable[Who | None]) -> None:
        """Note who stands in a row."""
        self.people.update({who.id: who.name for who in people if who is not None})


def scan_records(session: Session, survey_id: int) -> ScanRecords:
    """The line scans of a survey, in the order of their rows.

    Deleted scans and vehicles are left out with all that belongs to them, as for heights.
    """
    found = ScanRecords()
    insets = get_survey(session, survey_id).insets
    for scan in list_scans(session, survey_id):
        found.scans.append(scan)
        standing = standing_references(session, scan.id)
        passed = shown(scan, list_scan_vehicles(session, scan.id), standing)
        found.vehicles += passed
        found.references += _references(session, scan.id, passed)
        for one in passed:
            found.measurements += scan_measurement_history(session, one.vehicle.id)
        found.name(found.rigs.add_scan(session, scan.id))
        found.name(found.heights.add_scan(session, scan.id, [one.vehicle.id for one in passed], insets))
    found.heights.heights.sort(key=lambda one: one.height.revision_id)
    found.heights.reviews.sort(key=lambda one: one.review.id)
    found.measurements.sort(key=lambda one: one.id)
    found.references.sort(key=lambda one: one.reference.id)
    found.name(one.reference.created_by for one in found.references)
    for revision in found.measurements:
        found.name((revision.created_by, revision.review.reviewer))
    kept = {one.id for one in found.measurements}
    found.reviews = [one for one in list_scan_reviews(session, survey_id) if one.measurement_id in kept]
    found.name(one.reviewer for one in found.reviews)
    return found


def _references(session: Session, scan_id: int, passed: Iterable[ShownVehicle]) -> list[ListedReference]:
    by_id = {one.vehicle.id: one for one in passed}
    history = reference_history_of_scan(session, scan_id)
    return listed_references(history, lambda one: by_id[one.vehicle_id].agreement(one))


def fill_scans(staging: Staging, session: Session, survey_id: int) -> dict[int, str]:
    """Write the tables of line scans; the people who stand in them (name by id)."""
    found = scan_records(session, survey_id)
    staging.fill(LINE_SCANS, found.scans)
    staging.fill(SCAN_VEHICLES, found.vehicles)
    staging.fill(SCAN_MEASUREMENTS, found.measurements)
    staging.fill(SCAN_REVIEWS, found.reviews)
    staging.fill(SCAN_REFERENCES, found.references)
    found.heights.fill(staging)
    found.rigs.fill(staging)
    return found.people
