"""Vehicles of a scan. Their state follows from their measurements and is never stored."""

from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from functools import cache
from typing import Any

from sqlalchemy import ColumnElement, func, select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject, ScanDirection, VehicleOrigin
from sightline.errors import BadInput, Conflict
from sightline.infra.audit.changing import alter_row, bring_back_row, change_since, make_rows, take_out_row
from sightline.infra.database.rows import get_row, last_change, the_one
from sightline.infra.database.types import document_text
from sightline.scans.query import is_current, scan_vehicle_of_row, scan_vehicle_rows, scan_vehicle_states
from sightline.scans.records import Changes, KnownOfScanned, ScanCounts, ScanVehicle, state_of
from sightline.scans.tables import scan_measurements, scan_vehicles, scans

_ALIVE: ColumnElement[bool] = scan_vehicles.c.deleted_at.is_(None)
_PASSED_BESIDE = 200  # at most beside one that stands
_FIELDS = frozenset(one.name for one in fields(KnownOfScanned))
_LENGTHS = ("true_length_m", "u_true_length_m", "true_wheelbase_m", "u_true_wheelbase_m")
RigFor = Callable[[str | None, ScanDirection], JsonObject]


def create_scan_vehicle(
    session: Session, scan_id: int, *, origin: VehicleOrigin = "person", actor: int | None
) -> ScanVehicle:
    """A vehicle of a scan, yet without a measurement. Numbers count up in the scan."""
    (made,) = create_scan_vehicles(session, scan_id, 1, origin=origin, actor=actor)
    return get_scan_vehicle(session, made)


def create_scan_vehicles(
    session: Session, scan_id: int, count: int, *, origin: VehicleOrigin, actor: int | None
) -> list[int]:
    """The ids of so many vehicles, alike but for their numbers, with an event each; a few statements."""
    scan = get_row(session, scans, scan_id, "line-scan recording", scans.c.deleted_at.is_(None))
    content: dict[str, Any] = {**dict.fromkeys(_FIELDS), "notes": ""}
    counted = select(func.coalesce(func.max(scan_vehicles.c.number), 0))
    first = session.execute(counted.where(scan_vehicles.c.scan_id == scan_id)).scalar_one() + 1
    place = {"survey_id": scan["survey_id"], "scan_id": scan_id, "origin": origin}
    told = [{**place, "number": number, **content} for number in range(first, first + count)]
    return make_rows(session, scan_vehicles, told, survey_id=scan["survey_id"], actor=actor)


def get_scan_vehicle(session: Session, vehicle_id: int, *, deleted: bool = False) -> ScanVehicle:
    """One vehicle with its current measurement, profile and all. Raises NotFound (also with its scan)."""
    found = _fetch(session, scan_vehicles.c.id == vehicle_id, deleted=deleted, profile=True)
    return the_one(found, "scanned vehicle", vehicle_id)


def list_scan_vehicles(session: Session, scan_id: int, *, deleted: bool = False) -> tuple[ScanVehicle, ...]:
    """The vehicles of a scan in the order in which they passed; one query."""
    return _fetch(session, scan_vehicles.c.scan_id == scan_id, deleted=deleted)


def last_scan_vehicles(session: Session, scan_id: int, count: int) -> tuple[ScanVehicle, ...]:
    """A scan's last vehicles, in the order of passing; before them who stood until one of them came."""
    of_scan = scan_vehicles.c.scan_id == scan_id
    newest = select(func.max(scan_vehicles.c.number)).where(of_scan).scalar_subquery()
    late = scan_vehicles.c.number > newest - count
    late_vehicles = _fetch(session, of_scan & late)
    fronts = [one.measurement.values.front_line_1 for one in late_vehicles if one.measurement]
    if not fronts:
        return late_vehicles
    stood = is_current & (scan_measurements.c.rear_line_1 >= min(fronts))
    near = of_scan & (scan_vehicles.c.number > newest - count - _PASSED_BESIDE)
    standing = (
        select(scan_vehicles.c.id)
        .join(scan_measurements, scan_measurements.c.vehicle_id == scan_vehicles.c.id)
        .where(near, stood, ~late, _ALIVE)
        .limit(1)
    )
    if session.execute(standing).first() is None:
        return late_vehicles
    return _fetch(session, near & (late | stood))


def counts_of_scans(session: Session, rigs: Mapping[int, RigFor]) -> dict[int, ScanCounts]:
    """How many vehicles each scan has by state, and how many were measured with another rig than its own.

    `rigs`: what tells a scan's rig, as it is stored, for a lane and direction.
    """
    if not rigs:
        return {}
    counted: dict[int, dict[str, int]] = {}

    # As text: a stored document is compared as it stands, thousands of them at a time.
    @cache
    def own(scan_id: int, lane: str | None, way: ScanDirection) -> str:
        return document_text(rigs[scan_id](lane, way))

    for scan_id, status, verdict, rig, lane, way in session.execute(
        scan_vehicle_states(scan_vehicles.c.scan_id.in_(rigs))
    ):
        counts = counted.setdefault(scan_id, dict.fromkeys(ScanCounts.__slots__, 0))
        counts["vehicles"] += 1
        counts[state_of(status, verdict)] += 1
        counts["older"] += status is not None and rig != own(scan_id, lane, way)
    return {scan_id: replace(ScanCounts(), **counts) for scan_id, counts in counted.items()}


def scan_vehicles_placed_by_hand(session: Session, scan_id: int) -> frozenset[int]:
    """The vehicles whose boundaries a person placed; no search moves those, but boundaries that were found
    and brought back.
    """
    query = (
        select(scan_measurements.c.vehicle_id, scan_measurements.c.cause, scan_measurements.c.placed_by)
        .where(scan_measurements.c.scan_id == scan_id)
        .where(scan_measurements.c.cause.in_(("boundaries", "added", "back")))
        .order_by(scan_measurements.c.revision)
    )
    last = {vehicle_id: (cause, by) for vehicle_id, cause, by in session.execute(query)}
    return frozenset(id_ for id_, (cause, by) in last.items() if cause != "back" or by is not None)


def scan_vehicle_added_at(
    session: Session, scan_id: int, lines: tuple[float, float], actor: int
) -> int | None:
    """The living vehicle that a person added with just this front and rear at camera 1, if there is one."""
    query = (
        select(scan_vehicles.c.id)
        .join(scan_measurements, scan_measurements.c.vehicle_id == scan_vehicles.c.id)
        .where(scan_vehicles.c.scan_id == scan_id, _ALIVE, scan_measurements.c.cause == "added")
        .where(scan_measurements.c.placed_by == actor)
        .where(scan_measurements.c.front_line_1 == lines[0], scan_measurements.c.rear_line_1 == lines[1])
    )
    return session.execute(query).scalars().first()


def change_scan_vehicle(
    session: Session, vehicle_id: int, changes: Changes, *, version: int, actor: int | None
) -> ScanVehicle:
    """Fill in what is known of a vehicle. Raises Conflict if `version` is not the current one, BadInput."""
    before = require_scan_vehicle_version(session, vehicle_id, version)
    alter_row(session, scan_vehicles, before, _check_fields(changes), actor=actor)
    return get_scan_vehicle(session, vehicle_id)


def remove_scan_vehicle(
    session: Session, vehicle_id: int, *, version: int | None, actor: int | None
) -> ScanVehicle:
    """Take a vehicle out of all lists; `restore` brings it back. Found again, it stays away."""
    before = require_scan_vehicle_version(session, vehicle_id, version)
    take_out_row(session, scan_vehicles, before, actor=actor)
    return get_scan_vehicle(session, vehicle_id, deleted=True)


def restore_scan_vehicle(session: Session, vehicle_id: int, *, actor: int | None) -> ScanVehicle:
    """Bring a vehicle back. Raises Conflict for one that was not taken out."""
    before = get_row(session, scan_vehicles, vehicle_id, "scanned vehicle")
    if before["deleted_at"] is None:
        raise Conflict("scans-vehicle-not-deleted")
    bring_back_row(session, scan_vehicles, before, actor=actor)
    return get_scan_vehicle(session, vehicle_id, deleted=True)


def require_scan_vehicle_version(session: Session, vehicle_id: int, version: int | None) -> dict[str, Any]:
    """The row of a living vehicle, if it is the one that the caller saw (None: whichever it is).

    Raises NotFound, and Conflict that names who changed or deleted it and when.
    """
    row = get_row(session, scan_vehicles, vehicle_id, "scanned vehicle")
    get_row(session, scans, row["scan_id"], "line-scan recording", scans.c.deleted_at.is_(None))
    if row["deleted_at"] is not None:
        name, when = last_change(session, row)
        raise Conflict("scans-vehicle-deleted", name=name, number=row["number"], when=when)
    if by := change_since(session, row, version):
        raise Conflict("scans-vehicle-changed", name=by[0], when=by[1], number=row["number"])
    return row


def _check_fields(given: Mapping[str, Any]) -> dict[str, Any]:
    values = dict(given)
    unknown = set(values) - _FIELDS
    if unknown:
        raise BadInput("scans-vehicle-field-unknown", unknown=", ".join(sorted(unknown)))
    for name in _LENGTHS:
        value = values.get(name)
        least = 0.0 if name.startswith("u_") else 1e-3
        if value is not None and not least <= value <= 100:
            raise BadInput("scans-metres-range", name=name, value=format(value, "g"))
    if "run_of" in values:
        values["run_of"] = (values["run_of"] or "").strip() or None
    return values


def _fetch(
    session: Session, condition: ColumnElement[bool], *, deleted: bool = False, profile: bool = False
) -> tuple[ScanVehicle, ...]:
    query = (
        scan_vehicle_rows(profile=profile)
        .join(scans, scans.c.id == scan_vehicles.c.scan_id)
        .where(condition, scans.c.deleted_at.is_(None))
        .order_by(scan_vehicles.c.scan_id, scan_measurements.c.front_line_1, scan_vehicles.c.id)
    )
    if not deleted:
        query = query.where(_ALIVE)
    return tuple(scan_vehicle_of_row(row) for row in session.execute(query).mappings())
