"""What the line-scan room is told and what it answers: rig, crossings, a vehicle's pictures, its motion.

Conventions. A strip is an array (lines, rows): one line a row of memory, time downwards; row 0 is the top of
the picture. Line numbers are 0-based centres and fractional; line n was taken at n / line rate. Speed and
acceleration are those when the front reaches camera 1 (time 0 of a motion), whichever camera it reached
first: b = v t + a t^2 / 2 between the same point's crossings. A method is given the camera that a vehicle
reached first as camera 1 (`either_way`).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.enums import LaneBy, MeasurementStatus, ScanDirection, ScanMethod
from sightline.messages.said import Said

Pixels = NDArray[np.uint8] | NDArray[np.uint16]


USUAL_SHADOW_SHARE = 0.15


@dataclass(frozen=True)
class Lane:
    """A lane that a rig sees, and by what its vehicles are known.

    `distance_m`: from the cameras to its vehicles' side; `u_distance_m`: of one vehicle's, its place in the
    lane included. `direction`: of its traffic, None: either. `tyres_from_px`, `tyres_to_px`: rows of strip 1
    (from the top) between which its tyres meet the road, None: any. `shadow_share`: the rig's for this lane,
    whose road and shadows lie higher in the picture the farther it is; None: the rig's own.
    """

    name: str
    distance_m: float
    u_distance_m: float = 0.0
    direction: ScanDirection | None = None
    tyres_from_px: float | None = None
    tyres_to_px: float | None = None
    shadow_share: float | None = None


@dataclass(frozen=True)
class Rig:
    """Two line cameras a baseline apart, as measured on the road, with standard uncertainties.

    `misalignment_px`: a point's row in strip 2 minus its row in strip 1; None: estimated from the traffic.
    `divergence_rad`: angle by which the scanning planes open towards the vehicles; the baseline at a vehicle
    is `baseline_m + divergence_rad * distance_m`; `baseline_correlation` of the errors of both, as a
    calibration tells it. `u_distance_m`: of a vehicle's distance, its place in the lane included.
    `shadow_share`: the lowest share of the rows, in which the road and the vehicle's shadow on it are seen
    and no vehicle is looked for (Douxchamps et al., section IV). `lanes`: where vehicles drive at several
    distances; `distance_m`, `u_distance_m` and `shadow_share` are then those of a lane (`rig.at_lane`).
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
    shadow_share: float = USUAL_SHADOW_SHARE
    baseline_correlation: float = 0.0
    u_distance_m: float = 0.0
    lanes: tuple[Lane, ...] = ()


@dataclass(frozen=True)
class Crossings:
    """Line numbers at which a vehicle's front and rear cross each camera."""

    front_line_1: float
    rear_line_1: float
    front_line_2: float
    rear_line_2: float

    @property
    def direction(self) -> ScanDirection:
        """Which camera it reached first, by the mean of front and rear."""
        later = self.front_line_2 + self.rear_line_2 - self.front_line_1 - self.rear_line_1
        return "camera_1_first" if later >= 0 else "camera_2_first"


@dataclass(frozen=True, eq=False)
class Passage:
    """One vehicle as both cameras saw it: crossings, and its pictures with a margin around them.

    `first`, `second`: (lines, rows) pixels; row 0 of `first` is line `start_1` of strip 1, and so for 2.
    `background_1`, `background_2`: (rows,) float32, the empty road as last seen before the vehicle.
    `noise_dn`: standard deviation of a pixel of the empty road. `reason`: why it cannot be measured, or None.
    `u_ends_m`: what noise and doubt about front and rear bring to the length's uncertainty; 0 for a person's.
    `beside`: it passes one that stands before camera 1 and is told later. `leaving`: it was seen while what
    had stood there left, and may be a part of that: only one with a motion is told.
    """

    crossings: Crossings
    first: Pixels
    second: Pixels
    start_1: int
    start_2: int
    background_1: NDArray[np.float32]
    background_2: NDArray[np.float32]
    noise_dn: float
    reason: Said | None = None
    u_ends_m: tuple[float, float] = (0.0, 0.0)
    beside: bool = False
    leaving: bool = False


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


#: For what stands for longer nobody waits: it may be no vehicle, but a road that changed for good.
STANDS_S = 60.0
#: What is in view of a recording that begins so shortly after another ended is what stood then.
GOES_ON_S = 0.1
#: Why there is no motion of a vehicle that stood in view.
STOPPED = Said("scan-motion-stopped")
#: Of one that was in view for longer, and that nobody saw leave.
STOOD = Said("scan-motion-stood")
TOO_LONG = Said("scan-motion-too-long-in-view")
#: Of one that is in view where the recording begins or ends.
CUT = Said("scan-motion-cut")


def front_seen(reason: Said | str | None, front_line_1: float) -> bool:
    """Whether a vehicle's front was seen, by the reason why it has no motion: of one that was in view when
    the recording began it was not.
    """
    return reason is None or front_line_1 > 0


def rear_seen(reason: Said | None) -> bool:
    """Whether a vehicle's rear was seen, by the reason why it has no motion. Where it was not, its rear's
    lines are those at which it was given up: nothing is computed from them.
    """
    return reason not in (STOOD, TOO_LONG)


def may_still_stand(reason: Said | None) -> bool:
    """Whether nobody knows until when a vehicle stood, by why it has no motion (a text too)."""
    return reason is not None and str(reason) == str(STOOD)


#: One that stood until so shortly before the end of a recording still stood then.
AT_END_S = 0.2


def stands_at_end(reason: Said | None, rear_s: float | None, end_s: float) -> bool:
    """Whether a vehicle still stood when its recording ended; `rear_s`: until when it was seen."""
    stopped = reason is not None and str(reason) == str(STOPPED)
    return may_still_stand(reason) or (stopped and rear_s is not None and rear_s > end_s - AT_END_S)


@dataclass(frozen=True, eq=False)
class Motion:
    """A vehicle's motion, or the reason why there is none (then every number is None)."""

    method: ScanMethod
    crossings: Crossings
    status: MeasurementStatus
    reason: Said | None = None
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
    warnings: tuple[Said, ...] = ()
    correlation: float | None = None  # of speed and acceleration, as fitted: gaps carry both on
    axle_lines: tuple[float, ...] | None = None  # of strip 1, at each wheel's hub; None: not looked for
    lane: str | None = None  # of the rig's lanes; None: not known, or the rig has none
    lane_by: LaneBy | None = None
    u_boundaries_m: float = 0.0  # of both ends of the passage
    tyres_px: float | None = None  # row of strip 1 where tyres meet the road; None: not looked for


@dataclass(frozen=True)
class Gap:
    """From the rear of the vehicle before it of its direction and lane (of those beside each other the one
    that left last) to this front, at camera 1; None where unknown. The distance is by the leader's own fitted
    motion, the paper's is time gap times the mean speed; the headway runs from front to front.
    """

    time_gap_s: float | None
    distance_gap_m: float | None
    headway_s: float | None
    paper_distance_gap_m: float | None = None
    u_time_gap_s: float | None = None
    u_distance_gap_m: float | None = None
    reason: Said | None = None
