"""Reference values of scanned vehicles: append-only revisions by quantity and source."""

from collections.abc import Iterable
from dataclasses import asdict, replace

from sqlalchemy import ColumnElement, exists, select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject, ReferenceQuantity, ReferenceSource
from sightline.errors import Conflict
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.audit.written import written_once, written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import missing
from sightline.scans.references.records import ReferenceValues, StoredReference, require_reference
from sightline.scans.tables import scan_references, scan_vehicles
from sightline.scans.vehicles.store import require_scan_vehicle_version

_KEY = ("vehicle_id", "quantity", "source")
_later = scan_references.alias("later")
_is_current: ColumnElement[bool] = ~exists().where(
    *(_later.c[name] == scan_references.c[name] for name in _KEY),
    _later.c.revision > scan_references.c.revision,
)
_alive: ColumnElement[bool] = scan_references.c.vehicle_id.in_(
    select(scan_vehicles.c.id).where(scan_vehicles.c.deleted_at.is_(None))
)


def append_scan_reference(
    session: Session,
    vehicle_id: int,
    values: ReferenceValues,
    *,
    seen_revision: int,
    matched: JsonObject | None = None,
    actor: int | None,
) -> StoredReference:
    """The next revision of what a source says of a vehicle; `seen_revision`: 0 where none was there. The
    same once more adds nothing. `matched`: how its vehicle was found by time, which the event keeps.

    Raises NotFound, BadInput, Conflict if it was changed meanwhile or the vehicle was deleted.
    """
    require_reference(values)
    before = _current(session, vehicle_id, values.quantity, values.source)
    if before is not None and before.values == values:
        return before
    return _append(session, vehicle_id, values, before, seen_revision, actor, matched)


def withdraw_scan_reference(
    session: Session,
    vehicle_id: int,
    quantity: ReferenceQuantity,
    source: ReferenceSource,
    *,
    seen_revision: int,
    actor: int | None,
) -> StoredReference:
    """Take a value back: a revision that says so. Raises NotFound, Conflict (changed or withdrawn)."""
    before = _current(session, vehicle_id, quantity, source)
    if before is None:
        raise missing("reference value of this source")
    if before.values.withdrawn:
        raise Conflict("reference-withdrawn-already")
    values = replace(before.values, withdrawn=True)
    return _append(session, vehicle_id, values, before, seen_revision, actor)


def standing_references(session: Session, scan_id: int) -> dict[int, tuple[StoredReference, ...]]:
    """What stands of each living vehicle of a scan that has any, by vehicle; one query."""
    return _by_vehicle(_fetch_references(session, (scan_references.c.scan_id == scan_id) & _alive & _stands))


def standing_references_of(session: Session, vehicle_id: int) -> tuple[StoredReference, ...]:
    """What stands of one vehicle, deleted or not."""
    return _fetch_references(session, (scan_references.c.vehicle_id == vehicle_id) & _stands)


def reference_history_of_scan(session: Session, scan_id: int) -> tuple[StoredReference, ...]:
    """Every revision of a scan's living vehicles, oldest first."""
    return _fetch_references(session, (scan_references.c.scan_id == scan_id) & _alive)


_stands: ColumnElement[bool] = _is_current & ~scan_references.c.withdrawn


def _by_vehicle(found: Iterable[StoredReference]) -> dict[int, tuple[StoredReference, ...]]:
    out: dict[int, tuple[StoredReference, ...]] = {}
    for one in found:
        out[one.vehicle_id] = (*out.get(one.vehicle_id, ()), one)
    return out


def _current(
    session: Session, vehicle_id: int, quantity: ReferenceQuantity, source: ReferenceSource
) -> StoredReference | None:
    mine = dict(zip(_KEY, (vehicle_id, quantity, source), strict=True))
    found = _fetch_references(
        session, *(scan_references.c[name] == value for name, value in mine.items()), _is_current
    )
    return found[0] if found else None


def _append(
    session: Session,
    vehicle_id: int,
    values: ReferenceValues,
    before: StoredReference | None,
    seen_revision: int,
    actor: int | None,
    matched: JsonObject | None = None,
) -> StoredReference:
    vehicle = require_scan_vehicle_version(session, vehicle_id, None)
    revision = before.revision if before else 0
    if revision != seen_revision:
        name = name_or_somebody(before.created_by if before else None)
        raise Conflict("reference-changed-meanwhile", name=name)
    place = {"survey_id": vehicle["survey_id"], "scan_id": vehicle["scan_id"], "vehicle_id": vehicle_id}
    row_id = written_once(
        session,
        scan_references,
        {**place, "revision": revision + 1, **asdict(values)},
        "withdraw" if values.withdrawn else "create" if before is None else "revise",
        before={**asdict(before.values), "revision": revision} if before else None,
        also={} if matched is None else {"matched": matched},
        actor=actor,
    )
    return _fetch_references(session, scan_references.c.id == row_id)[0]


def _fetch_references(session: Session, *conditions: ColumnElement[bool]) -> tuple[StoredReference, ...]:
    rows = written_rows(session, scan_references, *conditions)
    return tuple(record_of(StoredReference, row, values=record_of(ReferenceValues, row)) for row in rows)
