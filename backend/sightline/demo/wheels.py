"""The demonstration's tyre contacts: its operator clicks both tyres of some vehicles, 0.5 px beside them."""

import numpy as np

from sightline.demo.clicks import Pass, scatter_click
from sightline.demo.made import PassTruth
from sightline.enums import Point
from sightline.infra.database import Session
from sightline.quality.checks.traffic import store_pair

CLICK_NOISE_PX = 0.5
_REAR, _FRONT = "contact_rear", "contact_front"


def click_wheels(session: Session, passes: list[Pass], *, actor: int) -> int:
    """Store both tyre contacts of each vehicle that shows both on one frame; how many did."""
    rng = np.random.default_rng(20200117)
    count = 0
    for vehicle_pass in passes:
        found = both_in_sight(vehicle_pass.truth)
        if found is None:
            continue
        frame, rear, front = found
        store_pair(
            session,
            vehicle_pass.vehicle.id,
            frame=frame,
            frame_crc32=None,
            first=scatter_click(rear, rng, CLICK_NOISE_PX),
            second=scatter_click(front, rng, CLICK_NOISE_PX),
            actor=actor,
        )
        count += 1
    return count


def both_in_sight(truth: PassTruth) -> tuple[int, Point, Point] | None:
    """(frame, rear, front) where both contacts are in the picture, furthest apart; None if nowhere."""
    both = [
        (one.frame, one.pixels[_REAR], one.pixels[_FRONT])
        for one in truth.frames
        if _REAR in one.pixels and _FRONT in one.pixels
    ]
    # the wider apart in the picture, the less a pixel turns the line between them
    return max(both, key=lambda seen: abs(seen[1][0] - seen[2][0]), default=None)
