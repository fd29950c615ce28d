"""What a person would click of every found pass of a recording, as a job; stored as proposals, as a whole."""

from collections.abc import Mapping, Sequence
from typing import Any

from sightline.detection.classify import FoundPass
from sightline.errors import BadInput, Conflict
from sightline.geometry.documents import pose_from_dict
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Finish, JobContext
from sightline.infra.jobs.store import jobs_under_way
from sightline.media.video.proposals import propose_in_video
from sightline.media.video.report import mean_rate_hz
from sightline.messages.said import Said
from sightline.poses.store import get_pose
from sightline.proposals.propose import POINTS, Proposals, Proposed
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.store import get_ready_recording, get_recording
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.store import replace_proposals
from sightline.vehicles.records import Vehicle
from sightline.vehicles.store import list_vehicles_of_recording

KIND = "proposals"


def request_proposals(session: Session, recording_id: int, *, actor: int) -> Job:
    """Queue it. Raises NotFound, BadInput (no frames or passes), Conflict (no camera pose; waits or runs)."""
    recording = get_ready_recording(session, recording_id)
    if recording.pose_id is None:
        raise Conflict("measurements-no-pose", name=recording.name)
    if not found_passes(session, recording_id):
        raise BadInput("proposals-no-found-passes", name=recording.name)
    if jobs_under_way(session, KIND, recording_id=recording_id):
        raise Conflict("proposals-being-made-already", name=recording.name)
    return registry.enqueue(
        session, KIND, {}, survey_id=recording.survey_id, recording_id=recording_id, actor=actor
    )


@registry.handler(KIND, long=True)
def make_proposals(context: JobContext) -> Finish:
    """Look through the video once; what is proposed takes, with the job's end, the place of all before."""
    services, recording_id = context.services, context.job.recording_id
    assert recording_id is not None
    opened = stills_of(services).open(recording_id)
    with services.reading() as session:
        recording = get_recording(session, recording_id)
        vehicles = found_passes(session, recording_id)
        if recording.pose_id is None:
            raise Conflict("measurements-no-pose", name=recording.name)
        pose_id = recording.pose_id
        pose = pose_from_dict(get_pose(session, pose_id).document, "the camera pose")
    context.progress(0.0, Said("proposals-looking"))
    proposals: list[PointProposal] = []
    proposed = propose_in_video(
        opened.media.path,
        [_pass_of_vehicle(one) for one in vehicles],
        pose,
        rate_hz=mean_rate_hz(opened.time_s),
        on_progress=lambda fraction: context.progress(0.98 * fraction, Said("proposals-looking")),
        is_cancelled=context.is_cancelled,
        name=recording.name,
        stream_number=opened.media.stream_number,
    )
    for index, one in proposed:
        proposals += proposals_of(vehicles[index].id, one)

    def finish(session: Session) -> Mapping[str, Any]:
        replace_proposals(session, recording_id, pose_id, proposals, actor=context.actor)
        return summarise_proposals(recording_id, proposals)

    return finish


def found_passes(session: Session, recording_id: int) -> list[Vehicle]:
    """The passes that Sightline found and nobody discarded: of those it knows where the vehicle is."""
    return [
        one
        for one in list_vehicles_of_recording(session, recording_id)
        if one.discarded is None and one.detection is not None and one.detection.get("boxes")
    ]


def proposals_of(vehicle_id: int, found: Proposals | str) -> list[PointProposal]:
    """Every point of a vehicle, as it is stored; where nothing is proposed each has that reason."""
    frame = None if isinstance(found, str) else found.frame
    points = dict.fromkeys(POINTS, found) if isinstance(found, str) else found.points
    return [_proposal(vehicle_id, frame, name, points[name]) for name in POINTS]


def summarise_proposals(recording_id: int, made: Sequence[PointProposal]) -> dict[str, Any]:
    """What was done, in words and numbers."""
    points = sum(one.point_px is not None for one in made)
    some = len({one.vehicle_id for one in made if one.point_px is not None})
    passes = len({one.vehicle_id for one in made})
    message = [Said("proposals-made", points=points, some=some, passes=passes)]
    return {"recording_id": recording_id, "passes": passes, "points": points, "message": message}


def _proposal(vehicle_id: int, frame: int | None, name: Any, point: Any) -> PointProposal:
    placed = isinstance(point, Proposed)
    return PointProposal(
        vehicle_id=vehicle_id,
        point=name,
        frame=frame,
        point_px=point.point_px if placed else None,
        expected_px=point.expected_px if placed else None,
        reason=None if placed else point,
    )


def _pass_of_vehicle(vehicle: Vehicle) -> FoundPass:
    """The pass as it was found, with the span and direction that people gave it since."""
    assert vehicle.detection is not None
    boxes = tuple((int(n), *map(float, sides)) for n, *sides in vehicle.detection["boxes"])
    best = vehicle.best_frame if vehicle.best_frame is not None else int(boxes[len(boxes) // 2][0])
    return FoundPass(
        first_frame=vehicle.first_frame,
        last_frame=vehicle.last_frame,
        best_frame=best,
        direction=vehicle.direction,
        whole=bool(vehicle.detection.get("whole", False)),
        score=float(vehicle.detection.get("score", 0.0)),
        sharpness=float(vehicle.detection.get("sharpness", 0.0)),
        luminance=float(vehicle.detection.get("luminance", 0.0)),
        boxes=boxes,  # type: ignore[arg-type]
    )
