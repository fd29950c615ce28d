"""Sheets of vehicles: the facts of a record with its standing measurements. The state is never stored."""

from collections.abc import Iterable
from typing import Any

from sqlalchemy import ColumnElement, func, select
from sqlalchemy.orm import Session

from sightline.infra.database.rows import the_one
from sightline.measurements.query import measurements_of_vehicles
from sightline.measurements.records import Measurement, VehicleSheet
from sightline.measurements.sheets.states import state_of
from sightline.measurements.tables import measurement_series, measurements, wheel_pairs
from sightline.vehicles.records import NOT_VISIBLE
from sightline.vehicles.store import facts_of_row, headways_needed, vehicle_rows
from sightline.vehicles.tables import vehicles


def get_sheet(session: Session, vehicle_id: int) -> VehicleSheet:
    """One vehicle with its measurements; two queries. Raises NotFound."""
    found = _fetch(session, [vehicles.c.id == vehicle_id], [measurement_series.c.vehicle_id == vehicle_id])
    return the_one(found, "vehicle", vehicle_id)


def list_sheets(
    session: Session, survey_id: int, *, recording_id: int | None = None
) -> tuple[VehicleSheet, ...]:
    """The vehicles of a survey or of one recording by number, with measurements; two queries."""
    where = [vehicles.c.survey_id == survey_id]
    of_these = [measurement_series.c.survey_id == survey_id]
    if recording_id is not None:
        where.append(vehicles.c.recording_id == recording_id)
        of_these.append(measurement_series.c.recording_id == recording_id)
    return _fetch(session, where, of_these)


def list_sheets_by_id(session: Session, ids: Iterable[int]) -> tuple[VehicleSheet, ...]:
    """Those of these vehicles that were not deleted, by number, with measurements; two queries."""
    chosen = sorted(set(ids))
    of_these = [measurement_series.c.vehicle_id.in_(chosen)]
    return _fetch(session, [vehicles.c.id.in_(chosen)], of_these)


def frames_used_of_vehicle(session: Session, vehicle_id: int) -> tuple[tuple[int, ...], ...]:
    """The frames of each measurement of a vehicle as it is now, withdrawn ones and repeats too."""
    newest = (
        select(measurements.c.series_id, func.max(measurements.c.revision).label("revision"))
        .join(measurement_series, measurement_series.c.id == measurements.c.series_id)
        .where(measurement_series.c.vehicle_id == vehicle_id)
        .group_by(measurements.c.series_id)
        .subquery()
    )
    query = select(measurements.c.frame, measurements.c.more_frames).join(
        newest,
        (newest.c.series_id == measurements.c.series_id) & (newest.c.revision == measurements.c.revision),
    )
    clicked = [(frame, *(int(one["frame"]) for one in more or ())) for frame, more in session.execute(query)]
    pairs = select(wheel_pairs.c.frame).where(wheel_pairs.c.vehicle_id == vehicle_id)
    return (*clicked, *((int(frame),) for frame in session.execute(pairs).scalars()))


def _fetch(
    session: Session, where: Iterable[ColumnElement[bool]], of_these: Iterable[ColumnElement[bool]]
) -> tuple[VehicleSheet, ...]:
    rows = session.execute(vehicle_rows(*where)).mappings().all()
    found = measurements_of_vehicles(session, of_these) if rows else {}
    headway_s = headways_needed(session, rows)
    return tuple(_sheet(facts_of_row(row, headway_s), tuple(found.get(row["id"], ()))) for row in rows)


def _sheet(facts: dict[str, Any], measured: tuple[Measurement, ...]) -> VehicleSheet:
    unseen = [target for target, name in NOT_VISIBLE.items() if facts[name] is not None]
    state = state_of(
        [(one.values.target, one.values.status, one.review.verdict) for one in measured],
        facts["asked"],
        unseen,
        discarded=facts["discarded"] is not None,
        wanted=facts["in_sample"] or facts["check_target"],
    )
    return VehicleSheet(**facts, state=state, measurements=measured)
