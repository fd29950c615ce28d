"""The demonstration's tyre contacts: its operator clicks both tyres of some vehicles, 0.5 px beside them."""

from __future__ import annotations

import numpy as np

from sightline.demo.clicks import Pass
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
    for one in passes:
        found = both_in_sight(one.truth)
        if found is None:
            continue
        frame, rear, front = found
        store_pair(
            session,
            one.vehicle.id,
            frame=frame,
            frame_crc32=None,
            first=_beside(rear, rng),
            second=_beside(front, rng),
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


def _beside(point: Point, rng: np.random.Generator) -> Point:
    x, y = rng.normal(0.0, CLICK_NOISE_PX, 2)
    return round(point[0] + float(x), 2), round(point[1] + float(y), 2)
