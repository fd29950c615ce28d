"""Cameras of a survey with their calibration images; calibrations are in `calibrations`."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any, Unpack

from sqlalchemy import delete, func, select
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.records import CalibrationImage, Detection
from sightline.cameras.calibrations.store import summaries
from sightline.cameras.calibrations.tables import calibration_images, calibrations
from sightline.cameras.records import CalibrationSummary, Camera, CameraWords
from sightline.cameras.tables import cameras
from sightline.errors import BadInput
from sightline.infra.audit import trail
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import add_row, change_row, get_row
from sightline.infra.database.types import now
from sightline.surveys.tables import surveys


def create_camera(
    session: Session,
    survey_id: int,
    *,
    name: str,
    notes: str = "",
    lens: str = "",
    zoom: str = "",
    focus: str = "",
    taken_from: str = "",
    actor: int | None,
) -> Camera:
    """A new camera in a survey. Raises NotFound, BadInput."""
    get_row(session, surveys, survey_id, "survey")
    words = _strip_words(name=name, notes=notes, lens=lens, zoom=zoom, focus=focus)
    content = {"survey_id": survey_id, "taken_from": taken_from, **words}
    camera_id = add_row(session, cameras, {**content, "created_at": now(), "created_by": actor})
    trail.record(session, actor, "create", "camera", camera_id, survey_id, None, content)
    return get_camera(session, camera_id)


def update_camera(session: Session, camera_id: int, changes: CameraWords, *, actor: int | None) -> Camera:
    """Change what is said of a camera; what is left out stays. Raises NotFound, BadInput."""
    before = get_row(session, cameras, camera_id, "camera")
    change = _strip_words(**changes)
    if change:
        change_row(session, cameras, camera_id, change)
    what = trail.changed_fields(before, change, change)
    trail.record(session, actor, "update", "camera", camera_id, before["survey_id"], *what)
    return get_camera(session, camera_id)


def _strip_words(**words: Unpack[CameraWords]) -> dict[str, str]:
    stripped = {name: str(text).strip() for name, text in words.items()}
    if stripped.get("name") == "":
        raise BadInput("cameras-no-name")
    return stripped


def get_camera(session: Session, camera_id: int) -> Camera:
    """One camera with its calibrations in short. Raises NotFound."""
    return _cameras(session, [get_row(session, cameras, camera_id, "camera")])[0]


def list_cameras(session: Session, survey_id: int) -> tuple[Camera, ...]:
    """The cameras of a survey, in a fixed number of queries."""
    query = select(cameras).where(cameras.c.survey_id == survey_id).order_by(cameras.c.id)
    return _cameras(session, [dict(row) for row in session.execute(query).mappings()])


def choose_calibration(session: Session, camera_id: int, calibration_id: int, *, actor: int | None) -> Camera:
    """Make one of a camera's calibrations the current one. Raises NotFound, BadInput for another camera's."""
    camera = get_row(session, cameras, camera_id, "camera")
    if get_row(session, calibrations, calibration_id, "calibration")["camera_id"] != camera_id:
        raise BadInput("cameras-calibration-other-camera", calibration_id=calibration_id)
    change_row(session, cameras, camera_id, {"current_calibration_id": calibration_id})
    before = {"current_calibration_id": camera["current_calibration_id"]}
    after = {"current_calibration_id": calibration_id}
    trail.record(
        session, actor, "choose_calibration", "camera", camera_id, camera["survey_id"], before, after
    )
    return get_camera(session, camera_id)


def list_calibration_images(session: Session, camera_id: int) -> tuple[CalibrationImage, ...]:
    """The calibration images of a camera, in the order in which they came."""
    query = select(calibration_images).where(calibration_images.c.camera_id == camera_id)
    rows = session.execute(query.order_by(calibration_images.c.id)).mappings()
    return tuple(_image(row) for row in rows)


def get_calibration_image(session: Session, image_id: int) -> CalibrationImage:
    """One calibration image. Raises NotFound."""
    return _image(get_row(session, calibration_images, image_id, "calibration image"))


def add_calibration_image(
    session: Session,
    camera_id: int,
    *,
    name: str,
    media_key: str,
    width_px: int,
    height_px: int,
    detection: Detection,
    actor: int | None,
) -> CalibrationImage:
    """A stored image with what was detected in it; `reason` says why no board was found."""
    camera = get_row(session, cameras, camera_id, "camera")
    content = {"name": name, "media_key": media_key, "width_px": width_px, "height_px": height_px}
    detected = _detection_row(detection)
    stamps = {"camera_id": camera_id, "created_at": now(), "created_by": actor}
    image_id = add_row(session, calibration_images, {**content, **detected, **stamps})
    after = {"camera_id": camera_id, **content, "found": detection.found, "reason": detection.reason}
    trail.record(session, actor, "create", "calibration_image", image_id, camera["survey_id"], None, after)
    return get_calibration_image(session, image_id)


def set_detection(
    session: Session, image_id: int, detection: Detection, *, actor: int | None
) -> CalibrationImage:
    """What was found when looking again, for a board of another size."""
    before = get_row(session, calibration_images, image_id, "calibration image")
    camera = get_row(session, cameras, before["camera_id"], "camera")
    detected = _detection_row(detection)
    change_row(session, calibration_images, image_id, detected)
    what = trail.changed_fields(before, detected, ("found", "reason", "columns", "rows"))
    trail.record(session, actor, "detect", "calibration_image", image_id, camera["survey_id"], *what)
    return get_calibration_image(session, image_id)


def remove_calibration_image(session: Session, image_id: int, *, actor: int | None) -> CalibrationImage:
    """Take an image out; the caller lets go of its file."""
    gone = get_calibration_image(session, image_id)
    camera = get_row(session, cameras, gone.camera_id, "camera")
    session.execute(delete(calibration_images).where(calibration_images.c.id == image_id))
    before = {"camera_id": gone.camera_id, "name": gone.name, "media_key": gone.media_key}
    trail.record(session, actor, "delete", "calibration_image", image_id, camera["survey_id"], before, None)
    return gone


def _detection_row(detection: Detection) -> dict[str, Any]:
    if not detection.found and not detection.reason:
        raise BadInput("cameras-image-without-reason")
    return asdict(detection)


def _cameras(session: Session, rows: Sequence[Mapping[str, Any]]) -> tuple[Camera, ...]:
    ids = [row["id"] for row in rows]
    per_camera: dict[int, list[CalibrationSummary]] = defaultdict(list)
    for summary in summaries(session, ids):
        per_camera[summary.camera_id].append(summary)
    counted = select(calibration_images.c.camera_id, func.count()).group_by(calibration_images.c.camera_id)
    counts = {
        camera_id: n
        for camera_id, n in session.execute(counted.where(calibration_images.c.camera_id.in_(ids)))
    }
    return tuple(
        record_of(Camera, row, images=counts.get(row["id"], 0), calibrations=tuple(per_camera[row["id"]]))
        for row in rows
    )


def _image(row: Mapping[Any, Any]) -> CalibrationImage:
    return record_of(CalibrationImage, row, corners_px=[(x, y) for x, y in row["corners_px"]])
