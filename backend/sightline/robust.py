"""The one robust scale: what a normal distribution's standard deviation is by the median of its distances."""

import numpy as np
from numpy.typing import ArrayLike

#: The standard deviation of a normal distribution over its median distance from the middle.
SD_OVER_MEDIAN = 1.4826


def robust_scale(distances: ArrayLike) -> float:
    """The standard deviation of N errors by the median of their `distances` (N,) from their middle, of either
    sign, in their unit: 1.4826 times it (Hampel 1974). NaN of none.
    """
    values = np.abs(np.asarray(distances))
    if values.size == 0:
        return float("nan")
    # as np.median, which takes several times as long for some thousand values
    low, high = (values.size - 1) // 2, values.size // 2
    part = np.partition(values.ravel(), (low, high) if low != high else low)
    return SD_OVER_MEDIAN * float((np.float64(part[low]) + np.float64(part[high])) / 2)
