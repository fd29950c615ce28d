"""Which second frame would say most of a height, and where its two points are to be looked for there.

How far the vehicle has come on each frame is seen by following it through its pass; where it cannot be
followed, another measurement of it on two frames gives its speed, and failing that the speeds of usual
traffic are assumed, and said to be. Nothing here is stored: the operator clicks both points.
"""

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from sightline.coverage import COVERAGE_95
from sightline.enums import Point, Target, TravelSource
from sightline.errors import BadInput
from sightline.geometry.follow import find_textured_spots
from sightline.geometry.gain import second_frame_gain
from sightline.geometry.height import measure_height
from sightline.geometry.insets import EITHER_SIDE_M, U_EITHER_SIDE_M
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.travel import BodyTracker, body_of, further_gain
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.measurements.click_context_query import click_context
from sightline.measurements.height_of_clicks import measured_frames
from sightline.measurements.records import Clicks, Measurement, VehicleSheet
from sightline.measurements.service import clicks_in_context, pose_in_force
from sightline.measurements.sheets.query import get_sheet
from sightline.messages.said import Said
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
class FrameForTarget:
    """The frame proposed for a target, or why none would help; `spots`: all that could be used, by number."""

    target: Target
    ok: bool
    reason: Said | None = None
    frame: int | None = None
    u_now_m: float | None = None
    U95_now_m: float | None = None
    u_then_m: float | None = None
    U95_then_m: float | None = None
    u_solved_inset_m: float | None = None
    spots: tuple[Spot, ...] = ()


@dataclass(frozen=True, kw_only=True)
class Proposal(FrameForTarget):
    """That of the target asked about, what it rests on, and those of the others, as they were asked about."""

    source: TravelSource | None = None
    words: Said | None = None
    others: tuple[FrameForTarget, ...] = ()


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A target and the frames that show it with its contact. `u_now_m`: of its height so far, None without
    one, for the `reason`; `sure`: frames of `spots` that show both whatever speed is assumed.
    """

    target: Target
    u_now_m: float | None
    reason: Said | None = None
    spots: tuple[Spot, ...] = ()
    sure: frozenset[int] = frozenset()

    @property
    def helpful(self) -> dict[int, Spot]:
        """By frame what makes the height notably better there."""
        best: dict[int, Spot] = {}
        for spot in self.spots:
            usual = spot.assumed_kmh in (None, ASSUMED_KMH[1])
            known = best.get(spot.frame)
            if usual and spot.frame in self.sure and (known is None or spot.u_height_m < known.u_height_m):
                best[spot.frame] = spot
        most = _WORTH * (self.u_now_m or 0.0)
        return {frame: spot for frame, spot in best.items() if spot.u_height_m <= most}


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
    others: Sequence[Clicks] = (),
    *,
    vehicle_id: int,
    actor: int | None,
) -> Proposal:
    """The frame that would gain most beside those clicked, of the vehicle's pass; `others`: targets on the
    same frame and contact, for all of which one frame is chosen where it can be.

    Raises NotFound, Conflict without a road pose, BadInput for a vehicle of another recording.
    """
    context = click_context(session, recording_id, actor, vehicle_id=vehicle_id)
    pose, _, _ = pose_in_force(session, context)
    asked = [_with_an_inset(clicks_in_context(one, context)) for one in (clicks, *others)]
    vehicle = get_sheet(session, vehicle_id)
    if vehicle.recording_id != recording_id:
        raise BadInput("measurements-vehicle-other-recording")
    now = [_current_u_m(pose, one) for one in asked]
    first = next((one for one, (u_m, _) in zip(asked, now, strict=True) if u_m is not None), None)
    if first is None:
        return _make_proposal([_refuse_target(one.target, *of) for one, of in zip(asked, now, strict=True)])
    opened = stills_of(services).open(recording_id)
    span = _span(vehicle, first.frame, len(opened.media))
    known = _known_travels(services, opened, pose, first, vehicle, span)
    candidates = candidates_of(pose, asked, now, known)
    frames = chosen_frames(candidates)
    found = [
        _offered(one, frame, len(span) > len(set(of.frames)))
        for one, frame, of in zip(candidates, frames, asked, strict=True)
    ]
    return _make_proposal(found, known[0].source)


def _with_an_inset(clicks: Clicks) -> Clicks:
    """An eye of unknown side is looked for where either side has it."""
    if clicks.inset_m is not None:
        return clicks
    return replace(clicks, inset_m=EITHER_SIDE_M, u_inset_m=U_EITHER_SIDE_M)


def candidates_of(
    pose: RoadPose,
    asked: Sequence[Clicks],
    now: Sequence[tuple[float | None, Said | None]],
    known: Sequence[Travels],
) -> list[Candidate]:
    """Where each of the targets could be clicked again; `now`: the uncertainty of each so far, or why there
    is none. Of many frames some are looked at closely: the same ones of all, and as many that show them all.
    """
    in_sight = [[_in_sight(pose, one, travels.by_frame) for travels in known] for one in asked]
    sure = [frozenset.intersection(*of_one) or of_one[_usual(known)] for of_one in in_sight]
    shown = [one for one, (u_m, _) in zip(sure, now, strict=True) if one and u_m is not None]
    for_all = frozenset.intersection(*shown) if shown else frozenset()
    step = -(-max(map(len, sure)) // _MOST_SPOTS) or 1
    out = []
    for clicks, of_one, certain, (u_m, reason) in zip(asked, in_sight, sure, now, strict=True):
        some = {frame for frame in certain if frame % step == 0} or _thinned(certain)
        close = frozenset(some) | _thinned(for_all) if u_m is not None else frozenset()
        spots = [
            spot
            for travels, visible in zip(known, of_one, strict=True)
            for frame in sorted(close & visible)
            if (spot := _spot(pose, clicks, frame, travels.by_frame[frame], travels.kmh)) is not None
        ]
        spots.sort(key=lambda spot: spot.frame)
        out.append(
            Candidate(target=clicks.target, u_now_m=u_m, reason=reason, spots=tuple(spots), sure=certain)
        )
    return out


def _usual(known: Sequence[Travels]) -> int:
    """Which of the travels counts where one has to."""
    return next((at for at, one in enumerate(known) if one.kmh == ASSUMED_KMH[1]), 0)


def _thinned(frames: frozenset[int]) -> frozenset[int]:
    """Enough to choose from, spread over the way."""
    return frozenset(sorted(frames)[:: max(1, -(-len(frames) // _MOST_SPOTS))])


def chosen_frames(candidates: Sequence[Candidate]) -> list[int | None]:
    """The frame for each, as few of them as can be: one frame for those that it leaves half of what their own
    best would gain, the frame that serves most of them first. None: no frame helps it.
    """
    helpful = [one.helpful for one in candidates]
    waiting = {
        at: set(_serving(one, frames))
        for at, (one, frames) in enumerate(zip(candidates, helpful, strict=True))
        if frames
    }
    chosen: list[int | None] = [None] * len(candidates)
    while waiting:
        served = {n: [at for at in waiting if n in waiting[at]] for n in set.union(*waiting.values())}
        most = max(map(len, served.values()))
        rated = {
            n: _together([(candidates[at], helpful[at][n]) for at in those])
            for n, those in served.items()
            if len(those) == most
        }
        frame = _best(rated)
        for at in served[frame]:
            chosen[at] = frame
            del waiting[at]
    return chosen


def _serving(one: Candidate, frames: dict[int, Spot]) -> list[int]:
    least = min(spot.u_height_m for spot in frames.values())
    most = ((one.u_now_m or 0.0) + least) / 2
    return [frame for frame, spot in frames.items() if spot.u_height_m <= most]


def _together(those: Sequence[tuple[Candidate, Spot]]) -> tuple[float, float]:
    """What a frame leaves of the uncertainties on average, and how far the vehicle has come there."""
    left = [spot.u_height_m / (one.u_now_m or 1.0) for one, spot in those]
    return sum(left) / len(left), abs(those[0][1].travel_m)


def _best(rated: dict[int, tuple[float, float]]) -> int:
    """Of (uncertainty, way) by frame: of those about as good as the best, the one with the shortest way."""
    least = min(u for u, _ in rated.values())
    return min((n for n in rated if rated[n][0] <= _AS_GOOD * least), key=lambda n: (rated[n][1], n))


def _refuse_target(target: Target, u_now_m: float | None, reason: Said | None) -> FrameForTarget:
    U95 = None if u_now_m is None else COVERAGE_95 * u_now_m
    reason = reason or Said("second-frame-no-height")
    return FrameForTarget(target=target, ok=False, reason=reason, u_now_m=u_now_m, U95_now_m=U95)


def _make_proposal(found: Sequence[FrameForTarget], source: TravelSource | None = None) -> Proposal:
    first, *others = found
    said = filled_from(Proposal, first, source=None, words=None, others=tuple(others))
    if source is None or not any(one.ok for one in found):
        return said
    return replace(said, source=source, words=_WORDS[source])


def _current_u_m(pose: RoadPose, clicks: Clicks) -> tuple[float | None, Said | None]:
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
    if n == m or isinstance(a, Said) or isinstance(b, Said) or times[m] <= times[n]:
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
    spots = find_textured_spots(gray, _box(clicks, gray.shape))
    body = body_of(pose, clicks.contact, clicks.target_point, clicks.assumed()[1], spots)
    if isinstance(body, Said) or len(body.points_m) < 5:
        return {}
    pixels = np.concatenate([[clicks.contact, clicks.target_point], spots])
    travels: dict[int, float] = {}
    speed: float | None = None
    for way in _ways(n, span):
        chase, before = BodyTracker(pose, body, pixels, gray, speed), n
        for frame in way:
            dt_s = float(opened.time_s[frame] - opened.time_s[before])
            travel = None
            if time.monotonic() < until or len(travels) < _LEAST_LOOKS:
                travel = chase.step(stills_of(services).gray(recording_id, frame), dt_s)
            if travel is None:
                break
            travels[frame], before, speed = travel, frame, chase.speed_mps
    return _completed(travels, opened.time_s, n, span)


def _ways(n: int, span: range) -> Iterator[range]:
    """From the frame clicked on to both ends of the span, the longer way first: it shows the speed best."""
    ways = [range(n + 1, span.stop), range(n - 1, span.start - 1, -1)]
    yield from sorted(ways, key=len, reverse=True)


def _completed(
    travels: dict[int, float], times: npt.NDArray[np.float64], n: int, span: range
) -> dict[int, float]:
    """The frames in between and beyond, at the speed of what was seen."""
    if not travels:
        return {}
    known = sorted({n: 0.0, **travels}.items())
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


def _in_sight(pose: RoadPose, clicks: Clicks, travels: dict[int, float]) -> frozenset[int]:
    """Frames that show both points, not too near the border, and are not clicked: without uncertainty."""
    body = body_of(pose, clicks.contact, clicks.target_point, clicks.assumed()[1], np.empty((0, 2)))
    if isinstance(body, Said):
        return frozenset()
    taken = set(clicks.frames)
    return frozenset(
        frame
        for frame, travel in travels.items()
        if frame not in taken and _well_inside(pose, body.pixels(pose, travel))
    )


def _well_inside(pose: RoadPose, points_px: npt.ArrayLike) -> bool:
    """Whether points (N, 2) lie in the picture and away from its border, where they are hard to click."""
    camera, points = pose.camera, np.asarray(points_px, dtype=np.float64)
    if not np.isfinite(points).all():
        return False
    edge = _EDGE_SHARE * camera.width_px
    most = np.array([camera.width_px - 1 - edge, camera.height_px - 1 - edge])
    return bool(((points >= edge) & (points <= most)).all())


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
    if not _well_inside(pose, (contact, point)):
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


def _offered(candidate: Candidate, frame: int | None, more_frames: bool) -> FrameForTarget:
    """The frame with what it would give, or in words why none does."""
    if candidate.u_now_m is None:
        return _refuse_target(candidate.target, None, candidate.reason)
    if not more_frames:
        return _refuse_target(candidate.target, candidate.u_now_m, Said("second-frame-no-other"))
    if not candidate.spots:
        return _refuse_target(candidate.target, candidate.u_now_m, Said("second-frame-not-shown"))
    if frame is None:
        least = min(spot.u_height_m for spot in candidate.spots)
        now_m, then_m = (round(COVERAGE_95 * u, 3) for u in (candidate.u_now_m, least))
        return _refuse_target(
            candidate.target, candidate.u_now_m, Said("second-frame-no-gain", now_m=now_m, then_m=then_m)
        )
    best = candidate.helpful[frame]
    return FrameForTarget(
        target=candidate.target,
        ok=True,
        frame=frame,
        u_now_m=candidate.u_now_m,
        U95_now_m=COVERAGE_95 * candidate.u_now_m,
        u_then_m=best.u_height_m,
        U95_then_m=best.U95_height_m,
        u_solved_inset_m=best.u_solved_inset_m,
        spots=candidate.spots,
    )


_WORDS: dict[TravelSource, Said] = {
    "followed": Said("second-frame-followed"),
    "measured": Said("second-frame-measured"),
    "assumed": Said("second-frame-assumed"),
}
