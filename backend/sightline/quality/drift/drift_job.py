"""Did the camera move? The background of the road pose's frames, looked for over the whole recording."""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any, cast

import numpy as np

from sightline.enums import DriftState
from sightline.errors import NotFound
from sightline.geometry.drift import TARGET_M, HeightChange, Motion, height_change
from sightline.geometry.drift_spans import Course, Look, Span, course
from sightline.geometry.road_pose import RoadPose
from sightline.infra.database import Session
from sightline.infra.database.types import now
from sightline.infra.jobs import registry
from sightline.infra.services import Services
from sightline.infra.version import code_version
from sightline.measurements.road_poses import road_pose
from sightline.media.video.drift import Background, background, mean_of, register
from sightline.messages.said import Said
from sightline.poses.records import Pose
from sightline.poses.store import get_pose
from sightline.recordings.drift import DriftCheck, DriftLook, DriftMotion, DriftSpan, DriftStep
from sightline.recordings.drift_request import DRIFT
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.records import Recording
from sightline.recordings.store import get_recording, store_drift

_OF_POSE = 8  # frames of the pose's span whose mean is looked for
_EVERY_S = 1.0
_FEWEST, _MOST = 24, 120
_MOST_SAID = 3


@dataclass(frozen=True, eq=False)
class _Check:
    """One recording against one pose: what `course` found, and what it is worth in millimetres."""

    recording: Recording
    pose: Pose
    road: RoadPose
    looks: list[Look]
    found: Course
    time_s: Callable[[int], float]


@registry.handler(DRIFT, long=True)
def look_for_drift(context: registry.JobContext) -> registry.Outcome:
    """Compare frames over the recording with those of the pose, and store what was found."""
    recording_id, pose_id = int(context.payload["recording_id"]), int(context.payload["pose_id"])
    services = context.services
    with services.reading() as session:
        recording = get_recording(session, recording_id)
        pose = get_pose(session, pose_id)
        road = road_pose(session, pose_id)
    ours = _of_pose(services, pose)
    looks = []
    frames = frames_to_look_at(recording.frame_count or 0, recording.duration_s or 0.0)
    for index, n in enumerate(frames):
        context.progress(0.9 * index / len(frames), Said("job-drift-background", frame=n))
        looks.append(Look(n, register(ours, stills_of(services).gray(recording_id, n))))
    context.progress(0.92, Said("job-drift-searching"))

    def look_at(n: int) -> Motion | Said:
        context.progress(0.95, Said("job-drift-background", frame=n))
        if not 0 <= n < (recording.frame_count or 0):
            return Said("drift-no-such-frame")
        return register(ours, stills_of(services).gray(recording_id, n))

    size = (road.camera.width_px, road.camera.height_px)
    found = course(looks, (recording.frame_count or 1) - 1, size, look_at)
    times = stills_of(services).open(recording_id).time_s
    at = _Check(
        recording=recording, pose=pose, road=road, looks=looks, found=found, time_s=lambda n: float(times[n])
    )
    document = document_of(at)

    def store(session: Session) -> Mapping[str, Any]:
        store_drift(session, recording_id, pose_id, document, actor=context.actor)
        return {"state": document["state"], "words": [one.document for one in document["words"]]}

    return store


def frames_to_look_at(count: int, duration_s: float) -> list[int]:
    """The frames of the looks, one a second, 24 to 120 of them, over the whole recording."""
    wanted = int(np.clip(duration_s / _EVERY_S, _FEWEST, _MOST))
    return sorted({int(n) for n in np.linspace(0, max(count - 1, 0), min(wanted, max(count, 1)))})


def _of_pose(services: Services, pose: Pose) -> Background:
    frames = sorted({int(n) for n in np.linspace(pose.first_frame, pose.last_frame, _OF_POSE)})
    try:
        return background(mean_of([stills_of(services).gray(pose.recording_id, n) for n in frames]))
    except NotFound as gone:
        raise NotFound("drift-recording-of-pose-deleted") from gone


def document_of(check: _Check) -> DriftCheck:
    """What is stored and shown: plain lists, every number with its unit."""
    drift_course = check.found
    changes = [(look, _change(check.road, look.motion)) for look in check.looks]
    spans = [_span_row(check.road, span) for span in drift_course.spans]
    bumps: list[DriftStep] = [
        {"after": one.after, "frame": one.frame, "time_s": check.time_s(one.frame), "by_px": one.by_px}
        for one in drift_course.bumps
    ]
    with_distance = [change for _, change in changes if change is not None and change.distance_m is not None]
    floor = _floor(check)
    state: DriftState = (
        "unknown" if drift_course.reason else "moved" if any(span["moved"] for span in spans) else "still"
    )
    document: DriftCheck = {
        "pose_id": check.pose.id,
        "pose_recording_id": check.pose.recording_id,
        "state": state,
        "words": [],
        "reason": drift_course.reason,
        "floor_px": drift_course.floor_px,
        "floor_m": floor,
        "target_m": TARGET_M,
        "distance_m": with_distance[0].distance_m if with_distance else None,
        "looks": [_look_row(check, look, change) for look, change in changes],
        "bumps": bumps,
        "spans": spans,
        "checked_at": now().isoformat(timespec="seconds"),
        "code_version": code_version(),
    }
    return {**document, "words": words_of(document, check.time_s)}


def _span_row(road: RoadPose, span: Span) -> DriftSpan:
    change = height_change(road, span.motion)
    return {
        "first_frame": span.first_frame,
        "last_frame": span.last_frame,
        "moved": span.moved,
        **_motion(span.motion),
        "change_m": change.change_m,
        "distance_m": change.distance_m,
    }


def _motion(motion: Motion) -> DriftMotion:
    return cast(DriftMotion, asdict(motion))


def _change(road: RoadPose, motion: Motion | Said) -> HeightChange | None:
    return height_change(road, motion) if isinstance(motion, Motion) else None


def _look_row(check: _Check, look: Look, change: HeightChange | None) -> DriftLook:
    at: DriftLook = {"frame": look.frame, "time_s": check.time_s(look.frame)}
    if isinstance(look.motion, Said) or change is None:
        assert isinstance(look.motion, Said)
        return {**at, "reason": look.motion}
    return {**at, **_motion(look.motion), "change_m": change.change_m}


def _floor(check: _Check) -> float | None:
    """The floor in metres of height: a shift of that much, up or down the picture, where heights feel it."""
    if check.found.floor_px is None:
        return None
    floor_px = check.found.floor_px
    shift = Motion(x_px=0.0, y_px=floor_px, turn_rad=0.0, scale=1.0, moved_px=floor_px, u_px=0.0, points=0)
    change = height_change(check.road, shift).change_m
    return None if change is None else abs(change)


def words_of(document: DriftCheck, time_s: Callable[[int], float]) -> list[Said]:
    """The verdict: what was found, or each of the first movements."""
    if document["state"] == "unknown":
        return [Said("drift-unknown", reason=document["reason"])]
    if document["state"] == "still":
        floor_px, floor_m = round(document["floor_px"] or 0.0, 2), document["floor_m"]
        if floor_m is None:
            return [Said("drift-still", floor_px=floor_px)]
        return [Said("drift-still-of-height", floor_px=floor_px, floor_m=round(floor_m, 4))]
    moved = [one for one in document["spans"] if one["moved"]]
    said = [_describe_span(one, document["bumps"], time_s) for one in moved[:_MOST_SAID]]
    more = len(moved) - _MOST_SAID
    said += [Said("drift-more", count=more)] if more > 0 else []
    near_m = next((at for one in moved if (at := one.get("distance_m")) is not None), None)
    return said if near_m is None else [*said, Said("drift-near", target_m=TARGET_M, distance_m=near_m)]


def _describe_span(span: DriftSpan, bumps: list[DriftStep], time_s: Callable[[int], float]) -> Said:
    first, last = span["first_frame"], span["last_frame"]
    bumped = any(bump["after"] < first <= bump["frame"] for bump in bumps)
    how = "bumped" if bumped else "before" if first == 0 else "drifted"
    at, moved_px = clock(time_s(first)), round(span["moved_px"], 1)
    if span["change_m"] is None:
        return Said("drift-moved", how=how, clock=at, frame=first, moved_px=moved_px, first=first, last=last)
    return Said(
        "drift-moved-height",
        how=how,
        clock=at,
        frame=first,
        moved_px=moved_px,
        error_m=round(abs(span["change_m"]), 3),
        first=first,
        last=last,
    )


def clock(seconds: float) -> str:
    """Minutes, seconds and tenths since the first frame."""
    tenths = round(seconds * 10)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"
