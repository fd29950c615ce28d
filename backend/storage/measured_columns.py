"""All measurements that statistics are made of, as columns: plain scans in SQL, joined in NumPy.

Lists of records cost 30 microseconds a row; these columns must serve a million rows.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from itertools import chain
from typing import Any, get_args

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import BigInteger, ColumnElement, Select, case, cast, extract, func, select
from sqlalchemy.orm import Session

from backend.storage.tables import recordings
from backend.storage.tables_of_work import measurement_series, measurements, reviews, vehicles
from backend.storage.words import Category, Lighting, Target, Verdict

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

TARGETS: tuple[str, ...] = get_args(Target)
LIGHTING: tuple[str, ...] = get_args(Lighting)
CATEGORIES: tuple[str, ...] = get_args(Category)
VERDICTS: tuple[str, ...] = get_args(Verdict)
NONE = -1
_AT_ONCE = 1_000  # few enough to stay in the processor's cache
_DAY_S = 86_400
_JULIAN_1970 = 2_440_587.5


@dataclass(frozen=True, eq=False)
class Measured:
    """Standing measurements with a height, (N,) each: current, not withdrawn, no repeats, of living vehicles.

    In the order of `measurement_id`. Words are indices into TARGETS, LIGHTING, CATEGORIES, VERDICTS, -1 for
    none; `day` counts days since 1970-01-01 (UTC) of the revision's making; lengths in metres, NaN where
    unknown.
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


def load(session: Session, survey_ids: Sequence[int] | None = None) -> Measured:
    """The columns of some surveys, or of all."""
    series, stamps, revised, height, uncorrected = _columns(session, _revisions(session, survey_ids))
    newest = _newest(series)
    operator, day, target, withdrawn = _unpacked(stamps[newest], _DAYS, _WORDS, 2)
    vehicle, revision = _unpacked(revised[newest], _REVISIONS)
    cars, packed, known, u_known = _columns(session, _vehicles(survey_ids))
    at = _places(cars, vehicle)
    keep = (withdrawn == 0) & (height[newest] > _UNKNOWN_M) & (at >= 0)
    rows, at = newest[keep], at[keep]
    survey, lighting, category = _unpacked(packed[at], _WORDS, _WORDS)
    verdict = _verdicts(_columns(session, _judged(survey_ids)), series[rows], revision[keep])
    return Measured(
        series[rows].astype(np.int64),
        vehicle[keep],
        survey,
        operator[keep] + NONE,
        day[keep],
        target[keep],
        lighting + NONE,
        category + NONE,
        verdict,
        *(_known(one) for one in (height[rows], uncorrected[rows], known[at], u_known[at])),
    )


# Several small numbers travel as one, for each fetched value costs more than arithmetic; all stay below 2^53.
_REVISIONS = 2**20
_DAYS = 2**16
_WORDS = 2**3
_UNKNOWN_M = -1e9


def _revisions(session: Session, survey_ids: Sequence[int] | None) -> Select[Any]:
    """series, (operator + 1, day, target, withdrawn), (vehicle, revision), both heights; oldest first."""
    m, s = measurements.c, measurement_series.c
    operator = cast(func.coalesce(m.created_by, NONE) - NONE, BigInteger)
    stamps = (operator * _DAYS + _day(session, m.created_at)) * _WORDS + _code(m.target, TARGETS)
    query = (
        select(
            m.series_id,
            stamps * 2 + case((m.withdrawn, 1), else_=0),
            cast(s.vehicle_id, BigInteger) * _REVISIONS + m.revision,
            func.coalesce(m.height_m, _UNKNOWN_M),
            func.coalesce(m.uncorrected_height_m, _UNKNOWN_M),
        )
        .join(measurement_series, s.id == m.series_id)
        .where(s.repeat_of.is_(None), *_of(s.survey_id, survey_ids))
    )
    return query.order_by(m.id)


def _vehicles(survey_ids: Sequence[int] | None) -> Select[Any]:
    """id, (survey, lighting + 1, category + 1), manufacturer's height, its u; ascending.

    A vehicle without lighting has its recording's.
    """
    v = vehicles.c
    lighting = _code(func.coalesce(v.lighting, recordings.c.lighting), LIGHTING) - NONE
    query = select(
        v.id,
        (cast(v.survey_id, BigInteger) * _WORDS + lighting) * _WORDS + _code(v.category, CATEGORIES) - NONE,
        func.coalesce(v.manufacturer_height_m, _UNKNOWN_M),
        func.coalesce(v.u_manufacturer_height_m, _UNKNOWN_M),
    ).join(recordings, recordings.c.id == v.recording_id)
    return query.where(v.deleted_at.is_(None), *_of(v.survey_id, survey_ids)).order_by(v.id)


def _judged(survey_ids: Sequence[int] | None) -> Select[Any]:
    """series, (revision that the verdict holds for, verdict); oldest first."""
    r = reviews.c
    query = select(r.series_id, r.result_revision * _WORDS + _code(r.verdict, VERDICTS)).order_by(r.id)
    if survey_ids is None:
        return query
    joined = query.join(measurement_series, measurement_series.c.id == r.series_id)
    return joined.where(measurement_series.c.survey_id.in_(survey_ids))


def _of(column: ColumnElement[Any], survey_ids: Sequence[int] | None) -> list[ColumnElement[bool]]:
    return [] if survey_ids is None else [column.in_(survey_ids)]


def _code(column: ColumnElement[Any], words: Sequence[str]) -> ColumnElement[int]:
    """The index of a word, -1 for none: numbers are cheaper to fetch than text."""
    return case(*((column == word, index) for index, word in enumerate(words)), else_=NONE)


def _day(session: Session, moment: ColumnElement[Any]) -> ColumnElement[Any]:
    if session.get_bind().dialect.name == "sqlite":
        return func.floor(func.julianday(moment) - _JULIAN_1970)
    return cast(func.floor(extract("epoch", moment) / _DAY_S), BigInteger)


def _columns(session: Session, query: Select[Any]) -> list[Floats]:
    """The columns (N,) of a query of numbers, none of them NULL; without row objects, for speed."""
    width = len(query.selected_columns)
    parts: list[Floats] = [np.empty((0, width))]
    cursor = session.connection().execute(query).cursor
    assert cursor is not None
    while rows := cursor.fetchmany(_AT_ONCE):
        flat = np.fromiter(chain.from_iterable(rows), np.float64, len(rows) * width)
        parts.append(flat.reshape(-1, width))
    cursor.close()
    return list(np.ascontiguousarray(np.concatenate(parts).T))


def _unpacked(packed: Floats, *sizes: int) -> list[Ints]:
    """The numbers that were packed as ((first * size + second) * size + ...), in that order."""
    left = packed.astype(np.int64)
    found: list[Ints] = []
    for size in reversed(sizes):
        found.append(left % size)
        left = left // size
    return [left, *reversed(found)]


def _known(length_m: Floats) -> Floats:
    return np.where(length_m > _UNKNOWN_M, length_m, np.nan)


def _newest(keys: Floats) -> Ints:
    """Of rows (N,), oldest first, the places of the last one of each key, in the order of the keys."""
    order = np.argsort(keys, kind="stable")
    last = np.append(np.diff(keys[order]) != 0, True)[: len(keys)]
    return np.asarray(order[last], dtype=np.int64)


def _places(ids: Floats, wanted: Floats | Ints) -> Ints:
    """Where each wanted id stands among ascending ids, -1 where it does not."""
    if len(ids) == 0:
        return np.full(len(wanted), NONE)
    at = np.minimum(np.searchsorted(ids, wanted), len(ids) - 1)
    return np.asarray(np.where(ids[at] == wanted, at, NONE), dtype=np.int64)


def _verdicts(judged: Sequence[Floats], series: Floats, revision: Ints) -> Ints:
    """The newest verdict on the very revision (N,) of each series (N,), "to_review" where there is none."""
    out = np.zeros(len(series), dtype=np.int64)
    on, verdict = _unpacked(judged[1], _WORDS)
    keys = judged[0] * _REVISIONS + on
    newest = _newest(keys)
    at = _places(keys[newest], series * _REVISIONS + revision)
    out[at >= 0] = verdict[newest][at[at >= 0]]
    return out
