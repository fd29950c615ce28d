"""Which line rate, or which baseline, a wanted accuracy of the speed takes: equation (2) of the paper.

The paper lets each of two crossings be off by a line, so that n lines become n + 2. As printed, its middle
term is 2 / n = 2 s / (b f), while its right side, 2 s / (b f + 2 s), is 2 / (n + 2): between them a division
by b f / (n + 2) stands where b f / n belongs. The paper's own 6600 Hz and 1.3 % come from the right side.
Both are worst cases of whole lines; what the default chain reaches is far better, and measured, not planned.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class LineRatePlan:
    """Line rates in Hz that keep the speed error within a share: of the right side, and corrected."""

    printed_right_side_hz: float
    corrected_hz: float


@dataclass(frozen=True)
class SpeedError:
    """Shares (0.01 is 1 %) by which the speed may be off: of the right side, and corrected."""

    printed_right_side: float
    corrected: float
    lines: float


def line_rate_for(error: float, speed_mps: float, baseline_m: float) -> LineRatePlan:
    """The line rate for a relative speed `error` (0 to 1). Raises ValueError outside."""
    if not (0 < error < 1 and speed_mps > 0 and baseline_m > 0):
        raise ValueError("The error must be a share between 0 and 1; speed and baseline greater than 0.")
    per_metre = 2 * speed_mps / baseline_m
    return LineRatePlan(per_metre * (1 - error) / error, per_metre / error)


def speed_error(speed_mps: float, baseline_m: float, line_rate_hz: float) -> SpeedError:
    """The relative speed error that equation (2) expects, and the n lines between the cameras."""
    if min(speed_mps, baseline_m, line_rate_hz) <= 0:
        raise ValueError("Speed, baseline and line rate must be greater than 0.")
    lines = baseline_m * line_rate_hz / speed_mps
    return SpeedError(2 / (lines + 2), 2 / lines, lines)
