"""Values of the report about line scans: rigs, speeds, lengths, gaps, and the paper's Table I."""

from collections.abc import Mapping

from sightline.enums import KnownLength, LengthUnit
from sightline.export.report.facts import ReportFacts
from sightline.export.report.pictures import Pictures
from sightline.export.report.scan_figures import scale_of
from sightline.export.report.settable import Values
from sightline.export.report.words import QUANTITIES
from sightline.linescan.rig import RigEstimate
from sightline.scans.statistics.service import ScanStatistics, Spread
from sightline.statistics.errors import ErrorGroup

MOST_VEHICLES = 60
# The headway's figure is in the package alone: four fill two rows.
_DRAWN = ("scan-speed", "scan-length", "scan-time-gap", "scan-distance-gap")


def line_scans(facts: ReportFacts, pictures: Pictures) -> Values | None:
    """The whole part; None where the survey has no line scan."""
    scans, unit = facts.scans, facts.unit
    if scans is None:
        return None
    statistics = scans.statistics
    return {
        "methods": [{"method": method, "n": n} for method, n in scans.methods],
        "rigs": scans.rigs,
        "counted": statistics.counted,
        "spreads": [_spread(one, unit) for one in statistics.spreads],
        "figures": pictures.figures(_DRAWN) if statistics.counted["used"] else [],
        "sizes": _sizes(statistics),
        "references": statistics.references,
        "heights": scans.heights,
        "vehicles": statistics.table[:MOST_VEHICLES],
        "vehicles_total": len(statistics.table),
    }


def _spread(spread: Spread, unit: LengthUnit) -> Values:
    return {
        "quantity": spread.quantity,
        "scale": scale_of(spread.unit, unit),
        "n": spread.n,
        "mean": spread.mean,
        "sd": spread.sd,
        "percentiles": spread.percentiles,
    }


def _sizes(found: ScanStatistics) -> list[Values]:
    """Errors of lengths and wheelbases against the makers', and what they say of the baseline."""
    kinds: tuple[tuple[KnownLength, Mapping[str, ErrorGroup], RigEstimate], ...] = (
        ("length", found.length_errors, found.length_ratio),
        ("wheelbase", found.wheelbase_errors, found.wheelbase_ratio),
    )
    return [
        {"kind": kind, "name": QUANTITIES[kind], "groups": groups, "ratio": ratio}
        for kind, groups, ratio in kinds
        if groups["overall"].n
    ]
