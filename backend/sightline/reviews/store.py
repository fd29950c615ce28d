"""Reviews: append-only verdicts on measurements. Nobody reviews a revision of their own."""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import ColumnElement, FromClause, and_, or_, select
from sqlalchemy.orm import Session

from sightline.enums import QueueState, ReviewVerdict, Verdict
from sightline.errors import BadInput, Conflict, NotAllowed
from sightline.infra.audit import trail
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.database.rows import add_row, missing, stored_hash
from sightline.infra.database.types import now
from sightline.measurements.query import (
    fetch_measurements,
    is_current,
    is_first,
    measurement_revision_rows,
    verdict,
    waits,
)
from sightline.measurements.records import Measurement, MeasurementValues, ReviewState
from sightline.measurements.sheets.query import list_sheets_by_id
from sightline.measurements.store import (
    append_measurement_revision,
    get_measurement,
    measurement_revisions,
    require_measurement_revision,
)
from sightline.measurements.tables import measurement_series, reviews
from sightline.measurements.tables import measurements as revision_rows
from sightline.reviews.query import reviews_of_series
from sightline.reviews.records import QueueItem, Review
from sightline.vehicles.tables import vehicles as vehicle_rows


def add_review(
    session: Session,
    series_id: int,
    *,
    seen_revision: int,
    verdict: ReviewVerdict,
    reason: str | None = None,
    seen: Verdict | None = None,
    fixed: MeasurementValues | None = None,
    actor: int,
) -> Measurement:
    """Give a verdict on the revision that was seen; "fixed" also writes a new revision with `fixed`.

    Raises Conflict if there is a newer revision or another verdict than `seen`, NotAllowed for one's own,
    BadInput without the reason of a rejection or the points of a fix.
    """
    before = require_measurement_revision(session, series_id, seen_revision)
    _not_own(session, before, actor)
    require_verdict(before.review, seen)
    _allowed(before, verdict, reason, fixed)
    result_revision = seen_revision
    content: dict[str, Any] = {"series_id": series_id, "revision": seen_revision, "verdict": verdict}
    content["reason"] = (reason or "").strip() or None
    if fixed is not None:
        result_revision = append_measurement_revision(
            session, before, fixed, withdrawn=False, action="fix", actor=actor
        ).revision
    moment = now()
    stamps = {"result_revision": result_revision, "created_at": moment, "created_by": actor}
    review_id = add_row(session, reviews, {**content, **stamps})
    after = {**content, "result_revision": result_revision, "vehicle_id": before.vehicle_id}
    after["created_at"] = moment
    after["content_sha256"] = stored_hash(session, reviews, review_id)
    then = {"verdict": before.review.verdict}
    trail.record(session, actor, "review", "review", review_id, before.survey_id, then, after)
    return get_measurement(session, series_id)


def require_verdict(standing: ReviewState, seen: Verdict | None) -> None:
    """Raises Conflict if somebody gave another verdict since `seen`; None: not compared."""
    if seen is not None and standing.verdict != seen:
        name = name_or_somebody(standing.reviewer)
        raise Conflict("reviews-verdict-given-meanwhile", name=name, verdict=standing.verdict)


def review_queue(
    session: Session,
    survey_id: int,
    *,
    state: QueueState = "to_review",
    after: int | None = None,
    only: int | None = None,
    limit: int | None = None,
    actor: int | None,
) -> tuple[QueueItem, ...]:
    """A survey's standing measurements by what was said of them; reopened ones are "to_review" again.

    In the order of the vehicles' numbers; a page of at most `limit` starts `after` a measurement (also one
    that left the queue meanwhile). `only`: that measurement alone, if it is in this state.
    """
    query = (
        measurement_revision_rows()
        .join(vehicle_rows, vehicle_rows.c.id == measurement_series.c.vehicle_id)
        .where(measurement_series.c.survey_id == survey_id, vehicle_rows.c.deleted_at.is_(None))
        .where(is_current, ~revision_rows.c.withdrawn, is_first)
    )
    if state == "to_review":
        query = query.where(waits)
    elif state != "all":
        query = query.where(verdict == state)
    if only is not None:
        query = query.where(revision_rows.c.series_id == only)
    if after is not None:
        query = query.where(_later_than(session, after))
    found = fetch_measurements(
        session, query.order_by(vehicle_rows.c.number, revision_rows.c.series_id).limit(limit)
    )
    chosen = list_sheets_by_id(session, (one.vehicle_id for one in found))
    by_id = {vehicle.id: vehicle for vehicle in chosen}
    mine = _of_own_points(session, found, actor)
    return tuple(QueueItem(one, by_id[one.vehicle_id], one.id in mine) for one in found)


def _later_than(session: Session, series_id: int) -> ColumnElement[bool]:
    """What stands behind a measurement in the order of the queue. Raises NotFound."""
    place = select(vehicle_rows.c.number).join(
        measurement_series, measurement_series.c.vehicle_id == vehicle_rows.c.id
    )
    number = session.execute(place.where(measurement_series.c.id == series_id)).scalar_one_or_none()
    if number is None:
        raise missing("measurement", series_id)
    same = and_(vehicle_rows.c.number == number, revision_rows.c.series_id > series_id)
    return or_(vehicle_rows.c.number > number, same)


def _of_own_points(session: Session, found: Sequence[Measurement], actor: int | None) -> set[int]:
    """Those whose current revision, or the points that stand in it, are the actor's (see `_not_own`)."""
    mine = revision_rows.alias("mine")
    query = (
        select(revision_rows.c.series_id)
        .join(mine, mine.c.series_id == revision_rows.c.series_id)
        .where(revision_rows.c.series_id.in_([one.id for one in found]), is_current)
        .where(mine.c.created_by == actor)
        .where(or_(mine.c.revision == revision_rows.c.revision, _same_points(mine)))
    )
    return set(session.execute(query).scalars())


def _same_points(other: FromClause) -> ColumnElement[bool]:
    names = ("frame", "contact_x_px", "contact_y_px", "target_x_px", "target_y_px")
    return and_(*(other.c[name] == revision_rows.c[name] for name in names))


def list_for_survey(session: Session, survey_id: int) -> tuple[Review, ...]:
    """Every review of a survey, oldest first, for the export."""
    return reviews_of_series(session, measurement_series.c.survey_id == survey_id)


def _not_own(session: Session, before: Measurement, actor: int) -> None:
    """Nobody reviews points of their own, nor does somebody else's withdrawing and restoring make them so."""
    clicks = before.values.first_clicks
    for one in measurement_revisions(session, before.id):
        own = one.created_by is not None and one.created_by.id == actor
        if own and (one.revision == before.revision or one.values.first_clicks == clicks):
            raise NotAllowed("reviews-nobody-reviews-their-own-measurement-ask")


def _allowed(
    before: Measurement,
    verdict: ReviewVerdict,
    reason: str | None,
    fixed: MeasurementValues | None,
) -> None:
    if before.withdrawn:
        raise Conflict("reviews-measurement-withdrawn-nothing-review")
    if before.repeat_of is not None:
        raise Conflict("reviews-repeat-not-reviewed-review-measurement-repeats")
    if verdict == "rejected" and not (reason or "").strip():
        raise BadInput("reviews-rejection-needs-reason-say-what-wrong")
    if (verdict == "fixed") != (fixed is not None):
        raise BadInput("reviews-fix-needs-new-points-only-fix")
    if verdict == "reopened" and before.review.verdict in ("to_review", "reopened"):
        raise Conflict("reviews-measurement-waits-review-already")
