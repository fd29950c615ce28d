"""A frame of a pass as the proposals look at it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.proposals.side_view import Bgr, Plane
from sightline.proposals.wheels import Box


@dataclass(frozen=True, eq=False)
class FrameSeen:
    """Frame n: `picture` (H, W, 3) BGR, `gray` (H, W), `change` (H, W) against the empty road over its
    tolerance, and the vehicle's box there (left, top, right, bottom), px.
    """

    n: int
    picture: Bgr
    gray: NDArray[np.uint8]
    change: Plane
    box: Box
