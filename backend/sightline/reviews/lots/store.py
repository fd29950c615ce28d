"""Writing lots: a draw, a decision, and the verdicts that follow from it, each with its audit event.

A lot's verdicts are written together: a few statements for a lot, however many heights it holds.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from sightline.enums import LotChoice, ReviewVerdict
from sightline.infra.audit import trail
from sightline.infra.audit.records import survey_chain
from sightline.infra.audit.written import written_once
from sightline.infra.database.rows import add_rows, stored_hashes
from sightline.infra.database.types import now
from sightline.measurements.tables import reviews
from sightline.reviews.lots.draw import drawn_order, seed_of
from sightline.reviews.lots.records import Decision, Lot, LotItem
from sightline.reviews.lots.tables import lot_decisions, lot_items, lots
from sightline.statistics.acceptance import RiskPoints, SamplingPlan

_SOME = 500


def add_lot(
    session: Session,
    survey_id: int,
    common: Mapping[str, Any],
    items: Sequence[tuple[int, int]],
    plan: SamplingPlan,
    risks: RiskPoints,
    *,
    actor: int | None,
) -> int:
    """Draw a lot of (measurement, revision): the seed is the chain's end, which nobody chooses. Its id."""
    head = trail.hold_chain_end(session, survey_chain(survey_id))
    seed = seed_of(head.hash, items)
    revisions = dict(items)
    drawn = [(number, revisions[number]) for number in drawn_order(seed, revisions)]
    last = session.execute(select(func.max(lots.c.number)).where(lots.c.survey_id == survey_id)).scalar_one()
    content = {
        "survey_id": survey_id,
        "number": (last or 0) + 1,
        "common": dict(common),
        "size": plan.size,
        "sample_size": plan.sample_size,
        "acceptance_number": plan.acceptance_number,
        **asdict(risks),
        "seed": seed,
        "created_by": actor,
    }
    lot_id = written_once(session, lots, content, "draw", also={"items": drawn}, actor=actor)
    places = [
        {"lot_id": lot_id, "series_id": number, "revision": revision, "place": place}
        for place, (number, revision) in enumerate(drawn, 1)
    ]
    add_rows(session, lot_items, places)
    return lot_id


def add_decision(
    session: Session, lot: Lot, choice: LotChoice, items: Sequence[LotItem], *, actor: int | None
) -> int:
    """Note what becomes of a lot as its items stand."""
    sample = [one for one in items if one.role == "sample"]
    account = {
        "judged": sum(one.conforming is not None for one in sample),
        "nonconforming": sum(one.conforming is False for one in sample),
        "rest": sum(one.role == "rest" for one in items),
        "sample": [one.measurement_id for one in sample],
        "left_out": {str(one.measurement_id): one.why for one in items if one.role == "left"},
    }
    return _add_decision(session, lot, choice, account, actor)


def add_taking_back(session: Session, lot: Lot, accepted: Decision, rest: int, *, actor: int | None) -> int:
    """Note that an acceptance was taken back; `rest` verdicts stood by it still."""
    account = {
        "judged": accepted.judged,
        "nonconforming": accepted.nonconforming,
        "rest": rest,
        "sample": list(accepted.sample),
        "left_out": {str(number): why for number, why in accepted.left_out.items()},
    }
    return _add_decision(session, lot, "taken_back", account, actor)


def _add_decision(
    session: Session, lot: Lot, choice: LotChoice, told: Mapping[str, Any], actor: int | None
) -> int:
    content = {"lot_id": lot.id, "choice": choice, **told, "created_by": actor}
    then = {"choice": lot.state}
    return written_once(
        session, lot_decisions, content, choice, survey_id=lot.survey_id, before=then, actor=actor
    )


def add_verdicts_by_lot(
    session: Session,
    lot: Lot,
    verdict: ReviewVerdict,
    judged: Sequence[tuple[int, int, int]],
    *,
    then: str,
    actor: int | None,
) -> None:
    """The same verdict on (measurement, revision, vehicle) by lot; each has an audit event of its own."""
    moment = now()
    for at in range(0, len(judged), _SOME):
        some = judged[at : at + _SOME]
        contents = [
            {
                "series_id": number,
                "revision": revision,
                "result_revision": revision,
                "verdict": verdict,
                "reason": None,
                "lot_id": lot.id,
                "created_at": moment,
            }
            for number, revision, _ in some
        ]
        ids = add_rows(session, reviews, [{**one, "created_by": actor} for one in contents])
        hashes = stored_hashes(session, reviews, ids)
        events = [
            (id_, {"verdict": then}, {**content, "vehicle_id": vehicle, "content_sha256": hashes[id_]})
            for id_, content, (_, _, vehicle) in zip(ids, contents, some, strict=True)
        ]
        trail.record_many(session, actor, "review", "review", lot.survey_id, events)
