"""Where the points of straight passes are seen, with all derivatives; every pass at once.

On one frame a vehicle stands s along its way from a place (X_0, y), X_0 fixed. With the heading psi of its
way against the road's X, a point that is o ahead of the rear tyre, c behind the side plane and H above the
road is at

    X = X_0 + (s + o) cos psi - c sin psi,   Y = y + (s + o) sin psi + c cos psi,   Z = H

    rear tyre   o = 0, c = 0, H = 0      front tyre   o = +-W, c = 0, H = 0      roof   o = a, c = inset, H

Unknown of a pass, in this order: y, psi, W (signed by the way it faces), a, inset, H, then s of each frame.
Own derivation; the least squares are those of a network with free coordinates for each vehicle (Triggs et al.
2000, bundle adjustment).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.adjustment.observed import FRONT, LENGTHS, REAR, ROOF, Known, ObservedPass, shared_insets
from sightline.adjustment.shared_errors import SharedErrors, moved_pose
from sightline.arrays import Floats
from sightline.coverage import MEAN_OF_INSET
from sightline.geometry.arrays import skew
from sightline.geometry.camera import project_with_jacobians, undistort
from sightline.geometry.road_pose import RoadPose

ACROSS, HEADING, WHEELBASE, AHEAD, INSET, HEIGHT, PLACES = range(7)
# What is taken for granted of a vehicle of which nothing is known: wide enough to say nothing (estimates).
_GUESS = (0.0, 0.0, 3.0, 0.0, 0.5, 1.6)
_U_GUESS = (100.0, 0.1, 3.0, 10.0, 0.5, 1.0)
_U_PLACE_M = 100.0
_LEAST_U_M = 1e-5  # a length stated as exact; a micrometre would spoil the arithmetic


@dataclass(frozen=True, eq=False)
class Traffic:
    """P passes as arrays. Points (N): `owner` their pass, `slot` their place within it, `place` the index
    of their frame's s among the pass's unknowns, `kind`, `points_px` (N, 2), `sigma_px`. Lengths (P, 3), in
    the order of LENGTHS: `known_m`, `u_m` (infinite: unknown) beside what it shares with others, which is
    `common` of SharedErrors.common (-1: nothing). `facing` (P,): +1 where the front is towards X. `start`
    (P, K) unknowns; `middle_m` (P,): X_0.
    """

    owner: NDArray[np.intp]
    slot: NDArray[np.intp]
    place: NDArray[np.intp]
    kind: NDArray[np.int64]
    points_px: Floats
    sigma_px: Floats
    known_m: Floats
    u_m: Floats
    common: NDArray[np.intp]
    facing: Floats
    middle_m: Floats
    start: Floats
    frames: NDArray[np.intp]

    @property
    def passes(self) -> int:
        """How many passes there are."""
        return len(self.facing)

    @property
    def slots(self) -> int:
        """How many points the longest pass has."""
        return int(self.slot.max(initial=0)) + 1


@dataclass(frozen=True, eq=False)
class Linear:
    """Whitened residuals (P, R), seen minus modelled, and their derivatives by the pass's own unknowns
    (P, R, K) and by the shared z (P, R, m). Rows: x and y of each slot, then the lengths.
    """

    residual: Floats
    own: Floats
    shared: Floats


def arrange_passes(pose: RoadPose, passes: Sequence[ObservedPass]) -> Traffic:
    """The passes as arrays with a first estimate of each one's unknowns, from the pose as it is.

    Own method: tyres meet the road where their rays do; the roof lies where its ray meets the vertical plane
    behind them. Passes are to be usable (observed.unusable_pass_reason).
    """
    frames = [np.unique(one.frame, return_inverse=True) for one in passes]
    count = np.array([len(one) for one, _ in frames])
    start = np.zeros((len(passes), PLACES + int(count.max())))
    facing, middle = np.ones(len(passes)), np.zeros(len(passes))
    rays = np.split(_rays(pose, np.concatenate([one.points_px for one in passes])), _ends(passes))
    for row, (one, (_, at)) in enumerate(zip(passes, frames, strict=True)):
        middle[row], facing[row], first = _first_estimate(pose, one, at, int(count[row]), rays[row])
        start[row, : len(first)] = first
    lengths = [[_value_and_u(known) for known in one.lengths] for one in passes]
    table = np.array(lengths, dtype=np.float64).reshape(len(passes), len(LENGTHS), 2)
    insets: dict[Known | None, int] = {one: 2 + k for k, one in enumerate(shared_insets(passes))}
    common = np.array([(0, 1, insets.get(one.roof_inset, -1)) for one in passes], dtype=np.intp)
    table[common[:, 2] >= 0, 2, 1] *= (1.0 - MEAN_OF_INSET) ** 0.5
    return Traffic(
        owner=np.repeat(np.arange(len(passes)), [len(one.frame) for one in passes]),
        slot=np.concatenate([np.arange(len(one.frame)) for one in passes]),
        place=PLACES + np.concatenate([at for _, at in frames]),
        kind=np.concatenate([one.point for one in passes]),
        points_px=np.concatenate([one.points_px for one in passes]),
        sigma_px=np.concatenate([one.sigma_px for one in passes]),
        known_m=table[:, :, 0],
        u_m=table[:, :, 1],
        common=common,
        facing=facing,
        middle_m=middle,
        start=start,
        frames=count,
    )


def _ends(passes: Sequence[ObservedPass]) -> list[int]:
    """Where the points of each pass but the last end among all of them."""
    return [int(end) for end in np.cumsum([len(one.frame) for one in passes])[:-1]]


def _value_and_u(known: Known | None) -> tuple[float, float]:
    return (0.0, np.inf) if known is None else (known.value_m, max(known.u_m, _LEAST_U_M))


def _rays(pose: RoadPose, points_px: Floats) -> Floats:
    """Directions (N, 3) in the road's axes; NaN where the lens model has none."""
    seen = undistort(pose.camera, points_px)
    rays = np.column_stack([seen.points, np.ones(len(points_px))]) @ pose.rotation
    rays[~seen.ok] = np.nan
    return np.asarray(rays, dtype=np.float64)


def on_road(pose: RoadPose, points_px: Floats) -> Floats:
    """Where the rays of `points_px` (N, 2) meet the road, X and Y (N, 2), metres; NaN where they do not.

    Dupuis et al. 2019, section 2, p_l.
    """
    return _ground(pose, _rays(pose, points_px))


def _ground(pose: RoadPose, rays: Floats) -> Floats:
    with np.errstate(all="ignore"):
        far = -pose.centre_m[2] / rays[:, 2]
        ground = pose.centre_m[:2] + far[:, None] * rays[:, :2]
    ground[~(far > 0)] = np.nan
    return np.asarray(ground, dtype=np.float64)


def _first_estimate(
    pose: RoadPose, observed: ObservedPass, at: NDArray[np.intp], frames: int, rays: Floats
) -> tuple[float, float, Floats]:
    """X_0, the way it faces, and the unknowns (PLACES + frames,) of one pass."""
    ground = _ground(pose, rays)
    tyre = observed.point != ROOF
    across = float(np.nanmedian(ground[tyre, 1]))
    inset = _GUESS[INSET] if observed.roof_inset is None else observed.roof_inset.value_m
    along = np.full((3, frames), np.nan)
    for kind in (REAR, FRONT):
        along[kind, at[observed.point == kind]] = ground[observed.point == kind, 0]
    rays = rays[observed.point == ROOF]
    with np.errstate(all="ignore"):
        far = (across + inset - pose.centre_m[1]) / rays[:, 1]
        roof = pose.centre_m + far[:, None] * rays
    along[ROOF, at[observed.point == ROOF]] = roof[:, 0]
    wheelbase = _offset(along, FRONT)
    ahead = _offset(along, ROOF)
    facing = -1.0 if wheelbase < 0 else 1.0
    if not np.isfinite(wheelbase):
        wheelbase = _GUESS[WHEELBASE] if observed.wheelbase is None else observed.wheelbase.value_m
    height = float(np.nanmedian(roof[:, 2])) if len(roof) and np.isfinite(roof[:, 2]).any() else np.nan
    if not np.isfinite(height):
        height = _GUESS[HEIGHT] if observed.roof is None else observed.roof.value_m
    ahead = ahead if np.isfinite(ahead) else 0.5 * wheelbase
    rear = np.where(np.isfinite(along[REAR]), along[REAR], along[FRONT] - wheelbase)
    rear = np.where(np.isfinite(rear), rear, along[ROOF] - ahead)
    middle = float(np.nanmean(rear))
    place = np.nan_to_num(rear - middle)
    return middle, facing, np.concatenate([[across, 0.0, wheelbase, ahead, inset, height], place])


def _offset(along: Floats, kind: int) -> float:
    """How far points of this kind lie ahead of the rear tyre, from the frames that show both; NaN if none."""
    apart = along[kind] - along[REAR]
    return float(np.nanmedian(apart)) if np.isfinite(apart).any() else np.nan


def prior_information(traffic: Traffic) -> Floats:
    """Information (P, K) on each pass's unknowns that stands for knowing nothing: it only keeps what no point
    shows from being without an answer. Own method: the guesses of `_U_GUESS`.
    """
    u = np.full(traffic.start.shape, _U_PLACE_M)
    u[:, :PLACES] = _U_GUESS
    u[np.isfinite(traffic.u_m[:, -1]), INSET] = _U_PLACE_M
    return np.asarray(u**-2.0, dtype=np.float64)


def guesses(traffic: Traffic) -> Floats:
    """The values (P, K) that `prior_information` is about. Own method: as there."""
    out = np.zeros(traffic.start.shape)
    out[:, : len(_GUESS)] = _GUESS
    out[:, ACROSS] = traffic.start[:, ACROSS]
    out[:, WHEELBASE] *= traffic.facing
    return out


def linearise(
    shared: SharedErrors, traffic: Traffic, z: Floats, unknown: Floats, weight: Floats, length_weight: Floats
) -> Linear:
    """Residuals and derivatives at the shared z (m,) and the passes' `unknown` (P, K).

    `weight` (N,) and `length_weight` (P, 3) are roots of weights: 0 for what is left out. Own derivation: the
    module's equations and project_with_jacobians.
    """
    increments = shared.root @ z
    pose = moved_pose(shared.pose, increments)
    points, by_own = _points(traffic, unknown)
    at_cam = pose.to_camera(points)
    pixels, by_point, by_lens = project_with_jacobians(pose.camera, at_cam)
    # x_cam = Exp(r) (R x + t) + t': the turn acts on what lies before t'.
    turned = skew(at_cam - increments[-3:]) @ (np.eye(3) + 0.5 * skew(increments[-6:-3]))
    by_pose = np.concatenate([-by_point @ turned, by_point], axis=2)
    by_shared = np.concatenate([by_lens, by_pose], axis=2) @ shared.root
    scale = (weight / traffic.sigma_px)[:, None]
    rows = 2 * traffic.slots
    residual = np.zeros((traffic.passes, rows + len(LENGTHS)))
    own = np.zeros((*residual.shape, unknown.shape[1]))
    of_z = np.zeros((*residual.shape, shared.size))
    where = traffic.owner[:, None], 2 * traffic.slot[:, None] + np.arange(2)
    residual[where] = scale * (traffic.points_px - pixels)
    own[where] = scale[:, :, None] * np.einsum("nij,njk->nik", by_point @ pose.rotation, by_own)
    of_z[where] = scale[:, :, None] * by_shared
    _add_lengths(shared, traffic, z, unknown, length_weight, (residual, own, of_z))
    return Linear(residual, own, of_z)


def _points(traffic: Traffic, unknown: Floats) -> tuple[Floats, Floats]:
    """Road points (N, 3) and their derivatives (N, 3, K) by the unknowns of their passes."""
    mine, rows = unknown[traffic.owner], np.arange(len(traffic.owner))
    front, roof = traffic.kind == FRONT, traffic.kind == ROOF
    c, s = np.cos(mine[:, HEADING]), np.sin(mine[:, HEADING])
    ahead = np.where(front, mine[:, WHEELBASE], np.where(roof, mine[:, AHEAD], 0.0))
    behind = np.where(roof, mine[:, INSET], 0.0)
    along = mine[rows, traffic.place] + ahead
    points = np.stack(
        [
            traffic.middle_m[traffic.owner] + along * c - behind * s,
            mine[:, ACROSS] + along * s + behind * c,
            np.where(roof, mine[:, HEIGHT], 0.0),
        ],
        axis=1,
    )
    by = np.zeros((len(mine), 3, unknown.shape[1]))
    by[:, 1, ACROSS] = 1.0
    by[:, 0, HEADING], by[:, 1, HEADING] = -along * s - behind * c, along * c - behind * s
    forward = np.stack([c, s], axis=1)
    by[:, :2, WHEELBASE] = forward * front[:, None]
    by[:, :2, AHEAD] = forward * roof[:, None]
    by[:, :2, INSET] = np.stack([-s, c], axis=1) * roof[:, None]
    by[:, 2, HEIGHT] = roof
    by[rows, :2, traffic.place] = forward
    return points, by


def _add_lengths(
    shared: SharedErrors,
    traffic: Traffic,
    z: Floats,
    unknown: Floats,
    length_weight: Floats,
    into: tuple[Floats, Floats, Floats],
) -> None:
    """Known minus modelled lengths, with the error common to all of a kind, in the last rows."""
    residual, own, of_z = into
    scale = length_weight / traffic.u_m
    first = residual.shape[1] - len(LENGTHS)
    common_m = np.array([*(part.u for part in shared.common), 0.0])[traffic.common]
    columns = shared.size - shared.commons + traffic.common
    solved = (traffic.facing * unknown[:, WHEELBASE], unknown[:, HEIGHT], unknown[:, INSET])
    by = (traffic.facing, 1.0, 1.0)
    for k, index in enumerate((WHEELBASE, HEIGHT, INSET)):
        row = first + k
        residual[:, row] = scale[:, k] * (
            traffic.known_m[:, k] - solved[k] - common_m[:, k] * z[columns[:, k]]
        )
        own[:, row, index] = scale[:, k] * by[k]
        of_z[np.arange(traffic.passes), row, columns[:, k]] = scale[:, k] * common_m[:, k]
