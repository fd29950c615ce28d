"""Heights in line scans: the rod's calibration, the height under the pointer, stored heights."""

from typing import Annotated

from fastapi import APIRouter, Query

from sightline.coverage import expanded
from sightline.enums import Target
from sightline.infra.database import Session
from sightline.infra.web.deps import Operator, PathId, Reading, Reviewer, Viewer, Writing
from sightline.scans.bodies import NewScanReview
from sightline.scans.heights import pose_store, poses, review_store, service, store
from sightline.scans.heights.bodies import (
    LineClicks,
    LineHeightAnswer,
    LineHeightBody,
    LineHeightWanted,
    LinePoseBody,
    LinePosesBody,
    LineRungBody,
    NewLineHeight,
    NewLinePose,
    RodIn,
    SeenRevision,
    SolvedRodBody,
)
from sightline.scans.heights.poses import Mark, Rod, SolvedRod
from sightline.scans.heights.queue import line_height_queue
from sightline.scans.heights.records import LineHeightQueue, StoredLineHeight, StoredLinePose
from sightline.scans.store import get_scan
from sightline.scans.vehicles.store import get_scan_vehicle
from sightline.surveys.store import get_survey

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
    point = None
    if body.target_line is not None and body.target_row_px is not None:
        point = (body.target_line, body.target_row_px)
    looked = service.preview_line_height(session, scan_id, _clicked(body, point), body.vehicle_id)
    found = looked.found
    only_contact = point is None and found.reason is None
    return LineHeightAnswer.model_validate(
        {
            **{name: getattr(found, name) for name in _OF_FOUND},
            "status": "contact" if only_contact else found.status,
            "budget": found.budget,
            "inset_m": looked.inset_m,
            "u_inset_m": looked.u_inset_m,
            "U95_distance_m": looked.U95_distance_m,
            "ladder": [LineRungBody(height_m=height, row_px=row) for height, row in looked.ladder],
        }
    )


@router.get("/scans/{scan_id}/heights")
def list_line_heights(scan_id: PathId, who: Viewer, session: Reading) -> list[LineHeightBody]:
    """The newest revision of every target of every vehicle, withdrawn ones too."""
    get_scan(session, scan_id)
    return _height_bodies(session, scan_id, store.list_line_heights(session, scan_id), who.id)


@router.get("/scan-vehicles/{vehicle_id}/heights")
def history_of_line_heights(vehicle_id: PathId, who: Viewer, session: Reading) -> list[LineHeightBody]:
    """Every revision of a vehicle's heights, oldest first."""
    vehicle = get_scan_vehicle(session, vehicle_id, deleted=True)
    history = store.line_height_history(session, vehicle_id)
    return _height_bodies(session, vehicle.scan_id, history, who.id)


@router.post("/scan-vehicles/{vehicle_id}/heights", status_code=201)
def store_line_height(
    vehicle_id: PathId, body: NewLineHeight, who: Operator, session: Writing
) -> LineHeightBody:
    """Store a target's height with the newest calibration: a new revision."""
    clicked = _clicked(body, (body.target_line, body.target_row_px))
    made = service.store_line_height(session, vehicle_id, clicked, seen_revision=body.revision, actor=who.id)
    return _height_bodies(session, made.scan_id, (made,), who.id)[0]


@router.delete("/scan-vehicles/{vehicle_id}/heights")
def withdraw_line_height(
    vehicle_id: PathId,
    who: Operator,
    session: Writing,
    target: Annotated[Target, Query()],
    revision: Annotated[SeenRevision, Query()],
) -> LineHeightBody:
    """Take a height back; nothing of it is erased."""
    made = store.withdraw_line_height(session, vehicle_id, target, seen_revision=revision, actor=who.id)
    return _height_bodies(session, made.scan_id, (made,), who.id)[0]


@router.post("/line-heights/{height_id}/review", status_code=201)
def review_line_height(
    height_id: PathId, body: NewScanReview, who: Reviewer, session: Writing
) -> LineHeightBody:
    """Accept, reject (with a reason) or reopen a revision; never clicks of one's own."""
    judged = review_store.add_line_height_review(
        session, height_id, verdict=body.verdict, reason=body.reason, seen=body.seen, actor=who.id
    )
    return _height_bodies(session, judged.scan_id, (judged,), who.id)[0]


@router.get("/surveys/{survey_id}/line-height-queue")
def list_waiting_line_heights(survey_id: PathId, who: Viewer, session: Reading) -> LineHeightQueue:
    """The heights of the survey's line scans that wait for a verdict, one's own last; 200 at most."""
    get_survey(session, survey_id)
    return line_height_queue(session, survey_id, actor=who.id)


_OF_FOUND = ("reason", "distance_m", "height_m", "u_height_m", "U95_height_m", "warnings")
_MADE = ("id", "revision", "created_by", "created_at")
_OF_HEIGHT = (*_MADE, "vehicle_id", "computing_id", "review")


def _rod(body: RodIn) -> Rod:
    marks = tuple(Mark(m.distance_m, m.height_m, m.row_px, m.line) for m in body.marks)
    return Rod(marks, body.sigma_px, body.u_distance_m, body.u_lean_rad)


def _clicked(body: LineClicks, point: tuple[float, float] | None) -> service.Clicked:
    return service.Clicked(
        target=body.target,
        contact=(body.contact_line, body.contact_row_px),
        target_point=point,
        sigma_px=body.sigma_px,
        inset_m=body.inset_m,
        u_inset_m=body.u_inset_m,
        side=body.side,
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


def _height_bodies(
    session: Session, scan_id: int, found: tuple[StoredLineHeight, ...], asker: int
) -> list[LineHeightBody]:
    pose = pose_store.current_line_poses(session, scan_id)
    insets = get_survey(session, get_scan(session, scan_id).survey_id).insets
    own = store.heights_of_own_clicks(session, scan_id, asker)
    return [
        _height_body(
            one,
            older=bool(
                service.causes_now_of_line(
                    one.values,
                    superseded=pose is None or one.values.pose_id != pose.id,
                    insets=insets,
                    category=one.category,
                )
            ),
            mine=one.id in own,
        )
        for one in found
    ]


def _height_body(one: StoredLineHeight, *, older: bool, mine: bool) -> LineHeightBody:
    values = one.values
    derived = ("older", "mine", "U95_distance_m", "U95_height_m")
    names = [name for name in LineHeightBody.model_fields if name not in (*_OF_HEIGHT, *derived)]
    body = {name: getattr(values, name) for name in names}
    body |= {name: getattr(one, name) for name in _OF_HEIGHT}
    for name in ("distance_m", "height_m"):
        body[f"U95_{name}"] = expanded(getattr(values, f"u_{name}"))
    return LineHeightBody.model_validate({**body, "older": older, "mine": mine})
