"""Finding the vehicle passes of a recording, as a job; what is there or was discarded stays as it is."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sightline.detection.classify import FoundPass
from sightline.errors import Conflict, Damaged
from sightline.geometry.documents import pose_from_dict
from sightline.geometry.road_pose import RoadPose
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Finish, JobContext
from sightline.infra.jobs.store import jobs_under_way
from sightline.infra.services import Services
from sightline.media.video.passes import find_passes
from sightline.media.video.report import mean_rate_hz
from sightline.messages.said import Said
from sightline.poses.store import get_pose
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.ingest_job import LOW_LIGHT_BELOW, PASSES
from sightline.recordings.records import Recording
from sightline.recordings.store import get_ready_recording
from sightline.vehicles.records import VehicleChanges
from sightline.vehicles.store import PassSpan, create_vehicle, pass_spans

KIND = PASSES
SAME_SHARE = 0.5


def request_passes(session: Session, recording_id: int, *, actor: int) -> Job:
    """Queue the search. Raises NotFound, BadInput (no frames yet), Conflict while one waits or runs."""
    recording = get_ready_recording(session, recording_id)
    if jobs_under_way(session, KIND, recording_id=recording_id):
        raise Conflict("vehicles-search-running", name=recording.name)
    return registry.enqueue(
        session, KIND, {}, survey_id=recording.survey_id, recording_id=recording_id, actor=actor
    )


@registry.handler(KIND, long=True)
def look_for_passes(context: JobContext) -> Finish:
    """Look through the video once; what is new is stored with the job's end."""
    services = context.services
    recording_id = context.job.recording_id
    assert recording_id is not None
    opened = stills_of(services).open(recording_id)
    recording = opened.recording
    board, square_at = _posed(services, recording)
    context.progress(0.0, Said("job-passes-searching"))
    search = find_passes(
        opened.media.path,
        rate_hz=mean_rate_hz(opened.time_s),
        square_at=square_at,
        on_progress=lambda fraction: context.progress(0.98 * fraction, Said("job-passes-searching")),
        is_cancelled=context.is_cancelled,
        name=recording.name,
        stream_number=opened.media.stream_number,
    )
    count = search.frames
    if count != len(opened.media):
        raise Damaged("vehicles-frames-changed", name=recording.name, count=count, count_2=len(opened.media))
    moving = [one for one in search.passes if not _is_board(one, board)]

    def finish(session: Session) -> Mapping[str, Any]:
        return store(session, recording_id, moving, context.actor, search.notes)

    return finish


def store(
    session: Session,
    recording_id: int,
    passes: Sequence[FoundPass],
    actor: int | None,
    notes: Sequence[Said] = (),
) -> dict[str, Any]:
    """Add the passes that are not there yet, discarded ones counted as there; what was done, in words."""
    known = pass_spans(session, recording_id)
    new = [one for one in passes if not any(same_pass(one, other) for other in known)]
    for one in new:
        create_vehicle(session, recording_id, fields_of(one), actor=actor)
    return {
        "recording_id": recording_id,
        "found": len(passes),
        "added": len(new),
        "known": len(passes) - len(new),
        "message": [_summarise_search(len(passes), len(new)), *notes],
    }


def fields_of(found_pass: FoundPass) -> VehicleChanges:
    """A found pass as a vehicle record; its lighting is proposed, for a person to confirm."""
    proposed = "low_light" if found_pass.luminance < LOW_LIGHT_BELOW else "daytime"
    detection = {
        "score": found_pass.score,
        "whole": found_pass.whole,
        "sharpness": found_pass.sharpness,
        "luminance": found_pass.luminance,
        "lighting_proposed": proposed,
        "boxes": [list(box) for box in found_pass.boxes],
    }
    return {
        "first_frame": found_pass.first_frame,
        "last_frame": found_pass.last_frame,
        "best_frame": found_pass.best_frame,
        "direction": found_pass.direction,
        "origin": "found",
        "detection": detection,
    }


def same_pass(found_pass: FoundPass, known: PassSpan) -> bool:
    """Whether half of the shorter span lies in the other and they go the same way, as far as is known."""
    if found_pass.direction and known.direction and found_pass.direction != known.direction:
        return False
    shared = min(found_pass.last_frame, known.last_frame) - max(found_pass.first_frame, known.first_frame) + 1
    shorter = min(found_pass.last_frame - found_pass.first_frame, known.last_frame - known.first_frame) + 1
    return shared >= SAME_SHARE * shorter


def _summarise_search(found: int, new: int) -> Said:
    if new == found:
        return Said("passes-were-found", found=found)
    return Said("passes-were-found-again", found=found, new=new, known=found - new)


def _posed(services: Services, recording: Recording) -> tuple[tuple[int, int] | None, float]:
    """The span in which the board stood, and where in the picture the camera looks square at the road."""
    if recording.pose_id is None:
        return None, 0.5
    with services.reading() as session:
        pose = get_pose(session, recording.pose_id)
    board = (pose.first_frame, pose.last_frame) if pose.recording_id == recording.id else None
    return board, square_at(pose_from_dict(pose.document, "the camera pose"))


def square_at(pose: RoadPose) -> float:
    """Where the camera looks square across the road, as a fraction of the picture's width, 0 to 1.

    Without the lens's distortion: it says near what the best frame lies, and measures nothing.
    """
    camera = pose.camera
    x, _, z = pose.rotation @ np.array([0.0, 1.0, 0.0])
    if z <= 0:
        return 0.5
    return float(np.clip((camera.cx_px + camera.fx_px * x / z) / camera.width_px, 0.0, 1.0))


def _is_board(found_pass: FoundPass, board: tuple[int, int] | None) -> bool:
    """Whether it lies for the most part in the span in which the board stood still on the road."""
    if board is None:
        return False
    shared = min(found_pass.last_frame, board[1]) - max(found_pass.first_frame, board[0]) + 1
    return shared > SAME_SHARE * (found_pass.last_frame - found_pass.first_frame + 1)
