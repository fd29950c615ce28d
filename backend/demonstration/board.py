"""Checkerboards: the one on the road (a scene's first seconds) and the lab pictures for the lens."""

from functools import lru_cache

import cv2
import numpy as np

from backend.demonstration.backdrop import backdrop, noise_tile
from backend.demonstration.camera import Array, DemoCamera, Floats, Image, finer, pixel_grid
from backend.demonstration.scene import RoadBoard, Scene
from backend.demonstration.sensor import sensor

LAB_COLUMNS, LAB_ROWS, LAB_SQUARE_M = 9, 6, 0.030
LAB_COUNT = 20


def _checker(u: Array, v: Array, columns: int, rows: int) -> tuple[Array, Array]:
    """Black squares and pattern extent; (u, v) in squares from the first inner corner, rightward and downward."""
    inside = (u >= -1) & (u < columns) & (v >= -1) & (v < rows)
    dark = ((np.floor(u) + np.floor(v)).astype(int) % 2 == 0) & inside
    return dark, inside


def board_corners_m(board: RoadBoard) -> Array:
    """True inner corners (rows, columns, 3) in the road frame, row 0 the top, column 0 at X = 0."""
    x = np.arange(board.columns) * board.square_m
    z = board.reference_height_m - np.arange(board.rows) * board.square_m
    return np.stack(
        [
            np.broadcast_to(x, (len(z), len(x))),
            np.zeros((len(z), len(x))),
            np.broadcast_to(z[:, None], (len(z), len(x))),
        ],
        -1,
    )


@lru_cache(maxsize=4)
def board_backdrop(scene: Scene) -> Floats:
    """The road with the board on its stand, float32, before the sensor; sixteen rays per pixel on the board."""
    camera, board = scene.camera, scene.board
    out = backdrop(scene).copy()
    wide, high = board.sheet_m
    x0 = (board.columns - 1) * board.square_m / 2 - wide / 2
    top = board.reference_height_m + board.square_m + (high - (board.rows + 1) * board.square_m) / 2
    corners = np.array(
        [
            [x0 - 0.3, 0, 0],
            [x0 + wide + 0.3, 0, 0],
            [x0 + wide + 0.3, 0, top],
            [x0 - 0.3, 0, top],
            [x0 - 0.3, 0.6, 0],
            [x0 + wide + 0.9, 0.7, 0],
        ]
    )
    px = camera.project(corners)
    a0, b0 = np.floor(px.min(0)).astype(int) - 6
    a1, b1 = np.ceil(px.max(0)).astype(int) + 7
    a0, b0, a1, b1 = max(a0, 0), max(b0, 0), min(a1, camera.width_px), min(b1, camera.height_px)
    s = 6
    u = a0 + (np.arange((a1 - a0) * s) + 0.5) / s - 0.5
    v = b0 + (np.arange((b1 - b0) * s) + 0.5) / s - 0.5
    slopes = camera.ray_slopes(np.stack(np.meshgrid(u, v), -1))
    size = (a1 - a0, b1 - b0)
    part = cv2.resize(out[b0:b1, a0:a1], (size[0] * s, size[1] * s), interpolation=cv2.INTER_NEAREST)
    part = _paint_board(scene, np.asarray(part, np.float32), slopes, x0, top)
    out[b0:b1, a0:a1] = cv2.resize(part, size, interpolation=cv2.INTER_AREA)
    out.flags.writeable = False
    return out


def _paint_board(scene: Scene, part: Floats, slopes: Array, x0: float, top: float) -> Floats:
    camera, board = scene.camera, scene.board
    wide, high = board.sheet_m
    dim = np.array([0.40, 0.47, 0.53]) if scene.light.low else np.array([1.0, 1.0, 1.0])
    away_ground = -camera.centre_m[2] / np.minimum(slopes[..., 1], -1e-3)
    gx, gy = camera.centre_m[0] + away_ground * slopes[..., 0], camera.centre_m[1] + away_ground
    key = scene.light.key
    lift = -gy * key[2] / key[1]
    shadow = (lift > top - high) & (lift < top) & (gy > 0)
    sx = gx + lift * key[0] / key[2]
    shadow &= (sx > x0) & (sx < x0 + wide)
    part = part * (1 - 0.45 * shadow[..., None]).astype(np.float32)
    away = 0.04 - camera.centre_m[1]
    lx, lz = camera.centre_m[0] + away * slopes[..., 0], camera.centre_m[2] + away * slopes[..., 1]
    for foot in (x0 + 0.14, x0 + wide - 0.14):
        leg = (np.abs(lx - foot) < 0.018) & (lz > 0) & (lz < top - high + 0.05)
        part[leg] = np.array([62, 62, 64]) * dim
        base = (np.abs(gx - foot) < 0.035) & (gy > -0.22) & (gy < 0.30)
        part[base] = np.array([48, 48, 50]) * dim
    away = -camera.centre_m[1]
    x, z = camera.centre_m[0] + away * slopes[..., 0], camera.centre_m[2] + away * slopes[..., 1]
    sheet = (x > x0) & (x < x0 + wide) & (z < top) & (z > top - high)
    dark, _ = _checker(
        x / board.square_m, (board.reference_height_m - z) / board.square_m, board.columns, board.rows
    )
    shine = 1 - 0.06 * (x - x0) / wide - 0.05 * (top - z) / high
    part[sheet] = (np.array([222, 226, 226]) * dim) * shine[sheet][:, None]
    black = sheet & dark
    part[black] = (np.array([36, 34, 34]) * dim) * shine[black][:, None]
    return part


def _lab_wall(seed: int, camera: DemoCamera) -> Floats:
    """A painted wall with a skirting board, a cable duct, a shelf edge and a poster, out of focus."""
    h, w = camera.height_px, camera.width_px
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    wall = (172 - 0.04 * x - 0.05 * y)[..., None] * np.array([0.94, 1.0, 1.02], np.float32)
    wall[395:402] *= 0.8
    wall[402:] = np.array([96, 112, 126], np.float32)
    cv2.rectangle(wall, (36, 60), (132, 190), (150, 132, 96), -1)
    cv2.rectangle(wall, (46, 72), (122, 120), (196, 190, 170), -1)
    cv2.rectangle(wall, (560, 0), (574, 400), (205, 206, 204), -1)
    cv2.rectangle(wall, (420, 40), (540, 46), (90, 100, 110), -1)
    for k, ink in enumerate(((70, 80, 150), (120, 90, 60), (60, 110, 90), (90, 90, 95))):
        cv2.rectangle(wall, (428 + 24 * k, 8), (446 + 24 * k, 40), ink, -1)
    tile = noise_tile(seed, ((3.0, 0.6), (20.0, 1.0)), 768)[:h, :w]
    wall += tile[..., None] * 1.6
    return cv2.GaussianBlur(wall, (0, 0), 2.4)  # type: ignore[return-value]


def lab_poses() -> list[tuple[Array, Array]]:
    """(R, t) cam_from_board of the lab pictures; board axes right, down, away; origin at the first inner corner."""
    rng = np.random.default_rng(99)
    spots = [
        (-0.55, -0.5),
        (0.0, -0.55),
        (0.55, -0.5),
        (-0.6, 0.0),
        (0.0, 0.0),
        (0.6, 0.0),
        (-0.55, 0.5),
        (0.0, 0.55),
        (0.55, 0.5),
        (0.0, 0.0),
    ]
    out = []
    for k in range(LAB_COUNT):
        sx, sy = spots[k % len(spots)]
        far = (
            0.46
            + 0.10 * (k % 3)
            + float(rng.uniform(-0.02, 0.03))
            - (0.06 if k % len(spots) in (4, 9) else 0)
        )
        tilt = rng.uniform(-0.5, 0.5, 2) + np.array([-0.18 * sy, 0.18 * sx]) * -1
        rotation, _ = cv2.Rodrigues(np.array([tilt[0], tilt[1], float(rng.uniform(-0.25, 0.25))]))
        middle = np.array([sx * 0.36 * far, sy * 0.24 * far, far])
        centre = np.array([(LAB_COLUMNS - 1) / 2, (LAB_ROWS - 1) / 2, 0]) * LAB_SQUARE_M
        out.append((np.asarray(rotation, float), middle - rotation @ centre))
    return out


def lab_corners_px(index: int, camera: DemoCamera | None = None) -> Array:
    """True inner corners (rows * columns, 2) of a lab picture, row by row."""
    camera = camera or DemoCamera()
    rotation, t = lab_poses()[index]
    c, r = np.meshgrid(np.arange(LAB_COLUMNS), np.arange(LAB_ROWS))
    points = np.stack([c.ravel(), r.ravel(), np.zeros(c.size)], -1) * LAB_SQUARE_M
    return camera.project_cam(points @ rotation.T + t)


def lab_image(index: int, camera: DemoCamera | None = None) -> Image:
    """Lab picture `index` (0..LAB_COUNT-1): a 9x6 board of 30 mm on a clip board, (480, 640, 3) uint8 BGR."""
    camera = camera or DemoCamera()
    rotation, t = lab_poses()[index]
    s = 3
    rays = _lab_rays(camera, s)
    inverse = rotation.T
    origin = -inverse @ t
    along = rays @ inverse.T.astype(np.float32)
    reach = np.float32(-origin[2]) / along[..., 2]
    x = (np.float32(origin[0]) + reach * along[..., 0]) / np.float32(LAB_SQUARE_M)
    y = (np.float32(origin[1]) + reach * along[..., 1]) / np.float32(LAB_SQUARE_M)
    wall = _lab_wall(5, camera)
    picture = np.asarray(cv2.resize(wall, (camera.width_px * s, camera.height_px * s), interpolation=cv2.INTER_LINEAR), np.float32)
    light = (
        np.float32(1.02)
        - np.float32(0.22) * np.float32(abs(rotation[0, 2]))
        - x * np.float32(0.008 * (1 + index % 3))
    )
    shade_ = (x > -1.55) & (x < LAB_COLUMNS + 0.75) & (y > -1.5) & (y < LAB_ROWS + 0.7)
    picture[shade_] = 70
    sheet = (x > -1.45) & (x < LAB_COLUMNS + 0.45) & (y > -1.4) & (y < LAB_ROWS + 0.4)
    picture[sheet] = (228 * light[sheet])[:, None] * np.array([0.97, 1.0, 1.01], np.float32)
    dark, _ = _checker(x, y, LAB_COLUMNS, LAB_ROWS)
    picture[dark] = (38 * light[dark])[:, None] * np.array([1.0, 1.0, 1.0], np.float32)
    small = np.asarray(
        cv2.resize(picture, (camera.width_px, camera.height_px), interpolation=cv2.INTER_AREA), np.float32
    )
    return sensor(small, 1.8, 0.6, 700 + index)


@lru_cache(maxsize=1)
def _lab_rays(camera: DemoCamera, s: int) -> Floats:
    flat = finer(camera.undistort(pixel_grid(camera, 2)), s)
    return np.concatenate([flat, np.ones((*flat.shape[:2], 1), np.float32)], -1)
