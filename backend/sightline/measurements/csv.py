"""The tables of measurements in the package: current ones, revisions, budgets, clicks."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from operator import attrgetter
from typing import get_args

from typing_extensions import TypeVar

from sightline.enums import (
    Category,
    Lighting,
    Point,
    Target,
    Verdict,
    VerdictBasis,
)
from sightline.infra.csv_package.columns import (
    columns_for,
    columns_within,
    flag,
    integer,
    key,
    metres,
    moment,
    number,
    person,
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


WHERE: Columns = (
    *columns_for(Measurement, "vehicle_id recording_id"),
    *columns_within(
        "values",
        *columns_for(MeasurementValues, "target"),
        *columns_for(MeasurementValues, "frame", minimum=0),
        *columns_for(MeasurementValues, "pts time_s frame_crc32"),
    ),
)


def _clicked(name: str, point: Callable[[MeasurementValues], Point]) -> Columns:
    """A point on the first frame."""

    def column(at: int, axis: str) -> Column[Measurement]:
        says = f"column-measurements-{name}-{axis}-px"
        return number(f"{name}_{axis}_px", says, "px", lambda m: float(point(m.values)[at]), required=True)

    return tuple(column(at, axis) for at, axis in enumerate("xy"))


POINTS: Columns = (
    *_clicked("contact", lambda values: values.contact),
    *_clicked("target", lambda values: values.target_point),
    *columns_within("values", *columns_for(MeasurementValues, "sigma_px", minimum=0)),
)
_MADE = columns_for(
    MeasurementValues,
    "made snapped_from_x_px snapped_from_y_px proposal "
    "proposed_contact_x_px proposed_contact_y_px proposed_target_x_px proposed_target_y_px",
)
POSE: Columns = columns_within("values", *columns_for(MeasurementValues, "pose_id"))
INSET: Columns = columns_within("values", *columns_for(MeasurementValues, "inset_m u_inset_m"))
_SIDE: Columns = columns_within("values", *columns_for(MeasurementValues, "side"))


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
    *columns_within("values", *columns_for(MeasurementValues, "followed solved_inset_m u_solved_inset_m")),
)


_FLAGS: Columns = said_columns(
    "flags", "warnings on this height, separated by semicolons", attrgetter("all_flags")
)
_HEIGHT: Columns = (
    *columns_within(
        "values",
        *columns_for(MeasurementValues, "height_m uncorrected_height_m u_height_m U95_height_m x_m y_m"),
        *columns_for(MeasurementValues, "u_clicks_m u_by_inset_m distance_m status reason"),
    ),
    *_FLAGS,
    *columns_within("values", *columns_for(MeasurementValues, "code_version", required=True)),
    *columns_for(Measurement, "created_by_id created_at withdrawn computing_id verdict_of_revision"),
)
_MEASURED: Columns = (
    *WHERE,
    *POINTS,
    *columns_within("values", *_MADE, *columns_for(MeasurementValues, "pose_id calibration_id")),
    *INSET,
    *_SIDE,
    *columns_within("values", *columns_for(MeasurementValues, "side_from inset_from")),
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
        *columns_for(Measurement, "id revision"),
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
        *columns_for(Measurement, "operator_id clicked_at"),
    ),
    primary=("id",),
    foreign=(
        *ids_of(vehicle_id="vehicles", recording_id="recordings"),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
        *ids_of(
            pose_id="poses",
            calibration_id="calibrations",
            computing_id="computings",
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
        *ids_of(pose_id="poses", computing_id="computings"),
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
        *columns_within("measurement", *POINTS, *INSET, *_SIDE, *_further_points(2)),
        *columns_within(
            "vehicle", text("lighting", "light at the time of the pass", enum=get_args(Lighting))
        ),
        metres(
            "reference_height_m",
            "known height of the target; empty where the model was chosen by size",
            _reference_height_m,
        ),
        *columns_within("measurement.values", *columns_for(MeasurementValues, "target")),
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
