"""The one query by which measurements are read: a revision with its series, its maker and its verdict."""

from collections.abc import Callable, Iterable
from dataclasses import fields
from datetime import datetime
from operator import itemgetter
from typing import Any, Generic, TypeVar

from sqlalchemy import ColumnElement, Row, Select, and_, case, exists, func, null, or_, select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.infra.audit.written import written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import who
from sightline.measurements.derived_query import add_filming_and_drift
from sightline.measurements.records import (
    FoundHeight,
    FurtherFrame,
    Measurement,
    MeasurementValues,
    Review,
    ReviewState,
    ScanHeight,
    ScanHeightValues,
)
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
#: Of joined reviews the newest of a revision, or of the one whose verdict holds for it too.
judges: ColumnElement[bool] = reviews.c.id == _newest_review
#: False for those that repeat another one: they stand in no list and count for no result.
is_first: ColumnElement[bool] = series.c.repeat_of.is_(None)
#: The verdict on a revision; what was reopened waits for a reviewer again.
verdict: ColumnElement[str] = func.coalesce(reviews.c.verdict, "to_review")
waits: ColumnElement[bool] = verdict.in_(("to_review", "reopened"))

_earlier = measurements.alias("earlier")
_before = measurements.alias("before")
#: The first frame's points, as `first_clicks` tells them.
_CLICKED = ("frame", "contact_x_px", "contact_y_px", "target_x_px", "target_y_px")


def _has_equal(of: Any, *names: str, to: Any = measurements.c) -> ColumnElement[bool]:
    """Whether a revision of the series has these columns as another, usually the one that is read."""
    alike = (of[name].is_not_distinct_from(to[name]) for name in names)
    return and_(of.series_id == to.series_id, *alike)


def _of_first(name: str) -> ColumnElement[Any]:
    """A column of the first revision of the series with the same points."""
    first = (
        select(_earlier.c[name])
        .where(_has_equal(_earlier.c, *_CLICKED))
        .order_by(_earlier.c.revision)
        .limit(1)
        .correlate(measurements)
        .scalar_subquery()
    )
    return case((measurements.c.revision == 1, measurements.c[name]), else_=first)


#: Who clicked the points of a revision, and when: of the first that has them (`revision_of_clicks`). Who
#: withdrew, restored or computed it again did not.
operator_id: ColumnElement[int | None] = _of_first("created_by")
clicked_at: ColumnElement[datetime] = _of_first("created_at")


def is_own(actor: int | None) -> ColumnElement[bool]:
    """Whether a person was the first to give something that stands in a revision: one of its two points, or
    what stands beside them, each by itself, also where another changed the rest since. Further frames are one
    list: while any stand, whoever changed them and left any has a share. A target, a click sigma and a side
    in a line scan come with every first click: they are given by who changes them.
    """
    m, theirs = measurements.c, _earlier.c

    def new(*names: str) -> ColumnElement[bool]:
        before = _has_equal(_before.c, *names, to=theirs)
        return ~exists().where(before, _before.c.revision < theirs.revision).correlate(_earlier)

    def first(*names: str) -> ColumnElement[bool]:
        return and_(_has_equal(theirs, *names), new(*names))

    gave = or_(
        *(first("frame", f"{point}_x_px", f"{point}_y_px") for point in ("contact", "target")),
        and_(m.more_frames != [], theirs.more_frames != [], new("more_frames")),
        and_(m.followed.is_not(None), first("followed")),
        *(and_(m.inset_from == "own", first("inset_from", name)) for name in ("inset_m", "u_inset_m")),
        and_(theirs.revision > 1, or_(first("target"), first("sigma_px"))),
        and_(m.line_pose_id.is_not(None), theirs.revision > 1, first("side")),
    )
    return (
        exists()
        .where(theirs.series_id == m.series_id, theirs.revision <= m.revision)
        .where(theirs.created_by.is_not_distinct_from(actor), gave)
        .correlate(measurements)
    )


def with_verdict(*columns: Any) -> Select[Any]:
    """Revisions with their series and the newest review of each, or of the one whose verdict holds for it."""
    return (
        select(*columns)
        .select_from(measurements)
        .join(series, series.c.id == measurements.c.series_id)
        .outerjoin(reviews, judges)
    )


_m = measurements.c
_POINTS = ("contact_x_px", "contact_y_px", "target_x_px", "target_y_px")


def _stored_fields(values: type[FoundHeight]) -> list[str]:
    """The fields that are a column of the same name."""
    return [field.name for field in fields(values) if field.name not in ("contact", "target_point")]


def _revision_rows(values: type[FoundHeight], *place: Any) -> Select[Any]:
    """Whole revisions with such values, of vehicles that passed in such a place."""
    return (
        with_verdict(
            *(_m[name] for name in (*_stored_fields(values), *_POINTS)),
            *(_m.series_id, _m.revision, _m.id.label("revision_id"), series.c.survey_id, *place),
            *(series.c.repeat_of, _m.created_by, _maker.c.name.label("maker_name")),
            *(_m.created_at, _m.withdrawn, reviews.c.verdict, reviews.c.reason.label("review_reason")),
            *(reviews.c.created_by.label("reviewer_id"), _reviewer.c.name.label("reviewer_name")),
            *(reviews.c.created_at.label("reviewed_at"), reviews.c.result_revision.label("judged_revision")),
            reviews.c.lot_id.label("verdict_lot_id"),
            *(_m.computing_id, _m.verdict_of_revision),
        )
        .outerjoin(_maker, _maker.c.id == measurements.c.created_by)
        .outerjoin(_reviewer, _reviewer.c.id == reviews.c.created_by)
    )


def measurement_revision_rows() -> Select[Any]:
    """Whole revisions on frames, for `measurement_of_row`; add the conditions and the order."""
    rows = _revision_rows(MeasurementValues, series.c.vehicle_id, series.c.recording_id)
    return rows.where(series.c.vehicle_id.is_not(None))


def scan_height_rows(category: ColumnElement[Any]) -> Select[Any]:
    """Whole revisions in line scans, for `scan_height_of_row`; add the joins, the conditions and the order.

    `category`: the column of the scanned vehicles that has their class, which this room does not know.
    """
    place = (series.c.scan_vehicle_id.label("vehicle_id"), series.c.scan_id, category.label("category"))
    rows = _revision_rows(ScanHeightValues, *place)
    return rows.where(series.c.scan_vehicle_id.is_not(None))


def fetch_measurements(session: Session, query: Select[Any]) -> tuple[Measurement, ...]:
    """Run a `measurement_revision_rows()` query."""
    return add_filming_and_drift(
        session, tuple([measurement_of_row(row) for row in session.execute(query).all()])
    )


def reviews_of_series(session: Session, condition: ColumnElement[bool]) -> tuple[Review, ...]:
    """The reviews of the series that meet a condition, oldest first."""
    as_named = {"measurement_id": "series_id", "reviewer": "created_by", "at": "created_at"}
    return tuple(
        record_of(Review, row, **{name: row[column] for name, column in as_named.items()})
        for row in written_rows(session, reviews, condition, of=measurement_series)
    )


def measurements_of_vehicles(
    session: Session, conditions: Iterable[ColumnElement[bool]]
) -> dict[int, list[Measurement]]:
    """The standing measurements (current, not withdrawn, no repeats) by vehicle, in the order of making."""
    query = measurement_revision_rows().where(is_current, ~measurements.c.withdrawn, is_first, *conditions)
    found: dict[int, list[Measurement]] = {}
    for one in fetch_measurements(session, query.order_by(measurements.c.series_id)):
        found.setdefault(one.vehicle_id, []).append(one)
    return found


# Fields of every revision by the name of their column.
_OUTER = {
    "id": "series_id",
    **{name: name for name in ("revision", "revision_id", "survey_id", "vehicle_id")},
    **{name: name for name in ("repeat_of", "created_at", "withdrawn")},
    **{name: name for name in ("computing_id", "verdict_of_revision", "judged_revision")},
}
_REVIEW = ("verdict", "review_reason", "reviewer_id", "reviewer_name", "reviewed_at", "verdict_lot_id")
_Made = TypeVar("_Made", Measurement, ScanHeight)


class Reader(Generic[_Made]):
    """Reads revisions of one kind. Where each name stands in a row is asked of the statement once: looked up
    row by row, a survey's thousands of measurements would take half as long again.
    """

    def __init__(self, kind: type[_Made], values: type[Any], rows: Select[Any], *place: str) -> None:
        #: Add the conditions and the order.
        self.rows = rows
        at = {name: where for where, name in enumerate(rows.selected_columns.keys())}

        def getter(names: Iterable[str]) -> Callable[[Row[Any]], tuple[Any, ...]]:
            return itemgetter(*(at[name] for name in names))

        self._kind: Callable[..., _Made] = kind
        self._values = values
        self._stored, self._outer = _stored_fields(values), (*_OUTER, *place)
        self._stored_of, self._points_of = getter(self._stored), getter(_POINTS)
        self._outer_of = getter((*_OUTER.values(), *place))
        self._maker_of, self._review_of = getter(("created_by", "maker_name")), getter(_REVIEW)

    def read(self, row: Row[Any]) -> _Made:
        """The record of a row; columns added behind those of the statement do not matter."""
        contact_x, contact_y, target_x, target_y = self._points_of(row)
        values = dict(zip(self._stored, self._stored_of(row), strict=True))
        if values["reason"] is not None:
            values["reason"] = Said.read(values["reason"])
        if values["flags"]:
            values["flags"] = [Said.read(flag) for flag in values["flags"]]
        if "more_frames" in values:
            more = values["more_frames"]
            values["more_frames"] = tuple([_further(document) for document in more]) if more else ()
        return self._kind(
            values=self._values(contact=(contact_x, contact_y), target_point=(target_x, target_y), **values),
            created_by=who(*self._maker_of(row)),
            review=_review(*self._review_of(row)),
            **dict(zip(self._outer, self._outer_of(row), strict=True)),
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

#: Both kinds: of a frame, and of a line of a line scan.
OF_FRAMES = Reader(Measurement, MeasurementValues, measurement_revision_rows(), "recording_id")
OF_LINES = Reader(ScanHeight, ScanHeightValues, scan_height_rows(null()), "scan_id", "category")
measurement_of_row = OF_FRAMES.read
scan_height_of_row = OF_LINES.read
