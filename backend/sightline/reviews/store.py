"""Reviews: append-only verdicts on measurements. Nobody reviews a revision of their own."""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.coverage import COVERAGE_95
from sightline.enums import QueueState, ReviewVerdict, Verdict
from sightline.errors import BadInput, Conflict, NotAllowed
from sightline.infra.audit import trail
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.database.rows import add_row, missing, stored_hash
from sightline.infra.database.types import now
from sightline.measurements.query import (
    fetch_measurements,
    is_current,
    is_own,
    measurement_revision_rows,
)
from sightline.measurements.records import (
    Measurement,
    MeasurementValues,
    ReviewState,
    ScanHeight,
    VehicleSheet,
)
from sightline.measurements.sheets.query import list_sheets_by_id
from sightline.measurements.store import (
    append_measurement_revision,
    get_measurement,
    require_measurement_revision,
)
from sightline.measurements.tables import measurement_series, reviews
from sightline.measurements.tables import measurements as revision_rows
from sightline.reviews.lots.records import LotPlace
from sightline.reviews.lots.service import places_in_open_lots
from sightline.reviews.order_query import Standing, standing_order
from sightline.reviews.plan_store import get_review_plan, is_drawn
from sightline.reviews.records import Judged, QueueItem, ReviewWork


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
    if (verdict == "fixed") != (fixed is not None):
        raise BadInput("reviews-fix-needs-new-points-only-fix")
    give_verdict(session, before, verdict=verdict, reason=reason, seen=seen, fixed=fixed, actor=actor)
    return get_measurement(session, series_id)


def give_verdict(
    session: Session,
    before: Measurement | ScanHeight,
    *,
    verdict: ReviewVerdict,
    reason: str | None,
    seen: Verdict | None,
    fixed: MeasurementValues | None = None,
    actor: int,
) -> None:
    """`add_review` of a current revision, of a frame or of a line scan, read in the same transaction."""
    not_own(session, before, actor)
    if before.withdrawn:
        raise Conflict("reviews-measurement-withdrawn-nothing-review")
    if before.repeat_of is not None:
        raise Conflict("reviews-repeat-not-reviewed-review-measurement-repeats")
    told = require_verdict(before.review, seen, verdict, reason)
    content: dict[str, Any] = {"series_id": before.id, "revision": before.revision, "verdict": verdict}
    content |= {"reason": told, "lot_id": None, "result_revision": before.revision}
    if fixed is not None and isinstance(before, Measurement):
        content["result_revision"] = append_measurement_revision(
            session, before, fixed, withdrawn=False, action="fix", actor=actor
        ).revision
    content["created_at"] = now()
    review_id = add_row(session, reviews, {**content, "created_by": actor})
    after = {**content, **before.place, "content_sha256": stored_hash(session, reviews, review_id)}
    then = {"verdict": before.review.verdict}
    trail.record(session, actor, "review", "review", review_id, before.survey_id, then, after)


def require_verdict(
    standing: ReviewState, seen: Verdict | None, verdict: ReviewVerdict, reason: str | None
) -> str | None:
    """The reason of a verdict that may be given, without blanks around it.

    Raises Conflict if somebody gave another verdict since `seen` (None: not compared), or for reopening what
    waits already, BadInput for a rejection without a reason.
    """
    if seen is not None and standing.verdict != seen:
        name = name_or_somebody(standing.reviewer)
        raise Conflict("reviews-verdict-given-meanwhile", name=name, verdict=standing.verdict)
    told = (reason or "").strip() or None
    if verdict == "rejected" and told is None:
        raise BadInput("reviews-rejection-needs-reason-say-what-wrong")
    if verdict == "reopened" and standing.verdict in ("to_review", "reopened"):
        raise Conflict("reviews-waits-review-already")
    return told


def review_queue(
    session: Session,
    survey_id: int,
    *,
    state: QueueState = "to_review",
    after: int | None = None,
    only: int | None = None,
    lot: int | None = None,
    limit: int | None = None,
    actor: int | None,
) -> tuple[QueueItem, ...]:
    """A survey's standing measurements by what was said of them; reopened ones are "to_review" again.

    Those most likely wrong come first, one's own last; a page of at most `limit` starts `after` a measurement
    (also one that left the queue meanwhile). `only`: that measurement alone, if it is in this state. `lot`:
    the sample of this open lot alone. What waits for its lot's sample is not "to_review".
    """
    order = standing_order(session, survey_id, actor)
    places = places_in_open_lots(session, survey_id)
    if only is not None:
        wanted = [only] if only in order else []
    else:
        wanted = list(order)
        if after is not None:
            if after not in order:
                raise missing("measurement", after)
            wanted = wanted[wanted.index(after) + 1 :]
        if lot is not None:
            wanted = [one for one in wanted if one in places and _sample_of(places[one], lot)]
        elif state == "to_review":
            wanted = [one for one in wanted if one not in places or places[one].in_sample]
        if state != "all":
            wanted = [one for one in wanted if order[one].verdict == state]
    found = _standing(session, wanted[:limit], state)
    sheets = list_sheets_by_id(session, {one.vehicle_id for one in found})
    by_id = {vehicle.id: vehicle for vehicle in sheets}
    drawn = _drawn(session, survey_id, found, actor)
    return tuple(
        _item(one, by_id[one.vehicle_id], order[one.id], one.id in drawn, places.get(one.id)) for one in found
    )


def _sample_of(place: LotPlace, lot: int) -> bool:
    return place.in_sample and place.lot_id == lot


def _item(
    one: Measurement, vehicle: VehicleSheet, place: Standing, drawn: bool, lot: LotPlace | None
) -> QueueItem:
    error_m, u_m = place.error_m, place.u_error_m
    judged = Judged(drawn and not place.mine, place.signs, error_m, u_m and COVERAGE_95 * u_m, lot)
    return QueueItem(one, vehicle, place.mine, judged)


def _standing(session: Session, ids: Sequence[int], state: QueueState) -> tuple[Measurement, ...]:
    """The current revisions of these, in their order; those in another state are left out."""
    query = measurement_revision_rows().where(is_current, revision_rows.c.series_id.in_(ids))
    by_id = {one.id: one for one in fetch_measurements(session, query)}
    fits = (by_id[id_] for id_ in ids if id_ in by_id)
    return tuple(one for one in fits if state == "all" or _plain(one.review.verdict) == state)


def _plain(verdict: Verdict) -> Verdict:
    return "to_review" if verdict == "reopened" else verdict


def review_work(session: Session, survey_id: int, *, actor: int | None) -> ReviewWork:
    """What waits for a verdict, by whose it is."""
    places = places_in_open_lots(session, survey_id)
    held = {number for number, place in places.items() if not place.in_sample}
    order = standing_order(session, survey_id, actor)
    waiting = [one.mine for number, one in order.items() if one.verdict == "to_review" and number not in held]
    return ReviewWork(waiting.count(False), waiting.count(True), len(held))


def require_clicked_again(session: Session, one: Measurement, actor: int) -> None:
    """Raises BadInput where the survey's plan wants it clicked again first, NotAllowed for one's own."""
    not_own(session, one, actor)
    if _drawn(session, one.survey_id, [one], actor):
        raise BadInput("reviews-click-it-again-before")


def _drawn(session: Session, survey_id: int, found: Sequence[Measurement], actor: int | None) -> set[int]:
    one_in = get_review_plan(session, survey_id).blind_one_in
    waiting = {
        one.id
        for one in found
        if _plain(one.review.verdict) == "to_review"
        and one.values.status == "ok"
        and one.repeat_of is None
        and is_drawn(one.id, one_in)
    }
    if not waiting:
        return waiting
    clicked = (
        select(measurement_series.c.repeat_of)
        .join(revision_rows, revision_rows.c.series_id == measurement_series.c.id)
        .where(measurement_series.c.repeat_of.in_(waiting), revision_rows.c.revision == 1)
        .where(revision_rows.c.created_by == actor)
    )
    return waiting - set(session.execute(clicked).scalars())


def not_own(session: Session, before: Measurement | ScanHeight, actor: int) -> None:
    """Nobody reviews points of their own, nor does somebody else's withdrawing and restoring make them so.

    Raises NotAllowed.
    """
    query = select(is_own(actor)).where(revision_rows.c.id == before.revision_id)
    if session.execute(query).scalar_one():
        raise NotAllowed("reviews-nobody-reviews-their-own-measurement-ask")
