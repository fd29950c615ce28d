"""Reading reviews, and a measurement's whole history."""

from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from sightline.infra.database.people import people
from sightline.infra.database.rows import who
from sightline.measurements.store import measurement_revisions
from sightline.measurements.tables import measurement_series, reviews
from sightline.reviews.records import MeasurementHistory, Review


def reviews_of_series(session: Session, condition: ColumnElement[bool]) -> tuple[Review, ...]:
    """The reviews of the series that meet a condition, oldest first."""
    query = (
        select(reviews, people.c.name.label("reviewer_name"))
        .join(measurement_series, measurement_series.c.id == reviews.c.series_id)
        .outerjoin(people, people.c.id == reviews.c.created_by)
        .where(condition)
        .order_by(reviews.c.id)
    )
    return tuple(
        Review(
            id=row.id,
            measurement_id=row.series_id,
            revision=row.revision,
            result_revision=row.result_revision,
            verdict=row.verdict,
            reason=row.reason,
            reviewer=who(row.created_by, row.reviewer_name),
            at=row.created_at,
            lot_id=row.lot_id,
        )
        for row in session.execute(query)
    )


def measurement_history(session: Session, series_id: int) -> MeasurementHistory:
    """Every revision and every review of a measurement, oldest first. Raises NotFound."""
    revisions = measurement_revisions(session, series_id)
    return MeasurementHistory(revisions, reviews_of_series(session, measurement_series.c.id == series_id))
