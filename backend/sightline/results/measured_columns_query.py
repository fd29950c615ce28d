"""All measurements that statistics are made of, as columns: one question to the database.

A package's tables give the same columns (`export.measured`), and `measured_of` makes the same of both.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from datetime import date
from typing import Any, Self, get_args

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import ColumnElement, Select, case, func, null, select
from sqlalchemy.orm import Session

from sightline.arrays import Floats, Ints
from sightline.enums import Category, ClassSet, Direction, Lighting, Target, Verdict
from sightline.errors import Damaged
from sightline.geometry.documents import camera_across_m
from sightline.measurements.query import (
    clicked_at,
    is_current,
    is_first,
    operator_id,
    series,
    verdict,
    with_verdict,
)
from sightline.measurements.tables import measurements
from sightline.poses.tables import road_poses
from sightline.recordings.filming import filming_of
from sightline.recordings.frames.tables import frames
from sightline.recordings.tables import recordings
from sightline.surveys.classes import sets_of
from sightline.surveys.store import classes_of_surveys
from sightline.vehicles.records import BY_SIZE, KNOWN
from sightline.vehicles.store import FIRST, FIRST_S, vehicles_outside
from sightline.vehicles.tables import vehicles

#: The values of a column, None for nothing.
Values = Iterable[Any]

TARGETS: tuple[str, ...] = get_args(Target)
LIGHTING: tuple[str, ...] = get_args(Lighting)
LANES: tuple[str, ...] = get_args(Direction)
CATEGORIES: tuple[str, ...] = get_args(Category)
CLASS_SETS: tuple[str, ...] = get_args(ClassSet)
VERDICTS: tuple[str, ...] = get_args(Verdict)
# What a height's total uncertainty is made of, beside its pose.
UNCERTAINTY = ("inset_m", "u_inset_m", "u_height_m", "u_clicks_m", "u_by_inset_m")
NONE = -1
#: The words of each column.
WORDS: Mapping[str, Sequence[str]] = {
    "target": TARGETS,
    "lighting": LIGHTING,
    "lane": LANES,
    "category": CATEGORIES,
    "class_set": CLASS_SETS,
    "verdict": VERDICTS,
}
_TRUTHS = ("by_size", "check_target", "counts")
_IN_MICROMETRES = ("height_m", "uncorrected_height_m", "known_m", "u_known_m", *UNCERTAINTY)
_BY_SIZE: ColumnElement[bool] = vehicles.c.model_chosen_by == BY_SIZE
_AT_ONCE = 5_000  # rows that are objects at a time: of more the garbage collector makes much work
_TIE = 1e-3  # micrometres from a tie: what is so close is rounded digit by digit
_EPOCH = date(1970, 1, 1).toordinal()


@dataclass(frozen=True, eq=False)
class Heights:
    """What the figures of heights (N,) are made of; words and lengths are those of `Measured`."""

    survey_id: Ints
    pose_id: Ints
    category: Ints
    lighting: Ints
    class_set: Ints
    height_m: Floats
    known_m: Floats
    inset_m: Floats
    u_inset_m: Floats
    u_height_m: Floats
    u_clicks_m: Floats
    u_by_inset_m: Floats

    def __len__(self) -> int:
        return len(self.height_m)

    def where(self, chosen: NDArray[np.bool_] | Ints) -> Self:
        """The rows that are chosen, (N,) by truth or (M,) by place."""
        if chosen.dtype == np.bool_ and chosen.all():
            return self
        return type(self)(**{one.name: getattr(self, one.name)[chosen] for one in fields(self)})

    def of_classes(
        self, categories: Sequence[Category], class_sets: Sequence[ClassSet] = ()
    ) -> NDArray[np.bool_]:
        """Whose vehicles (N,) are of one of the classes, or count in one of the sets."""
        of_set = np.isin(self.class_set, [CLASS_SETS.index(one) for one in class_sets])
        return of_set | np.isin(self.category, [CATEGORIES.index(one) for one in categories])


@dataclass(frozen=True, eq=False)
class Measured(Heights):
    """Standing measurements with a height, (N,) each: current, not withdrawn, no repeats, of living vehicles.

    In the order of `measurement_id`. Words are indices into TARGETS, LIGHTING, LANES (the way that a vehicle
    goes in the picture), CATEGORIES, CLASS_SETS,
    VERDICTS, -1 for none; `class_set` is what the survey makes of the category; `day`: when its points were
    clicked, days since 1970-01-01 (UTC), 0 unless asked for; `filmed_hour`: the full hour in which its pass
    was filmed, by the clocks of the place, hours since the beginning of 1970-01-01, -1 where nobody has
    confirmed the start of its recording; `known_m`: what was known of the target's height before it was
    measured, of a roof the maker's; `by_size`: its vehicle's model was chosen by its sizes, so nothing of it
    is known for a reference; `check_target`: of no vehicle of the traffic; `counts`: in results, by what its
    survey says of heights out of its sample; `across_m`: the contact's distance from the camera across the
    road; lengths in metres, NaN where unknown.
    """

    measurement_id: Ints
    vehicle_id: Ints
    operator_id: Ints
    day: Ints
    filmed_hour: Ints
    target: Ints
    lane: Ints
    verdict: Ints
    uncorrected_height_m: Floats
    u_known_m: Floats
    by_size: NDArray[np.bool_]
    check_target: NDArray[np.bool_]
    counts: NDArray[np.bool_]
    across_m: Floats


def load_measured_columns(
    session: Session, survey_ids: Sequence[int] | None = None, *, days: bool = False
) -> Measured:
    """The columns of some surveys, or of all, from one state of the database.

    days: whether each one's day is wanted. Raises Damaged for a word that the program does not know.
    """
    outside = list(vehicles_outside(session, survey_ids))
    parts = [
        _chunk(session, rows, outside)
        for rows in session.execute(_standing(survey_ids, days)).partitions(_AT_ONCE)
    ]
    whole = parts or [_chunk(session, [], outside)]
    return Measured(
        **{one.name: np.concatenate([getattr(part, one.name) for part in whole]) for one in fields(Measured)}
    )


def measured_of(columns: Mapping[str, Values]) -> Measured:
    """The columns of `Measured` by name out of their values: words as words, None for nothing.

    Lengths become those that a package writes, so that page, package and study compute of the same numbers
    and their figures agree to the last digit. Raises Damaged for a word that the program does not know.
    """
    arrays: dict[str, Any] = {}
    for field in fields(Measured):
        values = list(columns[field.name])
        if field.name in WORDS:
            arrays[field.name] = _codes(field.name, values, WORDS[field.name])
        elif field.name in _TRUTHS:
            arrays[field.name] = np.array(values, dtype=np.bool_)
        elif field.name.endswith("_m"):
            length_m = np.array(values, dtype=np.float64)
            arrays[field.name] = micrometres(length_m) if field.name in _IN_MICROMETRES else length_m
        else:
            arrays[field.name] = np.array(
                [NONE if value is None else value for value in values], dtype=np.int64
            )
    return Measured(**arrays)


def day_of(at: date) -> int:
    """Days since 1970-01-01."""
    return at.toordinal() - _EPOCH


def micrometres(length_m: Floats) -> Floats:
    """Lengths (N,) as a package writes them: the decimal of six places next to each, NaN for NaN."""
    scaled = length_m * 1e6
    found = np.asarray(np.rint(scaled) / 1e6 + 0.0, dtype=np.float64)
    for n in np.flatnonzero(np.abs(np.abs(scaled - np.trunc(scaled)) - 0.5) < _TIE).tolist():
        found[n] = float(f"{length_m[n]:.6f}") + 0.0
    return found


def _standing(survey_ids: Sequence[int] | None, days: bool) -> Select[Any]:
    """A row a measurement, in the order of their numbers: of no repeat, withdrawn one or removed vehicle; a
    vehicle without lighting has its recording's.
    """
    m, v, r = measurements.c, vehicles.c, recordings.c
    query = (
        with_verdict(
            series.c.id.label("measurement_id"),
            series.c.vehicle_id,
            series.c.survey_id,
            operator_id.label("operator_id"),
            (clicked_at if days else null()).label("day"),
            v.recording_id,
            FIRST_S,
            m.target,
            func.coalesce(v.lighting, r.lighting).label("lighting"),
            v.direction.label("lane"),
            v.category,
            verdict.label("verdict"),
            m.height_m,
            m.uncorrected_height_m,
            _reference_column({target: v[KNOWN[target].height] for target in get_args(Target)}).label(
                "known_m"
            ),
            _reference_column({target: v[KNOWN[target].u] for target in get_args(Target)}).label("u_known_m"),
            case((_BY_SIZE, 1), else_=0).label("by_size"),
            case((v.check_target, 1), else_=0).label("check_target"),
            m.pose_id,
            m.y_m,
            *(m[name] for name in UNCERTAINTY),
        )
        .join(vehicles, v.id == series.c.vehicle_id)
        .join(recordings, r.id == v.recording_id)
        .outerjoin(frames, FIRST)
        .where(is_current, is_first, ~m.withdrawn, m.height_m.is_not(None), v.deleted_at.is_(None))
        .order_by(series.c.id)
    )
    return query if survey_ids is None else query.where(series.c.survey_id.in_(survey_ids))


def _reference_column(of_target: Mapping[str, ColumnElement[Any]]) -> ColumnElement[Any]:
    """What is known of the target; of a model chosen by size nothing is a reference."""
    return case((_BY_SIZE, null()), else_=case(of_target, value=measurements.c.target))


def _chunk(session: Session, rows: Sequence[Any], outside: list[int]) -> Measured:
    """Rows of `_standing`, and what stands in no column."""
    names = _standing(None, False).selected_columns.keys()
    columns: dict[str, Values] = dict(
        zip(names, zip(*rows, strict=True) if rows else [()] * len(names), strict=True)
    )
    survey = np.array(columns["survey_id"], dtype=np.int64)
    pose = np.array(columns["pose_id"], dtype=np.int64)
    measured = measured_of(
        {
            **columns,
            "day": [0 if at is None else day_of(at) for at in columns["day"]],
            "filmed_hour": _filmed_hours(session, columns["recording_id"], columns["first_s"]),
            "class_set": [None] * len(rows),
            "counts": ~np.array(columns["check_target"], dtype=np.bool_)
            & ~np.isin(np.array(columns["vehicle_id"], dtype=np.int64), outside),
            "across_m": np.array(columns["y_m"], dtype=np.float64) - _cameras_across(session, pose),
        }
    )
    return replace(measured, class_set=_class_sets(session, survey, measured.category))


def _filmed_hours(session: Session, recording_ids: Values, first_s: Values) -> Ints:
    """The hour in which each pass (N,) was filmed, NONE where nobody has confirmed its recording's start."""
    recording, seconds = np.array(recording_ids, dtype=np.int64), np.array(first_s, dtype=np.float64)
    hour = np.full(len(recording), NONE, dtype=np.int64)
    r = recordings.c
    query = select(r.id, r.started_at, r.time_zone)
    for row in session.execute(query.where(r.started_at.is_not(None))).mappings():
        of, filming = np.flatnonzero((recording == row["id"]) & np.isfinite(seconds)), filming_of(row)
        if filming is not None:
            hour[of] = filming.hours(seconds[of])
    return hour


def _cameras_across(session: Session, pose_id: Ints) -> Floats:
    """Where the camera of each row's pose (N,) stands along the road's Y, metres; NaN without a place."""
    distinct, row = np.unique(pose_id, return_inverse=True)
    query = select(road_poses.c.id, road_poses.c.document).where(road_poses.c.id.in_(distinct.tolist()))
    documents = {found.id: found.document for found in session.execute(query)}
    at = np.array([camera_across_m(documents.get(int(one), {})) for one in distinct], dtype=np.float64)
    return at[row] if len(at) else np.zeros(len(pose_id))


def _codes(name: str, values: Sequence[str | None], words: Sequence[str]) -> Ints:
    """The index of each word, NONE for none."""
    code: dict[str | None, int] = {None: NONE, **{word: n for n, word in enumerate(words)}}
    try:
        return np.array([code[word] for word in values], dtype=np.int64)
    except KeyError as unknown:
        raise Damaged("results-word-unknown", name=name, unknown=str(unknown.args[0])) from None


def _class_sets(session: Session, survey: Ints, category: Ints) -> Ints:
    """The set of each class (N,) in its survey (N,), NONE for none."""
    sets = np.full(len(survey), NONE, dtype=np.int64)
    of = {id_: np.array([*sets_of(table), NONE]) for id_, table in classes_of_surveys(session).items()}
    for id_ in np.unique(survey):
        rows = survey == id_
        sets[rows] = of[int(id_)][category[rows]]  # the last place is for no class
    return sets
