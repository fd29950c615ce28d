"""The one query by which measurements are read: a revision with its series, its maker and its verdict."""

from collections.abc import Iterable
from typing import Any

from sqlalchemy import ColumnElement, Row, Select, exists, func, select
from sqlalchemy.orm import Session

from backend.storage.records import Measurement, ReviewState
from backend.storage.rows import who
from backend.storage.tables import people
from backend.storage.tables_of_work import measurement_series, measurements, reviews

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


def revisions() -> Select[Any]:
    """Whole revisions, for `measurement`; add the conditions and the order."""
    return (
        with_verdict(
            measurements,
            series.c.survey_id,
            series.c.recording_id,
            series.c.vehicle_id,
            _maker.c.name.label("maker_name"),
            reviews.c.verdict.label("review_verdict"),
            reviews.c.reason.label("review_reason"),
            reviews.c.created_at.label("review_at"),
            reviews.c.created_by.label("reviewer_id"),
            _reviewer.c.name.label("reviewer_name"),
        )
        .outerjoin(_maker, _maker.c.id == measurements.c.created_by)
        .outerjoin(_reviewer, _reviewer.c.id == reviews.c.created_by)
    )


def fetch(session: Session, query: Select[Any]) -> tuple[Measurement, ...]:
    """Run a `revisions()` query."""
    return tuple(measurement(row) for row in session.execute(query))


def of_vehicles(session: Session, conditions: Iterable[ColumnElement[bool]]) -> dict[int, list[Measurement]]:
    """The standing measurements (current, not withdrawn) by vehicle, in the order of their making."""
    query = revisions().where(is_current, ~measurements.c.withdrawn, *conditions)
    found: dict[int, list[Measurement]] = {}
    for one in fetch(session, query.order_by(measurements.c.series_id)):
        found.setdefault(one.vehicle_id, []).append(one)
    return found


def measurement(row: Row[Any]) -> Measurement:
    """The record of a row of `revisions()`."""
    return Measurement(
        id=row.series_id,
        revision=row.revision,
        revision_id=row.id,
        survey_id=row.survey_id,
        vehicle_id=row.vehicle_id,
        recording_id=row.recording_id,
        target=row.target,
        frame=row.frame,
        pts=row.pts,
        time_s=row.time_s,
        frame_crc=row.frame_crc,
        contact=(row.contact_x_px, row.contact_y_px),
        point=(row.point_x_px, row.point_y_px),
        sigma_px=row.sigma_px,
        pose_id=row.pose_id,
        calibration_id=row.calibration_id,
        inset_m=row.inset_m,
        u_inset_m=row.u_inset_m,
        height_m=row.height_m,
        uncorrected_height_m=row.uncorrected_height_m,
        u_height_m=row.u_height_m,
        U95_height_m=row.U95_height_m,
        distance_m=row.distance_m,
        status=row.status,
        reason=row.reason,
        flags=row.flags,
        budget=row.budget,
        code_version=row.code_version,
        created_by=who(row.created_by, row.maker_name),
        created_at=row.created_at,
        withdrawn=row.withdrawn,
        review=_review(row),
    )


def _review(row: Row[Any]) -> ReviewState:
    if row.review_verdict is None:
        return ReviewState("to_review")
    reviewer = who(row.reviewer_id, row.reviewer_name)
    return ReviewState(row.review_verdict, row.review_reason, reviewer, row.review_at)
