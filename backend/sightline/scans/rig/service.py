"""What the traffic of a scan says of its rig, beside what was entered; nothing is changed by asking."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, get_args

from pydantic import Field

from sightline.enums import KnownLength
from sightline.infra.database import Session
from sightline.linescan.rig import (
    RigEstimate,
    at_lane,
    baseline_of,
    baseline_ratio,
    common_baseline_of,
    gain,
    misalignment,
    rig_from,
    u_without_baseline_m,
)
from sightline.messages.said import Said
from sightline.scans.records import Scan, ScanValues, ScanVehicle
from sightline.scans.store import get_scan
from sightline.scans.vehicles.store import list_scan_vehicles

_GIVEN = Said("rig-misalignment-given")


@dataclass(frozen=True)
class ImpliedBaseline:
    """The baseline that makes known sizes come out right; numbers are None where `reason` says why.

    `ratio`: measured over true with the baseline in force. `differs`: by more than twice its uncertainty.
    """

    of: KnownLength
    ratio: RigEstimate
    baseline_m: float | None
    u_baseline_m: float | None
    differs: Annotated[
        bool, Field(description="From the baseline in force by more than twice its uncertainty.")
    ]
    words: Said | None


@dataclass(frozen=True)
class RigOfTraffic:
    """Misalignment in px, gain of camera 2 over camera 1, both baselines, and what the last search saw."""

    misalignment: RigEstimate
    gain: RigEstimate
    baselines: tuple[ImpliedBaseline, ...]
    order: Said | None


def rig_of_traffic(session: Session, scan_id: int) -> RigOfTraffic:
    """Estimates from the scan's standing vehicles that nobody rejected. Raises NotFound."""
    scan = get_scan(session, scan_id)
    vehicles = [one for one in list_scan_vehicles(session, scan_id) if _counts(one)]
    values = [one.measurement.values for one in vehicles if one.measurement is not None]
    return RigOfTraffic(
        _misalignment(values),
        gain(values),
        tuple(_implied(scan, vehicles, of) for of in reversed(get_args(KnownLength))),
        _order(scan),
    )


def _counts(one: ScanVehicle) -> bool:
    measured = one.measurement
    return measured is not None and measured.values.status == "ok" and measured.review.verdict != "rejected"


def _misalignment(values: Sequence[ScanValues]) -> RigEstimate:
    free = [one for one in values if one.rig["misalignment_px"] is None]
    if values and not free:
        return RigEstimate(None, None, None, 0, _GIVEN)
    return misalignment(free)


def _implied(scan: Scan, vehicles: Sequence[ScanVehicle], of: KnownLength) -> ImpliedBaseline:
    """Sizes go with the baseline at the vehicle that they were measured with; each is brought to today's."""
    in_force = baseline_of(at_lane(scan.rig, None))[0]
    rows = []
    for vehicle in vehicles:
        assert vehicle.measurement is not None
        values = vehicle.measurement.values
        size, true = getattr(values, f"{of}_m"), getattr(vehicle, f"true_{of}_m")
        if size is None or true is None:
            continue
        baseline_m, u_baseline_m = common_baseline_of(rig_from(values.rig))
        u = u_without_baseline_m(size, getattr(values, f"u_{of}_m"), baseline_m, u_baseline_m)
        scale = baseline_of(at_lane(scan.rig, values.lane, values.direction))[0] / baseline_m
        rows.append((scale * size, scale * u, true, getattr(vehicle, f"u_true_{of}_m") or 0.0))
    ratio = baseline_ratio(of, *([row[k] for row in rows] for k in range(4)))
    if ratio.value is None or ratio.u is None:
        return ImpliedBaseline(
            of=of, ratio=ratio, baseline_m=None, u_baseline_m=None, differs=False, words=ratio.reason
        )
    implied, opening = in_force / ratio.value, in_force - scan.rig.baseline_m
    u = implied * ratio.u / ratio.value
    return ImpliedBaseline(
        of=of,
        ratio=ratio,
        baseline_m=implied - opening,
        u_baseline_m=u,
        differs=ratio.warning is not None,
        words=ratio.warning or ratio.agrees,
    )


def _order(scan: Scan) -> Said | None:
    """Whether the strips are swapped, as the last search told it."""
    if scan.run is None:
        return None
    return next((one for one in scan.run.warnings if one.code == "scan-run-swapped"), None)
