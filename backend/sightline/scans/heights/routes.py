"""Heights in line scans: the rod's calibration, the height under the pointer, stored heights."""

from typing import Annotated

from fastapi import APIRouter, Query

from sightline.coverage import expanded
from sightline.enums import Target
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.measurements.records import Clicks
from sightline.scans.heights import pose_store, poses, service, store
from sightline.scans.heights.bodies import (
    LineClicks,
    LineHeightAnswer,
    LineHeightWanted,
    LinePoseBody,
    LinePosesBody,
    LineRungBody,
    NewLineHeight,
    NewLinePose,
    RodIn,
    ScanHeightBody,
    SeenRevision,
    SolvedRodBody,
)
from sightline.scans.heights.poses import Mark, Rod, SolvedRod
from sightline.scans.heights.presenters import scan_height_bodies
from sightline.scans.heights.records import StoredLinePose
from sightline.scans.store import get_scan
from sightline.scans.vehicles.store import get_scan_vehicle

router = APIRouter()


@router.get("/scans/{scan_id}/line-pose")
def get_line_pose(scan_id: PathId, who: Viewer, session: Reading) -> LinePosesBody:
    """The calibration of camera 1 that heights are computed with, and those before it."""
    get_scan(session, scan_id)
    history = [_pose_body(one) for one in pose_store.line_pose_history(session, scan_id)]
    return LinePosesBody(current=history[-1] if history else None, history=history)


@router.post("/scans/{scan_id}/line-pose/preview")
def preview_line_pose(scan_id: PathId, body: RodIn, who: Viewer, session: Reading) -> SolvedRodBody:
    """The pose that these marks would be stored with: residuals, the camera's height, warnings."""
    get_scan(session, scan_id)
    return _solved_body(poses.preview_line_pose(_rod(body)))


@router.put("/scans/{scan_id}/line-pose")
def store_line_pose(scan_id: PathId, body: NewLinePose, who: Operator, session: Writing) -> LinePoseBody:
    """Store a calibration; heights keep theirs, and say so, until they are stored again."""
    made = poses.store_line_pose(session, scan_id, _rod(body), seen_revision=body.revision, actor=who.id)
    return _pose_body(made)


@router.post("/scans/{scan_id}/line-height")
def preview_line_height(
    scan_id: PathId, body: LineHeightWanted, who: Viewer, session: Reading
) -> LineHeightAnswer:
    """The height that these two clicks would be stored with, and the ladder above the contact."""
    contact = (body.contact_line, body.contact_row_px)
    whole = body.target_line is not None and body.target_row_px is not None
    point = (body.target_line or 0.0, body.target_row_px or 0.0) if whole else contact
    looked = service.preview_line_height(
        session, scan_id, _clicked(body, point), body.vehicle_id, only_contact=not whole
    )
    found = looked.found
    only_contact = not whole and found.reason is None
    return LineHeightAnswer.model_validate(
        {
            **{name: getattr(found, name) for name in _OF_FOUND},
            "status": "contact" if only_contact else found.status,
            "budget": found.budget,
            "flags": list(found.flags),
            "inset_m": looked.inset_m,
            "u_inset_m": looked.u_inset_m,
            "U95_distance_m": looked.U95_distance_m,
            "ladder": [LineRungBody(height_m=height, row_px=row) for height, row in looked.ladder],
        }
    )


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


_OF_FOUND = ("reason", "distance_m", "height_m", "u_height_m", "U95_height_m")
_MADE = ("id", "revision", "created_by", "created_at")


def _rod(body: RodIn) -> Rod:
    marks = tuple(Mark(m.distance_m, m.height_m, m.row_px, m.line) for m in body.marks)
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


def _solved_body(one: SolvedRod) -> SolvedRodBody:
    names = [name for name in SolvedRodBody.model_fields if not name.startswith("U95")]
    U95 = expanded(one.u_camera_height_m)
    return SolvedRodBody.model_validate(
        {**{name: getattr(one, name) for name in names}, "U95_camera_height_m": U95}
    )


def _pose_body(one: StoredLinePose) -> LinePoseBody:
    names = ("marks", "sigma_px", "u_distance_m", "u_lean_rad")
    body = {name: getattr(one.values, name) for name in names} | {name: getattr(one, name) for name in _MADE}
    return LinePoseBody.model_validate({**body, "solved": _solved_body(poses.line_pose_result(one))})
