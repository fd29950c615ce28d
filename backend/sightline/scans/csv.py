"""The tables of line-scan recordings in an export: what every column holds, and what rows they have."""

import json
from collections.abc import Iterable, Mapping
from functools import lru_cache
from operator import attrgetter
from typing import Any, get_args

from sightline.coverage import expanded
from sightline.enums import (
    AxlesBy,
    Cause,
    JsonObject,
    LaneBy,
    Lighting,
    MeasurementStatus,
    ScanMethod,
    ScanSource,
    ScanVerdict,
    VehicleOrigin,
)
from sightline.errors import Damaged
from sightline.infra.audit.hashing import canonical_json
from sightline.infra.csv_package.columns import (
    columns_for,
    columns_within,
    integer,
    join_sentences,
    key,
    metres,
    moment,
    number,
    person,
    said_columns,
    text,
)
from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.schema import Cell, Column, Table, ids_of
from sightline.infra.database import Session
from sightline.linescan.parts import Gap, Rig
from sightline.linescan.rig import sound_rig_from
from sightline.measurements.csv import given_verdict, standing_verdict
from sightline.recordings.csv import started_column
from sightline.scans.clock import Passing
from sightline.scans.heights.csv import TABLES as HEIGHT_TABLES
from sightline.scans.heights.csv import fill_heights
from sightline.scans.records import Scan, ScanMeasurement, ScanReview, ScanValues, ScanVehicle
from sightline.scans.references.csv import SCAN_REFERENCES, ListedReference, listed_references
from sightline.scans.references.store import reference_history_of_scan, standing_references
from sightline.scans.rig.csv import TABLES as RIG_TABLES
from sightline.scans.rig.csv import fill_rigs
from sightline.scans.store import RIG, list_scans, rig_columns
from sightline.scans.vehicles.listing import ShownVehicle, shown_vehicles
from sightline.scans.vehicles.measurement_store import scan_measurement_history
from sightline.scans.vehicles.review_store import list_scan_reviews
from sightline.scans.vehicles.store import list_scan_vehicles
from sightline.surveys.store import get_survey

RigCells = Mapping[str, Cell]


def axle_words(lines: list[float] | None) -> str | None:
    """Lines of wheels as a cell has them."""
    return None if lines is None else join_sentences([f"{line:.3f}" for line in lines])


def lanes_text(lanes: list[JsonObject] | None) -> str | None:
    """Lanes of a rig as a cell has them: canonical JSON, as the audit chain hashes them."""
    return canonical_json(lanes) if lanes else None


def rig_of_row(path: str, row: Mapping[str, str]) -> Rig:
    """The rig of a row of a package's table; what is empty, or was no column yet, is as usual. Raises Damaged
    where no rig is as it says.
    """
    rig = _rig_of_cells(tuple(row.get(name, "") for name in RIG))
    if rig is None:
        raise Damaged("scans-rig-not-sound", path=path, id=row["id"])
    return rig


@lru_cache(maxsize=1000)
def _rig_of_cells(cells: tuple[str, ...]) -> Rig | None:
    """By the order of `RIG`; the motions of a recording have few rigs."""
    held = {name: cell for name, cell in zip(RIG, cells, strict=True) if cell}
    try:
        told = {name: json.loads(cell) if name == "lanes" else float(cell) for name, cell in held.items()}
    except (ValueError, RecursionError):
        return None
    return sound_rig_from(told)


def _with_u(name: str, meaning: str, unit: str) -> tuple[Column[ScanValues], ...]:
    u_of = attrgetter(f"u_{name}")
    return (
        number(name, meaning, unit),
        number(f"u_{name}", f"standard uncertainty of {name} (k = 1)", unit),
        number(
            f"U95_{name}", f"half-width of the 95 % interval of {name}", unit, lambda v: expanded(u_of(v))
        ),
    )


def _of_rig(name: str, meaning: str, unit: str) -> Column[RigCells]:
    return number(name, meaning, unit, lambda rig: rig[name])


_RIG: tuple[Column[RigCells], ...] = (
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
    *columns_within(
        "values",
        *columns_for(ScanValues, "direction"),
        number("front_line_1", "line of strip 1 at which the front crosses camera 1, fractional, from 0"),
        number("rear_line_1", "line of strip 1 at which the rear crosses camera 1"),
        number("front_line_2", "line of strip 2 at which the front crosses camera 2"),
        number("rear_line_2", "line of strip 2 at which the rear crosses camera 2"),
        *_with_u("speed_mps", "speed when the front reaches camera 1", "m/s"),
        *_with_u("acceleration_mps2", "acceleration, constant over the passage", "m/s2"),
        *_with_u("length_m", "length from front to rear, acceleration compensated", "m"),
        number("front_wheel_line", "line of strip 1 of the middle of the front wheel, as clicked"),
        number("rear_wheel_line", "line of strip 1 of the middle of the rear wheel, as clicked"),
        *_with_u("wheelbase_m", "distance between both wheels' middles", "m"),
        integer("axles", "how many axles it has, counted by its wheels; empty: none was found"),
        text(
            "axle_lines",
            "lines of strip 1 of the wheels' hubs, separated by semicolons",
            lambda v: axle_words(v.axle_lines),
        ),
        text("axles_by", "who found the wheels", enum=get_args(AxlesBy)),
        *columns_for(ScanValues, "lane"),
        text("lane_by", "who assigned the lane", enum=get_args(LaneBy)),
        *columns_for(ScanValues, "tyres_px"),
        metres(
            "u_boundaries_m",
            "what the doubt about boundaries that were found brings to u_length_m; 0 for a person's",
        ),
        number("fit_error_percent", "scatter of the speed profile about its fit", "%"),
        text("status", "whether there is a motion", required=True, enum=get_args(MeasurementStatus)),
        *said_columns("reason", "why there is no motion"),
        *said_columns("warnings", "warnings on this result, separated by semicolons"),
        text("method", "how the strips were matched", required=True, enum=get_args(ScanMethod)),
        text("cause", "what made this revision", required=True, enum=get_args(Cause)),
        text("code_version", "version of the program that computed it", required=True),
    ),
    person("created_by_id", "who made it; empty for the program itself"),
    moment("created_at", "when the revision was stored"),
)
_VERDICT: tuple[Column[ScanMeasurement], ...] = columns_within(
    "review", *standing_verdict(("to_review", *get_args(ScanVerdict)))
)


_PASSING: tuple[Column[Passing], ...] = (
    Column(
        "filmed_at",
        "datetime",
        "when its front reached camera 1, by the clocks of the place (ISO 8601 with offset): started_at of "
        "its recording and front_line_1 over the line rate later; empty until a person confirmed the start",
    ),
    number(
        "u_filmed_at_s",
        "standard uncertainty of filmed_at (k = 1): of the start, which all vehicles of a recording share, "
        "of the line rate, and of the front; empty without a motion",
        "s",
    ),
)
#: What stands of the gap before a vehicle.
GAP: tuple[Column[Gap], ...] = (
    number(
        "time_gap_s",
        "from the rear of the vehicle before it of its direction and lane to this front, at camera 1",
        "s",
    ),
    number("u_time_gap_s", "standard uncertainty of the time gap (k = 1)", "s"),
    metres(
        "distance_gap_m",
        "between the same two points when this front reaches camera 1, by the leader's own motion",
    ),
    metres("u_distance_gap_m", "standard uncertainty of the distance gap (k = 1)"),
    number("headway_s", "from front to front at camera 1", "s"),
    metres("paper_distance_gap_m", "the paper's D: time gap times the mean of both speeds"),
    *said_columns("gap_reason", "why a gap is missing", attrgetter("reason")),
)
LINE_SCANS: Table[Scan] = Table(
    "line_scans",
    "Line-scan recordings: pairs of strips with the rig that took them. Which camera a vehicle reached first "
    "stands with the vehicle.",
    (
        key("id", "line-scan recording"),
        text("name", "its name", required=True),
        text("source", "strips of cameras, or columns of a video", enum=get_args(ScanSource)),
        integer("recording_id", "video that the strips were cut from"),
        integer("rows_px", "pixels a line", unit="px"),
        integer("lines", "lines of either strip"),
        integer("bits", "bits of the cameras, as their brightest pixels tell"),
        text("first_sha256", "SHA-256 of camera 1's stored strip"),
        text("second_sha256", "SHA-256 of camera 2's stored strip"),
        *columns_within(lambda scan: rig_columns(scan.rig), *_RIG),
        text("lighting", "lighting", enum=get_args(Lighting)),
        started_column("when line 0 was taken", lambda s: s.started_at, lambda s: s.time_zone),
        text("time_zone", "time zone of these times (IANA)"),
        *columns_for(Scan, "u_start_s"),
        *said_columns("notes", "notes of the import, separated by semicolons"),
        moment("created_at", "when it was made"),
        text(
            "lanes",
            "lanes of the rig as a JSON list, each with its name, distance_m, u_distance_m (k = 1), "
            "direction, the rows between which its tyres meet the road, and shadow_share; empty: none",
            lambda s: lanes_text(rig_columns(s.rig)["lanes"]),
        ),
    ),
    primary=("id",),
    foreign=ids_of(recording_id="recordings"),
)
SCAN_VEHICLES: Table[ShownVehicle] = Table(
    "scan_vehicles",
    "Vehicles of line-scan recordings in the order of passing, with the current revision of their motion.",
    (
        *columns_within(
            "vehicle",
            key("id", "vehicle of a line-scan recording"),
            key("scan_id", "line-scan recording"),
            key("number", "number of the vehicle in its recording"),
            text("origin", "found by the program or marked by a person", enum=get_args(VehicleOrigin)),
            text("make", "make"),
            text("model", "model"),
            integer("year", "year of the model"),
            text("category", "kind of vehicle"),
            metres("true_length_m", "the manufacturer's length"),
            metres("u_true_length_m", "standard uncertainty of the manufacturer's length (k = 1)"),
            metres("true_wheelbase_m", "the manufacturer's wheelbase"),
            metres("u_true_wheelbase_m", "standard uncertainty of the manufacturer's wheelbase (k = 1)"),
            text("facts_source", "where the manufacturer's values come from"),
            *columns_for(ScanVehicle, "run_of"),
            text("lighting", "lighting, where it differs from the recording's"),
            text("notes", "notes"),
        ),
        *columns_within(
            "vehicle.measurement",  # none where it was never measured
            key("measurement_id", "current revision, in scan_measurements", attrgetter("id")),
            key("revision", "its number, from 1"),
            *_MOTION,
            required=False,
        ),
        *columns_within("passing", *_PASSING),  # none where the recording's start was not confirmed
        *columns_within("gap", *GAP),  # none before the first
        *columns_within("vehicle.measurement", *_VERDICT, required=False),
    ),
    primary=("id",),
    foreign=ids_of(scan_id="line_scans", measurement_id="scan_measurements"),
)
SCAN_MEASUREMENTS: Table[ScanMeasurement] = Table(
    "scan_measurements",
    "Every revision of every scanned vehicle's motion, with the rig that it was computed with.",
    (
        key("id", "revision"),
        key("vehicle_id", "vehicle of a line-scan recording"),
        key("revision", "number of the revision, from 1"),
        *_MOTION,
        *columns_within("values.rig", *_RIG),
        *_VERDICT,
        integer(
            "verdict_of_id",
            "of a motion that was put back: the revision before it whose verdict holds for it too",
        ),
    ),
    primary=("id",),
    foreign=ids_of(vehicle_id="scan_vehicles", verdict_of_id="scan_measurements"),
)
SCAN_REVIEWS: Table[ScanReview] = Table(
    "scan_reviews",
    "Every verdict given on a scanned vehicle's revision, oldest first.",
    (
        key("id", "verdict"),
        key("measurement_id", "revision that was judged, in scan_measurements"),
        *given_verdict(get_args(ScanVerdict)),
    ),
    primary=("id",),
    foreign=ids_of(measurement_id="scan_measurements"),
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


def fill_scans(staging: Staging, session: Session, survey_id: int) -> None:
    """Write the tables of line scans; deleted scans and vehicles are left out with all that is theirs."""
    scans = list_scans(session, survey_id)
    passed = {
        scan.id: shown_vehicles(
            scan, list_scan_vehicles(session, scan.id), standing_references(session, scan.id)
        )
        for scan in scans
    }
    vehicles = [one for found in passed.values() for one in found]
    revisions = [one for of in vehicles for one in scan_measurement_history(session, of.vehicle.id)]
    kept = {one.id for one in revisions}
    staging.fill(LINE_SCANS, scans)
    staging.fill(SCAN_VEHICLES, vehicles)
    staging.fill(SCAN_MEASUREMENTS, sorted(revisions, key=lambda one: one.id))
    given = list_scan_reviews(session, survey_id)
    staging.fill(SCAN_REVIEWS, (one for one in given if one.measurement_id in kept))
    references = [one for id_, found in passed.items() for one in _references(session, id_, found)]
    staging.fill(SCAN_REFERENCES, sorted(references, key=lambda one: one.reference.id))
    vehicles_of = {id_: [one.vehicle.id for one in found] for id_, found in passed.items()}
    fill_heights(staging, session, vehicles_of, get_survey(session, survey_id).insets)
    fill_rigs(staging, session, passed)


def _references(session: Session, scan_id: int, passed: Iterable[ShownVehicle]) -> list[ListedReference]:
    by_id = {one.vehicle.id: one for one in passed}
    history = reference_history_of_scan(session, scan_id)
    return listed_references(history, lambda one: by_id[one.vehicle_id].agreement(one))
