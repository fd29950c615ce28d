"""A pose adjusted by its traffic, as a geodesist adjusts a network, and what that says of itself."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import scipy

from sightline.adjustment.local_tests import FAILED, Cleaned, solve_without_outliers
from sightline.adjustment.observed import (
    DEFAULT_U_COMMON_M,
    LENGTHS,
    POINTS,
    ROOF,
    ObservedPass,
    shared_insets,
    unusable_pass_reason,
)
from sightline.adjustment.shared_errors import Part, SharedErrors, covariance_at, moved_pose, shared_errors
from sightline.adjustment.traffic_model import HEADING, Traffic, arrange_passes, on_road
from sightline.arrays import Bools, Floats
from sightline.errors import BadInput
from sightline.geometry.road_pose import POSE_NAMES, RoadPose
from sightline.messages.said import Said

_GLOBAL_FAILED = 0.001  # probability below which the global test fails
_FEW = 5


@dataclass(frozen=True)
class LeftOut:
    """A pass that was not used, and why."""

    name: str
    reason: Said


@dataclass(frozen=True)
class DroppedPoint:
    """A point that does not fit the straight way of its pass; the rest of the pass was used."""

    name: str
    frame: int
    point: str


@dataclass(frozen=True)
class Moved:
    """One shared error: what it was found to be (new minus old), and its standard uncertainty before and
    after, in the unit that its name ends in. `by_u`: how many u_before it moved by; None of what could not.
    `of_m`: the inset that it is the common error of.
    """

    name: str
    value: float
    u_before: float
    u_after: float
    by_u: float | None
    of_m: float | None = None


@dataclass(frozen=True)
class Adjustment:
    """The adjusted pose and the account of it. `chi2_limit`: what chi2 stays below 999 times in 1000 where
    the stated uncertainties hold; None with nothing to test. `notes`: whole sentences.
    """

    pose: RoadPose
    passes: int
    used: int
    left_out: tuple[LeftOut, ...]
    dropped_points: tuple[DroppedPoint, ...]
    chi2: float
    degrees_of_freedom: int
    chi2_limit: float | None
    moved: tuple[Moved, ...]
    heading_rad: float | None = None
    u_heading_rad: float | None = None
    notes: tuple[Said, ...] = field(default=())


def adjust(
    pose: RoadPose,
    passes: Sequence[ObservedPass],
    u_wheelbase_common_m: float = DEFAULT_U_COMMON_M,
    u_roof_common_m: float = DEFAULT_U_COMMON_M,
) -> Adjustment:
    """Solve for what all heights of a pose share, from passes with known wheelbases and roofs.

    Generalised least squares (JCGM 102:2011, 5) with the stated uncertainties of lens, pose and board as
    prior observations; CONVENTIONS.md, Adjustment.

    Parameters
    ----------
    pose : RoadPose
    passes : sequence of ObservedPass
        Pixels `points_px` (N, 2) of points of one vehicle on its way, and the lengths known of it, metres.
    u_wheelbase_common_m, u_roof_common_m : float
        Standard uncertainty of what all known wheelbases, all known roofs are off by together, metres.

    Returns
    -------
    Adjustment
        `pose` carries everything in its covariance, so its board's own uncertainties are 0; where no vehicle
        is known it comes back as it was. With chi2 and what was left out.

    Raises
    ------
    BadInput
        Where the pose states no uncertainty, or most passes contradict one another.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> pose = sightline.site_pose(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> def drive(number):
    ...     points = np.tile([[0.0, 0.0, 0.0], [1.2, 0.0, 0.0], [0.6, 0.2, 1.45]], (4, 1))
    ...     points[:, 0] += np.repeat(np.linspace(-0.9, 0.0, 4), 3)
    ...     return sightline.ObservedPass(
    ...         name=f"{number}", frame=np.repeat(np.arange(4), 3), point=np.tile([0, 1, 2], 4),
    ...         points_px=sightline.project(camera, pose.to_camera(points)), sigma_px=np.full(12, 0.3),
    ...         wheelbase=sightline.Known(1.2, 0.005), roof=sightline.Known(1.45, 0.01),
    ...         roof_inset=sightline.Known(0.2, 0.05))
    >>> found = sightline.adjust(pose, [drive(number) for number in range(6)])
    >>> found.used, [one.name for one in found.moved if one.u_after < 0.5 * one.u_before]
    (6, ['board_roll_rad', 'roof_inset_common_m', 'road_roll_rad', 'rz_rad'])
    """
    usable, left_out = _usable(pose, passes)
    shared = shared_errors(pose, u_wheelbase_common_m, u_roof_common_m, shared_insets(usable))
    if not shared.root.any():
        raise BadInput("adjustment-nothing-uncertain")
    if not usable:
        return _unchanged(shared, len(passes), left_out)
    traffic = arrange_passes(pose, usable)
    fit = solve_without_outliers(shared, traffic)
    wrong = np.isfinite(fit.wrong).any(axis=1)
    out = wrong | fit.crooked
    if 2 * out.sum() > len(usable):
        raise BadInput("adjustment-contradictory", out=int(out.sum()), passes=len(usable))
    left_out += [LeftOut(one.name, _reason(traffic, fit, row)) for row, one in enumerate(usable) if out[row]]
    freedom = _freedom(traffic, fit, ~out)
    limit = float(scipy.special.chdtri(freedom, _GLOBAL_FAILED)) if freedom > 0 else None
    heading, u_heading = _heading(fit, ~out)
    return Adjustment(
        pose=_adjusted(shared, fit),
        passes=len(passes),
        used=int((~out).sum()),
        left_out=tuple(left_out),
        dropped_points=_dropped(usable, traffic, fit, ~out),
        chi2=fit.solution.chi2,
        degrees_of_freedom=freedom,
        chi2_limit=limit,
        moved=_moved_by(shared, fit.solution.z, fit.solution.covariance),
        heading_rad=heading,
        u_heading_rad=u_heading,
        notes=_notes(shared, fit, int((~out).sum()), freedom, limit),
    )


def _usable(pose: RoadPose, passes: Sequence[ObservedPass]) -> tuple[list[ObservedPass], list[LeftOut]]:
    usable, left_out = [], []
    reasons = [unusable_pass_reason(one) for one in passes]
    points = [one.points_px for one in passes]
    seen = on_road(pose, np.concatenate(points or [np.zeros((0, 2))]))
    ground = np.asarray(np.isfinite(seen).all(axis=1), dtype=np.bool_)
    ends = np.cumsum([len(one) for one in points])
    for observed, reason, end in zip(passes, reasons, ends, strict=True):
        if reason is None and not pose.camera.inside(observed.points_px).all():
            reason = Said("adjustment-point-outside")
        if reason is None and not all(
            np.array(ground[end - len(observed.point) : end], dtype=bool)[observed.point != ROOF].tolist()
        ):
            reason = Said("adjustment-tyre-off-road")
        if reason is None:
            usable.append(observed)
        else:
            left_out.append(LeftOut(observed.name, reason))
    return usable, left_out


def _reason(traffic: Traffic, found: Cleaned, row: int) -> Said:
    if found.crooked[row]:
        return Said("adjustment-crooked")
    k = int(np.nanargmax(np.abs(found.wrong[row])))
    u = float(found.wrong[row, k])
    return Said(
        "adjustment-length-off",
        length=LENGTHS[k],
        known_m=round(float(traffic.known_m[row, k]), 3),
        deviate=round(abs(u), 1),
        than="long" if u > 0 else "short",
    )


def _dropped(
    usable: Sequence[ObservedPass], traffic: Traffic, found: Cleaned, used: Bools
) -> tuple[DroppedPoint, ...]:
    rows = np.flatnonzero(found.dropped & used[traffic.owner])
    ones = [(usable[traffic.owner[row]], int(traffic.slot[row])) for row in rows]
    return tuple(DroppedPoint(one.name, int(one.frame[k]), POINTS[int(one.point[k])]) for one, k in ones)


def _freedom(traffic: Traffic, fit: Cleaned, used: Bools) -> int:
    """Coordinates and known lengths less the unknowns that any of them shows; a shared error comes with an
    observation of its own, its prior.
    """
    kept = (fit.weights.points > 0) & used[traffic.owner]
    coordinates = 2 * np.bincount(traffic.owner[kept], minlength=traffic.passes)
    information = np.square(fit.solution.at.own).sum(axis=1)
    lengths = np.isfinite(traffic.u_m).sum(axis=1)
    free = coordinates + lengths - (information > 1e-9).sum(axis=1)
    return int(np.maximum(free, 0)[used].sum())


def _heading(fit: Cleaned, used: Bools) -> tuple[float, float]:
    """The passes' mean direction against the road's X, and what the adjustment says of its uncertainty: what
    is each pass's own, enlarged where they scatter by more (Birge 1932), and what the shared errors turn all
    by.
    """
    solution = fit.solution
    weight = 1.0 / (solution.pass_covariance[used, HEADING, HEADING] + np.deg2rad(0.3) ** 2)
    headings = solution.unknown[used, HEADING]
    mean = float((weight * headings).sum() / weight.sum())
    scatter = float((weight * (headings - mean) ** 2).sum()) / max(len(headings) - 1, 1)
    cross = np.swapaxes(solution.at.own, 1, 2) @ solution.at.shared
    turned = (solution.pass_covariance @ cross)[used, HEADING, :]
    common = weight @ turned / weight.sum()
    return mean, float(np.sqrt(max(scatter, 1.0) / weight.sum() + common @ solution.covariance @ common))


def _adjusted(shared: SharedErrors, found: Cleaned) -> RoadPose:
    increments = shared.root @ found.solution.z
    covariance = shared.root @ found.solution.covariance @ shared.root.T
    moved = moved_pose(shared.pose, increments)
    covariance = covariance_at(shared.pose, increments, covariance)
    return _fold_board_into_covariance(moved, 0.5 * (covariance + covariance.T))


def _fold_board_into_covariance(pose: RoadPose, covariance: Floats) -> RoadPose:
    """The pose with everything in its covariance, and a board that adds nothing any more."""
    n = len(pose.camera.parameters)
    board = pose.board
    if board is not None:
        bow = None if board.u_bow_m is None or board.bow_response is None else 0.0
        board = replace(board, u_reference_height_m=0.0, u_lean_rad=0.0, u_square_m=0.0, u_bow_m=bow)
    camera = pose.camera
    if camera.covariance is not None:
        camera = replace(camera, covariance=covariance[:n, :n])
    return replace(pose, camera=camera, board=board, covariance=covariance)


def _moved_by(shared: SharedErrors, z: Floats, covariance: Floats) -> tuple[Moved, ...]:
    """The parts by name, what they and the pose come to (the camera's height above the road, the road's turn
    about X and about Y), then lens and pose.
    """
    first, u = shared.first_part, np.sqrt(np.diag(covariance))
    out = [
        _entry(part.name, part.u * float(z[first + i]), part.u, part.u * float(u[first + i]), part.of_m)
        for i, part in enumerate(shared.parts)
    ]
    increments = shared.root @ z
    before, after = shared.root @ shared.root.T, shared.root @ covariance @ shared.root.T
    up = np.concatenate([np.zeros(len(before) - 3), -shared.pose.rotation[:, 2]])
    height = moved_pose(shared.pose, increments).centre_m[2] - shared.pose.centre_m[2]
    out.append(_entry("camera_height_m", float(height), _along(up, before), _along(up, after)))
    lean, roll = (
        np.concatenate([np.zeros(len(before) - 6), shared.pose.rotation[:, axis], np.zeros(3)])
        for axis in (0, 1)
    )
    names = (*shared.pose.camera.parameters, *(f"{n}_{'rad' if n[0] == 'r' else 'm'}" for n in POSE_NAMES))
    for name, by in (
        ("road_lean_rad", lean),
        ("road_roll_rad", roll),
        *zip(names, np.eye(len(before)), strict=True),
    ):
        out.append(_entry(name, float(by @ increments), _along(by, before), _along(by, after)))
    return tuple(out)


def _entry(name: str, value: float, u_before: float, u_after: float, of_m: float | None = None) -> Moved:
    by_u = abs(value) / u_before if u_before > 0.0 else None
    return Moved(name, value, u_before, u_after, by_u, of_m=of_m)


def _along(by: Floats, covariance: Floats) -> float:
    return float(np.sqrt(max(float(by @ covariance @ by), 0.0)))


def _notes(
    shared: SharedErrors, fit: Cleaned, used: int, freedom: int, limit: float | None
) -> tuple[Said, ...]:
    notes = []
    for index in fit.released:
        part, (u, unit) = shared.parts[index], _stated(shared.parts[index])
        notes.append(Said("adjustment-part-excluded", part=part.name, u=u, unit=unit))
    for index in range(-shared.commons, 0):
        if abs(float(np.nan_to_num(fit.tests.parts[index]))) > FAILED:
            part, (u, unit) = shared.parts[index], _stated(shared.parts[index])
            notes.append(Said("adjustment-common-far-off", part=part.name, u=u, unit=unit))
    if fit.point_factor > 1.0:
        notes.append(Said("adjustment-points-scatter", factor=round(fit.point_factor, 1)))
    for name, factor in zip(LENGTHS, fit.length_factors, strict=True):
        if factor > 1.0:
            notes.append(Said("adjustment-lengths-scatter", length=name, factor=round(float(factor), 1)))
    if limit is not None and fit.solution.chi2 > limit:
        chi2 = round(fit.solution.chi2)
        notes.append(Said("adjustment-global-test-failed", chi2=chi2, freedom=freedom))
    if used < _FEW:
        notes.append(Said("adjustment-few-vehicles", count=used))
    return tuple(notes)


def _stated(part: Part) -> tuple[float, str]:
    """What was stated of a part, and the unit that its name ends in."""
    return float(f"{part.u:.3g}"), part.name.rpartition("_")[2]


def _unchanged(shared: SharedErrors, passes: int, left_out: list[LeftOut]) -> Adjustment:
    """Nothing is known of the vehicles: the pose as it was, its board's budget in its covariance."""
    identity = np.eye(shared.size)
    return Adjustment(
        pose=_fold_board_into_covariance(shared.pose, shared.root @ shared.root.T),
        passes=passes,
        used=0,
        left_out=tuple(left_out),
        dropped_points=(),
        chi2=0.0,
        degrees_of_freedom=0,
        chi2_limit=None,
        moved=_moved_by(shared, np.zeros(shared.size), identity),
        notes=(Said("adjustment-pose-unchanged"),),
    )
