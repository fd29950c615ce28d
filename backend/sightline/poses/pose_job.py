"""Road poses of stored recordings: what is refused at once, and the job that looks at the frames."""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from sightline.cameras.boards import BoardTold
from sightline.cameras.calibrations.store import get_calibration
from sightline.enums import BoardSide
from sightline.errors import BadInput
from sightline.geometry.board import Board, require_board
from sightline.geometry.camera import Camera
from sightline.geometry.corners import find_board
from sightline.geometry.documents import camera_from_dict
from sightline.geometry.road_pose import DEFAULT_U_BOW_M, Reference
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.messages.said import Said
from sightline.poses.records import SolvedPose
from sightline.poses.service import (
    BoardView,
    StillSpan,
    board_in_span,
    board_view,
    check_fits,
    solve,
    still_span,
)
from sightline.poses.store import add_pose
from sightline.recordings.drift_request import request_if_posed
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.records import Recording
from sightline.recordings.store import get_ready_recording, get_recording, update_recording

KIND = "pose"


@dataclass(frozen=True, kw_only=True)
class PoseRequest(BoardTold):
    """A span of frames, the board that stood in it, and the tape's measure."""

    recording_id: int
    calibration_id: int
    first_frame: int
    last_frame: int
    reference: BoardSide
    reference_height_m: float
    u_reference_height_m: float
    u_lean_rad: float
    u_square_m: float | None = None
    u_bow_m: float = DEFAULT_U_BOW_M

    @property
    def tape(self) -> Reference:
        return Reference(
            side=self.reference,
            height_m=self.reference_height_m,
            u_height_m=self.u_reference_height_m,
            u_lean_rad=self.u_lean_rad,
            u_square_m=self.u_square_m,
            u_bow_m=self.u_bow_m,
        )


def look_for_board(
    services: Services, recording_id: int, frame: int, board: Board, calibration_id: int | None
) -> BoardView:
    """The board on one frame. Raises NotFound, BadInput (not ready, calibration of another size)."""
    if calibration_id is not None:
        with services.reading() as session:
            fitting_camera(session, get_recording(session, recording_id), calibration_id)
    return board_view(stills_of(services).gray(recording_id, frame), board)


def look_for_span(
    services: Services, recording_id: int, frame: int, board: Board, calibration_id: int | None
) -> StillSpan | None:
    """The frames around one in which the board stands still; None where it is not on it.

    Raises NotFound, BadInput (not ready, calibration of another size).
    """
    with services.reading() as session:
        recording = get_recording(session, recording_id)
        if calibration_id is not None:
            fitting_camera(session, recording, calibration_id)
    stills = stills_of(services)
    count = recording.frame_count or frame + 1
    return still_span(lambda n: find_board(stills.gray(recording_id, n), board), frame, count - 1)


def request_pose(session: Session, wanted: PoseRequest, *, actor: int) -> Job:
    """Queue the solution. Raises at once for what can be seen to be wrong without looking at a frame."""
    recording = get_ready_recording(session, wanted.recording_id)
    frames = recording.frame_count or 0
    if not wanted.first_frame <= wanted.last_frame < frames:
        raise BadInput(
            "poses-frames-outside",
            first_frame=wanted.first_frame,
            last_frame=wanted.last_frame,
            name=recording.name,
            frame_count=frames - 1,
        )
    require_board(wanted.board)
    fitting_camera(session, recording, wanted.calibration_id)
    return registry.enqueue(
        session, KIND, asdict(wanted), survey_id=recording.survey_id, recording_id=recording.id, actor=actor
    )


def fitting_camera(session: Session, recording: Recording, calibration_id: int) -> Camera:
    """The calibration as a camera. Raises BadInput if it is for pictures of another size."""
    camera = camera_from_dict(
        get_calibration(session, calibration_id).document, f"calibration {calibration_id}"
    )
    if recording.width_px is not None and recording.height_px is not None:
        check_fits(camera, recording.width_px, recording.height_px, recording.name)
    return camera


@registry.handler(KIND)
def solve_pose(context: registry.JobContext) -> registry.Outcome:
    """Detect the board in frames of the span, solve, and make the result the recording's pose."""
    wanted = PoseRequest(**context.payload)
    services = context.services
    with services.reading() as session:
        recording = get_recording(session, wanted.recording_id)
        camera = fitting_camera(session, recording, wanted.calibration_id)
    board_seen = board_in_span(
        lambda n: stills_of(services).gray(wanted.recording_id, n),
        wanted.first_frame,
        wanted.last_frame,
        wanted.board,
        context.progress,
    )
    context.progress(0.85, Said("job-pose-computing"))
    solved = solve(camera, board_seen, wanted.board, wanted.tape)
    return storing(wanted, solved, context.actor)


def storing(
    wanted: PoseRequest, solved: SolvedPose, actor: int | None
) -> Callable[[Session], Mapping[str, Any]]:
    """The write that ends the job: the pose, in force for its recording, and the camera that filmed it."""

    def store(session: Session) -> Mapping[str, Any]:
        pose = add_pose(
            session,
            wanted.recording_id,
            calibration_id=wanted.calibration_id,
            first_frame=wanted.first_frame,
            last_frame=wanted.last_frame,
            actor=actor,
            **solved,
        )
        recording = get_recording(session, wanted.recording_id)
        camera_id = get_calibration(session, wanted.calibration_id).camera_id
        if recording.camera_id is None:
            update_recording(session, recording.id, {"camera_id": camera_id}, actor=actor)
        request_if_posed(session, recording.id, actor=actor)
        return {"pose_id": pose.id}

    return store
