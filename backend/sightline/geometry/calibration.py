"""Intrinsics from checkerboard views, with their full covariance and a verdict in words."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import chain, count
from typing import Any

import cv2
import numpy as np

from sightline.arrays import Floats
from sightline.enums import LensModel
from sightline.errors import BadInput
from sightline.geometry.arrays import exp_rotation, freeze_array
from sightline.geometry.board import Board, board_points, require_board
from sightline.geometry.board_shape import BoardShape, shape_basis
from sightline.geometry.bundle import from_scratch, refine_all, refine_bent
from sightline.geometry.camera import Camera, View
from sightline.geometry.corners import Corners, spacing_px
from sightline.geometry.planar import PlanarPose, linearise, planar_roots
from sightline.geometry.reshoot import reshoot_advice
from sightline.geometry.verdict import Evidence, calibration_warnings
from sightline.messages.said import Said

COVERAGE_ROWS, COVERAGE_COLUMNS = 12, 16
_BLURRED = 0.45  # edge width over square size from which a view is left out as blurred
LEAST_VIEWS = 3
LEAST_BENT_VIEWS = 6  # with fewer, the board's shape and the lens cannot be told apart
_POOR_RMS_PX = 2.0  # above this, OpenCV's solution is doubted and other starts are tried

NamedCorners = tuple[str, Corners, tuple[int, int]]


@dataclass(frozen=True, eq=False)
class BoardFlatness:
    """The views fitted with the board taken as `flat`, and with its `shape` solved for (`bent`)."""

    shape: BoardShape
    flat: Camera
    bent: Camera
    solved: bool  # whether the calibration is the bent one


@dataclass(frozen=True, eq=False)
class CalibrationResult:
    """A camera, how well it is known, and whether it is to be trusted.

    coverage: corners per cell of a 12 x 16 grid over the picture; corners, residuals_px: per used view (by
    file), (rows, columns, 2); residuals are seen minus modelled. `trusted` is False when a warning says not
    to. `reshoot`: what pictures are missing. `flatness` is None with too few views to tell.
    """

    camera: Camera
    coverage: Floats
    corners: dict[str, Floats]
    residuals_px: dict[str, Floats]
    warnings: tuple[Said, ...]
    trusted: bool
    reshoot: tuple[Said, ...] = ()
    flatness: BoardFlatness | None = None


@dataclass(frozen=True, eq=False)
class _Fit:
    """One model fitted to the used views."""

    camera: Camera
    poses: tuple[PlanarPose, ...]
    shape: BoardShape | None = None

    @property
    def rms_px(self) -> float:
        squares = sum(pose.cost for pose in self.poses)
        return float(np.sqrt(squares / sum(len(pose.residuals_px) for pose in self.poses)))


def calibrate(
    views: Sequence[NamedCorners], board: Board, model: LensModel = "brown", bent_board: bool = False
) -> CalibrationResult:
    """Calibrate a lens from pictures of a checkerboard.

    OpenCV's calibrateCamera (Zhang 2000; k1 k2 p1 p2 k3) or fisheye.calibrate (Kannala and Brandt 2006)
    finds the minimum; the covariance is sigma^2 (J'J)^-1 with every view's pose marginalised, sigma^2 from
    the residuals. It holds corner noise only: a wrong lens model or a bent board shows in the warnings, not
    in it.

    Parameters
    ----------
    views : sequence of (str, Corners, (int, int))
        Name, corners `points_px` (rows, columns, 2) and size (width, height) in px of each picture.
    board : Board
        Squares of `square_m`, metres.
    model : {"brown", "fisheye"}
        The lens model.
    bent_board : bool
        Solve for the board's shape too; six pictures are needed then.

    Returns
    -------
    CalibrationResult
        The camera with its covariance, the pictures' residuals, and warnings. Pictures of another size than
        most, without a board, blurred or given twice come back as unused views with their reason.

    Raises
    ------
    BadInput
        When fewer than three views are left, or six for a bent board.

    Examples
    --------
    >>> import cv2, numpy as np, sightline
    >>> camera = sightline.plain_camera(640, 480, field_of_view_rad=1.0)
    >>> board = sightline.Board(columns=6, rows=4, square_m=0.1)
    >>> flat = np.stack([*np.meshgrid(np.arange(6), np.arange(4)), np.zeros((4, 6))], axis=-1) * 0.1
    >>> views = []
    >>> for tilt in ((0.4, 0.0), (-0.4, 0.1), (0.0, 0.4), (0.1, -0.4)):
    ...     rotation = cv2.Rodrigues(np.array([*tilt, 0.0]))[0]
    ...     seen = (flat.reshape(-1, 3) - [0.25, 0.15, 0.0]) @ rotation.T + [0.0, 0.0, 0.9]
    ...     points_px = sightline.project(camera, seen).reshape(4, 6, 2)
    ...     corners = sightline.Corners(True, points_px, board, None, 2.0, "drawn")
    ...     views.append((f"{tilt}", corners, (640, 480)))
    >>> round(sightline.calibrate(views, board).camera.fx_px - camera.fx_px, 3)
    0.0
    """
    require_board(board)
    names = told_apart(name for name, _, _ in views)
    views = [(name, corners, size) for name, (_, corners, size) in zip(names, views, strict=True)]
    used, skipped = usable_views(views)
    least = LEAST_BENT_VIEWS if bent_board else LEAST_VIEWS
    if len(used) < least:
        raise _too_few(len(used), len(views), skipped, least)
    size = used[0][2]
    flat = _fit(used, board, size, model)
    bent = _bend(flat, used, board) if len(used) >= LEAST_BENT_VIEWS else None
    fit = bent if bent_board and bent is not None else flat
    other = _try_other(used, board, size, model, bent_board)
    rms = [float(np.sqrt(pose.cost / len(pose.residuals_px))) for pose in fit.poses]
    by_file = {name: View(name, value, True) for (name, _, _), value in zip(used, rms, strict=True)} | skipped
    camera = replace(_fitted_camera(fit), views=tuple(by_file[name] for name in names))
    other_size = tuple(name for name, _, its in views if its != size)
    evidence = Evidence(
        camera=camera,
        coverage=coverage(used, size),
        files=tuple(name for name, _, _ in used),
        rms_px=tuple(rms),
        normals=tuple(pose.rotation[:, 2] for pose in fit.poses),
        other_rms_px=None if other is None else other.rms_px,
        other_size=other_size,
        missed=len(skipped) - len(other_size),
        corners_px=tuple(c.points_px.reshape(-1, 2) for _, c, _ in used),
        spacings_px=tuple(spacing_px(c.points_px) for _, c, _ in used),
    )
    warnings, trusted = calibration_warnings(evidence)
    shapes = [c.points_px.shape for _, c, _ in used]
    return CalibrationResult(
        camera=camera,
        coverage=freeze_array(evidence.coverage),
        corners={name: c.points_px for name, c, _ in used},
        residuals_px={
            name: freeze_array(pose.residuals_px.reshape(shape))
            for (name, _, _), pose, shape in zip(used, fit.poses, shapes, strict=True)
        },
        warnings=warnings,
        trusted=trusted,
        reshoot=reshoot_advice(evidence),
        flatness=None
        if bent is None or bent.shape is None
        else BoardFlatness(bent.shape, _fitted_camera(flat), _fitted_camera(bent), bent_board),
    )


def fitted_lens(
    used: Sequence[NamedCorners],
    board: Board,
    model: LensModel,
    bent_board: bool,
    start: Camera | None = None,
) -> tuple[Camera, BoardShape | None]:
    """The lens alone, with its covariance and the board's shape if it is asked for. Raises BadInput.

    start: a lens close to the minimum, as that of all views is to that of half of them; without it, few
    views may end in a false minimum.
    """
    fit = None if start is None else _from_start(used, board, start)
    fit = fit or _fit(used, board, used[0][2], model)
    if bent_board:
        fit = _bend(fit, used, board)
    return _fitted_camera(fit), fit.shape


def _fitted_camera(fit: _Fit) -> Camera:
    """The fitted camera with its residual and covariance."""
    covariance = lens_covariance(fit.poses)
    n = len(fit.camera.parameters)
    return replace(
        fit.camera, rms_px=fit.rms_px, covariance=None if covariance is None else covariance[:n, :n]
    )


def told_apart(names: Iterable[str]) -> list[str]:
    """The names; one that was there before gets a number: results are told apart by name."""
    taken = dict[str, None]()
    for name in names:
        numbers = (f"{name} ({number})" for number in count(2))
        taken[next(one for one in chain([name], numbers) if one not in taken)] = None
    return list(taken)


def usable_views(views: Sequence[NamedCorners]) -> tuple[list[NamedCorners], dict[str, View]]:
    """The views to use, and those left out with their reason, by name."""
    sizes = Counter(size for _, c, size in views if c.found) or Counter(size for _, _, size in views)
    usual = sizes.most_common(1)[0][0] if sizes else (0, 0)
    used: list[NamedCorners] = []
    skipped: dict[str, View] = {}
    seen: dict[bytes, str] = {}
    for name, corners, size in views:
        reason, points = None, corners.points_px.tobytes()
        if size != usual:
            reason = Said(
                "calibration-image-other-size",
                width_px=size[0],
                height_px=size[1],
                usual_width_px=usual[0],
                usual_height_px=usual[1],
            )
        elif not corners.found:
            reason = corners.reason or Said("board-not-found")
        elif corners.sharpness > _BLURRED * spacing_px(corners.points_px):
            reason = Said("calibration-image-blurred", edge_px=round(corners.sharpness, 1))
        elif points in seen:
            # counted as another view it would make the lens look better known than it is
            reason = Said("calibration-image-twice", file=seen[points])
        if reason is None:
            seen[points] = name
            used.append((name, corners, size))
        else:
            skipped[name] = View(name, None, False, reason)
    return used, skipped


def _too_few(used: int, given: int, skipped: dict[str, View], least: int) -> BadInput:
    first = next(iter(skipped.values()), None)
    if first is None:
        return BadInput("geometry-too-few-pictures", used=used, given=given, least=least)
    return BadInput(
        "geometry-too-few-images", used=used, given=given, least=least, file=first.file, reason=first.reason
    )


def _fit(used: Sequence[NamedCorners], board: Board, size: tuple[int, int], model: LensModel) -> _Fit:
    """Fit one lens model; BadInput where no start leads to a minimum."""
    objects = [board_points(replace(c.board_as_seen, square_m=board.square_m))[c.which] for _, c, _ in used]
    seen = [c.points_px.reshape(-1, 2) for _, c, _ in used]
    fit = _with_opencv(objects, seen, size, model)
    if fit is None or fit.rms_px > _POOR_RMS_PX:
        again = from_scratch(size, model, objects, seen)
        if again is not None and (fit is None or _Fit(*again).rms_px < fit.rms_px):
            fit = _Fit(*again)
    if fit is None:
        raise BadInput("geometry-model-misfit", model=model)
    return fit


def _bend(flat: _Fit, used: Sequence[NamedCorners], board: Board) -> _Fit:
    """The same views with the board's shape solved for, starting from the flat solution."""
    seen_as = [replace(c.board_as_seen, square_m=board.square_m) for _, c, _ in used]
    objects = [board_points(one)[c.which] for (_, c, _), one in zip(used, seen_as, strict=True)]
    seen = [c.points_px.reshape(-1, 2) for _, c, _ in used]
    bases = [shape_basis(board, one)[c.which] for (_, c, _), one in zip(used, seen_as, strict=True)]
    camera, poses, shape = refine_bent(flat.camera, flat.poses, objects, seen, bases)
    return _Fit(camera, poses, BoardShape(board, freeze_array(shape)))


def _from_start(used: Sequence[NamedCorners], board: Board, start: Camera) -> _Fit | None:
    objects = [board_points(replace(c.board_as_seen, square_m=board.square_m))[c.which] for _, c, _ in used]
    seen = [c.points_px.reshape(-1, 2) for _, c, _ in used]
    roots = [planar_roots(start, o, s) for o, s in zip(objects, seen, strict=True)]
    return _Fit(*refine_all(start, [r[0] for r in roots], objects, seen)) if all(roots) else None


def _with_opencv(
    objects: list[Floats], seen: list[Floats], size: tuple[int, int], model: LensModel
) -> _Fit | None:
    """OpenCV's solution, or None where it fails or ends in nonsense."""
    try:
        matrix, k, turns, shifts = (_brown if model == "brown" else _fisheye)(objects, seen, size)
    except cv2.error:
        return None
    if not (np.isfinite(matrix).all() and np.isfinite(k).all()) or min(matrix[0, 0], matrix[1, 1]) <= 0:
        return None
    f_and_c = (float(matrix[0, 0]), float(matrix[1, 1]), float(matrix[0, 2]), float(matrix[1, 2]))
    camera = Camera("camera", *size, model, *f_and_c, np.asarray(k, dtype=np.float64).ravel())
    poses = tuple(
        linearise(camera, exp_rotation(np.ravel(r)), np.asarray(t, dtype=np.float64).ravel(), p, s)
        for r, t, p, s in zip(turns, shifts, objects, seen, strict=True)
    )
    if not np.isfinite(_Fit(camera, poses).rms_px):
        return None
    # OpenCV stops after 30 rounds by default, in every seventh simulated set far from the minimum
    return _Fit(*refine_all(camera, poses, objects, seen))


def _brown(objects: list[Floats], seen: list[Floats], size: tuple[int, int]) -> tuple[Any, Any, Any, Any]:
    solve: Any = cv2.calibrateCamera
    o32 = [p.astype(np.float32) for p in objects]
    s32 = [s.reshape(-1, 1, 2).astype(np.float32) for s in seen]
    _, matrix, k, turns, shifts = solve(o32, s32, size, None, None, flags=0)
    return matrix, k, turns, shifts


def _fisheye(objects: list[Floats], seen: list[Floats], size: tuple[int, int]) -> tuple[Any, Any, Any, Any]:
    solve: Any = cv2.fisheye.calibrate
    flags = cv2.fisheye.CALIB_RECOMPUTE_EXTRINSIC | cv2.fisheye.CALIB_FIX_SKEW
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 200, 1e-10)
    o = [p.reshape(-1, 1, 3) for p in objects]
    s = [p.reshape(-1, 1, 2) for p in seen]
    _, matrix, k, turns, shifts = solve(o, s, size, np.eye(3), np.zeros((4, 1)), flags=flags, criteria=stop)
    return matrix, k, turns, shifts


def _try_other(
    used: Sequence[NamedCorners], board: Board, size: tuple[int, int], model: LensModel, bent_board: bool
) -> _Fit | None:
    """The other lens model on the same views, to judge the choice; None where it cannot be fitted."""
    try:
        other = _fit(used, board, size, "fisheye" if model == "brown" else "brown")
    except BadInput:
        return None
    return _bend(other, used, board) if bent_board else other


def lens_covariance(poses: Sequence[PlanarPose]) -> Floats | None:
    """Covariance (n, n) of the lens's parameters (and the board's shape, where it was solved for), every
    view's pose marginalised (Schur complement): s^2 (sum of A_i' (1 - P_i) A_i)^-1 (CONVENTIONS.md,
    Calibration).

    s^2 is the residual variance of one coordinate with its degrees of freedom. None where the views do not
    determine the lens.
    """
    n = poses[0].lens_jacobian.shape[1]
    information = np.zeros((n, n))
    for pose in poses:
        a, b = pose.lens_jacobian, pose.jacobian
        q, _ = np.linalg.qr(b)
        free = a - q @ (q.T @ a)  # what the view's own pose cannot explain
        information += free.T @ free
    freedom = sum(pose.jacobian.shape[0] - 6 for pose in poses) - n
    if freedom <= 0:
        return None
    variance = sum(pose.cost for pose in poses) / freedom
    scale = np.sqrt(np.diag(information))
    if not (scale > 0).all():
        return None
    scaled = information / np.outer(scale, scale)
    if np.linalg.cond(scaled) > 1e13:
        return None
    covariance = variance * np.linalg.inv(scaled) / np.outer(scale, scale)
    return np.asarray(0.5 * (covariance + covariance.T), dtype=np.float64)


def coverage(used: Sequence[NamedCorners], size: tuple[int, int]) -> Floats:
    """Corners per cell of a grid over the picture, (12, 16)."""
    points = np.concatenate([c.points_px.reshape(-1, 2) for _, c, _ in used])
    bins = [COVERAGE_ROWS, COVERAGE_COLUMNS]
    extent = [[-0.5, size[1] - 0.5], [-0.5, size[0] - 0.5]]
    counts, _, _ = np.histogram2d(points[:, 1], points[:, 0], bins=bins, range=extent)
    return np.asarray(counts, dtype=np.float64)
