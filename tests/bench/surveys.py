"""Surveys that the demonstration does not show, drawn by its renderer, to try the search for passes on.

A site is a seed: lens, camera height, distance, yaw, light, noise, lanes, speeds and the order of vehicles
follow from it. Unlike in the demonstration, the lanes do not wait for each other: vehicles meet, hide each
other and follow closely. `TRAINING` may be looked at and tuned on; `HELD_OUT` is only ever counted.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from sightline.geometry.camera import Camera
from sightline.geometry.road_pose import RoadPose
from sightline.media.video.writer import write_mp4
from tests.simulation import render
from tests.simulation.camera import DemoCamera
from tests.simulation.compose import Place
from tests.simulation.light import DAY, LOW, Light
from tests.simulation.models import MODELS
from tests.simulation.scene import FADE_FRAMES, FPS, RoadBoard, Scene, Vehicle, _paint, _reach
from tests.simulation.shape import shape_of

TRAINING = (101, 102, 103, 104, 105, 106)
HELD_OUT = (201, 202, 203, 204, 205, 206)
VEHICLES = 26
ROOM_M = 5.0  # least empty road between two vehicles of a lane
MEAN_GAP_S = 1.6

# Every passing vehicle's textures are kept while several are in view at once.
render.vehicle_kit = lru_cache(maxsize=10)(render.vehicle_kit.__wrapped__)


@dataclass(frozen=True)
class Passing:
    """What is true of one pass: in view from first to last frame, all of it from `whole` to `whole`."""

    number: int
    category: str
    lane: str
    direction: int
    speed_mps: float
    first_frame: int
    last_frame: int
    whole: tuple[int, int] | None
    hidden: float  # share of its frames in which a nearer vehicle covers some of it


def site(seed: int) -> Scene:
    """The survey of a seed; odd seeds are daytime, even ones low light."""
    rng = np.random.default_rng(seed)
    low = seed % 2 == 0
    camera = _camera(rng)
    vehicles = [*_lane(camera, False, VEHICLES // 2, rng), *_lane(camera, True, VEHICLES // 2, rng)]
    vehicles = [replace(one, number=i) for i, one in enumerate(sorted(vehicles, key=_start), 1)]
    frames = max(one.last_frame for one in vehicles) + 20
    board = 60 if seed % 3 == 0 else -FADE_FRAMES
    light = _light(LOW if low else DAY, rng)
    return Scene(f"site {seed}", camera, light, RoadBoard(), tuple(vehicles), frames, FPS, board, seed * 37)


def video_of(scene: Scene, folder: Path) -> Path:
    """The site as a video; drawn where it is not there yet."""
    path = folder / f"{scene.name.replace(' ', '_')}.mp4"
    if not path.is_file():
        write_mp4(path, (render.render_frame(scene, n) for n in range(scene.frames)), scene.fps)
    return path


def pose_of(scene: Scene) -> RoadPose:
    """The true road pose of a drawn scene."""
    c = scene.camera
    lens = Camera(
        "drawn", c.width_px, c.height_px, "brown", c.fx_px, c.fy_px, c.cx_px, c.cy_px, np.array(c.distortion)
    )
    return RoadPose(lens, c.rotation(), c.translation_m())


def passings(scene: Scene) -> list[Passing]:
    """The truth, in order of coming into view."""
    boxes = {one.number: boxes_of(scene.camera, one) for one in scene.vehicles}
    found = [_passing(scene, one, boxes) for one in scene.vehicles]
    return sorted(found, key=lambda one: one.first_frame)


def _start(one: Vehicle) -> int:
    return one.first_frame


def _camera(rng: np.random.Generator) -> DemoCamera:
    focal = float(rng.uniform(430, 560))
    return DemoCamera(
        fx_px=focal,
        fy_px=focal * 1.001,
        cx_px=float(rng.uniform(310, 330)),
        cy_px=float(rng.uniform(232, 250)),
        centre_m=(
            float(rng.uniform(-0.8, 0.2)),
            float(rng.uniform(-4.3, -2.7)),
            float(rng.uniform(1.15, 1.95)),
        ),
        yaw_rad=float(rng.uniform(0.05, 0.45)),
        pitch_rad=float(rng.uniform(0.0, 0.08)),
        roll_rad=float(rng.uniform(-0.02, 0.02)),
    )


def _light(light: Light, rng: np.random.Generator) -> Light:
    level = float(rng.uniform(0.75, 1.15))
    blue, green, red = light.ambient
    return replace(
        light,
        key=(float(rng.uniform(-0.7, 0.7)), float(rng.uniform(-0.8, -0.3)), 0.72),
        ambient=(blue * level, green * level, red * level),
        noise=light.noise * float(rng.uniform(0.8, 1.7)),
        blur_px=light.blur_px * float(rng.uniform(0.8, 1.5)),
    )


def _lane(camera: DemoCamera, far: bool, count: int, rng: np.random.Generator) -> list[Vehicle]:
    """Vehicles of one lane that keep their distance while they are in view."""
    made: list[Vehicle] = []
    start = int(rng.integers(70, 110))
    for number in range(1, count + 1):
        one = _vehicle(camera, number, far, start, rng)
        while made and _room_m(made[-1], one) < ROOM_M:
            one = _moved(one, 4)
        made.append(one)
        start = one.first_frame + 8 + int(rng.exponential(MEAN_GAP_S) * FPS)
    return made


def _vehicle(camera: DemoCamera, number: int, far: bool, start: int, rng: np.random.Generator) -> Vehicle:
    model = MODELS[int(rng.integers(len(MODELS)))]
    side = float(rng.uniform(2.25, 3.1) if far else rng.uniform(-0.15, 0.5))
    speed = float(rng.uniform(8.0, 22.0) if far else rng.uniform(6.0, 16.0))
    left, right = _reach(camera, side)
    count = int(np.ceil((right - left + model.length_m + 2.5) / speed * FPS))
    inset = 0.42 if far else model.width_m - 0.54
    return Vehicle(
        number=number,
        model=model,
        year=int(model.year_from),
        paint=_paint(int(rng.integers(100)), int(rng.integers(12))),
        lane="far" if far else "near",
        direction=-1 if far else 1,
        side_plane_m=side,
        speed_mps=speed,
        first_frame=start,
        last_frame=start + count,
        front_start_m=right + 0.6 if far else left - 0.6,
        roof_height_m=model.height_m,
        eye_height_m=model.eye_height_m,
        eye_inset_m=inset,
        driver_side="near" if far else "far",
        tail_lamp_m=model.tail_lamp_m,
        seed=int(rng.integers(1 << 30)),
    )


def _moved(one: Vehicle, frames: int) -> Vehicle:
    return replace(one, first_frame=one.first_frame + frames, last_frame=one.last_frame + frames)


def _room_m(before: Vehicle, one: Vehicle) -> float:
    """Least empty road between them while both are drawn; negative where they would touch."""
    shared = [n for n in (one.first_frame, before.last_frame) if n <= before.last_frame]
    if one.first_frame > before.last_frame:
        return ROOM_M
    front = [one.rear_m(n) + one.direction * one.model.length_m for n in shared]
    return min((before.rear_m(n) - at) * one.direction for n, at in zip(shared, front, strict=True))


def boxes_of(camera: DemoCamera, one: Vehicle) -> dict[int, tuple[float, float, float, float]]:
    """Frame -> box of the whole body, px, not clipped, for the frames in which some of it is in view."""
    shape = shape_of(one)
    along, z = np.vstack([shape.outline, shape.outline * (1, 0)]).T
    boxes = {}
    for n in range(one.first_frame - 30, one.last_frame + 31):
        place = Place(one.rear_m(n), one.direction, one.side_plane_m)
        body = np.concatenate([place.road(along, np.array(at), z) for at in (0.05, shape.width_m - 0.05)])
        depth = body @ camera.rotation().T[:, 2] + camera.translation_m()[2]
        px = camera.project(body[depth > 0.3])
        if len(px) == 0:
            continue
        (x0, y0), (x1, y1) = px.min(0), px.max(0)
        if x1 > 2 and x0 < camera.width_px - 3 and one.first_frame <= n <= one.last_frame:
            boxes[n] = (float(x0), float(y0), float(x1), float(y1))
    return boxes


def _passing(
    scene: Scene, one: Vehicle, boxes: dict[int, dict[int, tuple[float, float, float, float]]]
) -> Passing:
    mine = boxes[one.number]
    limit = scene.camera.width_px - 2, scene.camera.height_px - 2
    whole = [n for n, (x0, y0, x1, y1) in mine.items() if min(x0, y0) > 1 and x1 < limit[0] and y1 < limit[1]]
    nearer = [boxes[v.number] for v in scene.vehicles if v.side_plane_m < one.side_plane_m - 0.5]
    hidden = [
        n for n in mine if any(n in b and b[n][0] < mine[n][2] and b[n][2] > mine[n][0] for b in nearer)
    ]
    return Passing(
        one.number,
        one.model.category,
        one.lane,
        one.direction,
        one.speed_mps,
        min(mine),
        max(mine),
        (whole[0], whole[-1]) if whole else None,
        len(hidden) / len(mine),
    )
