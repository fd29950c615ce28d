"""Road poses: written once, never changed, their content's hash kept in the audit event."""

from typing import Any, Unpack

from sqlalchemy import ColumnElement
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.tables import calibrations
from sightline.cameras.tables import cameras
from sightline.errors import BadInput
from sightline.infra.audit.written import written_once, written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import change_row, get_row, the_one
from sightline.poses.records import NewPose, Pose, PoseSummary
from sightline.poses.tables import road_poses
from sightline.recordings.tables import recordings

_HEAVY = ("document", "warnings", "expected", "overlay")


def add_pose(
    session: Session, recording_id: int, *, attach: bool = True, actor: int | None, **values: Unpack[NewPose]
) -> Pose:
    """Store a pose taken from frames of a recording and (by default) make it that recording's pose; one that
    others alone use may have been deleted.
    """
    alive = (recordings.c.deleted_at.is_(None),) if attach else ()
    recording = get_row(session, recordings, recording_id, "recording", *alive)
    _calibration_of_survey(session, values["calibration_id"], recording["survey_id"])
    made_of: dict[str, Any] = dict.fromkeys(("turned_from", "turned_by_rad", "adjusted_from"))
    place = {"survey_id": recording["survey_id"], "recording_id": recording_id}
    content = {**place, **made_of, **values}
    pose_id = written_once(
        session, road_poses, content, "create", also={"attached": attach}, untold=_HEAVY, actor=actor
    )
    if attach:
        change_row(session, recordings, recording_id, {"pose_id": pose_id})
    return get_pose(session, pose_id)


def get_pose(session: Session, pose_id: int) -> Pose:
    """One pose, whole. Raises NotFound."""
    return the_one(_fetch_poses(session, road_poses.c.id == pose_id), "camera pose", pose_id)


def list_whole_poses(session: Session, survey_id: int) -> tuple[Pose, ...]:
    """Every pose of a survey, whole, for the export."""
    return _fetch_poses(session, road_poses.c.survey_id == survey_id)


def list_poses(session: Session, survey_id: int) -> tuple[PoseSummary, ...]:
    """The poses of a survey in short, newest first."""
    of_survey = road_poses.c.survey_id == survey_id
    rows = written_rows(session, road_poses, of_survey, without=_HEAVY, newest_first=True)
    return tuple(record_of(PoseSummary, row) for row in rows)


def _fetch_poses(session: Session, condition: ColumnElement[bool]) -> tuple[Pose, ...]:
    return tuple(record_of(Pose, row) for row in written_rows(session, road_poses, condition))


def _calibration_of_survey(session: Session, calibration_id: int, survey_id: int) -> None:
    camera_id = get_row(session, calibrations, calibration_id, "calibration")["camera_id"]
    if get_row(session, cameras, camera_id, "camera")["survey_id"] != survey_id:
        raise BadInput("poses-calibration-other-survey", calibration_id=calibration_id)
