"""Draws frame n of a scene: backdrop, board or vehicle, glow, then what lens and sensor do to it."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from tests.simulation.backdrop import backdrop
from tests.simulation.board import board_backdrop
from tests.simulation.camera import Floats, Image
from tests.simulation.compose import Place, Relief, lay_ground, lay_plate, lay_relief
from tests.simulation.glow import add_glow, beam_plate
from tests.simulation.insides import (
    driver_plate,
    far_side_plate,
    mirror_plate,
    seats_plate,
    spoke_count,
    tyre_plate,
    wheel_plates,
)
from tests.simulation.mesh import Facets, build_facets, lay_facets
from tests.simulation.paint import Plate
from tests.simulation.scene import FADE_FRAMES, Scene, Vehicle
from tests.simulation.sensor import expose
from tests.simulation.shade_plates import shadow_plate, under_plate
from tests.simulation.shape import Shape, shape_of
from tests.simulation.sideart import side_plate

TURNS = 8


@dataclass(frozen=True, eq=False)
class Kit:
    """All prepared textures of one vehicle under one light."""

    shape: Shape
    relief: Relief
    facets: Facets
    under: Plate
    far_side: Plate
    seats: Plate
    driver: Plate
    mirror: Plate
    shadow: Plate
    beam: Plate | None
    tyre: Plate
    wheels: tuple[Plate, ...]


def _relief(scene: Scene, shape: Shape, ppm: float) -> Relief:
    vehicle = shape.vehicle
    near = vehicle.side_plane_m - scene.camera.centre_m[1]
    smear = vehicle.speed_mps * scene.light.exposure_s
    plate = side_plate(shape, scene.light, ppm, scene.camera.centre_m[2], near, smear)
    h, w = plate.rgba.shape[:2]
    coarse = 60.0
    along = plate.left_m + (np.arange(int(np.ceil(w / ppm * coarse))) + 0.5) / coarse
    z = plate.top_m - (np.arange(int(np.ceil(h / ppm * coarse))) + 0.5) / coarse
    along = np.clip(along, 0, shape.length_m)
    depth = shape.inset(*np.meshgrid(along, z)).astype(np.float32)
    return Relief(plate, depth, coarse)


@lru_cache(maxsize=3)
def vehicle_kit(scene: Scene, vehicle: Vehicle) -> Kit:
    """Paints one vehicle; some 100 ms, kept for the frames in which it passes."""
    shape, light = shape_of(vehicle), scene.light
    near = vehicle.side_plane_m - scene.camera.centre_m[1]
    ppm = 640.0 / near
    spin = vehicle.speed_mps / shape.radius_m * light.exposure_s
    return Kit(
        shape=shape,
        relief=_relief(scene, shape, ppm),
        facets=build_facets(shape, light),
        under=under_plate(shape, light, ppm / 2),
        far_side=far_side_plate(shape, light, ppm * 0.7),
        seats=seats_plate(shape, light, ppm * 0.7),
        driver=driver_plate(shape, light, ppm),
        mirror=mirror_plate(shape, light, ppm),
        shadow=shadow_plate(shape, light),
        beam=beam_plate(shape) if light.low else None,
        tyre=tyre_plate(shape, light, ppm / 2),
        wheels=wheel_plates(shape, light, ppm, TURNS, spin),
    )


def _wheel(kit: Kit, rear_m: float, axle: float) -> Plate:
    """The wheel's texture turned by the way it has rolled (mirrored for the far lane)."""
    shape = kit.shape
    roll = shape.vehicle.direction * rear_m / shape.radius_m + axle
    return kit.wheels[int(np.floor(roll / (2 * np.pi / spoke_count(shape)) * TURNS)) % TURNS]


def draw_vehicle(frame: Floats, scene: Scene, vehicle: Vehicle, n: int) -> None:
    """Lays one vehicle onto the frame, the farthest parts first."""
    kit, camera = vehicle_kit(scene, vehicle), scene.camera
    place = Place(vehicle.rear_m(n), vehicle.direction, vehicle.side_plane_m)
    shape = kit.shape
    lay_ground(frame, camera, kit.shadow, place)
    if kit.beam is not None:
        lay_ground(frame, camera, kit.beam, place, add=True)
    for axle in shape.axles:
        lay_plate(
            frame,
            camera,
            _wheel(kit, place.rear_m, axle),
            place,
            shape.width_m - 0.02,
            (axle, shape.radius_m),
        )
    lay_plate(frame, camera, kit.far_side, place, shape.width_m - 0.24)
    driver_last = vehicle.driver_side == "near"
    for plate, inset in sorted(
        [(kit.seats, shape.width_m - 0.50 if driver_last else 0.42), (kit.driver, vehicle.eye_inset_m)],
        key=lambda pair: -pair[1],
    ):
        lay_plate(frame, camera, plate, place, inset)
    lay_plate(frame, camera, kit.under, place, 0.30)
    lay_facets(frame, camera, kit.facets, scene.light, place)
    for axle in shape.axles:
        wheel = _wheel(kit, place.rear_m, axle)
        lay_plate(frame, camera, kit.tyre, place, 0.17, (axle, shape.radius_m))
        lay_plate(frame, camera, kit.tyre, place, 0.08, (axle, shape.radius_m))
        lay_plate(frame, camera, wheel, place, 0.0, (axle, shape.radius_m))
    lay_relief(frame, camera, kit.relief, place)
    lay_plate(frame, camera, kit.mirror, place, -0.06)
    if scene.light.low:
        add_glow(frame, camera, shape, place)


def in_view(scene: Scene, n: int) -> list[Vehicle]:
    """Vehicles on the road at frame n, the far lane first."""
    there = [v for v in scene.vehicles if v.first_frame <= n <= v.last_frame]
    return sorted(there, key=lambda v: -v.side_plane_m)


def render_frame(scene: Scene, n: int) -> Image:
    """Frame n as (480, 640, 3) uint8 BGR; a pure function of (scene, n), caches aside.

    Raises:
        IndexError: if the scene has no frame n.
    """
    if not 0 <= n < scene.frames:
        raise IndexError(f"the scene has frames 0 to {scene.frames - 1}, not {n}")
    frame = _empty(scene, n).copy()
    for vehicle in in_view(scene, n):
        draw_vehicle(frame, scene, vehicle, n)
    return expose(frame, scene.light, scene.seed, n)


def _empty(scene: Scene, n: int) -> Floats:
    """The road with the board, the road alone, or the short fade between."""
    if n < scene.board_frames:
        return board_backdrop(scene)
    gone = (n - scene.board_frames + 1) / FADE_FRAMES
    if gone >= 1:
        return backdrop(scene)
    return board_backdrop(scene) * np.float32(1 - gone) + backdrop(scene) * np.float32(gone)
