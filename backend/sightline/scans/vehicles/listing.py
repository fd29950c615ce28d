"""Scans and their vehicles as they are shown: with gaps, errors against the catalogue, what is outdated."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from sightline.enums import KnownLength
from sightline.infra.database import Session
from sightline.linescan.parts import Gap, Rig
from sightline.scans.clock import Passing, ScanClock, passing_of
from sightline.scans.records import Scan, ScanMeasurement, ScanReview, ScanVehicle
from sightline.scans.references.records import StoredReference
from sightline.scans.references.service import beside_ours
from sightline.scans.references.store import standing_references, standing_references_of
from sightline.scans.store import get_scan
from sightline.scans.vehicles.measurement_store import scan_measurement_history
from sightline.scans.vehicles.motion import gaps_of, motion_of
from sightline.scans.vehicles.review_store import scan_reviews_of_vehicle
from sightline.scans.vehicles.store import get_scan_vehicle, list_scan_vehicles
from sightline.statistics.references import Agreement


@dataclass(frozen=True)
class ShownVehicle:
    """A vehicle with the gap before it (None: it is the first, or taken out) and when it passed (None: the
    recording's start is not confirmed, or the vehicle was never measured). `references`: what stands of what
    something else measured of it.
    """

    vehicle: ScanVehicle
    rig: Rig
    gap: Gap | None
    passing: Passing | None
    references: tuple[StoredReference, ...] = ()

    def agreement(self, reference: StoredReference) -> Agreement | None:
        """Our value against a reference; None where there is none."""
        measured = self.vehicle.measurement
        return beside_ours(None if measured is None else measured.values, reference.values)

    def error_m(self, of: KnownLength) -> float | None:
        """Measured minus the maker's length or wheelbase; None where either is missing."""
        values = self.vehicle.measurement and self.vehicle.measurement.values
        measured, true = getattr(values, f"{of}_m", None), getattr(self.vehicle, f"true_{of}_m")
        return None if measured is None or true is None else float(measured - true)


@dataclass(frozen=True)
class ShownDetail:
    """A vehicle with everything that was ever measured or said of it."""

    shown: ShownVehicle
    scan: Scan
    history: tuple[ScanMeasurement, ...]
    reviews: tuple[ScanReview, ...]


def vehicles_of(session: Session, scan_id: int) -> list[ShownVehicle]:
    """The vehicles of a scan in the order in which they passed, each with the gap before it."""
    return shown_vehicles(
        get_scan(session, scan_id),
        list_scan_vehicles(session, scan_id),
        standing_references(session, scan_id),
    )


def shown_vehicles(
    scan: Scan, vehicles: Sequence[ScanVehicle], references: Mapping[int, tuple[StoredReference, ...]]
) -> list[ShownVehicle]:
    """The same for vehicles that are at hand, in the order in which they passed; `references` by vehicle."""
    measured = (one.measurement for one in vehicles)
    motions = [None if one is None else (motion_of(one.values), one.values.rig) for one in measured]
    return [
        ShownVehicle(vehicle, scan.rig, gap, _passing(scan.clock, vehicle), references.get(vehicle.id, ()))
        for vehicle, gap in zip(vehicles, gaps_of(scan.rig, motions), strict=True)
    ]


def one_of(session: Session, vehicle_id: int) -> ShownVehicle:
    """One vehicle, its profile too, with the gap before it. Raises NotFound."""
    vehicle = get_scan_vehicle(session, vehicle_id, deleted=True)
    scan = get_scan(session, vehicle.scan_id)
    if vehicle.deleted:
        passing, given = _passing(scan.clock, vehicle), standing_references_of(session, vehicle_id)
        return ShownVehicle(vehicle, scan.rig, None, passing, given)
    by_id = {one.vehicle.id: one for one in vehicles_of(session, vehicle.scan_id)}
    return replace(by_id[vehicle_id], vehicle=vehicle)


def detail_of(session: Session, vehicle_id: int) -> ShownDetail:
    """One vehicle with all its revisions and verdicts. Raises NotFound."""
    found = one_of(session, vehicle_id)
    return ShownDetail(
        found,
        get_scan(session, found.vehicle.scan_id),
        scan_measurement_history(session, vehicle_id),
        scan_reviews_of_vehicle(session, vehicle_id),
    )


def _passing(clock: ScanClock | None, vehicle: ScanVehicle) -> Passing | None:
    if clock is None or vehicle.measurement is None:
        return None
    values = vehicle.measurement.values
    return passing_of(clock, values.front_line_1, values.speed_mps, values.u_length_m, values.rig)
