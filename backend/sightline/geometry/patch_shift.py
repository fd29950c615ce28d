"""How far a patch of a picture is off a template of it, and how well that is known.

Patches are laid out on the vertical plane in which a point of a vehicle travels, where what travels with it
stands still but for a small shift (Lucas and Kanade 1981; inverse compositional, Baker and Matthews 2004).
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.camera import project
from sightline.geometry.follow import Gray
from sightline.geometry.road_pose import RoadPose

_LOCAL_CELLS, _EVEN_GREY = 4.0, 30.0
_ODD = 3.0  # a residual so many times that of the cell along the pass is something else before it
FLOOR_GREY = 1.5  # noise of a cell that no picture is below, grey levels
_HOLD_CELLS = 3.0  # where nothing tells the place along an edge, it stays about here
_CORRELATED_CELLS = 1.5  # errors of cells nearer than about this are one error
_SEEN = 0.5  # least share of the weight that lies in the picture


@dataclass(frozen=True, eq=False)
class Patch:
    """Luminance (h, w) about a point, laid out on its plane, and which cells lie in the picture."""

    light: Floats
    seen: NDArray[np.bool_]


@dataclass(eq=False)
class Window:
    """Where cells lie about a point, metres along and up, (h, w) each; `cell_m` their size; `flat`: the
    spread in grey levels that is taken for none.
    """

    along: Floats
    up: Floats
    cell_m: float
    flat: float

    def patch(self, gray: Gray, pose: RoadPose, at_m: Floats) -> Patch:
        """What `gray` (H, W) shows about a road point at_m (3,), metres."""
        points = np.stack(
            [at_m[0] + self.along, np.full(self.along.shape, at_m[1]), at_m[2] + self.up], axis=-1
        ).reshape(-1, 3)
        pixels = project(pose.camera, pose.to_camera(points)).reshape(*self.along.shape, 2)
        height, width = gray.shape
        with np.errstate(invalid="ignore"):
            seen = (pixels >= 1).all(axis=-1) & (pixels <= (width - 2, height - 2)).all(axis=-1)
        maps = np.where(np.isfinite(pixels), pixels, -9.0).astype(np.float32)
        light = cv2.remap(gray, maps[..., 0], maps[..., 1], cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
        return Patch(_evened(light.astype(np.float64), self.flat), np.asarray(seen, dtype=np.bool_))


def _evened(light: Floats, flat: float) -> Floats:
    """Luminance (h, w) with its local mean taken off, over its local spread: a lamp that the vehicle passes
    changes an edge's contrast, and must not move it.
    """
    off = light - cv2.GaussianBlur(light, (0, 0), _LOCAL_CELLS)
    spread = cv2.GaussianBlur(off * off, (0, 0), _LOCAL_CELLS)
    return np.asarray(_EVEN_GREY * off / np.sqrt(spread + flat**2), dtype=np.float64)


def noise_grey(gray: Gray) -> float:
    """Noise of a picture gray (H, W), grey levels: median second difference, after Immerkaer 1996."""
    kernel = np.array([[1, -2, 1], [-2, 4, -2], [1, -2, 1]], dtype=np.float32)
    bent = cv2.filter2D(gray, cv2.CV_32F, kernel)
    return float(np.median(np.abs(bent)) / (0.6745 * 6.0))


@dataclass(frozen=True, eq=False)
class Shift:
    """A registration: the step (2,) left to go along and up, cells; its covariance (2, 2), cells squared; how
    alike the patches are; the usual slope.
    """

    step: Floats
    covariance: Floats
    alike: float
    slope: float


@dataclass(frozen=True, eq=False)
class Template:
    """What patches are laid on: luminance (h, w), and what a cell changes by (h, w, 4) with a step along, one
    up, a gain and an offset.
    """

    light: Floats
    design: Floats


def template_of(light: Floats) -> Template:
    """The template of a luminance light (h, w) with its derivatives, which inverse compositional alignment
    takes once (Baker and Matthews 2004).
    """
    up, along = np.gradient(light)
    return Template(light, np.stack([along, up, light, np.ones_like(light)], axis=-1))


def register_patch(onto: Template, patch: Patch, weight: Floats) -> Shift | None:
    """How far the patch (h, w) is to be moved to lie on the template, with gain and offset of its light, by
    cells of `weight` (h, w); None where too little of it is in the picture.

    Gauss-Newton's one step; cells that are odd beside the rest count less, and errors of neighbouring cells
    are taken together (Newey and West 1987).
    """
    template, design = onto.light, onto.design
    of_cell = weight * patch.seen
    if of_cell.sum() < _SEEN * weight.sum():
        return None
    gain, offset = light_of(template, patch.light, of_cell)
    rest = template - (gain * patch.light + offset)
    variance = max(float((of_cell * rest**2).sum() / of_cell.sum()), FLOOR_GREY**2)
    odd = rest**2 * weight / _ODD**2
    of_cell = of_cell / np.square(1.0 + odd)
    w = of_cell[..., None]
    normal = np.einsum("ijk,ijl->kl", design, w * design)
    held = normal + np.diag([variance / _HOLD_CELLS**2, variance / _HOLD_CELLS**2, 0.0, 0.0]) * float(
        of_cell.mean()
    )
    answer = np.linalg.inv(held)
    solved = answer @ np.einsum("ijk,ij->k", design, of_cell * rest)
    left = rest - design @ solved
    pull = (of_cell * left)[..., None] * design
    near = cv2.GaussianBlur(pull, (0, 0), _CORRELATED_CELLS) * (2 * np.pi * _CORRELATED_CELLS**2)
    meat = np.einsum("ijk,ijl->kl", pull, near)
    free = np.linalg.pinv(normal, hermitian=True)
    covariance = free @ (0.5 * (meat + meat.T)) @ free.T
    return Shift(
        step=solved[:2],
        covariance=covariance[:2, :2],
        alike=_correlate_patches(template, patch.light, of_cell),
        slope=_slope(patch.light, of_cell),
    )


def light_of(template: Floats, light: Floats, weight: Floats) -> tuple[float, float]:
    """Gain and offset that bring light (h, w) to template (h, w), cells weighted by weight (h, w): weighted
    least squares (as `register_patch`), the gain within 0.3 to 3.
    """
    total = weight.sum()
    a, b = (weight * light).sum() / total, (weight * template).sum() / total
    spread = (weight * (light - a) ** 2).sum()
    gain = float((weight * (light - a) * (template - b)).sum() / max(spread, 1e-9))
    gain = float(np.clip(gain, 0.3, 3.0))
    return gain, float(b - gain * a)


def _correlate_patches(one: Floats, two: Floats, weight: Floats) -> float:
    """Weighted correlation of two patches (h, w), smoothed: noise makes nothing unlike."""
    smooth = [cv2.GaussianBlur(of, (0, 0), _CORRELATED_CELLS) for of in (one, two)]
    a, b = (of - (weight * of).sum() / weight.sum() for of in smooth)
    size = np.sqrt((weight * a * a).sum() * (weight * b * b).sum())
    return float((weight * a * b).sum() / max(size, 1e-9))


def _slope(light: Floats, weight: Floats) -> float:
    up, along = np.gradient(light)
    return float(np.sqrt((weight * (up**2 + along**2)).sum() / weight.sum()))
