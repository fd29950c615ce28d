"""What the line-scan room is told and what it answers: rig, crossings, a vehicle's pictures, its motion.

Conventions. A strip is an array (lines, rows): one line a row of memory, time downwards; row 0 is the top of
the picture. Line numbers are 0-based centres and fractional; line n was taken at n / line rate. Camera 1 is
the one the vehicle reaches first. Speed and acceleration are those when the front reaches camera 1
(time 0 of a motion): b = v t + a t^2 / 2 between the same point's crossings.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from sightline.enums import MeasurementStatus, ScanMethod

Pixels = NDArray[np.uint8] | NDArray[np.uint16]


@dataclass(frozen=True)
class Rig:
    """Two line cameras a baseline apart, as measured on the road, with standard uncertainties.

    `misalignment_px`: a point's row in strip 2 minus its row in strip 1; None: estimated from the traffic.
    `divergence_rad`: angle by which the scanning planes open towards the vehicles; the baseline at a vehicle
    is `baseline_m + divergence_rad * distance_m`.
    """

    baseline_m: float
    line_rate_hz: float
    u_baseline_m: float = 0.0
    u_line_rate_ratio: float = 0.0
    divergence_rad: float = 0.0
    u_divergence_rad: float = 0.0
    distance_m: float | None = None
    misalignment_px: float | None = None
    u_misalignment_px: float = 0.0


@dataclass(frozen=True)
class Crossings:
    """Line numbers at which a vehicle's front and rear cross each camera."""

    front_line_1: float
    rear_line_1: float
    front_line_2: float
    rear_line_2: float


@dataclass(frozen=True, eq=False)
class Passage:
    """One vehicle as both cameras saw it: crossings, and its pictures with a margin around them.

    `first`, `second`: (lines, rows) pixels; row 0 of `first` is line `start_1` of strip 1, and so for 2.
    `background_1`, `background_2`: (rows,) float32, the empty road as last seen before the vehicle.
    `noise_dn`: standard deviation of a pixel of the empty road. `reason`: why it cannot be measured, or None.
    `u_boundaries_m`: what boundaries that are hardly to be seen add to the length's uncertainty.
    """

    crossings: Crossings
    first: Pixels
    second: Pixels
    start_1: int
    start_2: int
    background_1: NDArray[np.float32]
    background_2: NDArray[np.float32]
    noise_dn: float
    reason: str | None = None
    u_boundaries_m: float = 0.0


@dataclass(frozen=True)
class Entry:
    """One line of an uncertainty budget: standard uncertainties that this source brings to the results."""

    source: str
    u_speed_mps: float
    u_acceleration_mps2: float
    u_length_m: float


@dataclass(frozen=True, eq=False)
class Profile:
    """Speed along the passage: one entry a block; `used` is False for what the gate or the fit left out.

    `line_1`: (n,) line in strip 1 of the block's middle; `speed_mps`: (n,) mean speed between the cameras;
    `fitted_mps`: (n,) the fitted motion's; `used`: (n,) bool.
    """

    line_1: NDArray[np.float64]
    speed_mps: NDArray[np.float64]
    fitted_mps: NDArray[np.float64]
    used: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Motion:
    """A vehicle's motion, or the reason why there is none (then every number is None)."""

    method: ScanMethod
    crossings: Crossings
    status: MeasurementStatus
    reason: str | None = None
    speed_mps: float | None = None
    u_speed_mps: float | None = None
    acceleration_mps2: float | None = None
    u_acceleration_mps2: float | None = None
    length_m: float | None = None
    u_length_m: float | None = None
    fit_error_percent: float | None = None
    misalignment_px: float | None = None
    u_misalignment_px: float | None = None
    gain: float | None = None
    budget: tuple[Entry, ...] = ()
    profile: Profile | None = None
    warnings: tuple[str, ...] = field(default=())
    correlation: float | None = None  # of speed and acceleration, as fitted: gaps carry both on


@dataclass(frozen=True)
class Gap:
    """From the rear of the vehicle before to this front, at camera 1; None where unknown."""

    time_gap_s: float | None
    distance_gap_m: float | None
    headway_s: float | None
    paper_distance_gap_m: float | None = None
    u_time_gap_s: float | None = None
    u_distance_gap_m: float | None = None
    reason: str | None = None
