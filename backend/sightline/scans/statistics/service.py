"""What a survey's scanned vehicles say together, from the database or from a package: pure of where they are.

Errors of length and wheelbase against the catalogue, what known sizes say of the baseline, distributions of
speeds, lengths and gaps, the layout of the paper's Table I.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from math import hypot
from typing import Any, get_args

import numpy as np

from sightline.arrays import Floats
from sightline.enums import KnownLength, ReferenceQuantity, ReferenceSource, ScanDirection, ScanVehicleState
from sightline.infra.by_name import filled_from
from sightline.linescan.clock import since_start_s
from sightline.linescan.parts import Rig, front_seen, rear_seen
from sightline.linescan.rig import (
    RigEstimate,
    baseline_of,
    baseline_ratio,
    shared_errors_m,
    speed_ratio_of,
    u_without_baseline_m,
)
from sightline.messages.said import Said
from sightline.recordings.filming import FilmedWithin
from sightline.scans.references.records import MEASURED, UNITS, ReferenceValues
from sightline.scans.references.service import LOOKED_AT, compare_with_reference
from sightline.statistics.distributions import (
    Density,
    Ecdf,
    Percentile,
    density,
    ecdf,
    percentiles,
    sorted_values,
)
from sightline.statistics.errors import ErrorGroup, error_table
from sightline.statistics.references import ReferenceErrors, reference_errors
from sightline.statistics.runs import Run, RunsTogether, runs_together

#: Of a motion and of the gap before it, what the statistics use.
MOTION = (
    "speed_mps",
    "u_speed_mps",
    "acceleration_mps2",
    "length_m",
    "u_length_m",
    "wheelbase_m",
    "u_wheelbase_m",
    "fit_error_percent",
)
GAPS = ("time_gap_s", "distance_gap_m", "headway_s")
#: What the maker says of it, and where a vehicle has that.
KNOWN_SIZES = {
    "length_m": "true_length_m",
    "u_length_m": "u_true_length_m",
    "wheelbase_m": "true_wheelbase_m",
    "u_wheelbase_m": "u_true_wheelbase_m",
}
# What is distributed: of which value, and its unit.
_QUANTITIES = {
    "speed": ("speed_mps", "m/s"),
    "length": ("length_m", "m"),
    "time_gap": ("time_gap_s", "s"),
    "distance_gap": ("distance_gap_m", "m"),
    "headway": ("headway_s", "s"),
}


@dataclass(frozen=True)
class VehicleMotion:
    """A vehicle as the statistics see it: its standing motion, the gap before it, what is known of it.

    `state`: to_review, accepted, rejected, not_measurable; `measured`: it has a motion. `rig`: the planes
    that this motion was computed with, and their `line_rate_hz`; `rig_baseline_m`: their distance at the
    vehicle; `rig_errors_m`: what of it all vehicles share (`shared_errors_m`). None where there is no value.
    `known`: the maker's sizes. `since_s`, `occupied_s`: when it reached camera 1 after line 0, and how long
    it stood before it (None: its rear was not seen); `front_seen`: False of one in view at line 0,
    `told_before`: where it is of the recording before;
    `filmed_at`: the first by the clocks of the place (ISO 8601), empty where its recording has none;
    `rig_ratio`: what the rig gives to every speed alike, a share of it (k = 1). `run_of`: the car of which it
    is one run; `references`: what stands of what something else measured. `direction`: which camera it
    reached first.
    """

    vehicle_id: int
    scan_id: int
    number: int
    state: str
    measured: bool
    lighting: str
    values: dict[str, float | None] = field(default_factory=dict)
    known: dict[str, float | None] = field(default_factory=dict)
    rig: tuple[float, ...] = ()
    line_rate_hz: float | None = None
    rig_baseline_m: float = 1.0
    rig_errors_m: tuple[float, float] = (0.0, 0.0)
    status: str = "ok"
    reason: Said | None = None
    since_s: float | None = None
    occupied_s: float | None = None
    front_seen: bool = True
    told_before: bool = False
    filmed_at: str = ""
    u_filmed_at_s: float | None = None
    rig_ratio: float = 0.0
    run_of: str | None = None
    references: tuple[ReferenceValues, ...] = ()
    direction: ScanDirection | None = None
    lane: str | None = None
    axles: int | None = None

    def u_alone_m(self, name: str) -> float:
        """The u of a size of it without what the rig gives to all vehicles alike."""
        size_m, u_baseline_m = self.values.get(name) or 0.0, hypot(*self.rig_errors_m)
        return u_without_baseline_m(size_m, self.values.get(f"u_{name}"), self.rig_baseline_m, u_baseline_m)


def when_passed(rig: Rig, front_line_1: float, rear_line_1: float, reason: Said | None) -> dict[str, Any]:
    """When a vehicle passed, and what the rig that it was measured with gives to its motion and to all others
    alike, by name.

    `reason`: why it has no motion; where its rear was not seen, it is not known how long it stood there.
    """
    occupied_s = (rear_line_1 - front_line_1) / rig.line_rate_hz
    of_rig = rig.baseline_m, rig.u_baseline_m, rig.divergence_rad, rig.u_divergence_rad
    return {
        "rig": (*of_rig, rig.baseline_correlation),
        "line_rate_hz": rig.line_rate_hz,
        "rig_baseline_m": baseline_of(rig)[0],
        "rig_errors_m": shared_errors_m(rig),
        "rig_ratio": speed_ratio_of(rig),
        "since_s": since_start_s(front_line_1, rig.line_rate_hz),
        "occupied_s": occupied_s if rear_seen(reason) else None,
        "front_seen": front_seen(reason, front_line_1),
    }


@dataclass(frozen=True)
class ReferenceGroup:
    """Ours minus the references of one source (None: of all), in `unit`."""

    quantity: ReferenceQuantity
    source: ReferenceSource | None
    unit: str
    errors: ReferenceErrors


@dataclass(frozen=True)
class CarRuns:
    """The runs of one car in the order in which they stand in the survey, and what each size says together.

    `speed_mean_mps`, `speed_sd_mps`: runs differ in speed, so that is told and not tested. `sizes` has no
    wheelbase where none was clicked.
    """

    car: str
    runs: tuple[ScanRow, ...]
    speed_mean_mps: float
    speed_sd_mps: float | None
    sizes: dict[KnownLength, RunsTogether]


@dataclass(frozen=True, eq=False)
class Spread:
    """The distribution of one quantity; without values all parts are empty."""

    quantity: str
    unit: str
    n: int
    mean: float | None
    sd: float | None
    ecdf: Ecdf | None
    density: Density | Said
    percentiles: list[Percentile]


@dataclass(frozen=True)
class ScanRow:
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
    reason: Said | None
    references: tuple[ReferenceValues, ...]


@dataclass(frozen=True, eq=False)
class ScanStatistics:
    """Everything that is shown; `counted`: vehicles by what was done with them, and those `without_time`,
    which are left out where days or hours of filming are asked for.
    """

    scans: int
    counted: dict[str, int]
    length_errors: dict[str, ErrorGroup]
    wheelbase_errors: dict[str, ErrorGroup]
    length_ratio: RigEstimate
    wheelbase_ratio: RigEstimate
    spreads: tuple[Spread, ...]
    table: tuple[ScanRow, ...]
    references: tuple[ReferenceGroup, ...]
    cars: tuple[CarRuns, ...]


def statistics_of_seen(
    vehicles: Sequence[VehicleMotion], *, accepted_only: bool, filmed: FilmedWithin = FilmedWithin()
) -> ScanStatistics:
    """Statistics of these vehicles; rejected ones never count, unreviewed ones where asked for, none that was
    not `filmed` within those days and hours.

    A gap counts where the vehicle behind it does.
    """
    within = [one for one in vehicles if filmed.holds(one.filmed_at)]
    chosen = [one for one in within if counts(one, accepted_only)]
    states = [one.state for one in within]
    counted = {
        "vehicles": len(within),
        "used": len(chosen),
        "without_time": sum(not one.filmed_at for one in vehicles) if filmed.limits_time else 0,
        **{name: states.count(name) for name in get_args(ScanVehicleState)},
    }
    return ScanStatistics(
        scans=len({one.scan_id for one in within}),
        counted=counted,
        length_errors=_errors(chosen, "length_m"),
        wheelbase_errors=_errors(chosen, "wheelbase_m"),
        length_ratio=_ratio(chosen, "length"),
        wheelbase_ratio=_ratio(chosen, "wheelbase"),
        spreads=tuple(
            _spread(name, unit, [v for one in chosen if (v := one.values.get(of)) is not None])
            for name, (of, unit) in _QUANTITIES.items()
        ),
        table=tuple(_row_of_vehicle(one) for one in chosen),
        references=tuple(_references(chosen)),
        cars=tuple(_cars(chosen)),
    )


def counts(one: VehicleMotion, accepted_only: bool) -> bool:
    """Whether a vehicle's motion counts."""
    return one.measured and one.state in (("accepted",) if accepted_only else ("accepted", "to_review"))


def _spread(name: str, unit: str, values: Sequence[float]) -> Spread:
    ordered: Floats = sorted_values(np.array(values, dtype=np.float64))
    n = len(ordered)
    return Spread(
        quantity=name,
        unit=unit,
        n=n,
        mean=float(ordered.mean()) if n else None,
        sd=float(ordered.std(ddof=1)) if n > 1 else None,
        ecdf=ecdf(ordered),
        density=density(ordered),
        percentiles=percentiles(ordered),
    )


def _pairs(chosen: Iterable[VehicleMotion], name: str) -> list[tuple[VehicleMotion, float, float]]:
    """Vehicles of which a length was measured and is known, with both, metres."""
    both = ((one, one.values.get(name), one.known.get(name)) for one in chosen)
    return [(one, value, true) for one, value, true in both if value is not None and true is not None]


def _errors(chosen: Sequence[VehicleMotion], name: str) -> dict[str, ErrorGroup]:
    pairs = _pairs(chosen, name)
    measured, true = [value for _, value, _ in pairs], [true for *_, true in pairs]
    return error_table(measured, true, [one.lighting for one, *_ in pairs], "none")


def _ratio(chosen: Sequence[VehicleMotion], of: KnownLength) -> RigEstimate:
    """Measured over true, which tells of a wrong baseline; u of a measured one without the baseline's."""
    name = f"{of}_m"
    rows = [
        (value, one.u_alone_m(name), true, one.known.get(f"u_{name}") or 0.0)
        for one, value, true in _pairs(chosen, name)
    ]
    return baseline_ratio(of, *([row[k] for row in rows] for k in range(4)))


def _row_of_vehicle(vehicle: VehicleMotion) -> ScanRow:
    motion = ("speed_mps", "acceleration_mps2", "length_m", "fit_error_percent")
    values = {name: vehicle.values.get(name) for name in motion}
    return filled_from(ScanRow, vehicle, true_length_m=vehicle.known.get("length_m"), **values)


def _references(chosen: Sequence[VehicleMotion]) -> Iterator[ReferenceGroup]:
    """Quantity by quantity: each source that says something of it, then all together where there are more."""
    for quantity in get_args(ReferenceQuantity):
        agreements = [
            (given.source, apart)
            for vehicle in chosen
            for given in vehicle.references
            if given.quantity == quantity
            and (apart := compare_with_reference(_compared(vehicle), given)) is not None
        ]
        there = {by for by, _ in agreements}
        together = (None,) if len(there) > 1 else ()
        for source in (*(one for one in get_args(ReferenceSource) if one in there), *together):
            errors = reference_errors([apart for by, apart in agreements if source in (by, None)])
            if errors is not None:
                yield ReferenceGroup(quantity, source, UNITS[quantity], errors)


def _compared(one: VehicleMotion) -> dict[str, float | str | None]:
    return {**{name: one.values.get(name) for name in LOOKED_AT}, "status": one.status}


def _cars(chosen: Sequence[VehicleMotion]) -> Iterator[CarRuns]:
    """Every car of which there are runs, by name."""
    by_name: dict[str, list[VehicleMotion]] = {}
    for one in chosen:
        if one.run_of:
            by_name.setdefault(one.run_of, []).append(one)
    for car, runs in sorted(by_name.items()):
        speeds = np.array([one.values["speed_mps"] for one in runs], dtype=np.float64)
        sizes = {size: runs_together(_runs(runs, MEASURED[size])) for size in get_args(KnownLength)}
        yield CarRuns(
            car=car,
            runs=tuple(_row_of_vehicle(one) for one in runs),
            speed_mean_mps=float(speeds.mean()),
            speed_sd_mps=float(speeds.std(ddof=1)) if len(runs) > 1 else None,
            sizes={size: found for size, found in sizes.items() if found is not None},
        )


def _runs(vehicles: Sequence[VehicleMotion], name: str) -> list[Run]:
    """A size of each run; the errors of baseline and divergence are those of all runs with this rig, in
    whichever lane.

    They are a share of the car's one size, here the runs' median: taken of each observed size, the smaller
    ones would weigh more, and the mean could lie below every run (Peelle's puzzle).
    """
    sized = [
        (one, value)
        for one in vehicles
        if (value := one.values.get(name)) is not None and one.values.get(f"u_{name}") is not None
    ]
    middle = float(np.median([value for _, value in sized])) if sized else 0.0
    out = []
    for one, value in sized:
        shared = tuple(middle * error / one.rig_baseline_m for error in one.rig_errors_m)
        out.append(Run(value, one.u_alone_m(name), shared, one.rig))
    return out
