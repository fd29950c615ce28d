"""The direct chain: a vehicle's motion from the grey values of both strips, with its budget."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.linescan.budget import budget_of
from sightline.linescan.finding import too_few_lines
from sightline.linescan.masks import (
    ROWS,
    Points,
    Sheet,
    choose_points,
    coarsen_sheet,
    points_at,
    pool_picture,
    silhouette,
    softened_noise,
    softness,
)
from sightline.linescan.parts import Crossings, Motion, Passage, Pixels, Profile, Rig
from sightline.linescan.registration import GAINS, Clock, Fit, Prior, State, register
from sightline.linescan.rig import baseline_of
from sightline.linescan.spread import covariance, slopes_of
from sightline.linescan.warp import solved_by_boundaries
from sightline.messages.said import Said
from sightline.robust import robust_scale

# a sample along the vehicle after pooling, metres; finer says nothing new, the optics blur it
SAMPLE_M = 0.0028
MOST_POINTS = 12000
SHIFT_POINTS = 5000
COARSE, COARSE_POINTS = 4, 2500
FEWEST_POINTS = 150
BLOCK_M = 0.10
BLOCK_ROWS = 12
CELL_M = 0.18
# Errors go together over some decimetres; one length alone would make u itself scatter more. Whole cells:
# what takes one gain and one offset errs as one, its halves in two clusters would not be independent.
CELLS_A_CLUSTER = (2, 1)
PROFILE_M = 0.15
UNLIKE_M = 0.05
# by how much of the speed that the boundaries say the pictures may say another
MOST_MOVED = 0.25
MOST_SATURATED = 0.03
# of the fit's u, by how much the last round may have moved any figure that follows from it
SETTLED = 0.1
NO_TEXTURE = Said("scan-motion-no-texture")
NO_MATCH = Said("scan-motion-no-match")
NO_ORDER = Said("scan-motion-no-order")


@dataclass(frozen=True, eq=False)
class Scene:
    """What the registration works on: both sheets, the points, the clock, and what the points fall into.

    `block`: trusted or not as a whole; `cell`: has a gain and an offset of its own; `clusters`: whose errors
    go together, for each of CELLS_A_CLUSTER. (n,) numbers each.
    """

    first: Sheet
    second: Sheet
    points: Points
    block: NDArray[np.intp]
    cell: NDArray[np.intp]
    clusters: tuple[NDArray[np.intp], ...]
    clock: Clock
    lines_per_m: float
    noise_dn: float


def measure_direct(passage: Passage, rig: Rig) -> Motion:
    """Motion of one vehicle by registering its two line-scan pictures (Gauss-Newton on grey values).

    Left out: motion other than along the road (pitch, lane change), acceleration that changes while the
    vehicle passes.

    Parameters
    ----------
    passage : Passage
        The vehicle as both cameras saw it, pictures (lines, rows) of 8 or 16 bits.
    rig : Rig
        Baseline in metres and line rate in Hz, with their uncertainties.

    Returns
    -------
    Motion
        Speed, acceleration and length with their standard uncertainties (the budget's root sum of squares),
        or the reason why there is none.

    Examples
    --------
    >>> import cv2, numpy as np, sightline
    >>> rng = np.random.default_rng(4)
    >>> paint = 120 + 400 * cv2.GaussianBlur(rng.normal(size=(500, 40)), (0, 0), 4)  # a row a cm
    >>> def scan(first_line, front_line):
    ...     along_m = (np.arange(first_line, first_line + 260) - front_line) / 1000.0 * 20.0
    ...     seen = np.full((260, 40), 60.0)
    ...     on = (along_m >= 0.0) & (along_m <= 4.0)
    ...     seen[on] = paint[(along_m[on] * 100).round().astype(int)]
    ...     return (seen + rng.normal(0.0, 1.0, seen.shape)).clip(0, 255).astype(np.uint8)
    >>> road = np.full(40, 60.0, np.float32)
    >>> passage = sightline.Passage(
    ...     sightline.Crossings(30.0, 230.0, 80.0, 280.0), scan(0, 30), scan(50, 80), 0, 50, road, road, 1.0)
    >>> motion = sightline.measure_direct(passage, sightline.Rig(1.0, 1000.0, u_baseline_m=0.001))
    >>> round(motion.speed_mps, 1), round(motion.length_m, 1)
    (20.0, 4.0)
    """
    crossings = passage.crossings
    if passage.reason:
        return _not_measurable(crossings, passage.reason)
    ordered = (
        crossings.front_line_1 < crossings.rear_line_1 and crossings.front_line_2 < crossings.rear_line_2
    )
    later = crossings.front_line_2 + crossings.rear_line_2 > crossings.front_line_1 + crossings.rear_line_1
    if not (ordered and later):
        return _not_measurable(crossings, NO_ORDER)
    scene, start, prior = _prepared(passage, rig)
    if len(scene.points) < FEWEST_POINTS:
        return _not_measurable(crossings, NO_TEXTURE)
    whole, fit = _coarse_to_fine(scene, start, prior)
    reason = _distrusted(fit, scene, start, rig)
    if reason:
        return _not_measurable(crossings, reason)
    return _answer(passage, rig, scene, prior, whole, fit)


def _not_measurable(crossings: Crossings, reason: Said) -> Motion:
    return Motion("direct", crossings, "not_measurable", reason)


def _prepared(passage: Passage, rig: Rig) -> tuple[Scene, State, Prior]:
    c = passage.crossings
    baseline, _ = baseline_of(rig)
    clock = Clock(c.front_line_1, rig.line_rate_hz)
    crossed = clock.seconds(np.array([c.front_line_1, c.rear_line_1, c.front_line_2, c.rear_line_2]))
    course = solved_by_boundaries(crossed, baseline)
    lines_per_m = rig.line_rate_hz / course.speed_mps
    step = max(1, round(SAMPLE_M * lines_per_m))
    band = max(1, passage.first.shape[1] // ROWS)
    noise = passage.noise_dn / float(np.sqrt(step * band))
    soft = softness(noise)
    first = pool_picture(passage.first, passage.start_1, step, band, soft)
    second = pool_picture(passage.second, passage.start_2, step, band, soft)
    inside = silhouette(first, passage.background_1, passage.noise_dn)
    span = first.place(np.array([c.front_line_1, c.rear_line_1]))
    inside[: max(round(span[0]) - 4, 0)] = False
    inside[max(round(span[1]) + 5, 0) :] = False
    points = choose_points(first, inside, MOST_POINTS, noise)
    per_m = lines_per_m / step
    block = _blocks(points, BLOCK_M * per_m, BLOCK_ROWS)
    cell_lines = _whole(CELL_M * per_m)
    cell = _blocks(points, cell_lines, int(np.clip(round(noise / 2.5), 1, 4)))
    clusters = tuple(_blocks(points, cells * cell_lines, ROWS + 1) for cells in CELLS_A_CLUSTER)
    prior = Prior()
    if rig.misalignment_px is not None:
        prior = Prior(rig.misalignment_px / band, max(rig.u_misalignment_px, 0.005) / band)
    scene = Scene(
        first=first,
        second=second,
        points=points,
        block=block,
        cell=cell,
        clusters=clusters,
        clock=clock,
        lines_per_m=lines_per_m,
        noise_dn=noise,
    )
    return scene, State(course, prior.shift), prior


def _whole(size: float) -> int:
    return max(2, round(size))


def _blocks(points: Points, size: float, rows: int) -> NDArray[np.intp]:
    """Numbers of the cells of size x rows in which the points lie; some numbers stay without a point."""
    if not len(points):
        return np.empty(0, np.intp)
    column = points.place.astype(np.intp) // _whole(size)
    number = (column - column.min()) * (ROWS * 2 // rows + 2) + points.row.astype(np.intp) // rows
    return np.asarray(number, np.intp)


def _coarse_to_fine(scene: Scene, start: State, prior: Prior) -> tuple[Fit, Fit]:
    """On sheets pooled COARSE times along time, then on the full ones, whose two fits are returned.

    The first of them solves for all five unknowns, the second for the motion alone, with a gain and an
    offset for every small piece of every row.
    """
    state, free = start, (True, True, False, True, True)
    if len(scene.first.values) >= 40 * COARSE:
        first, second = coarsen_sheet(scene.first, COARSE), coarsen_sheet(scene.second, COARSE)
        few = max(1, len(scene.points) // COARSE_POINTS)
        points = points_at(first, scene.points.place[::few] / COARSE, scene.points.row[::few])
        block = _blocks(points, 8, BLOCK_ROWS)
        state = register(first, second, points, scene.clock, state, prior, block, free, None, 3).state
    args = scene.first, scene.second, scene.points, scene.clock
    few = max(1, len(scene.points) // SHIFT_POINTS)
    block = scene.block[::few]
    whole = register(*args[:2], scene.points.every(few), scene.clock, state, prior, block)
    return whole, register(*args, whole.state, prior, scene.block, free, scene.cell)


def _distrusted(fit: Fit, scene: Scene, start: State, rig: Rig) -> Said | None:
    """Why the registration's end is not to be believed, or None.

    Where a line at either end is a quarter of the way from camera to camera, boundaries a line off say
    another speed than pictures that fit: then it is the lines that are too few.
    """
    used = fit.weight > 0.05
    if used.sum() < FEWEST_POINTS:
        return NO_TEXTURE
    if not GAINS[0] < fit.state.gain < GAINS[1]:  # the search ended at its wall, not at an answer
        return NO_MATCH
    course, began = fit.state.course, start.course
    moved = abs(course.speed_mps / began.speed_mps - 1)
    # so much of its speed has the vehicle's rear gained otherwise than the boundaries say
    seconds = float(np.ptp(fit.look.first_s[used]))
    bent = abs(course.acceleration_mps2 - began.acceleration_mps2) * seconds / began.speed_mps
    # by how many samples the pictures typically miss each other, noise taken off
    noise = 1.5 * softened_noise(scene.noise_dn)
    left = np.sqrt(max(fit.scale_dn**2 - noise**2, 0.0))
    missed = left / max(robust_scale(fit.look.along), 1e-6)
    # away from what the boundaries say, by pictures that miss each other: both limits on simulated vehicles
    # side by side or stopping; single ones miss each other by up to 0.34 samples at 2 DN, 0.47 at 8 DN
    apart = (moved > 0.05 and missed > 0.25) or (max(moved, bent) > 0.02 and missed > 0.6)
    lines = began.baseline_m / began.speed_mps * rig.line_rate_hz
    if moved > MOST_MOVED and 2 / lines > MOST_MOVED:
        return too_few_lines(lines)
    return NO_MATCH if moved > MOST_MOVED or apart or abs(course.acceleration_mps2) > 11.5 else None


def _answer(passage: Passage, rig: Rig, scene: Scene, prior: Prior, whole: Fit, fit: Fit) -> Motion:
    c, course = passage.crossings, fit.state.course
    shift, u_shift = whole.state.shift, _u_shift(scene, prior, whole)
    slopes = slopes_of(scene.first, scene.second, scene.points, scene.clock, fit, scene.block, 2, scene.cell)
    spread = np.mean([covariance(slopes, one, fit, prior) for one in scene.clusters], axis=0)
    budget = budget_of(passage, rig, scene.clock, fit, spread, u_shift, baseline_of(rig))
    profile = _profile(scene, fit, rig)
    return Motion(
        method="direct",
        crossings=c,
        status="ok",
        reason=None,
        speed_mps=course.speed_mps,
        u_speed_mps=budget.u_speed_mps,
        acceleration_mps2=course.acceleration_mps2,
        u_acceleration_mps2=budget.u_acceleration_mps2,
        length_m=budget.length_m,
        u_length_m=budget.u_length_m,
        fit_error_percent=_fit_error(profile),
        misalignment_px=shift * scene.first.band,
        u_misalignment_px=u_shift * scene.first.band,
        gain=fit.state.gain,
        budget=budget.entries,
        profile=profile,
        warnings=_warnings(passage, _has_settled(fit, spread), budget.apart_m),
        correlation=budget.correlation,
    )


def _u_shift(scene: Scene, prior: Prior, whole: Fit) -> float:
    """Standard uncertainty of the row shift, rows of the sheets.

    A row's own gain errs alike all along the vehicle, so rows are clusters too, and both variances add up
    (Cameron, Gelbach and Miller 2011; what both count is small and left in).
    """
    few = round(len(scene.points) / len(whole.weight))
    points = scene.points.every(few)
    slopes = slopes_of(scene.first, scene.second, points, scene.clock, whole, scene.block[::few], 5)
    clusters = scene.clusters[0][::few], points.row.astype(np.intp)
    variance = sum(covariance(slopes, cluster, whole, prior)[2, 2] for cluster in clusters)
    return float(np.sqrt(variance))


def _has_settled(fit: Fit, spread: Floats) -> bool:
    """Whether the last round was small enough to stop at, or moved speed and acceleration, and what follows
    from both, by less than SETTLED of what the fit's own covariance `spread` (2, 2) lets them be off by.
    """
    if fit.settled:
        return True
    variance, axes = np.linalg.eigh(spread)
    # of what the covariance does not know at all no step is small
    moved = (axes.T @ fit.last_step[:2]) ** 2 / np.maximum(variance, np.finfo(float).tiny)
    return bool(moved.sum() <= SETTLED**2)


def _warnings(passage: Passage, has_settled: bool, apart_m: float) -> tuple[Said, ...]:
    """What a person should look at before believing the numbers."""
    warnings = []
    if not has_settled:
        warnings.append(Said("scan-motion-not-converged"))
    if apart_m > UNLIKE_M:
        warnings.append(Said("scan-motion-cameras-disagree", apart_cm=round(100 * apart_m)))
    if max(_saturated(passage.first), _saturated(passage.second)) > MOST_SATURATED:
        warnings.append(Said("scan-motion-saturated"))
    return tuple(warnings)


def _saturated(picture: Pixels) -> float:
    """The share of a picture's pixels that are as bright as they can be."""
    top = 255 if picture.dtype == np.uint8 else 65535
    return float(cv2.countNonZero(cv2.inRange(picture, top, top)) / max(picture.size, 1))


def _profile(scene: Scene, fit: Fit, rig: Rig) -> Profile:
    """What the points of each piece of the vehicle say alone, beside the fitted motion."""
    look = fit.look
    size = max(2, round(PROFILE_M * scene.lines_per_m / scene.first.step))
    piece = scene.points.place.astype(int) // size
    piece -= piece.min()
    count = int(piece.max()) + 1

    def total(values: Floats) -> Floats:
        return np.asarray(np.bincount(piece, weights=values, minlength=count))

    weight = fit.weight * look.inside
    information = total(weight * look.along**2)
    # residual = -gradient * error: the lines of the second sheet by which each piece strays
    stray = -total(weight * look.along * look.residual) / np.maximum(information, 1e-9) * scene.second.step
    share = np.maximum(total(weight), 1e-9)
    first_s, second_s = total(weight * look.first_s) / share, total(weight * look.second_s) / share
    baseline, _ = baseline_of(rig)
    fitted = baseline / np.maximum(second_s - first_s, 1e-9)
    own = baseline / np.maximum(second_s + stray / rig.line_rate_hz - first_s, 1e-9)
    clear = (
        information > 0.1 * np.median(information[information > 0])
        if (information > 0).any()
        else information > 0
    )
    kept = information > 0
    away = np.abs(own / fitted - 1)
    spread = robust_scale(away[clear]) if clear.any() else 0.0
    used = clear & (away <= 4 * spread + 1e-12)
    line = scene.clock.lines(first_s)
    return Profile(line[kept], own[kept], fitted[kept], used[kept])


def _fit_error(profile: Profile) -> float | None:
    """Root mean square of profile against fit, per cent of the speed."""
    used = profile.used
    if not used.any():
        return None
    return float(100 * np.sqrt(np.mean((profile.speed_mps[used] / profile.fitted_mps[used] - 1) ** 2)))
