"""Baseline and divergence of a rig from a staff or board that passes both planes at several distances.

What a pass tells. A scanning plane cuts the horizontal plane of the mark in a line, x_i = c_i + D tan(a_i)
along the traffic at the distance D from the cameras. What lies between both, along the traffic, is

    B(D) = x_2 - x_1 = b + q D,    b = c_2 - c_1 (baseline),    q = tan(a_2) - tan(a_1) (divergence),

exact at any distance. So a pass at a known distance gives one number, the span B(D), and only b and q can be
had: how far both planes are turned together, and where the pair stands along the road, shift x_1 and x_2
alike and do not matter for a speed. One distance gives B there and nothing more; two give b and q; a third
tests that the line is straight. A plane that leans along the traffic makes c_i depend on the height: the
marks are to be as high as what is measured of vehicles, or the lean enters q unseen.

How a pass gives a span:
- positions: the staff is moved along a tape until each camera sees it; span = |position_2 - position_1|;
- speed: the staff is carried at a known speed v; span = v |line_2 - line_1| / line rate;
- board: a board of known width w, its edges as front and rear; speed and acceleration follow from the width,
  seen twice, and the line rate cancels. With front and rear at f_1 = 0, r_1, f_2, r_2, in lines, and way p .
  (t, t^2/2), way(r_1) = w and way(r_2) - way(f_2) = w are linear in p, and span = way(f_2). Exact for a
  constant acceleration.

What goes together. Each span errs by itself (lines, positions, a speed's own u). Errors shared: the taped
distance of a stand (rows with one distance stand at one place), the width of one board, the scale of tape,
speed and line rate. All stand in the covariance V of the spans; sensitivities to scales are taken at the
fitted span, not the observed one, for weights made from observations pull a fit towards the small ones. b and
q then follow from generalised least squares with covariance (A' V^-1 A)^-1 (JCGM 100:2008, 5.2.2; Aitken
1936), and r' V^-1 r of the residuals is a chi-square with n - 2 degrees: what all passes share cannot show
there.

Douxchamps et al., section III, give only a result (593 mm; within 2 mm at 10 m) and leave the procedure to
another report; nothing here is theirs.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import isfinite, sqrt

import numpy as np

from sightline.arrays import Floats
from sightline.coverage import chance_of_larger, expanded
from sightline.enums import RigPassKind
from sightline.errors import BadInput
from sightline.linescan.rig import BASELINE_M, DISTANCE_M, DIVERGENCE_RAD, baseline_at
from sightline.messages.said import Said

LEAST_PASSES = 3
DEFAULT_U_LINE = 2.0  # standard uncertainty of a line that a person clicked, as of a wheel
DEFAULT_U_DISTANCE_M = 0.01
# Distances closer than this, as a share of their mean, are one distance.
LEAST_SPREAD = 0.1
# Less likely than this by chance: the passes contradict each other (refused), or are to be looked at (said).
CONTRADICTION = 1e-4
DOUBT = 0.025
_ROUNDS = 4  # of the weights, which hang on the fitted spans; the second changes the last digits already
_BEYOND = 0.5  # of the span of distances: a lane so far outside is told


class RigPassError(BadInput):
    """A pass tells nothing of the baseline; the message says why and what to do."""


@dataclass(frozen=True, kw_only=True)
class RigPass:
    """One pass of a staff or a board through both planes; of the three ways one has all its values.

    Lines are those of `Crossings`; `u_line` of each. u_ are standard uncertainties (k = 1).
    """

    name: str
    distance_m: float
    u_distance_m: float = DEFAULT_U_DISTANCE_M
    u_line: float = DEFAULT_U_LINE
    position_1_m: float | None = None
    position_2_m: float | None = None
    u_position_m: float | None = None
    speed_mps: float | None = None
    u_speed_mps: float | None = None
    line_1: float | None = None
    line_2: float | None = None
    width_m: float | None = None
    u_width_m: float | None = None
    front_line_1: float | None = None
    rear_line_1: float | None = None
    front_line_2: float | None = None
    rear_line_2: float | None = None


# What each way needs, in the order of the columns.
VALUES: dict[RigPassKind, tuple[str, ...]] = {
    "positions": ("position_1_m", "position_2_m", "u_position_m"),
    "speed": ("speed_mps", "u_speed_mps", "line_1", "line_2"),
    "board": ("width_m", "u_width_m", "front_line_1", "rear_line_1", "front_line_2", "rear_line_2"),
}


@dataclass(frozen=True, kw_only=True)
class Common:
    """What all passes share: the line rate (for passes of known speed), and scales of tape, speed, line rate.

    `u_..._ratio` are shares (k = 1): 1e-4 is 0.01 %.
    """

    line_rate_hz: float | None = None
    u_line_rate_ratio: float = 0.0
    u_tape_ratio: float = 0.0
    u_speed_ratio: float = 0.0


@dataclass(frozen=True)
class Span:
    """What one pass says of B at its distance, m. `u_span_m`: by itself; `u_ratio`: by itself, a share of the
    span; `shared`: what it shares with others by name, as shares of the span.
    """

    name: str
    kind: RigPassKind
    distance_m: float
    u_distance_m: float
    span_m: float
    u_span_m: float
    u_ratio: float = 0.0
    shared: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class FittedPass:
    """A pass beside the fit: residual = span - fitted; its u holds all that is uncertain of the span."""

    name: str
    kind: RigPassKind
    distance_m: float
    span_m: float
    u_span_m: float
    fitted_m: float
    residual_m: float
    normalised: float


@dataclass(frozen=True)
class LaneBaseline:
    """The baseline at a lane's distance, with the standard uncertainty that all speeds there share."""

    distance_m: float
    u_distance_m: float
    baseline_m: float
    u_baseline_m: float
    warning: Said | None = None


@dataclass(frozen=True)
class RigCalibration:
    """Baseline at the cameras and divergence with their joint uncertainty; how well the passes agree.

    `correlation` of both (nearly -1 where the passes are far away). `p_value`: the chance of a chi-square as
    large. `nearest_m`, `farthest_m`: between these the straight line was seen.
    """

    baseline_m: float
    u_baseline_m: float
    divergence_rad: float
    u_divergence_rad: float
    correlation: float
    chi2: float
    degrees_of_freedom: int
    p_value: float
    nearest_m: float
    farthest_m: float
    passes: tuple[FittedPass, ...]
    warnings: tuple[Said, ...] = ()


def kind_of(rig_pass: RigPass) -> RigPassKind:
    """Which way a pass has the values of. Raises RigPassError where none is whole or two are begun."""
    begun = [
        kind for kind, names in VALUES.items() if any(getattr(rig_pass, name) is not None for name in names)
    ]
    if not begun:
        raise RigPassError("rig-pass-no-way")
    if len(begun) > 1:
        raise RigPassError("rig-pass-two-ways", one=begun[0], two=begun[1])
    lacking = [name for name in VALUES[begun[0]] if getattr(rig_pass, name) is None]
    if lacking:
        raise RigPassError("rig-pass-lacks", column=lacking[0])
    return begun[0]


def span_of(rig_pass: RigPass, common: Common) -> Span:
    """What a pass says of the baseline at its distance. Raises RigPassError saying what is wrong."""
    kind = kind_of(rig_pass)
    _require_values(rig_pass, kind)
    if kind == "positions":
        return _by_positions(rig_pass, common)
    return _by_speed(rig_pass, common) if kind == "speed" else _by_board(rig_pass)


def calibrate_rig(passes: Sequence[RigPass], common: Common | None = None) -> RigCalibration:
    """Baseline and divergence from passes at two distances or more, by generalised least squares.

    Raises BadInput in one sentence: a pass that cannot be, too few, distances too alike, passes that
    contradict each other. The derivation stands above.
    """
    shared = common or Common()
    _require_common(shared)
    spans = [_span_by_name(one, shared) for one in passes]
    _require_spread(spans)
    distance, span = (np.array([getattr(one, name) for one in spans]) for name in ("distance_m", "span_m"))
    # b and q by way of the middle of the distances, where they are hardly correlated: better conditioned
    pivot = float(distance.mean())
    design = np.column_stack([np.ones_like(distance), distance - pivot])
    coefficients = np.linalg.lstsq(design, span, rcond=None)[0]
    for _ in range(_ROUNDS):
        spread = _spread(spans, design @ coefficients, float(coefficients[1]), shared)
        weighted = np.linalg.solve(spread, design)
        covariance = np.linalg.inv(design.T @ weighted)
        coefficients = covariance @ (weighted.T @ span)
    to_cameras = np.array([[1.0, -pivot], [0.0, 1.0]])
    baseline, divergence = (float(one) for one in to_cameras @ coefficients)
    covariance = to_cameras @ covariance @ to_cameras.T
    BASELINE_M.require(baseline)
    DIVERGENCE_RAD.require(divergence)
    fitted = _compare_with_fit(
        spans, design @ coefficients, spread, spread - design @ np.linalg.solve(design.T @ weighted, design.T)
    )
    residual = span - design @ coefficients
    chi2, degrees = float(residual @ np.linalg.solve(spread, residual)), len(spans) - 2
    p_value = chance_of_larger(chi2, degrees)
    if p_value < CONTRADICTION:
        _contradict(fitted, chi2, degrees)
    u_baseline, u_divergence = (sqrt(one) for one in np.diag(covariance))
    return RigCalibration(
        baseline_m=baseline,
        u_baseline_m=u_baseline,
        divergence_rad=divergence,
        u_divergence_rad=u_divergence,
        correlation=float(np.clip(covariance[0, 1] / (u_baseline * u_divergence), -1.0, 1.0)),
        chi2=chi2,
        degrees_of_freedom=degrees,
        p_value=p_value,
        nearest_m=float(distance.min()),
        farthest_m=float(distance.max()),
        passes=fitted,
        warnings=_warnings(p_value, fitted),
    )


def lane_baseline(calibration: RigCalibration, distance_m: float, u_distance_m: float = 0.0) -> LaneBaseline:
    """The baseline at a lane's distance: B = b + q D, u by the joint covariance and the distance's own u.

    Raises BadInput for a distance that cannot be. A warning where the lane lies far outside the passes.
    """
    DISTANCE_M.require(distance_m)
    baseline, u = baseline_at(
        (calibration.baseline_m, calibration.u_baseline_m),
        (calibration.divergence_rad, calibration.u_divergence_rad),
        calibration.correlation,
        (distance_m, u_distance_m),
    )
    beyond = max(calibration.nearest_m - distance_m, distance_m - calibration.farthest_m)
    warning = None
    if beyond > _BEYOND * (calibration.farthest_m - calibration.nearest_m):
        warning = Said(
            "rig-passes-outside",
            distance_m=round(distance_m, 2),
            nearest_m=round(calibration.nearest_m, 2),
            farthest_m=round(calibration.farthest_m, 2),
        )
    return LaneBaseline(distance_m, u_distance_m, baseline, u, warning)


def _span_by_name(rig_pass: RigPass, common: Common) -> Span:
    try:
        return span_of(rig_pass, common)
    except RigPassError as error:
        raise BadInput("linescan-rig-pass", name=rig_pass.name, sentence=error.said) from None


def _by_positions(rig_pass: RigPass, common: Common) -> Span:
    first, second, u = _numbers(rig_pass, "position_1_m", "position_2_m", "u_position_m")
    return _span(rig_pass, "positions", abs(second - first), sqrt(2.0) * u, {"tape": common.u_tape_ratio})


def _by_speed(rig_pass: RigPass, common: Common) -> Span:
    speed, u_speed, first, second = _numbers(rig_pass, *VALUES["speed"])
    if common.line_rate_hz is None:
        raise RigPassError("rig-pass-no-rate")
    rate_hz = common.line_rate_hz
    span_m, u_span_m = speed * abs(second - first) / rate_hz, sqrt(2.0) * rig_pass.u_line * speed / rate_hz
    shared = {"speed": common.u_speed_ratio, "line rate": common.u_line_rate_ratio}
    return _span(rig_pass, "speed", span_m, u_span_m, shared, u_speed / speed)


def _by_board(rig_pass: RigPass) -> Span:
    """Way, speed and acceleration by lines: the line rate cancels.

    An error of a crossing acts as the way gone in it, v(t) dt; one of f_1 shifts all the others back.
    """
    width, u_width, *lines = _numbers(rig_pass, *VALUES["board"])
    if lines[2] < lines[0]:
        lines = [*lines[2:], *lines[:2]]  # it went the other way: camera 2 saw it first
    rear_1, front_2, rear_2 = (line - lines[0] for line in lines[1:])
    if not (rear_1 > 0 and rear_2 > front_2 > 0):
        raise RigPassError("rig-pass-no-order")
    ways = np.array([[rear_1, rear_1**2 / 2], [rear_2 - front_2, (rear_2**2 - front_2**2) / 2]])
    if abs(np.linalg.det(ways)) < 1e-9 * rear_2**3:
        raise RigPassError("rig-pass-no-order")
    reach = np.array([front_2, front_2**2 / 2])
    motion = np.linalg.solve(ways, [width, width])
    gone = np.array([motion[0] + motion[1] * t for t in (0.0, rear_1, front_2, rear_2)])
    if gone.min() < 0.2 * gone.max():
        raise RigPassError("rig-pass-stopped")
    by_width = np.linalg.solve(ways.T, reach)
    due = np.array([-by_width[0] * gone[1], gone[2] * (1 + by_width[1]), -by_width[1] * gone[3]])
    u_span_m = rig_pass.u_line * float(np.sqrt(due @ due + due.sum() ** 2))
    return _span(rig_pass, "board", float(reach @ motion), u_span_m, {f"width {width!r}": u_width / width})


def _numbers(one: RigPass, *names: str) -> list[float]:
    return [float(getattr(one, name)) for name in names]


def _span(
    of: RigPass,
    kind: RigPassKind,
    span_m: float,
    u_span_m: float,
    shared: dict[str, float],
    u_ratio: float = 0.0,
) -> Span:
    if not BASELINE_M.least <= span_m <= BASELINE_M.most:
        span_m = float(f"{span_m:.4g}")
        raise RigPassError("rig-pass-span", span_m=span_m, least=BASELINE_M.least, most=BASELINE_M.most)
    return Span(
        name=of.name,
        kind=kind,
        distance_m=of.distance_m,
        u_distance_m=of.u_distance_m,
        span_m=span_m,
        u_span_m=u_span_m,
        u_ratio=u_ratio,
        shared=shared,
    )


def _require_values(rig_pass: RigPass, kind: RigPassKind) -> None:
    """All are numbers; what cannot be 0 or less is more (also the u of a line and of a position)."""
    names = ("distance_m", "u_distance_m", "u_line", *VALUES[kind])
    for name in names:
        value = getattr(rig_pass, name)
        positive = name in ("distance_m", "speed_mps", "width_m", "u_line", "u_position_m")
        least = 0.0 if name.startswith("u_") or positive else -np.inf
        if not isfinite(value) or value < least or (positive and value == 0):
            raise RigPassError("rig-pass-value", column=name, value=f"{value:.6g}")
    if not DISTANCE_M.least <= rig_pass.distance_m <= DISTANCE_M.most:
        raise RigPassError("rig-pass-value", column="distance_m", value=f"{rig_pass.distance_m:.6g}")


def _require_common(common: Common) -> None:
    shares = (common.u_line_rate_ratio, common.u_tape_ratio, common.u_speed_ratio)
    if not all(isfinite(one) and 0 <= one <= 0.1 for one in shares):
        raise BadInput("linescan-rig-common")


def _require_spread(spans: Sequence[Span]) -> None:
    if len(spans) < LEAST_PASSES:
        raise BadInput("linescan-rig-few-passes", count=len(spans), least=LEAST_PASSES)
    distances = [one.distance_m for one in spans]
    wide = max(distances) - min(distances)
    unsure = 4 * max(one.u_distance_m for one in spans)
    if wide < max(LEAST_SPREAD * sum(distances) / len(distances), unsure):
        raise BadInput(
            "linescan-rig-distances-alike",
            nearest_m=format(min(distances), ".3f"),
            farthest_m=format(max(distances), ".3f"),
        )
    for name in sorted({name for one in spans for name in one.shared if name.startswith("width ")}):
        if len({one.shared[name] for one in spans if name in one.shared}) > 1:
            raise BadInput("linescan-width-two-u", width_m=name.removeprefix("width "))
    for distance in sorted(set(distances)):
        if len({one.u_distance_m for one in spans if one.distance_m == distance}) > 1:
            raise BadInput("linescan-distance-two-u", distance_m=format(distance, ".3f"))


def _spread(spans: Sequence[Span], fitted: Floats, divergence: float, common: Common) -> Floats:
    """(n, n) covariance of the spans, m^2, with the sensitivities at the fitted spans."""
    own = np.array([one.u_span_m for one in spans]) ** 2
    own += (np.array([one.u_ratio for one in spans]) * fitted) ** 2
    distance = np.array([one.distance_m for one in spans])
    columns = {
        name: np.array([one.shared.get(name, 0.0) for one in spans]) * fitted
        for name in sorted({name for one in spans for name in one.shared})
    }
    # a tape that is too long makes spans too short that were taped, and every distance
    columns["tape"] = columns.get("tape", 0.0) - divergence * distance * common.u_tape_ratio
    for stand in np.unique(distance):
        u_stand = max(one.u_distance_m for one in spans if one.distance_m == stand)
        columns[f"stand {stand}"] = np.where(distance == stand, divergence * u_stand, 0.0)
    together = np.column_stack(list(columns.values()))
    return np.asarray(np.diag(own) + together @ together.T)


def _compare_with_fit(
    spans: Sequence[Span], fitted: Floats, spread: Floats, of_residuals: Floats
) -> tuple[FittedPass, ...]:
    """`of_residuals` (n, n): the covariance that the residuals have, V - A (A' V^-1 A)^-1 A'."""
    left = np.sqrt(np.maximum(np.diag(of_residuals), 1e-3 * np.diag(spread)))
    return tuple(
        FittedPass(
            name=span.name,
            kind=span.kind,
            distance_m=span.distance_m,
            span_m=span.span_m,
            u_span_m=sqrt(spread[at, at]),
            fitted_m=float(fitted[at]),
            residual_m=float(span.span_m - fitted[at]),
            normalised=float((span.span_m - fitted[at]) / left[at]),
        )
        for at, span in enumerate(spans)
    )


def _contradict(fitted: Sequence[FittedPass], chi2: float, degrees: int) -> None:
    worst = max(fitted, key=lambda one: abs(one.normalised))
    raise BadInput(
        "linescan-rig-contradict",
        chi2=format(chi2, ".1f"),
        degrees=degrees,
        name=worst.name,
        residual_mm=format(1000 * abs(worst.residual_m), ".2f"),
        expected_mm=format(1000 * expanded(abs(worst.residual_m / worst.normalised)), ".2f"),
    )


def _warnings(p_value: float, fitted: Sequence[FittedPass]) -> tuple[Said, ...]:
    worst = max(fitted, key=lambda one: abs(one.normalised))
    warnings = []
    if p_value < DOUBT:
        warnings.append(Said("rig-passes-differ", chance=float(f"{100 * p_value:.2g}"), name=worst.name))
    if p_value > 1 - DOUBT:
        warnings.append(Said("rig-passes-too-wide"))
    if len({one.distance_m for one in fitted}) == 2:
        warnings.append(Said("rig-passes-two-distances"))
    return tuple(warnings)
