"""Which frames of a pass are looked at; of each the change against the empty road and the vehicle's box."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import Background, gain_of
from sightline.proposals.seen import FrameSeen
from sightline.proposals.side_view import Bgr
from sightline.proposals.wheels import Box

FRAMES = 9
ALIKE = 0.6
BORDER_PX = 2.0
BoxOnFrame = tuple[int, float, float, float, float]


def box_on(boxes: Sequence[BoxOnFrame], n: int) -> Box:
    """The vehicle's box (left, top, right, bottom) px on frame n, between those known."""
    table = np.array(sorted(boxes), dtype=np.float64)
    left, top, right, bottom = (float(np.interp(n, table[:, 0], table[:, k])) for k in range(1, 5))
    return left, top, right, bottom


def frames_to_look_at(boxes: Sequence[BoxOnFrame], best: int, width_px: int) -> tuple[int, ...]:
    """FRAMES frames spread over those on which the vehicle is whole in the picture, and the best frame; where
    it hardly is, over those on which it is nearly as wide as it ever is.
    """
    frames = range(min(boxes)[0], max(boxes)[0] + 1)
    every = {n: box_on(boxes, n) for n in frames}
    about = [n for n, box in every.items() if box[0] > BORDER_PX and box[2] < width_px - 1 - BORDER_PX]
    if len(about) < FRAMES:
        wide = {n: min(box[2], width_px) - max(box[0], 0.0) for n, box in every.items()}
        about = [n for n in frames if wide[n] >= ALIKE * max(wide.values())]
    spread = {about[round(i)] for i in np.linspace(0, len(about) - 1, FRAMES)}
    return tuple(sorted(spread | {best}))


def frame_seen(
    n: int, picture: Bgr, gray: NDArray[np.uint8], road: Background, boxes: Sequence[BoxOnFrame]
) -> FrameSeen:
    """Frame n, `picture` (H, W, 3) BGR and `gray` (H, W), against the empty `road`.

    Own method: |gray - gain road| over the road's tolerance, as in the search for passes.
    """
    gain = gain_of(gray, road, 1.0)
    change = np.abs(gray.astype(np.float32) - road.level * np.float32(gain)) / road.tolerance
    return FrameSeen(n, picture, gray, np.asarray(change, np.float32), box_on(boxes, n))
