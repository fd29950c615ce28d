"""All measurements that statistics are made of, as columns: plain scans in SQL, joined in NumPy.

Lists of records cost 30 microseconds a row; these columns must serve a million rows. Joins in SQL cost more
than those of sorted arrays.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, get_args

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import BigInteger, ColumnElement, Select, case, cast, extract, func, select
from sqlalchemy.orm import Session

from sightline.enums import Category, Lighting, Target, Verdict
from sightline.infra.database.bulk_columns import columns
from sightline.measurements.tables import measurement_series, measurements
from sightline.recordings.tables import recordings
from sightline.reviews.tables import reviews
from sightline.vehicles.tables import vehicles

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

TARGETS: tuple[str, ...] = get_args(Target)
LIGHTING: tuple[str, ...] = get_args(Lighting)
CATEGORIES: tuple[str, ...] = get_args(Category)
VERDICTS: tuple[str, ...] = get_args(Verdict)
NONE = -1
_DAY_S = 86_400
_JULIAN_1970 = 2_440_587.5


@dataclass(frozen=True, eq=False)
class Measured:
    """Standing measurements with a height, (N,) each: current, not withdrawn, no repeats, of living vehicles.

    In the order of `measurement_id`. Words are indices into TARGETS, LIGHTING, CATEGORIES, VERDICTS, -1 for
    none; `day` counts days since 1970-01-01 (UTC) of the revision's making, 0 unless asked for; lengths in
    metres, NaN where unknown.
    """

    measurement_id: Ints
    vehicle_id: Ints
    survey_id: Ints
    operator_id: Ints
    day: Ints
    target: Ints
    lighting: Ints
    category: Ints
    verdict: Ints
    height_m: Floats
    uncorrected_height_m: Floats
    manufacturer_height_m: Floats
    u_manufacturer_height_m: Floats

    def __len__(self) -> int:
        return len(self.measurement_id)

    def where(self, chosen: NDArray[np.bool_]) -> "Measured":
        """The rows that are chosen (N,)."""
        return Measured(*(getattr(self, one.name)[chosen] for one in fields(self)))


def load_measured_columns(
    session: Session, survey_ids: Sequence[int] | None = None, *, days: bool = False
) -> Measured:
    """The columns of some surveys, or of all.

    days: whether each one's day is wanted; reading a million dates takes a third of a second.
    """
    series, vehicle = _unpacked(columns(session, _series(survey_ids), measurement_series.c.id)[0], _IDS)
    cars, words, *of_cars = columns(session, _vehicles(survey_ids), vehicles.c.id)
    few = _few(session, survey_ids, len(series))
    keys, stamps, *lengths = columns(session, _revisions(session, few, days), measurements.c.id)
    newest = _newest(keys, keys // _REVISIONS)
    at = _places(series, keys[newest] // _REVISIONS)
    car = np.where(at == NONE, NONE, _places(cars, vehicle)[at]) if len(series) else at
    keep = (stamps[newest] % 2 == 0) & ~np.isnan(lengths[0][newest]) & (car != NONE)
    rows, at, car = newest[keep], at[keep], car[keep]
    survey, lighting, category = _unpacked(words[car], _WORDS, _WORDS)
    operator, target, _ = _unpacked(stamps[rows], _WORDS, 2)
    return Measured(
        series[at],
        vehicle[at],
        survey,
        operator + NONE,
        lengths[2][rows] if days else np.zeros(len(rows), np.int64),
        target,
        lighting + NONE,
        category + NONE,
        _verdicts(columns(session, _judged(few), reviews.c.id)[0], keys[rows]),
        *(length[rows] for length in lengths[:2]),
        *(length[car] for length in of_cars),
    )


# Small numbers travel as one, for each costs as much as its digits do.
_IDS = 2**31
_REVISIONS = 2**20
_WORDS = 2**3


def _few(session: Session, survey_ids: Sequence[int] | None, found: int) -> Sequence[int] | None:
    """The surveys again where they hold a small part of all measurements; of most, a scan of all is quicker
    than a join, and the others fall out afterwards.
    """
    if survey_ids is None:
        return None
    of_all = session.execute(select(func.count()).select_from(measurement_series)).scalar_one()
    return survey_ids if 4 * found < of_all else None


def _series(survey_ids: Sequence[int] | None) -> Select[Any]:
    """(id, vehicle); without repeats."""
    s = measurement_series.c
    packed = cast(s.id, BigInteger) * _IDS + s.vehicle_id
    return select(packed).where(s.repeat_of.is_(None), *_of(s.survey_id, survey_ids))


def _vehicles(survey_ids: Sequence[int] | None) -> Select[Any]:
    """id, (survey, lighting + 1, category + 1), manufacturer's height, its u.

    A vehicle without lighting has its recording's.
    """
    v = vehicles.c
    lighting = _code(func.coalesce(v.lighting, recordings.c.lighting), LIGHTING) - NONE
    words = (
        (cast(v.survey_id, BigInteger) * _WORDS + lighting) * _WORDS + _code(v.category, CATEGORIES) - NONE
    )
    query = select(v.id, words, v.manufacturer_height_m, v.u_manufacturer_height_m)
    joined = query.join(recordings, recordings.c.id == v.recording_id)
    return joined.where(v.deleted_at.is_(None), *_of(v.survey_id, survey_ids))


def _revisions(session: Session, survey_ids: Sequence[int] | None, days: bool) -> Select[Any]:
    """(series, revision), (operator + 1, target, withdrawn), both heights, the day if wanted."""
    m = measurements.c
    operator = cast(func.coalesce(m.created_by, NONE) - NONE, BigInteger)
    stamps = (operator * _WORDS + _code(m.target, TARGETS)) * 2 + case((m.withdrawn, 1), else_=0)
    keys = cast(m.series_id, BigInteger) * _REVISIONS + m.revision
    query = select(keys, stamps, m.height_m, m.uncorrected_height_m)
    if days:
        query = query.add_columns(_day(session, m.created_at))
    return query.where(*_series_of(m.series_id, survey_ids))


def _judged(survey_ids: Sequence[int] | None) -> Select[Any]:
    """(series, revision that the verdict holds for, verdict)."""
    r = reviews.c
    keys = cast(r.series_id, BigInteger) * _REVISIONS + r.result_revision
    query = select(keys * _WORDS + _code(r.verdict, VERDICTS))
    return query.where(*_series_of(r.series_id, survey_ids))


def _of(column: ColumnElement[Any], survey_ids: Sequence[int] | None) -> list[ColumnElement[bool]]:
    return [] if survey_ids is None else [column.in_(survey_ids)]


def _series_of(column: ColumnElement[Any], survey_ids: Sequence[int] | None) -> list[ColumnElement[bool]]:
    if survey_ids is None:
        return []
    s = measurement_series.c
    return [column.in_(select(s.id).where(s.survey_id.in_(survey_ids)))]


def _code(column: ColumnElement[Any], words: Sequence[str]) -> ColumnElement[int]:
    """The index of a word, -1 for none: numbers are cheaper to fetch than text."""
    return case(*((column == word, index) for index, word in enumerate(words)), else_=NONE)


def _day(session: Session, moment: ColumnElement[Any]) -> ColumnElement[Any]:
    if session.get_bind().dialect.name == "sqlite":
        return cast(func.floor(func.julianday(moment) - _JULIAN_1970), BigInteger)
    return cast(func.floor(extract("epoch", moment) / _DAY_S), BigInteger)


def _unpacked(packed: Ints, *sizes: int) -> list[Ints]:
    """The numbers that were packed as ((first * size + second) * size + ...), in that order."""
    left = packed
    found: list[Ints] = []
    for size in reversed(sizes):
        found.append(left % size)
        left = left // size
    return [left, *reversed(found)]


def _newest(order: Ints, keys: Ints) -> Ints:
    """Of rows (N,), the place of the one that comes last in `order` for each key, in the order of the keys;
    `order` keeps equal keys together, and of equal rows the last one counts.
    """
    sorted_ = np.argsort(order, kind="stable")
    last = np.append(np.diff(keys[sorted_]) != 0, True)[: len(keys)]
    return np.asarray(sorted_[last], dtype=np.int64)


def _places(ids: Ints, wanted: Ints) -> Ints:
    """Where each wanted id stands among ascending ids, -1 where it does not."""
    if len(ids) == 0:
        return np.full(len(wanted), NONE)
    at = np.minimum(np.searchsorted(ids, wanted), len(ids) - 1)
    return np.asarray(np.where(ids[at] == wanted, at, NONE), dtype=np.int64)


def _verdicts(packed: Ints, wanted: Ints) -> Ints:
    """The newest verdict on each wanted (series, revision) (N,), "to_review" where there is none."""
    judged, verdict = _unpacked(packed, _WORDS)
    newest = _newest(judged, judged)
    at = _places(judged[newest], wanted)
    return np.where(at == NONE, 0, verdict[newest][at]) if len(newest) else np.zeros(len(wanted), np.int64)
