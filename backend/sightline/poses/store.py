"""Road poses: written once, never changed, their content's hash kept in the audit event."""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.tables import calibrations
from sightline.cameras.tables import cameras
from sightline.enums import JsonObject
from sightline.errors import BadInput
from sightline.infra.audit import trail
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, change_row, get_row, missing, stored_hash, who
from sightline.infra.database.types import columns_of, now
from sightline.messages.said import Said
from sightline.poses.records import ExpectedHeight, Pose, PoseOverlay, PoseSummary
from sightline.poses.tables import road_poses
from sightline.recordings.tables import recordings

_HEAVY = ("document", "warnings", "expected", "overlay")


def add_pose(
    session: Session,
    recording_id: int,
    *,
    calibration_id: int,
    first_frame: int,
    last_frame: int,
    rms_px: float | None,
    distance_m: float | None,
    summary: Sequence[Said],
    document: JsonObject,
    warnings: Sequence[Said],
    expected: Sequence[ExpectedHeight],
    overlay: PoseOverlay,
    attach: bool = True,
    turned_from: int | None = None,
    turned_by_rad: float | None = None,
    adjusted_from: int | None = None,
    actor: int | None,
) -> Pose:
    """Store a pose taken from frames of a recording and (by default) make it that recording's pose.

    turned_from, turned_by_rad: the pose that it was before it was turned about the road's normal;
    adjusted_from: before it was adjusted by its traffic.
    """
    recording = get_row(session, recordings, recording_id, "recording", recordings.c.deleted_at.is_(None))
    _calibration_of_survey(session, calibration_id, recording["survey_id"])
    content: dict[str, Any] = {
        "survey_id": recording["survey_id"],
        "recording_id": recording_id,
        "calibration_id": calibration_id,
        "first_frame": first_frame,
        "last_frame": last_frame,
        "rms_px": rms_px,
        "distance_m": distance_m,
        "summary": list(summary),
        "document": document,
        "warnings": list(warnings),
        "expected": list(expected),
        "overlay": overlay,
        "turned_from": turned_from,
        "turned_by_rad": turned_by_rad,
        "adjusted_from": adjusted_from,
        "created_at": now(),
        "created_by": actor,
    }
    pose_id = add_row(session, road_poses, content)
    if attach:
        change_row(session, recordings, recording_id, {"pose_id": pose_id})
    told = {key: content[key] for key in content if key not in (*_HEAVY, "created_at", "created_by")}
    after = {**told, "attached": attach, "content_sha256": stored_hash(session, road_poses, pose_id)}
    trail.record(session, actor, "create", "pose", pose_id, recording["survey_id"], None, after)
    return get_pose(session, pose_id)


def get_pose(session: Session, pose_id: int) -> Pose:
    """One pose, whole. Raises NotFound."""
    found = _whole(session, road_poses.c.id == pose_id)
    if not found:
        raise missing("camera pose", pose_id)
    return found[0]


def list_whole_poses(session: Session, survey_id: int) -> tuple[Pose, ...]:
    """Every pose of a survey, whole, for the export."""
    return _whole(session, road_poses.c.survey_id == survey_id)


def list_poses(session: Session, survey_id: int) -> tuple[PoseSummary, ...]:
    """The poses of a survey in short, newest first."""
    chosen = columns_of(road_poses, *_HEAVY)
    query = (
        select(*chosen, people.c.name.label("maker"))
        .outerjoin(people, people.c.id == road_poses.c.created_by)
        .where(road_poses.c.survey_id == survey_id)
        .order_by(road_poses.c.id.desc())
    )
    named = [column.name for column in chosen if column.name != "created_by"]
    return tuple(
        PoseSummary(created_by=who(row.created_by, row.maker), **{name: getattr(row, name) for name in named})
        for row in session.execute(query)
    )


def _whole(session: Session, condition: Any) -> tuple[Pose, ...]:
    query = (
        select(road_poses, people.c.name.label("maker"))
        .outerjoin(people, people.c.id == road_poses.c.created_by)
        .where(condition)
        .order_by(road_poses.c.id)
    )
    named = [column.name for column in columns_of(road_poses, "created_by")]
    return tuple(
        Pose(created_by=who(row.created_by, row.maker), **{name: getattr(row, name) for name in named})
        for row in session.execute(query)
    )


def _calibration_of_survey(session: Session, calibration_id: int, survey_id: int) -> None:
    camera_id = get_row(session, calibrations, calibration_id, "calibration")["camera_id"]
    if get_row(session, cameras, camera_id, "camera")["survey_id"] != survey_id:
        raise BadInput("poses-calibration-belongs-another-survey-choose-one", calibration_id=calibration_id)
