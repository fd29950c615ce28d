"""Measurements of scanned vehicles: append-only revisions. Nothing changes a row; the database refuses it."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

from sqlalchemy import func, select, update
from sqlalchemy.orm import Session

from sightline.errors import BadInput
from sightline.infra.audit import trail
from sightline.infra.database.rows import add_rows, get_row, missing, stored_hashes
from sightline.infra.database.types import now
from sightline.measurements.again.differences import judged_alike
from sightline.scans.query import scan_measurement_of_row, scan_revision_rows
from sightline.scans.records import ScanMeasurement, ScanValues, same_motion
from sightline.scans.tables import scan_measurements, scan_vehicles, scans
from sightline.scans.vehicles.store import require_scan_vehicle_version

# rows of one statement; each has some forty columns
_AT_ONCE = 500
# What stands in the row alone.
_UNTOLD = ("misalignment_px", "u_misalignment_px", "gain", "placed_by", "profile")
# What an event tells of its own revision, and not of the one before.
_OWN = ("run_id", "rig", "warnings", "code_version", "correlation", "budget")
_TOLD = tuple(one.name for one in fields(ScanValues) if one.name not in (*_UNTOLD, *_OWN))


def append_scan_measurement(
    session: Session, vehicle_id: int, values: ScanValues, *, version: int | None = None, actor: int | None
) -> ScanMeasurement:
    """The next revision of a vehicle's motion; the vehicle's version counts up with it.

    Raises Conflict if `version` (None: any) is not the current one or the vehicle was deleted, BadInput.
    """
    row = require_scan_vehicle_version(session, vehicle_id, version)
    return get_scan_measurement(
        session, append_scan_measurements(session, row["scan_id"], [(vehicle_id, values)], actor=actor)[0]
    )


def append_scan_measurements(
    session: Session, scan_id: int, measured: Sequence[tuple[int, ScanValues]], *, actor: int | None
) -> list[int]:
    """The ids of the next revisions of some vehicles of a scan, with an event each; a few statements.

    Whoever calls has looked, in this transaction, that the vehicles live and are as they were seen.
    Raises BadInput, NotFound for a deleted scan.
    """
    scan = get_row(session, scans, scan_id, "line-scan recording", scans.c.deleted_at.is_(None))
    for _, values in measured:
        _check(values)
    made: list[int] = []
    for start in range(0, len(measured), _AT_ONCE):
        made += _appended(session, scan, measured[start : start + _AT_ONCE], actor)
    return made


def _appended(
    session: Session, scan: Mapping[str, Any], measured: Sequence[tuple[int, ScanValues]], actor: int | None
) -> list[int]:
    vehicle_ids = [vehicle_id for vehicle_id, _ in measured]
    history, moment = _history(session, vehicle_ids), now()
    before = {vehicle_id: revisions[-1] for vehicle_id, revisions in history.items()}
    verdict_of = {
        vehicle_id: _verdict_that_stood(history.get(vehicle_id, []), values)
        for vehicle_id, values in measured
    }
    place = {"survey_id": scan["survey_id"], "scan_id": scan["id"]}
    stamps = {"created_at": moment, "created_by": actor}
    rows = [
        {
            **place,
            "vehicle_id": vehicle_id,
            **asdict(values),
            "revision": _next(before.get(vehicle_id)),
            "verdict_of_id": verdict_of[vehicle_id],
            **stamps,
        }
        for vehicle_id, values in measured
    ]
    row_ids = add_rows(session, scan_measurements, rows)
    change = {"version": scan_vehicles.c.version + 1, "updated_at": moment, "updated_by": actor}
    session.execute(update(scan_vehicles).where(scan_vehicles.c.id.in_(vehicle_ids)).values(change))
    hashes = stored_hashes(session, scan_measurements, row_ids)
    for action in ("create", "revise"):
        events = [
            (
                row_id,
                _event_before(before.get(vehicle_id)),
                {
                    **_event_after(vehicle_id, values, before.get(vehicle_id), hashes[row_id]),
                    "verdict_of_id": verdict_of[vehicle_id],
                    "created_at": moment,
                },
            )
            for row_id, (vehicle_id, values) in zip(row_ids, measured, strict=True)
            if (vehicle_id in before) == (action == "revise")
        ]
        trail.record_many(session, actor, action, "scan_measurement", scan["survey_id"], events)
    return row_ids


def _next(before: ScanMeasurement | None) -> int:
    return 1 if before is None else before.revision + 1


def _event_before(before: ScanMeasurement | None) -> dict[str, Any] | None:
    if before is None:
        return None
    return {name: getattr(before.values, name) for name in _TOLD} | {"revision": before.revision}


def _event_after(
    vehicle_id: int, values: ScanValues, before: ScanMeasurement | None, content_sha256: str
) -> dict[str, Any]:
    told: dict[str, Any] = {name: getattr(values, name) for name in (*_TOLD, *_OWN)}
    place = {"vehicle_id": vehicle_id, "revision": _next(before)}
    return told | place | {"content_sha256": content_sha256}


def get_scan_measurement(session: Session, measurement_id: int) -> ScanMeasurement:
    """One revision. Raises NotFound."""
    query = scan_revision_rows().where(scan_measurements.c.id == measurement_id)
    row = session.execute(query).mappings().one_or_none()
    if row is None:
        raise missing("measurement of a scanned vehicle", measurement_id)
    return scan_measurement_of_row(row)


def scan_measurement_history(
    session: Session, vehicle_id: int, *, profile: bool = False
) -> tuple[ScanMeasurement, ...]:
    """Every revision of a vehicle, oldest first, without profiles unless asked for."""
    query = scan_revision_rows(profile=profile).where(scan_measurements.c.vehicle_id == vehicle_id)
    rows = session.execute(query.order_by(scan_measurements.c.revision)).mappings()
    return tuple(scan_measurement_of_row(row) for row in rows)


def is_newest_scan_measurement(session: Session, measurement: ScanMeasurement) -> bool:
    """Whether no later revision of the same vehicle is there."""
    newest = select(func.max(scan_measurements.c.revision)).where(
        scan_measurements.c.vehicle_id == measurement.vehicle_id
    )
    return bool(session.execute(newest).scalar_one() == measurement.revision)


def _history(session: Session, vehicle_ids: Sequence[int]) -> dict[int, list[ScanMeasurement]]:
    """The revisions of those vehicles that have any, by vehicle, oldest first, without profiles."""
    query = scan_revision_rows(profile=False).where(scan_measurements.c.vehicle_id.in_(vehicle_ids))
    rows = session.execute(query.order_by(scan_measurements.c.revision)).mappings()
    found: dict[int, list[ScanMeasurement]] = {}
    for one in map(scan_measurement_of_row, rows):
        found.setdefault(one.vehicle_id, []).append(one)
    return found


def _verdict_that_stood(history: Sequence[ScanMeasurement], values: ScanValues) -> int | None:
    """Of a motion that is put back; never the verdict of who placed what stands in it now."""

    def same(measurement: ScanMeasurement) -> bool:
        reviewer = measurement.review.reviewer
        by_placer = reviewer is not None and reviewer.id == values.placed_by
        return not by_placer and same_motion(measurement.values, values)

    return judged_alike(reversed(history), same, lambda one: one.judged_id)


def _check(values: ScanValues) -> None:
    for camera, front, rear in (
        (1, values.front_line_1, values.rear_line_1),
        (2, values.front_line_2, values.rear_line_2),
    ):
        if not front < rear:
            raise BadInput("scans-front-after-rear", camera=camera, front=front, rear=rear)
    if values.status != "ok" and not values.reason:
        raise BadInput("scans-speed-no-reason")
