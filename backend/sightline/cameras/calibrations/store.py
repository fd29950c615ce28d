"""Calibrations of cameras: written once, never changed, their content's hash kept in the audit event."""

from collections.abc import Iterable, Sequence
from typing import Unpack

from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.records import Calibration, NewCalibration
from sightline.cameras.calibrations.tables import calibration_images, calibrations
from sightline.cameras.records import CalibrationSummary
from sightline.cameras.tables import cameras
from sightline.enums import JsonObject
from sightline.errors import Conflict
from sightline.infra.audit.written import written_once, written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import change_row, get_row, the_one


def add_calibration(
    session: Session, camera_id: int, *, actor: int | None, **values: Unpack[NewCalibration]
) -> Calibration:
    """Store a calibration and make it the camera's current one. Raises NotFound, Conflict."""
    camera = get_row(session, cameras, camera_id, "camera")
    calibration_id = written_once(
        session,
        calibrations,
        {"camera_id": camera_id, "recording_id": None, **values},
        "create",
        survey_id=camera["survey_id"],
        also={"current": True, "images": _images(session, values["views"])},
        untold=("document", "warnings", "coverage", "views"),
        actor=actor,
    )
    change_row(session, cameras, camera_id, {"current_calibration_id": calibration_id})
    return get_calibration(session, calibration_id)


def _images(session: Session, views: Sequence[JsonObject]) -> dict[str, str]:
    """The stored file of each image that was looked at, by the image's number; its name holds its hash.

    Raises Conflict where one was taken out meanwhile.
    """
    ids = [view["image_id"] for view in views if view.get("image_id") is not None]
    i = calibration_images.c
    found = session.execute(select(i.id, i.media_key).where(i.id.in_(ids)).order_by(i.id)) if ids else ()
    keys = {str(row.id): row.media_key for row in found}
    if len(keys) < len(ids):
        raise Conflict("cameras-image-gone-meanwhile")
    return keys


def get_calibration(session: Session, calibration_id: int) -> Calibration:
    """One calibration, whole. Raises NotFound."""
    return the_one(
        _fetch_calibrations(session, calibrations.c.id == calibration_id), "calibration", calibration_id
    )


def list_calibrations(session: Session, survey_id: int) -> tuple[Calibration, ...]:
    """Every calibration of a survey's cameras, whole, for the export."""
    of_survey = select(cameras.c.id).where(cameras.c.survey_id == survey_id)
    return _fetch_calibrations(session, calibrations.c.camera_id.in_(of_survey))


def _fetch_calibrations(session: Session, condition: ColumnElement[bool]) -> tuple[Calibration, ...]:
    return tuple(record_of(Calibration, row) for row in written_rows(session, calibrations, condition))


def documents_in_force(session: Session, camera_ids: Iterable[int | None]) -> dict[int | None, JsonObject]:
    """The document of the current calibration of those cameras that have one."""
    ids = sorted({one for one in camera_ids if one is not None})
    query = (
        select(cameras.c.id, calibrations.c.document)
        .join(calibrations, calibrations.c.id == cameras.c.current_calibration_id)
        .where(cameras.c.id.in_(ids))
    )
    return {row.id: row.document for row in session.execute(query)} if ids else {}


def summaries(session: Session, camera_ids: Sequence[int]) -> tuple[CalibrationSummary, ...]:
    """The calibrations of some cameras in short, oldest first."""
    of_cameras = calibrations.c.camera_id.in_(camera_ids)
    rows = written_rows(session, calibrations, of_cameras, without=("document", "coverage", "views"))
    return tuple(record_of(CalibrationSummary, row) for row in rows)
