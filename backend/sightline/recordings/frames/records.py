"""A frame of a recording, and how long frames last."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt


@dataclass(frozen=True, slots=True)
class Frame:
    n: int
    pts: int
    time_s: float
    key: bool
    crc32: int


def lasting_s(time_s: npt.NDArray[np.float64]) -> float:
    """From the first of the frames at `time_s` (N,), s, to the end of the last, which lasts as long as most
    do: a pause is in the time between frames, not in that of the last one.
    """
    usual_s = float(np.median(np.diff(time_s))) if len(time_s) > 1 else 0.0
    return float(time_s.max() - time_s.min()) + usual_s
