"""Line-scan recordings: made of uploaded strips or of a video's columns, changed, deleted; strips opened.

Finding and measuring their vehicles is in `vehicles.find_job` and `vehicles.measure`.
"""

from sightline.enums import Lighting, ScanMethod, TimeAxis
from sightline.errors import BadInput, Conflict
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import latest_jobs_of_scans
from sightline.infra.services import Services
from sightline.infra.stored_bytes import let_go
from sightline.linescan.parts import Rig
from sightline.media.strips.stored_reader import ReaderCache, StripReader
from sightline.media.video.report import require_clock_of_filming
from sightline.recordings.store import get_ready_recording
from sightline.recordings.uploads.records import Upload
from sightline.recordings.uploads.store import get_upload
from sightline.scans import store
from sightline.scans.records import CutSource, Scan, StripSource

READ = "scan_read"
FIND = "scan_find"
# Stored forms go by the hash of their content, so a path means the same strip for ever.
_READERS = ReaderCache()


def create_from_strips(
    session: Session,
    survey_id: int,
    *,
    name: str | None,
    first_upload: int,
    second_upload: int,
    time_axis: TimeAxis,
    rig: Rig,
    lighting: Lighting | None,
    find: ScanMethod | None,
    actor: int,
) -> Scan:
    """A scan of two strips that were uploaded, its reading queued; then `find` looks for vehicles.

    Raises NotFound, Conflict for an upload that is not whole or belongs to a scan already, BadInput.
    """
    source = uploaded_strips(session, survey_id, first_upload, second_upload)
    scan = store.create_scan(
        session,
        survey_id,
        name=name or source[0].name,
        source=source,
        time_axis=time_axis,
        rig=rig,
        lighting=lighting,
        actor=actor,
    )
    queue_reading(session, scan, find, actor)
    return store.get_scan(session, scan.id)


def create_from_video(
    session: Session,
    survey_id: int,
    *,
    name: str | None,
    source: CutSource,
    baseline_m: float,
    u_baseline_m: float,
    lighting: Lighting | None,
    find: ScanMethod | None,
    actor: int,
) -> Scan:
    """A scan cut from a video along two pixel columns or rows; its line rate is the video's frame rate."""
    recording = get_ready_recording(session, source.recording_id)
    rate_hz = recording.report.get("rate_hz")
    if recording.vfr or not rate_hz:
        raise BadInput("scans-frames-uneven", name=recording.name)
    require_clock_of_filming(recording.report.get("clock_doubt"), recording.name)
    cuts = (source.cut_1_px, source.cut_2_px)
    what = "columns" if source.cut_along == "columns" else "rows"
    size_px = (recording.width_px if what == "columns" else recording.height_px) or 0
    if cuts[0] == cuts[1] or not all(0 <= one < size_px for one in cuts):
        raise BadInput("scans-cuts-unusable", what=what, cut_1=cuts[0], cut_2=cuts[1], last_px=size_px - 1)
    scan = store.create_scan(
        session,
        survey_id,
        name=name or f"{recording.name}, {what} {cuts[0]} and {cuts[1]}",
        source=source,
        time_axis="width",
        rig=Rig(baseline_m=baseline_m, line_rate_hz=float(rate_hz), u_baseline_m=u_baseline_m),
        lighting=lighting or recording.lighting,
        actor=actor,
    )
    queue_reading(session, scan, find, actor)
    return store.get_scan(session, scan.id)


def queue_reading(session: Session, scan: Scan, find: ScanMethod | None, actor: int | None) -> Job:
    """Queue the reading of a scan's strips in the caller's transaction."""
    payload = {"find": find}
    return registry.enqueue(session, READ, payload, survey_id=scan.survey_id, scan_id=scan.id, actor=actor)


def retry_reading(session: Session, scan_id: int, actor: int) -> Job:
    """Read the strips again after a failed or cancelled reading. Raises Conflict where there is no need."""
    scan = store.get_scan(session, scan_id)
    if scan.state == "ready":
        raise Conflict("scans-read-already", name=scan.name)
    require_idle(session, scan)
    find = (scan.job.payload.get("find") if scan.job else None) or None
    scan = store.restart_reading(session, scan_id, actor=actor)
    return queue_reading(session, scan, find, actor)


def request_find(
    session: Session, scan_id: int, method: ScanMethod, search: bool, *, actor: int | None
) -> Job:
    """Queue the search for vehicles (or, without `search`, the measuring again of the known ones).

    Raises NotFound, BadInput (not read yet), Conflict while one waits or runs.
    """
    scan = store.get_scan(session, scan_id)
    require_ready(scan)
    require_idle(session, scan)
    payload = {"method": method, "search": search}
    return registry.enqueue(session, FIND, payload, survey_id=scan.survey_id, scan_id=scan_id, actor=actor)


def swap_cameras(session: Session, scan_id: int, *, version: int, actor: int) -> Scan:
    """Exchange the cameras and queue the search that puts the vehicles right.

    Raises NotFound, Conflict (as `store.swap_scan_cameras`, or a job of it waits or runs).
    """
    scan = store.get_scan(session, scan_id)
    require_idle(session, scan)
    store.swap_scan_cameras(session, scan_id, version=version, actor=actor)
    method: ScanMethod = "direct" if scan.run is None else scan.run.method
    request_find(session, scan_id, method, True, actor=actor)
    return store.get_scan(session, scan_id)


def is_within_strips(scan: Scan, line: float, row_px: float) -> bool:
    """Whether a place lies within the strips."""
    return -0.5 <= line <= (scan.lines or 0) and -0.5 <= row_px <= (scan.rows_px or 0)


def require_ready(scan: Scan) -> None:
    """Raises BadInput while a scan has no strips to look at."""
    if scan.state == "failed":
        raise BadInput("scans-import-failed", name=scan.name)
    if scan.state == "live":
        raise BadInput("scans-still-being-recorded", name=scan.name)
    if scan.state != "ready":
        raise BadInput("scans-not-ready", name=scan.name)


def require_idle(session: Session, scan: Scan) -> None:
    """Raises Conflict while a job of this scan waits or runs."""
    job = latest_jobs_of_scans(session, [scan.id]).get(scan.id)
    if job is not None and job.state in ("queued", "running"):
        what = "read" if job.kind == READ else "searched"
        raise Conflict("scans-already-wait-cancel", name=scan.name, what=what)


def remove_scan(services: Services, scan_id: int, actor: int) -> None:
    """Delete a scan and the files of it alone. Raises NotFound, Conflict (worked on, a job runs)."""
    with services.writing() as session:
        scan = store.get_scan(session, scan_id)
        require_idle(session, scan)
        store.remove_scan(session, scan_id, actor=actor)
        keys = (scan.first_source_key, scan.second_source_key, scan.first_key, scan.second_key)
        let_go(session, scan.survey_id, keys, actor)


def uploaded_strips(
    session: Session, survey_id: int, first_upload: int, second_upload: int
) -> tuple[StripSource, StripSource]:
    """Two strips that were uploaded. Raises NotFound, Conflict (not whole, or a scan's already), BadInput."""
    if first_upload == second_upload:
        raise BadInput("scans-upload-twice")
    first = _strip(session, survey_id, first_upload, "first")
    second = _strip(session, survey_id, second_upload, "second")
    if first.sha256 == second.sha256:
        raise BadInput("scans-strips-same", name=first.name, name_2=second.name)
    return first, second


def _strip(session: Session, survey_id: int, upload_id: int, word: str) -> StripSource:
    upload = get_upload(session, upload_id)
    if upload.survey_id != survey_id:
        raise BadInput("scans-strip-other-survey", word=word)
    if upload.purpose != "strip":
        raise BadInput("scans-upload-is-video", filename=upload.filename)
    if upload.scan_id is not None:
        raise Conflict("scans-upload-used", filename=upload.filename)
    return _arrived(upload, word)


def _arrived(upload: Upload, word: str) -> StripSource:
    if upload.finished_at is None or upload.sha256 is None:
        raise Conflict("scans-strip-incomplete", word=word, filename=upload.filename)
    return StripSource(upload.filename, upload.media_key, upload.sha256, upload.id)


def open_strips(services: Services, scan: Scan) -> tuple[StripReader, StripReader]:
    """Readers of both stored strips. Raises BadInput until the scan is ready, NotFound, Damaged."""
    return open_strip(services, scan, 1), open_strip(services, scan, 2)


def open_strip(services: Services, scan: Scan, camera: int) -> StripReader:
    """The reader of one camera's stored strip (1 or 2)."""
    require_ready(scan)
    key = scan.first_key if camera == 1 else scan.second_key
    assert key is not None
    path = services.media.local_path(key)
    return _READERS.reader(path, f"camera {camera} of {scan.name}", scan.bits or 8)
