"""Measurements of scanned vehicles: append-only revisions. Nothing changes a row; the database refuses it."""

from dataclasses import asdict
from typing import Any

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from backend.errors import BadInput
from backend.storage import audit
from backend.storage.columns import now
from backend.storage.rows import add_row, change_row, missing, stored_hash
from backend.storage.scans_query import is_current, measurement, revisions
from backend.storage.scans_records import ScanMeasurement, ScanValues
from backend.storage.scans_vehicles import seen
from backend.storage.tables_of_scans import scan_measurements, scan_vehicles

_TOLD = (
    "cause",
    "method",
    "front_line_1",
    "rear_line_1",
    "front_line_2",
    "rear_line_2",
    "speed_mps",
    "u_speed_mps",
    "acceleration_mps2",
    "u_acceleration_mps2",
    "length_m",
    "u_length_m",
    "fit_error_percent",
    "front_wheel_line",
    "rear_wheel_line",
    "wheelbase_m",
    "u_wheelbase_m",
    "status",
    "reason",
)


def append(
    session: Session,
    vehicle_id: int,
    values: ScanValues,
    *,
    version: int | None = None,
    actor: int | None,
) -> ScanMeasurement:
    """The next revision of a vehicle's motion; the vehicle's version counts up with it.

    Raises Conflict if `version` (None: any) is not the current one or the vehicle was deleted, BadInput.
    """
    row = seen(session, vehicle_id, version)
    _check(values)
    before = _current(session, vehicle_id)
    revision = 1 if before is None else before.revision + 1
    place = {"survey_id": row["survey_id"], "scan_id": row["scan_id"], "vehicle_id": vehicle_id}
    content = {**place, **asdict(values), "revision": revision}
    moment = now()
    row_id = add_row(session, scan_measurements, {**content, "created_at": moment, "created_by": actor})
    stamps = {"version": row["version"] + 1, "updated_at": moment, "updated_by": actor}
    change_row(session, scan_vehicles, vehicle_id, stamps)
    then = None
    if before is not None:
        then = {name: getattr(before.values, name) for name in _TOLD} | {"revision": before.revision}
    after: dict[str, Any] = {name: getattr(values, name) for name in _TOLD} | {"revision": revision}
    after |= {"vehicle_id": vehicle_id, "run_id": values.run_id}
    after["content_sha256"] = stored_hash(session, scan_measurements, row_id)
    action = "create" if before is None else "revise"
    audit.record(session, actor, action, "scan_measurement", row_id, row["survey_id"], then, after)
    return get(session, row_id)


def get(session: Session, measurement_id: int) -> ScanMeasurement:
    """One revision. Raises NotFound."""
    query = revisions().where(scan_measurements.c.id == measurement_id)
    row = session.execute(query).mappings().one_or_none()
    if row is None:
        raise missing("measurement of a scanned vehicle", measurement_id)
    return measurement(row)


def history(session: Session, vehicle_id: int) -> tuple[ScanMeasurement, ...]:
    """Every revision of a vehicle, oldest first, without profiles."""
    query = revisions(profile=False).where(scan_measurements.c.vehicle_id == vehicle_id)
    rows = session.execute(query.order_by(scan_measurements.c.revision)).mappings()
    return tuple(measurement(row) for row in rows)


def is_newest(session: Session, one: ScanMeasurement) -> bool:
    """Whether no later revision of the same vehicle is there."""
    newest = select(func.max(scan_measurements.c.revision)).where(
        scan_measurements.c.vehicle_id == one.vehicle_id
    )
    return bool(session.execute(newest).scalar_one() == one.revision)


def _current(session: Session, vehicle_id: int) -> ScanMeasurement | None:
    query = revisions(profile=False).where(scan_measurements.c.vehicle_id == vehicle_id, is_current)
    row = session.execute(query).mappings().one_or_none()
    return None if row is None else measurement(row)


def _check(values: ScanValues) -> None:
    for camera, front, rear in (
        (1, values.front_line_1, values.rear_line_1),
        (2, values.front_line_2, values.rear_line_2),
    ):
        if not front < rear:
            raise BadInput(
                f"At camera {camera} the front (line {front:.1f}) must come before the rear ({rear:.1f}); "
                "place them again."
            )
    if values.status != "ok" and not values.reason:
        raise BadInput("A vehicle that has no speed needs the reason why; measure it again.")
