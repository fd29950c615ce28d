"""What a person changes of scanned vehicles: boundaries, wheels, facts, a vehicle by hand."""

from __future__ import annotations

from dataclasses import replace

from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.version import code_version
from sightline.linescan.by_hand import seen_by_camera_2
from sightline.linescan.parts import Crossings
from sightline.scans.records import Scan, ScanValues, ScanVehicle, ScanVehicleChanges
from sightline.scans.service import open_strips
from sightline.scans.store import get_scan
from sightline.scans.vehicles.measure import Readers, measured_at
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.motion import values_of, wheels_of, with_wheels
from sightline.scans.vehicles.store import (
    change_scan_vehicle,
    create_scan_vehicle,
    get_scan_vehicle,
    require_scan_vehicle_version,
    scan_vehicle_added_at,
)
from sightline.vehicles.catalogue.store import get_catalogue_row

MOST_LINES = 400_000
MOST_PIXELS = 400_000_000


def place_boundaries(
    services: Services,
    vehicle_id: int,
    crossings: Crossings,
    method: ScanMethod | None,
    version: int,
    actor: int,
) -> None:
    """Measure a vehicle from boundaries that a person placed, as a new revision; its wheels stay.

    Raises NotFound, Conflict for another version, BadInput for boundaries that cannot be.
    """
    vehicle, scan = _seen(services, vehicle_id, version)
    before = vehicle.measurement
    readers = open_strips(services, scan)
    _check(crossings, readers)
    chosen = method or (before.values.method if before else "direct")
    motion = measured_at(crossings, scan.rig, chosen, readers)
    values = values_of(motion, scan.rig, "boundaries", placed_by=actor)
    if before is not None:
        values = with_wheels(values, wheels_of(before.values))
    with services.writing() as session:
        append_scan_measurement(session, vehicle_id, values, version=version, actor=actor)


def place_wheels(
    services: Services, vehicle_id: int, lines: tuple[float, float] | None, version: int, actor: int
) -> None:
    """The wheelbase from both wheels' lines in strip 1 (None: none), as a new revision.

    Raises NotFound, Conflict for another version, BadInput where there can be no wheelbase.
    """
    vehicle, scan = _seen(services, vehicle_id, version)
    before = vehicle.measurement
    if before is None:
        raise BadInput("scans-vehicle-not-measured-yet-no-wheelbase")
    values = with_wheels(_own(before.values), lines)
    if lines is not None and values.wheelbase_m is None:
        raise BadInput("said", sentence=values.warnings[-1].removeprefix("No wheelbase: "))
    if lines is not None and not all(0 <= line < (scan.lines or 0) for line in lines):
        raise BadInput("scans-wheel-lies-outside-strips-which-end", lines=(scan.lines or 1) - 1)
    made = replace(values, cause="wheels", placed_by=actor, run_id=None, code_version=code_version())
    with services.writing() as session:
        append_scan_measurement(session, vehicle_id, made, version=version, actor=actor)


def add_vehicle(
    services: Services,
    scan_id: int,
    first: tuple[float, float],
    second: tuple[float, float] | None,
    method: ScanMethod,
    actor: int,
) -> int:
    """A vehicle by hand, measured; its id. Without `second` it is looked for in camera 2's strip.

    The same lines from the same person are the same vehicle: a repeat, whose answer was lost, adds none.
    Raises NotFound, BadInput for lines that cannot be or a vehicle that camera 2 did not see.
    """
    with services.reading() as session:
        scan = get_scan(session, scan_id)
        known = scan_vehicle_added_at(session, scan_id, first, actor)
    if known is not None:
        return known
    readers = open_strips(services, scan)
    _check(Crossings(*first, *(second or first)), readers)
    if second is None:
        reads = (readers[0].read, readers[1].read)
        try:
            crossings = seen_by_camera_2(*first, scan.rig, readers[0].rows, reads)
        except LookupError:
            raise BadInput("scans-nothing-camera-2s-strip-looks-like") from None
    else:
        crossings = Crossings(*first, *second)
    motion = measured_at(crossings, scan.rig, method, readers)
    values = values_of(motion, scan.rig, "added", placed_by=actor)
    with services.writing() as session:
        made = create_scan_vehicle(session, scan_id, actor=actor)
        append_scan_measurement(session, made.id, values, actor=actor)
    return made.id


def fill_in(
    session: Session,
    vehicle_id: int,
    changes: ScanVehicleChanges,
    *,
    catalogue_id: int | None,
    version: int,
    actor: int,
) -> ScanVehicle:
    """Store what is known of a vehicle; what is not given comes from the catalogue's entry, if one is named.

    Raises NotFound, Conflict for another version, BadInput.
    """
    if catalogue_id is not None:
        entry = get_catalogue_row(session, catalogue_id)
        known = ScanVehicleChanges(
            make=entry.make,
            model=entry.model,
            category=entry.category,
            true_length_m=entry.length_m,
            true_wheelbase_m=entry.wheelbase_m,
            facts_source=entry.source or "catalogue",
        )
        changes = {**known, **changes}
    return change_scan_vehicle(session, vehicle_id, changes, version=version, actor=actor)


def _seen(services: Services, vehicle_id: int, version: int) -> tuple[ScanVehicle, Scan]:
    """The vehicle and its scan, if nobody changed it since; looked at before the work and after it."""
    with services.reading() as session:
        require_scan_vehicle_version(session, vehicle_id, version)
        vehicle = get_scan_vehicle(session, vehicle_id)
        return vehicle, get_scan(session, vehicle.scan_id)


def _own(values: ScanValues) -> ScanValues:
    """The content without what an earlier wheelbase said."""
    kept = [one for one in values.warnings if not one.startswith("No wheelbase: ")]
    return replace(values, warnings=kept)


def _check(crossings: Crossings, readers: Readers) -> None:
    """Raises BadInput for boundaries out of order, outside the strips, or too far apart to be one vehicle."""
    spans = (
        (crossings.front_line_1, crossings.rear_line_1),
        (crossings.front_line_2, crossings.rear_line_2),
    )
    for camera, ((front, rear), reader) in enumerate(zip(spans, readers, strict=True), 1):
        if not front < rear:
            raise BadInput("scans-camera-front-line-must-come-before", camera=camera, front=front, rear=rear)
        if not 0 <= front < rear <= reader.lines - 1:
            raise BadInput(
                "scans-boundaries-camera-lie-outside-strip-which", camera=camera, lines=reader.lines - 1
            )
        if rear - front > min(MOST_LINES, MOST_PIXELS / reader.rows):
            raise BadInput("scans-front-rear-camera-lines-apart-more", camera=camera, rear=rear - front)
