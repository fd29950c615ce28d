"""Sub-pixel corners by fitting what a blurred corner looks like: a saddle of two error functions.

    I(x, y) = a + b erf(d1 / (sqrt(2) s)) erf(d2 / (sqrt(2) s))

with d1, d2 the distances from the two edges that cross at the corner: seven parameters (a, b, two of place,
two directions, blur s) over a disc of 0.42 squares, 3 to 9 px. A step edge seen through a Gaussian blur is
exactly an error function, so unlike a gradient-orthogonality refinement (OpenCV's cornerSubPix, Foerstner
1987) this has no bias from blur, window or the edges' ends; all corners are fitted at once by
Levenberg-Marquardt.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Bools, Floats

_SHARE = 0.42
_LEAST_PX, _MOST_PX = 3.0, 9.0
_ROUNDS = 14
_MOST_MOVE_PX = 1.0
_ROOT2 = float(np.sqrt(2.0))


@dataclass(frozen=True, eq=False)
class Saddles:
    """`points_px` (N, 2), `blur_px` (N,); where `ok` is False the start point was kept."""

    points_px: Floats
    blur_px: Floats
    ok: Bools


@dataclass(frozen=True, eq=False)
class _Patches:
    """Pixels round each corner: offsets x, y from the start (N, P), grey values, and the disc's weights."""

    x: Floats
    y: Floats
    grey: Floats
    weight: Floats


def refine_saddles(picture: NDArray[Any], grid: Floats, share: float = _SHARE) -> Saddles:
    """Fit every corner of `grid` (rows, columns, 2), found to within a pixel, in a grey `picture` (H, W).

    share: radius of the disc in squares. A corner whose fit does not settle, leaves its start by over a pixel
    or explains little keeps its start. Own method: the module's saddle of two error functions
    (CONVENTIONS.md, Corner order), by Levenberg-Marquardt (Marquardt 1963).
    """
    return refine_saddles_at(picture, grid.reshape(-1, 2), *_directions(grid), share)


def refine_saddles_at(
    picture: NDArray[Any], start: Floats, right: Floats, down: Floats, share: float = _SHARE
) -> Saddles:
    """As `refine_saddles`, of corners, `start` (N, 2), with their vectors to the next ones right and below,
    `right`, `down` (N, 2), in a grey `picture` (H, W).
    """
    radius = np.clip(share * np.minimum(_length(right), _length(down)), _LEAST_PX, _MOST_PX)
    patches, inside = _cut(picture, start, radius)
    theta = _first_guess(patches, right, down)
    theta, cost = _fit(patches, theta)
    power = (patches.weight * (patches.grey - _mean(patches)[:, None]) ** 2).sum(axis=1)
    moved = np.hypot(theta[:, 2], theta[:, 3])
    ok = inside & np.isfinite(theta).all(axis=1) & (moved <= _MOST_MOVE_PX) & (cost < 0.5 * power)
    ok &= (np.abs(theta[:, 6]) > 0.15) & (np.abs(theta[:, 6]) < 0.8 * radius)
    points = np.where(ok[:, None], start + theta[:, 2:4], start)
    return Saddles(points, np.where(ok, np.abs(theta[:, 6]), 0.0), ok)


def _length(v: Floats) -> Floats:
    return np.asarray(np.linalg.norm(v, axis=1), dtype=np.float64)


def _directions(grid: Floats) -> tuple[Floats, Floats]:
    """Local edge vectors along the rows and the columns at every corner, (N, 2) each."""
    right = np.gradient(grid, axis=1)
    down = np.gradient(grid, axis=0)
    return right.reshape(-1, 2), down.reshape(-1, 2)


def _cut(picture: NDArray[Any], start: Floats, radius: Floats) -> tuple[_Patches, Bools]:
    """Pixels round each corner; corners whose disc leaves the picture are told, their pixels clamped."""
    half = int(np.ceil(radius.max()))
    step = np.arange(-half, half + 1)
    dx, dy = (v.ravel() for v in np.meshgrid(step, step))
    middle = np.rint(start).astype(int)
    column, row = middle[:, :1] + dx, middle[:, 1:] + dy
    height, width = picture.shape
    x, y = column - start[:, :1], row - start[:, 1:]
    weight = np.clip(radius[:, None] + 0.5 - np.hypot(x, y), 0.0, 1.0)
    outside = (column < 0) | (row < 0) | (column >= width) | (row >= height)
    inside = ~(outside & (weight > 0)).any(axis=1)
    grey = picture[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)].astype(np.float64)
    return _Patches(x, y, grey, weight), np.asarray(inside, dtype=np.bool_)


def _mean(patches: _Patches) -> Floats:
    total = (patches.weight * patches.grey).sum(axis=1) / patches.weight.sum(axis=1)
    return np.asarray(total, dtype=np.float64)


def _first_guess(patches: _Patches, right: Floats, down: Floats) -> Floats:
    """Parameters (N, 7): level, contrast (signed), place, directions of the two edges, blur."""
    theta = np.zeros((len(right), 7))
    theta[:, 4] = np.arctan2(right[:, 1], right[:, 0])
    theta[:, 5] = np.arctan2(down[:, 1], down[:, 0])
    theta[:, 6] = 1.0
    shape = _model(patches, np.concatenate([np.tile([0.0, 1.0], (len(right), 1)), theta[:, 2:]], axis=1))[0]
    theta[:, 0] = _mean(patches)
    w = patches.weight
    theta[:, 1] = (w * shape * (patches.grey - theta[:, :1])).sum(axis=1) / (w * shape**2).sum(axis=1)
    return theta


def _model(patches: _Patches, theta: Floats) -> tuple[Floats, Floats]:
    """Grey values (N, P) and their derivatives (N, P, 7)."""
    from scipy.special import erf  # here, so that a server starts without SciPy

    level, contrast, cx, cy, t1, t2, blur = (theta[:, i, None] for i in range(7))
    x, y = patches.x - cx, patches.y - cy
    scale = 1.0 / (_ROOT2 * blur)
    c1, s1, c2, s2 = np.cos(t1), np.sin(t1), np.cos(t2), np.sin(t2)
    u1, u2 = (c1 * y - s1 * x) * scale, (c2 * y - s2 * x) * scale
    e1, e2 = erf(u1), erf(u2)
    f1 = contrast * (2.0 / np.sqrt(np.pi)) * np.exp(-u1 * u1) * e2
    f2 = contrast * (2.0 / np.sqrt(np.pi)) * np.exp(-u2 * u2) * e1
    out = np.empty((*x.shape, 7))
    out[..., 0] = 1.0
    out[..., 1] = e1 * e2
    out[..., 2] = (f1 * s1 + f2 * s2) * scale
    out[..., 3] = -(f1 * c1 + f2 * c2) * scale
    out[..., 4] = -f1 * (s1 * y + c1 * x) * scale
    out[..., 5] = -f2 * (s2 * y + c2 * x) * scale
    out[..., 6] = -(f1 * u1 + f2 * u2) / blur
    return level + contrast * out[..., 1], out


def _fit(patches: _Patches, theta: Floats) -> tuple[Floats, Floats]:
    """Levenberg-Marquardt on all corners at once; returns parameters and weighted squared residuals."""
    damping = np.full(len(theta), 1e-2)
    eye = np.eye(7)
    with np.errstate(all="ignore"):
        model, jacobian = _model(patches, theta)
        cost = _cost(patches, model)
        for _ in range(_ROUNDS):
            weighted = jacobian * patches.weight[..., None]
            normal = np.swapaxes(weighted, 1, 2) @ jacobian
            diagonal = np.einsum("nii->ni", normal)
            damped = normal + (damping[:, None] * diagonal + 1e-12)[:, None, :] * eye
            gain = np.einsum("npk,np->nk", weighted, patches.grey - model)
            step = np.linalg.solve(damped, gain[..., None])[..., 0]
            tried = theta + step
            model_tried, jacobian_tried = _model(patches, tried)
            cost_tried = _cost(patches, model_tried)
            better = np.isfinite(cost_tried) & (cost_tried <= cost)
            theta = np.where(better[:, None], tried, theta)
            model = np.where(better[:, None], model_tried, model)
            jacobian = np.where(better[:, None, None], jacobian_tried, jacobian)
            cost = np.where(better, cost_tried, cost)
            damping = np.where(better, 0.1 * damping, 10.0 * damping)
            if float(np.abs(step[:, 2:4]).max()) < 1e-4:
                break
    return theta, cost


def _cost(patches: _Patches, model: Floats) -> Floats:
    return np.asarray((patches.weight * (patches.grey - model) ** 2).sum(axis=1), dtype=np.float64)
