"""What hides a target: the driver's eye is seen through glass only, and past the empty seats."""

from functools import lru_cache

import numpy as np

from tests.simulation.camera import Array, DemoCamera, Floats
from tests.simulation.insides import seats_area
from tests.simulation.paint import Stencil, pane_area
from tests.simulation.scene import Vehicle
from tests.simulation.shape import Shape, shape_of

PPM = 60.0


@lru_cache(maxsize=64)
def _masks(vehicle: Vehicle) -> tuple[Stencil, Floats, Floats]:
    shape = shape_of(vehicle)
    stencil = Stencil(0.0, shape.length_m, 0.0, vehicle.roof_height_m, PPM)
    return stencil, pane_area(shape, stencil), seats_area(shape, stencil)


def _look(stencil: Stencil, mask: Floats, along: float, z: float) -> float:
    """Least coverage in 4 cm around a spot of the local plane."""
    i, j = round((along - stencil.left_m) * PPM - 0.5), round((stencil.top_m - z) * PPM - 0.5)
    h, w = mask.shape
    if not (2 <= i < w - 2 and 2 <= j < h - 2):
        return 0.0
    return float(mask[j - 2 : j + 3, i - 2 : i + 3].min())


def _crossing(
    camera: DemoCamera, shape: Shape, eye: Array, rear_m: float, inset_m: float
) -> tuple[float, float]:
    """Local (l, z) where the sight line to a road point passes the plane at an inset."""
    centre, vehicle = np.array(camera.centre_m), shape.vehicle
    t = (vehicle.side_plane_m + inset_m - centre[1]) / (eye[1] - centre[1])
    at = centre + t * (eye - centre)
    return vehicle.direction * (float(at[0]) - rear_m), float(at[2])


def eye_is_seen(camera: DemoCamera, vehicle: Vehicle, eye: Array, frame: int) -> bool:
    """Whether the sight line to the driver's eye (road point) passes a side window and the seats."""
    shape, rear = shape_of(vehicle), vehicle.rear_m(frame)
    stencil, panes, seats = _masks(vehicle)
    inset = 0.1
    for _ in range(6):
        along, z = _crossing(camera, shape, eye, rear, inset)
        inset = float(shape.inset(np.array(along), np.array(z)))
    if _look(stencil, panes, along, z) < 0.99:
        return False
    if vehicle.driver_side == "near":
        return True
    along, z = _crossing(camera, shape, eye, rear, 0.42)
    return _look(stencil, 1 - seats, along, z) > 0.99
