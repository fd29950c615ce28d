"""Calibrations of cameras: written once, never changed, their content's hash kept in the audit event."""

from collections.abc import Iterable, Sequence
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.records import Calibration
from sightline.cameras.calibrations.tables import calibration_images, calibrations
from sightline.cameras.records import CalibrationSummary
from sightline.cameras.tables import cameras
from sightline.enums import CalibrationSource, JsonObject
from sightline.infra.audit import trail
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, change_row, get_row, missing, stored_hash, who
from sightline.infra.database.types import columns_of, now
from sightline.messages.said import Said


def add_calibration(
    session: Session,
    camera_id: int,
    *,
    source: CalibrationSource,
    document: JsonObject,
    trusted: bool,
    warnings: Sequence[Said],
    coverage: Sequence[Sequence[int]],
    views: Sequence[JsonObject],
    summary: Said,
    recording_id: int | None = None,
    make_current: bool = True,
    actor: int | None,
) -> Calibration:
    """Store a calibration and (by default) make it the camera's current one. Raises NotFound."""
    camera = get_row(session, cameras, camera_id, "camera")
    content: dict[str, Any] = {
        "camera_id": camera_id,
        "source": source,
        "recording_id": recording_id,
        "document": document,
        "trusted": trusted,
        "warnings": list(warnings),
        "coverage": [list(map(int, row)) for row in coverage],
        "views": list(views),
        "summary": summary,
        "created_at": now(),
        "created_by": actor,
    }
    calibration_id = add_row(session, calibrations, content)
    if make_current:
        change_row(session, cameras, camera_id, {"current_calibration_id": calibration_id})
    digest = stored_hash(session, calibrations, calibration_id)
    told = {key: content[key] for key in ("camera_id", "source", "recording_id", "trusted", "summary")}
    after = {
        **told,
        "current": make_current,
        "images": _images(session, views),
        "content_sha256": digest,
    }
    trail.record(session, actor, "create", "calibration", calibration_id, camera["survey_id"], None, after)
    return get_calibration(session, calibration_id)


def _images(session: Session, views: Sequence[JsonObject]) -> dict[str, str]:
    """The stored file of each image that was looked at, by the image's number; its name holds its hash."""
    ids = [view["image_id"] for view in views if view.get("image_id") is not None]
    i = calibration_images.c
    found = session.execute(select(i.id, i.media_key).where(i.id.in_(ids)).order_by(i.id)) if ids else ()
    return {str(row.id): row.media_key for row in found}


def get_calibration(session: Session, calibration_id: int) -> Calibration:
    """One calibration, whole. Raises NotFound."""
    query = select(calibrations, people.c.name.label("maker")).outerjoin(
        people, people.c.id == calibrations.c.created_by
    )
    row = session.execute(query.where(calibrations.c.id == calibration_id)).one_or_none()
    if row is None:
        raise missing("calibration", calibration_id)
    values = {column.name: getattr(row, column.name) for column in columns_of(calibrations, "created_by")}
    return Calibration(created_by=who(row.created_by, row.maker), **values)


def list_calibrations(session: Session, survey_id: int) -> tuple[Calibration, ...]:
    """Every calibration of a survey's cameras, whole, for the export."""
    query = (
        select(calibrations, people.c.name.label("maker"))
        .join(cameras, cameras.c.id == calibrations.c.camera_id)
        .outerjoin(people, people.c.id == calibrations.c.created_by)
        .where(cameras.c.survey_id == survey_id)
        .order_by(calibrations.c.id)
    )
    named = [column.name for column in columns_of(calibrations, "created_by")]
    return tuple(
        Calibration(created_by=who(row.created_by, row.maker), **{name: getattr(row, name) for name in named})
        for row in session.execute(query)
    )


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
    chosen = columns_of(calibrations, "document", "warnings", "coverage", "views", "recording_id")
    query = (
        select(*chosen, people.c.name.label("maker"))
        .outerjoin(people, people.c.id == calibrations.c.created_by)
        .where(calibrations.c.camera_id.in_(camera_ids))
        .order_by(calibrations.c.id)
    )
    return tuple(
        CalibrationSummary(
            id=row.id,
            camera_id=row.camera_id,
            created_at=row.created_at,
            created_by=who(row.created_by, row.maker),
            source=row.source,
            trusted=row.trusted,
            summary=row.summary,
        )
        for row in session.execute(query)
    )
