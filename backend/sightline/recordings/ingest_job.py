"""Ingest: the frame table, facts and thumbnails of an uploaded video, as a job; all of it or nothing."""

import tempfile
import zipfile
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from statistics import median
from typing import Any

from sightline.enums import Lighting
from sightline.errors import BadInput, Conflict, NotFound
from sightline.infra.database import Session
from sightline.infra.database.types import now
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Finish, JobContext
from sightline.infra.services import Services
from sightline.infra.stored_bytes import let_go
from sightline.media.store.local import COPY, THUMBS, MediaStore, made_key_of
from sightline.media.video.decode import require_whole
from sightline.media.video.ingest import Ingested, ingest
from sightline.media.video.remux import COPY_SUFFIXES
from sightline.messages.said import Said
from sightline.recordings import store as recordings
from sightline.recordings.frames.records import lasting_s
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.records import Facts, Recording

KIND = "ingest"
PASSES = "passes"
STOPPED = Said("recordings-import-cancelled")
# Mean luminance (0-255) below which low light is proposed; people decide.
LOW_LIGHT_BELOW = 60.0


def queue_ingest(session: Session, recording: Recording, actor: int | None) -> Job:
    """Queue the ingest of a recording in the caller's transaction."""
    return registry.enqueue(
        session, KIND, {}, survey_id=recording.survey_id, recording_id=recording.id, actor=actor
    )


def retry_ingest(services: Services, recording_id: int, actor: int) -> Job:
    """Read the video again. Raises NotFound, and Conflict while an ingest waits or runs."""
    with services.writing() as session:
        recording = recordings.get_recording(session, recording_id)
        if recording.job and recording.job.kind == KIND and recording.job.state in ("queued", "running"):
            raise Conflict("recordings-importing-already", name=recording.name)
        recording = recordings.restart_ingest(session, recording_id, actor=actor)
        job = queue_ingest(session, recording, actor)
    stills_of(services).forget(recording_id)
    return job


def mark_failed(session: Session, job: Job, error: Said) -> None:
    """With the job's end: the recording is not ready, and why."""
    if job.recording_id is None:
        return
    try:
        reason = STOPPED if error == registry.STOPPED else error
        recordings.note_ingest_failed(session, job.recording_id, reason, actor=job.created_by)
    except NotFound:
        return  # deleted meanwhile


def read_at_rate(services: Services, recording_id: int, filmed_hz: float, actor: int) -> Job:
    """Read the video again with the times of filming at a rate that a person states.

    Raises NotFound, Conflict, BadInput for one of several edits, which an earlier version read.
    """
    with services.reading() as session:
        recordings.require_times_in_doubt(session, recording_id)
        recording = recordings.get_recording(session, recording_id)
    path = services.media.local_path(recording.media_key)
    require_whole(path, recording.name, recording.stream_number)
    with services.writing() as session:
        recording = recordings.state_filming_rate(session, recording_id, filmed_hz, actor=actor)
        job = queue_ingest(session, recording, actor)
    stills_of(services).forget(recording_id)
    return job


def add_picture(session: Session, recording_id: int, number: int, actor: int) -> Recording:
    """Another picture of a recording's file as a recording of its own, to be read.

    Raises NotFound; BadInput where the file has no such picture, one that is still or switched off;
    Conflict where the survey has it already.
    """
    of = recordings.get_recording(session, recording_id)
    pictures = of.report.get("pictures", [])
    if not 1 <= number <= len(pictures):
        raise BadInput("video-no-such-stream", name=of.name, number=number, count=max(1, len(pictures)))
    if pictures[number - 1]["still"]:
        raise BadInput("video-track-is-still", name=of.name, number=number)
    if pictures[number - 1]["off"]:
        raise BadInput("video-stream-is-off", name=of.name, number=number)
    for one in recordings.list_recordings(session, of.survey_id):
        if (one.sha256, one.stream_number) == (of.sha256, number):
            raise Conflict("recordings-picture-is-there", number=number, name=one.name)
    created = recordings.create_recording(
        session,
        of.survey_id,
        name=f"{of.name} ({number})",
        media_key=of.media_key,
        sha256=of.sha256,
        size_bytes=of.size_bytes,
        stream_number=number,
        actor=actor,
    )
    queue_ingest(session, created, actor)
    return recordings.get_recording(session, created.id)


@registry.handler(KIND, failed=mark_failed)
def run_ingest(context: JobContext) -> Finish:
    """Decode the video once. May be killed at any moment: nothing is stored before it is whole."""
    services = context.services
    recording_id = context.job.recording_id
    assert recording_id is not None
    with services.reading() as session:
        recording = recordings.get_recording(session, recording_id)
    with tempfile.TemporaryDirectory(prefix="ingest-", dir=services.scratch) as folder:
        found = _ingest_video(
            context, services.media.local_path(recording.media_key), recording, Path(folder)
        )
        _require_same_pictures(services, recording, found)
        number = _number(found)
        if number != recording.stream_number:
            # Before files of that picture are stored: they go with the row, whatever comes of this.
            with services.writing() as session:
                recordings.change_fact(session, recording_id, "stream_number", number, actor=context.actor)
        working_copy = _keep_working_copy(services.media, recording, found)
        _keep_thumbnails(services.media, recording, Path(folder) / "thumbs", found)
    facts, table = facts_of(found, working_copy), found.frames

    def finish(session: Session) -> Mapping[str, Any]:
        recordings.note_ingested(session, recording_id, facts, table, actor=context.actor)
        if context.services.settings.find_passes:
            place = {"survey_id": recording.survey_id, "recording_id": recording_id}
            registry.enqueue(session, PASSES, {}, actor=context.actor, **place)
        return {"recording_id": recording_id, "frames": len(table)}

    return finish


def _require_same_pictures(services: Services, recording: Recording, found: Ingested) -> None:
    """Before the working copy is replaced: what was clicked on it must be on the new one, of twins too."""
    with services.reading() as session:
        for one in recordings.recordings_of_content(session, recording.sha256, _number(found)):
            recordings.require_same_pictures(session, one, found.frames)


def _ingest_video(context: JobContext, path: Path, recording: Recording, folder: Path) -> Ingested:
    context.progress(0.0, Said("job-video-reading"))
    return ingest(
        path,
        lambda fraction: context.progress(0.97 * fraction, Said("job-video-reading")),
        context.is_cancelled,
        folder / "thumbs",
        work_dir=folder,
        name=recording.name,
        stream_number=recording.stream_number,
        filmed_hz=recording.filmed_hz,
    )


def _keep_working_copy(store: MediaStore, recording: Recording, ingested: Ingested) -> str | None:
    """Store the working copy of a stream without an index and give its key; None where there is none."""
    if not ingested.is_working_copy:
        return None
    key = made_key_of(recording.sha256, COPY, _number(ingested), ingested.media_path.suffix)
    store.put_file(key, ingested.media_path, link=True)
    return key


def _keep_thumbnails(store: MediaStore, recording: Recording, folder: Path, found: Ingested) -> None:
    key = thumbnails_key_of(recording.sha256, _number(found))
    store.put_file(key, pack_thumbnails(folder, found), link=True)


def pack_thumbnails(folder: Path, found: Ingested) -> Path:
    """All thumbnails as one file: hundreds of small ones would be hundreds of requests to a distant store."""
    packed = folder.with_suffix(".zip")
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_STORED) as archive:
        for thumb in found.thumbnails:
            archive.write(folder / thumb.name, f"{thumb.n}.jpg")
    return packed


def thumbnails_key(recording: Recording) -> str:
    """Where the thumbnails of a recording's content are."""
    return thumbnails_key_of(recording.sha256, recording.stream_number)


def thumbnails_key_of(sha256: str, stream_number: int | None = None) -> str:
    """Where the thumbnails of a video with this content are, or of one of its pictures."""
    return made_key_of(sha256, THUMBS, stream_number, ".zip")


def _number(found: Ingested) -> int | None:
    """Which of several pictures was read; None of a file with one."""
    return found.facts.stream if found.facts.pictures else None


def thumbnail(services: Services, recording_id: int, n: int) -> bytes:
    """The thumbnail of frame n as JPEG. Raises NotFound where that frame has none."""
    recording = stills_of(services).open(recording_id).recording
    if n in recording.thumbs:
        with zipfile.ZipFile(services.media.local_path(thumbnails_key(recording))) as archive:
            # it is of the content: a twin that was read since may have left others than the row says
            if f"{n}.jpg" in archive.namelist():
                return archive.read(f"{n}.jpg")
    raise NotFound("recordings-no-thumbnail", n=n, name=recording.name)


def facts_of(ingested: Ingested, working_copy: str | None) -> Facts:
    """What is stored of an ingest beside the frame table."""
    facts, report = ingested.facts, ingested.report
    times = ingested.frames.time_s
    begun, ahead = ingested.stated.begun_at, list[Said]()
    if begun is not None and begun > now():
        ahead = [Said("video-start-in-future", start=f"{begun:%Y-%m-%d %H:%M}")]
        begun = None
    kept: dict[str, Any] = {
        "duplicates": report.duplicates,
        "unordered": report.unordered,
        "damaged": report.damaged,
        "rate_hz": report.rate_hz,
        "time_base": str(facts.time_base),
        "rotation_deg": facts.rotation_deg,
        "sample_aspect": str(facts.sample_aspect),
        "interlaced": facts.interlaced,
        "pixel_format": facts.pixel_format,
        "focal_35mm_mm": ingested.stated.focal_35mm_mm,
        "clock_doubt": report.clock_doubt,
    }
    if facts.pictures:
        kept["pictures"] = [asdict(one) for one in facts.pictures]
    if working_copy is not None:
        kept["working_copy"] = working_copy
    return Facts(
        width_px=facts.width_px,
        height_px=facts.height_px,
        duration_s=lasting_s(times),
        codec=facts.codec,
        container=facts.container,
        vfr=report.vfr,
        notes=[*report.notes, *ahead],
        report=kept,
        thumbs=[thumb.n for thumb in ingested.thumbnails],
        lighting_proposed=_lighting(ingested),
        start_proposed=begun,
        stream_number=_number(ingested),
    )


def _lighting(found: Ingested) -> Lighting | None:
    if not found.thumbnails:
        return None
    return "low_light" if median(one.luminance for one in found.thumbnails) < LOW_LIGHT_BELOW else "daytime"


def correct_durations(services: Services) -> None:
    """After a start: give recordings that an earlier version read the duration of their frame tables."""
    if services.read_only:
        return
    with services.reading() as session:
        found = recordings.durations_to_correct(session)
    for recording_id, duration_s in found.items():
        with services.writing() as session:
            recordings.change_fact(session, recording_id, "duration_s", duration_s, actor=None)


def remove_recording(services: Services, recording_id: int, actor: int) -> None:
    """Delete a recording without measurements, and its files if nothing else has the same content.

    Raises NotFound, Conflict (measurements, or an ingest is running).
    """
    with services.writing() as session:
        recording = recordings.get_recording(session, recording_id)
        if recording.job and recording.job.kind == KIND and recording.job.state in ("queued", "running"):
            raise Conflict("recordings-importing", name=recording.name)
        recordings.remove_recording(session, recording_id, actor=actor)
        # a reading that failed may have left a working copy of which no row tells
        copies = (
            made_key_of(recording.sha256, COPY, recording.stream_number, suffix) for suffix in COPY_SUFFIXES
        )
        keys = (recording.media_key, thumbnails_key(recording), *copies)
        let_go(session, recording.survey_id, keys, actor)
    stills_of(services).forget(recording_id)
