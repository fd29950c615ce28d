"""Line-scan recordings: made, read, looked at; their vehicles found."""

from datetime import UTC, datetime
from typing import Annotated

from fastapi import APIRouter, Path, Query, Request, Response

from sightline.infra.by_name import filled_from
from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired, Writing
from sightline.infra.web.pictures import JPEG, answer_not_modified, is_held, picture_response
from sightline.linescan.rig import rig_from
from sightline.recordings.uploads.store import strips_waiting
from sightline.scans import service, store
from sightline.scans.bodies import (
    ChangedScan,
    FindWanted,
    NewScan,
    NewScanFromVideo,
    ScanBody,
    StripUploadBody,
    SwapWanted,
)
from sightline.scans.clock import clock_said
from sightline.scans.presenters import scan_body
from sightline.scans.records import CutSource
from sightline.scans.rig.service import RigOfTraffic, rig_of_traffic
from sightline.scans.store import RIG

router = APIRouter()

Camera = Annotated[int, Path(ge=1, le=2)]
PathLevel = Annotated[int, Path(ge=0, le=40)]
PathIndex = Annotated[int, Path(ge=0, le=2**31 - 1)]


@router.get("/surveys/{survey_id}/scans")
def list_scans(survey_id: PathId, who: Viewer, session: Reading) -> list[ScanBody]:
    """The line-scan recordings of a survey, in the order in which they came."""
    return [scan_body(one) for one in store.list_scans(session, survey_id)]


@router.get("/surveys/{survey_id}/strip-uploads")
def list_strip_uploads(survey_id: PathId, who: Viewer, session: Reading) -> list[StripUploadBody]:
    """The strips that arrived and wait for their scan."""
    return [filled_from(StripUploadBody, one) for one in strips_waiting(session, survey_id)]


@router.post("/surveys/{survey_id}/scans", status_code=201)
def add_scan(survey_id: PathId, body: NewScan, who: Operator, session: Writing) -> ScanBody:
    """A scan of two uploaded strips; they are read in the background, then vehicles are looked for."""
    rig = rig_from(body.model_dump(include=set(RIG)))
    given = body.model_dump(exclude=set(RIG))
    return scan_body(service.create_from_strips(session, survey_id, rig=rig, actor=who.id, **given))


@router.post("/surveys/{survey_id}/scans/from-video", status_code=201)
def add_scan_from_video(
    survey_id: PathId, body: NewScanFromVideo, who: Operator, session: Writing
) -> ScanBody:
    """A scan cut from a video along two pixel columns or rows."""
    of_source = set(CutSource.__dataclass_fields__)
    source = CutSource(**body.model_dump(include=of_source))
    given = body.model_dump(exclude=of_source)
    return scan_body(service.create_from_video(session, survey_id, source=source, actor=who.id, **given))


@router.get("/scans/{scan_id}")
def get_scan(scan_id: PathId, who: Viewer, session: Reading) -> ScanBody:
    """One scan with its latest job and run."""
    return scan_body(store.get_scan(session, scan_id))


@router.get("/scans/{scan_id}/rig-of-traffic")
def get_rig_of_traffic(scan_id: PathId, who: Viewer, session: Reading) -> RigOfTraffic:
    """What the vehicles that stand say of misalignment, gain and baseline; nothing is changed."""
    return rig_of_traffic(session, scan_id)


@router.patch("/scans/{scan_id}")
def change_scan(scan_id: PathId, body: ChangedScan, who: Operator, session: Writing) -> ScanBody:
    """Change name, lighting, the start or values of the rig; results keep those that they were made with."""
    given = body.model_dump(exclude_unset=True, exclude={"version", "start"})
    may_be_null = {"lighting", "distance_m", "misalignment_px"}
    changes = {name: value for name, value in given.items() if value is not None or name in may_be_null}
    if "start" in body.model_fields_set:
        said = body.start
        changes["clock"] = said and clock_said(said.local, said.time_zone, said.u_s, datetime.now(UTC))
    return scan_body(store.update_scan(session, scan_id, changes, version=body.version, actor=who.id))


@router.delete("/scans/{scan_id}", status_code=204)
def remove_scan(scan_id: PathId, who: Operator, services: Wired) -> None:
    """Delete a scan on which nobody worked yet, and its files."""
    service.remove_scan(services, scan_id, who.id)


@router.post("/scans/{scan_id}/read", status_code=202)
def retry_reading(scan_id: PathId, who: Operator, session: Writing) -> JobBody:
    """Read the strips again, after a failed or cancelled reading."""
    return JobBody.model_validate(service.retry_reading(session, scan_id, who.id))


@router.post("/scans/{scan_id}/find", status_code=202)
def find_scan_vehicles(scan_id: PathId, body: FindWanted, who: Operator, session: Writing) -> JobBody:
    """Find and measure all vehicles in the background; boundaries that people placed stay."""
    job = service.request_find(session, scan_id, body.method, body.search, actor=who.id)
    return JobBody.model_validate(job)


@router.post("/scans/{scan_id}/swap", status_code=202)
def swap_cameras(scan_id: PathId, body: SwapWanted, who: Operator, session: Writing) -> ScanBody:
    """Exchange the cameras of strips that were given the wrong way round; vehicles are then found again."""
    return scan_body(service.swap_cameras(session, scan_id, version=body.version, actor=who.id))


@router.get("/scans/{scan_id}/tiles/{camera}/{level}/{index}", response_class=Response, responses=JPEG)
def scan_tile(
    scan_id: PathId,
    camera: Camera,
    level: PathLevel,
    index: PathIndex,
    who: Viewer,
    services: Wired,
    request: Request,
    gain: Annotated[float, Query(ge=0.1, le=50, description="Brighter, to look at only.")] = 1.0,
) -> Response:
    """Lines 1024 index .. of a zoom level as JPEG: time to the right, all rows."""
    with services.reading() as session:
        scan = store.get_scan(session, scan_id)
    etag = f'"s{(scan.first_sha256 if camera == 1 else scan.second_sha256) or ""}-{level}.{index}.{gain:g}"'
    if scan.state == "ready" and is_held(request, etag):
        return answer_not_modified(etag)
    content = service.open_strip(services, scan, camera).tile(level, index, gain)
    return picture_response(content, "image/jpeg", etag)
