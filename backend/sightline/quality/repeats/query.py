"""Repeats: what was clicked again, what it repeats, and what somebody could click again."""

from collections.abc import Sequence
from dataclasses import dataclass

from sqlalchemy import ColumnElement, select, union
from sqlalchemy.orm import Session

from sightline.enums import Target
from sightline.measurements.query import (
    fetch_measurements,
    is_current,
    is_first,
    measurement_revision_rows,
    operator_id,
)
from sightline.measurements.records import Measurement
from sightline.measurements.tables import measurement_series, measurements
from sightline.vehicles.tables import vehicles

_again = measurement_series.alias("again")
_of_again = measurements.alias("of_again")


@dataclass(frozen=True, slots=True)
class Blind:
    """What somebody who clicks again may know of a measurement: neither its points nor its height."""

    measurement_id: int
    vehicle_id: int
    vehicle_number: int
    recording_id: int
    frame: int
    target: Target


def repeats_of_survey(session: Session, survey_id: int) -> tuple[Measurement, ...]:
    """Every revision of the repeats of a survey and of what they repeat, by series; no deleted vehicles."""
    return _repeated(session, measurement_series.c.survey_id == survey_id)


def measurements_with_proposals(session: Session, survey_id: int) -> tuple[Measurement, ...]:
    """The standing heights of a survey of which the points were proposed on their frame, shown or not."""
    query = (
        measurement_revision_rows()
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(is_current, ~measurements.c.withdrawn, is_first, measurements.c.proposal.is_not(None))
    )
    return fetch_measurements(session, query.order_by(measurements.c.series_id))


def repeats_of_measurement(session: Session, series_id: int) -> tuple[Measurement, ...]:
    """The repeats of one measurement that stand, oldest first."""
    query = measurement_revision_rows().where(
        measurement_series.c.repeat_of == series_id, is_current, ~measurements.c.withdrawn
    )
    return fetch_measurements(session, query.order_by(measurements.c.series_id))


def measurements_to_click_again(
    session: Session, survey_id: int, *, person_id: int, only_own: bool
) -> tuple[list[int], list[int]]:
    """The standing measurements of a survey by number: (never repeated by the person, those that were)."""
    query = (
        select(measurements.c.series_id)
        .join(measurement_series, measurement_series.c.id == measurements.c.series_id)
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(is_current, ~measurements.c.withdrawn, is_first, measurements.c.status == "ok")
        .order_by(measurements.c.series_id)
    )
    if only_own:
        query = query.where(operator_id == person_id)
    mine = _repeated_by(session, survey_id, person_id)
    found = session.execute(query).scalars().all()
    return [one for one in found if one not in mine], [one for one in found if one in mine]


def list_blind(session: Session, series_ids: Sequence[int]) -> tuple[Blind, ...]:
    """What may be told of these measurements, in their order."""
    query = (
        select(
            measurements.c.series_id.label("measurement_id"),
            vehicles.c.id.label("vehicle_id"),
            vehicles.c.number.label("vehicle_number"),
            measurement_series.c.recording_id,
            measurements.c.frame,
            measurements.c.target,
        )
        .join(measurement_series, measurement_series.c.id == measurements.c.series_id)
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(measurements.c.series_id.in_(series_ids), is_current)
    )
    found = {row["measurement_id"]: Blind(**row) for row in session.execute(query).mappings()}
    return tuple(found[one] for one in series_ids)


def _repeated_by(session: Session, survey_id: int, person_id: int) -> set[int]:
    """The measurements of a survey that a person clicked again, by number."""
    query = (
        select(_again.c.repeat_of)
        .join(_of_again, _of_again.c.series_id == _again.c.id)
        .where(_again.c.survey_id == survey_id, _again.c.repeat_of.is_not(None))
        .where(_of_again.c.created_by == person_id)
    )
    return set(session.execute(query).scalars())


def _repeated(session: Session, condition: ColumnElement[bool]) -> tuple[Measurement, ...]:
    # asked once: of each series, whether it is repeated would be a look at all of them
    known = _again.c.repeat_of.is_not(None)
    concerned = union(select(_again.c.repeat_of).where(known), select(_again.c.id).where(known))
    query = (
        measurement_revision_rows()
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(condition, vehicles.c.deleted_at.is_(None))
        .where(measurement_series.c.id.in_(concerned))
    )
    return fetch_measurements(session, query.order_by(measurements.c.series_id, measurements.c.revision))
