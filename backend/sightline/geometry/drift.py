"""A camera that moved after its road pose was taken: how the picture moved, and what that does to heights.

The motion of a fixed background between two pictures is fitted as a similarity about the picture's centre,
q = p + (x, y) + [[s, -t], [t, s]] (p - centre), with t the turn in radians and s the change of scale. That is
what a small turn of the camera does to a narrow picture; a wide lens and a camera that was shifted leave a
rest, which enters the uncertainty through the scatter of the points.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.camera import project
from sightline.geometry.height import measure_height
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said
from sightline.robust import robust_scale

DISTANCE_M = 3.0
TARGET_M = 1.2
FEWEST = 12  # points on the same motion; fewer can agree by chance
FEWEST_BLOCKS = 4  # parts of the picture that hold them: points in one corner tell no turn
BLOCKS = (4, 3)
_ROUNDS = 12
_TUKEY = 4.685  # 95 % efficient where the errors are normal
_FINEST_PX = 0.02  # scatter below which points are not told apart: LK's own steps
_FARTHEST_M = 12.0


@dataclass(frozen=True)
class Motion:
    """How the picture moved since the pose: shift of its centre, turn (clockwise as seen), scale.

    `u_px` is the standard uncertainty of `moved_px`; `points` is how many points tell it.
    """

    x_px: float
    y_px: float
    turn_rad: float
    scale: float
    moved_px: float
    u_px: float
    points: int

    def move(self, points_px: Floats, size_px: tuple[int, int]) -> Floats:
        """Where points (N, 2) of the pose's picture, `points_px` (N, 2), lie in the moved one."""
        away = points_px - _centre(size_px)
        s, t = self.scale - 1.0, self.turn_rad
        turned = np.stack([s * away[:, 0] - t * away[:, 1], t * away[:, 0] + s * away[:, 1]], axis=1)
        return np.asarray(points_px + turned + (self.x_px, self.y_px), dtype=np.float64)

    def undo(self, points_px: Floats, size_px: tuple[int, int]) -> Floats:
        """Where points of the moved picture, `points_px` (N, 2), lie in the pose's (N, 2): `move` undone."""
        centre, t = _centre(size_px), self.turn_rad
        away = points_px - centre - (self.x_px, self.y_px)
        back = np.linalg.solve([[self.scale, -t], [t, self.scale]], away.T).T
        return np.asarray(centre + back, dtype=np.float64)


@dataclass(frozen=True)
class HeightChange:
    """What a motion does to the height of a target `TARGET_M` above the road, `distance_m` across from the
    camera: the worst over the picture's width. None with a reason where no such target is in the picture.
    """

    change_m: float | None
    distance_m: float | None
    reason: Said | None


def _centre(size_px: tuple[int, int]) -> Floats:
    return np.array([(size_px[0] - 1) / 2, (size_px[1] - 1) / 2])


def displacement_px(parameters: Floats, size_px: tuple[int, int]) -> float:
    """Root mean square over the picture's area of how far its points moved; `parameters` (4,): x, y (px), s,
    t.

    Own derivation: x^2 + y^2 + (s^2 + t^2) (w^2 + h^2) / 12, the last factor the mean square distance from
    the centre of a w x h picture.
    """
    x, y, s, t = (float(value) for value in parameters)
    spread = (size_px[0] ** 2 + size_px[1] ** 2) / 12.0
    return float(np.sqrt(x * x + y * y + (s * s + t * t) * spread))


def fit_motion(before_px: Floats, after_px: Floats, size_px: tuple[int, int]) -> Motion | Said:
    """The motion that most points share, or why it cannot be told: `before_px`, `after_px` (N, 2).

    Iterated least squares with Tukey's weights (Beaton and Tukey 1974) from the median motion; the
    uncertainty is a jackknife (Efron and Tibshirani 1993, ch. 11) over blocks of the picture, so that errors
    common to neighbouring points are not taken for independent ones. Left out: a change common to the whole
    background (a screen or a wet windscreen before the lens).
    """
    away = before_px - _centre(size_px)
    moves = after_px - before_px
    if len(away) < FEWEST:
        return _too_few(len(away))
    design = _design(away)
    weights = _weights(design, moves)
    kept = weights > 0.1
    blocks = _blocks(before_px, size_px)
    if int(kept.sum()) < FEWEST or len(np.unique(blocks[kept])) < FEWEST_BLOCKS:
        return _too_few(int(kept.sum()))
    found = _solve(design, moves, weights)
    u = _jackknife(design, moves, weights, blocks, found, size_px)
    return motion_of(found, size_px, u, int(kept.sum()))


def motion_of(parameters: Floats, size_px: tuple[int, int], u_px: float, points: int) -> Motion:
    """The motion with these `parameters` (4,): x, y (px), s, t; how far points move as `displacement_px`."""
    x, y, s, t = (float(value) for value in parameters)
    return Motion(
        x_px=x,
        y_px=y,
        turn_rad=t,
        scale=1.0 + s,
        moved_px=displacement_px(parameters, size_px),
        u_px=u_px,
        points=points,
    )


def _too_few(count: int) -> Said:
    return Said("drift-few-points", count=count)


def _design(away: Floats) -> Floats:
    """(N, 2, 4): the derivative of each point's motion by (x, y, s, t)."""
    one, zero = np.ones(len(away)), np.zeros(len(away))
    along = np.stack([one, zero, away[:, 0], -away[:, 1]], axis=1)
    down = np.stack([zero, one, away[:, 1], away[:, 0]], axis=1)
    return np.stack([along, down], axis=1)


def _solve(design: Floats, moves: Floats, weights: Floats) -> Floats:
    root = np.sqrt(weights)[:, None]
    rows = (design * root[:, :, None]).reshape(-1, 4)
    return np.asarray(np.linalg.lstsq(rows, (moves * root).reshape(-1), rcond=None)[0], dtype=np.float64)


def _weights(design: Floats, moves: Floats) -> Floats:
    """Tukey's weights (N,) of the last round; the first round starts from the median shift."""
    motion = np.array([*np.median(moves, axis=0), 0.0, 0.0])
    weights = np.ones(len(moves))
    for step in range(_ROUNDS):
        rest = np.linalg.norm(moves - design @ motion, axis=1)
        # a turn is not in the median shift: the first rounds must not throw its corners away
        widest = 1.0 * 0.5**step
        scale = max(robust_scale(rest) / 1.18, _FINEST_PX, widest)
        weights = np.square(np.clip(1.0 - np.square(rest / (_TUKEY * scale)), 0.0, None))
        if float(weights.sum()) < 3.0:
            break
        motion = _solve(design, moves, weights)
    return weights


def _blocks(points_px: Floats, size_px: tuple[int, int]) -> NDArray[np.intp]:
    """Which block of the picture each point lies in, (N,)."""
    column = np.clip(points_px[:, 0] * BLOCKS[0] / size_px[0], 0, BLOCKS[0] - 1).astype(np.intp)
    row = np.clip(points_px[:, 1] * BLOCKS[1] / size_px[1], 0, BLOCKS[1] - 1).astype(np.intp)
    return np.asarray(row * BLOCKS[0] + column, dtype=np.intp)


def _jackknife(
    design: Floats,
    moves: Floats,
    weights: Floats,
    blocks: NDArray[np.intp],
    motion: Floats,
    size_px: tuple[int, int],
) -> float:
    """Standard uncertainty of the displacement: the fit without each block in turn."""
    own = np.unique(blocks[weights > 0.1])
    changes = [
        displacement_px(
            _solve(design[blocks != b], moves[blocks != b], weights[blocks != b]) - motion, size_px
        )
        for b in own
    ]
    return float(np.sqrt((len(own) - 1) / len(own) * np.sum(np.square(changes))))


def height_change(pose: RoadPose, motion: Motion) -> HeightChange:
    """What heights are off by on a frame that moved so, when the pose is taken to hold.

    Contact and target are put where the camera sees them, moved along with the picture, and measured with
    the pose; the nearest distance from 3 m on at which the picture shows both is taken.
    """
    for distance in np.arange(DISTANCE_M, _FARTHEST_M + 0.5, 1.0):
        changes = [_change_at(pose, motion, float(distance), x) for x in _places(pose, float(distance))]
        seen = [change for change in changes if change is not None]
        if seen:
            return HeightChange(max(seen, key=abs), float(distance), None)
    return HeightChange(None, None, Said("drift-no-target", target_m=TARGET_M))


def _places(pose: RoadPose, distance_m: float) -> Floats:
    """Places along the traffic, on both sides of where the camera looks."""
    forward = pose.rotation.T @ np.array([0.0, 0.0, 1.0])
    lead = distance_m * float(np.clip(forward[0] / max(abs(float(forward[1])), 0.2), -3.0, 3.0))
    return np.asarray(pose.centre_m[0] + lead + np.linspace(-0.6, 0.6, 7) * distance_m)


def _change_at(pose: RoadPose, motion: Motion, distance_m: float, x_m: float) -> float | None:
    """The change of height in one place, None where the picture does not show it."""
    y = float(pose.centre_m[1]) + distance_m
    pixels = project(pose.camera, pose.to_camera(np.array([[x_m, y, 0.0], [x_m, y, TARGET_M]])))
    if not (np.isfinite(pixels).all() and pose.camera.inside(pixels).all()):
        return None
    moved = motion.move(pixels, (pose.camera.width_px, pose.camera.height_px))
    height = measure_height(pose, moved[0], moved[1]).height_m
    return None if height is None else height - TARGET_M
