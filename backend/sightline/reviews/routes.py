"""Reviews: the queue, and a verdict on a measurement."""

from collections.abc import Sequence
from typing import Annotated

from fastapi import APIRouter, Query

from sightline.enums import QueueState
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.web.deps import Manager, PathId, Reading, Reviewer, Viewer, Writing
from sightline.infra.web.named import LotId, MeasurementId
from sightline.measurements.bodies import measurement_body
from sightline.measurements.records import Measurement, ScanHeight
from sightline.reviews import plan_store, query, store
from sightline.reviews.bodies import HeightBody, HistoryBody, NewReview, PlanIn, QueueItemBody
from sightline.reviews.records import ReviewPlan, ReviewWork
from sightline.reviews.service import require_seen_by_plan, review
from sightline.scans.heights.presenters import scan_height_bodies

router = APIRouter()


@router.get("/surveys/{survey_id}/review-queue")
def review_queue(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    state: Annotated[QueueState, Query(description="What was said of them so far.")] = "to_review",
    after: Annotated[MeasurementId | None, Query(description="Those behind this measurement.")] = None,
    measurement: Annotated[MeasurementId | None, Query(description="This one alone, if it is there.")] = None,
    lot: Annotated[LotId | None, Query(description="The sample of this open lot alone.")] = None,
    limit: Annotated[int, Query(ge=1, le=1000)] = 200,
) -> list[QueueItemBody]:
    """The survey's standing heights, of frames and of line scans, by verdict, a page at a time, those most
    likely wrong first.

    Others have to review `mine`, which come last.
    """
    items = store.review_queue(
        session, survey_id, state=state, after=after, only=measurement, lot=lot, limit=limit, actor=who.id
    )
    heights = _bodies(session, [item.measurement for item in items], who.id)
    return [
        filled_from(QueueItemBody, item, measurement=height)
        for item, height in zip(items, heights, strict=True)
    ]


@router.get("/surveys/{survey_id}/review-work")
def review_work(survey_id: PathId, who: Viewer, session: Reading) -> ReviewWork:
    """How much waits for a verdict, how much of it is one's own, and how much has one."""
    return store.review_work(session, survey_id, actor=who.id)


@router.get("/surveys/{survey_id}/review-plan")
def review_plan(survey_id: PathId, who: Viewer, session: Reading) -> ReviewPlan:
    """Which measurements are clicked again by their reviewer before they are shown."""
    return plan_store.get_review_plan(session, survey_id)


@router.put("/surveys/{survey_id}/review-plan")
def choose_review_plan(survey_id: PathId, body: PlanIn, who: Manager, session: Writing) -> ReviewPlan:
    """Put another plan in its place; the reviewers follow it."""
    return plan_store.choose_review_plan(
        session, survey_id, blind_one_in=body.blind_one_in, version=body.version, actor=who.id
    )


@router.post("/measurements/{measurement_id}/reviews", status_code=201)
def review_measurement(
    measurement_id: PathId, body: NewReview, who: Reviewer, session: Writing
) -> HeightBody:
    """Accept, reject (with a reason), fix (on frames: with points), reopen; never one's own."""
    require_seen_by_plan(session, measurement_id, body.revision, body.verdict, who.id)
    judged = review(session, measurement_id, **body.model_dump(), actor=who.id)
    return _bodies(session, [judged], who.id)[0]


@router.get("/measurements/{measurement_id}/history")
def measurement_history(measurement_id: PathId, who: Viewer, session: Reading) -> HistoryBody:
    """Every revision and every verdict, oldest first."""
    found = query.measurement_history(session, measurement_id)
    return HistoryBody(_bodies(session, found.revisions, who.id), found.reviews)


def _bodies(session: Session, heights: Sequence[Measurement | ScanHeight], asker: int) -> list[HeightBody]:
    of_lines = scan_height_bodies(session, [one for one in heights if isinstance(one, ScanHeight)], asker)
    by_revision = {one.revision_id: one for one in of_lines}
    return [
        measurement_body(one) if isinstance(one, Measurement) else by_revision[one.revision_id]
        for one in heights
    ]
