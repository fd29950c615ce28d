"""Which frames of a pass are looked at; of each the change against the empty road and the vehicle's box."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import Background, gain_of
from sightline.proposals.propose import FrameSeen
from sightline.proposals.side_view import Bgr
from sightline.proposals.wheels import Box

FRAMES = 7
BORDER_PX = 2.0
BoxOnFrame = tuple[int, float, float, float, float]


def box_on(boxes: Sequence[BoxOnFrame], n: int) -> Box:
    """The vehicle's box (left, top, right, bottom) px on frame n, between those known."""
    table = np.array(sorted(boxes), dtype=np.float64)
    left, top, right, bottom = (float(np.interp(n, table[:, 0], table[:, k])) for k in range(1, 5))
    return left, top, right, bottom


def frames_to_look_at(boxes: Sequence[BoxOnFrame], best: int, width_px: int) -> tuple[int, ...]:
    """FRAMES frames spread over those on which the vehicle is whole in the picture, and the best frame; where
    it never is, those about the best frame.
    """
    first, last = min(boxes)[0], max(boxes)[0]
    whole = [
        n
        for n in range(first, last + 1)
        if (box := box_on(boxes, n))[0] > BORDER_PX and box[2] < width_px - 1 - BORDER_PX
    ]
    about = whole if len(whole) >= FRAMES else _about(whole or [best], first, last)
    spread = {about[round(i)] for i in np.linspace(0, len(about) - 1, FRAMES)}
    return tuple(sorted(spread | {best}))


def _about(core: Sequence[int], first: int, last: int) -> list[int]:
    """The frames nearest to some."""
    near = sorted(range(first, last + 1), key=lambda n: min(abs(n - one) for one in core))
    return sorted(near[:FRAMES])


def frame_seen(
    n: int, picture: Bgr, gray: NDArray[np.uint8], road: Background, boxes: Sequence[BoxOnFrame]
) -> FrameSeen:
    """Frame n, `picture` (H, W, 3) BGR and `gray` (H, W), against the empty `road`.

    Own method: |gray - gain road| over the road's tolerance, as in the search for passes.
    """
    gain = gain_of(gray, road, 1.0)
    change = np.abs(gray.astype(np.float32) - road.level * np.float32(gain)) / road.tolerance
    return FrameSeen(n, picture, gray, np.asarray(change, np.float32), box_on(boxes, n))
