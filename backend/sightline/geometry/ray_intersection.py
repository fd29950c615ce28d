"""Rays of clicks in the road frame and the height they enclose: the corrected equations, vectorised.

With C the camera's centre and w = R^T (x, y, 1) the direction of a click in the road frame, the contact ray
meets the road (Z = 0) and the target ray meets the side plane (Y = contact's Y + inset). Both plane
intersections reduce to two slopes, s = w_y / w_z of the contact ray and q = w_z / w_y of the target ray:

    D = -C_z s            distance from the camera's centre to the side plane, along Y
    E = D + inset         distance to the plane in which the target lies
    h = C_z + E q         height of the target above the road

which is Dupuis et al. 2019, eqs. (8) to (18), corrected. Where the paper is misprinted:
  (5)-(7)   directions rotate, they do not translate: n = R e, not [R t][e 1]
  (8)       the ground point is t + h n only if n points down; here the road frame is built from the canonical
            corner order (board.py), so that it always does
  (10)      the plane is [-n^T d]
  (13)      the side plane's normal is the horizontal across the traffic (C_x is undefined)
  (14)-(15) d = -n^T p_l (with +n^T p_l the plane is mirrored about the camera: metres of error)
  (17)      scale (n_z^T p_l) / (n_z^T p'_h), with the metric contact point p_l and the side plane's normal
  (18)      the height is the signed distance to the road plane, a number, already positive above it
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.geometry.camera import undistort_xy
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

OK = 0
REASONS = (
    Said("height-no-clicks"),  # in the place of OK: never said
    Said("height-click-not-finite"),
    Said("height-contact-outside-picture"),
    Said("height-target-outside-picture"),
    Said("height-contact-outside-lens"),
    Said("height-target-outside-lens"),
    Said("height-camera-below-road"),
    Said("height-contact-above-horizon"),
    Said("height-contact-behind-camera"),
    Said("height-plane-edge-on"),
    Said("height-target-no-crossing"),
    Said("height-target-below-road"),
    Said("height-u-not-valid"),
)
(
    _,
    NOT_FINITE,
    CONTACT_OUTSIDE,
    TARGET_OUTSIDE,
    CONTACT_RADIUS,
    TARGET_RADIUS,
    CAMERA_BELOW,
    HORIZON,
    BEHIND,
    EDGE_ON,
    NO_CROSSING,
    BELOW_ROAD,
    BAD_SIGMA,
) = range(len(REASONS))

MIN_DEPRESSION = np.sin(np.deg2rad(0.2))  # closer to the horizon, a pixel is worth tens of metres
MIN_HEIGHT_M = 1e-6  # one and the same click for both points is 0 up to rounding
MIN_EDGE = np.sin(np.deg2rad(1.0))  # closer to edge-on, a pixel is worth metres


@dataclass(frozen=True, eq=False)
class RayIntersection:
    """All that height and gradient need of N click pairs. Arrays (N,); `code` 0 where a height exists."""

    code: np.ndarray[tuple[int, ...], np.dtype[np.int8]]
    contact: tuple[Floats, Floats]  # undistorted, normalised
    target: tuple[Floats, Floats]
    s: Floats
    q: Floats
    w_contact_z: Floats
    w_target_y: Floats
    plane_m: Floats  # E
    height_m: Floats


def _component(rotation: Floats, axis: int, x: Floats, y: Floats) -> Floats:
    """Road-frame component `axis` of the directions (x, y, 1)."""
    r = rotation[:, axis]
    return float(r[0]) * x + float(r[1]) * y + float(r[2])


def intersect_rays(
    pose: RoadPose, contacts_px: Floats, targets_px: Floats, inset_m: Floats | float
) -> RayIntersection:
    """Solve N click pairs; contacts_px, targets_px (N, 2), inset_m a number or (N,), metres. A pair without a
    height has a code other than OK.

    D = -C_z s, h = C_z + (D + inset) q: Dupuis et al. 2019, eqs. (8) to (18), corrected; the module lists the
    misprints.
    """
    camera, rotation = pose.camera, pose.rotation
    cx, cy, c_ok = undistort_xy(camera, contacts_px[:, 0], contacts_px[:, 1])
    tx, ty, t_ok = undistort_xy(camera, targets_px[:, 0], targets_px[:, 1])
    height_z = float(pose.centre_m[2])
    with np.errstate(all="ignore"):
        c_y, c_z = _component(rotation, 1, cx, cy), _component(rotation, 2, cx, cy)
        t_y, t_z = _component(rotation, 1, tx, ty), _component(rotation, 2, tx, ty)
        s, q = c_y / c_z, t_z / t_y
        plane = inset_m - height_z * s
        height = height_z + plane * q
        c_norm, t_norm = np.sqrt(cx * cx + cy * cy + 1.0), np.sqrt(tx * tx + ty * ty + 1.0)
        # the last rule that applies is overwritten by the ones after it: worst last
        code = np.zeros(len(cx), dtype=np.int8)
        code[~(height > MIN_HEIGHT_M)] = BELOW_ROAD
        code[~(plane * t_y > 0.0)] = NO_CROSSING
        code[~((np.abs(t_y) > MIN_EDGE * t_norm) & (np.abs(c_y) > MIN_EDGE * c_norm))] = EDGE_ON
        code[~((c_y > -MIN_EDGE * c_norm) & (plane > 0.0))] = BEHIND
        code[~(c_z < -MIN_DEPRESSION * c_norm)] = HORIZON
    if not height_z > 0.0:
        code[:] = CAMERA_BELOW
    code[~t_ok] = TARGET_RADIUS
    code[~c_ok] = CONTACT_RADIUS
    code[~camera.inside(targets_px)] = TARGET_OUTSIDE
    code[~camera.inside(contacts_px)] = CONTACT_OUTSIDE
    # a sum is finite only where every part of it is
    total = contacts_px[:, 0] + contacts_px[:, 1] + targets_px[:, 0] + targets_px[:, 1]
    code[~np.isfinite(total)] = NOT_FINITE
    return RayIntersection(
        code=code,
        contact=(cx, cy),
        target=(tx, ty),
        s=s,
        q=q,
        w_contact_z=c_z,
        w_target_y=t_y,
        plane_m=plane,
        height_m=height,
    )


def contact_on_road(pose: RoadPose, intersection: RayIntersection) -> tuple[Floats, Floats, Floats]:
    """X and Y of the contact points on the road and their distance from the camera's centre, (N,) each,
    metres.

    The contact ray meets the road plane where C_z + lambda w_z = 0: p_l of Dupuis et al. 2019, section 2,
    between (12) and (13), where it has no number.
    """
    x, y = intersection.contact
    with np.errstate(all="ignore"):
        scale = -float(pose.centre_m[2]) / intersection.w_contact_z
        across = intersection.s * intersection.w_contact_z
        along = _component(pose.rotation, 0, x, y)
        distance = scale * np.sqrt(x * x + y * y + 1.0)
    return pose.centre_m[0] + scale * along, pose.centre_m[1] + scale * across, distance
