"""Review by lots: what could be drawn, the draw, the lots, and what is decided on one."""

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from sightline.enums import LotGrouping
from sightline.infra.web.bodies import In
from sightline.infra.web.deps import PathId, Reading, Reviewer, Viewer, Writing
from sightline.reviews.lots import service
from sightline.reviews.lots.query import get_lot
from sightline.reviews.lots.records import LotSummary, PlannedLot, ShownLot
from sightline.statistics.acceptance import USUAL_RISKS, RiskPoints

router = APIRouter()


class NewLots(In):
    by: Annotated[list[LotGrouping], Field(max_length=4, description="What a lot's heights have in common.")]
    producer_quality: float = USUAL_RISKS.producer_quality
    producer_risk: float = USUAL_RISKS.producer_risk
    consumer_quality: float = USUAL_RISKS.consumer_quality
    consumer_risk: float = USUAL_RISKS.consumer_risk


@router.get("/surveys/{survey_id}/lots")
def list_lots(survey_id: PathId, who: Viewer, session: Reading) -> tuple[ShownLot, ...]:
    """Every lot of a survey with its plan, its curve and how far it is; newest first."""
    return service.shown_lots(session, survey_id, actor=who.id)


@router.get("/surveys/{survey_id}/lots/summary")
def lot_summary(survey_id: PathId, who: Viewer, session: Reading) -> LotSummary:
    """How many accepted heights rest on a verdict of their own and how many on their lot's sample."""
    return service.lot_summary(session, survey_id)


@router.get("/surveys/{survey_id}/lots/plan")
def plan_lots(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    by: Annotated[tuple[LotGrouping, ...], Query()] = (),
    producer_quality: float = USUAL_RISKS.producer_quality,
    producer_risk: float = USUAL_RISKS.producer_risk,
    consumer_quality: float = USUAL_RISKS.consumer_quality,
    consumer_risk: float = USUAL_RISKS.consumer_risk,
) -> tuple[PlannedLot, ...]:
    """The lots that could be drawn from what waits now, each with its plan."""
    risks = RiskPoints(producer_quality, producer_risk, consumer_quality, consumer_risk)
    return service.planned_lots(session, survey_id, by, risks)


@router.post("/surveys/{survey_id}/lots", status_code=201)
def draw_lots(survey_id: PathId, body: NewLots, who: Reviewer, session: Writing) -> tuple[ShownLot, ...]:
    """Draw lots and their samples; the seed follows from the audit chain. Lots that save nothing are left."""
    risks = RiskPoints(body.producer_quality, body.producer_risk, body.consumer_quality, body.consumer_risk)
    made = service.draw_lots(session, survey_id, body.by, risks, actor=who.id)
    return tuple(service.shown_lot(session, get_lot(session, one), actor=who.id) for one in made)


@router.post("/lots/{lot_id}/accept")
def accept_lot(lot_id: PathId, who: Reviewer, session: Writing) -> ShownLot:
    """Accept the rest by the sample, as one act; never heights of one's own."""
    return service.shown_lot(session, service.accept_lot(session, lot_id, actor=who.id), actor=who.id)


@router.post("/lots/{lot_id}/inspect")
def inspect_fully(lot_id: PathId, who: Reviewer, session: Writing) -> ShownLot:
    """Full inspection: the rest goes to the queue, and into no other lot."""
    return service.shown_lot(session, service.inspect_fully(session, lot_id, actor=who.id), actor=who.id)


@router.post("/lots/{lot_id}/dissolve")
def dissolve_lot(lot_id: PathId, who: Reviewer, session: Writing) -> ShownLot:
    """Take a draw back of which nothing was judged yet."""
    return service.shown_lot(session, service.dissolve_lot(session, lot_id, actor=who.id), actor=who.id)


@router.post("/lots/{lot_id}/take-back")
def take_back_lot(lot_id: PathId, who: Reviewer, session: Writing) -> ShownLot:
    """Take an acceptance back as a whole; what was judged or measured since stays."""
    return service.shown_lot(session, service.take_back_lot(session, lot_id, actor=who.id), actor=who.id)
