"""Heights with their uncertainty: one click pair with its budget, or a million."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.enums import MeasurementStatus
from sightline.geometry.board_errors import board_covariance, board_parts, unknown_parts
from sightline.geometry.gradient import Gradient, gradient
from sightline.geometry.ray_intersection import (
    BAD_SIGMA,
    OK,
    REASONS,
    RayIntersection,
    contact_on_road,
    intersect_rays,
)
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

_CHUNK = 8192  # rows at a time: the working set stays in the processor's cache
_EDGE_FLAG = np.sin(np.deg2rad(10.0))
_LARGE_U_M = 0.03
_DOUBTS = (
    Said("height-flag-plane-oblique"),
    Said("height-flag-lens-edge"),
    Said("height-flag-far-from-board"),
    Said("height-flag-u-large"),
)


@dataclass(frozen=True)
class BudgetEntry:
    """One contribution to the standard uncertainty of a height."""

    source: str
    u_m: float


@dataclass(frozen=True)
class Height:
    """One height, or the reason why there is none (then every number is None).

    `u_height_m` is the root of the sum of the squares of `budget`. x_m, y_m: contact point on the road;
    distance_m: from the camera's centre to it.
    """

    status: MeasurementStatus
    reason: Said | None
    height_m: float | None = None
    u_height_m: float | None = None
    U95_height_m: float | None = None
    x_m: float | None = None
    y_m: float | None = None
    distance_m: float | None = None
    inset_m: float = 0.0
    u_inset_m: float = 0.0
    budget: tuple[BudgetEntry, ...] = field(default=())
    flags: tuple[Said, ...] = field(default=())


@dataclass(frozen=True, eq=False)
class Heights:
    """N heights as arrays (N,); NaN where `code` is not 0, `reason` then says why.

    `pose` and `doubts` (4, N), from which `flags` follow.
    """

    pose: RoadPose
    doubts: NDArray[np.bool_]
    code: NDArray[np.int8]
    height_m: Floats
    u_height_m: Floats
    x_m: Floats
    y_m: Floats
    distance_m: Floats

    @property
    def ok(self) -> NDArray[np.bool_]:
        """Which have a height, (N,)."""
        return np.asarray(self.code == OK, dtype=np.bool_)

    def reason(self, row: int) -> Said | None:
        """Why there is no height; None where there is one."""
        code = int(self.code[row])
        return None if code == OK else REASONS[code]

    def flags(self, row: int) -> tuple[Said, ...]:
        """What a reader should know of one height; none where there is no height."""
        return () if self.code[row] else _flags(self.pose, self.doubts[:, row])


def not_measurable(reason: Said, inset_m: float = 0.0, u_inset_m: float = 0.0) -> Height:
    """A height that is not there, and why."""
    return Height("not_measurable", reason, inset_m=inset_m, u_inset_m=u_inset_m)


def _entries(pose: RoadPose, g: Gradient, sigma_px: Floats, u_inset_m: Floats) -> dict[str, Floats]:
    """Variance of each source, (N,) each, for the heights of `g`."""
    click = np.square(sigma_px)
    out = {
        "click, target": click * np.square(g.target).sum(axis=0),
        "click, contact": click * np.square(g.contact).sum(axis=0),
        "inset": np.square(g.inset * u_inset_m),
    }
    if pose.covariance is not None:
        shared = np.einsum("ij,ij->j", pose.covariance @ g.parameters, g.parameters)
        out["lens and pose"] = np.maximum(shared, 0.0)
    for source, part in board_parts(pose).items():
        out[source] = np.square(part.T @ g.parameters[-6:]).sum(axis=0)
    return out


def _variance(g: Gradient, systematic: Floats, sigma_px: Floats | float, u_inset_m: Floats | float) -> Floats:
    """Variance of every height (N,), all sources together; `systematic` (n + 6, n + 6): lens, pose, board."""
    clicks = (g.target**2).sum(axis=0) + (g.contact**2).sum(axis=0)
    rest = np.einsum("ij,ij->j", systematic @ g.parameters, g.parameters)
    total = np.square(sigma_px) * clicks + np.maximum(rest, 0.0) + np.square(g.inset * u_inset_m)
    return np.asarray(total, dtype=np.float64)


def systematic_covariance(pose: RoadPose) -> Floats:
    """Covariance (n + 6, n + 6) of lens, pose and what the board may be off by; unknown parts left out.

    The pose's covariance with the board's added to its last six rows (CONVENTIONS.md, Pose).
    """
    n = len(pose.parameters)
    out = np.zeros((n, n)) if pose.covariance is None else np.array(pose.covariance)
    out[-6:, -6:] += board_covariance(pose)
    return out


@dataclass(frozen=True, eq=False)
class Parts:
    """What a number that was solved for is uncertain by: `u_own` of its vehicle alone, and what the vehicles
    of a pose share: `by_lens_pose` (n + 6,), its derivative by lens and pose, `by_heading` and `by_row_time`,
    what one standard uncertainty of the heading assumed and of the row time does to it.
    """

    u_own: float
    by_lens_pose: Floats
    by_heading: float = 0.0
    by_row_time: float = 0.0


def shared_covariance(pose: RoadPose, parts: Sequence[Parts]) -> Floats:
    """Covariance (N, N) of N numbers solved for under one pose, of what they share: lens, pose, board,
    heading and row time, in the square of the numbers' unit.

    JCGM 100:2008, 5.2.2, with S of `systematic_covariance`.
    """
    if not parts:
        return np.zeros((0, 0))
    by = np.stack([one.by_lens_pose for one in parts])
    others = np.array([(one.by_heading, one.by_row_time) for one in parts])
    return np.asarray(by @ systematic_covariance(pose) @ by.T + others @ others.T, dtype=np.float64)


def left_out(pose: RoadPose) -> list[Said]:
    """What the uncertainty of a height lacks because the pose does not say it."""
    out = []
    if pose.covariance is None:
        out.append(Said("height-flag-no-u-of-lens-and-pose"))
    elif pose.camera.covariance is None:
        out.append(Said("height-flag-no-u-of-lens"))
    missing = unknown_parts(pose)
    return out if missing is None else [*out, missing]


def _doubts(pose: RoadPose, intersection: RayIntersection, u_m: Floats) -> NDArray[np.bool_]:
    """Which of `_DOUBTS` holds for each height, (4, N); `u_m` (N,)."""
    norm = np.sqrt(intersection.target[0] ** 2 + intersection.target[1] ** 2 + 1.0)
    radius = np.maximum(np.hypot(*intersection.contact), np.hypot(*intersection.target))
    far_from_board = np.zeros(len(u_m), dtype=np.bool_)
    if pose.board is not None and pose.board.distance_m > 0:
        ratio = intersection.plane_m / pose.board.distance_m
        far_from_board = (ratio <= 0.4) | (ratio >= 2.5)
    return np.stack(
        [
            np.abs(intersection.w_target_y) < _EDGE_FLAG * norm,
            radius > 0.9 * pose.camera.limit.radius,
            far_from_board,
            u_m > _LARGE_U_M,
        ]
    )


def _flags(pose: RoadPose, doubts: NDArray[np.bool_]) -> tuple[Said, ...]:
    """One height's flags; `doubts` (4,)."""
    return (*left_out(pose), *(flag for flag, holds in zip(_DOUBTS, doubts, strict=True) if holds))


def measure_height(
    pose: RoadPose,
    contact_px: ArrayLike,
    target_px: ArrayLike,
    sigma_px: float = 1.0,
    inset_m: float = 0.0,
    u_inset_m: float = 0.0,
) -> Height:
    """The height of a target above the road from two clicks, with its budget (GUM: JCGM 100:2008, 5.1.2).

    Dupuis et al. 2019, eqs. (5) to (18), corrected as in ray_intersection.py, with the inset that they leave
    out (CONVENTIONS.md, Height).

    Parameters
    ----------
    pose : RoadPose
    contact_px, target_px : (2,) array
        Pixels of the tyre's contact with the road and of the target.
    sigma_px : float
        Standard uncertainty of each coordinate of each click, px.
    inset_m, u_inset_m : float
        How far the target lies behind the side plane through the contact, and its u, metres.

    Returns
    -------
    Height
        Metres, with `u_height_m` (k = 1), `U95_height_m` and the budget. Never raises for what was clicked: a
        height that cannot be had comes back with its reason.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> pose = sightline.site_pose(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> contact, roof = sightline.project(camera, pose.to_camera(np.array([[0, 0, 0], [0, 0.3, 1.45]])))
    >>> found = sightline.measure_height(pose, contact, roof, sigma_px=0.7, inset_m=0.3, u_inset_m=0.05)
    >>> round(found.height_m, 3), round(found.U95_height_m, 3)
    (1.45, 0.008)
    """
    contact = np.asarray(contact_px, dtype=np.float64).reshape(1, 2)
    target = np.asarray(target_px, dtype=np.float64).reshape(1, 2)
    return measure_with_budgets(pose, contact, target, [sigma_px], [inset_m], [u_inset_m])[0]


def measure_with_budgets(
    pose: RoadPose,
    contacts_px: ArrayLike,
    targets_px: ArrayLike,
    sigma_px: ArrayLike,
    inset_m: ArrayLike,
    u_inset_m: ArrayLike,
) -> list[Height]:
    """`measure_height` of N clicks: contacts_px, targets_px (N, 2); sigma_px, inset_m, u_inset_m (N,).

    JCGM 100:2008, 5.1.2, like the one; never raises for what was clicked.
    """
    contacts = np.asarray(contacts_px, dtype=np.float64).reshape(-1, 2)
    targets = np.asarray(targets_px, dtype=np.float64).reshape(-1, 2)
    sigma, inset, u_inset = (np.asarray(v, dtype=np.float64) for v in (sigma_px, inset_m, u_inset_m))
    found: list[Height] = []
    for start in range(0, len(contacts), _CHUNK):
        part = slice(start, start + _CHUNK)
        found += _with_budgets(pose, contacts[part], targets[part], sigma[part], inset[part], u_inset[part])
    return found


def _with_budgets(
    pose: RoadPose, contacts: Floats, targets: Floats, sigma: Floats, inset: Floats, u_inset: Floats
) -> list[Height]:
    intersection = intersect_rays(pose, contacts, targets, inset)
    bad = ~(np.isfinite(sigma) & np.isfinite(inset) & np.isfinite(u_inset) & (sigma >= 0) & (u_inset >= 0))
    with np.errstate(all="ignore"):  # rows without a height have numbers that nobody reads
        variances = _entries(pose, gradient(pose, intersection), sigma, u_inset)
        squares = np.stack(list(variances.values()))
        u_m, parts_m = np.sqrt(squares.sum(axis=0)), np.sqrt(squares)
        doubts = _doubts(pose, intersection, u_m)
    x_m, y_m, distance_m = contact_on_road(pose, intersection)
    out: list[Height] = []
    for n, code in enumerate(np.where(bad, BAD_SIGMA, intersection.code).tolist()):
        if code == BAD_SIGMA:
            out.append(not_measurable(REASONS[BAD_SIGMA]))
        elif code != OK:
            out.append(not_measurable(REASONS[code], float(inset[n]), float(u_inset[n])))
        else:
            out.append(
                Height(
                    status="ok",
                    reason=None,
                    height_m=float(intersection.height_m[n]),
                    u_height_m=float(u_m[n]),
                    U95_height_m=COVERAGE_95 * float(u_m[n]),
                    x_m=float(x_m[n]),
                    y_m=float(y_m[n]),
                    distance_m=float(distance_m[n]),
                    inset_m=float(inset[n]),
                    u_inset_m=float(u_inset[n]),
                    budget=tuple(map(BudgetEntry, variances, parts_m[:, n].tolist())),
                    flags=_flags(pose, doubts[:, n]),
                )
            )
    return out


def height_both(
    pose: RoadPose,
    contact_px: ArrayLike,
    target_px: ArrayLike,
    sigma_px: float = 1.0,
    inset_m: float = 0.0,
    u_inset_m: float = 0.0,
) -> tuple[Height, Height]:
    """The height corrected by the inset, and the paper's uncorrected one (inset 0); contact_px, target_px
    (2,).

    As `measure_height`, twice.
    """
    contacts = np.tile(np.asarray(contact_px, dtype=np.float64).reshape(1, 2), (2, 1))
    targets = np.tile(np.asarray(target_px, dtype=np.float64).reshape(1, 2), (2, 1))
    insets, u_insets = (inset_m, 0.0), (u_inset_m, 0.0)
    corrected, flat = measure_with_budgets(pose, contacts, targets, (sigma_px, sigma_px), insets, u_insets)
    return corrected, flat


def measure_heights(
    pose: RoadPose,
    contacts_px: ArrayLike,
    targets_px: ArrayLike,
    sigma_px: ArrayLike = 1.0,
    inset_m: ArrayLike = 0.0,
    u_inset_m: ArrayLike = 0.0,
    with_uncertainty: bool = True,
) -> Heights:
    """N heights, each as `measure_height` gives it, without the budgets.

    Parameters
    ----------
    pose : RoadPose
    contacts_px, targets_px : (N, 2) array
        Pixels of the contacts and of the targets.
    sigma_px : float or (N,) array
        Standard uncertainty of each coordinate of each click, px.
    inset_m, u_inset_m : float or (N,) array
        How far each target lies behind the side plane through its contact, and its u, metres.
    with_uncertainty : bool
        `u_height_m` is NaN where it is False.

    Returns
    -------
    Heights
        Arrays (N,), metres; NaN where there is no height, `reason(row)` then says why.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> pose = sightline.site_pose(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> points = np.array([[0, 0, 0], [0.5, 0, 0], [0, 0, 1.45], [0.5, 0, 1.12]])
    >>> pixels = sightline.project(camera, pose.to_camera(points))
    >>> sightline.measure_heights(pose, pixels[:2], pixels[2:]).height_m.round(3).tolist()
    [1.45, 1.12]
    """
    contacts = np.asarray(contacts_px, dtype=np.float64).reshape(-1, 2)
    targets = np.asarray(targets_px, dtype=np.float64).reshape(-1, 2)
    n = len(contacts)
    sigma, inset, u_inset = (
        np.broadcast_to(np.asarray(v, dtype=np.float64), (n,)) for v in (sigma_px, inset_m, u_inset_m)
    )
    code = np.zeros(n, dtype=np.int8)
    out = np.full((5, n), np.nan)
    doubts = np.zeros((len(_DOUBTS), n), dtype=np.bool_)
    systematic = systematic_covariance(pose) if with_uncertainty else None
    for start in range(0, n, _CHUNK):
        part = slice(start, start + _CHUNK)
        intersection = intersect_rays(pose, contacts[part], targets[part], inset[part])
        codes, results = code[part], out[:, part]  # views: filled in place
        u_px, u_m = sigma[part], u_inset[part]
        codes[:] = intersection.code
        fine = np.isfinite(u_px) & np.isfinite(inset[part]) & np.isfinite(u_m) & (u_px >= 0) & (u_m >= 0)
        codes[~fine] = BAD_SIGMA
        results[0] = intersection.height_m
        results[2], results[3], results[4] = contact_on_road(pose, intersection)
        with np.errstate(all="ignore"):
            if systematic is not None:
                results[1] = np.sqrt(_variance(gradient(pose, intersection), systematic, u_px, u_m))
            doubts[:, part] = _doubts(pose, intersection, results[1])
        results[:, codes != OK] = np.nan
    return Heights(pose, doubts, code, *out)
