"""A site before anybody goes there: the camera as it would stand, and the pose that a board would give it."""

from dataclasses import dataclass

import numpy as np

from sightline.errors import BadInput
from sightline.geometry.board import Board, road_points
from sightline.geometry.camera import Camera, project, undistort
from sightline.geometry.planar import linearise
from sightline.geometry.pose import board_on_road, joint_covariance
from sightline.geometry.road_pose import Reference, RoadPose

# the board that is planned with, its top row of corners this high above the road
PLANNING_BOARD = Board(6, 4, 0.1)
BOARD_TOP_M = 0.9
CORNER_SIGMA_PX = 0.05  # of the mean corners of a still clip


@dataclass(frozen=True)
class Site:
    """Where things are to stand. Distances are across the road, from the camera.

    `distance_m`: to the lane's wheel track; `board_distance_m`: to the board, None for the wheel track;
    `sigma_px`: of each click coordinate; `direction_rad`: how far the camera looks along the traffic instead
    of square across it; `travel_m`: of a vehicle between two frames.
    """

    camera_height_m: float
    distance_m: float
    board_distance_m: float | None = None
    sigma_px: float = 1.0
    direction_rad: float = 0.0
    travel_m: float = 2.0

    @property
    def board_m(self) -> float:
        return self.distance_m if self.board_distance_m is None else self.board_distance_m


def require_site(site: Site) -> None:
    """Raise BadInput for numbers that no site has."""
    for what, value, least, most, unit in (
        ("camera height", site.camera_height_m, 0.2, 20.0, "m"),
        ("distance to the wheel path", site.distance_m, 0.5, 100.0, "m"),
        ("distance to the board", site.board_m, 0.5, 100.0, "m"),
        ("click uncertainty", site.sigma_px, 1e-3, 100.0, "px"),
        ("direction", float(np.rad2deg(site.direction_rad)), -60.0, 60.0, "degrees"),
        ("travel between two frames", site.travel_m, 0.15, 20.0, "m"),
    ):
        if not (np.isfinite(value) and least <= value <= most):
            raise BadInput(
                "geometry-plan-range",
                what=what,
                value=format(value, "g"),
                unit=unit,
                least=format(least, "g"),
                most=format(most, "g"),
            )


def plain_camera(width_px: int, height_px: int, field_of_view_rad: float) -> Camera:
    """A camera before its calibration: no distortion, axis in the middle of the picture, no covariance.

    Parameters
    ----------
    width_px, height_px : int
        Size of the picture, 16 to 16384 px.
    field_of_view_rad : float
        Horizontal field of view, radians, 5 to 150 degrees.

    Returns
    -------
    Camera
        Square pixels, the focal length that the field of view gives.

    Raises
    ------
    BadInput
        For a size or a field of view that cannot be planned with.

    Examples
    --------
    >>> import sightline
    >>> round(sightline.plain_camera(1920, 1080, field_of_view_rad=1.0).fx_px, 1)
    1757.3
    """
    if not (16 <= width_px <= 16_384 and 16 <= height_px <= 16_384):
        raise BadInput("geometry-image-range", width_px=width_px, height_px=height_px)
    degrees = float(np.rad2deg(field_of_view_rad))
    if not (np.isfinite(degrees) and 5.0 <= degrees <= 150.0):
        raise BadInput("geometry-view-range", degrees=format(degrees, "g"))
    focal_px = 0.5 * width_px / float(np.tan(0.5 * field_of_view_rad))
    return Camera(
        name=f"plain camera, {degrees:g} degrees",
        width_px=width_px,
        height_px=height_px,
        model="brown",
        fx_px=focal_px,
        fy_px=focal_px,
        cx_px=0.5 * (width_px - 1),
        cy_px=0.5 * (height_px - 1),
        distortion=np.zeros(5),
    )


def level_pose(
    camera: Camera, height_m: float, board_m: float, aim_m: float | None = None, direction_rad: float = 0.0
) -> RoadPose:
    """A level camera, tipped to the middle of road and roof at `aim_m` across the road (the board's distance
    by default), its board in the middle of the picture `board_m` away; turned from +Y towards +X by
    `direction_rad`. Without covariance.
    """
    along, across = float(np.sin(direction_rad)), float(np.cos(direction_rad))
    aim = (board_m if aim_m is None else aim_m) / across
    low, high = np.arctan2(-height_m, aim), np.arctan2(1.6 - height_m, aim)
    pitch = -0.5 * float(low + high)
    c, s = float(np.cos(pitch)), float(np.sin(pitch))
    rotation = np.array(
        [[across, -along, 0.0], [-s * along, -s * across, -c], [c * along, c * across, -s]], dtype=np.float64
    )
    middle = 0.5 * (PLANNING_BOARD.columns - 1) * PLANNING_BOARD.square_m
    eye = np.array([middle - board_m * along / across, -board_m, height_m])
    return RoadPose(camera, rotation, -rotation @ eye)


def site_pose(camera: Camera, site: Site) -> RoadPose | None:
    """The pose of a camera that stands level at a site, with the covariance that a board there would give.

    Parameters
    ----------
    camera : Camera
        Its covariance, if it has one, goes into the pose's.
    site : Site
        Heights and distances, metres.

    Returns
    -------
    RoadPose or None
        None where the picture would not show the whole board.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> pose = sightline.site_pose(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> [round(float(metres), 2) for metres in pose.centre_m]
    [0.25, -4.0, 1.4]
    """
    bare = level_pose(camera, site.camera_height_m, site.board_m, site.distance_m, site.direction_rad)
    points = road_points(PLANNING_BOARD, "top", BOARD_TOP_M)
    seen = project(camera, bare.to_camera(points))
    if not (np.isfinite(seen).all() and camera.inside(seen).all()):
        return None
    at = linearise(camera, bare.rotation, bare.translation_m, points, seen)
    board = board_on_road(PLANNING_BOARD, Reference("top", BOARD_TOP_M), at, points)
    covariance = joint_covariance(camera, at, CORNER_SIGMA_PX)
    return RoadPose(camera, bare.rotation, bare.translation_m, covariance, board)


@dataclass(frozen=True)
class Outlook:
    """What the picture shows: angles of its edges from its axis' middle column and row, radians; None where
    the lens model has no direction there. Elevation is above the horizon, azimuth from square across the
    road towards +X.
    """

    top_rad: float | None
    bottom_rad: float | None
    left_rad: float | None
    right_rad: float | None


def outlook(pose: RoadPose) -> Outlook:
    """Where the middles of the picture's four edges look."""
    camera = pose.camera
    width, height = camera.width_px - 1, camera.height_px - 1
    edges = undistort(camera, [[width / 2, 0], [width / 2, height], [0, height / 2], [width, height / 2]])
    rays = np.column_stack([edges.points, np.ones(4)]) @ pose.rotation
    up = np.arctan2(rays[:, 2], np.hypot(rays[:, 0], rays[:, 1]))
    turn = np.arctan2(rays[:, 0], rays[:, 1])
    top, bottom, left, right = (
        float(angle) if fine else None for angle, fine in zip((*up[:2], *turn[2:]), edges.ok, strict=True)
    )
    return Outlook(top, bottom, left, right)


def middle_of_view_m(pose: RoadPose, distance_m: float) -> tuple[float, float]:
    """The point of the wheel track in the vertical plane through the camera's axis: x, y on the road."""
    forward = pose.rotation[2]
    x, y = float(pose.centre_m[0]), float(pose.centre_m[1])
    return x + distance_m * float(forward[0] / forward[1]), y + distance_m


def track_shown_m(pose: RoadPose, distance_m: float, height_m: float) -> float:
    """Length of the wheel track over which the picture shows both the road and a point above it."""
    x, y = middle_of_view_m(pose, distance_m)
    along = x + np.linspace(-4.0 * distance_m, 4.0 * distance_m, 1601)
    shown = np.ones(along.size, dtype=np.bool_)
    for up in (0.0, height_m):
        points = np.column_stack([along, np.full_like(along, y), np.full_like(along, up)])
        pixels = project(pose.camera, pose.to_camera(points))
        shown &= np.isfinite(pixels).all(axis=1) & pose.camera.inside(np.nan_to_num(pixels, nan=-1e9))
    return float(np.count_nonzero(shown) * (along[1] - along[0]))
