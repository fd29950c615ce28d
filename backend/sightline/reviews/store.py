"""Reviews: append-only verdicts on heights, of frames and of line scans. Nobody reviews their own."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.coverage import COVERAGE_95
from sightline.enums import QueueState, ReviewVerdict, Verdict
from sightline.errors import BadInput, Conflict, NotAllowed
from sightline.infra.audit.records import Who
from sightline.infra.audit.written import written_once
from sightline.infra.database.rows import missing, names
from sightline.measurements.query import fetch_measurements, is_current, is_own, measurement_revision_rows
from sightline.measurements.records import Measurement, MeasurementValues, ScanHeight
from sightline.measurements.store import (
    append_measurement_revision,
    get_measurement,
    require_measurement_revision,
)
from sightline.measurements.tables import measurement_series, reviews
from sightline.measurements.tables import measurements as revision_rows
from sightline.measurements.verdicts import require_verdict
from sightline.reviews.lots.records import LotPlace
from sightline.reviews.lots.service import places_in_open_lots
from sightline.reviews.order_query import Standing, standing_order
from sightline.reviews.plan_store import get_review_plan, is_drawn
from sightline.reviews.query import facts_of_scanned, facts_of_vehicles
from sightline.reviews.records import Judged, QueueItem, ReviewWork, VehicleFacts
from sightline.scans.heights.store import is_of_line_scan, require_scan_height_revision, scan_heights_of


def add_review(
    session: Session,
    series_id: int,
    *,
    seen_revision: int,
    verdict: ReviewVerdict,
    reason: str | None = None,
    seen: Verdict | None = None,
    seen_at: datetime | None = None,
    fixed: MeasurementValues | None = None,
    actor: int,
) -> Measurement | ScanHeight:
    """Give a verdict on the revision that was seen; "fixed" also writes a new revision with `fixed`.

    Raises Conflict if there is a newer revision or another verdict than `seen` of `seen_at`, NotAllowed for
    one's own, BadInput without the reason of a rejection or the points of a fix.
    """
    before = require_revision(session, series_id, seen_revision)
    if (verdict == "fixed") != (fixed is not None):
        raise BadInput("reviews-fix-without-points")
    not_own(session, before, actor)
    if before.withdrawn:
        raise Conflict("reviews-withdrawn")
    if before.repeat_of is not None:
        raise Conflict("reviews-repeat")
    told = require_verdict(before.review, seen, seen_at, verdict, reason)
    content: dict[str, Any] = {"series_id": before.id, "revision": before.revision, "verdict": verdict}
    content |= {"reason": told, "lot_id": None, "result_revision": before.revision}
    if fixed is not None and isinstance(before, Measurement):
        content["result_revision"] = append_measurement_revision(
            session, before, fixed, withdrawn=False, action="fix", actor=actor
        ).revision
    written_once(
        session,
        reviews,
        content,
        "review",
        survey_id=before.survey_id,
        before={"verdict": before.review.verdict},
        also=before.place,
        actor=actor,
    )
    if isinstance(before, ScanHeight):
        return scan_heights_of(session, (series_id,))[0]
    return get_measurement(session, series_id)


def require_revision(session: Session, series_id: int, revision: int) -> Measurement | ScanHeight:
    """The current revision of a height, if it is the one that the caller saw. Raises NotFound, Conflict."""
    if is_of_line_scan(session, series_id):
        return require_scan_height_revision(session, series_id, revision)
    return require_measurement_revision(session, series_id, revision)


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
    """A survey's standing heights by what was said of them; reopened ones are "to_review" again.

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
            sample = {one for one, place in places.items() if place.in_sample and place.lot_id == lot}
            wanted = [one for one in wanted if one in sample]
        elif state == "to_review":
            wanted = [one for one in wanted if one not in places or places[one].in_sample]
        if state != "all":
            wanted = [one for one in wanted if order[one].verdict == state]
    ids = wanted[:limit]
    query = measurement_revision_rows().where(
        is_current, revision_rows.c.series_id.in_([one for one in ids if not order[one].scanned])
    )
    filmed = fetch_measurements(session, query)
    scanned = scan_heights_of(session, [one for one in ids if order[one].scanned])
    facts = _facts_by_measurement(filmed, facts_of_vehicles(session, {one.vehicle_id for one in filmed}))
    facts |= _facts_by_measurement(scanned, facts_of_scanned(session, {one.vehicle_id for one in scanned}))
    heights: tuple[Measurement | ScanHeight, ...] = (*filmed, *scanned)
    by_id = {one.id: one for one in heights}
    drawn = _draw_blind(session, survey_id, filmed, actor)
    named = names(session, [order[id_].operator for id_ in ids])
    people = {person: Who(person, name) for person, name in named.items()}
    return tuple(
        QueueItem(
            by_id[id_],
            facts[id_],
            order[id_].mine,
            _make_judged(order[id_], id_ in drawn, people, places.get(id_)),
        )
        for id_ in ids
        if id_ in by_id and (state == "all" or _queue_state(by_id[id_].review.verdict) == state)
    )


def _facts_by_measurement(
    found: Iterable[Measurement | ScanHeight], facts: Mapping[int, VehicleFacts]
) -> dict[int, VehicleFacts]:
    return {one.id: facts[one.vehicle_id] for one in found}


def _make_judged(place: Standing, drawn: bool, people: Mapping[int, Who], lot: LotPlace | None) -> Judged:
    return Judged(
        blind=drawn and not place.mine,
        signs=place.signs,
        error_m=place.error_m,
        U95_error_m=place.u_error_m and COVERAGE_95 * place.u_error_m,
        operator=None if place.operator is None else people.get(place.operator),
        clicked_at=place.clicked_at,
        lot=lot,
    )


def _queue_state(verdict: Verdict) -> Verdict:
    return "to_review" if verdict == "reopened" else verdict


def review_work(session: Session, survey_id: int, *, actor: int | None) -> ReviewWork:
    """What waits for a verdict, by whose it is, and what has one."""
    places = places_in_open_lots(session, survey_id)
    held = {number for number, place in places.items() if not place.in_sample}
    order = standing_order(session, survey_id, actor)
    waiting = [one.mine for number, one in order.items() if one.verdict == "to_review" and number not in held]
    verdicts = Counter(one.verdict for one in order.values())
    return ReviewWork(
        to_review=waiting.count(False),
        own=waiting.count(True),
        in_lots=len(held),
        accepted=verdicts["accepted"] + verdicts["fixed"],
        rejected=verdicts["rejected"],
        heights=len(order),
    )


def require_clicked_again(session: Session, measurement: Measurement, actor: int) -> None:
    """Raises BadInput where the survey's plan wants it clicked again first, NotAllowed for one's own."""
    not_own(session, measurement, actor)
    if _draw_blind(session, measurement.survey_id, [measurement], actor):
        raise BadInput("reviews-repeat-first")


def _draw_blind(
    session: Session, survey_id: int, found: Sequence[Measurement], actor: int | None
) -> set[int]:
    one_in = get_review_plan(session, survey_id).blind_one_in
    waiting = {
        entry.id
        for entry in found
        if _queue_state(entry.review.verdict) == "to_review"
        and entry.values.status == "ok"
        and entry.repeat_of is None
        and is_drawn(entry.id, one_in)
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
    """Nobody reviews points of their own, whoever restored them. Raises NotAllowed."""
    query = select(is_own(actor)).where(revision_rows.c.id == before.revision_id)
    if session.execute(query).scalar_one():
        raise NotAllowed("reviews-own-measurement")
