"""What a person would click of a passing vehicle, proposed from several frames of its pass.

The wheels tell where the vehicle stands on every frame and how long its wheelbase is. The frames are laid
out on a vertical plane along the road and averaged where the vehicle is: it stays sharp while what is behind
it smears, and noise goes down. Roof and rear lamp are looked for in that one picture, and again in the halves
of the frames: how far those differ is part of the predicted error. Nothing here is a measurement.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from sightline.enums import Direction, ProposedPoint, WheelEnd
from sightline.geometry.arrays import Floats
from sightline.geometry.height import measure_height
from sightline.geometry.road_pose import RoadPose
from sightline.proposals.lamps import taillight_of
from sightline.proposals.roof import Place, body_of, roof_of
from sightline.proposals.side_view import Bgr, Plane, SideView, averaged, pixel_of, side_view
from sightline.proposals.wheels import Box, Wheel, Wheels, wheels_on

POINTS: tuple[ProposedPoint, ...] = get_args(ProposedPoint)
TARGETS: tuple[ProposedPoint, ...] = ("roof", "taillight")
PLANES_M: dict[str, float] = {"roof": 0.25, "taillight": 0.10}
LEAST_FRAMES = 3
BEHIND_M, BEFORE_M, TOP_M = 2.6, 2.3, 4.2
STRAY_M = 0.06
EDGE_PX = 6.0
# What a point is off by beside the differences of both halves. Set by judgement after site 303 of the bench,
# not fitted: no full run of bench_proposals --training was made.
REST_PX: dict[str, float] = {"roof": 0.3, "taillight": 0.7}
_PARTS = (slice(None), slice(0, None, 2), slice(1, None, 2))
MOST_APART_M = 0.03
NO_REAR = "proposals-rear-not-in-view"
NOT_ONE_VEHICLE = "proposals-not-one-vehicle"
BY_HAND: dict[ProposedPoint, str] = {
    "headlight": "proposals-headlight-by-hand",
    "driver_eye": "proposals-eye-by-hand",
}


@dataclass(frozen=True, eq=False)
class FrameSeen:
    """Frame n: `picture` (H, W, 3) BGR, `gray` (H, W), `change` (H, W) against the empty road over its
    tolerance, and the vehicle's box there (left, top, right, bottom), px.
    """

    n: int
    picture: Bgr
    gray: NDArray[np.uint8]
    change: Plane
    box: Box


@dataclass(frozen=True)
class Proposed:
    """A point on the best frame, px, and its predicted standard error; `expected_m` of its height, from its
    own and the contact's error, None for a contact.
    """

    point_px: tuple[float, float]
    expected_px: float
    expected_m: float | None


@dataclass(frozen=True)
class Proposals:
    """What is proposed of a vehicle on `frame`, seen on `frames` frames; of each point a place, or why there
    is none, as a key of the catalogue of messages. `wheelbase_m` None: only one wheel was seen.
    """

    frame: int
    frames: int
    wheelbase_m: float | None
    points: Mapping[ProposedPoint, Proposed | str]


@dataclass(frozen=True, eq=False)
class _Motion:
    """Where the rear wheel (or the only one) stands on frame n: X = `x_m` + `step_m` (n - `n0`)."""

    x_m: float
    step_m: float
    n0: int
    y_m: float
    wheelbase_m: float | None
    only: WheelEnd | None
    used: tuple[int, ...]

    def at(self, n: int) -> float:
        return self.x_m + self.step_m * (n - self.n0)


def propose_points(
    seen: Sequence[FrameSeen], pose: RoadPose, direction: Direction, usual_frame: int
) -> Proposals | str:
    """All that can be proposed of a vehicle that goes in `direction` through the frames `seen`; or the key
    (of the catalogue of messages) of why nothing can. `usual_frame`: where it is best seen, as far as known.

    Own method, as the module says.
    """
    ahead = 1 if direction == "right" else -1
    found: dict[int, Wheels] = {}
    for one in sorted(seen, key=lambda frame: abs(frame.n - usual_frame)):
        expected = _expected(found, one, pose, ahead)
        pair = wheels_on(one.gray, one.change > 1, pose, one.box, direction, expected)
        if isinstance(pair, Wheels):
            found[one.n] = pair
    if len(found) < LEAST_FRAMES:
        return "proposals-wheels-on-few-frames"
    motion = _motion(found, ahead)
    if isinstance(motion, str):
        return motion
    used = [one for one in seen if one.n in motion.used]
    places = _places(used, pose, motion, ahead)
    return _on_best_frame(used, pose, motion, found, places, usual_frame)


def _expected(
    found: Mapping[int, Wheels], one: FrameSeen, pose: RoadPose, ahead: int
) -> list[tuple[float, float]] | None:
    """Where two frames with both wheels say that they stand on a third, px; None where they do not say."""
    pairs = [(n, pair) for n, pair in found.items() if pair.rear is not None and pair.front is not None]
    if len(pairs) < 2:
        return None
    (n0, first), (n1, second) = pairs[0], pairs[1]
    assert first.rear and first.front and second.rear and second.front
    base = first.front.x_m - first.rear.x_m
    step = (second.rear.x_m - first.rear.x_m) / (n1 - n0)
    if abs(second.front.x_m - second.rear.x_m - base) > STRAY_M or ahead * step <= 0:
        return None
    rear = first.rear.x_m + step * (one.n - n0)
    at = [pixel_of(pose, x, first.y_m, 0.0) for x in (rear, rear + base)]
    return [point for point in at if _inside(point, one.gray)]


def _motion(found: Mapping[int, Wheels], ahead: int) -> _Motion | str:
    """The straight, even motion that most wheels agree on."""
    bases = [abs(p.front.x_m - p.rear.x_m) for p in found.values() if p.front and p.rear]
    base = float(np.median(bases)) if bases else None
    if base is not None:
        near = sum(abs(one - base) < STRAY_M for one in bases)
        base = base if near * 2 > len(bases) else None
    only = _only(found) if base is None else None
    at = _stands(found, ahead, base, only)
    line = _line(at[:, 0], at[:, 1])
    if line is None:
        return NOT_ONE_VEHICLE
    start, step, keep = line
    used = tuple(sorted({int(n) for n in at[keep, 0]}))
    if ahead * step <= 0:
        return NOT_ONE_VEHICLE
    return _Motion(
        x_m=start,
        step_m=step,
        n0=int(at[0, 0]),
        y_m=float(np.median(at[keep, 2])),
        wheelbase_m=base,
        only=only,
        used=used,
    )


def _stands(found: Mapping[int, Wheels], ahead: int, base: float | None, only: WheelEnd | None) -> Floats:
    """Frame, X and Y (k, 3) of the rear wheel, also by way of the front one; of the only end where one is."""
    at: list[tuple[float, float, float]] = []
    for n, pair in found.items():
        if pair.rear is not None and only != "front":
            at.append((n, pair.rear.x_m, pair.rear.y_m))
        if pair.front is not None and only != "rear" and (base is not None or only == "front"):
            at.append((n, pair.front.x_m - ahead * (base or 0.0), pair.front.y_m))
    return np.array(at, dtype=np.float64).reshape(-1, 3)


def _only(found: Mapping[int, Wheels]) -> WheelEnd:
    rears = sum(pair.rear is not None for pair in found.values())
    return "rear" if rears * 2 >= len(found) else "front"


def _line(n: Floats, x: Floats) -> tuple[float, float, NDArray[np.bool_]] | None:
    """X at the first n, step a frame, and which agree: the line through two of them that most lie on."""
    if len(np.unique(n)) < LEAST_FRAMES:
        return None
    best: NDArray[np.bool_] = np.zeros(len(n), np.bool_)
    for i in range(len(n)):
        for j in range(i + 1, len(n)):
            if n[i] == n[j]:
                continue
            step = (x[j] - x[i]) / (n[j] - n[i])
            on = np.abs(x - x[i] - step * (n - n[i])) < STRAY_M
            best = on if on.sum() > best.sum() else best
    if len(np.unique(n[best])) < LEAST_FRAMES or best.sum() * 2 < len(n):
        return None
    step, start = np.polyfit(n[best] - n[0], x[best], 1)
    return float(start), float(step), best


@dataclass(frozen=True)
class _Found:
    """A place relative to the rear wheel (or the only one), and what two halves of the frames differ by."""

    place: Place
    apart_m: float


def _places(
    used: Sequence[FrameSeen], pose: RoadPose, motion: _Motion, ahead: int
) -> dict[str, _Found | str]:
    insets = set(PLANES_M.values())
    laid = {inset: [_laid(one, pose, motion, ahead, inset) for one in used] for inset in insets}
    whole, *halves = (_looked(laid, part, pose, motion, ahead) for part in _PARTS)
    out: dict[str, _Found | str] = {}
    for name, place in whole.items():
        parts = [half[name] for half in halves]
        if isinstance(place, str):
            out[name] = place
            continue
        known = [part.z_m for part in parts if isinstance(part, Place)]
        apart_m = max((abs(z - place.z_m) for z in known), default=0.0)
        if len(known) < len(halves) or apart_m > MOST_APART_M:
            out[name] = "proposals-halves-disagree"
        else:
            out[name] = _Found(place, apart_m)
    return out


def _looked(
    laid: Mapping[float, Sequence[SideView]], part: slice, pose: RoadPose, motion: _Motion, ahead: int
) -> dict[str, Place | str]:
    views = {inset: averaged(some[part]) for inset, some in laid.items()}
    base = ahead * (motion.wheelbase_m or 0.0)
    between = (min(0.0, base) - 0.3, max(0.0, base) + 0.3)
    view = views[PLANES_M["roof"]]
    body = body_of(view, between)
    out: dict[str, Place | str] = {"roof": roof_of(view, body)}
    roof = out["roof"]
    if isinstance(roof, Place) and roof.z_m < float(pose.centre_m[2]) - 0.02:
        out["roof"] = "proposals-roof-from-above"
    view = views[PLANES_M["taillight"]]
    body = body_of(view, between)
    end = None if motion.only == "front" else _end(view, body, -ahead)
    out["taillight"] = NO_REAR if end is None else taillight_of(view, body, end, ahead)
    return out


def _end(view: SideView, body: NDArray[np.bool_], way: int) -> float | None:
    """X of the body's last column that way, at half a metre to one metre up; None where it is cut off."""
    rows = slice(view.row(0.5), view.row(0.95) + 1)
    columns = np.flatnonzero(body[rows].mean(axis=0) > 0.5)
    if len(columns) == 0:
        return None
    last = int(columns[-1] if way > 0 else columns[0])
    beyond = np.clip(last + way * 6, 0, body.shape[1] - 1)
    return view.x_m(last) if view.seen[rows, beyond].mean() > 0.9 else None


def _laid(one: FrameSeen, pose: RoadPose, motion: _Motion, ahead: int, inset_m: float) -> SideView:
    """A frame laid out about the vehicle; X from its rear wheel (or the only one)."""
    low = -BEHIND_M if motion.only != "front" else -7.0
    high = (motion.wheelbase_m or 0.0) + BEFORE_M if motion.only != "rear" else 7.0
    low, high = (low, high) if ahead > 0 else (-high, -low)
    x = motion.at(one.n)
    view = side_view(one.picture, one.change, pose, motion.y_m + inset_m, (x + low, x + high), (-0.1, TOP_M))
    return replace(view, left_m=low)


def _on_best_frame(
    used: Sequence[FrameSeen],
    pose: RoadPose,
    motion: _Motion,
    found: Mapping[int, Wheels],
    places: Mapping[str, _Found | str],
    usual_frame: int,
) -> Proposals:
    def pixel(name: str, n: int) -> tuple[float, float] | None:
        place = places[name]
        if isinstance(place, str):
            return None
        at = place.place
        return pixel_of(pose, motion.at(n) + at.x_m, motion.y_m + PLANES_M[name], at.z_m)

    def score(one: FrameSeen) -> tuple[int, float]:
        inside = [p for name in places if (p := pixel(name, one.n)) and _inside(p, one.gray)]
        return len(inside) + len(found[one.n].found), -abs(one.n - usual_frame)

    best = max(used, key=score)
    pair = found[best.n]
    points: dict[ProposedPoint, Proposed | str] = {}
    for contact, wheel in (("contact_rear", pair.rear), ("contact_front", pair.front)):
        name: ProposedPoint = "contact_rear" if contact == "contact_rear" else "contact_front"
        points[name] = (
            "proposals-wheel-on-best-frame"
            if wheel is None
            else Proposed(wheel.contact_px, wheel.expected_px, None)
        )
    base = min(pair.found, key=lambda w: w.expected_px)
    for target in TARGETS:
        points[target] = _target(pose, best, places[target], pixel(target, best.n), target, base)
    points |= BY_HAND
    return Proposals(best.n, len(used), motion.wheelbase_m, points)


def _target(
    pose: RoadPose,
    best: FrameSeen,
    place: _Found | str,
    at: tuple[float, float] | None,
    name: str,
    wheel: Wheel,
) -> Proposed | str:
    """A target's place on the best frame with its predicted error, and that of its height."""
    if isinstance(place, str) or at is None:
        return str(place)
    if not _inside(at, best.gray):
        return "proposals-not-in-picture"
    pixel_m = abs(float(wheel.y_m - pose.centre_m[1])) / (0.5 * (pose.camera.fx_px + pose.camera.fy_px))
    sigma = float(np.hypot(REST_PX[name], place.apart_m / pixel_m))
    height = measure_height(pose, wheel.contact_px, at, 1.0, PLANES_M[name])
    if height.status != "ok":
        return "proposals-no-height"
    u_m = {entry.source: entry.u_m for entry in height.budget}
    expected_m = np.hypot(u_m["click, target"] * sigma, u_m["click, contact"] * wheel.expected_px)
    return Proposed(at, sigma, float(expected_m))


def _inside(at: tuple[float, float], gray: NDArray[np.uint8]) -> bool:
    height, width = gray.shape
    across = EDGE_PX <= at[0] <= width - 1 - EDGE_PX
    return bool(across and EDGE_PX <= at[1] <= height - 1 - EDGE_PX)
