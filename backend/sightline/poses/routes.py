"""Road poses: the board on a frame, a pose from a span of frames, and the poses of a survey."""

from fastapi import APIRouter, Response

from sightline.infra.csv_package.schema import json_bytes
from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired, Writing
from sightline.poses import pose_job, store
from sightline.poses.bodies import BoardWanted, PoseBody, PoseSummaryBody, PoseWanted
from sightline.poses.pose_job import PoseRequest
from sightline.poses.service import BoardView, StillSpan

router = APIRouter()


@router.post("/recordings/{recording_id}/board")
def find_board(recording_id: PathId, body: BoardWanted, who: Operator, services: Wired) -> BoardView:
    """Look for the board on one frame; where it is not found, the answer says why."""
    return pose_job.look_for_board(services, recording_id, body.frame, body.board, body.calibration_id)


@router.post("/recordings/{recording_id}/board/span")
def find_still_span(
    recording_id: PathId, body: BoardWanted, who: Operator, services: Wired
) -> StillSpan | None:
    """The frames around one in which the board stands still, to be confirmed; null where it is not there."""
    return pose_job.look_for_span(services, recording_id, body.frame, body.board, body.calibration_id)


@router.post("/recordings/{recording_id}/poses", status_code=202)
def make_pose(recording_id: PathId, body: PoseWanted, who: Operator, session: Writing) -> JobBody:
    """Solve for the road pose in the background; it becomes the recording's pose when it succeeds."""
    wanted = PoseRequest(recording_id=recording_id, **body.model_dump())
    return JobBody.model_validate(pose_job.request_pose(session, wanted, actor=who.id))


@router.get("/surveys/{survey_id}/poses")
def list_poses(survey_id: PathId, who: Viewer, session: Reading) -> list[PoseSummaryBody]:
    """The poses of a survey, newest first."""
    return [PoseSummaryBody.model_validate(one) for one in store.list_poses(session, survey_id)]


@router.get("/poses/{pose_id}")
def get_pose(pose_id: PathId, who: Viewer, session: Reading) -> PoseBody:
    """One pose with its document, what heights will be worth, and what to draw over the frame."""
    return PoseBody.model_validate(store.get_pose(session, pose_id))


@router.get("/poses/{pose_id}/pose.json", response_class=Response)
def download_pose(pose_id: PathId, who: Viewer, session: Reading) -> Response:
    """A road pose with its camera as `pose.json`, as `sightline height --pose` reads it."""
    document = store.get_pose(session, pose_id).document
    headers = {"Content-Disposition": f'attachment; filename="pose-{pose_id}.json"'}
    return Response(json_bytes(document), media_type="application/json", headers=headers)
