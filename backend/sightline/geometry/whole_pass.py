"""One vehicle followed through its whole pass: height, inset, heading, speed and wheelbase by one least
squares.

Where a frame's time is known, so is how far the vehicle has come since, up to its speed: F frames then have
no travels of their own to solve for, as in multiframe.py, and every frame says something of every unknown.
Points are weighted by their full covariance (followed_tracks.py), so the estimate is the best linear one
(Aitken 1936) and meets the Cramer-Rao bound where the noise is as stated. No published method is known.
"""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95, chance_of_larger
from sightline.geometry.board_errors import board_parts
from sightline.geometry.camera import undistort
from sightline.geometry.followed_tracks import (
    CONTACT,
    POINT_NAMES,
    SECOND,
    TARGET,
    Following,
    Tracks,
    clicked_at_s,
    noise_parts,
)
from sightline.geometry.height import BudgetEntry, Height, Parts, left_out, not_measurable
from sightline.geometry.insets import implausible_inset
from sightline.geometry.multiframe import LEAST_TRAVEL_M, U_HEADING_RAD
from sightline.geometry.pass_model import (
    ACCELERATION,
    HEADING,
    HEIGHT,
    INSET,
    SPEED,
    WHEELBASE,
    Seen,
    X,
    Y,
    first_estimate,
    middle_s,
    predict_tracks,
    since_middle,
)
from sightline.geometry.ray_intersection import BELOW_ROAD, CAMERA_BELOW, MIN_DEPRESSION, REASONS
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

_LEAST_FRAMES = 3
_OUTLYING = 0.001  # chance that a pass without a wrong point loses one
_DEMANDED = 10.828  # 99.9 % of chi-square with one more unknown: only then an acceleration is solved for
_DISORDER = 0.001
_MOST_DROPPED = 1.0 / 3.0
_NOISE_ROUNDS = 2  # where the noise depends on the speeds in the picture, which settle at once


@dataclass(frozen=True)
class Dropped:
    """An observation that was left out, and why; `index`: its row in the tracks given."""

    index: int
    frame: int
    point: str
    reason: Said


@dataclass(frozen=True)
class Solved:
    """A number solved for, with its standard uncertainty from all sources."""

    value: float
    u: float


@dataclass(frozen=True)
class WholePass:
    """A height from a whole pass; the solved numbers are None where there is none. Contact and distance are
    those of the frame clicked on; `speed_mps` is that of the pass's middle, positive in the road's +X.
    `wheelbase_m` is None without a second contact, `acceleration_mps2` where a constant speed
    explains the points. `u_random_height_m`: what no other vehicle shares.

    `chi2` with `freedom`, and the chance of a larger one; `covariance` (k, k) of `solved_for` (k names), all
    sources together. `inset_parts`: u of the inset in parts; None where something was assumed of it.
    """

    height: Height
    u_random_height_m: float | None = None
    inset_m: Solved | None = None
    heading_rad: Solved | None = None
    speed_mps: Solved | None = None
    wheelbase_m: Solved | None = None
    acceleration_mps2: Solved | None = None
    chi2: float | None = None
    freedom: int = 0
    chance: float | None = None
    frames: int = 0
    dropped: tuple[Dropped, ...] = ()
    solved_for: tuple[str, ...] = ()
    covariance: tuple[tuple[float, ...], ...] = ()
    inset_parts: Parts | None = None


_NAMES = ("x_m", "y_m", "heading_rad", "speed_mps", "ahead_m", "inset_m", "height_m", "wheelbase_m",
          "acceleration_mps2")  # fmt: skip


@dataclass(frozen=True)
class _Prior:
    """What is known of an unknown beforehand, with its standard uncertainty."""

    which: int
    value: float
    u: float
    source: str


_Priors = tuple[_Prior, ...]


def _priors(u_heading_rad: float | None, assumed_inset: tuple[float, float] | None) -> _Priors:
    out = [] if u_heading_rad is None else [_Prior(HEADING, 0.0, max(u_heading_rad, 1e-9), "heading")]
    if assumed_inset is not None:
        out.append(_Prior(INSET, assumed_inset[0], max(assumed_inset[1], 1e-6), "inset"))
    return tuple(out)


@dataclass(frozen=True, eq=False)
class _Fit:
    """The minimum: unknowns (9,), which of them were free, and the whitened problem there."""

    unknowns: Floats
    free: NDArray[np.intp]
    at: Seen
    noise: dict[str, Floats]
    residual_px: Floats  # (2N,)
    covariance: Floats  # (k, k), of noise and heading
    answer: Floats  # (k, 2N): how the unknowns follow the points
    weight: Floats  # (2N, 2N)
    cost: float


def measure_pass(
    pose: RoadPose,
    tracks: Tracks,
    following: Following | None = None,
    u_heading_rad: float | None = U_HEADING_RAD,
    assumed_inset: tuple[float, float] | None = None,
) -> WholePass:
    """Height, inset, heading, speed and, from both tyres, wheelbase of one vehicle that was followed
    through its pass, `tracks` (N), metres, radians and seconds, with the full budget. `assumed_inset`: what
    is known of the inset beforehand, and its standard uncertainty; None: nothing.

    Generalised least squares (Aitken 1936) of a straight course at constant speed, with a constant
    acceleration where chi-square falls by more than 10.8 with it; observations that contradict the rest are
    dropped one by one (Baarda 1968). Lens, pose and board pass through the implicit function of the
    minimum, as in `measure_frames` (CONVENTIONS.md, Whole passes). Never raises for what was followed: no
    height comes back with its reason.
    """
    following = following or Following()
    reason = _unreadable(tracks, following, pose)
    if reason is not None:
        return WholePass(not_measurable(reason))
    priors = _priors(u_heading_rad, assumed_inset)
    kept, dropped = _in_sight(pose, tracks)
    while True:
        part = tracks.only(kept)
        reason = _too_little(part)
        if reason is not None:
            return WholePass(not_measurable(reason), dropped=tuple(dropped))
        fit = _fitted(pose, part, following, priors)
        if isinstance(fit, Said):
            return WholePass(not_measurable(fit), dropped=tuple(dropped))
        worst = _worst(fit, part)
        if worst is None:
            middle_row = 0.5 * (pose.camera.height_px - 1)
            since_s = clicked_at_s(tracks, following, middle_row) - middle_s(part)
            return _reported(pose, part, following, priors, fit, since_s, tuple(dropped))
        row, off_px, times = worst
        index = int(np.flatnonzero(kept)[row])
        off = Said("followed-off", off_px=round(off_px, 1), times=round(times, 1))
        dropped.append(_left_out(tracks, index, off))
        kept[index] = False
        if len(dropped) > _MOST_DROPPED * len(tracks.frame):
            return WholePass(
                not_measurable(
                    Said("height-pass-most-excluded", dropped=len(dropped), points=len(tracks.frame))
                ),
                dropped=tuple(dropped),
            )


def _unreadable(tracks: Tracks, following: Following, pose: RoadPose) -> Said | None:
    numbers = [tracks.time_s, tracks.points_px.ravel(), tracks.sigma_px.ravel()]
    if len(tracks.frame) == 0:
        return Said("height-pass-empty")
    if not np.isfinite(np.concatenate(numbers)).all():
        return Said("height-pass-not-finite")
    if not (tracks.sigma_px > 0).all():
        return Said("height-pass-u-not-positive")
    if not following.can_be:
        return Said("height-pass-statement-not-valid")
    if len(np.unique(np.stack([tracks.frame, tracks.point]), axis=1).T) < len(tracks.frame):
        return Said("height-pass-point-twice")
    if not pose.centre_m[2] > 0:
        return REASONS[CAMERA_BELOW]
    return None


def _left_out(tracks: Tracks, index: int, reason: Said) -> Dropped:
    return Dropped(index, int(tracks.frame[index]), POINT_NAMES[int(tracks.point[index])], reason)


def _in_sight(pose: RoadPose, tracks: Tracks) -> tuple[NDArray[np.bool_], list[Dropped]]:
    """Which observations (N,) can be used by where they lie, and why the others cannot."""
    inside = pose.camera.inside(tracks.points_px)
    lens = undistort(pose.camera, tracks.points_px)
    rays = np.column_stack([lens.points, np.ones(len(inside))]) @ pose.rotation
    with np.errstate(invalid="ignore"):
        below = rays[:, 2] < -MIN_DEPRESSION * np.linalg.norm(rays, axis=1)
    below |= tracks.point == TARGET
    dropped = []
    for index in np.flatnonzero(~(inside & lens.ok & below)):
        if not inside[index]:
            why = Said("followed-outside-picture")
        elif not lens.ok[index]:
            why = Said("followed-outside-lens")
        else:
            why = Said("followed-above-horizon")
        dropped.append(_left_out(tracks, int(index), why))
    return np.asarray(inside & lens.ok & below, dtype=np.bool_), dropped


def _too_little(tracks: Tracks) -> Said | None:
    for point in (CONTACT, TARGET):
        count = int((tracks.point == point).sum())
        if count < _LEAST_FRAMES:
            return Said("height-pass-few-frames", point=POINT_NAMES[point], count=count, needed=_LEAST_FRAMES)
    return None


def _fitted(pose: RoadPose, tracks: Tracks, following: Following, priors: _Priors) -> _Fit | Said:
    """At constant speed, or with an acceleration where the points demand it; or why there is no minimum."""
    t_s = since_middle(tracks)
    start = first_estimate(pose, tracks, t_s)
    if not np.isfinite(start).all():
        return Said("height-pass-no-path")
    for point in (CONTACT, TARGET):
        travel = abs(start[SPEED]) * float(np.ptp(t_s[tracks.point == point]))
        if not travel >= LEAST_TRAVEL_M:
            return Said("height-pass-short", point=POINT_NAMES[point], travel_m=round(travel, 2))
    free = [i for i in range(9) if i != ACCELERATION and (i != WHEELBASE or (tracks.point == SECOND).any())]
    even = _minimum(pose, tracks, t_s, following, priors, start, free)
    if isinstance(even, Said):
        return even
    if len(np.unique(tracks.frame)) <= _LEAST_FRAMES:
        return even
    changing = _minimum(pose, tracks, t_s, following, priors, even.unknowns, [*free, ACCELERATION])
    if isinstance(changing, Said) or even.cost - changing.cost < _DEMANDED:
        return even
    return changing


def _minimum(
    pose: RoadPose,
    tracks: Tracks,
    t_s: Floats,
    following: Following,
    priors: _Priors,
    start: Floats,
    free: list[int],
) -> _Fit | Said:
    index = np.array(free)
    unknowns = np.array(start)

    def filled(values: Floats) -> Floats:
        out = np.array(start)
        out[index] = values
        return out

    last: list[tuple[Floats, Seen]] = []

    def looked(values: Floats) -> Seen:
        """Residuals and slopes are asked for at the same values, one after the other."""
        if not last or not np.array_equal(last[0][0], values):
            last[:] = [
                (values.copy(), predict_tracks(pose, tracks, t_s, following.row_time_s, filled(values)))
            ]
        return last[0][1]

    def residual(values: Floats) -> Floats:
        away = (looked(values).pixels - tracks.points_px).ravel()
        off = scipy.linalg.solve_triangular(root, away, lower=True)
        out = np.append(off, [(filled(values)[one.which] - one.value) / one.u for one in priors])
        return np.asarray(np.nan_to_num(out, nan=1e9, posinf=1e9, neginf=-1e9), dtype=np.float64)

    def slope(values: Floats) -> Floats:
        prior = [(index == one.which) / one.u for one in priors]
        of_points = scipy.linalg.solve_triangular(root, looked(values).by_unknowns[:, index], lower=True)
        out = np.vstack([of_points, *prior])
        return np.asarray(np.nan_to_num(out, nan=0.0, posinf=0.0, neginf=0.0), dtype=np.float64)

    depends = _depends_on_speed(following)
    for _ in range(_NOISE_ROUNDS if depends else 1):
        at = predict_tracks(pose, tracks, t_s, following.row_time_s, unknowns)
        if not np.isfinite(at.pixels).all():
            return _UNSETTLED
        noise = noise_parts(tracks, following, at.speed_px_s)
        root = np.linalg.cholesky(np.sum(list(noise.values()), axis=0))
        solution = scipy.optimize.least_squares(
            residual, unknowns[index], slope, method="lm", x_scale="jac", xtol=1e-12, ftol=1e-12, gtol=1e-12,
            max_nfev=200
        )  # fmt: skip
        if not solution.success or not np.isfinite(solution.x).all():
            return _UNSETTLED
        unknowns = filled(solution.x)
    return _at_minimum(pose, tracks, t_s, following, priors, unknowns, index, noise)


_UNSETTLED = Said("height-pass-disagrees")


def _depends_on_speed(following: Following) -> bool:
    return max(following.u_time_s, following.exposure_s, following.u_depth_share, following.view_px) > 0


def _at_minimum(
    pose: RoadPose,
    tracks: Tracks,
    t_s: Floats,
    following: Following,
    priors: _Priors,
    unknowns: Floats,
    free: NDArray[np.intp],
    noise: dict[str, Floats],
) -> _Fit | Said:
    at = predict_tracks(pose, tracks, t_s, following.row_time_s, unknowns)
    jacobian = at.by_unknowns[:, free]
    if not np.isfinite(jacobian).all():
        return _UNSETTLED
    factor = scipy.linalg.cho_factor(np.sum(list(noise.values()), axis=0), lower=True)
    weight = scipy.linalg.cho_solve(factor, np.eye(len(jacobian)))
    normal = jacobian.T @ weight @ jacobian
    for one in priors:
        normal[one.which, one.which] += one.u**-2
    scale = 1.0 / np.sqrt(np.maximum(np.diag(normal), 1e-300))
    scaled = normal * np.outer(scale, scale)
    if not np.isfinite(scaled).all() or np.linalg.cond(scaled) > 1e12:
        return Said("height-pass-inset-undetermined")
    covariance = np.linalg.inv(scaled) * np.outer(scale, scale)
    residual = (tracks.points_px - at.pixels).ravel()
    off = sum(((unknowns[one.which] - one.value) / one.u) ** 2 for one in priors)
    cost = float(residual @ weight @ residual + off)
    answer = covariance @ jacobian.T @ weight
    return _Fit(
        unknowns=unknowns,
        free=free,
        at=at,
        noise=noise,
        residual_px=residual,
        covariance=covariance,
        answer=answer,
        weight=weight,
        cost=cost,
    )


def _worst(fit: _Fit, tracks: Tracks) -> tuple[int, float, float] | None:
    """The observation that contradicts the others most (row, pixels off, times its uncertainty), if one does:
    Baarda's test of both coordinates together, at a chance shared by all N.
    """
    jacobian = fit.at.by_unknowns[:, fit.free]
    spare = fit.weight - fit.weight @ jacobian @ fit.answer
    pull = fit.weight @ fit.residual_px
    n = len(tracks.frame)
    limit = 2.0 * float(scipy.special.gammaincinv(1.0, (1.0 - _OUTLYING) ** (1.0 / n)))
    blocks = np.array([spare[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] for i in range(n)])
    tested = np.array([np.linalg.cond(block) < 1e10 for block in blocks])
    off = np.zeros((n, 2))
    off[tested] = np.linalg.solve(blocks[tested], pull.reshape(n, 2, 1)[tested])[:, :, 0]
    value = np.einsum("ni,ni->n", off, pull.reshape(n, 2))
    row = int(np.argmax(value))
    if value[row] <= limit:
        return None
    return row, float(np.hypot(*off[row])), float(np.sqrt(value[row]))


def _sources(
    pose: RoadPose, following: Following, priors: _Priors, fit: _Fit
) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Covariance (k, k) of the free unknowns by source: those of this vehicle alone, and those it shares."""
    own = {name: fit.answer @ part @ fit.answer.T for name, part in fit.noise.items()}
    shared: dict[str, Floats] = {}
    for one in priors:
        pull = fit.covariance[:, one.which] / one.u
        shared[one.source] = np.outer(pull, pull)
    moved = -fit.answer @ fit.at.by_lens_pose
    if following.u_row_time_s > 0:
        late = fit.answer @ fit.at.by_row_time * following.u_row_time_s
        shared["row time"] = np.outer(late, late)
    if pose.covariance is not None:
        shared["lens and pose"] = moved @ pose.covariance @ moved.T
    for source, part in board_parts(pose).items():
        effect = moved[:, -6:] @ part
        shared[source] = effect @ effect.T
    return own, shared


def _inset_parts(following: Following, priors: _Priors, fit: _Fit, own: Floats) -> Parts | None:
    """`own` (k, k): covariance of what is this vehicle's alone. None where the inset rests on a prior."""
    if any(one.which == INSET for one in priors):
        return None
    row = fit.answer[INSET]
    by_heading = sum(float(fit.covariance[INSET, one.which]) / one.u for one in priors)
    by_row_time = float(row @ fit.at.by_row_time) * following.u_row_time_s
    return Parts(_root(own[INSET, INSET]), -row @ fit.at.by_lens_pose, by_heading, by_row_time)


def _as_told(fit: _Fit, since_s: float) -> tuple[Floats, Floats]:
    """The unknowns (9,) with the contact where it was `since_s` after the middle of the pass and the
    wheelbase without its sign; and the derivatives of the free ones by the free unknowns, (k, k).
    """
    heading, speed, acceleration = (float(fit.unknowns[i]) for i in (HEADING, SPEED, ACCELERATION))
    along = np.array([np.cos(heading), np.sin(heading)])
    way = speed * since_s + 0.5 * acceleration * since_s**2
    facing = -1.0 if fit.unknowns[WHEELBASE] < 0 else 1.0
    reported, by = np.array(fit.unknowns), np.eye(9)
    reported[[X, Y]] += way * along
    reported[WHEELBASE] *= facing
    by[[X, Y], HEADING] = -way * along[1], way * along[0]
    by[[X, Y], SPEED] = since_s * along
    by[[X, Y], ACCELERATION] = 0.5 * since_s**2 * along
    by[WHEELBASE, WHEELBASE] = facing
    return reported, by[np.ix_(fit.free, fit.free)]


def _reported(
    pose: RoadPose,
    tracks: Tracks,
    following: Following,
    priors: _Priors,
    fit: _Fit,
    clicked_since_s: float,
    dropped: tuple[Dropped, ...],
) -> WholePass:
    if fit.unknowns[HEIGHT] <= 0:
        return WholePass(not_measurable(REASONS[BELOW_ROAD]), dropped=dropped)
    reason = implausible_inset(float(fit.unknowns[INSET]))
    if reason is not None:
        return WholePass(not_measurable(reason), dropped=dropped)
    own, shared = _sources(pose, following, priors, fit)
    alone = np.sum(list(own.values()), axis=0)
    reported, by = _as_told(fit, clicked_since_s)
    total = by @ np.sum([alone, *shared.values()], axis=0) @ by.T
    freedom = 2 * len(tracks.frame) - len(fit.free) + len(priors)
    chance = chance_of_larger(fit.cost, freedom)
    place = {name: int(i) for i, name in enumerate(fit.free)}

    def solved(which: int) -> Solved | None:
        if which not in place:
            return None
        return Solved(float(reported[which]), _root(total[place[which], place[which]]))

    def of_height(part: Floats) -> float:
        return _root(part[HEIGHT, HEIGHT])

    u_height, inset = of_height(total), solved(INSET)
    assert inset is not None  # every pass is solved for its inset
    x, y = float(reported[X]), float(reported[Y])
    height = Height(
        status="ok",
        reason=None,
        height_m=float(fit.unknowns[HEIGHT]),
        u_height_m=u_height,
        U95_height_m=COVERAGE_95 * u_height,
        x_m=x,
        y_m=y,
        distance_m=float(np.linalg.norm(pose.centre_m - [x, y, 0.0])),
        inset_m=inset.value,
        u_inset_m=inset.u,
        budget=tuple(BudgetEntry(name, of_height(part)) for name, part in {**own, **shared}.items()),
        flags=_flags(pose, inset, chance),
    )
    return WholePass(
        height=height,
        u_random_height_m=of_height(alone),
        inset_m=inset,
        heading_rad=solved(HEADING),
        speed_mps=solved(SPEED),
        wheelbase_m=solved(WHEELBASE),
        acceleration_mps2=solved(ACCELERATION),
        chi2=fit.cost,
        freedom=freedom,
        chance=chance,
        frames=len(np.unique(tracks.frame)),
        dropped=dropped,
        solved_for=tuple(_NAMES[i] for i in fit.free),
        covariance=tuple(tuple(float(v) for v in row) for row in total),
        inset_parts=_inset_parts(following, priors, fit, alone),
    )


def _root(variance: float) -> float:
    """A variance of 0 may come out of rounding as less."""
    return float(np.sqrt(max(float(variance), 0.0)))


def _flags(pose: RoadPose, inset: Solved, chance: float) -> tuple[Said, ...]:
    out = left_out(pose)
    if chance < _DISORDER:
        out.append(Said("height-flag-pass-misfit"))
    if inset.u > 0.3:
        out.append(Said("height-flag-inset-weak"))
    return tuple(out)
