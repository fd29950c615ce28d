"""Measurements: from clicks on a stored recording to a stored height, and what is shown before the click.

The preview and the stored number come from the same function (`height_of_clicks.answer`) with the same pose,
sigma and inset, so for the same points they are the same number.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields, replace
from typing import Any, cast

from sightline.enums import Made, Point, ProposedPoint, Target
from sightline.errors import BadInput, Conflict
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.ruler import Ruler, ruler
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.version import code_version
from sightline.measurements.click_context_query import ClickContext, click_context, click_context_of_vehicle
from sightline.measurements.height_of_clicks import Answer, answer, answers, filled_in, inset_for, on_side
from sightline.measurements.records import (
    ClickedFrame,
    Clicks,
    FurtherFrame,
    Measurement,
    MeasurementValues,
    Origin,
)
from sightline.measurements.road_poses import road_pose
from sightline.measurements.store import add_measurement, get_measurement, is_stored_key, revise_measurement
from sightline.statistics.plausible import is_of_class
from sightline.vehicles.proposing.store import proposals_of_vehicle
from sightline.vehicles.records import VehicleChanges
from sightline.vehicles.store import update_vehicle


def height_at(
    session: Session,
    recording_id: int,
    clicks: Clicks,
    *,
    vehicle_id: int | None = None,
    actor: int | None = None,
) -> Answer:
    """The height that these clicks of `actor` would get on a vehicle. Raises Conflict without a road pose."""
    context = click_context(session, recording_id, actor, vehicle_id=vehicle_id)
    pose, _, _ = pose_in_force(session, context)
    found = answer(pose, clicks_in_context(clicks, context))
    if found.height_m is None:
        return found
    return replace(found, of_class=is_of_class(clicks.target, found.height_m, context.category))


def ruler_at(
    session: Session,
    recording_id: int,
    contact: Point,
    target: Target,
    inset_m: float | None,
    vehicle_id: int | None = None,
) -> Ruler:
    """Axes and ladder at a contact; no ladder for eyes without side. Raises Conflict without a road pose."""
    context = click_context(session, recording_id, None, vehicle_id=vehicle_id)
    pose, _, _ = pose_in_force(session, context)
    side = None if context.side is None else context.side.side
    usual = inset_for(target, side, context.category, context.insets)
    return ruler(pose, contact, inset_m if inset_m is not None or usual is None else usual.inset_m)


def store_measurement(
    session: Session,
    vehicle_id: int,
    client_key: str,
    clicks: Clicks,
    *,
    repeat_of: int | None = None,
    actor: int,
) -> Measurement:
    """Measure and store; the same `client_key` again gives back what was stored the first time.

    `repeat_of`: the measurement that these clicks repeat; its inset is theirs unless they bring one, so that
    the heights differ by the clicks alone. A target that was said not to be visible is so no longer,
    nor is a vehicle discarded. Raises NotFound, Conflict without a road pose or where clicks said to be a
    proposal's are none that stands, BadInput for a frame outside the recording or a repeat of another
    target's or vehicle's.
    """
    context = click_context_of_vehicle(session, vehicle_id, actor, _frames_once(clicks))
    if context.proposed or clicks.made != "clicked":
        clicks = origin_of(session, vehicle_id, client_key, clicks)
    if repeat_of is not None and clicks.inset_m is None:
        first = get_measurement(session, repeat_of)
        clicks = replace(clicks, **_inset_of(first.values))
    values = values_of_clicks(session, context, clicks)
    measurement = add_measurement(
        session, vehicle_id, client_key=client_key, values=values, repeat_of=repeat_of, actor=actor
    )
    gone = gone_by_measuring(context, clicks.target)
    if gone and repeat_of is None:
        update_vehicle(session, vehicle_id, gone, version=None, actor=actor)
    return measurement


def origin_of(session: Session, vehicle_id: int, client_key: str, clicks: Clicks) -> Clicks:
    """Clicks with how their points were set, held against what is proposed on their frame: a point exactly
    where one is proposed was not clicked, whatever is said. What was proposed is kept beside them.

    Raises Conflict where clicks said to be confirmed are not those proposed, or where nothing is proposed of
    the target of clicks said to be moved, on their frame; not for a `client_key` that is stored already.
    """
    placed = [one for one in proposals_of_vehicle(session, vehicle_id) if one.frame == clicks.frame]
    places = {one.point: one.point_px for one in placed if one.point_px is not None}
    origin = made_of(clicks, places)
    if origin is None and not is_stored_key(session, client_key):
        raise Conflict("measurements-proposals-not-these")
    contacts = [one for one in placed if one.point.startswith("contact") and one.point_px is not None]
    best = min(contacts, key=lambda one: one.expected_px or 0.0, default=None)
    target = places.get(cast(ProposedPoint, clicks.target))
    origin = origin or clicks.made
    if best is None or best.point_px is None or target is None:
        return replace(clicks, made=origin)
    return replace(
        clicks,
        made=origin,
        proposal="withheld" if best.withheld else "shown",
        proposed_contact_x_px=best.point_px[0],
        proposed_contact_y_px=best.point_px[1],
        proposed_target_x_px=target[0],
        proposed_target_y_px=target[1],
    )


def made_of(clicks: Clicks, places: Mapping[ProposedPoint, Point]) -> Made | None:
    """None where clicks are not what they are said to be. A target that nothing is proposed of is clicked,
    also on a contact that was proposed.
    """
    if cast(ProposedPoint, clicks.target) not in places:
        return None if clicks.made in ("confirmed", "moved") else clicks.made
    contact = any(
        _is_same_point(clicks.contact, at) for point, at in places.items() if point.startswith("contact")
    )
    target = _is_same_point(clicks.target_point, places.get(cast(ProposedPoint, clicks.target)))
    if contact and target:
        return "confirmed"
    if clicks.made == "snapped":
        return "snapped"
    if clicks.made == "confirmed":
        return None
    return "moved" if contact or target or clicks.made == "moved" else "clicked"


def _is_same_point(clicked: Point, proposed: Point | None) -> bool:
    """Whether it is that point, but for the rounding of its way to a page and back."""
    return proposed is not None and all(abs(a - b) < 1e-6 for a, b in zip(clicked, proposed, strict=True))


def gone_by_measuring(context: ClickContext, target: Target) -> VehicleChanges:
    """What was said of a vehicle and no longer holds once the target is measured."""
    gone = [f"{target}_not_visible"] if target in context.not_visible else []
    gone += ["discarded"] if context.discarded else []
    return dict.fromkeys(gone)


def store_revision(session: Session, before: Measurement, clicks: Clicks, *, actor: int) -> Measurement:
    """Measure again, as a new revision, what `require_measurement_revision` gave in the same transaction."""
    then = before.values
    if (clicks.target, clicks.inset_m, clicks.u_inset_m) == (then.target, then.inset_m, then.u_inset_m):
        clicks = replace(clicks, **_inset_of(then))
    if clicks.made != "snapped":
        clicks = replace(clicks, **origin_after(then, clicks.frame, clicks.contact, clicks.target_point))
    elif clicks.frame == then.frame and then.made in ("confirmed", "moved"):
        clicks = replace(clicks, made="moved")
    values = values_of_vehicle(session, before.vehicle_id, clicks, actor=actor)
    return revise_measurement(session, before, values, actor=actor)


def _inset_of(then: MeasurementValues) -> dict[str, Any]:
    """The inset of a revision, and where it came from."""
    names = ("inset_m", "u_inset_m", "inset_from", "side", "side_from")
    return {name: getattr(then, name) for name in names}


def values_of_vehicle(session: Session, vehicle_id: int, clicks: Clicks, *, actor: int) -> MeasurementValues:
    """`values_of_clicks` of a person's clicks on a vehicle."""
    context = click_context_of_vehicle(session, vehicle_id, actor, _frames_once(clicks))
    return values_of_clicks(session, context, clicks)


def _frames_once(clicks: Clicks) -> tuple[int, ...]:
    """Raises BadInput where a frame is there twice: the vehicle has not moved between a frame and itself."""
    twice = next((number for number in clicks.frames if clicks.frames.count(number) > 1), None)
    if twice is not None:
        raise BadInput("measurements-frame-twice", twice=twice)
    return clicks.frames


def values_of_clicks(session: Session, context: ClickContext, clicks: Clicks) -> MeasurementValues:
    """Everything that is stored of a measurement, so that anybody can compute it again.

    `context` holds the frames of the clicks. Raises NotFound for a frame outside the recording.
    """
    pose, _, _ = pose_in_force(session, context)
    clicks = clicks_in_context(clicks, context)
    return values_of_answer(context, clicks, answer(pose, clicks))


def values_of_answer(context: ClickContext, clicks: Clicks, answered: Answer) -> MeasurementValues:
    """What is stored of clicks that `clicks_in_context` filled in and of the height that they gave."""
    frame = context.frame(clicks.frame)
    return filled_from(
        MeasurementValues,
        answered,
        clicks,
        pts=frame.pts,
        time_s=frame.time_s,
        frame_crc32=frame.crc32,
        pose_id=context.pose_id,
        calibration_id=context.calibration_id,
        code_version=code_version(),
        more_frames=tuple(_further(context, one) for one in clicks.more_frames),
    )


def _further(context: ClickContext, one: ClickedFrame) -> FurtherFrame:
    frame = context.frame(one.frame)
    return filled_from(FurtherFrame, one, frame, frame_crc32=frame.crc32)


def clicks_in_context(clicks: Clicks, context: ClickContext) -> Clicks:
    """The clicks with sigma and inset; what was left out comes from the person's repeats and the survey."""
    _check_point("contact", clicks.contact)
    _check_point("target", clicks.target_point)
    for further in clicks.more_frames:
        _check_point(f"contact (frame {further.frame})", further.contact)
        _check_point(f"target (frame {further.frame})", further.target_point)
    return filled_in(on_side(clicks, context.side), context.insets, context.category, context.own_sigma_px)


def _check_point(word: str, point: Point) -> None:
    """Far outside any picture a number is a slip, not a click."""
    if not all(abs(value) < 1e6 for value in point):
        raise BadInput(
            "measurements-point-outside",
            word=word,
            point=format(point[0], "g"),
            point_2=format(point[1], "g"),
        )


def pose_in_force(session: Session, context: ClickContext) -> tuple[RoadPose, int, int]:
    """(pose, pose id, calibration id) of the recording.

    Raises Conflict with what to do where it has none, or one for pictures of another size: then every click
    would be a wrong number that looks right.
    """
    if context.pose_id is None or context.calibration_id is None:
        raise Conflict("measurements-no-pose", name=context.name)
    pose = road_pose(session, context.pose_id)
    size_px = (pose.camera.width_px, pose.camera.height_px)
    if None not in context.size_px and context.size_px != size_px:
        raise Conflict(
            "measurements-pose-image-size", name=context.name, size_px=size_px[0], size_px_2=size_px[1]
        )
    return pose, context.pose_id, context.calibration_id


def revise_with_what_holds_now(session: Session, before: Measurement, *, actor: int) -> Measurement:
    """The same clicks with the side, inset and road pose in force now, as a new revision of who clicked; an
    inset of its own stays. Raises Conflict without a road pose.
    """
    clicks = clicks_to_compute_again(before.values)
    values = values_of_vehicle(session, before.vehicle_id, clicks, actor=actor)
    return revise_measurement(session, before, values, clicked_by=before.created_by, actor=actor)


def clicks_to_compute_again(values: MeasurementValues) -> Clicks:
    """What a person clicked and said for a stored revision, without what followed from the survey."""
    own = values.inset_from == "own"
    return replace(
        clicked_again(values, values.frame, values.contact, values.target_point),
        inset_m=values.inset_m if own else None,
        u_inset_m=values.u_inset_m if own else None,
        inset_from="own" if own else None,
        side=None,
        side_from=None,
    )


def clicked_again(values: MeasurementValues, n: int, contact: Point, target_point: Point) -> Clicks:
    """Other points on frame n with everything else as in a stored revision.

    On another frame the further frames fall away: they were clicked to go with the frame before.
    """
    more = tuple(filled_from(ClickedFrame, other) for other in values.more_frames)
    return Clicks(
        target=values.target,
        frame=n,
        contact=contact,
        target_point=target_point,
        more_frames=more if n == values.frame else (),
        # what was followed began at these very points
        followed=values.followed if (n, contact, target_point) == values.first_clicks else None,
        sigma_px=values.sigma_px,
        **_inset_of(values),
        **origin_after(values, n, contact, target_point),
    )


def answers_again(pose: RoadPose, made: Sequence[Measurement]) -> list[Answer]:
    """What stored clicks give under a pose, their insets being the same."""
    return answers(pose, [clicked_again(one.values, *one.values.first_clicks) for one in made])


def origin_after(then: MeasurementValues, n: int, contact: Point, target_point: Point) -> dict[str, Any]:
    """How the points of a revision were set that follows another, fields of `Origin`: the same ones as
    before, put elsewhere, or clicked on another frame.
    """
    if n != then.frame:
        return asdict(Origin())
    before = {one.name: getattr(then, one.name) for one in fields(Origin)}
    if contact != then.contact:
        before |= {"snapped_from_x_px": None, "snapped_from_y_px": None}
    return before | {"made": _made_after(then, contact, target_point)}


def _made_after(then: MeasurementValues, contact: Point, target_point: Point) -> Made:
    same = (contact == then.contact, target_point == then.target_point)
    if all(same) or then.made == "clicked" or (then.made == "snapped" and same[0]):
        return then.made
    return "moved"
