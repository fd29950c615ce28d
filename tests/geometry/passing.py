"""Drawn passes to test with: a vehicle past the independent camera of simulate.py, its followed points with
noise, and the Cramer-Rao bound by differences. It shares no code with sightline.
"""

from dataclasses import dataclass, replace

import numpy as np

from tests.geometry.simulate import Lens, Scene

FPS = 25.0
NEAR, FAR = (Scene(Lens(), (0.0, -d, 1.5), 0.0, 3.0, 0.5) for d in (3.0, 6.4))
CONTACT, SECOND, TARGET = 0, 1, 2


@dataclass(frozen=True)
class Drawn:
    """A vehicle: place (m) of its contact at time 0, heading (rad), speed (m/s) and so on."""

    x: float = 0.9
    y: float = 0.05
    heading: float = 0.01
    speed: float = 9.0
    ahead: float = -0.9
    inset: float = 0.45
    height: float = 1.16
    wheelbase: float = -2.6
    acceleration: float = 0.0

    def vector(self):
        return np.array(list(self.__dict__.values()))


def place(car: Drawn, point, t):
    """Road points (N, 3) at times t (N,)."""
    c, s = np.cos(car.heading), np.sin(car.heading)
    ahead = np.array([0.0, car.wheelbase, car.ahead])[point]
    side, up = np.array([0.0, 0.0, car.inset])[point], np.array([0.0, 0.0, car.height])[point]
    run = car.speed * t + car.acceleration * t * t / 2 + ahead
    return np.column_stack([car.x + run * c - side * s, car.y + run * s + side * c, up])


def look(scene: Scene, car: Drawn, point, t, row_time=0.0):
    """Pixels (N, 2); with a rolling shutter each row is seen at its own time, found by halving."""
    if not row_time:
        return scene.look(place(car, point, t))
    low, high = np.full(len(t), -200.0), np.full(len(t), scene.lens.height + 200.0)
    middle = (scene.lens.height - 1) / 2
    for _ in range(38):
        row = (low + high) / 2
        there = scene.look(place(car, point, t + row_time * (row - middle)))[:, 1]
        low, high = np.where(there > row, row, low), np.where(there > row, high, row)
    return scene.look(place(car, point, t + row_time * ((low + high) / 2 - middle)))


def frames_of(scene: Scene, car: Drawn, points=(CONTACT, SECOND, TARGET), row_time=0.0, border=12.0):
    """frame (N,), point (N,), t (N,) of what is inside the picture, and not further aside than lenses are
    described.
    """
    frame, point = np.meshgrid(np.arange(-60, 61), points, indexing="ij")
    frame, point = frame.ravel(), point.ravel()
    t = frame / FPS
    aside = np.abs(place(car, point, t)[:, 0] - scene.eye[0]) < 1.2 * abs(scene.eye[1])
    frame, point, t = frame[aside], point[aside], t[aside]
    pixels = look(scene, car, point, t, row_time)
    size = np.array([scene.lens.width, scene.lens.height])
    seen = ((pixels > border) & (pixels < size - 1 - border)).all(axis=1)
    return frame[seen], point[seen], t[seen]


def covariance(frame, point, sigma, confirmed=0.0, drift=0.0, begun_on=0):
    """(N, N) of each coordinate."""
    same = point[:, None] == point[None, :]
    away = frame - begun_on
    one_way = away[:, None] * away[None, :] > 0
    walked = np.where(one_way, np.minimum(abs(away)[:, None], abs(away)[None, :]), 0)
    return sigma**2 * np.eye(len(frame)) + same * (confirmed**2 + drift**2 * walked)


def bound(scene: Scene, car: Drawn, frame, point, t, cov, u_heading=None, row_time=0.0):
    """Cramer-Rao bound (k, k) of the nine unknowns that the points touch, acceleration known to be 0."""
    names = list(car.__dict__)[:-1]
    if not (point == SECOND).any():
        names.remove("wheelbase")
    columns = []
    for name in names:
        h = 1e-5
        up, down = (replace(car, **{name: getattr(car, name) + s * h}) for s in (1, -1))
        columns.append(
            (look(scene, up, point, t, row_time) - look(scene, down, point, t, row_time)) / (2 * h)
        )
    slope = np.stack(columns, axis=2)  # (N, 2, k)
    inverse = np.linalg.inv(cov)
    information = sum(slope[:, a].T @ inverse @ slope[:, a] for a in (0, 1))
    if u_heading is not None:
        information[names.index("heading"), names.index("heading")] += u_heading**-2
    return names, np.linalg.inv(information)
