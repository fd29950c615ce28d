"""What a person changes of scanned vehicles: boundaries, wheels, facts, a vehicle by hand."""

from collections.abc import Sequence
from dataclasses import replace

from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.version import code_version
from sightline.linescan.by_hand import seen_by_camera_2
from sightline.linescan.parts import Crossings, Rig
from sightline.linescan.rig import lane_named
from sightline.scans.records import Changes, Scan, ScanValues, ScanVehicle
from sightline.scans.service import open_strips
from sightline.scans.store import get_scan, rig_for
from sightline.scans.vehicles.measure import Readers, measured_again, measured_at
from sightline.scans.vehicles.measurement_store import append_scan_measurement, scan_measurement_history
from sightline.scans.vehicles.motion import (
    brought_back,
    crossings_of,
    lane_by_person,
    values_of,
    with_people,
    with_wheels,
)
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

    The very boundaries of an earlier revision are that one's again: who found or placed them, their doubt,
    and the motion itself where the rig, method and lane are the same.

    Raises NotFound, Conflict for another version, BadInput for boundaries that cannot be.
    """
    vehicle, scan = _require_seen_version(services, vehicle_id, version)
    before = vehicle.measurement
    readers = open_strips(services, scan)
    _check(crossings, readers)
    chosen = method or (before.values.method if before else "direct")
    with services.reading() as session:
        back = brought_back(scan_measurement_history(session, vehicle_id, profile=True), crossings)
    lane = lane_by_person(before)
    if back is None:
        motion = measured_at(crossings, scan.rig, chosen, readers, lane)
        values = values_of(motion, scan.rig, "boundaries", placed_by=actor)
    elif back.method == chosen and _as_now(back, scan.rig, lane):
        values = replace(_drop_wheelbase_warning(back), cause="back", run_id=None)
    else:
        motion = measured_at(crossings, scan.rig, chosen, readers, lane, back)
        values = values_of(motion, scan.rig, "back", placed_by=back.placed_by)
    if before is not None:
        values = with_people(values, before.values)
    with services.writing() as session:
        append_scan_measurement(session, vehicle_id, values, version=version, actor=actor)


def place_wheels(
    services: Services, vehicle_id: int, lines: tuple[float, float] | None, version: int, actor: int
) -> None:
    """The wheelbase from both wheels' lines in strip 1 (None: none), as a new revision.

    Raises NotFound, Conflict for another version, BadInput where there can be no wheelbase.
    """
    vehicle, scan = _require_seen_version(services, vehicle_id, version)
    before = vehicle.measurement
    if before is None:
        raise BadInput("scans-vehicle-not-measured")
    values = with_wheels(_drop_wheelbase_warning(before.values), lines)
    if lines is not None and values.wheelbase_m is None:
        raise BadInput("scan-motion-no-wheelbase", reason=values.warnings[-1].values["reason"])
    if lines is not None and not all(0 <= line < (scan.lines or 0) for line in lines):
        raise BadInput("scans-wheel-outside", lines=(scan.lines or 1) - 1)
    made = replace(values, cause="wheels", placed_by=actor, run_id=None, code_version=code_version())
    with services.writing() as session:
        append_scan_measurement(session, vehicle_id, made, version=version, actor=actor)


def place_axles(
    services: Services, vehicle_id: int, lines: Sequence[float] | None, version: int, actor: int
) -> None:
    """The lines of all wheels' hubs in strip 1 as a person says, as a new revision; None: the machine's own.

    Raises NotFound, Conflict for another version, BadInput for lines outside the vehicle or too many.
    """
    vehicle, scan = _require_seen_version(services, vehicle_id, version)
    before = vehicle.measurement
    if before is None or before.values.status != "ok":
        raise BadInput("scans-axles-without-motion")
    values = before.values
    if lines is None:
        readers = open_strips(services, scan)
        motion = measured_again(before, scan.rig, values.method, readers)
        found = None if motion.axle_lines is None else list(motion.axle_lines)
        changed = replace(values, axle_lines=found, axles_by=None if found is None else "machine")
    else:
        if not all(values.front_line_1 <= line <= values.rear_line_1 for line in lines):
            raise BadInput("scans-axle-outside-vehicle")
        changed = replace(values, axle_lines=sorted(set(lines)), axles_by="person")
    changed = replace(changed, cause="wheels", placed_by=actor, run_id=None, code_version=code_version())
    with services.writing() as session:
        append_scan_measurement(session, vehicle_id, changed, version=version, actor=actor)


def place_lane(services: Services, vehicle_id: int, lane: str | None, version: int, actor: int) -> None:
    """Measure a vehicle in the lane that a person chose, as a new revision; None: the one the machine tells.

    Boundaries, rig and lane of an earlier revision are that one's again.

    Raises NotFound, Conflict for another version, BadInput for a lane that the rig does not have.
    """
    vehicle, scan = _require_seen_version(services, vehicle_id, version)
    before = vehicle.measurement
    if before is None:
        raise BadInput("scans-lane-needs-boundaries")
    if lane is not None and lane_named(scan.rig, lane) is None:
        raise BadInput("scans-no-such-lane", lane=lane)
    then, crossings = before.values, crossings_of(before.values)
    with services.reading() as session:
        history = scan_measurement_history(session, vehicle_id, profile=True)
    same = [
        one for one in history if _as_now(one.values, scan.rig, lane) and one.values.method == then.method
    ]
    back = brought_back(same, crossings)
    if back is None:
        readers = open_strips(services, scan)
        motion = measured_at(crossings, scan.rig, then.method, readers, lane, then)
        values = values_of(motion, scan.rig, "lane", placed_by=actor)
    else:
        values = replace(_drop_wheelbase_warning(back), cause="back", run_id=None)
    values = with_people(values, then)
    with services.writing() as session:
        append_scan_measurement(session, vehicle_id, values, version=version, actor=actor)


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
            raise BadInput("scans-second-camera-blank") from None
    else:
        crossings = Crossings(*first, *second)
    motion = measured_at(crossings, scan.rig, method, readers)
    values = values_of(motion, scan.rig, "added", placed_by=actor)
    with services.writing() as session:
        made = create_scan_vehicle(session, scan_id, actor=actor)
        append_scan_measurement(session, made.id, values, actor=actor)
    return made.id


def fill_in(
    session: Session, vehicle_id: int, changes: Changes, *, catalogue_id: int | None, version: int, actor: int
) -> ScanVehicle:
    """Store what is known of a vehicle; what is not given comes from the catalogue's entry, if one is named.

    A size that is given without its source has none, rather than that of the size before.

    Raises NotFound, Conflict for another version, BadInput.
    """
    if "true_length_m" in changes or "true_wheelbase_m" in changes:
        changes = {"facts_source": None, **changes}
    if catalogue_id is not None:
        entry = get_catalogue_row(session, catalogue_id)
        known = {
            "make": entry.make,
            "model": entry.model,
            "category": entry.category,
            "true_length_m": entry.length_m,
            "true_wheelbase_m": entry.wheelbase_m,
            "facts_source": entry.source or "catalogue",
        }
        changes = {**known, **changes}
    return change_scan_vehicle(session, vehicle_id, changes, version=version, actor=actor)


def _as_now(values: ScanValues, rig: Rig, lane: str | None) -> bool:
    """Whether a revision was measured with the rig as it is, in the lane of a person, else the machine's."""
    told = values.lane if values.lane_by == "person" else None
    return values.rig == rig_for(rig, values.lane, values.direction) and told == lane


def _require_seen_version(services: Services, vehicle_id: int, version: int) -> tuple[ScanVehicle, Scan]:
    """The vehicle and its scan, if nobody changed it since; looked at before the work and after it."""
    with services.reading() as session:
        require_scan_vehicle_version(session, vehicle_id, version)
        vehicle = get_scan_vehicle(session, vehicle_id)
        return vehicle, get_scan(session, vehicle.scan_id)


def _drop_wheelbase_warning(values: ScanValues) -> ScanValues:
    """The content without what an earlier wheelbase said."""
    kept = [one for one in values.warnings if one.code != "scan-motion-no-wheelbase"]
    return replace(values, warnings=kept)


def _check(crossings: Crossings, readers: Readers) -> None:
    """Raises BadInput for boundaries out of order, outside the strips, or too far apart to be one vehicle."""
    spans = (
        (crossings.front_line_1, crossings.rear_line_1),
        (crossings.front_line_2, crossings.rear_line_2),
    )
    for camera, ((front, rear), reader) in enumerate(zip(spans, readers, strict=True), 1):
        if not front < rear:
            raise BadInput("scans-front-after-rear", camera=camera, front=front, rear=rear)
        if not 0 <= front < rear <= reader.lines - 1:
            raise BadInput("scans-boundaries-outside", camera=camera, lines=reader.lines - 1)
        if rear - front > min(MOST_LINES, MOST_PIXELS / reader.rows):
            raise BadInput("scans-boundaries-far-apart", camera=camera, rear=rear - front)
