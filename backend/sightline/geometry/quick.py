"""One height in microseconds, for a pointer that moves: plain floats, no arrays, no uncertainty."""

from math import sqrt

from sightline.geometry.camera import undistort
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.sight import MIN_DEPRESSION, MIN_EDGE, MIN_HEIGHT_M

_ROUNDS = 12


class QuickHeights:
    """Heights of one pose; the same equations and limits as height.measure_height (a test compares them)."""

    def __init__(self, pose: RoadPose) -> None:
        camera = pose.camera
        self._pose = pose
        self._f = (camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px)
        self._k = tuple(float(v) for v in camera.distortion) + (0.0,) * (8 - len(camera.distortion))
        self._table = camera.limit.table_gain.tolist()
        self._per_step = 1.0 / camera.limit.table_step
        self._limit2 = camera.limit.radius**2
        self._y = tuple(float(v) for v in pose.rotation[:, 1])
        self._z = tuple(float(v) for v in pose.rotation[:, 2])
        self._height = float(pose.centre_m[2])
        self._size = (camera.width_px - 0.5, camera.height_px - 0.5)
        self._plain = camera.model == "brown" and not any(self._k[5:])

    def _direction(self, u: float, v: float) -> tuple[float, float] | None:
        """Undistorted normalised coordinates of a pixel, None where there are none."""
        if not (-0.5 <= u <= self._size[0] and -0.5 <= v <= self._size[1]):
            return None
        if not self._plain:
            seen = undistort(self._pose.camera, [[u, v]])
            return (float(seen.points[0, 0]), float(seen.points[0, 1])) if seen.ok[0] else None
        fx, fy, cx, cy = self._f
        k1, k2, p1, p2, k3 = self._k[:5]
        xd, yd = (u - cx) / fx, (v - cy) / fy
        table = self._table
        index = min(int(sqrt(xd * xd + yd * yd) * self._per_step), len(table) - 1)
        x, y = xd * table[index], yd * table[index]
        for _ in range(_ROUNDS):
            r2 = x * x + y * y
            gain = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3))
            slope2 = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3))
            lean = 2.0 * (p1 * y + p2 * x)
            ex = x * (gain + lean) + p2 * r2 - xd
            ey = y * (gain + lean) + p1 * r2 - yd
            a = gain + slope2 * x * x + 2.0 * p1 * y + 6.0 * p2 * x
            b = slope2 * x * y + 2.0 * (p1 * x + p2 * y)
            c = gain + slope2 * y * y + 6.0 * p1 * y + 2.0 * p2 * x
            scale = a * c - b * b
            if scale == 0.0:
                return None
            dx, dy = (c * ex - b * ey) / scale, (a * ey - b * ex) / scale
            x -= dx
            y -= dy
            if -1e-7 < dx < 1e-7 and -1e-7 < dy < 1e-7:
                return (x, y) if x * x + y * y <= self._limit2 else None
        return None

    def height_m(self, cu: float, cv: float, tu: float, tv: float, inset_m: float = 0.0) -> float | None:
        """Height of target (tu, tv) over contact (cu, cv), pixels; None where nothing can be measured."""
        contact, target = self._direction(cu, cv), self._direction(tu, tv)
        if contact is None or target is None or self._height <= 0.0:
            return None
        (x, y), (p, q) = contact, target
        ry, rz = self._y, self._z
        c_y, c_z = ry[0] * x + ry[1] * y + ry[2], rz[0] * x + rz[1] * y + rz[2]
        t_y, t_z = ry[0] * p + ry[1] * q + ry[2], rz[0] * p + rz[1] * q + rz[2]
        c_norm, t_norm = sqrt(x * x + y * y + 1.0), sqrt(p * p + q * q + 1.0)
        if c_z >= -MIN_DEPRESSION * c_norm or c_y <= MIN_EDGE * c_norm or abs(t_y) <= MIN_EDGE * t_norm:
            return None
        plane = inset_m - self._height * c_y / c_z
        if plane <= 0.0 or t_y <= 0.0:
            return None
        height = self._height + plane * t_z / t_y
        return height if height > MIN_HEIGHT_M else None
