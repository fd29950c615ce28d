"""Heights of scanned vehicles: one measurement a vehicle's target; a withdrawn one is a revision too."""

from collections.abc import Collection
from typing import Any

from sqlalchemy import ColumnElement, Select, and_, select
from sqlalchemy.orm import Session

from sightline.enums import Target
from sightline.errors import BadInput, Conflict
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.database.rows import add_row, missing
from sightline.measurements.again.query import Made, made_among
from sightline.measurements.query import (
    OF_LINES,
    is_current,
    is_own,
    scan_height_of_row,
    scan_height_rows,
    with_verdict,
)
from sightline.measurements.records import ScanHeight, ScanHeightValues
from sightline.measurements.store import append_revision, require_seen, verdict_that_stood
from sightline.measurements.tables import measurement_series, measurements, reviews
from sightline.scans.tables import scan_vehicles, scans
from sightline.scans.vehicles.store import require_scan_vehicle_version

_s, _m = measurement_series.c, measurements.c
_alive: ColumnElement[bool] = and_(scan_vehicles.c.deleted_at.is_(None), scans.c.deleted_at.is_(None))
#: Of a height that counts: the newest of its vehicle and target, not withdrawn, all of it still there.
stands: ColumnElement[bool] = and_(is_current, ~_m.withdrawn, _alive)


def append_scan_height(
    session: Session, vehicle_id: int, values: ScanHeightValues, *, seen_revision: int, actor: int | None
) -> ScanHeight:
    """The next revision of a target's height; `seen_revision`: 0 where none was there.

    Raises NotFound, Conflict if it was measured meanwhile or the vehicle was deleted, BadInput.
    """
    if values.status != "ok" and not values.reason:
        raise BadInput("scans-height-no-reason")
    before = current(session, vehicle_id, values.target)
    return _append(session, vehicle_id, values, before, seen_revision, actor)


def withdraw_scan_height(
    session: Session, vehicle_id: int, target: Target, *, seen_revision: int, actor: int | None
) -> ScanHeight:
    """Take a height back: a revision that says so. Raises NotFound, Conflict (changed or withdrawn)."""
    before = current(session, vehicle_id, target)
    if before is None:
        raise missing("height of this target")
    if before.withdrawn:
        raise Conflict("scans-height-withdrawn")
    return _append(session, vehicle_id, before.values, before, seen_revision, actor, withdrawn=True)


def current(session: Session, vehicle_id: int, target: Target) -> ScanHeight | None:
    """The newest revision of one target, withdrawn or not; None where it was never measured."""
    found = _fetch_heights(session, _s.scan_vehicle_id == vehicle_id, _m.target == target, is_current)
    return found[0] if found else None


def scan_heights_of(session: Session, height_ids: Collection[int]) -> tuple[ScanHeight, ...]:
    """The newest revision of each of these; of frames none."""
    return _fetch_heights(session, _s.id.in_(height_ids), is_current)


def require_scan_height_revision(session: Session, height_id: int, revision: int) -> ScanHeight:
    """The newest revision, if it is the one that the caller saw. Raises NotFound, Conflict."""
    (current,) = scan_heights_of(session, (height_id,))
    require_scan_vehicle_version(session, current.vehicle_id, None)
    require_seen(current, revision)
    return current


def is_of_line_scan(session: Session, height_id: int) -> bool:
    """Whether a height is of a line scan: then it is read here, else with the measurements of frames."""
    query = select(_s.id).where(_s.id == height_id, _s.scan_id.is_not(None))
    return session.execute(query).first() is not None


def revisions_of_own_clicks(
    session: Session, revision_ids: Collection[int], person_id: int
) -> frozenset[int]:
    """Of these revisions, those of which this person clicked or gave anything."""
    query = select(_m.id).where(_m.id.in_(revision_ids), is_own(person_id))
    return frozenset(session.execute(query).scalars())


def scan_height_states(*conditions: ColumnElement[bool]) -> Select[Any]:
    """(scan, verdict) of each standing height of living vehicles: what counts are made of."""
    return (
        with_verdict(_s.scan_id, reviews.c.verdict)
        .join(scan_vehicles, scan_vehicles.c.id == _s.scan_vehicle_id)
        .join(scans, scans.c.id == _s.scan_id)
        .where(stands, *conditions)
    )


def list_scan_heights(session: Session, scan_id: int) -> tuple[ScanHeight, ...]:
    """The newest revision of every target of a scan's living vehicles, withdrawn or not."""
    return _fetch_heights(session, _s.scan_id == scan_id, is_current, _alive)


def standing_scan_heights(session: Session, survey_id: int) -> tuple[ScanHeight, ...]:
    """The standing heights of a survey's living vehicles, in the order of their making."""
    return _fetch_heights(session, _s.survey_id == survey_id, stands)


def scan_heights_made_by(session: Session, computing_id: int) -> list[Made]:
    """The heights that a computing made, of vehicles that are still there."""
    made = select(_m.series_id).where(_m.computing_id == computing_id)
    return made_among(_fetch_heights(session, _s.id.in_(made), _alive), computing_id)


def scan_height_revisions(session: Session, height_id: int) -> tuple[ScanHeight, ...]:
    """Every revision of a height, oldest first."""
    return _fetch_heights(session, _s.id == height_id)


def scan_height_history(session: Session, vehicle_id: int) -> tuple[ScanHeight, ...]:
    """Every revision of a vehicle's heights, oldest first."""
    return _fetch_heights(session, _s.scan_vehicle_id == vehicle_id)


def scan_height_history_of_scan(session: Session, scan_id: int) -> dict[int, list[ScanHeight]]:
    """The same for every vehicle of a scan that has heights, by vehicle; one query."""
    found: dict[int, list[ScanHeight]] = {}
    for one in _fetch_heights(session, _s.scan_id == scan_id):
        found.setdefault(one.vehicle_id, []).append(one)
    return found


def _append(
    session: Session,
    vehicle_id: int,
    values: ScanHeightValues,
    before: ScanHeight | None,
    seen_revision: int,
    actor: int | None,
    *,
    withdrawn: bool = False,
) -> ScanHeight:
    vehicle = require_scan_vehicle_version(session, vehicle_id, None)
    revision = before.revision if before else 0
    if revision != seen_revision:
        name = name_or_somebody(before.created_by if before else None)
        raise Conflict("scans-target-measured-meanwhile", name=name)
    if before is None:
        place = {"survey_id": vehicle["survey_id"], "scan_id": vehicle["scan_id"]}
        key = f"scan {vehicle_id} {values.target}"
        series_id = add_row(
            session, measurement_series, {**place, "scan_vehicle_id": vehicle_id, "client_key": key}
        )
    else:
        series_id = before.id
    return append_revision(
        session,
        series_id,
        revision + 1,
        values,
        withdrawn=withdrawn,
        before=before,
        action="withdraw" if withdrawn else "create" if before is None else "revise",
        actor=actor,
        verdict_of_revision=None
        if before is None or withdrawn
        else verdict_that_stood(session, OF_LINES, series_id, values),
        made_of=lambda row: _fetch_heights(session, _m.id == row.id)[0],
    )


def _fetch_heights(session: Session, *conditions: ColumnElement[bool]) -> tuple[ScanHeight, ...]:
    """By the order of their making, with their vehicle's class."""
    query = (
        scan_height_rows(scan_vehicles.c.category)
        .join(scan_vehicles, scan_vehicles.c.id == _s.scan_vehicle_id)
        .join(scans, scans.c.id == _s.scan_id)
        .where(*conditions)
        .order_by(_m.id)
    )
    return tuple(scan_height_of_row(row) for row in session.execute(query))
