"""What happens in front of the demonstration's camera: the site, the board, and who drives by when.

Everything here is a frozen dataclass of plain numbers: hashable, picklable, the same on every machine.
"""

from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np

from tests.simulation.camera import DemoCamera
from tests.simulation.light import BGR, DAY, LOW, Light
from tests.simulation.models import MODELS, Model
from tests.simulation.styles import STYLES, Style

FPS = 30
BOARD_FRAMES = 120
FADE_FRAMES = 10

PAINTS: tuple[BGR, ...] = (
    (206, 208, 210), (62, 60, 60), (150, 152, 154), (38, 34, 158), (140, 84, 38), (226, 226, 224),
    (58, 74, 44), (96, 100, 102), (168, 118, 62), (48, 66, 120), (34, 34, 36), (60, 120, 176),
)  # fmt: skip


@dataclass(frozen=True)
class RoadBoard:
    """The checkerboard on the road: inner corners, and the road's origin below its top left inner corner.

    It stands in the plane Y = 0, square to the road; the reference row is the TOP row of inner corners.
    """

    columns: int = 6
    rows: int = 9
    square_m: float = 0.1
    reference_height_m: float = 1.125
    sheet_m: tuple[float, float] = (0.841, 1.189)


@dataclass(frozen=True)
class Vehicle:
    """One pass: which model, where, how fast, and the true heights of what is drawn.

    `ends_seed`: its front and rear are no other vehicle's, drawn from this; None: those of its style.
    """

    number: int
    model: Model
    year: int
    paint: BGR
    lane: str
    direction: int
    side_plane_m: float
    speed_mps: float
    first_frame: int
    last_frame: int
    front_start_m: float
    roof_height_m: float
    eye_height_m: float
    eye_inset_m: float
    driver_side: str
    tail_lamp_m: float
    seed: int
    ends_seed: int | None = None

    @property
    def style(self) -> Style:
        return STYLES[self.model.category]

    def rear_m(self, frame: int) -> float:
        """Road X of the rearmost point at a frame."""
        front = self.front_start_m + self.direction * self.speed_mps * (frame - self.first_frame) / FPS
        return front - self.direction * self.model.length_m


@dataclass(frozen=True)
class Scene:
    """One video: camera, light, board and passes; `render_frame(scene, n)` draws frame n."""

    name: str
    camera: DemoCamera
    light: Light
    board: RoadBoard
    vehicles: tuple[Vehicle, ...]
    frames: int
    fps: int = FPS
    board_frames: int = BOARD_FRAMES
    seed: int = field(default=0)


def _reach(camera: DemoCamera, y_m: float) -> tuple[float, float]:
    """Leftmost and rightmost X in view on the plane Y = y_m, a little beyond the picture's border."""
    edge = np.array([[0.0, 150.0], [0.0, 380.0], [639.0, 150.0], [639.0, 380.0]])
    x = camera.centre_m[0] + (y_m - camera.centre_m[1]) * camera.ray_slopes(edge)[:, 0]
    return float(x[:2].min()) - 0.12, float(x[2:].max()) + 0.12


def _paint(number: int, shift: int) -> BGR:
    """A colour that the eleven vehicles before did not have, a little lighter or darker."""
    blue, green, red = PAINTS[number * 5 % len(PAINTS)]
    gain = 0.92 + 0.012 * shift
    return blue * gain, green * gain, red * gain


def _vehicle(
    camera: DemoCamera, number: int, model: Model, far: bool, start: int, rng: np.random.Generator
) -> Vehicle:
    direction = -1 if far else 1
    side = float(rng.uniform(2.35, 2.85) if far else rng.uniform(-0.02, 0.36))
    speed = float(rng.uniform(11.0, 15.0) if far else rng.uniform(8.5, 11.5))
    left, right = _reach(camera, side)
    # the rear drags along the far corner of the view: leave only when the whole body, width included, is out
    span = right - left + model.length_m + (1.2 if far else 0.9)
    count = int(np.ceil(span / speed * FPS))
    inset = float(rng.uniform(0.39, 0.46)) if far else model.width_m - float(rng.uniform(0.39, 0.46)) - 0.12
    return Vehicle(
        number=number,
        model=model,
        year=int(rng.integers(model.year_from, model.year_to + 1)),
        paint=_paint(number, int(rng.integers(len(PAINTS)))),
        lane="far" if far else "near",
        direction=direction,
        side_plane_m=round(side, 4),
        speed_mps=round(speed, 3),
        first_frame=start,
        last_frame=start + count,
        front_start_m=right if far else left,
        roof_height_m=round(model.height_m + float(np.clip(rng.normal(0, 0.008), -0.02, 0.02)), 4),
        eye_height_m=round(model.eye_height_m + float(np.clip(rng.normal(0, 0.03), -0.06, 0.06)), 4),
        eye_inset_m=round(inset, 4),
        driver_side="near" if far else "far",
        tail_lamp_m=round(model.tail_lamp_m + float(np.clip(rng.normal(0, 0.005), -0.015, 0.015)), 4),
        seed=int(rng.integers(1 << 30)),
    )


def _timetable(
    camera: DemoCamera, plan: list[tuple[int, bool]], seed: int
) -> tuple[tuple[Vehicle, ...], int]:
    rng = np.random.default_rng(seed)
    vehicles: list[Vehicle] = []
    start = BOARD_FRAMES + FADE_FRAMES + 14
    for number, (index, far) in enumerate(plan, 1):
        vehicles.append(_vehicle(camera, number, MODELS[index], far, start, rng))
        start = vehicles[-1].last_frame + int(rng.integers(6, 14))
    return tuple(vehicles), start


_DAY_PLAN = [
    (0, False), (8, False), (3, True), (6, False), (11, False), (1, True), (4, False), (9, True),
    (13, True), (2, False), (5, False), (12, True), (7, False), (10, False), (0, True), (14, True),
    (3, False), (12, False), (8, True), (1, False), (7, True), (9, False), (2, True), (4, False),
]  # fmt: skip
_LOW_PLAN = [
    (2, False), (9, False), (4, True), (11, False), (0, False), (7, True), (13, True), (3, False),
    (8, True), (6, False), (5, False), (12, True), (1, False), (10, False), (14, True), (4, False),
]  # fmt: skip


@lru_cache(maxsize=1)
def day_scene() -> Scene:
    """The daytime video: board, then 24 passes."""
    camera = DemoCamera()
    vehicles, frames = _timetable(camera, _DAY_PLAN, 20190611)
    return Scene(
        name="day", camera=camera, light=DAY, board=RoadBoard(), vehicles=vehicles, frames=frames, seed=11
    )


@lru_cache(maxsize=1)
def low_light_scene() -> Scene:
    """The low-light video, camera set up anew (another pose, the same lens): board, then 16 passes."""
    camera = DemoCamera(centre_m=(-0.70, -3.12, 1.33), yaw_rad=0.385, pitch_rad=0.028, roll_rad=-0.009)
    vehicles, frames = _timetable(camera, _LOW_PLAN, 20191203)
    return Scene(
        name="low_light",
        camera=camera,
        light=LOW,
        board=RoadBoard(),
        vehicles=vehicles,
        frames=frames,
        seed=12,
    )
