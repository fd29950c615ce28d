"""What each target of a vehicle in the planned lane would be worth, with one frame and with two."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.geometry.camera import project
from sightline.geometry.gain import second_frame_gain
from sightline.geometry.height import Height, measure_height, measure_heights, not_measurable
from sightline.geometry.insets import USUAL_INSETS
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.site import Site, middle_of_view_m, track_shown_m
from sightline.messages.said import Said

# typical heights above the road, for planning only (estimates)
TYPICAL_M = (
    ("roof", 1.50),
    ("driver_eye", 1.15),
    ("driver_eye_far", 1.15),  # the driver on the side away from the camera
    ("taillight", 0.75),
    ("headlight", 0.65),
)
NO_BOARD = Said("height-no-board-in-picture")
Insets = Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class TwoFrames:
    """The same points clicked in two frames, the inset solved for; where that cannot be had, why."""

    reason: Said | None
    u_height_m: float | None = None
    U95_height_m: float | None = None
    u_inset_m: float | None = None


@dataclass(frozen=True)
class PlannedTarget:
    """What to expect of one target. `bias_if_ignored_m`: the error when its inset is taken as 0."""

    target: str
    height_m: float
    inset_m: float
    u_inset_m: float
    result: Height
    bias_if_ignored_m: float
    two_frames: TwoFrames


def insets_of(given: Insets | None) -> dict[str, tuple[float, float]]:
    """Inset and standard uncertainty per planned target: those given by their names, else the usual ones."""
    usual = {_planned_name(name): (inset, u) for name, (inset, u, _) in USUAL_INSETS.items()}
    known = usual | {_planned_name(name): inset for name, inset in (given or {}).items()}
    return {name: known[name] for name, _ in TYPICAL_M}


def _planned_name(name: str) -> str:
    return "driver_eye" if name == "driver_eye_near" else name


def ignored_bias_m(
    camera_height_m: Floats | float, height_m: float, distance_m: float, inset_m: float
) -> Floats:
    """(C_z - h) inset / (D + inset), metres, of the same shape as `camera_height_m`, any shape: the error of
    a height whose inset is taken as 0 (CONVENTIONS.md, Height).
    """
    return np.asarray(
        (np.asarray(camera_height_m) - height_m) * inset_m / (distance_m + inset_m), dtype=np.float64
    )


def planned_target(
    pose: RoadPose | None, site: Site, name: str, height_m: float, inset: tuple[float, float]
) -> PlannedTarget:
    """One target in the middle of the picture's wheel track; `pose` None: no board, so no number."""
    bias = float(ignored_bias_m(site.camera_height_m, height_m, site.distance_m, inset[0]))
    if pose is None:
        result, two_frames = not_measurable(NO_BOARD, *inset), TwoFrames(NO_BOARD)
    else:
        clicks = _clicks(pose, site.distance_m, height_m, inset[0])
        result = measure_height(pose, clicks[0], clicks[1], site.sigma_px, *inset)
        two_frames = _two_frames(pose, site, height_m, inset)
    return PlannedTarget(
        target=name,
        height_m=height_m,
        inset_m=inset[0],
        u_inset_m=inset[1],
        result=result,
        bias_if_ignored_m=bias,
        two_frames=two_frames,
    )


def _clicks(
    pose: RoadPose, distance_m: float, height_m: float, inset_m: float, along_m: float = 0.0
) -> Floats:
    """Pixels (2, 2) of contact and target, `along_m` from the middle of the view."""
    x, y = middle_of_view_m(pose, distance_m)
    points = np.array([[x + along_m, y, 0.0], [x + along_m, y + inset_m, height_m]])
    return project(pose.camera, pose.to_camera(points))


def _two_frames(pose: RoadPose, site: Site, height_m: float, inset: tuple[float, float]) -> TwoFrames:
    """Half the travel before the middle of the view, and half behind it."""
    clicks = _clicks(pose, site.distance_m, height_m, inset[0], -0.5 * site.travel_m)
    gain = second_frame_gain(pose, clicks[0], clicks[1], site.travel_m, site.sigma_px, *inset)
    if gain is None:
        shown = track_shown_m(pose, site.distance_m, height_m)
        return TwoFrames(
            Said("height-picture-too-narrow", shown_m=round(shown, 1), travel_m=float(f"{site.travel_m:g}"))
        )
    return TwoFrames(None, gain.u_double_m, COVERAGE_95 * gain.u_double_m, gain.u_inset_m)


def U95_over_distance(
    pose: RoadPose | None, site: Site, distances_m: Floats, height_m: float, inset: tuple[float, float]
) -> list[float | None]:
    """U95, metres, of a target on vehicles that pass at other distances, `distances_m` (N,), the camera and
    its pose as planned; None where the picture does not show them. Clicks are foreseen, and measured as
    `measure_height` does.
    """
    if pose is None:
        return [None] * len(distances_m)
    clicks = np.stack([_clicks(pose, float(d), height_m, inset[0]) for d in distances_m])
    found = measure_heights(pose, clicks[:, 0], clicks[:, 1], site.sigma_px, *inset)
    return [COVERAGE_95 * float(u) if ok else None for u, ok in zip(found.u_height_m, found.ok, strict=True)]
