"""What stands beyond the road, plate by plate from the horizon to the guard rail, and the sky above."""

import cv2
import numpy as np

from tests.simulation.camera import Floats
from tests.simulation.easel import Easel, grove, hedge, tree
from tests.simulation.light import BGR, Light
from tests.simulation.paint import Plate

PLASTER: tuple[BGR, ...] = (
    (176, 200, 216),
    (200, 207, 210),
    (104, 122, 164),
    (160, 190, 204),
    (188, 206, 196),
)


def sky_colours(light: Light, seed: int, a: Floats, b: Floats) -> Floats:
    """Sky (h, w, 3): a gradient with soft clouds by day, deep blue above an afterglow in low light."""
    up = np.clip(b / 0.6, 0, 1)[..., None]
    low, high = np.array(light.horizon, np.float32), np.array(light.zenith, np.float32)
    colour = low + (high - low) * up**0.8
    rng = np.random.default_rng(seed // 100 + 78)
    small = np.zeros((96, 160), np.float32)
    for sigma, weight in ((1.5, 0.22), (3, 0.5), (7, 1.0), (14, 0.9)):
        white = cv2.GaussianBlur(rng.standard_normal((96, 160)).astype(np.float32), (0, 0), sigma)
        small += weight * white / white.std()
    u, v = (a * 24 + 50).astype(np.float32), (90 - b * 130).astype(np.float32)
    cloud = np.clip(cv2.remap(small, u, v, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT) * 0.40, 0, 1)
    white = np.array([252, 251, 250] if not light.low else [104, 82, 76], np.float32)
    return np.asarray(colour + (white - colour) * 0.8 * cloud[..., None], np.float32)


def _roof(easel: Easel, at: float, wide: float, eaves: float, rng: np.random.Generator) -> None:
    tile = (60 + rng.uniform(-8, 8), 72 + rng.uniform(-8, 8), 126 + rng.uniform(-34, 18))
    ridge = eaves + wide * 0.28
    easel.poly(
        [(at - 0.35, eaves), (at + wide + 0.35, eaves), (at + wide * 0.86, ridge), (at + wide * 0.14, ridge)],
        tile,
    )
    for z in np.arange(eaves, ridge, 0.22):
        t = (z - eaves) / (ridge - eaves)
        x0, x1 = at - 0.35 + t * (0.35 + wide * 0.14), at + wide + 0.35 - t * (0.35 + wide * 0.14)
        easel.rect((x0 + 0.1, z, x1 - 0.1, z + 0.05), tile, float(rng.uniform(-20, -8)))
    easel.rect((at + wide * 0.14, ridge - 0.1, at + wide * 0.86, ridge + 0.08), tile, -22)
    chimney = at + wide * rng.uniform(0.25, 0.7)
    easel.rect((chimney, ridge - 0.4, chimney + 0.6, ridge + 0.8), (58, 66, 104))
    easel.rect((chimney + 0.4, ridge - 0.4, chimney + 0.6, ridge + 0.8), (44, 50, 80))


def _window(easel: Easel, x: float, z: float, lit: bool) -> None:
    easel.rect((x - 0.62, z - 0.12, x + 0.62, z + 1.44), (206, 209, 209))
    easel.rect((x - 0.66, z - 0.16, x + 0.66, z - 0.08), (150, 154, 156))
    easel.rect((x - 0.52, z, x + 0.52, z + 1.34), (84, 74, 66))
    easel.rect((x - 0.52, z + 0.75, x + 0.52, z + 1.34), (132, 118, 104))
    easel.rect((x - 0.48, z + 0.1, x - 0.22, z + 1.3), (150, 152, 152))
    if lit:
        easel.glow((x - 0.52, z, x + 0.52, z + 1.34), (96, 178, 236))
    easel.rect((x - 0.03, z, x + 0.03, z + 1.34), (196, 198, 198))
    easel.rect((x - 0.52, z + 0.86, x + 0.52, z + 0.91), (196, 198, 198))


def _house(easel: Easel, at: float, wide: float, eaves: float, ink: BGR, rng: np.random.Generator) -> None:
    """A plastered front with a tiled roof, windows with frames and sills, a gutter and a door."""
    _roof(easel, at, wide, eaves, rng)
    easel.rect((at, 0, at + wide, eaves), ink)
    easel.rect((at, 0, at + wide, 0.55), ink, -42)
    easel.rect((at, eaves - 0.45, at + wide, eaves), ink, -30)
    easel.rect((at - 0.3, eaves - 0.12, at + wide + 0.3, eaves + 0.02), (92, 94, 96))
    easel.rect((at + wide - 0.2, 0, at + wide - 0.08, eaves), (96, 98, 100))
    columns = max(2, int(wide / 2.4))
    for storey in range(int(eaves // 2.7)):
        for column in range(columns):
            x, z = at + (column + 0.5) * wide / columns, 0.95 + 2.75 * storey
            if storey == 0 and column == columns // 2:
                easel.rect((x - 0.58, 0, x + 0.58, 2.25), ink, -24)
                easel.rect((x - 0.46, 0, x + 0.46, 2.1), (52, 66, 60))
                easel.rect((x - 0.2, 1.3, x + 0.2, 1.9), (90, 92, 88))
            else:
                _window(easel, x, z, easel.low and rng.uniform() < 0.34)


def _rail(easel: Easel) -> None:
    """A steel guard rail: posts and a beam with its two waves."""
    for x in np.arange(easel.left_m + 0.6, easel.right_m, 2.0):
        easel.rect((x - 0.05, 0, x + 0.05, 0.62), (108, 111, 112))
    for k, tone in enumerate((140, 178, 162, 116, 104, 150, 192, 170, 128)):
        easel.rect(
            (easel.left_m, 0.42 + 0.031 * k, easel.right_m, 0.452 + 0.031 * k), (tone + 2.0, tone, tone - 2.0)
        )
    for x in np.arange(easel.left_m + 0.75, easel.right_m, 4.0):
        easel.rect((x, 0.42, x + 0.025, 0.70), (96, 97, 98))


def _post(easel: Easel, at: float, height: float) -> None:
    easel.rect((at - 0.065, 0, at + 0.065, height), (104, 108, 107))
    easel.rect((at - 0.065, 0, at - 0.02, height), (134, 138, 137))
    easel.rect((at - 0.9, height - 0.10, at + 0.04, height), (108, 112, 110))
    easel.rect((at - 1.35, height - 0.14, at - 0.75, height + 0.02), (150, 154, 154))
    if easel.low:
        easel.glow((at - 1.33, height - 0.16, at - 0.77, height - 0.06), (190, 226, 255))


def _row_of_houses(easel: Easel, rng: np.random.Generator) -> None:
    x = easel.left_m
    while x < easel.right_m - 2:
        wide = float(rng.uniform(6.5, 10))
        ink = PLASTER[int(rng.integers(len(PLASTER)))]
        if rng.uniform() < 0.74:
            _house(easel, x, wide, float(rng.choice([3.2, 5.8, 5.8])), ink, rng)
        else:
            for k in range(3):
                tree(easel, x + 1 + 2.4 * k, float(rng.uniform(4.5, 7.5)), 3.2, rng)
        x += wide + float(rng.uniform(0.6, 3.5))


def street_plates(light: Light, seed: int) -> list[tuple[Plate, float]]:
    """Plates and the Y they stand at, the farthest first."""
    rng = np.random.default_rng(1003 + seed // 100)
    far = Easel(-14.0, 62.0, 16.0, 16, light)
    grove(far, rng)
    row = Easel(-14.0, 46.0, 13.0, 30, light)
    _row_of_houses(row, rng)
    trees = Easel(-14.0, 34.0, 9.0, 44, light)
    for x in (-6.0, 1.2, 8.4, 13.4, 21.5, 29.0):
        tree(
            trees,
            x + float(rng.uniform(-0.6, 0.6)),
            float(rng.uniform(4.2, 6.4)),
            float(rng.uniform(2.8, 3.8)),
            rng,
        )
    shrubs = Easel(-9.0, 26.0, 2.0, 56, light)
    hedge(shrubs, 1.05, rng)
    rail = Easel(-7.0, 24.0, 7.0, 64, light)
    _rail(rail)
    _post(rail, 5.2, 6.2)
    _post(rail, 19.0, 6.2)
    stack = (
        (far, 34.0, 0.34),
        (row, 19.0, 0.15),
        (trees, 12.5, 0.06),
        (shrubs, 9.4, 0.03),
        (rail, 7.6, 0.01),
    )
    return [(easel.finish(haze, rng), y_m) for easel, y_m, haze in stack]
