"""The empty road behind a pass, at full size."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import Background, background_of

FEWEST = 12


def road_behind(samples: Sequence[NDArray[np.uint8]]) -> Background | str:
    """What `samples` (H, W) of some seconds before and after a pass show when nothing stands before it; or
    why they are too few. Own method: detection's background, at full size.
    """
    if len(samples) < FEWEST:
        return "proposals-no-empty-road"
    return background_of(np.stack(samples))
