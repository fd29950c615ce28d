"""Review by lots: what could be drawn, the draw, how far a sample is, and what becomes of the lot."""

from collections import Counter, defaultdict
from collections.abc import Collection, Sequence
from typing import Any

from sightline.enums import LotGrouping, LotRole
from sightline.errors import BadInput, Conflict, NotAllowed
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.database.rows import names
from sightline.reviews.lots import query, store
from sightline.reviews.lots.judged import items_of, lot_item
from sightline.reviews.lots.records import (
    CurvePoint,
    Lot,
    LotItem,
    LotPlace,
    LotSummary,
    PlannedLot,
    Progress,
    ShownLot,
)
from sightline.statistics.acceptance import (
    RiskPoints,
    SamplingPlan,
    accepted_with,
    best_bad,
    operating_curve,
    outgoing_of_lots,
    require_risks,
    single_plan,
    worst_good,
)

_Group = tuple[dict[str, Any], list[tuple[int, int]]]


def planned_lots(
    session: Session, survey_id: int, by: Collection[LotGrouping], risks: RiskPoints
) -> tuple[PlannedLot, ...]:
    """The lots that could be drawn now, the largest first. Raises BadInput for risks that are none."""
    require_risks(risks)
    groups = _groups(session, survey_id, by)
    people = names(session, [common.get("operator_id") for common, _ in groups])
    return tuple(_planned(common, len(items), risks, people) for common, items in groups)


def draw_lots(
    session: Session, survey_id: int, by: Collection[LotGrouping], risks: RiskPoints, *, actor: int | None
) -> tuple[int, ...]:
    """Draw every lot whose sample is not all of it; their ids.

    What is in no lot is reviewed one by one. Raises BadInput for risks that are none, and where no lot saves
    anything.
    """
    require_risks(risks)
    drawn = []
    for common, items in _groups(session, survey_id, by):
        plan = single_plan(len(items), risks)
        if plan.saves:
            drawn.append(store.add_lot(session, survey_id, common, items, plan, risks, actor=actor))
    if not drawn:
        raise BadInput("lots-nothing-to-draw")
    return tuple(drawn)


def accept_lot(session: Session, lot_id: int, *, actor: int) -> Lot:
    """The rest of the lot is accepted by its sample, as one act. Raises NotFound, Conflict where the sample
    is not judged, or holds too many, NotAllowed where heights of the rest are the actor's own.
    """
    lot = _open(session, lot_id)
    items = _items(session, lot)
    progress = progress_of(lot, items)
    if progress.judged < progress.sample:
        raise Conflict("lots-sample-not-judged", count=progress.sample - progress.judged)
    if not progress.may_accept:
        raise Conflict("lots-too-many", count=progress.nonconforming, most=lot.acceptance_number)
    rest = [one for one in items if one.role == "rest"]
    if query.own_items(session, lot_id, actor) & {one.measurement_id for one in rest}:
        raise NotAllowed("lots-own-heights")
    store.add_decision(session, lot, "accepted", items, actor=actor)
    vehicle = query.vehicles_of(session, lot.id)
    judged = [(one.measurement_id, one.revision, vehicle[one.measurement_id]) for one in rest]
    store.add_verdicts_by_lot(session, lot, "accepted", judged, then="to_review", actor=actor)
    return query.get_lot(session, lot_id)


def inspect_fully(session: Session, lot_id: int, *, actor: int) -> Lot:
    """The lot is not accepted by its sample: its rest goes to the queue, each for itself, for good.

    Raises NotFound, Conflict where something was decided already.
    """
    lot = _open(session, lot_id)
    store.add_decision(session, lot, "full_inspection", _items(session, lot), actor=actor)
    return query.get_lot(session, lot_id)


def dissolve_lot(session: Session, lot_id: int, *, actor: int) -> Lot:
    """Take a draw back before anybody judged any of it. Raises NotFound, Conflict later: whoever could draw
    again until a sample pleases would need no sample.
    """
    lot = _open(session, lot_id)
    now = query.items_now(session, (lot,))[lot.id]
    items = items_of(now, lot.sample_size)
    sample = {one.measurement_id for one in items if one.role == "sample"}
    if any(one.said for one in now if one.measurement_id in sample):
        raise Conflict("lots-judged-already")
    store.add_decision(session, lot, "dissolved", items, actor=actor)
    return query.get_lot(session, lot_id)


def take_back_lot(session: Session, lot_id: int, *, actor: int) -> Lot:
    """Every verdict that stands by this lot is taken back, as one act; what was judged or measured since
    stays. Raises NotFound, Conflict unless the lot was accepted.
    """
    lot = query.get_lot(session, lot_id)
    if lot.state != "accepted" or lot.decision is None:
        raise Conflict("lots-not-accepted")
    standing = [
        (row.series_id, row.revision, row.vehicle_id) for row in query.standing_by_lot(session, lot_id)
    ]
    store.add_taking_back(session, lot, lot.decision, len(standing), actor=actor)
    store.add_verdicts_by_lot(session, lot, "reopened", standing, then="accepted", actor=actor)
    return query.get_lot(session, lot_id)


def shown_lots(session: Session, survey_id: int, *, actor: int | None) -> tuple[ShownLot, ...]:
    """A survey's lots with all that is told of them, newest first."""
    found = lots_with_items(session, query.list_lots(session, survey_id))
    return tuple(_show_lot(session, lot, items, actor) for lot, items in reversed(found))


def shown_lot(session: Session, lot: Lot, *, actor: int | None) -> ShownLot:
    """One of them."""
    ((_, items),) = lots_with_items(session, (lot,))
    return _show_lot(session, lot, items, actor)


def lots_with_items(session: Session, lots: Sequence[Lot]) -> list[tuple[Lot, tuple[LotItem, ...]]]:
    """Each lot with its items: as they stand, or as they stood when it was decided."""
    now = query.items_now(session, lots)
    return [
        (
            lot,
            items_of(now[lot.id], lot.sample_size)
            if lot.state == "open"
            else decided_items(lot, now[lot.id]),
        )
        for lot in lots
    ]


def decided_items(lot: Lot, now: Sequence[Any]) -> tuple[LotItem, ...]:
    """The items as the first decision on the lot found them; what they were judged is not told again."""
    first = lot.decisions[0]
    sample = first.sample
    roles: dict[int, LotRole] = {**dict.fromkeys(first.left_out, "left"), **dict.fromkeys(sample, "sample")}
    return tuple(
        lot_item(item, roles.get(item.measurement_id, "rest"), why=first.left_out.get(item.measurement_id))
        for item in now
    )


def lot_summary(session: Session, survey_id: int) -> LotSummary:
    """How many accepted heights rest on what, and what accepted lots let through at most."""
    counts = query.accepted_counts(session, survey_id)
    individual = counts.pop(None, 0)
    passed = outgoing_of_lots(
        (one.judged + one.rest, one.judged, one.nonconforming, counts[lot.id])
        for lot in query.list_lots(session, survey_id)
        if lot.state == "accepted" and (one := lot.decision) is not None
    )
    held = sum(not place.in_sample for place in places_in_open_lots(session, survey_id).values())
    return LotSummary(individual=individual, by_lot=counts.total(), waiting=held, outgoing=passed)


def places_in_open_lots(session: Session, survey_id: int) -> dict[int, LotPlace]:
    """Of each measurement that an open lot holds: which lot, and whether it is of the sample."""
    return {
        item.measurement_id: LotPlace(lot.id, lot.number, item.role == "sample")
        for lot, items in lots_with_items(session, query.open_lots(session, survey_id))
        for item in items
        if item.role != "left"
    }


def progress_of(lot: Lot, items: Sequence[LotItem], own: Collection[int] = ()) -> Progress:
    """How far a lot is; `own`: measurements that are the asker's own (`is_own`)."""
    sample = [one for one in items if one.role == "sample"]
    waiting = [one.measurement_id for one in sample if one.conforming is None]
    bad = sum(one.conforming is False for one in sample)
    return Progress(
        sample=len(sample),
        judged=len(sample) - len(waiting),
        nonconforming=bad,
        rest=sum(one.role == "rest" for one in items),
        left=dict(Counter(one.why for one in items if one.why is not None)),
        own=sum(one in own for one in waiting),
        may_accept=not waiting and bool(sample) and bad <= lot.acceptance_number,
        next_measurement=next((one for one in waiting if one not in own), None),
    )


def _show_lot(session: Session, lot: Lot, items: Sequence[LotItem], actor: int | None) -> ShownLot:
    progress = _progress(session, lot, items, actor)
    plan = SamplingPlan(lot.size, lot.sample_size, lot.acceptance_number, 0.0, 0.0)
    shown_to = min(1.0, 2.5 * lot.risks.consumer_quality)
    curve = operating_curve(plan, shown_to)
    return ShownLot(
        lot=lot,
        state=lot.state,
        progress=progress,
        curve=tuple(CurvePoint(*map(float, at)) for at in zip(curve.fraction, curve.accepted, strict=True)),
        kept=_risks_kept(lot),
        outgoing=lot.outgoing,
    )


def _risks_kept(lot: Lot) -> RiskPoints:
    """Both points of the curve at whole numbers of heights, as the plan keeps them."""
    plan = (lot.sample_size, lot.acceptance_number)
    good, bad = worst_good(lot.size, lot.risks), best_bad(lot.size, lot.risks)
    refused = max(0.0, 1.0 - accepted_with(lot.size, good, *plan))
    return RiskPoints(good / lot.size, refused, bad / lot.size, accepted_with(lot.size, bad, *plan))


def _progress(session: Session, lot: Lot, items: Sequence[LotItem], actor: int | None) -> Progress:
    decided = lot.decision
    if decided is None:
        own = query.own_items(session, lot.id, actor) if actor is not None else ()
        return progress_of(lot, items, own)
    return filled_from(
        Progress,
        decided,
        sample=len(decided.sample),
        left=dict(Counter(decided.left_out.values())),
        own=0,
        may_accept=False,
        next_measurement=None,
    )


def _open(session: Session, lot_id: int) -> Lot:
    lot = query.get_lot(session, lot_id)
    if lot.state != "open":
        raise Conflict("lots-decided-already", number=lot.number)
    return lot


def _items(session: Session, lot: Lot) -> tuple[LotItem, ...]:
    return items_of(query.items_now(session, (lot,))[lot.id], lot.sample_size)


def _groups(session: Session, survey_id: int, by: Collection[LotGrouping]) -> list[_Group]:
    """What waits, divided; the largest first."""
    groups: dict[tuple[Any, ...], list[tuple[int, int]]] = defaultdict(list)
    names_of: dict[LotGrouping, str] = {
        "target": "target",
        "lighting": "lighting",
        "operator": "operator_id",
        "day": "day",
    }
    wanted = [(one, names_of[one]) for one in names_of if one in by]
    for row in query.waiting_measurements(session, survey_id):
        has = {**row._mapping, "day": row.clicked_at.date().isoformat()}
        groups[tuple(has[name] for _, name in wanted)].append((row.series_id, row.revision))
    found = [
        ({name: value for (_, name), value in zip(wanted, values, strict=True)}, items)
        for values, items in groups.items()
    ]
    return sorted(found, key=lambda one: (-len(one[1]), str(one[0])))


def _planned(common: dict[str, Any], size: int, risks: RiskPoints, people: dict[int, str]) -> PlannedLot:
    plan = single_plan(size, risks)
    return filled_from(PlannedLot, plan, common=query.common_of(common, people), size=size, saves=plan.saves)
