"""Vehicles of line-scan recordings: looked at, corrected by hand, reviewed."""

from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from sightline.enums import MatchPicture
from sightline.errors import BadInput
from sightline.infra.web.deps import Operator, PathId, Reading, Reviewer, Viewer, Wired, Writing
from sightline.infra.web.pictures import JPEG, jpeg_once
from sightline.linescan.parts import Crossings
from sightline.scans.bodies import (
    AxlesIn,
    BoundariesIn,
    LaneIn,
    NewScanReview,
    NewScanVehicle,
    ScanFacts,
    ScanVehicleBody,
    ScanVehicleDetailBody,
    Version,
    WheelsIn,
)
from sightline.scans.match import match_picture
from sightline.scans.presenters import changed_vehicle, detail_body, vehicle_body
from sightline.scans.vehicles import edits, listing, review_store, store

router = APIRouter()


@router.get("/scans/{scan_id}/vehicles")
def list_scan_vehicles(scan_id: PathId, who: Viewer, session: Reading) -> list[ScanVehicleBody]:
    """The vehicles of a scan in the order in which they passed, with the gaps between them."""
    return [vehicle_body(one, who.id) for one in listing.vehicles_of(session, scan_id)]


@router.post("/scans/{scan_id}/vehicles", status_code=201)
def add_scan_vehicle(
    scan_id: PathId, body: NewScanVehicle, who: Operator, services: Wired
) -> ScanVehicleBody:
    """A vehicle that was not found, by the lines of its front and rear; sent twice it is added once."""
    second = None
    if body.front_line_2 is not None and body.rear_line_2 is not None:
        second = (body.front_line_2, body.rear_line_2)
    elif body.front_line_2 is not None or body.rear_line_2 is not None:
        raise BadInput("scans-second-camera-half")
    first = (body.front_line_1, body.rear_line_1)
    made = edits.add_vehicle(services, scan_id, first, second, body.method, who.id)
    return changed_vehicle(services, made, who.id)


@router.get("/scan-vehicles/{vehicle_id}")
def get_scan_vehicle(vehicle_id: PathId, who: Viewer, session: Reading) -> ScanVehicleDetailBody:
    """One vehicle with its profile, budget, all revisions and all verdicts; taken out or not."""
    return detail_body(listing.detail_of(session, vehicle_id), who.id)


@router.put("/scan-vehicles/{vehicle_id}/boundaries")
def place_boundaries(
    vehicle_id: PathId, body: BoundariesIn, who: Operator, services: Wired
) -> ScanVehicleBody:
    """Measure again from boundaries that a person placed: a new revision."""
    crossings = Crossings(body.front_line_1, body.rear_line_1, body.front_line_2, body.rear_line_2)
    edits.place_boundaries(services, vehicle_id, crossings, body.method, body.version, who.id)
    return changed_vehicle(services, vehicle_id, who.id)


@router.put("/scan-vehicles/{vehicle_id}/wheels")
def place_wheels(vehicle_id: PathId, body: WheelsIn, who: Operator, services: Wired) -> ScanVehicleBody:
    """The wheelbase from the lines of both wheels in strip 1: a new revision; null takes them away."""
    lines = None
    if body.front_wheel_line is not None and body.rear_wheel_line is not None:
        lines = (body.front_wheel_line, body.rear_wheel_line)
    elif body.front_wheel_line is not None or body.rear_wheel_line is not None:
        raise BadInput("scans-wheel-missing")
    edits.place_wheels(services, vehicle_id, lines, body.version, who.id)
    return changed_vehicle(services, vehicle_id, who.id)


@router.put("/scan-vehicles/{vehicle_id}/axles")
def place_axles(vehicle_id: PathId, body: AxlesIn, who: Operator, services: Wired) -> ScanVehicleBody:
    """All wheels' hubs in strip 1 as a person sees them: a new revision; null looks for them again."""
    edits.place_axles(services, vehicle_id, body.axle_lines, body.version, who.id)
    return changed_vehicle(services, vehicle_id, who.id)


@router.put("/scan-vehicles/{vehicle_id}/lane")
def place_lane(vehicle_id: PathId, body: LaneIn, who: Operator, services: Wired) -> ScanVehicleBody:
    """Measure again in the lane that a person chose: a new revision; null leaves it to the program."""
    edits.place_lane(services, vehicle_id, body.lane, body.version, who.id)
    return changed_vehicle(services, vehicle_id, who.id)


@router.put("/scan-vehicles/{vehicle_id}/facts")
def fill_in_scan_vehicle(
    vehicle_id: PathId, body: ScanFacts, who: Operator, services: Wired
) -> ScanVehicleBody:
    """What is known of the vehicle: model, category, the maker's length and wheelbase."""
    given = body.model_dump(exclude_unset=True, exclude={"version", "catalogue_id"})
    if given.get("notes", "") is None:
        given["notes"] = ""
    with services.writing() as session:
        edits.fill_in(
            session, vehicle_id, given, catalogue_id=body.catalogue_id, version=body.version, actor=who.id
        )
    return changed_vehicle(services, vehicle_id, who.id)


@router.delete("/scan-vehicles/{vehicle_id}", status_code=204)
def remove_scan_vehicle(
    vehicle_id: PathId, who: Operator, session: Writing, version: Annotated[Version | None, Query()] = None
) -> None:
    """Take a vehicle out of all lists; nothing of it is erased, and found again it stays away."""
    store.remove_scan_vehicle(session, vehicle_id, version=version, actor=who.id)


@router.post("/scan-vehicles/{vehicle_id}/restore")
def restore_scan_vehicle(vehicle_id: PathId, who: Operator, services: Wired) -> ScanVehicleBody:
    """Bring a vehicle back that was taken out."""
    with services.writing() as session:
        store.restore_scan_vehicle(session, vehicle_id, actor=who.id)
    return changed_vehicle(services, vehicle_id, who.id)


@router.get("/scan-vehicles/{vehicle_id}/match/{picture}", response_class=Response, responses=JPEG)
def match_of_scan_vehicle(
    vehicle_id: PathId, picture: MatchPicture, who: Viewer, services: Wired, request: Request
) -> Response:
    """The vehicle in strip 1, strip 2 laid over it by the fitted motion, or their difference (grey: none)."""
    with services.reading() as session:
        detail = listing.detail_of(session, vehicle_id)
    measured = detail.shown.vehicle.measurement
    etag = f'"m{measured.id if measured else 0}-{picture}"'
    return jpeg_once(request, etag, lambda: match_picture(services, detail.scan, measured, picture))


@router.post("/scan-measurements/{measurement_id}/review", status_code=201)
def review_scan_measurement(
    measurement_id: PathId, body: NewScanReview, who: Reviewer, services: Wired
) -> ScanVehicleBody:
    """Accept, reject (with a reason) or reopen a revision; never boundaries of one's own."""
    with services.writing() as session:
        judged = review_store.add_scan_review(session, measurement_id, **body.model_dump(), actor=who.id)
    return changed_vehicle(services, judged.vehicle_id, who.id)
