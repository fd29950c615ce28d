"""What was seen of the traffic: points followed through passes, and what is known of the vehicles."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.arrays import freeze_array
from sightline.messages.said import Said

POINTS = ("rear_tyre", "front_tyre", "roof")
REAR, FRONT, ROOF = range(3)
LENGTHS = ("wheelbase", "roof", "roof_inset")
_LEAST_SIGMA_PX = 0.001  # nobody tells a place finer, and the squares of much finer weights overflow
DEFAULT_U_COMMON_M = 0.005  # all catalogue lengths, or all contacts against their axles, off alike (estimate)


@dataclass(frozen=True)
class Known:
    """A length known from elsewhere, and its standard uncertainty, metres."""

    value_m: float
    u_m: float


@dataclass(frozen=True, eq=False)
class ObservedPass:
    """One vehicle on its way: N points seen on numbered frames.

    `frame`, `point` (N,): the frame's number and an index into POINTS; `points_px` (N, 2); `sigma_px` (N,):
    standard uncertainty of each coordinate. The lengths are None where they are unknown.
    """

    name: str
    frame: NDArray[np.int64]
    point: NDArray[np.int64]
    points_px: Floats
    sigma_px: Floats
    wheelbase: Known | None = None
    roof: Known | None = None
    roof_inset: Known | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "points_px", freeze_array(self.points_px).reshape(-1, 2))
        object.__setattr__(self, "sigma_px", freeze_array(self.sigma_px))

    @property
    def lengths(self) -> tuple[Known | None, ...]:
        """In the order of LENGTHS."""
        return self.wheelbase, self.roof, self.roof_inset


def shared_insets(passes: Sequence[ObservedPass]) -> tuple[Known, ...]:
    """Roof insets that more than one pass states, in the order of their values: whoever states the same one
    with the same u assumes it, and shares what it is off by on average. Own reading.
    """
    stated = Counter(one.roof_inset for one in passes if one.roof_inset is not None)
    return tuple(
        sorted((one for one, times in stated.items() if times > 1), key=lambda one: (one.value_m, one.u_m))
    )


def unusable_pass_reason(observed: ObservedPass) -> Said | None:
    """Why a pass can say nothing of the pose, or None. Without a known length that was seen, what is left
    is only how alike the frames are, which errors of following a point imitate.
    """
    if not (np.isfinite(observed.points_px).all() and np.isfinite(observed.sigma_px).all()):
        return Said("adjustment-point-not-finite")
    if (observed.sigma_px < _LEAST_SIGMA_PX).any():
        return Said("adjustment-point-no-u")
    for name, known in zip(LENGTHS, observed.lengths, strict=True):
        problem = None if known is None else _unusable_length(name, known)
        if problem is not None:
            return problem
    frame_points = set(zip(observed.frame.tolist(), observed.point.tolist(), strict=True))
    if len(frame_points) < len(observed.frame):
        return Said("adjustment-point-twice")
    if not any(point in (REAR, FRONT) for _, point in frame_points):
        return Said("adjustment-no-tyre")
    return None if _shows_a_known_length(observed, frame_points) else Said("adjustment-no-known-length")


def _unusable_length(name: str, known: Known) -> Said | None:
    if not (np.isfinite(known.value_m) and np.isfinite(known.u_m) and known.u_m >= 0):
        return Said("adjustment-length-not-finite", length=name)
    if known.value_m <= 0 and name != "roof_inset":
        return Said("adjustment-length-not-positive", length=name)
    return None


def _shows_a_known_length(observed: ObservedPass, seen: set[tuple[int, int]]) -> bool:
    frames = {frame for frame, _ in seen}
    both = any({(frame, REAR), (frame, FRONT)} <= seen for frame in frames)
    roof = any((frame, ROOF) in seen and ({(frame, REAR), (frame, FRONT)} & seen) for frame in frames)
    return (observed.wheelbase is not None and both) or (observed.roof is not None and roof)
