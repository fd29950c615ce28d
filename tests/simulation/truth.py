"""What is true of every pass: contact points and targets, as road points and as pixels, by frame."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sightline.demo.made import FramePixels
from tests.simulation.board import board_corners_m
from tests.simulation.camera import Array, DemoCamera
from tests.simulation.compose import Place
from tests.simulation.insides import eye_point
from tests.simulation.scene import Scene, Vehicle
from tests.simulation.shape import Shape, shape_of
from tests.simulation.sideart import tail_lamp_box
from tests.simulation.sight import eye_is_seen

MARGIN_PX = 6.0
TARGETS = ("roof", "driver_eye", "taillight")


@dataclass(frozen=True)
class Spot:
    """A definite spot, local frame, metres: l from the rear, inset behind the side plane, height."""

    name: str
    along_m: float
    inset_m: float
    height_m: float


@dataclass(frozen=True)
class PassTruth:
    """One pass; `frames` hold only frames in which at least one contact and one target are in the picture."""

    vehicle: Vehicle
    spots: tuple[Spot, ...]
    first_whole_frame: int | None
    last_whole_frame: int | None
    best_frame: int
    best_frames: dict[str, int]
    distance_m: float
    frames: tuple[FramePixels, ...]

    def spot(self, name: str) -> Spot:
        """The spot called contact_rear, contact_front, roof, driver_eye, taillight or headlight."""
        return next(s for s in self.spots if s.name == name)


@lru_cache(maxsize=64)
def spots_of(vehicle: Vehicle) -> tuple[Spot, ...]:
    """The spots that can be clicked, where the renderer draws them."""
    shape = shape_of(vehicle)
    rear, front = shape.axles
    eye_l, eye_z = eye_point(shape)
    return (
        Spot("contact_rear", rear, 0.0, 0.0),
        Spot("contact_front", front, 0.0, 0.0),
        _roof(shape),
        Spot("driver_eye", eye_l, vehicle.eye_inset_m, eye_z),
        _tail(shape),
        _head(shape),
    )


def _skin(shape: Shape, name: str, along: float, z: float) -> Spot:
    return Spot(name, along, float(shape.inset(np.array(along), np.array(z))), z)


def _roof(shape: Shape) -> Spot:
    """The highest point of the near roof edge; the roof is level across, so this edge is the silhouette."""
    top = shape.outline[:, 1].max()
    crest = shape.outline[shape.outline[:, 1] > top - 1e-9, 0]
    return _skin(shape, "roof", float(crest.mean()), float(top))


def _tail(shape: Shape) -> Spot:
    """The middle of the lamp's lower edge (lower limit of the lit area) on the near side."""
    l0, l1, z0, _ = tail_lamp_box(shape)
    return _skin(shape, "taillight", l0 + 0.45 * (l1 - l0), z0)


def _head(shape: Shape) -> Spot:
    style = shape.vehicle.style
    middle = (style.head_lamp[1] + style.head_lamp[2]) / 2 * shape.sz
    return _skin(shape, "headlight", shape.length_m - 0.08, middle)


def place_of(vehicle: Vehicle, frame: int) -> Place:
    """Where the vehicle's local frame lies at a frame."""
    return Place(vehicle.rear_m(frame), vehicle.direction, vehicle.side_plane_m)


def spot_m(vehicle: Vehicle, spot: Spot, frame: int) -> Array:
    """Road point (3,) of a spot at a frame."""
    return place_of(vehicle, frame).road(
        np.array(spot.along_m), np.array(spot.inset_m), np.array(spot.height_m)
    )


def spot_pixel(camera: DemoCamera, vehicle: Vehicle, spot: Spot, frame: int) -> Array:
    """True distorted pixel (2,) of a spot at a frame."""
    return camera.project(spot_m(vehicle, spot, frame))


def _inside(camera: DemoCamera, px: Array, margin: float = MARGIN_PX) -> Array:
    limit: Array = np.array([camera.width_px - 1, camera.height_px - 1]) - margin
    return np.asarray(((px > margin) & (px < limit)).all(-1))


def _whole(camera: DemoCamera, vehicle: Vehicle, frame: int) -> bool:
    """Whether the near side, wheels to roof and rear to front, is in the picture."""
    outline = shape_of(vehicle).outline
    foot = outline * (1, 0)
    points = np.vstack([outline, foot])
    inset = shape_of(vehicle).inset(points[:, 0], points[:, 1])
    road = place_of(vehicle, frame).road(points[:, 0], inset, points[:, 1])
    return bool(_inside(camera, camera.project(road), 1.0).all())


def _frame_pixels(camera: DemoCamera, vehicle: Vehicle, frame: int) -> FramePixels | None:
    pixels, hidden = {}, []
    for spot in spots_of(vehicle):
        px = spot_pixel(camera, vehicle, spot, frame)
        if not _inside(camera, px):
            continue
        pixels[spot.name] = (float(px[0]), float(px[1]))
        if spot.name == "driver_eye" and not eye_is_seen(
            camera, vehicle, spot_m(vehicle, spot, frame), frame
        ):
            hidden.append(spot.name)
    contact = any(name.startswith("contact") for name in pixels)
    target = any(not name.startswith("contact") for name in pixels)
    return FramePixels(frame, pixels, tuple(hidden)) if contact and target else None


def _best(camera: DemoCamera, frames: list[FramePixels], wanted: tuple[str, ...]) -> int | None:
    """Most of the wanted spots in sight with a contact, then nearest to the middle; None if none is."""

    def score(one: FramePixels) -> tuple[int, float]:
        x = [p[0] for p in one.pixels.values()]
        return sum(one.shows(name) for name in wanted), -abs(sum(x) / len(x) - camera.width_px / 2)

    best = max((f for f in frames if f.contact), key=score, default=None)
    return best.frame if best is not None and score(best)[0] else None


def pass_truth(scene: Scene, vehicle: Vehicle) -> PassTruth:
    """Everything true of one pass."""
    camera = scene.camera
    span = range(vehicle.first_frame, vehicle.last_frame + 1)
    frames = [f for n in span if (f := _frame_pixels(camera, vehicle, n)) is not None]
    whole = [n for n in span if _whole(camera, vehicle, n)]
    return PassTruth(
        vehicle=vehicle,
        spots=spots_of(vehicle),
        first_whole_frame=whole[0] if whole else None,
        last_whole_frame=whole[-1] if whole else None,
        best_frame=_best(camera, frames, (*TARGETS, "contact_rear")) or vehicle.first_frame,
        best_frames={name: n for name in TARGETS if (n := _best(camera, frames, (name,))) is not None},
        distance_m=vehicle.side_plane_m - camera.centre_m[1],
        frames=tuple(frames),
    )


@lru_cache(maxsize=4)
def truth(scene: Scene) -> tuple[PassTruth, ...]:
    """One `PassTruth` per vehicle, in order of passing."""
    return tuple(pass_truth(scene, vehicle) for vehicle in scene.vehicles)


def camera_document(camera: DemoCamera) -> dict[str, object]:
    """Intrinsics in the names of `camera.json` and the pose as cam_from_road."""
    return {
        "model": "brown",
        "width_px": camera.width_px,
        "height_px": camera.height_px,
        "fx_px": camera.fx_px,
        "fy_px": camera.fy_px,
        "cx_px": camera.cx_px,
        "cy_px": camera.cy_px,
        "distortion": list(camera.distortion),
        "cam_from_road": {
            "rotation": camera.rotation().tolist(),
            "translation_m": camera.translation_m().tolist(),
        },
        "centre_m": list(camera.centre_m),
    }


def _pass_document(one: PassTruth) -> dict[str, object]:
    v = one.vehicle
    return {
        "number": v.number,
        "make": v.model.make,
        "model": v.model.model,
        "year": v.year,
        "category": v.model.category,
        "manufacturer_height_m": v.model.height_m,
        "true_heights_m": {s.name: s.height_m for s in one.spots if not s.name.startswith("contact")},
        "insets_m": {s.name: s.inset_m for s in one.spots if not s.name.startswith("contact")},
        "wheelbase_m": v.model.wheelbase_m,
        "lane": v.lane,
        "direction": v.direction,
        "driver_side": v.driver_side,
        "distance_m": one.distance_m,
        "side_plane_m": v.side_plane_m,
        "speed_mps": v.speed_mps,
        "first_frame": v.first_frame,
        "last_frame": v.last_frame,
        "first_whole_frame": one.first_whole_frame,
        "last_whole_frame": one.last_whole_frame,
        "best_frame": one.best_frame,
        "best_frames": one.best_frames,
        "frames": [
            {"frame": f.frame, "pixels": {k: list(p) for k, p in f.pixels.items()}, "hidden": list(f.hidden)}
            for f in one.frames
        ],
    }


def truth_document(scene: Scene) -> dict[str, object]:
    """All truth of a scene as plain JSON values; distorted pixels, (0, 0) the top-left pixel's centre."""
    board = scene.board
    return {
        "scene": scene.name,
        "lighting": scene.light.name,
        "fps": scene.fps,
        "frames": scene.frames,
        "camera": camera_document(scene.camera),
        "board": {
            "columns": board.columns,
            "rows": board.rows,
            "square_m": board.square_m,
            "reference": "top",
            "reference_height_m": board.reference_height_m,
            "first_frame": 0,
            "last_frame": scene.board_frames - 1,
            "corners_px": scene.camera.project(board_corners_m(board)).reshape(-1, 2).tolist(),
        },
        "passes": [_pass_document(one) for one in truth(scene)],
    }
