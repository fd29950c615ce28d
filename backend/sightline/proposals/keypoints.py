"""Where the points of a vehicle lie on a frame, by two small networks that drawn vehicles taught.

The first looks at the whole side plane and says where each point may be, to a few centimetres; the second
looks at half a metre about one of them and says where it lies there, how far that may be off, and whether it
is to be seen at all. `tests/bench/train_proposals.py` makes the weights; who calls brings the networks.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, get_args

import numpy as np

from sightline.enums import ProposedPoint, ProposedTarget
from sightline.geometry.camera import undistort
from sightline.geometry.road_pose import RoadPose
from sightline.proposals.canvas import Canvas, Values
from sightline.proposals.wheels import Box

POINTS: tuple[ProposedPoint, ...] = get_args(ProposedPoint)
COARSE_CELL_M, COARSE_SIZE, COARSE_Z_M = 0.08, (144, 60), -0.6
COARSE_STEP = 2  # cells of the picture to one of what comes out
FINE_SIZE = 48
FINE_CELL_M: dict[ProposedTarget, tuple[float, float]] = {
    "roof": (0.02, 0.01),
    "taillight": (0.01, 0.01),
    "headlight": (0.01, 0.01),
    "driver_eye": (0.01, 0.01),
}
#: In the order of the second network's maps.
FINE_POINTS: tuple[ProposedTarget, ...] = tuple(FINE_CELL_M)
FINE_STEP = 2


@dataclass(frozen=True)
class Networks:
    """`coarse`: views (n, 4, 60, 144) to maps (n, 6, 30, 72), logits against "not seen", which is 0; `fine`:
    views (n, 4, 48, 48) to maps (n, 4, 24, 24) and stats (n, 12), of each point the logarithm of its standard
    error along and up, cells, and the logit of being seen.
    """

    coarse: Callable[[Values], Values]
    fine: Callable[[Values], tuple[Values, Values]]


@dataclass(frozen=True)
class Seen:
    """A point on a plane: along the vehicle's way and up, metres; how far off it may be; how sure it is that
    it is seen at all, 0 to 1.
    """

    along_m: float
    z_m: float
    u_along_m: float
    u_z_m: float
    sure: float


def plane_point(pose: RoadPose, pixel: tuple[float, float], y_m: float) -> tuple[float, float]:
    """X and Z where the ray of a pixel meets the plane Y = `y_m`; NaN where it does not.

    Standard; the ray is C + t R^T (x, y, 1).
    """
    xy = undistort(pose.camera, np.array([pixel], dtype=np.float64)).points[0]
    ray = pose.rotation.T @ np.array([xy[0], xy[1], 1.0])
    t = (y_m - pose.centre_m[1]) / ray[1] if abs(ray[1]) > 1e-9 else np.nan
    if not t > 0:
        return np.nan, np.nan
    at = pose.centre_m + t * ray
    return float(at[0]), float(at[2])


def moved_to_plane(
    pose: RoadPose, at: tuple[float, float], y_m: float, other_y_m: float
) -> tuple[float, float]:
    """What is seen at (X, Z) of one plane along the road, on another: a similarity about the camera."""
    centre = pose.centre_m
    k = (other_y_m - centre[1]) / (y_m - centre[1])
    return float(centre[0] + (at[0] - centre[0]) * k), float(centre[2] + (at[1] - centre[2]) * k)


def coarse_canvas(pose: RoadPose, box: Box, y_m: float, ahead: int) -> Canvas | None:
    """The side plane about a vehicle's box (left, top, right, bottom) px; None where the box is off it."""
    middle = 0.5 * (box[1] + box[3])
    ends = [plane_point(pose, (x, middle), y_m)[0] for x in (box[0], box[2])]
    if not np.isfinite(ends).all():
        return None
    half = 0.5 * COARSE_SIZE[0] * COARSE_CELL_M
    along = ahead * 0.5 * sum(ends) - half
    return Canvas(
        y_m=y_m,
        ahead=ahead,
        along_m=along,
        z_m=COARSE_Z_M,
        cell_m=(COARSE_CELL_M, COARSE_CELL_M),
        size=COARSE_SIZE,
    )


def fine_canvas(name: ProposedTarget, along_m: float, z_m: float, y_m: float, ahead: int) -> Canvas:
    """Half a metre (of a roof one along) about a place of the side plane Y = `y_m`."""
    cell = FINE_CELL_M[name]
    half = 0.5 * (FINE_SIZE - 1)
    left, low = along_m - half * cell[0], z_m - half * cell[1]
    size = (FINE_SIZE, FINE_SIZE)
    return Canvas(y_m=y_m, ahead=ahead, along_m=left, z_m=low, cell_m=cell, size=size)


def coarse_places(networks: Networks, canvas: Canvas, view: Values) -> dict[ProposedPoint, Seen]:
    """Where each point may be on a canvas laid out as `view` (4, rows, columns).

    Own method: a softmax over the cells and "not seen"; the mean place about the most likely cell.
    """
    maps = networks.coarse(view[None])[0]
    return {name: _peak(canvas, maps[i]) for i, name in enumerate(POINTS)}


def _peak(canvas: Canvas, logits: Values) -> Seen:
    top = max(float(logits.max()), 0.0)
    weights = np.exp(logits.astype(np.float64) - top)
    total = float(weights.sum()) + float(np.exp(-top))
    row, column = np.unravel_index(int(np.argmax(logits)), logits.shape)
    rows = slice(max(0, int(row) - 2), int(row) + 3)
    columns = slice(max(0, int(column) - 2), int(column) + 3)
    near = weights[rows, columns]
    grid_row, grid_column = np.indices(near.shape) + np.array([rows.start, columns.start])[:, None, None]
    at = [float((near * grid).sum() / near.sum()) for grid in (grid_column, grid_row)]
    along, z = canvas.place(*(_unstepped(one, COARSE_STEP) for one in at))
    u = COARSE_CELL_M * COARSE_STEP / 2
    return Seen(float(along), float(z), u, u, float(near.sum() / total))


def _unstepped(at: Any, step: int) -> Any:
    """The cell of the picture that the middle of a cell of the network's maps stands for."""
    return at * step + (step - 1) / 2


def fine_places(
    networks: Networks, names: Sequence[ProposedPoint], canvases: Sequence[Canvas], views: Sequence[Values]
) -> list[Seen]:
    """Where each named point lies on its own canvas, laid out as its one of `views`, (4, rows, columns) each.

    Own method: the mean of a softmax over the cells; its standard error as the network learnt it.
    """
    if not views:
        return []
    maps, stats = networks.fine(np.stack(views))
    out = []
    for i, (name, canvas) in enumerate(zip(names, canvases, strict=True)):
        k = FINE_POINTS.index(name)
        weights = np.exp(maps[i, k].astype(np.float64) - float(maps[i, k].max()))
        weights /= weights.sum()
        cells = _unstepped(np.arange(weights.shape[0], dtype=np.float64), FINE_STEP)
        at = float(weights.sum(axis=0) @ cells), float(weights.sum(axis=1) @ cells)
        along, z = canvas.place(*at)
        u = np.exp(stats[i, 3 * k : 3 * k + 2].astype(np.float64)) * canvas.cell_m
        sure = 1 / (1 + np.exp(-float(stats[i, 3 * k + 2])))
        out.append(Seen(float(along), float(z), float(u[0]), float(u[1]), float(sure)))
    return out
