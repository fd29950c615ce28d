"""The report's part on line scans: rig, method, speeds, gaps, errors of known sizes, the vehicles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sightline.export.report.blocks import Column, Document
from sightline.export.report.canvas import Drawing
from sightline.export.report.facts import ReportFacts, RigFacts, ScanFacts, ScannedHeights
from sightline.export.report.scan_figures import NAMES, scale_of
from sightline.export.report.units import HEIGHT, NONE, SMALL, Scale, Unit, count, fixed, plural
from sightline.export.report.words import GROUPS, LIGHTING, TARGETS, heading
from sightline.linescan.rig import Estimate
from sightline.scans.statistics.service import Row, ScanStatistics, Spread
from sightline.statistics.distributions import Percentile
from sightline.statistics.errors import ErrorGroup

Drawn = Mapping[str, Drawing | str]
MOST_VEHICLES = 60
# The headway's figure is in the package alone: four fill two rows.
_DRAWN = ("scan-speed", "scan-length", "scan-time-gap", "scan-distance-gap")
_PERCENTS = (15.0, 50.0, 85.0)
_IN_WORDS: dict[Unit, str] = {"m": "millimetres", "ft": "inches"}
_METHODS = {
    "direct": "by laying both strips of a vehicle over each other as a whole (direct registration)",
    "paper": "by the paper’s block matching and linear regression",
}
_ERROR_ROWS = (
    ("bias_m", "bias"),
    ("mae_m", "MAE"),
    ("rmse_m", "RMSE"),
    ("sd_m", "SD"),
)


def line_scans(document: Document, facts: ReportFacts, drawn: Drawn) -> None:
    """The whole part; nothing where the survey has no line scan."""
    scans = facts.scans
    if scans is None:
        return
    document.section("Line scans")
    found = scans.statistics
    document.words(_method(scans))
    _rigs(document, scans.rigs, facts.unit)
    document.words(_counted(found))
    if not found.counted["used"]:
        return
    document.words(_speed_in_short(found, facts.unit))
    _quantities(document, found.spreads, facts.unit)
    document.figures([(name, drawn[name]) for name in _DRAWN if name in drawn], across=2)
    _sizes(document, found, facts.unit)
    _heights(document, scans.heights, facts.unit)
    _vehicles(document, found.table, facts.unit)


def _method(scans: ScanFacts) -> str:
    by = [f"{plural(n, 'vehicle', 'vehicles')} {_METHODS.get(method, method)}" for method, n in scans.methods]
    how = f" Measured were {' and '.join(by)}." if by else ""
    return (
        "Two line cameras a known baseline apart record the same traffic (Douxchamps, Macq and Chihara). A "
        "vehicle’s motion is one speed when its front reaches camera 1 and one constant acceleration; its "
        "length is compensated for it. Time gaps run from the rear of the vehicle before to this front, "
        f"distance gaps between the same points as this front reaches camera 1.{how} Uncertainties hold "
        "baseline, clock, misalignment, fit and boundaries."
    )


def _rigs(document: Document, rigs: Sequence[RigFacts], unit: Unit) -> None:
    scale = HEIGHT[unit]
    document.table(
        "Line scans and their rigs as entered; ± is a standard uncertainty (k = 1).",
        [
            Column("Line scan", 1.0),
            Column("Lines", align="right"),
            Column("Baseline", 0.0, "right", scale.sign),
            Column("Line rate", 0.0, "right", "Hz"),
            Column("Clock", 0.0, "right", "ppm"),
            Column("Divergence", 0.0, "right", "mrad"),
            Column("Lane at", 0.0, "right", scale.sign),
            Column("Misalignment", 0.0, "right", "px"),
        ],
        [_rig(one, scale) for one in rigs],
    )


def _rig(one: RigFacts, scale: Scale) -> list[str | tuple[str, str]]:
    small = Scale(scale.factor, "", 4)
    light = LIGHTING.get(one.lighting, one.lighting)
    made = "columns of a video" if one.source == "video" else "strips"
    given = one.misalignment_px is not None
    return [
        (one.name, f"{made}, {light}"),
        NONE if one.lines is None else count(one.lines),
        f"{small.number(one.baseline_m)} ± {small.number(one.u_baseline_m)}",
        fixed(one.line_rate_hz, 1),
        fixed(1e6 * one.u_line_rate_ratio, 0),
        f"{fixed(1e3 * one.divergence_rad, 2)} ± {fixed(1e3 * one.u_divergence_rad, 2)}",
        NONE if one.distance_m is None else Scale(scale.factor, "", 2).number(one.distance_m),
        f"{fixed(one.misalignment_px or 0.0, 2)} ± {fixed(one.u_misalignment_px, 2)}"
        if given
        else "from the traffic",
    ]


def _counted(found: ScanStatistics) -> str:
    counted = found.counted
    left = [
        f"{count(counted[name])} {words}"
        for name, words in (
            ("to_review", "not reviewed yet"),
            ("rejected", "rejected"),
            ("not_measurable", "not measurable"),
        )
        if counted[name]
    ]
    if not counted["vehicles"]:
        return "No vehicle was found in them."
    out = f" Left out: {', '.join(left)}; scan_vehicles.csv has the reasons." if left else ""
    if not counted["used"]:
        return f"No scanned vehicle is accepted, so none counts here.{out}"
    return (
        f"{plural(counted['used'], 'accepted vehicle counts', 'accepted vehicles count')} of "
        f"{count(counted['vehicles'])} found.{out}"
    )


def _speed_in_short(found: ScanStatistics, unit: Unit) -> str:
    speed = next(one for one in found.spreads if one.quantity == "speed")
    scale = scale_of(speed.unit, unit)
    at = _percentile(speed, 85.0)
    if at is None or speed.mean is None:
        return ""
    within = (
        f" (no 95 % interval: {at.reason})"
        if at.low is None or at.high is None
        else f" (95 %: {scale.number(at.low)} to {scale.number(at.high)})"
    )
    return (
        f"The mean speed is {scale.length(speed.mean)}; 85 % drive no faster than "
        f"{scale.length(at.value)}{within}."
    )


def _quantities(document: Document, spreads: Sequence[Spread], unit: Unit) -> None:
    document.table(
        "What was measured of the accepted vehicles, with percentiles and their 95 % intervals.",
        [
            Column("Quantity", 1.0),
            Column("n", align="right"),
            Column("Mean", align="right"),
            Column("SD", align="right"),
            *(Column("Median" if p == 50 else f"P{fixed(p, 0)}", align="right") for p in _PERCENTS),
        ],
        [_quantity(one, scale_of(one.unit, unit)) for one in spreads if one.n],
    )
    reasons: dict[str, list[str]] = {}
    for one in spreads:
        for each in one.percentiles:
            if each.percent in _PERCENTS and each.reason:
                reasons.setdefault(each.reason, []).append(f"P{fixed(each.percent, 0)}")
    document.note(*(f"{', '.join(dict.fromkeys(which))}: {why}." for why, which in reasons.items()))


def _quantity(one: Spread, scale: Scale) -> list[str | tuple[str, str]]:
    name = f"{heading(NAMES[one.quantity])} ({scale.sign})"
    figures = [scale.number(one.mean), scale.number(one.sd)]
    return [name, count(one.n), *figures, *(_with_interval(_percentile(one, p), scale) for p in _PERCENTS)]


def _percentile(one: Spread, at: float) -> Percentile | None:
    return next((each for each in one.percentiles if each.percent == at), None)


def _with_interval(found: Percentile | None, scale: Scale) -> str | tuple[str, str]:
    if found is None:
        return NONE
    if found.low is None or found.high is None:
        return scale.number(found.value)
    return (scale.number(found.value), f"{scale.number(found.low)} to {scale.number(found.high)}")


def _sizes(document: Document, found: ScanStatistics, unit: Unit) -> None:
    """Errors of lengths and wheelbases against the makers', and what they say of the baseline."""
    small = SMALL[unit]
    kinds = (
        ("length", found.length_errors, found.length_ratio),
        ("wheelbase", found.wheelbase_errors, found.wheelbase_ratio),
    )
    there = [(name, groups, ratio) for name, groups, ratio in kinds if groups["overall"].n]
    if not there:
        document.words("No accepted vehicle has a known length or wheelbase, so neither is tested here.")
        return
    document.table(
        f"Errors (measured minus the makers’ sizes) in {_IN_WORDS[unit]}, with 95 % intervals.",
        [
            Column("Size", 1.0),
            Column("n", align="right"),
            *(Column(heading(word), 0.0, "right") for _, word in _ERROR_ROWS),
        ],
        [
            [
                heading(name) if group == "overall" else f"{heading(name)}, {GROUPS.get(group, group)}",
                count(one.n),
                *(_error(one, key, small) for key, _ in _ERROR_ROWS),
            ]
            for name, groups, _ in there
            for group, one in groups.items()
            if one.n and (group == "overall" or one.n < groups["overall"].n)
        ],
    )
    document.words(*(_ratio(name, ratio) for name, _, ratio in there))


def _heights(document: Document, heights: Sequence[ScannedHeights], unit: Unit) -> None:
    """Heights clicked in the strips; nothing where there are none."""
    if not heights:
        return
    scale = HEIGHT[unit]
    document.table(
        "Heights above the road of accepted scanned vehicles, by two clicks in the strip of camera 1, whose "
        "pose a rod gave; corrected by their insets, reviewed with the vehicle’s motion alone.",
        [
            Column("Target", 1.0),
            Column("n", align="right"),
            Column("Mean", 0.0, "right", scale.sign),
            Column("SD", 0.0, "right", scale.sign),
            Column("Median", 0.0, "right", scale.sign),
            Column("Typical U95", 0.0, "right", scale.sign),
        ],
        [
            [
                heading(TARGETS.get(one.target, one.target)),
                count(one.n),
                *(scale.number(value) for value in (one.mean_m, one.sd_m, one.median_m, one.U95_m)),
            ]
            for one in heights
        ],
    )


def _error(group: ErrorGroup, key: str, small: Scale) -> str | tuple[str, str]:
    value, within = group.figures[key], group.ci95[key]
    text = small.number(value, signed=key == "bias_m")
    if within is None:
        return text
    return (text, f"{small.number(within.low)} to {small.number(within.high)}")


def _ratio(name: str, ratio: Estimate) -> str:
    if ratio.value is None or ratio.u is None:
        return f"Baseline by {name}s: {ratio.reason}"
    said = f"Measured over true {name}s of {plural(ratio.n, 'vehicle', 'vehicles')}: {fixed(ratio.value, 4)}"
    end = ratio.warning or "The baseline agrees with them."
    return f"{said} ± {fixed(ratio.u, 4)} (k = 1). {end}"


def _vehicles(document: Document, table: Sequence[Row], unit: Unit) -> None:
    speed, way = scale_of("m/s", unit), scale_of("m", unit)
    acceleration = Scale(HEIGHT[unit].factor, f"{HEIGHT[unit].sign}/s²", 2)
    document.table(
        "Accepted vehicles in the layout of the paper’s Table I.",
        [
            Column("Vehicle", align="right"),
            Column("Speed", 0.0, "right", speed.sign),
            Column("Acceleration", 0.0, "right", acceleration.sign),
            Column("Length", 0.0, "right", way.sign),
            Column("True length", 0.0, "right", way.sign),
            Column("Length error", 0.0, "right", "%"),
            Column("Fit error", 0.0, "right", "%"),
        ],
        [_vehicle(one, speed, acceleration, way) for one in table[:MOST_VEHICLES]],
    )
    if len(table) > MOST_VEHICLES:
        document.note(f"The first {MOST_VEHICLES} of {count(len(table))}; scan_vehicles.csv has them all.")


def _vehicle(one: Row, speed: Scale, acceleration: Scale, way: Scale) -> list[str]:
    off = NONE
    if one.length_m is not None and one.true_length_m:
        off = fixed(100 * (one.length_m / one.true_length_m - 1), 1, signed=True)
    return [
        str(one.number),
        speed.number(one.speed_mps),
        acceleration.number(one.acceleration_mps2),
        way.number(one.length_m),
        way.number(one.true_length_m),
        off,
        NONE if one.fit_error_percent is None else fixed(one.fit_error_percent, 2),
    ]
