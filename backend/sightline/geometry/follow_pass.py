"""Points confirmed on one frame of a pass, followed through the others in the pictures.

Road pose and speed say where a point will be on each frame, how large, and how its surroundings are seen from
there: they are laid out on the vertical plane along the road in which the point travels, where a vehicle that
goes straight stands still but for a small shift. That shift is found on each frame against the mean of all
frames (Lucas and Kanade 1981; inverse compositional, Baker and Matthews 2004), each cell weighted by how
steady it is along the pass: what does not travel with the point (road, what is seen through a window) hardly
counts.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import cv2
import numpy as np

from sightline.arrays import Floats
from sightline.enums import FollowedPoint, Target
from sightline.geometry.camera import project
from sightline.geometry.follow import Gray, find_textured_spots
from sightline.geometry.followed_tracks import (
    CONTACT,
    POINT_NAMES,
    SECOND,
    TARGET,
    Following,
    Tracks,
    u_of_rounded_times,
)
from sightline.geometry.patch_shift import (
    FLOOR_GREY,
    Patch,
    Shift,
    Window,
    light_of,
    noise_grey,
    register_patch,
    template_of,
)
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.travel import Body, BodyTracker, body_of
from sightline.messages.said import Said

# (aside, below, above) the point, metres: a wheel and what is beside it; what is next to a target
_WHEEL_M = (0.33, 0.10, 0.32)
_NEAR_M = (0.15, 0.15, 0.15)
_LEAST_CELLS, _MOST_CELLS = 7, 42  # to each side
_HUB_M, _RIM_M = 0.31, 0.20  # of a usual wheel
_TAPER = 0.7  # width of the window that is laid over the first look, over its half size
_ALIKE = 0.75  # least weighted correlation with the mean of all frames
_SHARP = 0.5  # least share of the usual slope
_EDGE_PX = 3.0
_REACH_PX = 8.0  # a point farther from where pose and speed have it is not it
_FIRST_STEPS, _ROUNDS = 8, 16
_LONGEST_CELLS, _FURTHER = 2.5, 1.5
_STILL_CELLS = 0.02  # mean step of all frames that ends the rounds
_SETTLED_CELLS = 1.5  # a step still so long after all of them goes nowhere
_FLAT_GREY, _FLAT_NOISE = 10.0, 3.0  # what is flatter than this, or than so many times the noise, stays flat
_WEAK_PX = 1.5
_APART_PX, _APART_U = 1.0, 5.0  # off the line of the others: pixels, and times its uncertainty
_LEAST_SPEED_MPS = 0.5
# What following is off by beside the noise of the pictures, set on drawn sites 701 to 703 and 811 to 826:
# on every frame, and as the point is seen from another side, in 100 px of its way.
_REST_PX = 0.02
_VIEW_PX = 0.15
# Targets that can be followed, and how far what is followed about one may lie before or behind it, metres
# (estimates; lamps are bent round a corner). A roof is an edge along the road with moving scenery behind it,
# a headlight's outline is that of the bonnet behind it: on drawn sites their insets came out 0.1 m wrong.
U_DEPTH_M: dict[Target, float] = {"driver_eye": 0.02, "taillight": 0.03, "other": 0.05}
_LEAST_FRAMES, _LEAST_TRIPLES = 3, 4


@dataclass(frozen=True, eq=False)
class PassFrame:
    """A frame of the pass: number, time, seconds, and luminance (H, W); `tick_s`: what its file counts time
    in, 0 where that is not known.
    """

    frame: int
    time_s: float
    gray: Gray
    tick_s: float = 0.0


@dataclass(frozen=True)
class Lost:
    """A point that was not followed to a frame, and why."""

    frame: int
    point: FollowedPoint
    reason: Said


@dataclass(frozen=True, eq=False)
class FollowedPass:
    """Points followed through a pass, how their errors hang together, and what was left out."""

    tracks: Tracks
    following: Following
    lost: tuple[Lost, ...]


def follow_pass(
    pose: RoadPose,
    frames: Sequence[PassFrame],
    begun_on: int,
    points_px: Mapping[int, tuple[float, float]],
    target: Target,
    inset_m: float,
    confirmed_px: float = 1.0,
) -> FollowedPass | Said:
    """CONTACT, TARGET and, if given, SECOND of `points_px`, pixels, confirmed on frame `begun_on` to
    `confirmed_px`, followed through `frames` in order of time; or the reason why nothing can be followed.
    `inset_m`: about how far the target lies behind the side plane, which need not be right: it says how its
    surroundings are laid out.

    Own method: see the module. Each point's uncertainty is that of its shift, from slopes and residuals of
    its own picture, with errors of neighbouring cells taken together (Newey and West 1987).
    """
    if target not in U_DEPTH_M:
        return Said("follow-outline")
    numbers = [one.frame for one in frames]
    if begun_on not in numbers:
        return Said("follow-frame-not-of-pass")
    start = numbers.index(begun_on)
    placed = _placed(pose, points_px, inset_m)
    if isinstance(placed, Said):
        return placed
    travel = _travels(pose, frames, start, points_px, inset_m)
    if travel is None:
        return Said("follow-not-from-here")
    lost: list[Lost] = []
    rows: list[tuple[int, int, Floats, Floats]] = []
    for point, at_m in placed.items():
        found, why = _followed_point(pose, frames, start, travel, point, at_m)
        lost += [Lost(numbers[i], POINT_NAMES[point], reason) for i, reason in why.items()]
        rows += [(i, point, one.pixel, one.sigma_px) for i, one in found.items()]
    order = sorted(rows, key=lambda row: (row[0], row[1]))
    tracks = Tracks(
        frame=np.array([numbers[i] for i, *_ in order], dtype=np.int64),
        time_s=np.array([frames[i].time_s for i, *_ in order], dtype=np.float64),
        point=np.array([point for _, point, *_ in order], dtype=np.int64),
        points_px=np.array([pixel for *_, pixel, _ in order], dtype=np.float64).reshape(-1, 2),
        sigma_px=np.array([sigma for *_, sigma in order], dtype=np.float64).reshape(-1, 2),
    )
    following = Following(
        confirmed_px=float(confirmed_px),
        begun_on=begun_on,
        u_time_s=u_of_rounded_times(np.array([one.time_s for one in frames]), frames[start].tick_s),
        u_depth_share=U_DEPTH_M[target] / _depth_m(pose, placed[TARGET]),
        view_px=_VIEW_PX,
        matched=True,
    )
    return FollowedPass(tracks, following, tuple(sorted(lost, key=lambda one: (one.frame, one.point))))


def _placed(
    pose: RoadPose, points_px: Mapping[int, tuple[float, float]], inset_m: float
) -> dict[int, Floats] | Said:
    """The points (3,) on the road by what they are; or why they are none of a vehicle."""
    if CONTACT not in points_px or TARGET not in points_px:
        return Said("follow-points-needed")
    body = body_of(pose, points_px[CONTACT], points_px[TARGET], inset_m, np.empty((0, 2)))
    if isinstance(body, Said):
        return body
    placed = {CONTACT: body.points_m[0], TARGET: body.points_m[1]}
    if SECOND in points_px:
        other = road_point(pose, points_px[SECOND])
        if isinstance(other, Said):
            return other
        placed[SECOND] = other
    return placed


def _travels(
    pose: RoadPose,
    frames: Sequence[PassFrame],
    start: int,
    points_px: Mapping[int, tuple[float, float]],
    inset_m: float,
) -> Floats | None:
    """How far along X the vehicle has come on every frame (F,), m, at the speed that it is seen to go."""
    pixels = np.array([points_px[point] for point in sorted(points_px)])
    contact, target = points_px[CONTACT], points_px[TARGET]
    tall = max(abs(contact[1] - target[1]), 0.05 * pose.camera.height_px)
    (left, top), (right, bottom) = pixels.min(axis=0), pixels.max(axis=0)
    box = (left - 0.6 * tall, top + 0.15 * tall, right + 0.6 * tall, bottom - 0.12 * tall)
    spots = find_textured_spots(frames[start].gray, box)
    body = body_of(pose, contact, target, inset_m, spots)
    if isinstance(body, Said):
        return None
    followed_px = np.concatenate([[contact, target], spots])
    times = np.array([one.time_s for one in frames])
    known = {start: 0.0}
    speed: float | None = None
    ways = [range(start + 1, len(frames)), range(start - 1, -1, -1)]
    for way in sorted(ways, key=len, reverse=True):
        found, speed = _tracked(pose, body, followed_px, frames, start, way, speed)
        known |= found
    if len(known) < _LEAST_FRAMES:
        return None
    index = np.array(sorted(known))
    moved = np.array([known[i] for i in index])
    bend = 2 if len(index) >= 8 else 1
    since = times - times[start]
    line = np.polyfit(since[index], moved, 1)
    if abs(line[0]) < _LEAST_SPEED_MPS:
        return None
    curve = np.polyfit(since[index], moved, bend)
    inside = np.clip(since, since[index].min(), since[index].max())
    # beyond where it was seen it goes on at its mean speed
    out = np.polyval(curve, inside) - np.polyval(curve, 0.0) + line[0] * (since - inside)
    return np.asarray(out, dtype=np.float64)


def _tracked(
    pose: RoadPose,
    body: Body,
    pixels: Floats,
    frames: Sequence[PassFrame],
    start: int,
    way: range,
    speed: float | None,
) -> tuple[dict[int, float], float | None]:
    chase, before = BodyTracker(pose, body, pixels, frames[start].gray, speed), start
    out: dict[int, float] = {}
    for i in way:
        travel = chase.step(frames[i].gray, frames[i].time_s - frames[before].time_s)
        if travel is None:
            break
        out[i], before = travel, i
    return out, chase.speed_mps


def _depth_m(pose: RoadPose, at_m: Floats) -> float:
    return max(float(pose.to_camera(at_m[None])[0, 2]), 0.1)


def _window(pose: RoadPose, gray: Gray, point: int, at_m: Floats) -> Window:
    cell = _depth_m(pose, at_m) / pose.camera.fx_px
    size = _NEAR_M if point == TARGET else _WHEEL_M
    aside, below, above = (int(np.clip(round(one / cell), _LEAST_CELLS, _MOST_CELLS)) for one in size)
    flat = max(_FLAT_GREY, _FLAT_NOISE * noise_grey(gray))
    along, up = np.meshgrid(np.arange(-aside, aside + 1), np.arange(-below, above + 1))
    return Window(np.float64(cell) * along.astype(np.float64), cell * up.astype(np.float64), cell, flat)


@dataclass(frozen=True, eq=False)
class _Seen:
    """Where a point is on a frame, pixels (2,), and the uncertainty of each coordinate (2,)."""

    pixel: Floats
    sigma_px: Floats


@dataclass(eq=False)
class _Chase:
    """One point on its way through the frames: shifts (F, 2) along and up, metres, beside the travel."""

    pose: RoadPose
    frames: Sequence[PassFrame]
    start: int
    travel: Floats
    at_m: Floats
    window: Window
    steady: Floats  # weight (h, w) of cells by what they may show
    shift_m: Floats = field(init=False)
    why: dict[int, Said] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.shift_m = np.zeros((len(self.frames), 2))

    def place(self, i: int) -> Floats:
        along, up = self.shift_m[i]
        return np.asarray(self.at_m + np.array([self.travel[i] + along, 0.0, up]), dtype=np.float64)

    def pixel(self, i: int) -> Floats:
        return np.asarray(project(self.pose.camera, self.pose.to_camera(self.place(i)[None]))[0], np.float64)

    def patch(self, i: int) -> Patch:
        return self.window.patch(self.frames[i].gray, self.pose, self.place(i))

    def moved(self, i: int, step: Floats) -> None:
        longest = max(1.0, float(np.hypot(*step)) / _LONGEST_CELLS)
        self.shift_m[i] += step / longest * self.window.cell_m

    def too_far(self, i: int) -> bool:
        return bool(np.hypot(*self.shift_m[i]) > self.reach_m(i))

    def reach_m(self, i: int) -> float:
        """How far a point may be from where it is expected: a wrong inset moves it with the travel."""
        return _REACH_PX * self.window.cell_m + 0.08 * abs(float(self.travel[i]))


OUTSIDE = Said("followed-left-picture")
LOST = Said("followed-lost")
ELSEWHERE = Said("followed-elsewhere")
UNLIKE = Said("followed-unlike")
BLURRED = Said("followed-blurred")
WEAK = Said("followed-weak")


def _followed_point(
    pose: RoadPose, frames: Sequence[PassFrame], start: int, travel: Floats, point: int, at_m: Floats
) -> tuple[dict[int, _Seen], dict[int, Said]]:
    """Where the point is, by index of the frame, and why not on the others."""
    window = _window(pose, frames[start].gray, point, at_m)
    chase = _Chase(
        pose=pose,
        frames=frames,
        start=start,
        travel=travel,
        at_m=at_m,
        window=window,
        steady=_not_turning(window, point),
    )
    usable = _first_look(chase)
    shifts: dict[int, Shift] = {}
    for _ in range(_ROUNDS):
        shifts = _against_mean(chase, usable)
        usable = [i for i in usable if i in shifts]
        steps = [float(np.hypot(*shifts[i].step)) for i in usable]
        if len(usable) < 2 or start not in usable or np.mean(steps) < _STILL_CELLS:
            break
    out: dict[int, _Seen] = {}
    if start not in usable or len(usable) < 2:
        return out, {i: chase.why.get(i, LOST) for i in range(len(frames))}
    slope = float(np.median([shifts[i].slope for i in usable]))
    scatter = _scatter(chase, usable, shifts)
    apart = _apart_px(chase, usable)
    begun = chase.shift_m[start].copy()
    for i in usable:
        shift = shifts[i]
        sigma = _sigma_px(chase, i, shift, scatter)
        if shift.alike < _ALIKE:
            chase.why[i] = UNLIKE
        elif apart[i] > _APART_PX + _APART_U * sigma.max():
            chase.why[i] = ELSEWHERE
        elif shift.slope < _SHARP * slope:
            chase.why[i] = BLURRED
        elif sigma[1] > _WEAK_PX:
            chase.why[i] = WEAK
        else:
            # the point is where it was confirmed: shifts count from that frame
            chase.shift_m[i] -= begun
            out[i] = _Seen(chase.pixel(i), sigma)
    return out, chase.why


def _first_look(chase: _Chase) -> list[int]:
    """Outwards from the confirmed frame, each against the mean of those before it; the frames followed to."""
    start, count = chase.start, len(chase.frames)
    weight = _taper(chase.window) * chase.steady
    usable = [start]
    for way in (range(start + 1, count), range(start - 1, -1, -1)):
        mean = chase.patch(start).light
        known = [start]
        for i in way:
            chase.shift_m[i] = _expected(chase, known, i)
            if not _in_picture(chase, i):
                chase.why[i] = OUTSIDE
                continue
            found = _settled(chase, i, mean, weight)
            if isinstance(found, Said):
                chase.why[i] = found
                continue
            known.append(i)
            patch = chase.patch(i)
            gain, offset = light_of(mean, patch.light, weight * patch.seen + 1e-9)
            fresh = np.where(patch.seen, gain * patch.light + offset, mean)
            mean = mean + (fresh - mean) / len(known)
        usable += known[1:]
    return sorted(usable)


def _not_turning(window: Window, point: int) -> Floats:
    """Weight (h, w) of cells: little where spokes turn."""
    if point == TARGET:
        return np.ones(window.along.shape)
    inside = np.hypot(window.along, window.up - _HUB_M) < _RIM_M
    return np.asarray(np.where(inside, 0.01, 1.0), dtype=np.float64)


def _taper(window: Window) -> Floats:
    """Weight (h, w) of cells by how near they are to the middle."""
    middle = 0.5 * (window.up.max() + window.up.min())
    width, height = window.along.max(), 0.5 * (window.up.max() - window.up.min())
    away = (window.along / width) ** 2 + ((window.up - middle) / height) ** 2
    return np.asarray(np.exp(-0.5 * away / _TAPER**2), dtype=np.float64)


def _expected(chase: _Chase, known: Sequence[int], i: int) -> Floats:
    """The shift to start from: that of the frame before and, where some are known, what it grows by."""
    last = chase.shift_m[known[-1]]
    some = np.array(known[-6:])
    way = chase.travel[some]
    if len(some) < 3 or np.ptp(way) < 1e-6:
        return np.asarray(last.copy())
    line = np.polyfit(way, chase.shift_m[some], 1)
    ahead = float(chase.travel[i] - chase.travel[known[-1]])
    return np.asarray(last + line[0] * ahead, dtype=np.float64)


def _in_picture(chase: _Chase, i: int) -> bool:
    x, y = chase.pixel(i)
    height, width = chase.frames[i].gray.shape
    return bool(_EDGE_PX <= x <= width - 1 - _EDGE_PX and _EDGE_PX <= y <= height - 1 - _EDGE_PX)


def _settled(chase: _Chase, i: int, mean: Floats, weight: Floats) -> Said | None:
    """Moves the shift of a frame to where it lies on the mean; or says why it does not."""
    shift, onto = None, template_of(mean)
    for _ in range(_FIRST_STEPS):
        shift = register_patch(onto, chase.patch(i), weight)
        if shift is None:
            return OUTSIDE
        chase.moved(i, shift.step)
        if np.hypot(*shift.step) < 0.02:
            break
    if shift is None or np.hypot(*shift.step) > _SETTLED_CELLS or chase.too_far(i):
        return LOST
    return UNLIKE if shift.alike < _ALIKE else None


def _against_mean(chase: _Chase, usable: Sequence[int]) -> dict[int, Shift]:
    """Every frame registered against the mean of all, by cells that are steady along the pass."""
    base = chase.patch(chase.start)
    patches = {i: chase.patch(i) for i in usable}
    visible = np.stack([patches[i].seen for i in usable])
    taper = _taper(chase.window)
    stack = []
    for i in usable:
        of_cell = taper * patches[i].seen * base.seen + 1e-9
        gain, offset = light_of(base.light, patches[i].light, of_cell)
        stack.append(gain * patches[i].light + offset)
    laid = np.stack(stack)
    count = np.maximum(visible.sum(axis=0), 1)
    mean = np.where(visible.any(axis=0), (laid * visible).sum(axis=0) / count, base.light)
    spread = (np.square(laid - mean) * visible).sum(axis=0) / np.maximum(count - 1, 1)
    spread = cv2.GaussianBlur(np.where(count > 1, spread, spread.max()), (0, 0), 1.0)
    weight = chase.steady / (FLOOR_GREY**2 + spread)
    out, onto = {}, template_of(mean)
    for i in usable:
        shift = register_patch(onto, patches[i], weight)
        if shift is None:
            chase.why[i] = OUTSIDE
            continue
        # the mean is blurred by what the frames are off still, so a step falls short
        chase.moved(i, _FURTHER * shift.step)
        if chase.too_far(i):
            chase.why[i] = LOST
        elif not _in_picture(chase, i):
            chase.why[i] = OUTSIDE
        else:
            out[i] = shift
    return out


def _apart_px(chase: _Chase, usable: Sequence[int]) -> dict[int, float]:
    """How far each shift lies from the line by the travel that most of them lie on (Theil-Sen), pixels."""
    index = np.array(usable)
    if len(index) < _LEAST_FRAMES:
        return dict.fromkeys(usable, 0.0)
    way, shift = chase.travel[index], chase.shift_m[index] / chase.window.cell_m
    one, two = np.triu_indices(len(index), 1)
    wide = np.abs(way[two] - way[one]) > 1e-6
    slopes = (shift[two] - shift[one])[wide] / (way[two] - way[one])[wide, None]
    slope = np.median(slopes, axis=0) if wide.any() else np.zeros(2)
    rest = shift - way[:, None] * slope
    away = np.hypot(*(rest - np.median(rest, axis=0)).T)
    return {int(i): float(off) for i, off in zip(index, away, strict=True)}


def _scatter(chase: _Chase, usable: Sequence[int], shifts: Mapping[int, Shift]) -> Floats:
    """By how much (2,) shifts of neighbouring frames scatter more than their uncertainties say, at least 1:
    second differences, which a smooth way of the point leaves out.
    """
    triples = [i for i in usable if i - 1 in shifts and i + 1 in shifts]
    if len(triples) < _LEAST_TRIPLES:
        return np.ones(2)
    shift = chase.shift_m / chase.window.cell_m
    away = np.array([shift[i - 1] - 2 * shift[i] + shift[i + 1] for i in triples])
    own = [np.diag(shifts[i - 1].covariance + 4 * shifts[i].covariance + shifts[i + 1].covariance)
           for i in triples]  # fmt: skip
    ratio = np.abs(away) / np.sqrt(np.maximum(np.array(own), 1e-12))
    return np.asarray(np.maximum(1.0, np.median(ratio, axis=0) / 0.6745), dtype=np.float64)


def _sigma_px(chase: _Chase, i: int, shift: Shift, scatter: Floats) -> Floats:
    """Uncertainty (2,) of a followed point in the picture, pixels."""
    cell_px = chase.window.cell_m * chase.pose.camera.fx_px / _depth_m(chase.pose, chase.place(i))
    own = np.sqrt(np.maximum(np.diag(shift.covariance), 0.0)) * cell_px * scatter
    return np.asarray(np.hypot(own, _REST_PX), dtype=np.float64)
