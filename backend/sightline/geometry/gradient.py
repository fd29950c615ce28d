"""First derivatives of the height by everything it rests on, in closed form.

h = C_z (1 - s q) + inset q (see ray_intersection.py). The clicks enter through the undistorted directions m,
whose derivatives by pixel p and by lens parameter k follow from the implicit function K d(m; k) = p:
dm = (K d')^-1 (dp - d(K d)/dk dk). A pose increment x_cam = Exp(r) (R x + t) + t' turns directions by
w -> R^T (d - r x d) and leaves the camera's centre, which then moves by -R^T t'.
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.geometry import lens
from sightline.geometry.ray_intersection import RayIntersection
from sightline.geometry.road_pose import RoadPose


@dataclass(frozen=True, eq=False)
class Gradient:
    """Derivatives of N heights: by click (2, N), by lens and pose parameters (n + 6, N), by inset."""

    contact: Floats
    target: Floats
    parameters: Floats
    inset: Floats


def _by_click(
    pose: RoadPose, xy: tuple[Floats, Floats], by_x: Floats, by_y: Floats, out_lens: Floats
) -> tuple[Floats, Floats]:
    """Chain dh/d(direction) back to the pixel; adds dh/d(lens) to `out_lens` (n, N)."""
    camera = pose.camera
    d = lens.distort(camera.model, camera.distortion, *xy)
    inverse = 1.0 / d.determinant
    hx = (d.dy_dy * by_x - d.dx_dy * by_y) * inverse
    hy = (d.dx_dx * by_y - d.dx_dy * by_x) * inverse
    px, py = hx / camera.fx_px, hy / camera.fy_px
    out_lens[0] -= px * d.x
    out_lens[1] -= py * d.y
    out_lens[2] -= px
    out_lens[3] -= py
    if len(camera.distortion):
        kx, ky = lens.by_coefficients(camera.model, camera.distortion, *xy)
        out_lens[4:] -= hx * kx + hy * ky
    return px, py


def gradient(pose: RoadPose, intersection: RayIntersection) -> Gradient:
    """All first derivatives of the N heights in `intersection`; garbage where its `code` is not 0."""
    r, centre = pose.rotation, pose.centre_m
    c_z = float(centre[2])
    s, q, plane = intersection.s, intersection.q, intersection.plane_m
    lever = 1.0 - s * q
    a = -c_z * q / intersection.w_contact_z  # dh/ds * ds/dw
    b = plane / intersection.w_target_y
    g_contact = [a * (r[i, 1] - s * r[i, 2]) for i in range(3)]
    g_target = [b * (r[i, 2] - q * r[i, 1]) for i in range(3)]
    n = 4 + len(pose.camera.distortion)
    parameters = np.zeros((n + 6, len(s)))
    contact = _by_click(pose, intersection.contact, g_contact[0], g_contact[1], parameters[:n])
    target = _by_click(pose, intersection.target, g_target[0], g_target[1], parameters[:n])
    for g, (x, y) in ((g_contact, intersection.contact), (g_target, intersection.target)):
        parameters[n] += g[1] - g[2] * y  # g x (x, y, 1)
        parameters[n + 1] += g[2] * x - g[0]
        parameters[n + 2] += g[0] * y - g[1] * x
    for i in range(3):
        parameters[n + 3 + i] = -lever * r[i, 2]
    return Gradient(np.stack(contact), np.stack(target), parameters, q)
