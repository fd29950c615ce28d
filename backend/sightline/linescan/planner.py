"""What a rig will be worth: equation (2) of the paper, and the uncertainties of speed, length and gaps.

The paper lets each of two crossings be off by a line, so that n lines become n + 2. As printed, its middle
term is 2 / n = 2 s / (b f), while its right side, 2 s / (b f + 2 s), is 2 / (n + 2): between them a division
by b f / (n + 2) stands where b f / n belongs. The paper's own 6600 Hz comes from the right side; its 1.3 %
fits both forms.
Both are worst cases of whole lines. The uncertainties planned here let each crossing be rounded to a line;
what the default chain reaches is far better, and measured, not planned.
"""

from dataclasses import dataclass
from math import hypot, sqrt

from sightline.coverage import COVERAGE_95
from sightline.enums import PlannedQuantity
from sightline.linescan.budget import U_EDGE_M

# Two crossings, each rounded to a whole line: a uniform error of half a line either way.
_U_TRANSIT_LINES = sqrt(2 / 12)
_FEW_LINES = 20
_U_LINE = 1 / sqrt(12)
USUAL_LENGTH_M, USUAL_TIME_GAP_S = 4.5, 1.5


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
class PlannedValue:
    """What a quantity (m/s, m or s) will be known to: u of whole lines, baseline and edges, and together."""

    quantity: PlannedQuantity
    value: float
    u_lines: float
    u_baseline: float
    u_edges: float
    u: float
    U95: float


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
    values: tuple[PlannedValue, ...]
    words: tuple[str, ...]


def plan_lines(
    speed_mps: float,
    baseline_m: float,
    error: float,
    line_rate_hz: float | None = None,
    u_baseline_m: float = 0.0,
    length_m: float = USUAL_LENGTH_M,
    time_gap_s: float = USUAL_TIME_GAP_S,
) -> LinePlan:
    """The plan for a vehicle of this speed and length, so long behind one as fast; without a line rate that
    of the corrected equation is taken.

    error: share by which the speed may be off (0 to 1). Raises ValueError for what cannot be planned with.
    """
    if not (0 < length_m <= 100 and 0 < time_gap_s <= 3600):
        raise ValueError("The vehicle must be up to 100 m long, the gap up to 3600 s; both greater than 0.")
    if not 0 <= u_baseline_m < baseline_m:
        raise ValueError("The baseline's uncertainty must be at least 0 and less than the baseline.")
    wanted = line_rate_for(error, speed_mps, baseline_m)
    rate_hz = wanted.corrected_hz if line_rate_hz is None else line_rate_hz
    expected = speed_error(speed_mps, baseline_m, rate_hz)
    one_line_mps = speed_mps / expected.lines
    u_lines = one_line_mps * _U_TRANSIT_LINES
    u_baseline = speed_mps * u_baseline_m / baseline_m
    u_speed = hypot(u_lines, u_baseline)
    rig = _Rig(speed_mps, baseline_m, u_baseline_m, rate_hz)
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
        values=rig.values(length_m, time_gap_s),
        words=words,
    )


@dataclass(frozen=True)
class _Rig:
    """A vehicle's speed and the rig that sees it.

    Own derivation, for constant speed: each crossing is read to a line, t +- 1 / (f sqrt 12), and each edge
    to U_EDGE_M on the vehicle, both independent (JCGM 100:2008, 5.1.2); the baseline is one error for all.
    """

    speed_mps: float
    baseline_m: float
    u_baseline_m: float
    line_rate_hz: float

    def values(self, length_m: float, time_gap_s: float) -> tuple[PlannedValue, ...]:
        """Speed, length and both gaps."""
        return (
            self._speed(),
            self._length(length_m),
            self._time_gap(time_gap_s),
            self._distance_gap(time_gap_s),
        )

    def _speed(self) -> PlannedValue:
        """v = b / (f2 - f1): two crossings of one edge, which is the same at both cameras."""
        v = self.speed_mps
        return self._planned("speed", v, sqrt(2) * v * self._line_m / self.baseline_m, v * self._ratio, 0.0)

    def _length(self, length_m: float) -> PlannedValue:
        """L = b (r1 - f1) / (f2 - f1); the front's crossing of camera 1 stands in both differences."""
        times = length_m / self.baseline_m
        lines = self._line_m * sqrt(1 + (times - 1) ** 2 + times**2)
        return self._planned("length", length_m, lines, length_m * self._ratio, sqrt(2) * U_EDGE_M)

    def _time_gap(self, seconds: float) -> PlannedValue:
        """From the rear before to this front, at camera 1: no baseline in it."""
        lines, edges = sqrt(2) * self._line_m / self.speed_mps, sqrt(2) * U_EDGE_M / self.speed_mps
        return self._planned("time_gap", seconds, lines, 0.0, edges)

    def _distance_gap(self, seconds: float) -> PlannedValue:
        """The time gap times the speed of the vehicle before: its speed was measured by its own front."""
        gap_m, speed, time = self.speed_mps * seconds, self._speed(), self._time_gap(seconds)
        lines = hypot(self.speed_mps * time.u_lines, seconds * speed.u_lines)
        return self._planned("distance_gap", gap_m, lines, gap_m * self._ratio, sqrt(2) * U_EDGE_M)

    @property
    def _line_m(self) -> float:
        """Of a crossing that is read to a line, on the road."""
        return _U_LINE * self.speed_mps / self.line_rate_hz

    @property
    def _ratio(self) -> float:
        return self.u_baseline_m / self.baseline_m

    @staticmethod
    def _planned(
        quantity: PlannedQuantity, value: float, lines: float, baseline: float, edges: float
    ) -> PlannedValue:
        u = hypot(lines, baseline, edges)
        return PlannedValue(
            quantity=quantity,
            value=value,
            u_lines=lines,
            u_baseline=baseline,
            u_edges=edges,
            u=u,
            U95=COVERAGE_95 * u,
        )


def _words(error: float, expected: SpeedError, by_lines: float, by_baseline: float) -> tuple[str, ...]:
    """What to do about it, what stops the work first; shares only, so that they hold in any unit."""
    out = []
    if expected.lines < _FEW_LINES:
        out.append(
            f"Only {expected.lines:.1f} lines lie between the cameras; use a higher line rate or a longer "
            "baseline, otherwise this vehicle can hardly be measured."
        )
    if expected.corrected > error * (1 + 1e-9):
        out.append(
            f"At this line rate the speed error may reach {_percent(expected.corrected)}, more than the "
            f"{_percent(error)} allowed; use the line rate of the corrected equation, or a baseline "
            f"{expected.corrected / error:.1f} times as long."
        )
    if by_baseline == 0:
        out.append("The baseline is taken as exact; enter its uncertainty, which is part of every speed.")
    elif by_baseline > by_lines:
        out.append(
            "The baseline is the limit, not the line rate: its standard uncertainty is "
            f"{_percent(by_baseline)}, "
            f"whole lines add {_percent(by_lines)}. Measure the baseline more accurately first."
        )
    else:
        out.append(
            f"The line rate is the limit, not the baseline: whole lines add {_percent(by_lines)} (standard "
            f"uncertainty), the baseline {_percent(by_baseline)}."
        )
    out.append(
        "Equation (2) is a worst case for whole lines, with each crossing off by one "
        "line. Sightline registers "
        "both strips to fractions of a line, so expect better; each vehicle's own "
        "uncertainty states what was "
        "reached."
    )
    return tuple(out)


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %"
