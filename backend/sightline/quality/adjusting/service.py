"""A road pose adjusted by its traffic: what it says, put in force by a person, taken back as a whole."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from sightline.adjustment.account import adjustment_to_dict
from sightline.adjustment.adjust import Adjustment, Moved, adjust
from sightline.errors import BadInput, Conflict, NotFound
from sightline.geometry.road_pose import RoadPose
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.jobs.records import Job
from sightline.measurements.again.query import list_computings
from sightline.measurements.again.service import ask_to_compute, ask_to_undo
from sightline.measurements.road_poses import road_pose
from sightline.measurements.service import answers_again
from sightline.measurements.store import list_measurements
from sightline.messages.said import Said
from sightline.poses.records import Pose, SolvedPose
from sightline.poses.service import describe_pose
from sightline.poses.store import get_pose
from sightline.quality.adjusting.observations import Observations, Seen, observations_of
from sightline.quality.adjusting.records import (
    AdjustedHeight,
    KnownUncertainties,
    LeftOutVehicle,
    PoseAdjustment,
    WithoutModel,
)
from sightline.quality.in_force import replace_in_force
from sightline.recordings.records import Recording
from sightline.recordings.store import list_recordings, update_recording

_CAMERA_HEIGHT = "camera_height_m"
_SAME_M = 1e-7
_MOST_MODELS = 40
_MOST_HEIGHTS = 500


def check_adjustments(
    session: Session, survey_id: int, known: KnownUncertainties
) -> tuple[PoseAdjustment, ...]:
    """Every pose in force of a survey's recordings, adjusted by their traffic. Nothing is stored."""
    ready = list_recordings(session, survey_id)
    # by recording: a pose that is put in force stays where the one before it stood
    poses = dict.fromkeys(one.pose_id for one in sorted(ready, key=lambda one: one.id))
    return tuple(_adjust_pose(session, pose_id, known)[0] for pose_id in poses if pose_id is not None)


def _adjust_pose(
    session: Session, pose_id: int, known: KnownUncertainties
) -> tuple[PoseAdjustment, Adjustment | None]:
    stored = get_pose(session, pose_id)
    users = _users(session, stored)
    observations = observations_of(session, stored.survey_id, {one.id for one in users}, known.u_wheelbase_m)
    empty = PoseAdjustment(
        pose_id=pose_id,
        recordings=tuple(one.name for one in users),
        adjusted_from=stored.adjusted_from,
        known=known,
        tyres=sum(one.what == "tyres" for one in observations.seen),
        roofs=sum(one.what == "roof" for one in observations.seen),
        left_out=observations.left_out,
    )
    if stored.adjusted_from is not None:
        # the traffic is in its covariance already; used twice it would count as twice as much
        return replace(empty, reason=Said("adjustment-done-before")), None
    if not observations.seen:
        return replace(empty, reason=Said("adjustment-no-lengths-yet")), None
    pose = road_pose(session, pose_id)
    try:
        found = _adjusted(pose, observations.seen, known)
    except BadInput as refused:
        return replace(empty, reason=refused.said), None
    heights = _heights(session, stored.survey_id, found.pose, observations.numbers)
    return _describe_adjustment(empty, pose, observations, found, heights), found


def _users(session: Session, pose: Pose) -> list[Recording]:
    return [one for one in list_recordings(session, pose.survey_id) if one.pose_id == pose.id]


def _adjusted(pose: RoadPose, seen: tuple[Seen, ...], known: KnownUncertainties) -> Adjustment:
    passes = [one.observed for one in seen]
    return adjust(pose, passes, known.u_wheelbase_common_m, known.u_roof_common_m)


def _describe_adjustment(
    empty: PoseAdjustment,
    pose: RoadPose,
    observations: Observations,
    adjustment: Adjustment,
    heights: list[AdjustedHeight],
) -> PoseAdjustment:
    of_name = {one.observed.name: one for one in observations.seen}
    wrong = [
        LeftOutVehicle(
            vehicle_id=of_name[left.name].vehicle.id,
            number=of_name[left.name].vehicle.number,
            what=of_name[left.name].what,
            reason=left.reason,
        )
        for left in adjustment.left_out
    ]
    heights.sort(key=lambda one: -abs(one.change_m))
    return filled_from(
        PoseAdjustment,
        adjustment,
        empty,
        left_out=(*wrong, *empty.left_out),
        without_model=_without_models(pose, observations, adjustment, empty.known),
        heights=tuple(heights[:_MOST_HEIGHTS]),
        largest_change_m=abs(heights[0].change_m) if heights else None,
    )


def _without_models(
    pose: RoadPose, observations: Observations, found: Adjustment, known: KnownUncertainties
) -> tuple[WithoutModel, ...]:
    """The leave-one-model check: does one model alone carry the result?"""
    with_all = _camera_height(found)
    models = sorted({one.model for one in observations.seen})
    out = []
    for model in models[:_MOST_MODELS] if len(models) > 1 else []:
        others = tuple(one for one in observations.seen if one.model != model)
        try:
            change = _camera_height(_adjusted(pose, others, known)).value - with_all.value
        except BadInput:
            continue
        out.append(
            WithoutModel(
                model=model,
                vehicles=len({one.vehicle.id for one in observations.seen if one.model == model}),
                camera_height_change_m=change,
                by_u=abs(change) / with_all.u_after,
            )
        )
    return tuple(sorted(out, key=lambda one: -one.by_u))


def _camera_height(found: Adjustment) -> Moved:
    return next(one for one in found.moved if one.name == _CAMERA_HEIGHT)


def _heights(
    session: Session, survey_id: int, adjusted: RoadPose, numbers: Mapping[int, int]
) -> list[AdjustedHeight]:
    """Stored heights of vehicles (numbers by id), and those of the same clicks and insets when adjusted."""
    made = [one for one in list_measurements(session, survey_id) if one.vehicle_id in numbers]
    out = []
    for measurement, new in zip(made, answers_again(adjusted, made), strict=True):
        old = measurement.values
        if old.height_m is None or new.height_m is None:
            continue
        out.append(
            AdjustedHeight(
                measurement_id=measurement.id,
                vehicle_id=measurement.vehicle_id,
                number=numbers[measurement.vehicle_id],
                target=old.target,
                height_m=old.height_m,
                U95_height_m=old.U95_height_m or 0.0,
                adjusted_m=new.height_m,
                U95_adjusted_m=new.U95_height_m or 0.0,
                change_m=new.height_m - old.height_m,
            )
        )
    return out


def put_in_force(
    session: Session, pose_id: int, known: KnownUncertainties, seen_camera_height_m: float, *, actor: int
) -> tuple[Pose, Job]:
    """Store the adjusted pose, in force for the recordings that use the one before, and compute again.

    `seen_camera_height_m`: the change of the camera's height that was shown. Raises NotFound, BadInput where
    the traffic gives no pose, Conflict where it now says something else or nobody uses the pose.
    """
    told, adjustment = _adjust_pose(session, pose_id, known)
    if adjustment is None or adjustment.used == 0:
        why = told.reason or Said("adjustment-no-pass")
        raise BadInput(why.code, **why.values)
    if abs(_camera_height(adjustment).value - seen_camera_height_m) > _SAME_M:
        raise Conflict("adjusting-changed-meanwhile")
    before = get_pose(session, pose_id)
    pose = replace_in_force(
        session,
        before,
        _users(session, before),
        _adjusted_pose(before, adjustment),
        turned_from=before.turned_from,
        turned_by_rad=before.turned_by_rad,
        adjusted_from=pose_id,
        actor=actor,
    )
    return pose, ask_to_compute(session, before.survey_id, kind="adjustment", actor=actor)


def _adjusted_pose(before: Pose, adjustment: Adjustment) -> SolvedPose:
    corners = np.asarray(before.overlay.get("corners_px") or [], dtype=np.float64).reshape(-1, 2)
    solved = describe_pose(adjustment.pose, corners)
    note = Said("pose-adjusted-by-passes", passes=adjustment.used)
    return {
        **solved,
        "summary": [note, *solved["summary"]],
        "document": {**solved["document"], "adjustment": adjustment_to_dict(adjustment)},
        "warnings": [*before.warnings, note, Said("pose-before", pose=before.id), *adjustment.notes],
    }


def take_back(session: Session, pose_id: int, *, actor: int) -> Job | None:
    """Put the pose before an adjusted one in force again, and the heights back that were computed with it.

    None where those heights cannot be put back as a whole any more: then they are out of date and say so.
    Raises NotFound, Conflict for a pose that is not an adjusted one in force.
    """
    stored = get_pose(session, pose_id)
    users = _users(session, stored)
    if stored.adjusted_from is None or not users:
        raise Conflict("adjusting-nothing-in-force")
    for one in users:
        update_recording(session, one.id, {"pose_id": stored.adjusted_from}, actor=actor)
    heights = list_measurements(session, stored.survey_id, include_repeats=True)
    with_it = {one.computing_id for one in heights if one.values.pose_id == pose_id}
    mine = [
        one
        for one in list_computings(session, stored.survey_id)
        if one.kind == "adjustment" and one.undone_by is None and one.id in with_it
    ]
    try:
        return ask_to_undo(session, mine[0].id, actor=actor) if mine else None
    except (Conflict, NotFound):
        return None
