"""Heights in line scans: the rod's calibration, the height under the pointer, stored heights."""

from typing import Annotated

from fastapi import APIRouter, Query

from sightline.enums import Target
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.infra.web.quantities import SeenRevision
from sightline.measurements.records import Clicks
from sightline.scans.heights import poses, service, store
from sightline.scans.heights.bodies import (
    LineClicks,
    LineHeightWanted,
    NewLineHeight,
    NewLinePose,
    RodIn,
    ScanHeightBody,
)
from sightline.scans.heights.poses import LinePoses, Mark, Rod, ShownLinePose, SolvedRod
from sightline.scans.heights.presenters import scan_height_bodies
from sightline.scans.heights.service import HeightPreview
from sightline.scans.store import get_scan
from sightline.scans.vehicles.store import get_scan_vehicle

router = APIRouter()


@router.get("/scans/{scan_id}/line-pose")
def get_line_pose(scan_id: PathId, who: Viewer, session: Reading) -> LinePoses:
    """The calibration of camera 1 that heights are computed with, and those before it."""
    get_scan(session, scan_id)
    return poses.line_poses_of(session, scan_id)


@router.post("/scans/{scan_id}/line-pose/preview")
def preview_line_pose(scan_id: PathId, body: RodIn, who: Viewer, session: Reading) -> SolvedRod:
    """The pose that these marks would be stored with: residuals, the camera's height, warnings."""
    get_scan(session, scan_id)
    return poses.preview_line_pose(_rod(body))


@router.put("/scans/{scan_id}/line-pose")
def store_line_pose(scan_id: PathId, body: NewLinePose, who: Operator, session: Writing) -> ShownLinePose:
    """Store a calibration; heights keep theirs, and say so, until they are stored again."""
    made = poses.store_line_pose(session, scan_id, _rod(body), seen_revision=body.revision, actor=who.id)
    return poses.shown_line_pose(made)


@router.post("/scans/{scan_id}/line-height")
def preview_line_height(
    scan_id: PathId, body: LineHeightWanted, who: Viewer, session: Reading
) -> HeightPreview:
    """The height that these two clicks would be stored with, and the ladder above the contact."""
    only_contact, point = True, (body.contact_line, body.contact_row_px)
    if body.target_line is not None and body.target_row_px is not None:
        only_contact, point = False, (body.target_line, body.target_row_px)
    clicked = _clicked(body, point)
    return service.preview_line_height(session, scan_id, clicked, body.vehicle_id, only_contact=only_contact)


@router.get("/scans/{scan_id}/heights")
def list_scan_heights(scan_id: PathId, who: Viewer, session: Reading) -> list[ScanHeightBody]:
    """The newest revision of every target of every vehicle, withdrawn ones too."""
    get_scan(session, scan_id)
    return scan_height_bodies(session, store.list_scan_heights(session, scan_id), who.id)


@router.get("/scan-vehicles/{vehicle_id}/heights")
def history_of_scan_heights(vehicle_id: PathId, who: Viewer, session: Reading) -> list[ScanHeightBody]:
    """Every revision of a vehicle's heights, oldest first."""
    get_scan_vehicle(session, vehicle_id, deleted=True)
    return scan_height_bodies(session, store.scan_height_history(session, vehicle_id), who.id)


@router.post("/scan-vehicles/{vehicle_id}/heights", status_code=201)
def store_scan_height(
    vehicle_id: PathId, body: NewLineHeight, who: Operator, session: Writing
) -> ScanHeightBody:
    """Store a target's height with the newest calibration: a new revision."""
    clicked = _clicked(body, (body.target_line, body.target_row_px))
    made = service.store_scan_height(session, vehicle_id, clicked, seen_revision=body.revision, actor=who.id)
    return scan_height_bodies(session, (made,), who.id)[0]


@router.delete("/scan-vehicles/{vehicle_id}/heights")
def withdraw_scan_height(
    vehicle_id: PathId,
    who: Operator,
    session: Writing,
    target: Annotated[Target, Query()],
    revision: Annotated[SeenRevision, Query()],
) -> ScanHeightBody:
    """Take a height back; nothing of it is erased."""
    made = store.withdraw_scan_height(session, vehicle_id, target, seen_revision=revision, actor=who.id)
    return scan_height_bodies(session, (made,), who.id)[0]


def _rod(body: RodIn) -> Rod:
    marks = tuple(Mark(**one.model_dump()) for one in body.marks)
    return Rod(marks, body.sigma_px, body.u_distance_m, body.u_lean_rad)


def _clicked(body: LineClicks, point: tuple[float, float]) -> Clicks:
    return Clicks(
        target=body.target,
        contact=(body.contact_line, body.contact_row_px),
        target_point=point,
        sigma_px=body.sigma_px,
        inset_m=body.inset_m,
        u_inset_m=body.u_inset_m,
        side=body.side if body.target == "driver_eye" else None,
    )
