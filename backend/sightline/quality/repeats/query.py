"""Repeats: what was clicked again, what it repeats, and what somebody could click again."""

from dataclasses import dataclass

from sqlalchemy import ColumnElement, exists, or_, select
from sqlalchemy.orm import Session

from sightline.enums import Target
from sightline.measurements.query import fetch_measurements, is_current, is_first, measurement_revision_rows
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


def repeats_of_measurement(session: Session, series_id: int) -> tuple[Measurement, ...]:
    """The repeats of one measurement that stand, oldest first."""
    query = measurement_revision_rows().where(
        measurement_series.c.repeat_of == series_id, is_current, ~measurements.c.withdrawn
    )
    return fetch_measurements(session, query.order_by(measurements.c.series_id))


def measurements_to_click_again(
    session: Session, survey_id: int, *, person_id: int, only_own: bool
) -> tuple[tuple[Blind, ...], tuple[Blind, ...]]:
    """The standing measurements of a survey: (those that the person never repeated, those that they did)."""
    mine = exists().where(
        _again.c.repeat_of == measurements.c.series_id,
        _of_again.c.series_id == _again.c.id,
        _of_again.c.created_by == person_id,
    )
    query = (
        select(
            measurements.c.series_id.label("measurement_id"),
            vehicles.c.id.label("vehicle_id"),
            vehicles.c.number.label("vehicle_number"),
            measurement_series.c.recording_id,
            measurements.c.frame,
            measurements.c.target,
            mine.label("repeated"),
        )
        .join(measurement_series, measurement_series.c.id == measurements.c.series_id)
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(is_current, ~measurements.c.withdrawn, is_first, measurements.c.status == "ok")
        .order_by(measurements.c.series_id)
    )
    if only_own:
        query = query.where(measurements.c.created_by == person_id)
    fresh: list[Blind] = []
    known: list[Blind] = []
    for row in session.execute(query).mappings():
        of = known if row["repeated"] else fresh
        of.append(Blind(**{name: row[name] for name in Blind.__slots__}))
    return tuple(fresh), tuple(known)


def _repeated(session: Session, condition: ColumnElement[bool]) -> tuple[Measurement, ...]:
    repeats_it = exists().where(_again.c.repeat_of == measurement_series.c.id)
    query = (
        measurement_revision_rows()
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(condition, vehicles.c.deleted_at.is_(None))
        .where(or_(measurement_series.c.repeat_of.is_not(None), repeats_it))
    )
    return fetch_measurements(session, query.order_by(measurements.c.series_id, measurements.c.revision))
