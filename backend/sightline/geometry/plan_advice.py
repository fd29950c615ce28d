"""What to do about a planned site, each with what it is worth there."""

from collections.abc import Sequence

from sightline.geometry.plan_targets import PlannedTarget
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.site import BOARD_TOP_M, Site
from sightline.messages.said import Said, with_commas

_CROSSFALL = 0.025
# A way that gains less than 5 % is no advice.
_WORTH_SAYING = 0.95
_SPEED_MPS, _RATE_HZ = 50.0 / 3.6, 25.0  # an example: town traffic, an ordinary camera


def advice(
    site: Site, pose: RoadPose | None, targets: Sequence[PlannedTarget], turned_eye: PlannedTarget | None
) -> tuple[Said, ...]:
    """What stops the work first. `turned_eye`: the eye from a camera turned along the road."""
    eye = next(t for t in targets if t.target == "driver_eye")
    out = [*_out_of_sight(site, pose, targets), *_camera_height(site, targets)]
    if abs(site.board_m - site.distance_m) > 0.2 * site.distance_m:
        distance_m, board_m = round(site.distance_m, 1), round(site.board_m, 1)
        out.append(Said("plan-board-at-wheel-path", distance_m=distance_m, board_m=board_m))
    out += [_square_to_road(site, eye), *_oblique(eye, turned_eye), *_second_frame(site, eye)]
    if site.distance_m < 1.5:
        out.append(Said("plan-lane-close"))
    return tuple(out)


def _out_of_sight(site: Site, pose: RoadPose | None, targets: Sequence[PlannedTarget]) -> list[Said]:
    if pose is None:
        return [Said("plan-board-unseen", board_m=round(site.board_m, 1), board_top_m=BOARD_TOP_M)]
    unseen = [Said("plan-target", target=t.target) for t in targets if t.result.status != "ok"]
    return [Said("plan-out-of-sight", targets=with_commas(unseen))] if unseen else []


def _camera_height(site: Site, targets: Sequence[PlannedTarget]) -> list[Said]:
    near, far = (next(t for t in targets if t.target == name) for name in ("driver_eye", "driver_eye_far"))
    if abs(site.camera_height_m - near.height_m) <= 0.15:
        return [Said("plan-camera-at-eye", height_m=round(near.height_m, 2))]
    return [
        Said(
            "plan-camera-height",
            height_m=round(near.height_m, 2),
            camera_height_m=round(site.camera_height_m, 2),
            near_m=round(abs(near.bias_if_ignored_m), 3),
            far_m=round(abs(far.bias_if_ignored_m), 3),
        )
    ]


def _square_to_road(site: Site, eye: PlannedTarget) -> Said:
    """The closed form of CONVENTIONS.md for a leaning board and a level camera, here and 1 m further on."""

    def worth_m(distance_m: float) -> float:
        h, camera = eye.height_m, site.camera_height_m
        lever = (h / camera) * (site.board_m - distance_m) + h * (camera - h) / distance_m
        return round(abs(_CROSSFALL * lever), 3)

    return Said(
        "plan-board-square",
        crossfall=100 * _CROSSFALL,
        here_m=worth_m(site.distance_m),
        further_m=worth_m(site.distance_m + 1.0),
        distance_m=round(site.distance_m, 1),
    )


def _oblique(eye: PlannedTarget, turned: PlannedTarget | None) -> list[Said]:
    if turned is None or turned.result.U95_height_m is None or eye.result.U95_height_m is None:
        return []
    turned_m, square_m = turned.result.U95_height_m, eye.result.U95_height_m
    if turned_m > _WORTH_SAYING * square_m:
        return []
    return [Said("plan-oblique", U95_turned_m=round(turned_m, 3), U95_square_m=round(square_m, 3))]


def _second_frame(site: Site, eye: PlannedTarget) -> list[Said]:
    two_m, one_m = eye.two_frames.U95_height_m, eye.result.U95_height_m
    if two_m is None or one_m is None:
        return []
    if two_m >= one_m:
        return [Said("plan-second-frame-no-gain", travel_m=site.travel_m, U95_two_m=round(two_m, 3))]
    frames = round(site.travel_m / (_SPEED_MPS / _RATE_HZ), 1)
    return [
        Said(
            "plan-second-frame",
            travel_m=site.travel_m,
            frames=frames,
            U95_one_m=round(one_m, 3),
            U95_two_m=round(two_m, 3),
        )
    ]
