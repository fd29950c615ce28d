"""Reviews: append-only verdicts on measurements. Nobody reviews a revision of their own."""

from collections.abc import Sequence
from typing import Any, Literal

from sqlalchemy import ColumnElement, FromClause, and_, or_, select
from sqlalchemy.orm import Session

from backend.errors import BadInput, Conflict, NotAllowed
from backend.storage import audit, measurements, vehicles
from backend.storage.columns import now
from backend.storage.measurement_query import fetch, is_current, is_first, revisions, verdict, waits
from backend.storage.records import Measurement, MeasurementValues, QueueItem, Review, ReviewVerdict
from backend.storage.reviews_query import of_series
from backend.storage.rows import add_row, missing, stored_hash
from backend.storage.tables_of_work import measurement_series, reviews
from backend.storage.tables_of_work import measurements as revision_rows
from backend.storage.tables_of_work import vehicles as vehicle_rows

QueueState = Literal["to_review", "accepted", "fixed", "rejected", "all"]


def add(
    session: Session,
    series_id: int,
    *,
    seen_revision: int,
    verdict: ReviewVerdict,
    reason: str | None = None,
    fixed: MeasurementValues | None = None,
    actor: int,
) -> Measurement:
    """Give a verdict on the revision that was seen; "fixed" also writes a new revision with `fixed`.

    Raises Conflict if there is a newer revision, NotAllowed for one's own, BadInput without the reason of a
    rejection or the points of a fix.
    """
    before = measurements.seen(session, series_id, seen_revision)
    _not_own(session, before, actor)
    _allowed(before, verdict, reason, fixed)
    result_revision = seen_revision
    content: dict[str, Any] = {"series_id": series_id, "revision": seen_revision, "verdict": verdict}
    content["reason"] = (reason or "").strip() or None
    if fixed is not None:
        result_revision = measurements.append_revision(
            session, before, fixed, withdrawn=False, action="fix", actor=actor
        )
    moment = now()
    stamps = {"result_revision": result_revision, "created_at": moment, "created_by": actor}
    review_id = add_row(session, reviews, {**content, **stamps})
    after = {**content, "result_revision": result_revision, "vehicle_id": before.vehicle_id}
    after["created_at"] = moment
    after["content_sha256"] = stored_hash(session, reviews, review_id)
    then = {"verdict": before.review.verdict}
    audit.record(session, actor, "review", "review", review_id, before.survey_id, then, after)
    return measurements.get(session, series_id)


def queue(
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
        revisions()
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
    found = fetch(session, query.order_by(vehicle_rows.c.number, revision_rows.c.series_id).limit(limit))
    chosen = vehicles.list_by_ids(session, (one.vehicle_id for one in found))
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
    names = ("frame", "contact_x_px", "contact_y_px", "point_x_px", "point_y_px")
    return and_(*(other.c[name] == revision_rows.c[name] for name in names))


def list_for_survey(session: Session, survey_id: int) -> tuple[Review, ...]:
    """Every review of a survey, oldest first, for the export."""
    return of_series(session, measurement_series.c.survey_id == survey_id)


def _not_own(session: Session, before: Measurement, actor: int) -> None:
    """Nobody reviews points of their own, nor does somebody else's withdrawing and restoring make them so."""
    points = (before.frame, before.contact, before.point)
    for one in measurements.history(session, before.id).revisions:
        own = one.created_by is not None and one.created_by.id == actor
        if own and (one.revision == before.revision or (one.frame, one.contact, one.point) == points):
            raise NotAllowed("Nobody reviews their own measurement; ask another reviewer.")


def _allowed(
    before: Measurement,
    verdict: ReviewVerdict,
    reason: str | None,
    fixed: MeasurementValues | None,
) -> None:
    if before.withdrawn:
        raise Conflict("This measurement is withdrawn; there is nothing to review.")
    if before.repeat_of is not None:
        raise Conflict("A repeat is not reviewed; review the measurement that it repeats.")
    if verdict == "rejected" and not (reason or "").strip():
        raise BadInput("A rejection needs a reason; say what is wrong so that it can be put right.")
    if (verdict == "fixed") != (fixed is not None):
        raise BadInput("A fix needs the new points, and only a fix has them; click them and send them along.")
    if verdict == "reopened" and before.review.verdict in ("to_review", "reopened"):
        raise Conflict("This measurement waits for a review already.")
