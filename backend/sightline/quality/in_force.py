"""A road pose made of another one, in force wherever that one was."""

from collections.abc import Sequence

from sightline.errors import Conflict
from sightline.infra.database import Session
from sightline.poses.records import Pose, SolvedPose
from sightline.poses.store import add_pose
from sightline.recordings.drift_request import request_if_posed
from sightline.recordings.records import Recording
from sightline.recordings.store import update_recording


def replace_in_force(
    session: Session,
    before: Pose,
    users: Sequence[Recording],
    solved: SolvedPose,
    *,
    turned_from: int | None = None,
    turned_by_rad: float | None = None,
    adjusted_from: int | None = None,
    actor: int,
) -> Pose:
    """Store a pose made of `before`, in force for the recordings that use it; measurements keep theirs.
    Whether cameras moved is looked for again: what was found is of the pose before.

    Raises Conflict where no recording uses the pose any more.
    """
    if not users:
        raise Conflict("quality-pose-unused")
    as_before: SolvedPose = {**solved, "rms_px": before.rms_px, "distance_m": before.distance_m}
    pose = add_pose(
        session,
        before.recording_id,
        attach=any(recording.id == before.recording_id for recording in users),
        calibration_id=before.calibration_id,
        first_frame=before.first_frame,
        last_frame=before.last_frame,
        turned_from=turned_from,
        turned_by_rad=turned_by_rad,
        adjusted_from=adjusted_from,
        actor=actor,
        **as_before,
    )
    for recording in users:
        if recording.id != before.recording_id:
            update_recording(session, recording.id, {"pose_id": pose.id}, actor=actor)
        request_if_posed(session, recording.id, actor=actor)
    return pose
