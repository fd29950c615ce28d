"""Both tyre contacts of a vehicle on one frame. Rows are only added; the newest of a vehicle counts."""

from typing import Any

from sqlalchemy import exists, select
from sqlalchemy.orm import Session

from sightline.enums import AuditAction, Point
from sightline.errors import Conflict
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.audit.written import written_once
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import get_row, missing, who
from sightline.measurements.tables import wheel_pairs
from sightline.quality.checks.records import WheelPair
from sightline.recordings.frames.store import get_frame
from sightline.recordings.tables import recordings
from sightline.vehicles.tables import vehicles

_PLACED = ("frame", "pts", "time_s", "frame_crc32", "first_x_px", "first_y_px", "second_x_px", "second_y_px")
_later = wheel_pairs.alias("later")
_is_newest = ~exists().where(_later.c.vehicle_id == wheel_pairs.c.vehicle_id, _later.c.id > wheel_pairs.c.id)


def add_wheel_pair(
    session: Session,
    vehicle_id: int,
    *,
    frame: int,
    frame_crc32: int,
    first: Point,
    second: Point,
    seen: int | None = None,
    actor: int | None,
) -> WheelPair:
    """Store where both tyres of a vehicle touch the road, in place of the pair before.

    Raises NotFound for a deleted vehicle or a frame that is not there, Conflict for another picture
    or another pair than `seen` (0: none).
    """
    _require_seen(of_vehicle(session, vehicle_id), seen)
    vehicle = get_row(session, vehicles, vehicle_id, "vehicle", vehicles.c.deleted_at.is_(None))
    found = get_frame(session, vehicle["recording_id"], frame)
    if found.crc32 != frame_crc32:
        raise Conflict("measurements-frame-not-clicked", frame=frame)
    places = (frame, found.pts, found.time_s, found.crc32, *first, *second)
    return _append(session, vehicle, dict(zip(_PLACED, places, strict=True)), False, "create", actor)


def withdraw_wheel_pair(
    session: Session, vehicle_id: int, *, seen: int | None = None, actor: int | None
) -> WheelPair:
    """Take the pair of a vehicle out of the self-check. Raises NotFound where there is none, Conflict."""
    before = of_vehicle(session, vehicle_id)
    _require_seen(before, seen)
    if before is None:
        raise missing("pair of tyre contacts of this vehicle")
    row = get_row(session, wheel_pairs, before.id, "pair of tyre contacts")
    vehicle = get_row(session, vehicles, vehicle_id, "vehicle")
    return _append(session, vehicle, {name: row[name] for name in _PLACED}, True, "withdraw", actor)


def of_vehicle(session: Session, vehicle_id: int) -> WheelPair | None:
    """The pair that counts for a vehicle, None where there is none."""
    found = _fetch(session, wheel_pairs.c.vehicle_id == vehicle_id, ~wheel_pairs.c.withdrawn)
    return found[0] if found else None


def list_wheel_pairs(session: Session, survey_id: int) -> tuple[WheelPair, ...]:
    """The pairs that count of a survey's vehicles (deleted ones left out), by vehicle number."""
    return _fetch(session, wheel_pairs.c.survey_id == survey_id, ~wheel_pairs.c.withdrawn)


def _require_seen(before: WheelPair | None, seen: int | None) -> None:
    """Raises Conflict if another pair counts than the one that was seen; None: not compared."""
    if seen is not None and seen != (before.id if before else 0):
        name = name_or_somebody(before.created_by if before else None)
        raise Conflict("quality-tyres-changed-meanwhile", name=name)


def _append(
    session: Session,
    vehicle: dict[str, Any],
    values: dict[str, Any],
    withdrawn: bool,
    action: AuditAction,
    actor: int | None,
) -> WheelPair:
    place = {"survey_id": vehicle["survey_id"], "recording_id": vehicle["recording_id"]}
    content = {**place, "vehicle_id": vehicle["id"], **values, "withdrawn": withdrawn}
    row_id = written_once(session, wheel_pairs, content, action, actor=actor)
    return _fetch(session, wheel_pairs.c.id == row_id)[0]


def _fetch(session: Session, *conditions: Any) -> tuple[WheelPair, ...]:
    query = (
        select(wheel_pairs, vehicles.c.number, recordings.c.pose_id, people.c.name)
        .join(vehicles, vehicles.c.id == wheel_pairs.c.vehicle_id)
        .join(recordings, recordings.c.id == wheel_pairs.c.recording_id)
        .outerjoin(people, people.c.id == wheel_pairs.c.created_by)
        .where(_is_newest, vehicles.c.deleted_at.is_(None), *conditions)
        .order_by(vehicles.c.number)
    )
    return tuple(_pair(row) for row in session.execute(query))


def _pair(row: Any) -> WheelPair:
    return record_of(
        WheelPair,
        row._mapping,
        vehicle_number=row.number,
        first=(row.first_x_px, row.first_y_px),
        second=(row.second_x_px, row.second_y_px),
        created_by=who(row.created_by, row.name),
    )
