"""A drawn street, quick to make: textured road and houses, vehicles, their shadows and lights, a walker."""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

WIDTH, HEIGHT = 320, 240
Picture = NDArray[np.uint8]


@dataclass(frozen=True)
class Mover:
    """A box on the street: its left edge at `start_px` on frame `first`, moving `step_px` a frame."""

    first: int
    start_px: float
    step_px: float
    width_px: int
    height_px: int
    foot_px: int
    grey: int
    headlight: bool = False

    def left(self, n: int) -> float:
        return self.start_px + self.step_px * (n - self.first)

    def whole(self, n: int) -> bool:
        return self.left(n) >= 0 and self.left(n) + self.width_px <= WIDTH

    def in_view(self, n: int) -> bool:
        return n >= self.first and -self.width_px < self.left(n) < WIDTH


def car(first: int, right: bool = True, near: bool = True, grey: int = 210, headlight: bool = False) -> Mover:
    """A car that drives in from its border on frame `first` and crosses the picture in about a second."""
    width, height, foot = (180, 90, 205) if near else (100, 48, 150)
    step = 14.0 if near else 11.0
    start, speed = (-width + 6.0, step) if right else (WIDTH - 6.0, -step)
    return Mover(first, start, speed, width, height, foot, grey, headlight)


def walker(first: int) -> Mover:
    """Somebody who carries a board along the road."""
    return Mover(first, -20.0, 5.0, 30, 100, 205, 40)


def texture(width: int, height: int, seed: int) -> NDArray[np.float32]:
    """Grey values 40 to 210 with detail of all sizes, as scenery and paint have it."""
    rng = np.random.default_rng(seed)
    out = np.zeros((height, width), np.float32)
    for cell in (6, 20, 60):
        coarse = rng.normal(0, 1, (height // cell + 2, width // cell + 2)).astype(np.float32)
        out += cv2.resize(coarse, (width, height), interpolation=cv2.INTER_CUBIC)
    return np.asarray(np.clip(125 + 30 * out, 40, 210), np.float32)


def street(
    count: int,
    movers: list[Mover],
    level: float = 1.0,
    flicker: float = 0.0,
    board_until: int = 0,
    detailed: bool = False,
) -> Iterator[Picture]:
    """`count` frames, (HEIGHT, WIDTH) grey; `level` is the light, `flicker` its relative swing; `detailed`:
    the ground has detail of all sizes.
    """
    rng = np.random.default_rng(5)
    ground = (
        texture(WIDTH, HEIGHT, 7)
        if detailed
        else cv2.resize(rng.uniform(90, 150, (48, 64)).astype(np.float32), (WIDTH, HEIGHT))
    )
    for n in range(count):
        frame = ground * level
        if n < board_until:
            frame[90:200, 130:190] = 200 * level
        for mover in sorted(movers, key=lambda one: one.foot_px):
            if mover.in_view(n):
                _draw(frame, mover, n, level)
        frame = frame * (1 + flicker * np.sin(1.7 * n)) + rng.normal(0, 1.5, frame.shape)
        yield np.clip(frame, 0, 255).astype(np.uint8)


def _draw(frame: NDArray[np.float32], one: Mover, n: int, level: float) -> None:
    x, y, w, h = round(one.left(n)), one.foot_px, one.width_px, one.height_px
    across = np.arange(WIDTH)
    if one.headlight:
        nose = x + w if one.step_px > 0 else x
        ahead = (across - nose) * np.sign(one.step_px)
        beam = np.where(ahead > 0, np.exp(-((ahead - 50) ** 2) / 1800.0), 0.0)
        flat = np.exp(-((np.arange(HEIGHT) - (y - 6)) ** 2) / 160.0)
        frame += 150 * flat[:, None] * beam[None, :]
    else:
        frame[y - 4 : y + 8, max(x - 10, 0) : max(x + w + 10, 0)] *= 0.6
    paint = one.grey * level
    cv2.rectangle(frame, (x, y - h // 2), (x + w, y), paint, -1)
    cv2.rectangle(frame, (x + w // 5, y - h), (x + 4 * w // 5, y - h // 2), paint, -1)
    cv2.rectangle(frame, (x + w // 4, y - h + 6), (x + 3 * w // 4, y - h // 2 - 4), 60.0 * level, -1)
    for wheel in (x + w // 5, x + 4 * w // 5):
        cv2.circle(frame, (wheel, y), max(4, h // 8), 20.0 * level, -1)
