"""Reading lots: what could be drawn, what was, and what became of the items, for all of a survey at once."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from typing import Any, get_args

from sqlalchemy import ColumnElement, and_, exists, func, select
from sqlalchemy.orm import Session

from sightline.enums import AcceptedVerdict, LotLeaving
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import names, the_one, who
from sightline.measurements.query import (
    clicked_at,
    is_current,
    is_first,
    is_own,
    operator_id,
    verdict,
    waits,
    with_verdict,
)
from sightline.measurements.tables import measurement_series, measurements, reviews
from sightline.recordings.tables import recordings
from sightline.reviews.lots.judged import ItemNow, Judgement
from sightline.reviews.lots.records import Common, Decision, Lot
from sightline.reviews.lots.tables import lot_decisions, lot_items, lots
from sightline.statistics.acceptance import RiskPoints
from sightline.vehicles.tables import vehicles

_m, _item = measurements.c, lot_items.c
_RISKS = tuple(one.name for one in fields(RiskPoints))
_newer = lot_decisions.alias("newer")
_newest: ColumnElement[bool] = ~exists().where(
    _newer.c.lot_id == lot_decisions.c.lot_id, _newer.c.id > lot_decisions.c.id
)


def waiting_measurements(session: Session, survey_id: int) -> Sequence[Any]:
    """The standing heights on frames that wait for a verdict and are in no lot that is open, nor went to full
    inspection with this revision: (series_id, revision, target, lighting, operator_id, clicked_at). Those in
    line scans are judged one by one: a lot's items are revisions of measurements.csv in the package.
    """
    light = func.coalesce(vehicles.c.lighting, recordings.c.lighting).label("lighting")
    closed = (
        select(lot_items.c.series_id)
        .select_from(lot_items)
        .outerjoin(lot_decisions, and_(lot_decisions.c.lot_id == _item.lot_id, _newest))
        .where(_item.series_id == _m.series_id, _item.revision == _m.revision)
        .where(func.coalesce(lot_decisions.c.choice, "open").in_(("open", "full_inspection")))
        .correlate(measurements)
    )
    query = (
        with_verdict(
            *(_m.series_id, _m.revision, _m.target, light),
            *(operator_id.label("operator_id"), clicked_at.label("clicked_at")),
        )
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .join(recordings, recordings.c.id == measurement_series.c.recording_id)
        .where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(is_current, is_first, waits, ~_m.withdrawn, _m.status == "ok", ~closed.exists())
        .order_by(_m.series_id)
    )
    return session.execute(query).all()


def list_lots(session: Session, survey_id: int) -> tuple[Lot, ...]:
    """A survey's lots, oldest first."""
    return _lots(session, lots.c.survey_id == survey_id)


def get_lot(session: Session, lot_id: int) -> Lot:
    """One of them. Raises NotFound."""
    return the_one(_lots(session, lots.c.id == lot_id), "lot", lot_id)


def open_lots(session: Session, survey_id: int) -> tuple[Lot, ...]:
    """Those on which nothing was decided."""
    decided = exists().where(_newer.c.lot_id == lots.c.id)
    return _lots(session, and_(lots.c.survey_id == survey_id, ~decided))


def _lots(session: Session, condition: ColumnElement[bool]) -> tuple[Lot, ...]:
    maker = people.c.name.label("maker")
    drawn = session.execute(
        select(lots, maker)
        .outerjoin(people, people.c.id == lots.c.created_by)
        .where(condition)
        .order_by(lots.c.id)
    ).all()
    if not drawn:
        return ()
    by_lot: dict[int, list[Decision]] = defaultdict(list)
    decided = (
        select(lot_decisions, maker)
        .join(lots, lots.c.id == lot_decisions.c.lot_id)
        .outerjoin(people, people.c.id == lot_decisions.c.created_by)
        .where(condition)
        .order_by(lot_decisions.c.id)
    )
    for row in session.execute(decided):
        by_lot[row.lot_id].append(decision_of(row._mapping, row.maker))
    operators = names(session, [row.common.get("operator_id") for row in drawn])
    return tuple(lot_of(row._mapping, row.maker, operators, by_lot[row.id]) for row in drawn)


def decision_of(row: Any, maker: str | None) -> Decision:
    """The record of a row of `lot_decisions`, or of what its event says."""
    left = {int(number): why for number, why in row["left_out"].items()}
    by = who(row["created_by"], maker)
    return record_of(Decision, row, sample=tuple(row["sample"]), left_out=left, created_by=by)


def lot_of(row: Any, maker: str | None, operators: Any, decisions: Iterable[Decision]) -> Lot:
    """The record of a row of `lots`, or of what its event says; `operators`: names by number."""
    return record_of(
        Lot,
        row,
        common=common_of(row["common"], operators),
        risks=RiskPoints(**{name: float(row[name]) for name in _RISKS}),
        created_by=who(row["created_by"], maker),
        decisions=tuple(decisions),
    )


def common_of(told: Mapping[str, Any], operators: Any) -> Common:
    """What a lot's heights have in common, as it is stored; `operators`: names by number."""
    others = {name: value for name, value in told.items() if name != "operator_id"}
    by = told.get("operator_id")
    return Common(**others, operator=who(by, operators.get(by)))


def items_now(session: Session, lots_: Sequence[Lot]) -> dict[int, list[ItemNow]]:
    """The items of these lots with what became of them since each was drawn, by lot; three queries."""
    if not lots_:
        return {}
    wanted = _item.lot_id.in_([one.id for one in lots_])
    judgements = _fetch_judgements(session, wanted)
    heights = _heights(session, wanted)
    current = (
        select(*(_item.lot_id, _item.series_id, _item.revision, _item.place), _m.revision.label("newest"))
        .add_columns(_m.withdrawn, vehicles.c.deleted_at)
        .select_from(lot_items)
        .join(measurements, measurements.c.series_id == _item.series_id)
        .join(measurement_series, measurement_series.c.id == _item.series_id)
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(wanted, is_current)
        .order_by(_item.lot_id, _item.place)
    )
    by_lot: dict[int, list[ItemNow]] = {one.id: [] for one in lots_}
    for row in session.execute(current):
        key = (row.lot_id, row.series_id)
        by_lot[row.lot_id].append(
            record_of(
                ItemNow,
                row._mapping,
                measurement_id=row.series_id,
                gone=_reason_of_leaving(row.deleted_at is not None, row.withdrawn),
                said=judgements.get(key, ()),
                heights=heights.get(key, {}),
            )
        )
    return by_lot


def _reason_of_leaving(deleted: bool, withdrawn: bool) -> LotLeaving | None:
    if deleted:
        return "vehicle_deleted"
    return "withdrawn" if withdrawn else None


def _fetch_judgements(
    session: Session, wanted: ColumnElement[bool]
) -> dict[tuple[int, int], list[Judgement]]:
    r = reviews.c
    query = (
        select(_item.lot_id, r.series_id, r.revision, r.result_revision, r.verdict)
        .select_from(reviews)
        .join(lot_items, _item.series_id == r.series_id)
        .join(lots, lots.c.id == _item.lot_id)
        .where(wanted, r.lot_id.is_(None), r.created_at >= lots.c.created_at)
        .order_by(r.id)
    )
    found: dict[tuple[int, int], list[Judgement]] = defaultdict(list)
    for row in session.execute(query):
        found[row.lot_id, row.series_id].append(Judgement(row.revision, row.result_revision, row.verdict))
    return found


def _heights(
    session: Session, wanted: ColumnElement[bool]
) -> dict[tuple[int, int], dict[int, tuple[float | None, float | None]]]:
    """Of items with revisions since, the heights of the lot's revision and of those after it."""
    later = measurements.alias("later_one")
    changed = exists().where(later.c.series_id == _item.series_id, later.c.revision > _item.revision)
    query = (
        select(_item.lot_id, _m.series_id, _m.revision, _m.height_m, _m.U95_height_m)
        .select_from(measurements)
        .join(lot_items, _item.series_id == _m.series_id)
        .where(wanted, _m.revision >= _item.revision, changed)
    )
    found: dict[tuple[int, int], dict[int, tuple[float | None, float | None]]] = defaultdict(dict)
    for row in session.execute(query):
        found[row.lot_id, row.series_id][row.revision] = (row.height_m, row.U95_height_m)
    return found


def own_items(session: Session, lot_id: int, person_id: int) -> set[int]:
    """The items of a lot whose revision in it is this person's own."""
    query = (
        select(_item.series_id)
        .join(measurements, and_(_m.series_id == _item.series_id, _m.revision == _item.revision))
        .where(_item.lot_id == lot_id, is_own(person_id))
    )
    return set(session.execute(query).scalars())


def standing_by_lot(session: Session, lot_id: int) -> Sequence[Any]:
    """The heights whose verdict is this lot's: (series_id, revision, vehicle_id), as they stand."""
    query = (
        with_verdict(_m.series_id, _m.revision, measurement_series.c.vehicle_id)
        .where(is_current, ~_m.withdrawn, reviews.c.lot_id == lot_id, verdict == "accepted")
        .order_by(_m.series_id)
    )
    return session.execute(query).all()


def vehicles_of(session: Session, lot_id: int) -> dict[int, int]:
    """The vehicle of each item of a lot."""
    query = (
        select(measurement_series.c.id, measurement_series.c.vehicle_id)
        .join(lot_items, _item.series_id == measurement_series.c.id)
        .where(_item.lot_id == lot_id)
    )
    return {row.id: row.vehicle_id for row in session.execute(query)}


def accepted_counts(session: Session, survey_id: int) -> Counter[int | None]:
    """How many standing heights were accepted by each lot; by None: accepted or fixed by themselves."""
    query = (
        with_verdict(reviews.c.lot_id, func.count().label("count"))
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(is_current, is_first, ~_m.withdrawn, verdict.in_(get_args(AcceptedVerdict)))
        .group_by(reviews.c.lot_id)
    )
    return Counter({row.lot_id: int(row._mapping["count"]) for row in session.execute(query)})


def items_of_deleted_vehicles(session: Session, survey_id: int) -> set[int]:
    """The measurements in lots of a survey whose vehicle was deleted."""
    query = (
        select(_item.series_id)
        .join(measurement_series, measurement_series.c.id == _item.series_id)
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(vehicles.c.survey_id == survey_id, vehicles.c.deleted_at.is_not(None))
    )
    return set(session.execute(query).scalars())
