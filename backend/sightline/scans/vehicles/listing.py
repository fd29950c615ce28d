"""Scans and their vehicles as they are shown: with gaps, errors against the catalogue, what is outdated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sightline.enums import JsonObject
from sightline.infra.database import Session
from sightline.linescan.parts import Gap
from sightline.scans.records import Scan, ScanMeasurement, ScanReview, ScanVehicle
from sightline.scans.store import get_scan, rig_columns
from sightline.scans.vehicles.measurement_store import scan_measurement_history
from sightline.scans.vehicles.motion import gaps_of
from sightline.scans.vehicles.review_store import scan_reviews_of_vehicle
from sightline.scans.vehicles.store import get_scan_vehicle, list_scan_vehicles


@dataclass(frozen=True)
class ShownVehicle:
    """A vehicle with the gap before it (None: it is the first, or taken out)."""

    vehicle: ScanVehicle
    rig: JsonObject
    gap: Gap | None

    @property
    def length_error_m(self) -> float | None:
        """Measured minus the maker's length; None where either is missing."""
        values = self.vehicle.measurement and self.vehicle.measurement.values
        return _difference(values.length_m if values else None, self.vehicle.true_length_m)

    @property
    def wheelbase_error_m(self) -> float | None:
        """Measured minus the maker's wheelbase; None where either is missing."""
        values = self.vehicle.measurement and self.vehicle.measurement.values
        return _difference(values.wheelbase_m if values else None, self.vehicle.true_wheelbase_m)


@dataclass(frozen=True)
class ShownDetail:
    """A vehicle with everything that was ever measured or said of it."""

    shown: ShownVehicle
    scan: Scan
    history: tuple[ScanMeasurement, ...]
    reviews: tuple[ScanReview, ...]


def vehicles_of(session: Session, scan_id: int) -> list[ShownVehicle]:
    """The vehicles of a scan in the order in which they passed, each with the gap before it."""
    return shown(get_scan(session, scan_id), list_scan_vehicles(session, scan_id))


def shown(scan: Scan, found: Sequence[ScanVehicle]) -> list[ShownVehicle]:
    """The same for vehicles that are at hand, in the order in which they passed."""
    rig = rig_columns(scan.rig)
    gaps = gaps_of(scan.rig, found)
    return [ShownVehicle(vehicle, rig, gap) for vehicle, gap in zip(found, gaps, strict=True)]


def one_of(session: Session, vehicle_id: int) -> ShownVehicle:
    """One vehicle, its profile too, with the gap before it. Raises NotFound."""
    vehicle = get_scan_vehicle(session, vehicle_id, deleted=True)
    scan = get_scan(session, vehicle.scan_id)
    if vehicle.deleted:
        return ShownVehicle(vehicle, rig_columns(scan.rig), None)
    neighbours = list_scan_vehicles(session, vehicle.scan_id)
    by_id = {one.vehicle.id: one for one in shown(scan, neighbours)}
    return ShownVehicle(vehicle, rig_columns(scan.rig), by_id[vehicle_id].gap)


def detail_of(session: Session, vehicle_id: int) -> ShownDetail:
    """One vehicle with all its revisions and verdicts. Raises NotFound."""
    found = one_of(session, vehicle_id)
    return ShownDetail(
        found,
        get_scan(session, found.vehicle.scan_id),
        scan_measurement_history(session, vehicle_id),
        scan_reviews_of_vehicle(session, vehicle_id),
    )


def _difference(measured: float | None, true: float | None) -> float | None:
    return None if measured is None or true is None else measured - true
