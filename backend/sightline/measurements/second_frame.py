"""Which second frame would say most of a height, and where its two points are to be looked for there.

How far the vehicle has come on each frame is seen by following it through its pass; where it cannot be
followed, another measurement of it on two frames gives its speed, and failing that the speeds of usual
traffic are assumed, and said to be. Nothing here is stored: the operator clicks both points.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from sightline.coverage import COVERAGE_95
from sightline.enums import Point, TravelSource
from sightline.errors import BadInput
from sightline.geometry.follow import textured
from sightline.geometry.gain import second_frame_gain
from sightline.geometry.height import measure_height
from sightline.geometry.insets import EITHER_SIDE_M, U_EITHER_SIDE_M
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.travel import BodyTracker, body_of, further_gain
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.measurements.click_context_query import click_context
from sightline.measurements.height_of_clicks import measured_frames
from sightline.measurements.records import Clicks, Measurement, VehicleSheet
from sightline.measurements.service import clicks_in_context, pose_in_force
from sightline.measurements.sheets.query import get_sheet
from sightline.recordings.frames.stills import OpenRecording, stills_of

# Following is for a proposal that is waited for: what is not seen by then goes on at the speed found.
PATIENCE_S = 0.25
ASSUMED_KMH = (30.0, 50.0, 80.0)
_MOST_FRAMES = 60
_MOST_SPOTS = 24
_LEAST_LOOKS = 3  # frames that are followed however long it takes
_EDGE_SHARE = 0.02  # points this close to the border are hard to click
_WORTH = 0.95  # a second frame that leaves more of the uncertainty than this helps nobody
_AS_GOOD = 1.03  # of frames this much alike, the one with the shorter way is the safer


@dataclass(frozen=True, kw_only=True)
class Spot:
    """Where both points are expected on one frame, and what clicking them there would give."""

    frame: int
    travel_m: float
    contact: Point
    target_point: Point
    u_height_m: float
    U95_height_m: float
    u_solved_inset_m: float
    assumed_kmh: float | None = None


@dataclass(frozen=True, kw_only=True)
class Proposal:
    """The frame proposed, or why none would help; `spots` are all frames that could be used, by number."""

    ok: bool
    reason: str | None = None
    frame: int | None = None
    source: TravelSource | None = None
    words: str = ""
    u_now_m: float | None
    U95_now_m: float | None
    u_then_m: float | None = None
    U95_then_m: float | None = None
    u_solved_inset_m: float | None = None
    spots: tuple[Spot, ...] = ()


@dataclass(frozen=True)
class Travels:
    """How far the vehicle has come, m, on frames of its pass; `kmh` where the speed is assumed."""

    by_frame: dict[int, float]
    source: TravelSource
    kmh: float | None = None


def proposal(
    services: Services,
    session: Session,
    recording_id: int,
    clicks: Clicks,
    *,
    vehicle_id: int,
    actor: int | None,
) -> Proposal:
    """The frame that would gain most beside those clicked, of the vehicle's pass.

    Raises NotFound, Conflict without a road pose, BadInput for a vehicle of another recording.
    """
    context = click_context(session, recording_id, actor, vehicle_id=vehicle_id)
    pose, _, _ = pose_in_force(session, context)
    clicks = clicks_in_context(clicks, context)
    if clicks.inset_m is None:
        clicks = replace(clicks, inset_m=EITHER_SIDE_M, u_inset_m=U_EITHER_SIDE_M)
    vehicle = get_sheet(session, vehicle_id)
    if vehicle.recording_id != recording_id:
        raise BadInput("measurements-vehicle-not-recording-choose-one-passes")
    u_now, reason = _now(pose, clicks)
    if u_now is None:
        return refused(reason or "There is no height yet; click contact and target first.")
    opened = stills_of(services).open(recording_id)
    n, taken = clicks.frame, set(clicks.frames)
    span = _span(vehicle, n, len(opened.media))
    known = _known_travels(services, opened, pose, clicks, vehicle, span)
    spots = [
        spot
        for travels in known
        for frame, travel in _in_sight(pose, clicks, travels.by_frame, taken)
        if (spot := _spot(pose, clicks, frame, travel, travels.kmh)) is not None
    ]
    return _chosen(u_now, known[0].source, sorted(spots, key=lambda spot: spot.frame), len(span) > len(taken))


def refused(reason: str, u_now_m: float | None = None) -> Proposal:
    """No frame, and why."""
    U95 = None if u_now_m is None else COVERAGE_95 * u_now_m
    return Proposal(ok=False, reason=reason, u_now_m=u_now_m, U95_now_m=U95)


def _now(pose: RoadPose, clicks: Clicks) -> tuple[float | None, str | None]:
    """The uncertainty of what is clicked so far, or why there is none."""
    if clicks.more_frames:
        height = measured_frames(pose, clicks).height
    else:
        height = measure_height(pose, clicks.contact, clicks.target_point, *clicks.assumed())
    return height.u_height_m, height.reason


def _span(vehicle: VehicleSheet, n: int, frames: int) -> range:
    """The frames of the pass round the one clicked, as many as are worth looking at."""
    first = max(min(vehicle.first_frame, n), n - _MOST_FRAMES, 0)
    last = min(max(vehicle.last_frame, n), n + _MOST_FRAMES, frames - 1)
    return range(first, last + 1)


def _known_travels(
    services: Services,
    opened: OpenRecording,
    pose: RoadPose,
    clicks: Clicks,
    vehicle: VehicleSheet,
    span: range,
) -> list[Travels]:
    """The best that is known of the vehicle's travel: one answer, or one for each speed assumed."""
    n, times = clicks.frame, opened.time_s
    own = list(zip(clicks.frames, clicks.contacts, strict=True))
    speed = _speed(pose, times, own)
    if speed is None:
        seen = follow(services, opened, pose, clicks, n, span)
        if seen:
            return [Travels(seen, "followed")]
        others = (_clicked_on(one) for one in vehicle.measurements if one.values.more_frames)
        speed = next((v for other in others if (v := _speed(pose, times, other)) is not None), None)
    if speed is not None:
        return [Travels(_at_speed(times, n, span, speed), "measured")]
    signs = (
        (-1.0,) if vehicle.direction == "left" else (1.0,) if vehicle.direction == "right" else (1.0, -1.0)
    )
    speeds = ASSUMED_KMH if len(signs) == 1 else ASSUMED_KMH[1:2]
    return [
        Travels(_at_speed(times, n, span, sign * kmh / 3.6), "assumed", kmh)
        for sign in signs
        for kmh in speeds
    ]


def _clicked_on(one: Measurement) -> list[tuple[int, Point]]:
    return list(zip(one.values.frames, one.values.contacts, strict=True))


def _speed(
    pose: RoadPose, times: npt.NDArray[np.float64], clicked_on: Sequence[tuple[int, Point]]
) -> float | None:
    """Along the road's X, from the contacts on the first and the last frame; None where one says nothing."""
    (n, first), (m, last) = min(clicked_on), max(clicked_on)
    a, b = road_point(pose, first), road_point(pose, last)
    if n == m or isinstance(a, str) or isinstance(b, str) or times[m] <= times[n]:
        return None
    return float((b[0] - a[0]) / (times[m] - times[n]))


def _at_speed(times: npt.NDArray[np.float64], n: int, span: range, speed_mps: float) -> dict[int, float]:
    return {frame: speed_mps * float(times[frame] - times[n]) for frame in span if frame != n}


def follow(
    services: Services, opened: OpenRecording, pose: RoadPose, clicks: Clicks, n: int, span: range
) -> dict[int, float]:
    """How far the vehicle has come on each frame of the span, seen in the pictures; empty where not seen.

    Frames that could not be looked at in time, or on which it was lost, go on at the speed seen last.
    """
    recording_id = opened.recording.id
    until = time.monotonic() + PATIENCE_S
    gray = stills_of(services).gray(recording_id, n)
    spots = textured(gray, _box(clicks, gray.shape))
    body = body_of(pose, clicks.contact, clicks.target_point, clicks.assumed()[1], spots)
    if isinstance(body, str) or len(body.points_m) < 5:
        return {}
    pixels = np.concatenate([[clicks.contact, clicks.target_point], spots])
    found: dict[int, float] = {}
    speed: float | None = None
    for way in _ways(n, span):
        chase, before = BodyTracker(pose, body, pixels, gray, speed), n
        for frame in way:
            dt_s = float(opened.time_s[frame] - opened.time_s[before])
            travel = None
            if time.monotonic() < until or len(found) < _LEAST_LOOKS:
                travel = chase.step(stills_of(services).gray(recording_id, frame), dt_s)
            if travel is None:
                break
            found[frame], before, speed = travel, frame, chase.speed_mps
    return _completed(found, opened.time_s, n, span)


def _ways(n: int, span: range) -> Iterator[range]:
    """From the frame clicked on to both ends of the span, the longer way first: it shows the speed best."""
    ways = [range(n + 1, span.stop), range(n - 1, span.start - 1, -1)]
    yield from sorted(ways, key=len, reverse=True)


def _completed(
    found: dict[int, float], times: npt.NDArray[np.float64], n: int, span: range
) -> dict[int, float]:
    """The frames in between and beyond, at the speed of what was seen."""
    if not found:
        return {}
    known = sorted({n: 0.0, **found}.items())
    t = np.array([times[frame] for frame, _ in known])
    x = np.array([travel for _, travel in known])
    speed = float((x[-1] - x[0]) / (t[-1] - t[0]))
    out = {}
    for frame in span:
        at = float(times[frame])
        inside = float(np.interp(at, t, x))
        beyond = at - float(np.clip(at, t[0], t[-1]))
        if frame != n:
            out[frame] = inside + speed * beyond
    return out


def _box(clicks: Clicks, shape: tuple[int, ...]) -> tuple[float, float, float, float]:
    """Where the vehicle's side is, round contact and target: left, top, right, bottom."""
    (cx, cy), (tx, ty) = clicks.contact, clicks.target_point
    tall = max(abs(cy - ty), 0.05 * shape[0])
    return (
        min(cx, tx) - 0.6 * tall,
        min(cy, ty) + 0.15 * tall,
        max(cx, tx) + 0.6 * tall,
        max(cy, ty) - 0.12 * tall,
    )


def _in_sight(
    pose: RoadPose, clicks: Clicks, travels: dict[int, float], taken: set[int]
) -> list[tuple[int, float]]:
    """(frame, travel) of frames that may show both points: a first look, without any uncertainty."""
    body = body_of(pose, clicks.contact, clicks.target_point, clicks.assumed()[1], np.empty((0, 2)))
    if isinstance(body, str):
        return []
    out = []
    for frame, travel in travels.items():
        there = body.pixels(pose, travel)
        if frame not in taken and np.isfinite(there).all() and pose.camera.inside(there).all():
            out.append((frame, travel))
    # enough to choose from, spread over the way
    return out[:: max(1, -(-len(out) // _MOST_SPOTS))]


def _spot(pose: RoadPose, clicks: Clicks, frame: int, travel_m: float, kmh: float | None) -> Spot | None:
    """The points on that frame and what they would give; None where it does not show them both well."""
    sigma_px, inset_m, u_inset_m = clicks.assumed()
    if clicks.more_frames:
        contacts, targets = np.array(clicks.contacts), np.array(clicks.target_points)
        further = further_gain(pose, contacts, targets, travel_m, sigma_px)
        if further is None:
            return None
        contact, point = further.contact_px, further.target_px
        u, u_inset = further.u_height_m, further.u_inset_m
    else:
        gain = second_frame_gain(
            pose, clicks.contact, clicks.target_point, travel_m, sigma_px, inset_m, u_inset_m
        )
        if gain is None:
            return None
        contact, point, u, u_inset = gain.contact_px, gain.target_px, gain.u_double_m, gain.u_inset_m
    edge = _EDGE_SHARE * pose.camera.width_px
    for x, y in (contact, point):
        if not (
            edge <= x <= pose.camera.width_px - 1 - edge and edge <= y <= pose.camera.height_px - 1 - edge
        ):
            return None
    return Spot(
        frame=frame,
        travel_m=travel_m,
        contact=contact,
        target_point=point,
        u_height_m=u,
        U95_height_m=COVERAGE_95 * u,
        u_solved_inset_m=u_inset,
        assumed_kmh=kmh,
    )


def _chosen(u_now: float, source: TravelSource, spots: list[Spot], more_frames: bool) -> Proposal:
    """The best of the frames, and in words what it rests on."""
    if not more_frames:
        return refused("The pass has no other frame; extend it by its first or last frame.", u_now)
    if not spots:
        return refused("No other frame of the pass shows both points; use a single frame.", u_now)
    usual = [spot for spot in spots if spot.assumed_kmh in (None, ASSUMED_KMH[1])] or spots
    least = min(spot.u_height_m for spot in usual)
    best = min(
        (spot for spot in usual if spot.u_height_m <= _AS_GOOD * least), key=lambda spot: abs(spot.travel_m)
    )
    if best.u_height_m > _WORTH * u_now:
        now, then = (1000 * COVERAGE_95 * u for u in (u_now, best.u_height_m))
        return refused(f"A second frame does not help: {now:.0f} mm now, {then:.0f} mm with it.", u_now)
    return Proposal(
        ok=True,
        frame=best.frame,
        source=source,
        words=_WORDS[source],
        u_now_m=u_now,
        U95_now_m=COVERAGE_95 * u_now,
        u_then_m=best.u_height_m,
        U95_then_m=best.U95_height_m,
        u_solved_inset_m=best.u_solved_inset_m,
        spots=tuple(spots),
    )


_WORDS: dict[TravelSource, str] = {
    "followed": "The vehicle was followed through its pass.",
    "measured": "Its speed is that of the points clicked on two frames.",
    "assumed": (
        "The vehicle could not be followed; its speed is assumed, so look for the points around the marks."
    ),
}
