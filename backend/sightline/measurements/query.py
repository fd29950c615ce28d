"""The one query by which measurements are read: a revision with its series, its maker and its verdict."""

from collections.abc import Callable, Iterable
from dataclasses import fields
from operator import itemgetter
from typing import Any

from sqlalchemy import ColumnElement, Row, Select, exists, func, or_, select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.infra.database.people import people
from sightline.infra.database.rows import who
from sightline.measurements.derived_query import derived
from sightline.measurements.records import FurtherFrame, Measurement, MeasurementValues, ReviewState
from sightline.measurements.tables import measurement_series, measurements, reviews
from sightline.messages.said import Said

series = measurement_series
_later = measurements.alias("later")
_maker = people.alias("maker")
_reviewer = people.alias("reviewer")

#: True for the newest revision of each series.
is_current: ColumnElement[bool] = ~exists().where(
    _later.c.series_id == measurements.c.series_id, _later.c.revision > measurements.c.revision
)
#: The same of one series, or of a vehicle's: its revisions are not gone through, only the last is looked up.
is_last: ColumnElement[bool] = measurements.c.revision == (
    select(func.max(_later.c.revision))
    .where(_later.c.series_id == series.c.id)
    .correlate(series)
    .scalar_subquery()
)
_newest_review = (
    select(func.max(reviews.c.id))
    .where(reviews.c.series_id == measurements.c.series_id)
    .where(
        or_(
            reviews.c.result_revision == measurements.c.revision,
            reviews.c.result_revision == measurements.c.verdict_of_revision,
        )
    )
    .correlate(measurements)
    .scalar_subquery()
)
#: False for those that repeat another one: they stand in no list and count for no result.
is_first: ColumnElement[bool] = series.c.repeat_of.is_(None)
#: The verdict on a revision; what was reopened waits for a reviewer again.
verdict: ColumnElement[str] = func.coalesce(reviews.c.verdict, "to_review")
waits: ColumnElement[bool] = verdict.in_(("to_review", "reopened"))


def with_verdict(*columns: Any) -> Select[Any]:
    """Revisions joined with their series and the newest review of that very revision, or of the one whose
    verdict holds for it too.
    """
    return (
        select(*columns)
        .select_from(measurements)
        .join(series, series.c.id == measurements.c.series_id)
        .outerjoin(reviews, reviews.c.id == _newest_review)
    )


# The fields of MeasurementValues that are a column of the same name.
_MADE_OF_SEVERAL = ("contact", "target_point", "more_frames")
_STORED = [field.name for field in fields(MeasurementValues) if field.name not in _MADE_OF_SEVERAL]
_m = measurements.c


def measurement_revision_rows() -> Select[Any]:
    """Whole revisions, for `measurement`; add the conditions and the order."""
    return (
        with_verdict(
            *(_m[name] for name in _STORED),
            *(_m.contact_x_px, _m.contact_y_px, _m.target_x_px, _m.target_y_px, _m.more_frames),
            *(_m.series_id, _m.revision, _m.id.label("revision_id")),
            *(series.c.survey_id, series.c.vehicle_id, series.c.recording_id, series.c.repeat_of),
            *(_m.created_by, _maker.c.name.label("maker_name"), _m.created_at, _m.withdrawn),
            *(reviews.c.verdict, reviews.c.reason.label("review_reason")),
            *(reviews.c.created_by.label("reviewer_id"), _reviewer.c.name.label("reviewer_name")),
            *(reviews.c.created_at.label("reviewed_at"), reviews.c.result_revision.label("judged_revision")),
            reviews.c.lot_id.label("verdict_lot_id"),
            *(_m.computing_id, _m.verdict_of_revision),
        )
        .outerjoin(_maker, _maker.c.id == measurements.c.created_by)
        .outerjoin(_reviewer, _reviewer.c.id == reviews.c.created_by)
    )


def fetch_measurements(session: Session, query: Select[Any]) -> tuple[Measurement, ...]:
    """Run a `measurement_revision_rows()` query."""
    return derived(session, tuple([measurement_of_row(row) for row in session.execute(query).all()]))


def measurements_of_vehicles(
    session: Session, conditions: Iterable[ColumnElement[bool]]
) -> dict[int, list[Measurement]]:
    """The standing measurements (current, not withdrawn, no repeats) by vehicle, in the order of making."""
    query = measurement_revision_rows().where(is_current, ~measurements.c.withdrawn, is_first, *conditions)
    found: dict[int, list[Measurement]] = {}
    for one in fetch_measurements(session, query.order_by(measurements.c.series_id)):
        found.setdefault(one.vehicle_id, []).append(one)
    return found


# Where each name stands in a row, asked of the statement once: looked up row by row, a survey's thousands of
# measurements would take half as long again.
_AT = {name: place for place, name in enumerate(measurement_revision_rows().selected_columns.keys())}


def _getter(names: Iterable[str]) -> Callable[[Row[Any]], tuple[Any, ...]]:
    return itemgetter(*(_AT[name] for name in names))


# Fields of Measurement by the name of their column.
_OUTER = {
    "id": "series_id",
    **{name: name for name in ("revision", "revision_id", "survey_id", "vehicle_id", "recording_id")},
    **{name: name for name in ("repeat_of", "created_at", "withdrawn")},
    **{name: name for name in ("computing_id", "verdict_of_revision", "judged_revision")},
}
_outer_of, _values_of = _getter(_OUTER.values()), _getter(_STORED)
_clicks_of = _getter(("contact_x_px", "contact_y_px", "target_x_px", "target_y_px", "more_frames"))
_maker_of = _getter(("created_by", "maker_name"))
_review_of = _getter(
    ("verdict", "review_reason", "reviewer_id", "reviewer_name", "reviewed_at", "verdict_lot_id")
)


def measurement_of_row(row: Row[Any]) -> Measurement:
    """The record of a row of `measurement_revision_rows()`; columns added behind those do not matter."""
    contact_x, contact_y, target_x, target_y, more_frames = _clicks_of(row)
    values = dict(zip(_STORED, _values_of(row), strict=True))
    if values["reason"] is not None:
        values["reason"] = Said.read(values["reason"])
    if values["flags"]:
        values["flags"] = [Said.read(flag) for flag in values["flags"]]
    return Measurement(
        values=MeasurementValues(
            contact=(contact_x, contact_y),
            target_point=(target_x, target_y),
            more_frames=tuple([_further(document) for document in more_frames]) if more_frames else (),
            **values,
        ),
        created_by=who(*_maker_of(row)),
        review=_review(*_review_of(row)),
        **dict(zip(_OUTER, _outer_of(row), strict=True)),
    )


def _further(document: JsonObject) -> FurtherFrame:
    points = {word: (document[word][0], document[word][1]) for word in ("contact", "target_point")}
    return FurtherFrame(**{**document, **points})


def _review(
    verdict: Any, reason: Any, reviewer_id: Any, reviewer_name: Any, at: Any, lot_id: Any
) -> ReviewState:
    if verdict is None:
        return _NOT_YET
    by = who(reviewer_id, reviewer_name)
    return ReviewState(verdict=verdict, reason=reason, reviewer=by, at=at, lot_id=lot_id)


_NOT_YET = ReviewState("to_review")
