"""Self-check of road poses: the direction of travel of a survey's vehicles, and pairs of tyre contacts."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sightline.enums import DirectionSource, Point
from sightline.errors import BadInput, Conflict
from sightline.geometry.multiframe import measure_frames
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.traffic import (
    Heading,
    Headings,
    heading_of_pair,
    headings_of_pairs,
    summary_of_headings,
)
from sightline.infra.database import Session
from sightline.measurements.click_context_query import click_context
from sightline.measurements.height_of_clicks import DEFAULT_SIGMA_PX
from sightline.measurements.records import Measurement, VehicleSheet
from sightline.measurements.road_poses import road_pose
from sightline.measurements.service import pose_in_force
from sightline.measurements.sheets.query import list_sheets
from sightline.measurements.store import list_measurements
from sightline.messages.said import Said
from sightline.poses.store import get_pose
from sightline.quality.checks.records import WheelPair
from sightline.quality.checks.store import add_wheel_pair, list_wheel_pairs
from sightline.quality.checks.turning import Changes, changes_of_heights
from sightline.recordings.frames.store import get_frame
from sightline.recordings.records import Recording
from sightline.recordings.store import list_recordings
from sightline.vehicles.store import get_vehicle

_SAME_TURN_RAD = 1e-6


@dataclass(frozen=True)
class VehicleHeading:
    """A vehicle's direction of travel against the road's X axis, with the u of its own clicks.

    `reason`: why it has none, or is unused.
    """

    vehicle_id: int
    number: int
    recording_id: int
    frame: int
    source: DirectionSource
    used: bool
    heading_rad: float | None = None
    u_heading_rad: float | None = None
    base_m: float | None = None
    reason: Said | None = None


@dataclass(frozen=True, kw_only=True)
class PoseFindings:
    """What the traffic says of a pose in force. `mean_rad` is None where `reason` says why."""

    pose_id: int
    turned_from: int | None
    turned_by_rad: float | None
    vehicles: tuple[VehicleHeading, ...]
    used: int
    mean_rad: float | None = None
    u_mean_rad: float | None = None
    spread_rad: float | None = None
    proposed: bool = False
    reason: Said | None = None
    verdict: tuple[Said, ...] = ()
    changes: Changes | None = None


@dataclass(frozen=True, kw_only=True)
class PoseCheck(PoseFindings):
    """A pose in force against the traffic of its recordings."""

    recordings: tuple[Recording, ...]


#: A vehicle, and the direction that its contacts or two-frame clicks give.
_Told = tuple[VehicleHeading, Heading | Said]


def check_traffic(session: Session, survey_id: int) -> tuple[PoseCheck, ...]:
    """Every pose in force of a survey's recordings, with the headings of their vehicles."""
    ready = [one for one in list_recordings(session, survey_id) if one.state == "ready"]
    passes = list_sheets(session, survey_id)
    pairs = list_wheel_pairs(session, survey_id)
    in_force = sorted({one.pose_id for one in ready if one.pose_id is not None})
    return tuple(check_pose(session, pose_id, ready, passes, pairs) for pose_id in in_force)


@dataclass(frozen=True)
class Turn:
    """The turn that the traffic proposes for a pose, and what it would change."""

    turn_rad: float
    u_turn_rad: float
    vehicles: int
    recordings: tuple[Recording, ...]
    changes: Changes


def turn_of(session: Session, pose_id: int, seen_rad: float | None = None) -> Turn:
    """The turn of a pose in force.

    Raises NotFound, BadInput where the traffic gives none, Conflict where no recording uses the pose or the
    turn is not the one that was seen.
    """
    survey_id = get_pose(session, pose_id).survey_id
    at = next((one for one in check_traffic(session, survey_id) if one.pose_id == pose_id), None)
    if at is None:
        raise Conflict("quality-pose-unused")
    if at.reason is not None:
        raise BadInput(at.reason.code, **at.reason.values)
    assert at.mean_rad is not None and at.u_mean_rad is not None and at.changes is not None
    if seen_rad is not None and abs(seen_rad - at.mean_rad) > _SAME_TURN_RAD:
        raise Conflict("quality-direction-changed", turn_deg=format(np.rad2deg(at.mean_rad), "+.2f"))
    return Turn(at.mean_rad, at.u_mean_rad, at.used, at.recordings, at.changes)


def check_pose(
    session: Session,
    pose_id: int,
    ready: Sequence[Recording],
    passes: Sequence[VehicleSheet],
    pairs: Sequence[WheelPair],
) -> PoseCheck:
    pose = road_pose(session, pose_id)
    users = tuple(one for one in ready if one.pose_id == pose_id)
    ids = {one.id for one in users}
    headings = _headings(
        pose, [v for v in passes if v.recording_id in ids], [p for p in pairs if p.recording_id in ids]
    )
    good = [found for _, found in headings if isinstance(found, Heading)]
    summary = summary_of_headings(pose, good)
    used = iter(summary.used if isinstance(summary, Headings) else [True] * len(good))
    shown = tuple(
        _vehicle_heading(of, found, isinstance(found, Heading) and bool(next(used))) for of, found in headings
    )
    stored = get_pose(session, pose_id)
    check = PoseCheck(
        pose_id=pose_id,
        recordings=users,
        turned_from=stored.turned_from,
        turned_by_rad=stored.turned_by_rad,
        vehicles=shown,
        used=len(good),
    )
    if isinstance(summary, Said):
        return replace(check, reason=summary, verdict=(summary,))
    standing = [
        one
        for one in list_measurements(session, stored.survey_id)
        if one.recording_id in ids and one.values.pose_id == pose_id
    ]
    changes = changes_of_heights(pose, summary.mean_rad, standing)
    return replace(
        check,
        used=int(summary.used.sum()),
        mean_rad=summary.mean_rad,
        u_mean_rad=summary.u_mean_rad,
        spread_rad=summary.spread_rad,
        proposed=summary.proposed,
        verdict=_verdict(summary, changes),
        changes=changes,
    )


def _headings(pose: RoadPose, passes: Sequence[VehicleSheet], pairs: Sequence[WheelPair]) -> list[_Told]:
    """One heading a vehicle, by number: from its tyre contacts, else from its best two-frame measurement."""
    solved = headings_of_pairs(
        pose, [one.first for one in pairs], [one.second for one in pairs], DEFAULT_SIGMA_PX
    )
    by_vehicle: dict[int, _Told] = {}
    for pair, found in zip(pairs, solved, strict=True):
        of = VehicleHeading(
            pair.vehicle_id, pair.vehicle_number, pair.recording_id, pair.frame, "tyres", used=False
        )
        by_vehicle[of.vehicle_id] = of, found
    for vehicle in passes:
        if vehicle.id in by_vehicle and isinstance(by_vehicle[vehicle.id][1], Heading):
            continue
        best = _from_frames(pose, vehicle.measurements)
        if best is not None:
            place = vehicle.id, vehicle.number, vehicle.recording_id, best[0]
            by_vehicle[vehicle.id] = VehicleHeading(*place, "two_frames", used=False), best[1]
    return sorted(by_vehicle.values(), key=lambda told: told[0].number)


def _from_frames(pose: RoadPose, made: Sequence[Measurement]) -> tuple[int, Heading] | None:
    """The heading that two-frame clicks solve for, nothing being known of it before."""
    best: tuple[int, Heading] | None = None
    for measurement in made:
        if not measurement.values.more_frames or measurement.review.verdict == "rejected":
            continue
        values = measurement.values
        solved = measure_frames(pose, values.contacts, values.target_points, values.sigma_px, None)
        if solved.heading_rad is None or solved.heading_parts is None or solved.travel_m is None:
            continue
        heading = Heading(solved.heading_rad, solved.heading_parts, solved.travel_m)
        if best is None or heading.u_heading_rad < best[1].u_heading_rad:
            best = measurement.values.frame, heading
    return best


def _vehicle_heading(of: VehicleHeading, found: Heading | Said, used: bool) -> VehicleHeading:
    if isinstance(found, Said):
        return replace(of, reason=found)
    return replace(
        of,
        used=used,
        heading_rad=found.heading_rad,
        u_heading_rad=found.u_heading_rad,
        base_m=found.base_m,
        reason=None if used else Said("heading-outlier"),
    )


def _verdict(headings: Headings, changes: Changes) -> tuple[Said, ...]:
    """How the axes lie against the traffic, and what it matters."""
    mean_deg = round(abs(float(np.rad2deg(headings.mean_rad))), 2)
    u_deg, count = round(float(np.rad2deg(headings.u_mean_rad)), 2), int(headings.used.sum())
    axes = (
        Said("traffic-turned", mean_deg=mean_deg, u_deg=u_deg, count=count)
        if headings.proposed
        else Said("traffic-agrees", mean_deg=mean_deg, u_deg=u_deg, count=count)
    )
    if not changes.count:
        return (axes,)
    largest_m = round(changes.largest_m, 4)
    if not headings.proposed:
        return axes, Said("traffic-turn-would-change", largest_m=largest_m)
    return axes, Said("traffic-turn-changes", count=changes.count, largest_m=largest_m)


def store_pair(
    session: Session,
    vehicle_id: int,
    *,
    frame: int,
    frame_crc32: int | None,
    first: Point,
    second: Point,
    seen: int | None = None,
    actor: int,
) -> WheelPair:
    """Store both tyre contacts of a vehicle on one frame, in place of the pair before.

    Raises NotFound, Conflict without a road pose, for another picture or another pair than `seen`, BadInput,
    saying why, for clicks that give no direction (the sky, contacts closer than a metre).
    """
    vehicle = get_vehicle(session, vehicle_id)
    pose, _, _ = pose_in_force(session, click_context(session, vehicle.recording_id, actor))
    found = heading_of_pair(pose, first, second)
    if isinstance(found, Said):
        raise BadInput(found.code, **found.values)
    if not vehicle.first_frame <= frame <= vehicle.last_frame:
        raise BadInput(
            "quality-frame-outside-pass",
            frame=frame,
            number=vehicle.number,
            first_frame=vehicle.first_frame,
            last_frame=vehicle.last_frame,
        )
    stored = get_frame(session, vehicle.recording_id, frame).crc32 if frame_crc32 is None else frame_crc32
    return add_wheel_pair(
        session,
        vehicle_id,
        frame=frame,
        frame_crc32=stored,
        first=first,
        second=second,
        seen=seen,
        actor=actor,
    )
