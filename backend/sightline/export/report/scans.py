"""Values of the report about line scans: rigs, speeds, lengths, gaps, and the paper's Table I."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sightline.enums import KnownLength, LengthUnit, ReferenceQuantity
from sightline.export.report.facts import ReportFacts, RigFacts
from sightline.export.report.pictures import Pictures
from sightline.export.report.results import percentile_interval, without_interval
from sightline.export.report.said import Called, said, told
from sightline.export.report.scan_figures import NAMES, scale_of
from sightline.export.report.settable import Json, Values
from sightline.export.report.units import HEIGHT, SMALL, SPEED, Scale, fixed, percent
from sightline.export.report.words import GROUPS, LIGHTING, SOURCES, target_words
from sightline.linescan.rig import RigEstimate
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.service import ReferenceGroup, ScanRow, ScanStatistics, Spread
from sightline.statistics.distributions import Percentile
from sightline.statistics.errors import ErrorGroup

MOST_VEHICLES = 60
# The headway's figure is in the package alone: four fill two rows.
_DRAWN = ("scan-speed", "scan-length", "scan-time-gap", "scan-distance-gap")
_SIZES_KEYS: dict[KnownLength, str] = {"length": "report-length", "wheelbase": "report-wheelbase"}
_SIZES = Called(_SIZES_KEYS)
_QUANTITIES_KEYS: dict[ReferenceQuantity, str] = {
    "speed": "report-speed",
    "length": "report-length",
    "wheelbase": "report-wheelbase",
}
_QUANTITIES = Called(_QUANTITIES_KEYS)
_PERCENTS = (15.0, 50.0, 85.0)
_ERROR_FIGURES = ("bias_m", "mae_m", "rmse_m", "sd_m")


def line_scans(facts: ReportFacts, pictures: Pictures) -> Values | None:
    """The whole part; None where the survey has no line scan."""
    scans, unit = facts.scans, facts.unit
    if scans is None:
        return None
    found = scans.statistics
    return {
        "methods": [{"method": method, "n": n} for method, n in scans.methods],
        "rigs": [_rig(rig, HEIGHT[unit]) for rig in scans.rigs],
        "counted": found.counted,
        "speed": _speed_in_short(found, unit),
        "quantities": _quantities(found.spreads, unit),
        "figures": pictures.figures(_DRAWN) if found.counted["used"] else [],
        "sizes": _sizes(found, SMALL[unit]),
        "references": [_reference(one, unit) for one in found.references],
        "heights": [_height(heights, HEIGHT[unit]) for heights in scans.heights],
        "vehicles": {
            "total": len(found.table),
            "rows": [_vehicle(row, unit) for row in found.table[:MOST_VEHICLES]],
        },
    }


def _rig(rig: RigFacts, height: Scale) -> Values:
    baseline, lane = Scale(height.factor, "", 4), Scale(height.factor, "", 2)
    given = rig.misalignment_px
    return {
        "name": rig.name,
        "video": rig.source == "video",
        "lighting": LIGHTING.get(rig.lighting, rig.lighting),
        "lines": rig.lines,
        "baseline": baseline.number(rig.baseline_m),
        "u_baseline": baseline.number(rig.u_baseline_m),
        "line_rate": fixed(rig.line_rate_hz, 1),
        "u_line_rate_ppm": fixed(1e6 * rig.u_line_rate_ratio, 0),
        "divergence": fixed(1e3 * rig.divergence_rad, 2),
        "u_divergence": fixed(1e3 * rig.u_divergence_rad, 2),
        "distance": lane.number(rig.distance_m),
        "misalignment": None if given is None else fixed(given, 2),
        "u_misalignment": fixed(rig.u_misalignment_px, 2),
    }


def _speed_in_short(found: ScanStatistics, unit: LengthUnit) -> Values | None:
    speed = next(one for one in found.spreads if one.quantity == "speed")
    scale = scale_of(speed.unit, unit)
    at = _percentile(speed, 85.0)
    if at is None or speed.mean is None:
        return None
    return {
        "unit": scale.sign,
        "mean": scale.number(speed.mean),
        "p85": scale.number(at.value),
        "ci95": percentile_interval(at, scale),
        "reason": told(at.reason or "") or None,
    }


def _quantities(spreads: Sequence[Spread], unit: LengthUnit) -> Values:
    shown = [each for one in spreads for each in one.percentiles if each.percent in _PERCENTS]
    return {
        "percents": [fixed(percent, 0) for percent in _PERCENTS],
        "rows": [_quantity(one, scale_of(one.unit, unit)) for one in spreads if one.n],
        "without_interval": without_interval(shown),
    }


def _quantity(spread: Spread, scale: Scale) -> Values:
    return {
        "name": NAMES[spread.quantity],
        "unit": scale.sign,
        "n": spread.n,
        "mean": scale.number(spread.mean),
        "sd": scale.number(spread.sd),
        "percentiles": [_with_interval(_percentile(spread, percent), scale) for percent in _PERCENTS],
    }


def _percentile(spread: Spread, at: float) -> Percentile | None:
    return next((each for each in spread.percentiles if each.percent == at), None)


def _with_interval(found: Percentile | None, scale: Scale) -> Values | None:
    if found is None:
        return None
    return {"value": scale.number(found.value), "ci95": percentile_interval(found, scale)}


def _sizes(found: ScanStatistics, small: Scale) -> list[Json]:
    """Errors of lengths and wheelbases against the makers', and what they say of the baseline."""
    kinds: tuple[tuple[KnownLength, Mapping[str, ErrorGroup], RigEstimate], ...] = (
        ("length", found.length_errors, found.length_ratio),
        ("wheelbase", found.wheelbase_errors, found.wheelbase_ratio),
    )
    return [_size(kind, groups, ratio, small) for kind, groups, ratio in kinds if groups["overall"].n]


def _size(kind: KnownLength, groups: Mapping[str, ErrorGroup], ratio: RigEstimate, small: Scale) -> Values:
    known = ratio.value is not None and ratio.u is not None
    return {
        "kind": kind,
        "name": _SIZES[kind],
        "groups": [
            {
                "name": None if group == "overall" else GROUPS.get(group, group),
                "n": one.n,
                "figures": {key: _error(one, key, small) for key in _ERROR_FIGURES},
            }
            for group, one in groups.items()
            if one.n and (group == "overall" or one.n < groups["overall"].n)
        ],
        "n": ratio.n,
        "ratio": fixed(ratio.value, 4) if known and ratio.value is not None else None,
        "u_ratio": fixed(ratio.u, 4) if known and ratio.u is not None else None,
        "reason": told(ratio.reason or "") or None,
        "warning": told(ratio.warning or "") or None,
    }


def _reference(group: ReferenceGroup, unit: LengthUnit) -> Values:
    """What a quantity of ours is apart from what one source says (None: from all)."""
    errors = group.errors
    speed = SPEED[unit]
    scale = Scale(speed.factor, speed.sign, 2) if group.quantity == "speed" else SMALL[unit]
    return {
        "name": _QUANTITIES[group.quantity],
        "source": said("report-all-sources") if group.source is None else SOURCES[group.source],
        "unit": scale.sign,
        "n": errors.n,
        "bias": scale.number(errors.mean, signed=True),
        "sd": scale.number(errors.sd),
        "rmse": scale.number(errors.rmse),
        "within": errors.within,
        "share": percent(errors.share_within),
        "low": fixed(100 * errors.share_low, 1),
        "high": percent(errors.share_high),
    }


def _error(group: ErrorGroup, key: str, small: Scale) -> Values:
    value, within = group.figures[key], group.ci95[key]
    interval: Json = (
        None if within is None else {"low": small.number(within.low), "high": small.number(within.high)}
    )
    return {"value": small.number(value, signed=key == "bias_m"), "ci95": interval}


def _height(heights: ScannedHeights, scale: Scale) -> Values:
    return {
        "target": target_words(heights.target),
        "n": heights.n,
        "waiting": heights.to_review,
        "mean": scale.number(heights.mean_m),
        "sd": scale.number(heights.sd_m),
        "median": scale.number(heights.median_m),
        "u95": scale.number(heights.U95_m),
    }


def _vehicle(row: ScanRow, unit: LengthUnit) -> Values:
    speed, length = scale_of("m/s", unit), scale_of("m", unit)
    acceleration = Scale(HEIGHT[unit].factor, "", 2)
    off = None
    if row.length_m is not None and row.true_length_m:
        off = fixed(100 * (row.length_m / row.true_length_m - 1), 1, signed=True)
    return {
        "number": row.number,
        "speed": speed.number(row.speed_mps),
        "acceleration": acceleration.number(row.acceleration_mps2),
        "length": length.number(row.length_m),
        "true_length": length.number(row.true_length_m),
        "length_error_percent": off,
        "fit_error_percent": None if row.fit_error_percent is None else fixed(row.fit_error_percent, 2),
    }
