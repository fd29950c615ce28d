"""The one query by which measurements are read: a revision with its series, its maker and its verdict."""

from collections.abc import Iterable
from typing import Any

from sqlalchemy import ColumnElement, Row, Select, exists, func, select
from sqlalchemy.orm import Session

from sightline.infra.database.people import people
from sightline.infra.database.rows import who
from sightline.measurements.records import FurtherFrame, Measurement, ReviewState
from sightline.measurements.tables import measurement_series, measurements
from sightline.recordings.drift_query import flagged
from sightline.reviews.tables import reviews

series = measurement_series
_later = measurements.alias("later")
_maker = people.alias("maker")
_reviewer = people.alias("reviewer")

#: True for the newest revision of each series.
is_current: ColumnElement[bool] = ~exists().where(
    _later.c.series_id == measurements.c.series_id, _later.c.revision > measurements.c.revision
)
_newest_review = (
    select(func.max(reviews.c.id))
    .where(reviews.c.series_id == measurements.c.series_id)
    .where(reviews.c.result_revision == measurements.c.revision)
    .correlate(measurements)
    .scalar_subquery()
)
#: False for those that repeat another one: they stand in no list and count for no result.
is_first: ColumnElement[bool] = series.c.repeat_of.is_(None)
#: The verdict on a revision; what was reopened waits for a reviewer again.
verdict: ColumnElement[str] = func.coalesce(reviews.c.verdict, "to_review")
waits: ColumnElement[bool] = verdict.in_(("to_review", "reopened"))


def with_verdict(*columns: Any) -> Select[Any]:
    """Revisions joined with their series and the newest review of that very revision."""
    return (
        select(*columns)
        .select_from(measurements)
        .join(series, series.c.id == measurements.c.series_id)
        .outerjoin(reviews, reviews.c.id == _newest_review)
    )


# In the order of Measurement's fields, so that a row becomes a record without looking up names: a survey has
# thousands of them.
_m = measurements.c
_FIELDS = (
    (_m.series_id, _m.revision, _m.id, series.c.survey_id, series.c.vehicle_id, series.c.recording_id),
    (series.c.repeat_of,),
    (_m.target, _m.frame, _m.pts, _m.time_s, _m.frame_crc),
    (_m.contact_x_px, _m.contact_y_px, _m.point_x_px, _m.point_y_px),
    (_m.sigma_px, _m.pose_id, _m.calibration_id, _m.inset_m, _m.u_inset_m),
    (_m.height_m, _m.uncorrected_height_m, _m.u_height_m, _m.U95_height_m, _m.distance_m),
    (_m.status, _m.reason, _m.flags, _m.budget, _m.code_version),
    (_m.more_frames, _m.solved_inset_m, _m.u_solved_inset_m),
    (_m.created_by, _maker.c.name, _m.created_at, _m.withdrawn),
    (reviews.c.verdict, reviews.c.reason, reviews.c.created_by, _reviewer.c.name, reviews.c.created_at),
)
_POINTS, _MORE, _MAKER, _REVIEW = 12, 31, 34, 38


def measurement_revision_rows() -> Select[Any]:
    """Whole revisions, for `measurement`; add the conditions and the order."""
    return (
        with_verdict(*(column for group in _FIELDS for column in group))
        .outerjoin(_maker, _maker.c.id == measurements.c.created_by)
        .outerjoin(_reviewer, _reviewer.c.id == reviews.c.created_by)
    )


def fetch_measurements(session: Session, query: Select[Any]) -> tuple[Measurement, ...]:
    """Run a `revisions()` query."""
    return flagged(session, tuple([measurement_of_row(row) for row in session.execute(query).all()]))


def measurements_of_vehicles(
    session: Session, conditions: Iterable[ColumnElement[bool]]
) -> dict[int, list[Measurement]]:
    """The standing measurements (current, not withdrawn, no repeats) by vehicle, in the order of making."""
    query = measurement_revision_rows().where(is_current, ~measurements.c.withdrawn, is_first, *conditions)
    found: dict[int, list[Measurement]] = {}
    for one in fetch_measurements(session, query.order_by(measurements.c.series_id)):
        found.setdefault(one.vehicle_id, []).append(one)
    return found


def measurement_of_row(row: Row[Any]) -> Measurement:
    """The record of a row of `revisions()`."""
    values = tuple(row)
    contact_x, contact_y, point_x, point_y = values[_POINTS : _POINTS + 4]
    maker, maker_name, created_at, withdrawn = values[_MAKER:_REVIEW]
    points = ((contact_x, contact_y), (point_x, point_y))
    made = (who(maker, maker_name), created_at, withdrawn, _review(*values[_REVIEW:]))
    more = tuple([_further(one) for one in values[_MORE]])
    solved = (more, *values[_MORE + 1 : _MAKER])
    fields: tuple[Any, ...] = (*values[:_POINTS], *points, *values[_POINTS + 4 : _MORE], *solved, *made)
    return Measurement(*fields)


def _further(one: dict[str, Any]) -> FurtherFrame:
    points = {word: (one[word][0], one[word][1]) for word in ("contact", "point")}
    return FurtherFrame(**{**one, **points})


def _review(verdict: Any, reason: Any, reviewer: Any, name: Any, at: Any) -> ReviewState:
    if verdict is None:
        return _NOT_YET
    return ReviewState(verdict, reason, who(reviewer, name), at)


_NOT_YET = ReviewState("to_review")
