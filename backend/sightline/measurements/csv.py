"""The tables of measurements in the package: current ones, revisions, budgets, clicks."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from operator import attrgetter
from typing import Any, get_args

from typing_extensions import TypeVar

from sightline.enums import (
    Category,
    DriverSide,
    InsetSource,
    Lighting,
    Made,
    MeasurementStatus,
    Point,
    ProposalKept,
    SideBasis,
    Target,
    Verdict,
    VerdictBasis,
)
from sightline.infra.csv_package.columns import (
    columns_within,
    flag,
    integer,
    key,
    metres,
    moment,
    number,
    person,
    pixel,
    said_columns,
    text,
)
from sightline.infra.csv_package.schema import Cell, Column, Table, ids_of
from sightline.measurements.again.csv import out_of_date
from sightline.measurements.followed_text import frames_of_text
from sightline.measurements.records import FurtherFrame, Measurement, MeasurementValues, ReviewState
from sightline.poses.csv import pose_path
from sightline.vehicles.records import is_reference

TARGETS: tuple[str, ...] = get_args(Target)
Record = TypeVar("Record")
REVIEWER, REASON_GIVEN = "who reviewed", "the reviewer's reason"
CLICKS_FOLDER = "clicks/"
Columns = tuple[Column[Measurement], ...]


@dataclass(frozen=True, slots=True)
class OfVehicle:
    """What a row of clicks says of a measurement's vehicle."""

    number: int
    lighting: str | None
    category: str | None
    known_m: Mapping[Target, float | None]
    model_chosen_by: str | None
    check_target: bool


@dataclass(frozen=True, slots=True)
class Clicked:
    """A measurement, the vehicle that it is of, and whether the package's statistics evaluate its height."""

    measurement: Measurement
    vehicle: OfVehicle
    evaluated: bool


@dataclass(frozen=True, slots=True)
class BudgetEntry:
    """One contribution to the uncertainty of a measurement's height."""

    measurement_id: int
    source: str
    u_m: float


def budget_entries(measurement: Measurement) -> Iterator[BudgetEntry]:
    """The contributions to the uncertainty of a height, in their order."""
    for entry in measurement.values.budget:
        yield BudgetEntry(measurement.id, str(entry["source"]), float(entry["u_m"]))


def clicks_path(pose_id: int) -> str:
    """Where the clicks of one road pose alone are."""
    return f"{CLICKS_FOLDER}pose-{pose_id}.csv"


PASS: Columns = (
    key("vehicle_id", "vehicle that was measured"),
    key("recording_id", "recording in which the points were clicked"),
)
FRAME: Columns = columns_within(
    "values",
    integer("frame", "frame number: the n-th decoded frame, from 0", required=True, minimum=0),
    integer("pts", "presentation time stamp of that frame, in the stream's own time base"),
    number("time_s", "time of that frame from the start of the stream", "s"),
)
_WHERE: Columns = (
    *PASS,
    *columns_within("values", text("target", "what was measured", required=True, enum=TARGETS)),
    *FRAME,
    *columns_within(
        "values",
        integer("frame_crc32", "CRC-32 of the decoded luma of that frame: proof of what was clicked on"),
    ),
)
#: Along a picture's two axes.
WAYS = (("x", "x to the right"), ("y", "y down"))


def _clicked(name: str, meaning: str, point: Callable[[MeasurementValues], Point]) -> Columns:
    """A point on the first frame."""

    def along(at: int) -> Callable[[Any], float]:
        return lambda m: float(point(m.values)[at])

    return tuple(
        pixel(f"{name}_{axis}_px", f"{meaning}, {way}", along(at)) for at, (axis, way) in enumerate(WAYS)
    )


POINTS: Columns = (
    *_clicked("contact", "where the tyre meets the road", lambda values: values.contact),
    *_clicked("target", "the target point", lambda values: values.target_point),
    number("sigma_px", "column-measurements-sigma-px", "px", lambda m: float(m.values.sigma_px), minimum=0),
)


def _optional_point_columns(name: str, meaning: str, more: str = "") -> Columns:
    """A point that may be told of, by both coordinates."""
    return tuple(pixel(f"{name}_{axis}_px", f"{meaning}, {way}{more}", required=False) for axis, way in WAYS)


def _proposed(which: str) -> Columns:
    """Where a point was proposed; of no height."""
    return _optional_point_columns(
        f"proposed_{which}", f"where the {which} was proposed", "; not used for any height"
    )


_MADE: Columns = columns_within(
    "values",
    text("made", "column-measurements-made", required=True, enum=get_args(Made)),
    *_optional_point_columns(
        "snapped_from", "where a person clicked before the contact went to the tyre found there"
    ),
    text("proposal", "column-measurements-proposal", enum=get_args(ProposalKept)),
    *_proposed("contact"),
    *_proposed("target"),
)
POSE: Columns = columns_within("values", key("pose_id", "camera pose used"))
_INSET: Columns = columns_within(
    "values",
    metres("inset_m", "column-measurements-inset-m"),
    metres("u_inset_m", "standard uncertainty of the inset (k = 1)"),
)
_SIDE: Columns = columns_within(
    "values",
    text("side", "column-measurements-side", enum=get_args(DriverSide)),
)
_SIDE_FROM: Columns = columns_within(
    "values",
    text("side_from", "column-measurements-side-from", enum=get_args(SideBasis)),
    text("inset_from", "column-measurements-inset-from", required=True, enum=get_args(InsetSource)),
)


def _on_frame(k: int, value: Callable[[FurtherFrame], Cell]) -> Callable[[Measurement], Cell]:
    """A value of the k-th frame of a measurement, from 2; None where fewer were clicked on."""

    def of(measurement: Measurement) -> Cell:
        more = measurement.values.more_frames
        return value(more[k - 2]) if len(more) > k - 2 else None

    return of


def _coordinate(point: Callable[[FurtherFrame], Point], axis: int) -> Callable[[FurtherFrame], Cell]:
    return lambda frame: float(point(frame)[axis])


def _further_points(k: int) -> Columns:
    """The same two points on the k-th frame; empty where fewer were clicked."""
    points: tuple[tuple[str, str, Callable[[FurtherFrame], Point]], ...] = (
        ("contact", "the same tyre contact", lambda frame: frame.contact),
        ("target", "the same target point", lambda frame: frame.target_point),
    )
    return tuple(
        number(
            f"{word}{k}_{axis}_px",
            f"{what} on frame {k} of the measurement, {axis}",
            "px",
            _on_frame(k, _coordinate(point, at)),
        )
        for word, what, point in points
        for at, axis in enumerate("xy")
    )


def _frame_number(k: int) -> Column[Measurement]:
    meaning = f"number of frame {k} that the points were clicked on"
    return integer(f"frame{k}", meaning, _on_frame(k, lambda frame: frame.frame), minimum=0)


def _frames_used(m: Measurement) -> int:
    followed = m.values.followed
    return len(m.values.frames) if followed is None else frames_of_text(followed)


_SEVERAL: Columns = (
    integer("frames", "column-measurements-frames", _frames_used, required=True, minimum=1),
    _frame_number(2),
    *_further_points(2),
    *columns_within(
        "values",
        text("followed", "column-measurements-followed"),
        metres("solved_inset_m", "column-measurements-solved-inset-m"),
        metres("u_solved_inset_m", "standard uncertainty of the inset found (k = 1)"),
    ),
)


REASON: Columns = columns_within("values", *said_columns("reason", "why there is no height"))
_FLAGS: Columns = said_columns(
    "flags", "warnings on this height, separated by semicolons", attrgetter("all_flags")
)
_HEIGHT: Columns = (
    *columns_within(
        "values",
        metres("height_m", "height of the target above the road along its normal, corrected for the inset"),
        metres("uncorrected_height_m", "column-measurements-uncorrected-height-m"),
        metres("u_height_m", "standard uncertainty of height_m (k = 1)"),
        metres("U95_height_m", "half-width of the 95 % interval of height_m"),
        metres("x_m", "contact point along the road, from the pose's origin (X)"),
        metres("y_m", "contact point across the road, away from the camera (Y)"),
        metres("u_clicks_m", "component of u_height_m from the clicks, which no other height shares"),
        metres("u_by_inset_m", "column-measurements-u-by-inset-m"),
        metres("distance_m", "from the camera's centre to the contact point"),
        text("status", "whether there is a height", required=True, enum=get_args(MeasurementStatus)),
    ),
    *REASON,
    *_FLAGS,
    *columns_within(
        "values", text("code_version", "version of the program that computed the height", required=True)
    ),
    person("created_by_id", "column-measurements-created-by-id"),
    moment("created_at", "when the revision was stored"),
    flag("withdrawn", "true if the measurement was withdrawn", required=True),
    integer("computing_id", "recomputation that made this revision from the clicks of the previous one"),
    integer("verdict_of_revision", "column-measurements-verdict-of-revision"),
)
_MEASURED: Columns = (
    *_WHERE,
    *POINTS,
    *_MADE,
    *POSE,
    *columns_within("values", key("calibration_id", "calibration behind that pose")),
    *_INSET,
    *_SIDE,
    *_SIDE_FROM,
    *_SEVERAL,
    *_HEIGHT,
)

_FILMED: Columns = (Column("filmed_at", "datetime", "column-measurements-filmed-at"),)


def verdict_basis(verdict: str, lot_id: int | None) -> str | None:
    """What a verdict rests on, in the word of its column; None while there is none."""
    if verdict == "to_review":
        return None
    return "individual" if lot_id is None else "lot"


def given_verdict(verdicts: tuple[str, ...]) -> tuple[Column[object], ...]:
    """One verdict, of a record that has its `verdict`, `reason`, `reviewer` and `at`."""
    return (
        text("verdict", "the verdict", required=True, enum=verdicts),
        text("reason", REASON_GIVEN),
        person("reviewer_id", REVIEWER),
        moment("at", "when"),
    )


def standing_verdict(verdicts: tuple[str, ...]) -> tuple[Column[ReviewState], ...]:
    """Of a revision: what stands of its reviews."""
    return (
        text("verdict", "state of the review of this revision", required=True, enum=verdicts),
        text("review_reason", REASON_GIVEN, lambda r: r.reason),
        person("reviewer_id", REVIEWER),
        moment("reviewed_at", "when it was reviewed", lambda r: r.at),
    )


MEASUREMENTS: Table[Measurement] = Table(
    "measurements",
    "The current revision of every measurement, with the verdict on it. Withdrawn ones are kept and marked.",
    (
        key("id", "measurement (a series of revisions)"),
        key("revision", "number of the current revision, from 1"),
        *_MEASURED,
        *_FILMED,
        *columns_within("review", *standing_verdict(get_args(Verdict))),
        text(
            "verdict_by",
            "column-measurements-verdict-by",
            lambda m: verdict_basis(m.review.verdict, m.review.lot_id),
            enum=get_args(VerdictBasis),
        ),
        *columns_within("review", integer("lot_id", "of a verdict by lot: the lot")),
        out_of_date("recording's road pose"),
        person("operator_id", "column-measurements-operator-id"),
        moment("clicked_at", "when the points that stand were clicked: the day of measuring"),
    ),
    primary=("id",),
    foreign=(
        *ids_of(vehicle_id="vehicles", recording_id="recordings"),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
        *ids_of(
            pose_id="poses",
            calibration_id="calibrations",
            computing_id="computings",
            created_by_id="people",
            operator_id="people",
            reviewer_id="people",
            lot_id="lots",
        ),
    ),
)

REVISIONS: Table[Measurement] = Table(
    "revisions",
    "Every revision of every measurement as it was stored: nothing is overwritten.",
    (
        key("measurement_id", "measurement that this is a revision of", lambda m: m.id),
        key("revision", "number of the revision, from 1"),
        *_MEASURED,
    ),
    primary=("measurement_id", "revision"),
    foreign=(
        *ids_of(measurement_id="measurements"),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
        *ids_of(pose_id="poses", computing_id="computings", created_by_id="people"),
    ),
)

BUDGET: Table[BudgetEntry] = Table(
    "budget",
    "The contributions to each current u_height_m; their root sum of squares is u_height_m.",
    (
        key("measurement_id", "measurement"),
        text("source", "source of uncertainty", required=True),
        metres("u_m", "its contribution to the standard uncertainty of the height"),
    ),
    primary=("measurement_id", "source"),
    foreign=ids_of(measurement_id="measurements"),
)


def _reference_height_m(clicked: Clicked) -> Cell:
    """What was known of the target's height; what was chosen by size is no reference."""
    vehicle = clicked.vehicle
    return (
        vehicle.known_m[clicked.measurement.values.target] if is_reference(vehicle.model_chosen_by) else None
    )


CLICKS: Table[Clicked] = Table(
    "clicks",
    "The clicks of every current measurement, as `sightline height --clicks` reads them; those of each pose "
    "alone are in clicks/pose-N.csv, to be used with poses/pose-N.json.",
    (
        text("id", "measurement the clicks belong to", lambda c: f"m{c.measurement.id}", required=True),
        *columns_within("measurement", *POINTS, *_INSET, *_SIDE, *_further_points(2)),
        *columns_within(
            "vehicle", text("lighting", "light at the time of the pass", enum=get_args(Lighting))
        ),
        metres(
            "reference_height_m",
            "known height of the target; empty where the model was chosen by size",
            _reference_height_m,
        ),
        *columns_within(
            "measurement.values", text("target", "what was measured", required=True, enum=TARGETS)
        ),
        *columns_within(
            "vehicle",
            text("category", "body of the vehicle", enum=get_args(Category)),
            flag(
                "check_target",
                "whether it checks the measuring, and is no vehicle of the traffic",
                required=True,
            ),
        ),
        flag(
            "counts",
            "whether the statistics of this package evaluate its height: accepted, of a vehicle that counts "
            "(vehicles.csv) and that the package is of (selection.csv)",
            lambda c: c.evaluated and not c.vehicle.check_target,
            required=True,
        ),
        flag(
            "error_counts",
            "whether the statistics of this package evaluate its error, where its reference height is known: "
            "as counts, and also for check targets",
            lambda c: c.evaluated,
            required=True,
        ),
        *columns_within("measurement.values", key("pose_id", "camera pose for the height")),
        text(
            "pose_file",
            "that pose as a file of this package",
            lambda c: pose_path(c.measurement.values.pose_id),
            required=True,
        ),
    ),
    primary=("id",),
    foreign=ids_of(pose_id="poses"),
)


_FRAME = re.compile(r"frame(\d+)")


def count_frames(columns: Iterable[str]) -> int:
    """For how many frames of a measurement a table has columns, at least two."""
    return max((int(found[1]) for name in columns if (found := _FRAME.fullmatch(name))), default=2)


def with_frames(table: Table[Measurement], most: int) -> Table[Measurement]:
    """The table with the columns of frames 3 to `most`."""
    return _with_frames(table, most, lambda columns: columns)


def clicks_with_frames(most: int) -> Table[Clicked]:
    """The table of clicks with the columns of frames 3 to `most`."""
    return _with_frames(CLICKS, most, lambda columns: columns_within("measurement", *columns))


def _with_frames(
    table: Table[Record], most: int, of_records: Callable[[Columns], tuple[Column[Record], ...]]
) -> Table[Record]:
    """Frame numbers follow that of the second, points those of the second."""
    columns: list[Column[Record]] = []
    for column in table.columns:
        columns.append(column)
        if column.name == "frame2":
            columns += of_records(tuple(_frame_number(k) for k in range(3, most + 1)))
        elif column.name == "target2_y_px":
            columns += of_records(tuple(one for k in range(3, most + 1) for one in _further_points(k)))
    return replace(table, columns=tuple(columns))
