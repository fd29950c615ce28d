"""Reference values of scanned vehicles: said beside the vehicle, or brought in a CSV."""

from typing import Annotated

from fastapi import APIRouter, File, Query, UploadFile

from sightline.enums import ReferenceQuantity, ReferenceSource
from sightline.infra.web.deps import Operator, PathId, Wired
from sightline.infra.web.quantities import SeenRevision
from sightline.infra.web.uploaded import whole_file
from sightline.scans.bodies import ScanVehicleBody
from sightline.scans.presenters import changed_vehicle
from sightline.scans.references import store
from sightline.scans.references.bodies import ReferenceIn
from sightline.scans.references.import_csv import MOST_BYTES, import_references, plan_references
from sightline.scans.references.passing_times import MOST_TOLERANCE_S, USUAL_TOLERANCE_S
from sightline.scans.references.records import ReferencePlan, ReferencesImported, ReferenceValues

router = APIRouter()
Sent = Annotated[UploadFile, File(description="CSV in UTF-8.")]
Tolerance = Annotated[
    float,
    Query(gt=0, le=MOST_TOLERANCE_S, description="How far a line's time may be from its vehicle's, seconds."),
]


@router.put("/scan-vehicles/{vehicle_id}/references/{quantity}/{source}")
def say_reference(
    vehicle_id: PathId,
    quantity: ReferenceQuantity,
    source: ReferenceSource,
    body: ReferenceIn,
    who: Operator,
    services: Wired,
) -> ScanVehicleBody:
    """What this source says of the vehicle; sent twice it is stored once."""
    device = (body.device or "").strip() or None
    values = ReferenceValues(quantity, source, value=body.value, u=body.u, device=device)
    with services.writing() as session:
        store.append_scan_reference(session, vehicle_id, values, seen_revision=body.revision, actor=who.id)
    return changed_vehicle(services, vehicle_id, who.id)


@router.delete("/scan-vehicles/{vehicle_id}/references/{quantity}/{source}")
def withdraw_reference(
    vehicle_id: PathId,
    quantity: ReferenceQuantity,
    source: ReferenceSource,
    revision: Annotated[SeenRevision, Query()],
    who: Operator,
    services: Wired,
) -> ScanVehicleBody:
    """Take back what this source says; its revisions stay."""
    with services.writing() as session:
        store.withdraw_scan_reference(
            session, vehicle_id, quantity, source, seen_revision=revision, actor=who.id
        )
    return changed_vehicle(services, vehicle_id, who.id)


@router.post("/scans/{scan_id}/references/preview")
def preview_reference_import(
    scan_id: PathId, who: Operator, services: Wired, file: Sent, tolerance_s: Tolerance = USUAL_TOLERANCE_S
) -> ReferencePlan:
    """What an import of this file would do with each line; nothing is stored."""
    name = file.filename or "The file"
    data = whole_file(file, MOST_BYTES, name)
    with services.reading() as session:
        return plan_references(session, scan_id, data, name, tolerance_s)


@router.post("/scans/{scan_id}/references/import")
def import_scan_references(
    scan_id: PathId, who: Operator, services: Wired, file: Sent, tolerance_s: Tolerance = USUAL_TOLERANCE_S
) -> ReferencesImported:
    """The lines of a CSV; those that cannot be used are named with their reason, the others are stored."""
    name = file.filename or "The file"
    data = whole_file(file, MOST_BYTES, name)
    with services.writing() as session:
        return import_references(session, scan_id, data, name, tolerance_s, actor=who.id)
