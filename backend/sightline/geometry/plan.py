"""Before going out: what a height will be worth from a given place, and what to do about it."""

from dataclasses import dataclass, replace

import numpy as np

from sightline.geometry.camera import Camera
from sightline.geometry.plan_advice import advice
from sightline.geometry.plan_passing import Passing, passings
from sightline.geometry.plan_targets import (
    TYPICAL_M,
    Insets,
    PlannedTarget,
    U95_over_distance,
    ignored_bias_m,
    insets_of,
    planned_target,
)
from sightline.geometry.site import Outlook, Site, level_pose, outlook, require_site, site_pose, track_shown_m
from sightline.messages.said import Said

_DISTANCES_M = np.linspace(2.0, 8.0, 49)
_CAMERA_HEIGHTS_M = np.linspace(0.6, 2.4, 37)
OBLIQUE_RAD = float(np.deg2rad(30.0))


@dataclass(frozen=True)
class Curve:
    """One line of a figure: a target, the points' places, and the values there (None: there is none)."""

    target: str
    at_m: tuple[float, ...]
    value_m: tuple[float | None, ...]


@dataclass(frozen=True)
class Plan:
    """Expected uncertainties of a set-up, with advice.

    `U95_over_distance`: vehicles at other distances, camera and board as planned. `bias_over_height`: error
    of a driver's eye whose inset is ignored, by the camera's height. `track_shown_m`: length of the wheel
    track over which road and a driver's eye are in the picture. `passing`: exposure and frames by speed.
    """

    site: Site
    targets: tuple[PlannedTarget, ...]
    advice: tuple[Said, ...]
    U95_over_distance: tuple[Curve, ...]
    bias_over_height: tuple[Curve, ...]
    outlook: Outlook
    tilt_rad: float
    track_shown_m: float
    passing: tuple[Passing, ...]


def plan_site(camera: Camera, site: Site, insets: Insets | None = None) -> Plan:
    """Expected uncertainty per target of a camera at a site.

    The camera is taken to be level, tipped so that road and roof are in view, and its pose to be solved from
    a board of 6x4 corners of 10 cm parallel to the traffic. The lens's and the pose's share comes from their
    covariances; a camera without one counts as exactly known (the flags say so).

    Parameters
    ----------
    camera : Camera
    site : Site
        Heights and distances, metres.
    insets : mapping of str to (float, float), optional
        Inset and its standard uncertainty per target, metres; the defaults where a target is not given.

    Returns
    -------
    Plan
        `targets`, each with the height's budget from one frame and from two.

    Raises
    ------
    BadInput
        For numbers that no site has.

    Examples
    --------
    >>> import sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> plan = sightline.plan_site(camera, sightline.Site(camera_height_m=1.4, distance_m=4.0))
    >>> plan.targets[0].target, round(plan.targets[0].result.U95_height_m, 3)
    ('roof', 0.01)
    """
    require_site(site)
    pose = site_pose(camera, site)
    known = insets_of(insets)
    targets = tuple(planned_target(pose, site, name, h, known[name]) for name, h in TYPICAL_M)
    bare = level_pose(camera, site.camera_height_m, site.board_m, site.distance_m, site.direction_rad)
    eye = dict(TYPICAL_M)["driver_eye"]
    over_distance = (
        Curve(
            name,
            tuple(_DISTANCES_M.tolist()),
            tuple(U95_over_distance(pose, site, _DISTANCES_M, height, known[name])),
        )
        for name, height in TYPICAL_M
    )
    over_height = (
        Curve(
            name,
            tuple(_CAMERA_HEIGHTS_M.tolist()),
            tuple(ignored_bias_m(_CAMERA_HEIGHTS_M, eye, site.distance_m, known[name][0]).tolist()),
        )
        for name in ("driver_eye", "driver_eye_far")
    )
    shown_m = track_shown_m(bare, site.distance_m, eye)
    return Plan(
        site=site,
        targets=targets,
        advice=advice(site, pose, targets, _turned_eye(camera, site, known["driver_eye"])),
        U95_over_distance=tuple(over_distance),
        bias_over_height=tuple(over_height),
        outlook=outlook(bare),
        tilt_rad=float(np.arcsin(-bare.rotation[2, 2])),
        track_shown_m=shown_m,
        passing=passings(bare, site, eye, shown_m),
    )


def _turned_eye(camera: Camera, site: Site, inset: tuple[float, float]) -> PlannedTarget | None:
    """The driver's eye from a camera that looks obliquely along the road; None if it does already."""
    if abs(site.direction_rad) > 0.5 * OBLIQUE_RAD:
        return None
    turned = replace(site, direction_rad=OBLIQUE_RAD)
    return planned_target(
        site_pose(camera, turned), turned, "driver_eye", dict(TYPICAL_M)["driver_eye"], inset
    )
