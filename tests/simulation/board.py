"""Checkerboards: the one on the road (a scene's first seconds) and the lab pictures for the lens."""

from functools import lru_cache

import cv2
import numpy as np

from tests.simulation.backdrop import backdrop, noise_tile
from tests.simulation.camera import Array, DemoCamera, Floats, Image, finer, pixel_grid
from tests.simulation.scene import RoadBoard, Scene
from tests.simulation.sensor import sensor

LAB_COLUMNS, LAB_ROWS, LAB_SQUARE_M = 9, 6, 0.030
LAB_COUNT = 20


def _checker(u: Array, v: Array, columns: int, rows: int) -> Array:
    """Coverage by black squares; (u, v) in squares from the first inner corner, right and down.

    Edges are ramps one sample wide: hard samples would shift near-upright edges by a fraction of a pixel.
    """
    inside = (u >= -1) & (u < columns) & (v >= -1) & (v < rows)
    return np.asarray((0.5 + 0.5 * _ramp(u) * _ramp(v)) * inside)


def _ramp(u: Array) -> Array:
    """+1 in even squares, -1 in odd ones, a ramp as wide as a sample's footprint at every integer."""
    foot = float(np.median(np.abs(np.diff(u, axis=1))) + np.median(np.abs(np.diff(u, axis=0))))
    whole = np.floor(u)
    side = 1 - 2 * (whole % 2)
    return np.asarray(np.clip(side * np.minimum(u - whole, 1 - u + whole) * (2 / foot), -1, 1))


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
    """The road with the board on its stand, float32, before the sensor; 16 rays per pixel there."""
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
    s = 4
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
    dim = np.array([0.52, 0.61, 0.68]) if scene.light.low else np.array([1.0, 1.0, 1.0])
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
    dark = _checker(
        x / board.square_m, (board.reference_height_m - z) / board.square_m, board.columns, board.rows
    )
    shine = 1 - 0.06 * (x - x0) / wide - 0.05 * (top - z) / high
    part[sheet] = (np.array([222, 226, 226]) * dim) * shine[sheet][:, None]
    ink = (dark * sheet)[..., None]
    out: Floats = part * (1 - ink) + (np.array([36, 34, 34]) * dim) * shine[..., None] * ink
    return out.astype(np.float32)


@lru_cache(maxsize=1)
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
    return np.asarray(cv2.GaussianBlur(wall, (0, 0), 2.4), np.float32)


def _fits(camera: DemoCamera, rotation: Array, t: Array) -> bool:
    """Whether the whole sheet, a square beyond the inner corners, is well inside the picture."""
    c, r = np.meshgrid([-1.2, LAB_COLUMNS / 2, LAB_COLUMNS + 0.2], [-1.2, LAB_ROWS / 2, LAB_ROWS + 0.2])
    points = np.stack([c.ravel(), r.ravel(), np.zeros(c.size)], -1) * LAB_SQUARE_M
    px = camera.project_cam(points @ rotation.T + t)
    return bool(np.all((px > 4) & (px < (camera.width_px - 5, camera.height_px - 5))))


@lru_cache(maxsize=1)
def lab_poses() -> tuple[tuple[Array, Array], ...]:
    """(R, t) cam_from_board of the lab pictures; board axes right, down, away; origin: first corner.

    Each board is pushed toward one part of the picture as far as it stays wholly in view.
    """
    rng, camera = np.random.default_rng(99), DemoCamera()
    spots = [(x, y) for y in (-1, 0, 1) for x in (-1, 0, 1)] + [(-1, -1), (1, 1), (1, -1), (-1, 1)]
    middle = np.array([(LAB_COLUMNS - 1) / 2, (LAB_ROWS - 1) / 2, 0]) * LAB_SQUARE_M
    out = []
    for k in range(LAB_COUNT):
        sx, sy = spots[k % len(spots)]
        far = (0.36, 0.44, 0.52)[k % 3] + float(rng.uniform(-0.02, 0.02))
        tilt = rng.uniform(-0.42, 0.42, 2)
        rotation, _ = cv2.Rodrigues(np.array([tilt[0], tilt[1], float(rng.uniform(-0.2, 0.2))]))
        push = 1.0
        while True:
            centre = np.array([sx * 0.72 * far * push, sy * 0.52 * far * push, far])
            t = centre - rotation @ middle
            if _fits(camera, rotation, t) or push < 0.02:
                break
            push *= 0.97
        out.append((np.asarray(rotation), np.asarray(t)))
    return tuple(out)


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
    s = 2
    rays = _lab_rays(camera, s)
    inverse = rotation.T
    origin = -inverse @ t
    along = rays @ inverse.T.astype(np.float32)
    reach = np.float32(-origin[2]) / along[..., 2]
    x = (np.float32(origin[0]) + reach * along[..., 0]) / np.float32(LAB_SQUARE_M)
    y = (np.float32(origin[1]) + reach * along[..., 1]) / np.float32(LAB_SQUARE_M)
    wall = _lab_wall(5, camera)
    picture = np.asarray(
        cv2.resize(wall, (camera.width_px * s, camera.height_px * s), interpolation=cv2.INTER_LINEAR),
        np.float32,
    )
    light = (
        np.float32(1.02)
        - np.float32(0.22) * np.float32(abs(rotation[0, 2]))
        - x * np.float32(0.008 * (1 + index % 3))
    )
    shade_ = (x > -1.55) & (x < LAB_COLUMNS + 0.75) & (y > -1.5) & (y < LAB_ROWS + 0.7)
    picture[shade_] = 70
    sheet = (x > -1.45) & (x < LAB_COLUMNS + 0.45) & (y > -1.4) & (y < LAB_ROWS + 0.4)
    picture[sheet] = (228 * light[sheet])[:, None] * np.array([0.97, 1.0, 1.01], np.float32)
    dark = _checker(x, y, LAB_COLUMNS, LAB_ROWS)
    picture += dark[..., None] * ((38 * light)[..., None] - picture)
    small = np.asarray(
        cv2.resize(picture, (camera.width_px, camera.height_px), interpolation=cv2.INTER_AREA), np.float32
    )
    return sensor(small, 1.8, 0.6, 700 + index)


@lru_cache(maxsize=1)
def _lab_rays(camera: DemoCamera, s: int) -> Floats:
    flat = finer(camera.undistort(pixel_grid(camera, 2)), s)
    return np.concatenate([flat, np.ones((*flat.shape[:2], 1), np.float32)], -1)
