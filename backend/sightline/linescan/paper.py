"""The paper's chain: block matching, speed profile, linear regression; Douxchamps, Macq, Chihara, section IV.

Kept as a method of its own to compare with, as it was published but for its corrections: the mean speed
over the baseline holds at the mean of a point's two crossing times, and the length is that of the fitted
motion (acceleration compensated) between front and rear at camera 1. A vertical misalignment is searched for
by whole rows only and is not cured by that; the default method solves for it.
"""

from dataclasses import replace
from math import hypot

import numpy as np

from sightline.arrays import Floats
from sightline.linescan.budget import correlation_of
from sightline.linescan.direct import NO_ORDER
from sightline.linescan.equations import solve_crossings, travelled_m
from sightline.linescan.matching import BLOCK_LINES, STEP_LINES, Matches, match_blocks
from sightline.linescan.parts import Crossings, Entry, Motion, Passage, Profile, Rig
from sightline.linescan.rig import baseline_of
from sightline.linescan.spread import widening
from sightline.messages.said import Said

# Blocks overlap, so of six neighbours one counts; two of those are spent on speed and acceleration.
OVERLAP = BLOCK_LINES / STEP_LINES
LEAST_FREEDOM = 2.0
# The search covers this share of the delay beyond what the four crossings say, and no less than these lines.
MARGIN_SHARE, MARGIN_LINES = 0.05, 8
U_CROSSING_LINES = 2.0
# The gate looks at changes over this length of the vehicle: over one line of a slow one, noise hides them.
GATE_M = 0.006

TOO_FEW_BLOCKS = Said("scan-motion-few-blocks", lines=BLOCK_LINES)


def measure_paper(passage: Passage, rig: Rig) -> Motion:
    """Motion of a vehicle by the paper's method; never raises for pictures: a reason instead.

    Standard uncertainties: of the regression (blocks overlap, so only every sixth counts as independent; few
    of them widen u as Student's t is wider), baseline, clock; for the length the crossings besides.
    """
    if passage.reason:
        return _not_measurable(passage.crossings, passage.reason)
    baseline_m, _ = baseline_of(rig)
    try:
        solve_crossings(passage.crossings, baseline_m, rig.line_rate_hz)
    except ValueError:
        return _not_measurable(passage.crossings, NO_ORDER)
    matches = _match(passage, baseline_m)
    seconds, speeds = _speeds(matches, passage, baseline_m, rig.line_rate_hz)
    used = matches.used
    if np.count_nonzero(used) / OVERLAP - 2 < LEAST_FREEDOM:
        return _not_measurable(passage.crossings, TOO_FEW_BLOCKS)
    return _regression(passage, rig, baseline_m, matches, seconds, speeds)


def _match(passage: Passage, baseline_m: float) -> Matches:
    crossings = passage.crossings
    front, rear = (
        crossings.front_line_2 - crossings.front_line_1,
        crossings.rear_line_2 - crossings.rear_line_1,
    )
    margin = max(MARGIN_SHARE * max(front, rear), MARGIN_LINES)
    apart = passage.start_2 - passage.start_1
    low = int(np.floor(min(front, rear) - margin)) - apart
    high = int(np.ceil(max(front, rear) + margin)) - apart
    at = max(0, int(np.ceil(crossings.front_line_1)) - passage.start_1)
    until = min(len(passage.first), int(crossings.rear_line_1) + 1 - passage.start_1)
    low += at
    high += at
    second = passage.second
    if low < 0:  # the margin reaches before the second picture: search less far
        low = 0
    shifts = range(low, max(high + 1, low))
    lag = int(np.clip(round(GATE_M / baseline_m * (front + rear) / 2), 1, BLOCK_LINES // 4))
    found = match_blocks(passage.first[at:until], second, shifts, passage.noise_dn, lag=lag)
    return replace(found, middle=found.middle + at + passage.start_1, shift=found.shift - at + apart)


def _speeds(
    matches: Matches, passage: Passage, baseline_m: float, line_rate_hz: float
) -> tuple[Floats, Floats]:
    """Time after the front's crossing of camera 1 at which each block's mean speed holds, and that speed."""
    with np.errstate(divide="ignore"):
        speeds = baseline_m * line_rate_hz / matches.shift
    middle = matches.middle + matches.shift / 2 - passage.crossings.front_line_1
    return middle / line_rate_hz, speeds


def _regression(
    passage: Passage, rig: Rig, baseline_m: float, matches: Matches, seconds: Floats, speeds: Floats
) -> Motion:
    """The paper's plain linear regression of the speed over the time, and what follows from it."""
    used = matches.used
    design = np.column_stack([np.ones(np.count_nonzero(used)), seconds[used]])
    normal = np.linalg.inv(design.T @ design)
    speed, acceleration = normal @ design.T @ speeds[used]
    residuals = speeds[used] - design @ (speed, acceleration)
    # of n blocks n / OVERLAP are independent observations, and as many less two say how they scatter
    freedom = len(residuals) / OVERLAP - 2
    variance = float(residuals @ residuals) / (OVERLAP * freedom)
    covariance = variance * normal * OVERLAP * widening(freedom) ** 2
    crossings = passage.crossings
    rear_s = (crossings.rear_line_1 - crossings.front_line_1) / rig.line_rate_hz
    length = float(travelled_m(speed, acceleration, rear_s))
    budget = _budget(rig, baseline_m, (float(speed), float(acceleration), length), covariance, rear_s)
    u_speed, u_acceleration, u_length = (
        hypot(*(getattr(one, name) for one in budget))
        for name in ("u_speed_mps", "u_acceleration_mps2", "u_length_m")
    )
    return Motion(
        method="paper",
        crossings=crossings,
        status="ok",
        speed_mps=float(speed),
        u_speed_mps=u_speed,
        acceleration_mps2=float(acceleration),
        u_acceleration_mps2=u_acceleration,
        length_m=length,
        u_length_m=u_length,
        fit_error_percent=100 * float(np.std(residuals)) / float(np.mean(speeds[used])),
        budget=budget,
        profile=Profile(matches.middle, speeds, speed + acceleration * seconds, used),
        correlation=correlation_of(
            float(covariance[0, 1]),
            (float(speed), float(acceleration)),
            (u_speed, u_acceleration),
            (baseline_of(rig)[1] / baseline_m, rig.u_line_rate_ratio),
        ),
    )


def _budget(
    rig: Rig, baseline_m: float, motion: tuple[float, float, float], covariance: Floats, rear_s: float
) -> tuple[Entry, ...]:
    """Of speed, acceleration and length; the clock shortens a time and leaves the length alone."""
    speed, acceleration, length = motion
    of_baseline = baseline_of(rig)[1] / baseline_m
    of_length = np.array([rear_s, rear_s**2 / 2])
    of_clock = rig.u_line_rate_ratio
    leaving = speed + acceleration * rear_s
    of_line = U_CROSSING_LINES / rig.line_rate_hz
    return (
        Entry("baseline", speed * of_baseline, abs(acceleration) * of_baseline, length * of_baseline),
        Entry("clock", speed * of_clock, 2 * abs(acceleration) * of_clock, 0.0),
        Entry(
            "regression",
            float(np.sqrt(covariance[0, 0])),
            float(np.sqrt(covariance[1, 1])),
            float(np.sqrt(of_length @ covariance @ of_length)),
        ),
        Entry("front", 0.0, 0.0, speed * of_line),
        Entry("rear", 0.0, 0.0, leaving * of_line),
    )


def _not_measurable(crossings: Crossings, reason: Said) -> Motion:
    return Motion("paper", crossings, "not_measurable", reason)
