"""Reading a height's whole history, and what is told of the vehicles of heights."""

from collections.abc import Collection

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.measurements.query import reviews_of_series
from sightline.measurements.store import measurement_revisions
from sightline.measurements.tables import measurement_series
from sightline.reviews.records import MeasurementHistory, VehicleFacts
from sightline.scans.heights.store import is_of_line_scan, scan_height_revisions
from sightline.scans.tables import scan_vehicles, scans
from sightline.vehicles.tables import vehicles

_TOLD = ("id", "number", "make", "model", "year", "lighting")


def measurement_history(session: Session, series_id: int) -> MeasurementHistory:
    """Every revision and every review of a height, oldest first. Raises NotFound."""
    of_line = is_of_line_scan(session, series_id)
    revisions = (scan_height_revisions if of_line else measurement_revisions)(session, series_id)
    return MeasurementHistory(revisions, reviews_of_series(session, measurement_series.c.id == series_id))


def facts_of_vehicles(session: Session, ids: Collection[int]) -> dict[int, VehicleFacts]:
    """What is told of filmed vehicles, by id."""
    told = (*(vehicles.c[name] for name in _TOLD), vehicles.c.manufacturer_height_m)
    found = session.execute(select(*told).where(vehicles.c.id.in_(ids)))
    return {row.id: VehicleFacts(**row._mapping) for row in found}


def facts_of_scanned(session: Session, ids: Collection[int]) -> dict[int, VehicleFacts]:
    """What is told of scanned vehicles, by id."""
    told = (*(scan_vehicles.c[name] for name in _TOLD), scans.c.name.label("scan_name"))
    query = select(*told).join(scans, scans.c.id == scan_vehicles.c.scan_id)
    found = session.execute(query.where(scan_vehicles.c.id.in_(ids)))
    return {row.id: VehicleFacts(**row._mapping) for row in found}
