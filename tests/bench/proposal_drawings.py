"""Drawn vehicles to train the proposals' networks on: no site of theirs is one that is reported on.

Cameras, lights and vehicles are drawn wider than those of `surveys.site`, and each vehicle's body, lamps and
driver are unlike any catalogue model's, so that a network must look where a point is and cannot know it from
the model. One file a site: JPEG frames with the truth of every vehicle in view.
"""

from __future__ import annotations

import pickle
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.proposals.road import FEWEST, road_behind
from tests.bench.surveys import boxes_of, site
from tests.simulation import truth
from tests.simulation.camera import DemoCamera
from tests.simulation.light import DAY, LOW, Light
from tests.simulation.render import render_frame
from tests.simulation.scene import FADE_FRAMES, FPS, RoadBoard, Scene, Vehicle
from tests.simulation.styles import STYLES, Style

FIRST_SEED = 50_000  # far from every seed of surveys and benches
FRAMES = 9
BESIDE_PX = 4.0
_SPREAD_M = 0.035


@dataclass(frozen=True)
class Varied(Vehicle):
    """A vehicle with a body style of its own."""

    own: Style | None = None

    @property
    def style(self) -> Style:
        assert self.own is not None
        return self.own


def training_site(seed: int) -> Scene:
    """A site of `surveys.site` with another camera, light and other vehicles."""
    rng = np.random.default_rng((seed, 77))
    scene = site(seed)
    camera = _camera(rng)
    light = _light(LOW if rng.uniform() < 0.5 else DAY, rng)
    vehicles = tuple(_varied(one, rng) for one in scene.vehicles)
    name = f"training {seed}"
    return Scene(name, camera, light, RoadBoard(), vehicles, scene.frames, FPS, -FADE_FRAMES, seed * 41)


def _camera(rng: np.random.Generator) -> DemoCamera:
    focal = float(rng.uniform(410, 590))
    bend = float(rng.uniform(-0.36, -0.22))
    return DemoCamera(
        fx_px=focal,
        fy_px=focal * float(rng.uniform(0.998, 1.002)),
        cx_px=float(rng.uniform(305, 335)),
        cy_px=float(rng.uniform(228, 255)),
        distortion=(bend, 0.12, 5e-4, -3e-4, -0.02),
        centre_m=(
            float(rng.uniform(-1.0, 0.4)),
            float(rng.uniform(-4.6, -2.5)),
            float(rng.uniform(1.05, 2.15)),
        ),
        yaw_rad=float(rng.uniform(-0.05, 0.5)),
        pitch_rad=float(rng.uniform(-0.01, 0.10)),
        roll_rad=float(rng.uniform(-0.03, 0.03)),
    )


def _light(light: Light, rng: np.random.Generator) -> Light:
    level = float(rng.uniform(0.65, 1.25))
    blue, green, red = (one * level * float(rng.uniform(0.93, 1.07)) for one in light.ambient)
    return replace(
        light,
        key=(float(rng.uniform(-0.9, 0.9)), float(rng.uniform(-0.9, -0.2)), 0.72),
        key_gain=light.key_gain * float(rng.uniform(0.6, 1.3)),
        ambient=(blue, green, red),
        noise=light.noise * float(rng.uniform(0.6, 1.9)),
        blur_px=light.blur_px * float(rng.uniform(0.7, 1.7)),
    )


def _varied(one: Vehicle, rng: np.random.Generator) -> Varied:
    model = one.model
    scale = float(rng.uniform(0.93, 1.09))
    model = replace(
        model,
        length_m=model.length_m * float(rng.uniform(0.93, 1.08)),
        width_m=model.width_m * float(rng.uniform(0.95, 1.05)),
        wheelbase_m=model.wheelbase_m * float(rng.uniform(0.95, 1.05)),
    )
    near = one.driver_side == "near"
    inset = float(rng.uniform(0.34, 0.55)) if near else model.width_m - float(rng.uniform(0.40, 0.66))
    grey = rng.uniform() < 0.6
    tone = rng.uniform(25, 230)
    paint = np.clip(tone + rng.normal(0, 6 if grey else 55, 3), 15, 235)
    fields = {name: getattr(one, name) for name in Vehicle.__dataclass_fields__}
    fields |= {
        "model": model,
        "paint": tuple(float(c) for c in paint),
        "roof_height_m": one.roof_height_m * scale,
        "eye_height_m": one.eye_height_m * scale + float(rng.normal(0, 0.04)),
        "eye_inset_m": inset,
        "tail_lamp_m": one.tail_lamp_m * scale + float(rng.normal(0, 0.07)),
    }
    return Varied(**fields, own=_style(STYLES[model.category], rng))


def _style(style: Style, rng: np.random.Generator) -> Style:
    """Another body of the same kind: outline bent, windows, pillars, lamps and driver moved."""

    def moved(value: float, by: float) -> float:
        return value + float(rng.normal(0, by))

    outline = style.outline
    if style.smooth:
        bend = rng.normal(0, _SPREAD_M, len(outline))
        shift = np.convolve(bend, (0.25, 0.5, 0.25), "same")
        outline = tuple((at, z + (d if z > 0.5 else 0.0)) for (at, z), d in zip(outline, shift, strict=True))
    (l0, z0), (l1, z1) = style.belt
    lower, upper = moved(0, 0.03), moved(0, 0.03)
    wide, high = style.tail_lamp
    along, low, top = style.head_lamp
    rise, grow = moved(0, 0.06), float(rng.uniform(0.75, 1.35))
    middle, half = 0.5 * (low + top) + rise, 0.5 * (top - low) * grow
    return replace(
        style,
        outline=outline,
        belt=((l0, z0 + lower), (l1, z1 + upper)),
        tumble=style.tumble * float(rng.uniform(0.75, 1.2)),
        pillars=tuple(moved(one, 0.08) for one in style.pillars),
        tail_lamp=(wide * float(rng.uniform(0.65, 1.5)), high * float(rng.uniform(0.6, 1.5))),
        head_lamp=(along + float(rng.uniform(-0.15, 0.1)), middle - half, middle + half),
        eye_at_m=moved(style.eye_at_m, 0.10),
    )


def drawn(seed: int) -> dict[str, Any]:
    """A site's frames and truth, as `file_of` keeps it."""
    scene = training_site(seed)
    rng = np.random.default_rng((seed, 78))
    first = min(one.first_frame for one in scene.vehicles)
    assert first >= FEWEST, "nobody comes before frame 70"
    grays = [_gray(render_frame(scene, n)) for n in range(FEWEST)]
    road = road_behind(grays)
    assert not isinstance(road, str)
    boxes = {one.number: boxes_of(scene.camera, one) for one in scene.vehicles}
    frames = {}
    for n in sorted(set(_picked(scene, rng))):
        quality = [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(78, 97))]
        coded = cv2.imencode(".jpg", render_frame(scene, n), quality)[1]
        frames[n] = {"jpeg": coded.tobytes(), "vehicles": list(_truths(scene, boxes, n))}
    level, tolerance = np.float16(road.level), np.float16(road.tolerance)
    return {"camera": scene.camera, "low": scene.light.low, "road": (level, tolerance), "frames": frames}


def _gray(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), np.uint8)


def _picked(scene: Scene, rng: np.random.Generator) -> Iterator[int]:
    for one in truth(scene):
        frames = [frame.frame for frame in one.frames if len(frame.pixels) >= 3]
        if frames:
            count = min(FRAMES, len(frames))
            yield from rng.choice(frames, count, replace=False).tolist()


def _truths(scene: Scene, boxes: dict[int, Any], n: int) -> Iterator[dict[str, Any]]:
    sides = {one.number: one.side_plane_m for one in scene.vehicles}
    for one in truth(scene):
        frame = next((f for f in one.frames if f.frame == n), None)
        if frame is None or n not in boxes[one.vehicle.number]:
            continue
        mine = sides[one.vehicle.number]
        nearer = [boxes[k][n] for k, side in sides.items() if side < mine - 0.5 and n in boxes[k]]
        seen = [
            name
            for name, at in frame.pixels.items()
            if frame.shows(name) and not any(_covers(box, at) for box in nearer)
        ]
        yield {
            "number": one.vehicle.number,
            "direction": one.vehicle.direction,
            "side_m": mine,
            "box": boxes[one.vehicle.number][n],
            "pixels": frame.pixels,
            "seen": seen,
            "kind": one.vehicle.model.category,
        }


def _covers(box: tuple[float, float, float, float], at: tuple[float, float]) -> bool:
    left, top, right, bottom = box
    beside = BESIDE_PX
    return left - beside <= at[0] <= right + beside and top - beside <= at[1] <= bottom + beside


def file_of(seed: int, folder: Path) -> Path:
    """The file of a site, drawn where it is not there yet."""
    path = folder / f"{seed}.pickle"
    if not path.is_file():
        part = path.with_suffix(".part")
        part.write_bytes(pickle.dumps(drawn(seed)))
        part.rename(path)
    return path
