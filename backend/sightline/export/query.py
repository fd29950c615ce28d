"""Reading a survey for its export: page by page, so that memory does not grow with the survey."""

from collections.abc import Iterator
from typing import Any

from sqlalchemy import Select, Text, func, select, type_coerce
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.tables import calibrations
from sightline.cameras.tables import cameras
from sightline.enums import JsonObject
from sightline.infra.audit.hashing import event_hash, to_plain_json
from sightline.infra.audit.records import survey_chain
from sightline.infra.audit.tables import audit_events
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import row_content
from sightline.measurements.csv import OfVehicle
from sightline.measurements.derived_query import add_filming_and_drift
from sightline.measurements.query import (
    is_first,
    measurement_of_row,
    measurement_revision_rows,
    reviews_of_series,
)
from sightline.measurements.records import Measurement, Review, VehicleSheet
from sightline.measurements.sheets.query import list_sheets_by_id
from sightline.measurements.tables import measurement_series, measurements
from sightline.measurements.tables import reviews as review_rows
from sightline.poses.tables import road_poses
from sightline.recordings.tables import recordings
from sightline.vehicles.records import KNOWN
from sightline.vehicles.tables import vehicles as vehicle_rows

PAGE = 1000


def count_measurements(session: Session, survey_id: int) -> int:
    """How many measurements and repeats a survey has, those of deleted vehicles too."""
    query = select(func.count()).where(measurement_series.c.survey_id == survey_id)
    return int(session.execute(query).scalar_one())


def most_frames(session: Session, survey_id: int) -> int:
    """On how many frames the points of a measurement were clicked at most."""
    query = (
        select(measurements.c.more_frames)
        .join(measurement_series, measurement_series.c.id == measurements.c.series_id)
        .where(measurement_series.c.survey_id == survey_id, is_first)
        .where(type_coerce(measurements.c.more_frames, Text) != "[]")
        .execution_options(yield_per=PAGE)
    )
    return 1 + max((len(more) for more in session.execute(query).scalars()), default=0)


def revision_pages(session: Session, survey_id: int) -> Iterator[list[tuple[Measurement, OfVehicle]]]:
    """Every revision of every measurement and repeat of vehicles that were not deleted, in the order of
    (measurement, revision); all revisions of one measurement come in one page.
    """
    v = vehicle_rows.c
    chosen: Select[Any] = (
        measurement_revision_rows()
        .add_columns(v.number, v.category, v.model_chosen_by, v.check_target)
        .add_columns(func.coalesce(v.lighting, recordings.c.lighting).label("lighting"))
        .add_columns(*(v[names.height] for names in KNOWN.values()))
        .join(vehicle_rows, v.id == measurement_series.c.vehicle_id)
        .join(recordings, recordings.c.id == v.recording_id)
        .where(measurement_series.c.survey_id == survey_id, v.deleted_at.is_(None))
        .order_by(measurements.c.series_id, measurements.c.revision)
    )
    of_survey = select(measurement_series.c.id).where(measurement_series.c.survey_id == survey_id)
    for ids in _ids(session, of_survey, measurement_series.c.id):
        rows = session.execute(chosen.where(measurement_series.c.id.between(ids[0], ids[-1]))).all()
        revisions = tuple([measurement_of_row(row) for row in rows])
        cars = [
            record_of(
                OfVehicle,
                row._mapping,
                known_m={target: getattr(row, names.height) for target, names in KNOWN.items()},
            )
            for row in rows
        ]
        yield list(zip(add_filming_and_drift(session, revisions), cars, strict=True))


def vehicle_pages(session: Session, survey_id: int) -> Iterator[list[VehicleSheet]]:
    """The vehicles that were not deleted, with their measurements, in the order of ids."""
    of_survey = select(vehicle_rows.c.id).where(vehicle_rows.c.survey_id == survey_id)
    for ids in _ids(session, of_survey, vehicle_rows.c.id):
        yield sorted(list_sheets_by_id(session, ids), key=lambda one: one.id)


def review_pages(session: Session, survey_id: int) -> Iterator[tuple[Review, ...]]:
    """The reviews of a survey's measurements, oldest first; those of deleted vehicles are left out."""
    of_survey = (
        select(review_rows.c.id)
        .join(measurement_series, measurement_series.c.id == review_rows.c.series_id)
        .join(vehicle_rows, vehicle_rows.c.id == measurement_series.c.vehicle_id)
        .where(measurement_series.c.survey_id == survey_id, vehicle_rows.c.deleted_at.is_(None))
    )
    for ids in _ids(session, of_survey, review_rows.c.id):
        yield reviews_of_series(session, review_rows.c.id.in_(ids))


def audit_pages(session: Session, survey_id: int, after: int = 0) -> Iterator[list[dict[str, Any]]]:
    """A survey's chain from its first event on, or from the one after `after`, oldest first: rows as they
    were hashed, with the hash of their content.
    """
    at = after + 1
    names = [column.name for column in audit_events.c]
    query = (
        select(audit_events)
        .where(audit_events.c.chain == survey_chain(survey_id))
        .order_by(audit_events.c.number)
        .limit(PAGE)
    )
    while rows := session.execute(query.where(audit_events.c.number >= at)).mappings().all():
        yield [{**row, "content_sha256": event_hash({name: row[name] for name in names})} for row in rows]
        at = int(rows[-1]["number"]) + 1


def pose_contents(session: Session, survey_id: int) -> dict[int, JsonObject]:
    """The whole content of each pose by id, as it was hashed for the audit chain."""
    query = select(road_poses).where(road_poses.c.survey_id == survey_id).order_by(road_poses.c.id)
    return {row["id"]: to_plain_json(row_content(row)) for row in session.execute(query).mappings()}


def calibration_contents(session: Session, survey_id: int) -> dict[int, JsonObject]:
    """The whole content of each calibration by id, as it was hashed for the audit chain."""
    query = (
        select(calibrations)
        .join(cameras, cameras.c.id == calibrations.c.camera_id)
        .where(cameras.c.survey_id == survey_id)
        .order_by(calibrations.c.id)
    )
    return {row["id"]: to_plain_json(row_content(row)) for row in session.execute(query).mappings()}


def _ids(session: Session, query: Select[Any], column: Any) -> Iterator[list[int]]:
    """Ids in ascending order, a page at a time."""
    last = 0
    while found := list(session.execute(query.where(column > last).order_by(column).limit(PAGE)).scalars()):
        yield found
        last = found[-1]
