"""Statistics of a survey's line scans: errors against the catalogue, speeds, gaps, the paper's layout."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import hypot

import numpy as np
from sqlalchemy.orm import Session

from backend.linescan.rig import Estimate, baseline_ratio
from backend.statistics.distributions import (
    Density,
    Ecdf,
    Floats,
    Percentile,
    density,
    ecdf,
    percentiles,
    sorted_values,
)
from backend.statistics.errors import ErrorGroup, error_table
from backend.storage import scans, scans_vehicles
from backend.storage.scans_records import Scan
from backend.work.scanning_list import ShownVehicle, shown

#: What is distributed: its unit.
QUANTITIES = {"speed": "m/s", "length": "m", "time_gap": "s", "distance_gap": "m", "headway": "s"}


@dataclass(frozen=True, eq=False)
class Spread:
    """The distribution of one quantity; without values all parts are empty."""

    quantity: str
    unit: str
    n: int
    mean: float | None
    sd: float | None
    ecdf: Ecdf | None
    density: Density | str
    percentiles: list[Percentile]


@dataclass(frozen=True)
class Row:
    """A vehicle in the layout of the paper's Table I."""

    vehicle_id: int
    scan_id: int
    number: int
    speed_mps: float | None
    acceleration_mps2: float | None
    length_m: float | None
    true_length_m: float | None
    fit_error_percent: float | None
    status: str
    reason: str | None


@dataclass(frozen=True, eq=False)
class ScanStatistics:
    """Everything that is shown; `counted`: vehicles by what was done with them."""

    scans: int
    counted: dict[str, int]
    length_errors: dict[str, ErrorGroup]
    wheelbase_errors: dict[str, ErrorGroup]
    length_ratio: Estimate
    wheelbase_ratio: Estimate
    spreads: tuple[Spread, ...]
    table: tuple[Row, ...]


def scan_statistics(session: Session, survey_id: int, *, accepted_only: bool) -> ScanStatistics:
    """Statistics of a survey's line scans; rejected vehicles never count, unreviewed ones where asked for.

    A gap counts where the vehicle behind it does.
    """
    found = [
        (scan, one)
        for scan in scans.list_for_survey(session, survey_id)
        for one in shown(scan, scans_vehicles.list_for_scan(session, scan.id))
    ]
    chosen = [(scan, one) for scan, one in found if _counts(one, accepted_only)]
    states: list[str] = [one.vehicle.state for _, one in found]
    names = ("to_review", "accepted", "rejected", "not_measurable")
    counted = {"vehicles": len(found), "used": len(chosen), **{name: states.count(name) for name in names}}
    return ScanStatistics(
        scans=len({scan.id for scan, _ in found}),
        counted=counted,
        length_errors=_errors(chosen, "length_m"),
        wheelbase_errors=_errors(chosen, "wheelbase_m"),
        length_ratio=_ratio(chosen, "length_m"),
        wheelbase_ratio=_ratio(chosen, "wheelbase_m"),
        spreads=tuple(_spread(name, unit, _values(chosen, name)) for name, unit in QUANTITIES.items()),
        table=tuple(_row(one) for _, one in chosen),
    )


Chosen = Sequence[tuple[Scan, ShownVehicle]]


def _counts(one: ShownVehicle, accepted_only: bool) -> bool:
    measured = one.vehicle.measurement
    if measured is None or measured.values.status != "ok":
        return False
    verdict = measured.review.verdict
    return verdict == "accepted" if accepted_only else verdict != "rejected"


def _values(chosen: Chosen, name: str) -> list[float]:
    return list(_present(_value(one, name) for _, one in chosen))


def _value(one: ShownVehicle, name: str) -> float | None:
    if name in ("speed", "length"):
        measured = one.vehicle.measurement
        if measured is None:
            return None
        return measured.values.speed_mps if name == "speed" else measured.values.length_m
    if one.gap is None:
        return None
    gap = {"time_gap": one.gap.time_gap_s, "distance_gap": one.gap.distance_gap_m}
    return gap.get(name, one.gap.headway_s)


def _present(values: Iterable[float | None]) -> Iterable[float]:
    return (value for value in values if value is not None)


def _spread(name: str, unit: str, values: Sequence[float]) -> Spread:
    ordered: Floats = sorted_values(np.array(values, dtype=np.float64))
    n = len(ordered)
    return Spread(
        name,
        unit,
        n,
        float(ordered.mean()) if n else None,
        float(ordered.std(ddof=1)) if n > 1 else None,
        ecdf(ordered),
        density(ordered),
        percentiles(ordered),
    )


@dataclass(frozen=True)
class _Pair:
    """A measured and a true length with their uncertainties, and the lighting."""

    measured_m: float
    u_measured_m: float
    true_m: float
    u_true_m: float
    lighting: str


def _pairs(chosen: Chosen, name: str) -> list[_Pair]:
    """Vehicles that have both; the measured one's uncertainty without the baseline's, which is common."""
    out = []
    for scan, one in chosen:
        vehicle, measured = one.vehicle, one.vehicle.measurement
        true = getattr(vehicle, f"true_{name}")
        value = getattr(measured.values, name) if measured else None
        if measured is None or true is None or value is None:
            continue
        u = getattr(measured.values, f"u_{name}") or 0.0
        common = value * measured.values.rig["u_baseline_m"] / measured.values.rig["baseline_m"]
        alone = max(u**2 - common**2, 0.0) ** 0.5
        lighting = vehicle.lighting or scan.lighting or "unknown"
        out.append(_Pair(value, alone, true, getattr(vehicle, f"u_true_{name}") or 0.0, lighting))
    return out


def _errors(chosen: Chosen, name: str) -> dict[str, ErrorGroup]:
    pairs = _pairs(chosen, name)
    measured, true = [one.measured_m for one in pairs], [one.true_m for one in pairs]
    return error_table(measured, true, [one.lighting for one in pairs], "none")


def _ratio(chosen: Chosen, name: str) -> Estimate:
    """Measured over true, which tells of a wrong baseline."""
    pairs = _pairs(chosen, name)
    least = 1e-3  # lengths without any uncertainty would outweigh all others
    return baseline_ratio(
        [one.measured_m for one in pairs],
        [hypot(one.u_measured_m, least) for one in pairs],
        [one.true_m for one in pairs],
        [one.u_true_m for one in pairs],
    )


def _row(one: ShownVehicle) -> Row:
    vehicle, measured = one.vehicle, one.vehicle.measurement
    assert measured is not None
    values = measured.values
    return Row(
        vehicle.id,
        vehicle.scan_id,
        vehicle.number,
        values.speed_mps,
        values.acceleration_mps2,
        values.length_m,
        vehicle.true_length_m,
        values.fit_error_percent,
        values.status,
        values.reason,
    )
