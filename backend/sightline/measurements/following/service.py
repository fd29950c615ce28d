"""A vehicle followed through its pass from the points confirmed on one frame. Nothing is stored here."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from sightline.enums import FollowedPoint, Point
from sightline.errors import BadInput
from sightline.geometry.follow_pass import FollowedPass, PassFrame, follow_pass
from sightline.geometry.followed_tracks import CONTACT, POINT_NAMES, SECOND, TARGET
from sightline.geometry.insets import EITHER_SIDE_M
from sightline.geometry.road_pose import RoadPose
from sightline.infra.services import Services
from sightline.measurements.click_context_query import click_context_of_vehicle
from sightline.measurements.followed_text import text_of
from sightline.measurements.height_of_clicks import Answer, answer
from sightline.measurements.records import Clicks
from sightline.measurements.service import clicks_in_context, pose_in_force
from sightline.media.video.report import require_clock_of_filming
from sightline.messages.said import Said
from sightline.recordings.frames.stills import stills_of
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.store import proposals_of_vehicle
from sightline.vehicles.store import get_vehicle

APART_PX = 20.0  # two tyres stand farther apart than this
MOST_FRAMES = 90  # to each side of the frame that was confirmed


@dataclass(frozen=True, slots=True, kw_only=True)
class PointOnFrame:
    """Where a point was followed to, px, with the standard uncertainty of both coordinates."""

    frame: int
    point: FollowedPoint
    at: Point
    sigma_px: Point


@dataclass(frozen=True, slots=True, kw_only=True)
class NotFollowed:
    """A point that is not used on a frame, and why."""

    frame: int
    point: FollowedPoint
    reason: Said


@dataclass(frozen=True, slots=True, kw_only=True)
class FollowedAnswer:
    """What was followed and the height of it all, or why nothing can be (then the lists are empty)."""

    reason: Said | None
    points: tuple[PointOnFrame, ...] = ()
    dropped: tuple[NotFollowed, ...] = ()
    height: Answer | None = None


def follow_vehicle(
    services: Services, vehicle_id: int, clicks: Clicks, second: Point | None, *, actor: int
) -> FollowedAnswer:
    """Contact and target of the clicks, and the other tyre `second`, followed through the vehicle's pass.

    Raises NotFound, Conflict without a road pose, BadInput for clicks on further frames, Damaged for a frame
    that fails its checksum.
    """
    pose, whole, followed = _followed(services, vehicle_id, clicks, second, actor)
    if isinstance(followed, Said):
        return FollowedAnswer(reason=followed)
    height = answer(pose, replace(whole, followed=text_of(followed.tracks, followed.following)))
    tracks = followed.tracks
    points = (
        PointOnFrame(frame=int(n), point=POINT_NAMES[int(point)], at=(x, y), sigma_px=(sx, sy))
        for n, point, (x, y), (sx, sy) in zip(
            tracks.frame, tracks.point, tracks.points_px.tolist(), tracks.sigma_px.tolist(), strict=True
        )
    )
    lost = (NotFollowed(frame=one.frame, point=one.point, reason=one.reason) for one in followed.lost)
    return FollowedAnswer(reason=None, points=tuple(points), dropped=tuple(lost), height=height)


def followed_text(
    services: Services, vehicle_id: int, clicks: Clicks, second: Point | None, *, actor: int
) -> str:
    """What a whole pass keeps. Raises as `follow_vehicle`, and BadInput where nothing can be followed."""
    _, _, found = _followed(services, vehicle_id, clicks, second, actor)
    if isinstance(found, Said):
        raise BadInput("measurements-not-followed", reason=found)
    return text_of(found.tracks, found.following)


def _other_tyre(some: Sequence[PointProposal], clicks: Clicks) -> Point | None:
    """The tyre that is proposed on the frame beside the one clicked; none of a vehicle measured free."""
    for proposal in some:
        if proposal.frame != clicks.frame or proposal.withheld or not proposal.point.startswith("contact"):
            continue
        at = proposal.point_px
        if at is not None and math.dist(at, clicks.contact) > APART_PX:
            return at
    return None


def _followed(
    services: Services, vehicle_id: int, clicks: Clicks, second: Point | None, actor: int
) -> tuple[RoadPose, Clicks, FollowedPass | Said]:
    if clicks.more_frames:
        raise BadInput("measurements-followed-and-clicked")
    with services.reading() as session:
        vehicle = get_vehicle(session, vehicle_id)
        context = click_context_of_vehicle(session, vehicle_id, actor, clicks.frames)
        context.frame(clicks.frame)
        pose, _, _ = pose_in_force(session, context)
        whole = clicks_in_context(clicks, context)
        proposed = _other_tyre(proposals_of_vehicle(session, vehicle_id), clicks)
    stills = stills_of(services)
    opened = stills.open(vehicle.recording_id)
    require_clock_of_filming(opened.recording.report.get("clock_doubt"), opened.recording.name)
    first = max(min(vehicle.first_frame, clicks.frame), clicks.frame - MOST_FRAMES)
    last = min(max(vehicle.last_frame, clicks.frame), clicks.frame + MOST_FRAMES, len(opened.media) - 1)
    tick_s = float(Fraction(opened.recording.report.get("time_base", 0)))
    frames = [
        PassFrame(n, float(opened.time_s[n]), stills.gray(vehicle.recording_id, n), tick_s)
        for n in range(first, last + 1)
    ]
    points = {CONTACT: clicks.contact, TARGET: clicks.target_point}
    other = second or proposed
    if other is not None:
        points[SECOND] = other
    inset_m = EITHER_SIDE_M if whole.inset_m is None else whole.inset_m
    found = follow_pass(pose, frames, clicks.frame, points, clicks.target, inset_m, whole.known_sigma_px)
    return pose, whole, found
