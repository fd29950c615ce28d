"""What to do about a planned site, in sentences, each with what it is worth there."""

from collections.abc import Sequence

from sightline.geometry.plan_targets import PlannedTarget
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.site import BOARD_TOP_M, Site

_CROSSFALL = 0.025
# A way that gains less than 5 % is no advice.
_WORTH_SAYING = 0.95
_SPEED_MPS, _RATE_HZ = 50.0 / 3.6, 25.0  # an example: town traffic, an ordinary camera
TARGET_WORDS = {
    "roof": "roof",
    "driver_eye": "driver's eye",
    "driver_eye_far": "driver's eye on the far side",
    "taillight": "taillight",
    "headlight": "headlight",
}


def advice(
    site: Site, pose: RoadPose | None, targets: Sequence[PlannedTarget], turned_eye: PlannedTarget | None
) -> tuple[str, ...]:
    """Sentences, what stops the work first. `turned_eye`: the eye from a camera turned along the road."""
    eye = next(t for t in targets if t.target == "driver_eye")
    out = [*_out_of_sight(site, pose, targets), *_camera_height(site, targets)]
    if abs(site.board_m - site.distance_m) > 0.2 * site.distance_m:
        out.append(
            f"Put the board at the wheel path, {site.distance_m:.1f} m away, not at {site.board_m:.1f} m: "
            "errors of pose, tilt and focal length vanish at the board's distance and grow away from it."
        )
    out += [_square_to_road(site, eye), *_oblique(eye, turned_eye), *_second_frame(site, eye)]
    if site.distance_m < 1.5:
        out.append("The lane is very close; step back to at least 2 m.")
    return tuple(out)


def _out_of_sight(site: Site, pose: RoadPose | None, targets: Sequence[PlannedTarget]) -> list[str]:
    if pose is None:
        return [
            f"The picture would not show a board at {site.board_m:.1f} m with its top row {BOARD_TOP_M:.1f} "
            "m above the road; put it at the wheel path, step back, or use a wider lens."
        ]
    unseen = [TARGET_WORDS[t.target] for t in targets if t.result.status != "ok"]
    if not unseen:
        return []
    return [
        f"Road or target are outside the picture for: {', '.join(unseen)}; step back or use a wider lens."
    ]


def _camera_height(site: Site, targets: Sequence[PlannedTarget]) -> list[str]:
    near, far = (next(t for t in targets if t.target == name) for name in ("driver_eye", "driver_eye_far"))
    if abs(site.camera_height_m - near.height_m) <= 0.15:
        return [
            f"The camera is at about the height of a driver's eye ({near.height_m:.2f} m), where the "
            "inset has little effect; for roofs or lamps, place it at their height."
        ]
    return [
        f"Put the camera at the height to be measured, where the inset has no effect: {near.height_m:.2f} "
        f"m for a driver's eye. At {site.camera_height_m:.2f} m, ignoring the inset biases the "
        f"height by {_mm(abs(near.bias_if_ignored_m))} mm for a driver on the near side and "
        f"{_mm(abs(far.bias_if_ignored_m))} mm on the far side."
    ]


def _square_to_road(site: Site, eye: PlannedTarget) -> str:
    """The closed form of CONVENTIONS.md for a leaning board and a level camera, here and 1 m further on."""

    def worth_m(distance_m: float) -> float:
        h, camera = eye.height_m, site.camera_height_m
        lever = (h / camera) * (site.board_m - distance_m) + h * (camera - h) / distance_m
        return abs(_CROSSFALL * lever)

    here, on = worth_m(site.distance_m), worth_m(site.distance_m + 1.0)
    return (
        f"Set the board perpendicular to the road, not plumb: on a crossfall of {100 * _CROSSFALL:.1f} % a "
        f"plumb board biases heights by {_mm(here)} mm at {site.distance_m:.1f} m and by "
        f"{_mm(on)} mm at 1 m more."
    )


def _oblique(eye: PlannedTarget, turned: PlannedTarget | None) -> list[str]:
    if turned is None or turned.result.U95_height_m is None or eye.result.U95_height_m is None:
        return []
    if turned.result.U95_height_m > _WORTH_SAYING * eye.result.U95_height_m:
        return []
    return [
        "A board seen obliquely determines the camera's direction better than one seen frontally, while "
        "clicks are slightly less precise: with the camera turned 30 degrees along the road, an eye has "
        f"±{_mm(turned.result.U95_height_m)} mm instead of ±{_mm(eye.result.U95_height_m)} mm."
    ]


def _second_frame(site: Site, eye: PlannedTarget) -> list[str]:
    two, one = eye.two_frames, eye.result
    if two.U95_height_m is None or one.U95_height_m is None:
        return []
    frames = site.travel_m / (_SPEED_MPS / _RATE_HZ)
    if two.U95_height_m >= one.U95_height_m:
        return [
            f"A second frame {site.travel_m:g} m on does not reduce the uncertainty here "
            f"(±{_mm(two.U95_height_m)} mm for an eye); use frames further apart."
        ]
    return [
        f"Click eye and contact in a second frame where possible: with {site.travel_m:g} m of travel the "
        f"inset is computed instead of assumed, and ±{_mm(one.U95_height_m)} mm becomes "
        f"±{_mm(two.U95_height_m)} mm. At 50 km/h and 25 frames/s, this is {frames:.1f} frames later."
    ]


def _mm(metres: float) -> str:
    return f"{1000 * metres:.0f}"
