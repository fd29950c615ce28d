"""Which line rate, or which baseline, a wanted accuracy of the speed takes: equation (2) of the paper.

The paper lets each of two crossings be off by a line, so that n lines become n + 2. As printed, its middle
term is 2 / n = 2 s / (b f), while its right side, 2 s / (b f + 2 s), is 2 / (n + 2): between them a division
by b f / (n + 2) stands where b f / n belongs. The paper's own 6600 Hz comes from the right side; its 1.3 %
fits both forms.
Both are worst cases of whole lines; what the default chain reaches is far better, and measured, not planned.
"""

from dataclasses import dataclass
from math import hypot, sqrt

from sightline.coverage import COVERAGE_95

# Two crossings, each rounded to a whole line: a uniform error of half a line either way.
_U_TRANSIT_LINES = sqrt(2 / 12)
_FEW_LINES = 20


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


@dataclass(frozen=True)
class LinePlan:
    """What a line rate and a baseline are worth for the speed of one vehicle.

    `wanted`: the line rates that keep the speed within `error`. `expected`: equation (2) at `line_rate_hz`.
    `one_line_mps`: by how much the speed changes when the transit is a line longer; `one_line_m`: what
    the vehicle travels in a line. `u_lines_mps`: standard uncertainty where each of both crossings is read to
    a whole line (each rounded by up to half a line, uniformly); `u_speed_mps`: with the baseline's.
    """

    speed_mps: float
    baseline_m: float
    u_baseline_m: float
    line_rate_hz: float
    error: float
    wanted: LineRatePlan
    expected: SpeedError
    one_line_mps: float
    one_line_m: float
    u_lines_mps: float
    u_baseline_mps: float
    u_speed_mps: float
    U95_speed_mps: float
    words: tuple[str, ...]


def plan_lines(
    speed_mps: float,
    baseline_m: float,
    error: float,
    line_rate_hz: float | None = None,
    u_baseline_m: float = 0.0,
) -> LinePlan:
    """The plan for a vehicle of this speed; without a line rate that of the corrected equation is taken.

    error: share by which the speed may be off (0 to 1). Raises ValueError for what cannot be planned with.
    """
    if not 0 <= u_baseline_m < baseline_m:
        raise ValueError("The baseline's uncertainty must be at least 0 and less than the baseline.")
    wanted = line_rate_for(error, speed_mps, baseline_m)
    rate_hz = wanted.corrected_hz if line_rate_hz is None else line_rate_hz
    expected = speed_error(speed_mps, baseline_m, rate_hz)
    one_line_mps = speed_mps / expected.lines
    u_lines = one_line_mps * _U_TRANSIT_LINES
    u_baseline = speed_mps * u_baseline_m / baseline_m
    u_speed = hypot(u_lines, u_baseline)
    words = _words(error, expected, u_lines / speed_mps, u_baseline_m / baseline_m)
    return LinePlan(
        speed_mps=speed_mps,
        baseline_m=baseline_m,
        u_baseline_m=u_baseline_m,
        line_rate_hz=rate_hz,
        error=error,
        wanted=wanted,
        expected=expected,
        one_line_mps=one_line_mps,
        one_line_m=speed_mps / rate_hz,
        u_lines_mps=u_lines,
        u_baseline_mps=u_baseline,
        u_speed_mps=u_speed,
        U95_speed_mps=COVERAGE_95 * u_speed,
        words=words,
    )


def _words(error: float, expected: SpeedError, by_lines: float, by_baseline: float) -> tuple[str, ...]:
    """What to do about it, what stops the work first; shares only, so that they hold in any unit."""
    out = []
    if expected.lines < _FEW_LINES:
        out.append(
            f"Only {expected.lines:.1f} lines lie between the cameras; take a higher line rate or a longer "
            "baseline, or this vehicle can hardly be measured."
        )
    if expected.corrected > error * (1 + 1e-9):
        out.append(
            f"At this line rate the speed may be off by {_percent(expected.corrected)}, more than the "
            f"{_percent(error)} wanted; take the line rate of the corrected equation, or a baseline "
            f"{expected.corrected / error:.1f} times as long."
        )
    if by_baseline == 0:
        out.append("The baseline is taken as exactly known; enter its uncertainty, for it enters any speed.")
    elif by_baseline > by_lines:
        out.append(
            f"The baseline limits, not the line rate: it is known to {_percent(by_baseline)} (standard "
            f"uncertainty), whole lines add {_percent(by_lines)}. Measure the baseline better first."
        )
    else:
        out.append(
            f"The line rate limits, not the baseline: whole lines add {_percent(by_lines)} (standard "
            f"uncertainty), the baseline {_percent(by_baseline)}."
        )
    out.append(
        "Equation (2) is a worst case of whole lines, each crossing a line off. Sightline lays both strips "
        "over each other to fractions of a line, so plan with this and expect better; each vehicle's own "
        "uncertainty says what was reached."
    )
    return tuple(out)


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %"
