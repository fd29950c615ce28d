"""What a rig will be worth: the uncertainties of speed, length and gaps, and equation (2) of the paper.

The uncertainties are those of the default chain (`direct.py`): it registers both strips of a vehicle as a
whole, so a speed errs by a length over the baseline, not by lines; boundaries are read to a part of a line.
Equation (2) is told beside them: it lets each of two crossings be off by a line, so that n lines are n + 2.
As printed, its middle term is 2 / n = 2 s / (b f), while its right side, 2 s / (b f + 2 s), is 2 / (n + 2):
between them a division by b f / (n + 2) stands where b f / n belongs. The paper's own 6600 Hz comes from the
right side; its 1.3 % fits both forms. Both are worst cases of whole lines.
"""

from dataclasses import dataclass
from math import hypot, sqrt

from sightline.coverage import COVERAGE_95
from sightline.enums import PlannedQuantity
from sightline.errors import BadInput
from sightline.linescan.boundaries import U_LINE_LINES
from sightline.linescan.budget import U_EDGE_M
from sightline.linescan.direct import MOST_MOVED
from sightline.linescan.fineness import GOOD_LINE_M
from sightline.linescan.rig import BASELINE_M, LIMITS, Limits
from sightline.messages.said import Said

# By how much registering both strips errs along the road, standard u: so much whatever the lines, and a share
# of what the vehicle moves from line to line. Of 111 simulated vehicles (11 to 36 m/s, 1,221 to 9,766 Hz,
# baselines of 0.3 to 1.2 m, noise 2 DN) the errors of the speed, in metres of the baseline, are 0.8 times as
# large on the whole, 0.5 to 1.1 times by lines' distances, and do not depend on the baseline.
U_REGISTERED_M, U_REGISTERED_LINES = 0.0001, 0.015
# 16 of 22 simulated vehicles that moved more than this from line to line were refused, none that moved less
COARSE_LINE_M = 0.020
# fewer lines from camera to camera cannot be told from a speed that the pictures deny (direct.py)
_FEW_LINES = 2 / MOST_MOVED
USUAL_LENGTH_M, USUAL_TIME_GAP_S = 4.5, 1.5
_SPEED_MPS = Limits("A speed", 0.1, 1000.0, "m/s")


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
    """The line rate for a relative speed `error` (0 to 1). Raises BadInput outside."""
    if not (0 < error < 1 and speed_mps > 0 and baseline_m > 0):
        raise BadInput("plan-lines-no-share")
    per_metre = 2 * speed_mps / baseline_m
    return LineRatePlan(per_metre * (1 - error) / error, per_metre / error)


def speed_error(speed_mps: float, baseline_m: float, line_rate_hz: float) -> SpeedError:
    """The relative speed error that equation (2) expects, and the n lines between the cameras."""
    if min(speed_mps, baseline_m, line_rate_hz) <= 0:
        raise BadInput("plan-lines-above-zero")
    lines = baseline_m * line_rate_hz / speed_mps
    return SpeedError(2 / (lines + 2), 2 / lines, lines)


@dataclass(frozen=True)
class PlannedValue:
    """What a quantity (m/s, m or s) will be known to: u of reading the strips (of a speed: of registering
    them), of baseline and of edges, and together.
    """

    quantity: PlannedQuantity
    value: float
    u_strips: float
    u_baseline: float
    u_edges: float
    u: float
    U95: float


@dataclass(frozen=True)
class LinePlan:
    """What a line rate and a baseline are worth for the speed of one vehicle.

    `wanted`: the line rates by which equation (2) keeps the speed within `error`; `expected`: equation (2) at
    `line_rate_hz`. `fine_hz`: the line rate at which lines lie GOOD_LINE_M apart on the vehicle;
    `one_line_m`: what it travels in a line. `u_strips_mps`: standard uncertainty of the speed by registering
    both strips; `u_speed_mps`: with the baseline's.
    """

    speed_mps: float
    baseline_m: float
    u_baseline_m: float
    line_rate_hz: float
    fine_hz: float
    error: float
    wanted: LineRatePlan
    expected: SpeedError
    one_line_m: float
    u_strips_mps: float
    u_baseline_mps: float
    u_speed_mps: float
    U95_speed_mps: float
    values: tuple[PlannedValue, ...]
    words: tuple[Said, ...]


def plan_lines(
    speed_mps: float,
    baseline_m: float,
    error: float,
    line_rate_hz: float | None = None,
    u_baseline_m: float = 0.0,
    length_m: float = USUAL_LENGTH_M,
    time_gap_s: float = USUAL_TIME_GAP_S,
) -> LinePlan:
    """What a line rate and a baseline are worth for the speed of a vehicle, so long behind one as fast.

    Parameters
    ----------
    speed_mps : float
        Of the vehicle, m/s.
    baseline_m : float
        Between both scanning planes, metres.
    error : float
        Share that the speed's U95 may be, 0 to 1.
    line_rate_hz : float, optional
        None: that at which lines lie GOOD_LINE_M apart on the vehicle.
    u_baseline_m : float
        Standard uncertainty of the baseline, metres.
    length_m, time_gap_s : float
        Of the vehicle, and behind the one before, metres and seconds.

    Returns
    -------
    LinePlan
        With `u_speed_mps`, m/s.

    Raises
    ------
    BadInput
        For what cannot be planned with.

    Examples
    --------
    >>> import sightline
    >>> plan = sightline.plan_lines(speed_mps=13.9, baseline_m=1.0, error=0.01)
    >>> plan.line_rate_hz, round(plan.u_speed_mps, 4)
    (1390.0, 0.0025)
    """
    if not (0 < length_m <= 100 and 0 < time_gap_s <= 3600):
        raise BadInput("plan-lines-vehicle")
    BASELINE_M.require(baseline_m)
    _SPEED_MPS.require(speed_mps)
    if line_rate_hz is not None:
        LIMITS["line_rate_hz"].require(line_rate_hz)
    if not 0 <= u_baseline_m < baseline_m:
        raise BadInput("plan-lines-u-baseline")
    wanted = line_rate_for(error, speed_mps, baseline_m)
    fine_hz = speed_mps / GOOD_LINE_M
    rate_hz = fine_hz if line_rate_hz is None else line_rate_hz
    expected = speed_error(speed_mps, baseline_m, rate_hz)
    rig = _Rig(speed_mps, baseline_m, u_baseline_m, rate_hz)
    values = rig.values(length_m, time_gap_s)
    speed = values[0]
    return LinePlan(
        speed_mps=speed_mps,
        baseline_m=baseline_m,
        u_baseline_m=u_baseline_m,
        line_rate_hz=rate_hz,
        fine_hz=fine_hz,
        error=error,
        wanted=wanted,
        expected=expected,
        one_line_m=speed_mps / rate_hz,
        u_strips_mps=speed.u_strips,
        u_baseline_mps=speed.u_baseline,
        u_speed_mps=speed.u,
        U95_speed_mps=speed.U95,
        values=values,
        words=_list_advice(error, expected.lines, speed, speed_mps / rate_hz, fine_hz),
    )


@dataclass(frozen=True)
class _Rig:
    """A vehicle's speed and the rig that sees it.

    Own derivation, for constant speed, of what `budget.py` and `gaps.py` say of a measured vehicle: the
    transit by U_REGISTERED_M and U_REGISTERED_LINES, each boundary by U_LINE_LINES of a line and U_EDGE_M on
    the vehicle, all independent (JCGM 100:2008, 5.1.2); the baseline is one error for all.
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
            self._distance_gap(length_m, time_gap_s),
        )

    def _speed(self) -> PlannedValue:
        """v = b / T: all of the vehicle that both strips show gives T, not its ends."""
        v = self.speed_mps
        off_m = hypot(U_REGISTERED_M, U_REGISTERED_LINES * v / self.line_rate_hz)
        return self._planned("speed", v, v * off_m / self.baseline_m, v * self._ratio, 0.0)

    def _length(self, length_m: float) -> PlannedValue:
        """L, the mean of both cameras: each end read to a fraction of a line, the scale that of the speed
        midway along the vehicle, where a straight line is known twice as well as at its end.
        """
        strips = hypot(U_LINE_LINES * self.speed_mps / self.line_rate_hz, length_m * self._of_speed / 2)
        return self._planned("length", length_m, strips, length_m * self._ratio, sqrt(2) * U_EDGE_M)

    def _time_gap(self, seconds: float) -> PlannedValue:
        """From the rear before to this front, at camera 1: no baseline in it."""
        lines, edges = sqrt(2) * U_LINE_LINES / self.line_rate_hz, sqrt(2) * U_EDGE_M / self.speed_mps
        return self._planned("time_gap", seconds, lines, 0.0, edges)

    def _distance_gap(self, length_m: float, seconds: float) -> PlannedValue:
        """The vehicle before, as long as this one, is carried on from its rear by its own motion: a straight
        line in time, known twice as well midway along the vehicle as at its end, and the less the farther on.
        """
        gap_m, time = self.speed_mps * seconds, self._time_gap(seconds)
        seen_s, u_mps = (length_m + self.baseline_m) / self.speed_mps, self._speed().u_strips
        u_midway_mps2 = sqrt(3) * u_mps / seen_s
        carried_m = seconds * hypot(u_mps / 2, u_midway_mps2 * (seconds + seen_s) / 2)
        strips = hypot(self.speed_mps * time.u_strips, carried_m)
        return self._planned("distance_gap", gap_m, strips, gap_m * self._ratio, sqrt(2) * U_EDGE_M)

    @property
    def _of_speed(self) -> float:
        """By which share registering lets a speed err."""
        return self._speed().u_strips / self.speed_mps

    @property
    def _ratio(self) -> float:
        return self.u_baseline_m / self.baseline_m

    @staticmethod
    def _planned(
        quantity: PlannedQuantity, value: float, strips: float, baseline: float, edges: float
    ) -> PlannedValue:
        u = hypot(strips, baseline, edges)
        return PlannedValue(
            quantity=quantity,
            value=value,
            u_strips=strips,
            u_baseline=baseline,
            u_edges=edges,
            u=u,
            U95=COVERAGE_95 * u,
        )


def _list_advice(
    error: float, lines: float, speed: PlannedValue, line_m: float, fine_hz: float
) -> tuple[Said, ...]:
    """What to do about it, what stops the work first."""
    out, rate_hz = [], _digits(fine_hz, 3)
    if lines < _FEW_LINES:
        out.append(Said("plan-lines-few", lines=round(lines, 1)))
    if line_m > COARSE_LINE_M:
        out.append(
            Said("plan-lines-coarse", line_m=round(line_m, 4), coarse_m=COARSE_LINE_M, rate_hz=rate_hz)
        )
    elif line_m > GOOD_LINE_M * (1 + 1e-9):
        out.append(Said("plan-lines-apart", line_m=round(line_m, 4), good_m=GOOD_LINE_M, rate_hz=rate_hz))
    reached = speed.U95 / speed.value
    if reached > error * (1 + 1e-9):
        times = round(reached / error, 1)
        allowed = _percent(error)
        out.append(Said("plan-lines-U95", reached=_percent(reached), allowed=allowed, times=times))
    by_strips, by_baseline = speed.u_strips / speed.value, speed.u_baseline / speed.value
    strips, baseline = _percent(by_strips), _percent(by_baseline)
    if by_baseline == 0:
        out.append(Said("plan-lines-baseline-exact"))
    elif by_baseline > by_strips:
        out.append(Said("plan-lines-baseline-limits", strips=strips, baseline=baseline))
    else:
        out.append(Said("plan-lines-strips-limit", strips=strips, baseline=baseline))
    return (*out, Said("plan-lines-expected"))


def _percent(share: float) -> float:
    return _digits(100 * share, 2)


def _digits(value: float, digits: int) -> float:
    """To so many that count."""
    return float(f"{value:.{digits}g}")
