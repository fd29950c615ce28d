"""All measurements that statistics are made of, as columns: plain scans in SQL, joined in NumPy.

Lists of records cost 30 microseconds a row; these columns must serve a million rows. Joins in SQL cost more
than those by position here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, get_args

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import ColumnElement, Select, case, func, null, select
from sqlalchemy.orm import Session

from sightline.enums import Category, ClassSet, Direction, Lighting, Target, Verdict
from sightline.errors import Damaged
from sightline.geometry.documents import camera_across_m
from sightline.infra.audit.tables import audit_chains
from sightline.measurements.tables import measurement_series, measurements, reviews
from sightline.poses.tables import road_poses
from sightline.recordings.filming import filming_of, frame_s
from sightline.recordings.tables import recordings
from sightline.surveys.classes import sets_of
from sightline.surveys.store import classes_of_surveys
from sightline.vehicles.records import BY_SIZE, KNOWN
from sightline.vehicles.store import vehicles_outside
from sightline.vehicles.tables import vehicles

if TYPE_CHECKING:
    import pyarrow as pa

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

TARGETS: tuple[str, ...] = get_args(Target)
LIGHTING: tuple[str, ...] = get_args(Lighting)
LANES: tuple[str, ...] = get_args(Direction)
CATEGORIES: tuple[str, ...] = get_args(Category)
CLASS_SETS: tuple[str, ...] = get_args(ClassSet)
VERDICTS: tuple[str, ...] = get_args(Verdict)
# What a height's total uncertainty is made of, beside its pose.
UNCERTAINTY = ("inset_m", "u_inset_m", "u_height_m", "u_clicks_m", "u_by_inset_m")
NONE = -1
# The fields of each target's known height, in the order of TARGETS.
_KNOWN = tuple(KNOWN[target] for target in get_args(Target))
_BY_SIZE: ColumnElement[bool] = vehicles.c.model_chosen_by == BY_SIZE
_SPARSE = 2**20
_FEW = 20_000  # series: so many are read sooner through the session than another connection is opened
_TIE = 1e-3  # micrometres from a tie: what is so close is rounded digit by digit


@dataclass(frozen=True, eq=False)
class Measured:
    """Standing measurements with a height, (N,) each: current, not withdrawn, no repeats, of living vehicles.

    In the order of `measurement_id`. Words are indices into TARGETS, LIGHTING, LANES (the way that a vehicle
    goes in the picture), CATEGORIES, CLASS_SETS,
    VERDICTS, -1 for none; `class_set` is what the survey makes of the category; `day` counts days since
    1970-01-01 (UTC) of the revision's making, 0 unless asked for; `filmed_day`: the day on which
    its pass was filmed, by the clocks of the place, days since 1970-01-01, -1 where nobody has confirmed the
    start of its recording; `known_m`: what was known of the target's height before it was measured, of a roof
    the maker's; `by_size`: its vehicle's model was chosen by its sizes, so nothing of it is known for a
    reference; `check_target`: of no vehicle of the traffic; `counts`: in results, by what its survey says of
    heights out of its sample; `across_m`: the contact's distance from the
    camera across the road; lengths in metres, NaN where unknown.
    """

    measurement_id: Ints
    vehicle_id: Ints
    survey_id: Ints
    operator_id: Ints
    day: Ints
    filmed_day: Ints
    target: Ints
    lighting: Ints
    lane: Ints
    category: Ints
    class_set: Ints
    verdict: Ints
    height_m: Floats
    uncorrected_height_m: Floats
    known_m: Floats
    u_known_m: Floats
    by_size: NDArray[np.bool_]
    check_target: NDArray[np.bool_]
    counts: NDArray[np.bool_]
    pose_id: Ints
    across_m: Floats
    inset_m: Floats
    u_inset_m: Floats
    u_height_m: Floats
    u_clicks_m: Floats
    u_by_inset_m: Floats

    def __len__(self) -> int:
        return len(self.measurement_id)

    def where(self, chosen: NDArray[np.bool_] | Ints) -> Measured:
        """The rows that are chosen, (N,) by truth or (M,) by place."""
        return Measured(**{one.name: getattr(self, one.name)[chosen] for one in fields(self)})


def load_measured_columns(
    session: Session, survey_ids: Sequence[int] | None = None, *, days: bool = False
) -> Measured:
    """The columns of some surveys, or of all, from one state of the database.

    Lengths are as a package writes them, so that page, package and study compute of the same numbers and
    their figures agree to the last digit. days: whether each one's day is wanted. Raises Damaged for a word
    that the program does not know.
    """
    series, cars, revisions, judged = _tables(session, survey_ids, days)
    id_, car_id = _ints(series, "id"), _ints(cars, "id")
    order = np.argsort(id_, kind="stable")
    id_, vehicle = id_[order], _ints(series, "vehicle_id")[order]
    at_series = _Places(id_)
    row, revision = _newest(at_series, revisions, len(id_))
    verdict = _verdicts(at_series, judged, revision, _carried(revisions, row))
    height = np.append(_floats(revisions, "height_m"), np.nan)[row]
    car = _Places(car_id)(vehicle)
    keep = (row != NONE) & ~np.isnan(height) & (car != NONE)
    row, car = row[keep], car[keep]
    pose_id = _ints(revisions, "pose_id")[row]
    target = _codes(revisions, "target", TARGETS)[row]
    survey, category = _ints(cars, "survey_id")[car], _codes(cars, "category", CATEGORIES)[car]
    check_target = _ints(cars, "check_target").astype(np.bool_)[car]
    outside = vehicles_outside(session, survey_ids)
    return Measured(
        measurement_id=id_[keep],
        vehicle_id=vehicle[keep],
        survey_id=survey,
        operator_id=_ints(revisions, "created_by")[row],
        day=_days(revisions)[row] if days else np.zeros(len(row), np.int64),
        filmed_day=_filmed_days(session, cars)[car],
        target=target,
        lighting=_codes(cars, "lighting", LIGHTING)[car],
        lane=_codes(cars, "direction", LANES)[car],
        category=category,
        class_set=_class_sets(session, survey, category),
        verdict=verdict[keep],
        height_m=micrometres(height[keep]),
        uncorrected_height_m=micrometres(_floats(revisions, "uncorrected_height_m")[row]),
        known_m=micrometres(_known(cars, [names.height for names in _KNOWN], car, target)),
        u_known_m=micrometres(_known(cars, [names.u for names in _KNOWN], car, target)),
        by_size=_ints(cars, "by_size").astype(np.bool_)[car],
        check_target=check_target,
        counts=~check_target & ~np.isin(vehicle[keep], list(outside)),
        pose_id=pose_id,
        across_m=_floats(revisions, "y_m")[row] - _cameras_across(session, pose_id),
        **{name: micrometres(_floats(revisions, name)[row]) for name in UNCERTAINTY},
    )


def micrometres(length_m: Floats) -> Floats:
    """Lengths (N,) as a package writes them: the decimal of six places next to each, NaN for NaN."""
    scaled = length_m * 1e6
    found = np.asarray(np.rint(scaled) / 1e6 + 0.0, dtype=np.float64)
    for n in np.flatnonzero(np.abs(np.abs(scaled - np.trunc(scaled)) - 0.5) < _TIE).tolist():
        found[n] = float(f"{length_m[n]:.6f}") + 0.0
    return found


def _tables(session: Session, survey_ids: Sequence[int] | None, days: bool) -> list[pa.Table]:
    """Series, vehicles, revisions and reviews, at least those of the surveys."""
    from sightline.infra.database.arrow import arrow_rows, arrow_tables  # a start needs no Arrow

    s = measurement_series.c
    counted = select(func.count()).select_from(measurement_series)
    wanted = session.execute(counted.where(*_of(s.survey_id, survey_ids))).scalar_one()
    # Of most, a scan of all is quicker than a join, and the others fall out afterwards.
    few = wanted <= _FEW or 4 * wanted < session.execute(counted).scalar_one()
    joined = survey_ids if few else None
    queries = (_series(survey_ids), _vehicles(survey_ids), _revisions(joined, days), _judged(joined))
    if wanted <= _FEW:
        return [arrow_rows(session, query) for query in queries]
    return arrow_tables(session, select(func.sum(audit_chains.c.count)), queries)


def _series(survey_ids: Sequence[int] | None) -> Select[Any]:
    """Without repeats."""
    s = measurement_series.c
    return select(s.id, s.vehicle_id).where(s.repeat_of.is_(None), *_of(s.survey_id, survey_ids))


def _vehicles(survey_ids: Sequence[int] | None) -> Select[Any]:
    """Living ones; a vehicle without lighting has its recording's."""
    v = vehicles.c
    lighting = func.coalesce(v.lighting, recordings.c.lighting).label("lighting")
    query = select(
        v.id,
        v.survey_id,
        v.recording_id,
        v.first_frame,
        lighting,
        v.direction,
        v.category,
        case((v.check_target, 1), else_=0).label("check_target"),
        case((_BY_SIZE, 1), else_=0).label("by_size"),
        *(_if_reference(v[name]) for names in _KNOWN for name in (names.height, names.u)),
    ).join(recordings, recordings.c.id == v.recording_id)
    return query.where(v.deleted_at.is_(None), *_of(v.survey_id, survey_ids))


def _if_reference(column: ColumnElement[Any]) -> ColumnElement[Any]:
    """Of a model chosen by size nothing is a reference."""
    return case((_BY_SIZE, null()), else_=column).label(column.key)


def _revisions(survey_ids: Sequence[int] | None, days: bool) -> Select[Any]:
    """All of them; a withdrawn one has no height."""
    m = measurements.c
    height = case((m.withdrawn, null()), else_=m.height_m).label("height_m")
    query = select(m.series_id, m.revision, m.created_by, m.target, height, m.uncorrected_height_m, m.pose_id)
    query = query.add_columns(m.y_m)
    query = query.add_columns(m.verdict_of_revision, *(m[name] for name in UNCERTAINTY))
    if days:
        query = query.add_columns(m.created_at)
    return query.where(*_series_of(m.series_id, survey_ids))


def _judged(survey_ids: Sequence[int] | None) -> Select[Any]:
    """Reviews with the revision that the verdict holds for."""
    r = reviews.c
    query = select(r.id, r.series_id, r.result_revision, r.verdict)
    return query.where(*_series_of(r.series_id, survey_ids))


def _filmed_days(session: Session, cars: pa.Table) -> Ints:
    """The day on which each pass (V,) was filmed, NONE where nobody has confirmed its recording's start."""
    recording, frame = _ints(cars, "recording_id"), _ints(cars, "first_frame")
    day = np.full(len(recording), NONE, dtype=np.int64)
    r = recordings.c
    query = select(r.id, r.started_at, r.time_zone, r.duration_s, r.frame_count)
    for row in session.execute(query.where(r.started_at.is_not(None))).mappings():
        of = np.flatnonzero(recording == row["id"])
        filming, each_s = filming_of(row), frame_s(row["duration_s"], row["frame_count"])
        if filming is not None:
            day[of] = filming.days(frame[of].astype(np.float64) * each_s)
    return day


def _cameras_across(session: Session, pose_id: Ints) -> Floats:
    """Where the camera of each row's pose (N,) stands along the road's Y, metres; NaN without a place."""
    distinct, row = np.unique(pose_id, return_inverse=True)
    query = select(road_poses.c.id, road_poses.c.document).where(road_poses.c.id.in_(distinct.tolist()))
    documents = {found.id: found.document for found in session.execute(query)}
    at = np.array([camera_across_m(documents.get(int(one), {})) for one in distinct], dtype=np.float64)
    return at[row] if len(at) else np.zeros(len(pose_id))


def _of(column: ColumnElement[Any], survey_ids: Sequence[int] | None) -> list[ColumnElement[bool]]:
    return [] if survey_ids is None else [column.in_(survey_ids)]


def _series_of(column: ColumnElement[Any], survey_ids: Sequence[int] | None) -> list[ColumnElement[bool]]:
    if survey_ids is None:
        return []
    s = measurement_series.c
    return [column.in_(select(s.id).where(s.survey_id.in_(survey_ids)))]


def _ints(table: pa.Table, name: str) -> Ints:
    """Whole numbers, NONE for null."""
    return np.asarray(table[name].fill_null(NONE), dtype=np.int64)


def _floats(table: pa.Table, name: str) -> Floats:
    """NaN for null."""
    return np.asarray(table[name], dtype=np.float64)


def _known(cars: pa.Table, fields: Sequence[str], car: Ints, target: Ints) -> Floats:
    """What the fields of each target say of each row's target (N,) on its vehicle (N,), NaN for nothing."""
    found = np.full(len(car), np.nan)
    for code, name in enumerate(fields):
        rows = target == code
        found[rows] = _floats(cars, name)[car[rows]]
    return found


def _codes(table: pa.Table, name: str, words: Sequence[str]) -> Ints:
    """The index of each word, NONE for null."""
    import pyarrow as pa
    import pyarrow.compute as pc

    column = table[name]
    code = pc.index_in(column, value_set=pa.array(words, pa.string()))
    if code.null_count != column.null_count:
        unknown = sorted(set(column.unique().to_pylist()) - {*words, None})
        raise Damaged("results-database-holds-which-version-not-know", name=name, unknown=unknown[0])
    return np.asarray(code.fill_null(NONE), dtype=np.int64)


def _days(table: pa.Table) -> Ints:
    """Days since 1970-01-01, UTC; SQLite has times as text, without a zone."""
    column = table["created_at"]
    if str(column.type) == "string":
        column = column.cast("timestamp[us]")
    return np.asarray(column).astype("datetime64[D]").astype(np.int64)


def _class_sets(session: Session, survey: Ints, category: Ints) -> Ints:
    """The set of each class (N,) in its survey (N,), NONE for none."""
    found = np.full(len(survey), NONE, dtype=np.int64)
    of = {id_: np.array([*sets_of(table), NONE]) for id_, table in classes_of_surveys(session).items()}
    for id_ in np.unique(survey):
        rows = survey == id_
        found[rows] = of[int(id_)][category[rows]]  # the last place is for no class
    return found


class _Places:
    """Where an id stands among ids (N,) that are all different. Ids of a database lie close together, so they
    are looked up in a table; where they do not, in their order.
    """

    def __init__(self, ids: Ints) -> None:
        self._order: Ints | None = None
        if int(ids.max(initial=0)) > 64 * len(ids) + _SPARSE:
            self._order = np.argsort(ids, kind="stable")
            self._ids = ids[self._order]
            return
        self._at = np.full(int(ids.max(initial=0)) + 2, NONE, dtype=np.int32)
        self._at[ids] = np.arange(len(ids), dtype=np.int32)

    def __call__(self, ids: Ints) -> Ints:
        """The place of each id (M,), NONE where it does not stand there."""
        if self._order is not None:
            at = np.minimum(np.searchsorted(self._ids, ids), len(self._ids) - 1)
            return np.where(self._ids[at] == ids, self._order[at], NONE)
        # the last place is nobody's
        return np.asarray(self._at[np.minimum(ids, len(self._at) - 1)], dtype=np.int64)


def _newest(at_series: _Places, revisions: pa.Table, count: int) -> tuple[Ints, Ints]:
    """For each of `count` series, (count,) each: the row and the number of its newest revision, else NONE."""
    number = _ints(revisions, "revision")
    at, order = at_series(_ints(revisions, "series_id")), _ascending(number)
    row = np.full(count + 1, NONE)  # the last is for rows of no series
    row[at[order]] = order  # of equal places the last value stays
    return row[:count], np.append(number, NONE)[row[:count]]


def _carried(revisions: pa.Table, row: Ints) -> Ints:
    """Of each row (N,) the earlier revision whose verdict holds for it too, NONE without any."""
    return np.append(_ints(revisions, "verdict_of_revision"), NONE)[row]


def _verdicts(at_series: _Places, judged: pa.Table, revision: Ints, carried: Ints) -> Ints:
    """The newest verdict on the newest revision (N,) of each series, or on the earlier one (N,) whose verdict
    holds for it too; the first of VERDICTS without any.
    """
    at, judged_revision = at_series(_ints(judged, "series_id")), _ints(judged, "result_revision")
    on_newest = np.append(revision, NONE)[at] == judged_revision
    holds = (at != NONE) & (on_newest | (np.append(carried, NONE)[at] == judged_revision))
    order = _ascending(_ints(judged, "id")[holds])
    verdict = np.zeros(len(revision), dtype=np.int64)
    verdict[at[holds][order]] = _codes(judged, "verdict", VERDICTS)[holds][order]
    return verdict


def _ascending(values: Ints) -> Ints:
    """The order (N,) in which values ascend; small numbers are sorted several times quicker as such."""
    small = np.min_scalar_type(int(values.max(initial=0)))
    return np.argsort(values.astype(small), kind="stable")
