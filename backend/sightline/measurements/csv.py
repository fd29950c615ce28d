"""The tables of measurements in the package: current ones, revisions, budgets, clicks."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from operator import attrgetter
from typing import get_args

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
    flag,
    integer,
    key,
    metres,
    moment,
    number,
    of_part,
    person,
    pixel,
    said,
    text,
)
from sightline.infra.csv_package.schema import Cell, Column, Table
from sightline.measurements.again.csv import out_of_date
from sightline.measurements.followed_text import frames_of_text
from sightline.measurements.records import FurtherFrame, Measurement, ReviewState
from sightline.messages.said import Said
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
    counts: bool


@dataclass(frozen=True, slots=True)
class Clicked:
    """A measurement and the vehicle that it is of."""

    measurement: Measurement
    vehicle: OfVehicle


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
    key("vehicle_id", "vehicle that was measured", lambda m: m.vehicle_id),
    key("recording_id", "recording in which the points were clicked", lambda m: m.recording_id),
)
FRAME: Columns = (
    integer(
        "frame",
        "frame number: the n-th decoded frame, from 0",
        lambda m: m.values.frame,
        required=True,
        minimum=0,
    ),
    integer(
        "pts",
        "presentation time stamp of that frame, in the stream's own time base",
        lambda m: m.values.pts,
    ),
    number("time_s", "time of that frame from the start of the stream", "s", lambda m: m.values.time_s),
)
_WHERE: Columns = (
    *PASS,
    text("target", "what was measured", lambda m: m.values.target, required=True, enum=TARGETS),
    *FRAME,
    integer(
        "frame_crc32",
        "CRC-32 of the decoded luma of that frame: proof of what was clicked on",
        lambda m: m.values.frame_crc32,
    ),
)
POINTS: Columns = (
    pixel(
        "contact_x_px",
        "where the tyre meets the road, x to the right",
        lambda m: float(m.values.contact[0]),
    ),
    pixel("contact_y_px", "where the tyre meets the road, y down", lambda m: float(m.values.contact[1])),
    pixel("target_x_px", "the target point, x to the right", lambda m: float(m.values.target_point[0])),
    pixel("target_y_px", "the target point, y down", lambda m: float(m.values.target_point[1])),
    number(
        "sigma_px",
        "standard uncertainty of each coordinate of each click",
        "px",
        lambda m: float(m.values.sigma_px),
        minimum=0,
    ),
)


def _proposed(which: str) -> Columns:
    """Where a point was proposed; of no height."""
    return tuple(
        pixel(
            f"proposed_{which}_{axis}_px",
            f"where the {which} was proposed, {way}; it counts for no height",
            partial(_value, name=f"proposed_{which}_{axis}_px"),
            required=False,
        )
        for axis, way in (("x", "x to the right"), ("y", "y down"))
    )


def _value(m: Measurement, name: str) -> float | None:
    found: float | None = getattr(m.values, name)
    return found


_MADE: Columns = (
    text(
        "made",
        "how the points on `frame` were set: clicked: by hand (the contact may be a proposed one where no "
        "target was proposed); snapped: the contact moved from a click to the tyre found there; confirmed: "
        "as proposed; moved: from proposed or found points (contact or target), at least one of which a "
        "person placed",
        lambda m: m.values.made,
        required=True,
        enum=get_args(Made),
    ),
    pixel(
        "snapped_from_x_px",
        "where a person clicked before the contact went to the tyre found there, x to the right",
        lambda m: m.values.snapped_from_x_px,
        required=False,
    ),
    pixel(
        "snapped_from_y_px",
        "where a person clicked before the contact went to the tyre found there, y down",
        lambda m: m.values.snapped_from_y_px,
        required=False,
    ),
    text(
        "proposal",
        "whether contact and target were proposed on `frame` when it was measured: shown, or withheld: the "
        "vehicle was drawn to be measured free; empty where one of them was not proposed",
        lambda m: m.values.proposal,
        enum=get_args(ProposalKept),
    ),
    *_proposed("contact"),
    *_proposed("target"),
)
POSE: Columns = (key("pose_id", "camera pose used", lambda m: m.values.pose_id),)
_INSET: Columns = (
    metres(
        "inset_m",
        "inset: distance from the vertical plane through the contact point to the target, along road Y",
        lambda m: m.values.inset_m,
    ),
    metres("u_inset_m", "standard uncertainty of the inset (k = 1)", lambda m: m.values.u_inset_m),
)
_SIDE: Columns = (
    text(
        "side",
        "of an eye: on which side of the vehicle, as the camera sees it, the driver sits",
        lambda m: m.values.side,
        enum=get_args(DriverSide),
    ),
)
_SIDE_FROM: Columns = (
    text(
        "side_from",
        "source of the side: entered for this vehicle, its direction, or the lane next to the camera",
        lambda m: m.values.side_from,
        enum=get_args(SideBasis),
    ),
    text(
        "inset_from",
        "whether the inset is the survey's usual one or this measurement's own",
        lambda m: m.values.inset_from,
        required=True,
        enum=get_args(InsetSource),
    ),
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
    integer(
        "frames",
        "on how many frames the points were clicked, or followed through a whole pass",
        _frames_used,
        required=True,
        minimum=1,
    ),
    _frame_number(2),
    *_further_points(2),
    text(
        "followed",
        "of a whole pass: JSON of the points followed from those on `frame` (docs/formats.md); height_m is "
        "then that of all of them",
        lambda m: m.values.followed,
    ),
    metres(
        "solved_inset_m",
        "the inset found from several frames or a whole pass; inset_m is then not used for height_m, of a "
        "whole pass only as what is known beforehand",
        lambda m: m.values.solved_inset_m,
    ),
    metres(
        "u_solved_inset_m",
        "standard uncertainty of the inset found (k = 1)",
        lambda m: m.values.u_solved_inset_m,
    ),
)


def _reason_of(one: Measurement) -> Said | None:
    return one.values.reason


def _flags_of(one: Measurement) -> list[Said]:
    return one.all_flags


REASON: Columns = said("reason", "why there is no height", _reason_of)
_FLAGS: Columns = said("flags", "warnings on this height, separated by semicolons", _flags_of)
_HEIGHT: Columns = (
    metres(
        "height_m",
        "height of the target above the road along its normal, corrected for the inset",
        lambda m: m.values.height_m,
    ),
    metres(
        "uncorrected_height_m",
        "the first frame's height with an inset of 0 (the paper's assumption)",
        lambda m: m.values.uncorrected_height_m,
    ),
    metres("u_height_m", "standard uncertainty of height_m (k = 1)", lambda m: m.values.u_height_m),
    metres("U95_height_m", "half-width of the 95 % interval of height_m", lambda m: m.values.U95_height_m),
    metres("x_m", "contact point along the road, from the pose's origin (X)", lambda m: m.values.x_m),
    metres("y_m", "contact point across the road, away from the camera (Y)", lambda m: m.values.y_m),
    metres(
        "u_clicks_m",
        "component of u_height_m from the clicks, which no other height shares",
        lambda m: m.values.u_clicks_m,
    ),
    metres(
        "u_by_inset_m",
        "component of u_height_m from the assumed inset; the remaining component is that of the camera pose",
        lambda m: m.values.u_by_inset_m,
    ),
    metres("distance_m", "from the camera's centre to the contact point", lambda m: m.values.distance_m),
    text(
        "status",
        "whether there is a height",
        lambda m: m.values.status,
        required=True,
        enum=get_args(MeasurementStatus),
    ),
    *REASON,
    *_FLAGS,
    text(
        "code_version",
        "version of the program that computed the height",
        lambda m: m.values.code_version,
        required=True,
    ),
    person("created_by_id", "who clicked the points", lambda m: m.created_by),
    moment("created_at", "when the revision was stored", lambda m: m.created_at),
    flag("withdrawn", "true if the measurement was withdrawn", lambda m: m.withdrawn, required=True),
    integer(
        "computing_id",
        "what computed the revision again, with the clicks of the revision before",
        lambda m: m.computing_id,
    ),
    integer(
        "verdict_of_revision",
        "the revision before it whose verdict holds for this one too: computed again, it moved by no more "
        "than its u, or its points were put back where they were",
        lambda m: m.verdict_of_revision,
    ),
)
_MEASURED: Columns = (
    *_WHERE,
    *POINTS,
    *_MADE,
    *POSE,
    key("calibration_id", "calibration behind that pose", lambda m: m.values.calibration_id),
    *_INSET,
    *_SIDE,
    *_SIDE_FROM,
    *_SEVERAL,
    *_HEIGHT,
)

_FILMED: Columns = (
    Column(
        "filmed_at",
        "datetime",
        "when that frame was filmed, by the clocks of the place (ISO 8601 with offset): started_at of its "
        "recording and time_s; empty while nobody has confirmed that start",
        of=lambda m: m.filmed_at,
    ),
)


def verdict_basis(verdict: str, lot_id: int | None) -> str | None:
    """What a verdict rests on, in the word of its column; None while there is none."""
    if verdict == "to_review":
        return None
    return "individual" if lot_id is None else "lot"


def given_verdict(verdicts: tuple[str, ...]) -> tuple[Column[object], ...]:
    """One verdict, of a record that has its `verdict`, `reason`, `reviewer` and `at`."""
    return (
        text("verdict", "the verdict", attrgetter("verdict"), required=True, enum=verdicts),
        text("reason", REASON_GIVEN, attrgetter("reason")),
        person("reviewer_id", REVIEWER, attrgetter("reviewer")),
        moment("at", "when", attrgetter("at")),
    )


def standing_verdict(verdicts: tuple[str, ...]) -> tuple[Column[ReviewState], ...]:
    """Of a revision: what stands of its reviews."""
    return (
        text(
            "verdict",
            "state of the review of this revision",
            lambda r: r.verdict,
            required=True,
            enum=verdicts,
        ),
        text("review_reason", REASON_GIVEN, lambda r: r.reason),
        person("reviewer_id", REVIEWER, lambda r: r.reviewer),
        moment("reviewed_at", "when it was reviewed", lambda r: r.at),
    )


def _review(measurement: Measurement) -> ReviewState:
    return measurement.review


MEASUREMENTS: Table[Measurement] = Table(
    "measurements",
    "The current revision of every measurement, with the verdict on it. Withdrawn ones are kept and marked.",
    (
        key("id", "measurement (a series of revisions)", lambda m: m.id),
        key("revision", "number of the current revision, from 1", lambda m: m.revision),
        *_MEASURED,
        *_FILMED,
        *of_part(standing_verdict(get_args(Verdict)), _review),
        text(
            "verdict_by",
            "whether a reviewer judged this measurement itself, or its lot by a sample",
            lambda m: verdict_basis(m.review.verdict, m.review.lot_id),
            enum=get_args(VerdictBasis),
        ),
        integer("lot_id", "of a verdict by lot: the lot", lambda m: m.review.lot_id),
        out_of_date("recording's road pose", lambda m: m.out_of_date),
    ),
    primary=("id",),
    foreign=(
        (("vehicle_id",), "vehicles", ("id",)),
        (("recording_id",), "recordings", ("id",)),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
        (("pose_id",), "poses", ("id",)),
        (("calibration_id",), "calibrations", ("id",)),
        (("computing_id",), "computings", ("id",)),
        (("created_by_id",), "people", ("id",)),
        (("reviewer_id",), "people", ("id",)),
        (("lot_id",), "lots", ("id",)),
    ),
)

REVISIONS: Table[Measurement] = Table(
    "revisions",
    "Every revision of every measurement as it was stored: nothing is overwritten.",
    (
        key("measurement_id", "measurement that this is a revision of", lambda m: m.id),
        key("revision", "number of the revision, from 1", lambda m: m.revision),
        *_MEASURED,
    ),
    primary=("measurement_id", "revision"),
    foreign=(
        (("measurement_id",), "measurements", ("id",)),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
        (("pose_id",), "poses", ("id",)),
        (("computing_id",), "computings", ("id",)),
        (("created_by_id",), "people", ("id",)),
    ),
)

BUDGET: Table[BudgetEntry] = Table(
    "budget",
    "The contributions to each current u_height_m; their root sum of squares is u_height_m.",
    (
        key("measurement_id", "measurement", lambda entry: entry.measurement_id),
        text("source", "source of uncertainty", lambda entry: entry.source, required=True),
        metres(
            "u_m",
            "its contribution to the standard uncertainty of the height",
            lambda entry: entry.u_m,
        ),
    ),
    primary=("measurement_id", "source"),
    foreign=((("measurement_id",), "measurements", ("id",)),),
)


def _measurement(clicked: Clicked) -> Measurement:
    return clicked.measurement


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
        *of_part((*POINTS, *_INSET, *_SIDE, *_further_points(2)), _measurement),
        text(
            "lighting",
            "light at the time of the pass",
            lambda c: c.vehicle.lighting,
            enum=get_args(Lighting),
        ),
        metres(
            "reference_height_m",
            "known height of the target; empty where the model was chosen by size",
            _reference_height_m,
        ),
        text(
            "target", "what was measured", lambda c: c.measurement.values.target, required=True, enum=TARGETS
        ),
        text("category", "body of the vehicle", lambda c: c.vehicle.category, enum=get_args(Category)),
        flag(
            "check_target",
            "whether it checks the measuring, and is no vehicle of the traffic",
            lambda c: c.vehicle.check_target,
            required=True,
        ),
        flag(
            "counts",
            "whether its height counts in results, as its vehicle's in vehicles.csv",
            lambda c: c.vehicle.counts,
            required=True,
        ),
        key("pose_id", "camera pose for the height", lambda c: c.measurement.values.pose_id),
        text(
            "pose_file",
            "that pose as a file of this package",
            lambda c: pose_path(c.measurement.values.pose_id),
            required=True,
        ),
    ),
    primary=("id",),
    foreign=((("pose_id",), "poses", ("id",)),),
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
    return _with_frames(CLICKS, most, lambda columns: of_part(columns, _measurement))


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
