"""An upright sheet in metres on which the scenery is drawn, and the green things that grow on it."""

import cv2
import numpy as np

from tests.simulation.camera import Floats
from tests.simulation.light import BGR, Light
from tests.simulation.paint import Plate

__all__ = ["BGR", "Easel", "grove", "hedge", "tree"]

DUSK = (0.25, 0.19, 0.16)
AIR = (232.0, 226.0, 214.0)


class Easel:
    """Draws flat shapes given in metres (x along the road, z up) with full coverage; lit things apart."""

    def __init__(self, left_m: float, right_m: float, top_m: float, ppm: float, light: Light) -> None:
        self.left_m, self.right_m, self.top_m, self.ppm = left_m, right_m, top_m, ppm
        self.light, self.low = light, light.low
        size = (int(top_m * ppm), int((right_m - left_m) * ppm))
        self.canvas = np.zeros((*size, 4), np.float32)
        self.lamps = np.zeros((*size, 3), np.float32)

    def at(self, x: float, z: float) -> tuple[int, int]:
        return round((x - self.left_m) * self.ppm), round((self.top_m - z) * self.ppm)

    def rect(self, box: tuple[float, float, float, float], ink: BGR, lighter: float = 0.0) -> None:
        """A rectangle (x0, z0, x1, z1)."""
        colour = (ink[0] + lighter, ink[1] + lighter, ink[2] + lighter, 255.0)
        cv2.rectangle(self.canvas, self.at(box[0], box[1]), self.at(box[2], box[3]), colour, -1)

    def poly(self, points: list[tuple[float, float]], ink: BGR) -> None:
        px = np.array([self.at(*p) for p in points], np.int32)
        cv2.fillPoly(self.canvas, [px], (*ink, 255.0))

    def blob(self, x: float, z: float, wide_m: float, high_m: float, turn: float, ink: BGR) -> None:
        """A small tilted ellipse."""
        axes = (max(1, round(wide_m * self.ppm)), max(1, round(high_m * self.ppm)))
        cv2.ellipse(self.canvas, self.at(x, z), axes, turn, 0, 360, (*ink, 255.0), -1)

    def glow(self, box: tuple[float, float, float, float], ink: BGR) -> None:
        """A rectangle that shines by itself in low light."""
        cv2.rectangle(self.lamps, self.at(box[0], box[1]), self.at(box[2], box[3]), ink, -1)

    def finish(self, haze: float, rng: np.random.Generator) -> Plate:
        """Premultiplied plate: grain, haze with distance, dusk and lit windows in low light."""
        soft: Floats = cv2.GaussianBlur(self.canvas, (0, 0), 0.6)
        alpha = soft[..., 3:] / 255
        grain = cv2.GaussianBlur(rng.standard_normal(alpha.shape[:2]).astype(np.float32), (0, 0), 1.3)
        soft[..., :3] *= 1 + 0.10 * grain[..., None]
        if self.low:
            soft[..., :3] *= np.array(DUSK, np.float32)
            soft[..., :3] += cv2.GaussianBlur(self.lamps, (0, 0), 0.8) * 0.8
        else:
            soft[..., :3] = soft[..., :3] * (1 - haze) + np.array(AIR, np.float32) * alpha * haze
        out: Floats = np.asarray(soft, np.float32)
        out.flags.writeable = False
        return Plate(out, self.ppm, self.left_m, self.top_m)


def _leaves(
    easel: Easel,
    x: np.ndarray,
    z: np.ndarray,
    light: np.ndarray,
    size_m: float,
    hue: float,
    rng: np.random.Generator,
) -> None:
    """Leaf clumps from the darkest to the lightest: what lies deep is in shade."""
    for i in np.argsort(light + rng.normal(0, 0.22, len(light))):
        tone = 44 * light[i] + rng.normal(0, 9)
        ink = (42 + 0.55 * tone, 82 + tone + hue * 0.4, 66 + 0.92 * tone + hue)
        wide = float(rng.uniform(0.5, 1.2)) * size_m
        easel.blob(float(x[i]), float(z[i]), wide, wide * 0.65, float(rng.uniform(0, 180)), ink)


def tree(easel: Easel, at: float, height: float, wide: float, rng: np.random.Generator) -> None:
    """A trunk and a crown of several lobes, each lit from the upper left."""
    easel.rect((at - 0.14, 0, at + 0.14, height * 0.55), (44.0, 58.0, 72.0))
    easel.rect((at - 0.14, 0, at - 0.04, height * 0.55), (62.0, 80.0, 96.0))
    lobes = 6
    cx = at + rng.uniform(-0.30, 0.30, lobes) * wide
    cz = height * rng.uniform(0.50, 0.82, lobes)
    radius = wide * rng.uniform(0.24, 0.36, lobes)
    hue, size = float(rng.uniform(-10, 14)), 0.085 if easel.ppm > 25 else 0.17
    count = int(150 * wide / 3 * (0.085 / size))
    turn, reach = rng.uniform(0, 2 * np.pi, (lobes, count)), np.sqrt(rng.uniform(0, 1, (lobes, count)))
    dx, dz = np.cos(turn) * reach, np.sin(turn) * reach
    x = cx[:, None] + dx * radius[:, None]
    z = cz[:, None] + dz * radius[:, None] * 0.9
    light = 0.45 * dz - 0.32 * dx + 0.35 * (z - height * 0.66) / (height * 0.3)
    for k in range(lobes):
        easel.blob(
            float(cx[k]), float(cz[k]), float(radius[k]) * 0.9, float(radius[k]) * 0.8, 0.0, (36, 66, 52)
        )
    _leaves(easel, x.ravel(), z.ravel(), light.ravel(), size, hue, rng)


def grove(easel: Easel, rng: np.random.Generator) -> None:
    """A far line of trees."""
    for x in np.arange(easel.left_m, easel.right_m, 1.9):
        at, height = float(x + rng.uniform(-0.8, 0.8)), float(rng.uniform(4.0, 8.5))
        tree(easel, at, height, float(rng.uniform(3, 5)), rng)


def hedge(easel: Easel, height: float, rng: np.random.Generator) -> None:
    """A clipped hedge along the whole sheet."""
    easel.rect((easel.left_m, 0, easel.right_m, height * 0.84), (38.0, 66.0, 54.0))
    count = int((easel.right_m - easel.left_m) * 60)
    x = rng.uniform(easel.left_m, easel.right_m, count)
    z = height * rng.uniform(0.02, 1.0, count) * (1 + 0.06 * np.sin(x * 2.3))
    _leaves(easel, x, z, 0.9 * (z / height - 0.5), 0.085, 4.0, rng)
