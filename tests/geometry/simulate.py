"""An independent camera, road and board to test against. It shares no code with sightline.geometry.

Everything is written from the definitions: cameras by position and angles, distortion as plain formulas per
point, inversion by bisection-free fixed-point rounds to convergence, pictures by casting rays at a checker
pattern.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np


@dataclass(frozen=True)
class Lens:
    """f, c in pixels; k in OpenCV's order; kind 'brown' or 'fisheye'."""

    f: float = 483.5
    cx: float = 319.5
    cy: float = 239.5
    k: tuple = (-0.32, 0.12, 5e-4, -3e-4, -0.02)
    kind: str = "brown"
    width: int = 640
    height: int = 480


def bend(lens: Lens, a, b):
    """Distorted normalised coordinates, written out from the textbook formulas."""
    if lens.kind == "fisheye":
        rho = np.hypot(a, b)
        angle = np.arctan(rho)
        angle_d = angle + sum(k * angle ** (2 * i + 3) for i, k in enumerate(lens.k))
        ratio = np.where(rho > 1e-12, angle_d / np.maximum(rho, 1e-12), 1.0)
        return a * ratio, b * ratio
    k = list(lens.k) + [0.0] * (8 - len(lens.k))
    aa, bb, ab = a * a, b * b, a * b
    r2 = aa + bb
    radial = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))
    if any(k[5:]):
        radial = radial / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])))
    return (
        a * radial + 2 * k[2] * ab + k[3] * (3 * aa + bb),
        b * radial + k[2] * (aa + 3 * bb) + 2 * k[3] * ab,
    )


def unbend(lens: Lens, u, v):
    """Inverse of `bend` by damped fixed-point rounds, many of them."""
    a, b = np.array(u, dtype=float), np.array(v, dtype=float)
    for _ in range(400):
        p, q = bend(lens, a, b)
        a, b = a - 0.8 * (p - u), b - 0.8 * (q - v)
    return a, b


@lru_cache(maxsize=1000)
def road_to_camera(yaw=0.0, pitch=0.0, roll=0.0):
    """Rows: the camera's right, down and forward in the road frame (X right, Y away, Z up). Degrees.

    yaw turns the camera to its right, pitch tips it down, roll turns it clockwise about its axis.
    """
    y, p, r = (math.radians(v) for v in (yaw, pitch, roll))
    forward = np.array([math.sin(y) * math.cos(p), math.cos(y) * math.cos(p), -math.sin(p)])
    level_right = np.array([math.cos(y), -math.sin(y), 0.0])
    level_down = np.cross(forward, level_right)
    right = math.cos(r) * level_right + math.sin(r) * level_down
    down = -math.sin(r) * level_right + math.cos(r) * level_down
    axes = np.array([right, down, forward])
    axes.flags.writeable = False
    return axes


@dataclass(frozen=True)
class Scene:
    """A camera at `eye` (road frame, metres) looking by yaw, pitch, roll (degrees)."""

    lens: Lens = Lens()
    eye: tuple = (0.0, -3.0, 1.5)
    yaw: float = 0.0
    pitch: float = 8.0
    roll: float = 0.0

    def axes(self):
        return road_to_camera(self.yaw, self.pitch, self.roll)

    def look(self, points):
        """Pixels (N, 2) of road points (N, 3)."""
        x, y, z = self.axes() @ (np.atleast_2d(np.asarray(points, float)) - self.eye).T
        a, b = bend(self.lens, x / z, y / z)
        return np.stack([self.lens.f * a + self.lens.cx, self.lens.f * b + self.lens.cy], axis=1)

    def board(self, columns, rows, square, top_m):
        """Inner corners (rows, columns, 3) of a board standing at Y = 0, its top row at `top_m`."""
        grid = np.zeros((rows, columns, 3))
        for i in range(rows):
            for j in range(columns):
                grid[i, j] = (j * square, 0.0, top_m - i * square)
        return grid

    def pose_arrays(self):
        rotation = self.axes()
        return rotation, -rotation @ np.asarray(self.eye, float)


def checker(across, down, columns, rows):
    """Grey value of the board's plane at (across, down) in squares, (0, 0) being the first inner corner."""
    black = (np.floor(across) + np.floor(down)) % 2 == 0
    inside = (across > -1) & (across < columns) & (down > -1) & (down < rows)
    margin = (across > -1.7) & (across < columns + 0.7) & (down > -1.7) & (down < rows + 0.7)
    return np.where(inside & black, 40.0, np.where(inside | margin, 205.0, 118.0))


def picture(
    scene: Scene,
    columns,
    rows,
    square,
    top_m,
    *,
    samples=8,
    blur=0.8,
    noise=2.0,
    seed=0,
    turn=None,
    paint=checker,
):
    """A grey uint8 picture of a board standing at Y = 0, supersampled, blurred, with noise.

    turn: optional 3x3 rotation of the board about its first corner (road frame); paint: as `checker`.
    """
    lens = scene.lens
    turn = np.eye(3) if turn is None else turn
    grey = np.full((lens.height, lens.width), 118.0)
    box = _board_box(scene, columns, rows, square, top_m, turn)
    if box is not None:
        x0, x1, y0, y1 = box
        grey[y0:y1, x0:x1] = _cast(scene, box, (columns, rows, square, top_m), samples, turn, paint)
    if blur > 0:
        grey = _gauss(grey, blur)
    grey = grey + np.random.default_rng(seed).normal(0, noise, grey.shape)
    return np.clip(np.rint(grey), 0, 255).astype(np.uint8)


def _board_box(scene, columns, rows, square, top_m, turn):
    """The part of the picture that the board with its margin covers, as x0, x1, y0, y1."""
    across, down = np.meshgrid(np.linspace(-1.8, columns + 0.8, 9), np.linspace(-1.8, rows + 0.8, 9))
    flat = np.stack([across * square, 0 * across, -down * square], axis=-1).reshape(-1, 3)
    at = scene.look(flat @ turn.T + [0.0, 0.0, top_m])
    lens = scene.lens
    x0, y0 = np.maximum(np.floor(at.min(axis=0)).astype(int) - 2, 0)
    x1, y1 = np.minimum(np.ceil(at.max(axis=0)).astype(int) + 3, [lens.width, lens.height])
    return (x0, x1, y0, y1) if x1 > x0 and y1 > y0 else None


def _cast(scene, box, board, samples, turn, paint):
    """Grey values of the box, some rows after the other: what is computed of them stays in the cache."""
    x0, x1, y0, y1 = box
    parts = [(x0, x1, y, min(y + 4, y1)) for y in range(y0, y1, 4)]
    return np.concatenate([_cast_part(scene, part, board, samples, turn, paint) for part in parts])


def _cast_part(scene, box, board, samples, turn, paint):
    lens = scene.lens
    x0, x1, y0, y1 = box
    columns, rows, square, top_m = board
    step = (np.arange(samples) + 0.5) / samples - 0.5
    xs, ys = (np.arange(x0, x1)[:, None] + step).ravel(), (np.arange(y0, y1)[:, None] + step).ravel()
    u, v = np.meshgrid((xs - lens.cx) / lens.f, (ys - lens.cy) / lens.f)
    a, b = u.copy(), v.copy()
    for _ in range(25):
        p, q = bend(lens, a, b)
        p, q = p - u, q - v
        a, b = a - p, b - q
        if max(np.abs(p).max(), np.abs(q).max()) < 1e-8:  # 5e-6 px, and less by the next round
            break
    eye = turn.T @ (np.asarray(scene.eye, float) - [0.0, 0.0, top_m])
    m = scene.axes() @ turn  # rows: the camera's axes in the board's own
    d = [a * m[0, i] + b * m[1, i] + m[2, i] for i in range(3)]
    far = -eye[1] / d[1]
    grey = paint((eye[0] + far * d[0]) / square, -(eye[2] + far * d[2]) / square, columns, rows)
    grey = np.where(far > 0, grey, 118.0)
    return grey.reshape(y1 - y0, samples, x1 - x0, samples).mean(axis=(1, 3))


def _gauss(grey, blur):
    half = int(4 * blur) + 1
    kernel = np.exp(-0.5 * (np.arange(-half, half + 1) / blur) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        padded = np.pad(grey, [(half, half) if i == axis else (0, 0) for i in (0, 1)], mode="edge")
        grey = sum(w * np.take(padded, range(i, i + grey.shape[axis]), axis) for i, w in enumerate(kernel))
    return grey
