"""Recordings of a survey: what they are, what belongs to them, and trying an ingest again."""

from datetime import datetime

from fastapi import APIRouter
from pydantic import Field

from sightline.enums import Lighting, RecordingState
from sightline.infra.web.bodies import Id, In, JobBody, Name, Out
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired
from sightline.recordings import ingest_job, store
from sightline.recordings.drift_request import request_if_posed
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.records import Recording, RecordingChanges

router = APIRouter()


class Thumb(Out):
    frame: int
    url: str


class RecordingBody(Out):
    id: int
    survey_id: int
    name: str
    state: RecordingState
    error: str | None
    job: JobBody | None
    sha256: str
    size_bytes: int
    width_px: int | None
    height_px: int | None
    frame_count: int | None
    duration_s: float | None
    codec: str | None
    container: str | None
    vfr: bool
    notes: list[str]
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None
    lighting_proposed: Lighting | None
    created_at: datetime
    thumbs: list[Thumb]


class RecordingChange(In):
    """Any subset; what is left out stays."""

    name: Name = Field(default="", validate_default=False)
    camera_id: Id | None = None
    pose_id: Id | None = None
    lighting: Lighting | None = None


def recording_body(recording: Recording) -> RecordingBody:
    """A recording as it goes out, with the addresses of its thumbnails."""
    values = {name: getattr(recording, name) for name in RecordingBody.model_fields if name != "thumbs"}
    address = f"/api/recordings/{recording.id}/thumbs"
    thumbs = [Thumb(frame=n, url=f"{address}/{n}.jpg?v={recording.sha256[:12]}") for n in recording.thumbs]
    return RecordingBody.model_validate({**values, "thumbs": thumbs})


@router.get("/surveys/{survey_id}/recordings")
def list_recordings(survey_id: PathId, who: Viewer, session: Reading) -> list[RecordingBody]:
    """The recordings of a survey, in the order in which they came."""
    return [recording_body(one) for one in store.list_recordings(session, survey_id)]


@router.get("/recordings/{recording_id}")
def get_recording(recording_id: PathId, who: Viewer, session: Reading) -> RecordingBody:
    """One recording with its latest job."""
    return recording_body(store.get_recording(session, recording_id))


@router.put("/recordings/{recording_id}")
def change_recording(
    recording_id: PathId, body: RecordingChange, who: Operator, services: Wired
) -> RecordingBody:
    """Change name, camera, road pose or lighting."""
    changes = RecordingChanges(**body.model_dump(exclude_unset=True))  # type: ignore[typeddict-item]
    with services.writing() as session:
        changed = store.update_recording(session, recording_id, changes, actor=who.id)
        if changes.get("pose_id") is not None:
            request_if_posed(session, recording_id, actor=who.id)
    stills_of(services).forget(recording_id)
    return recording_body(changed)


@router.delete("/recordings/{recording_id}", status_code=204)
def remove_recording(recording_id: PathId, who: Operator, services: Wired) -> None:
    """Delete a recording without measurements, and its file if no other recording has it."""
    ingest_job.remove_recording(services, recording_id, who.id)


@router.post("/recordings/{recording_id}/ingest", status_code=202)
def retry_ingest(recording_id: PathId, who: Operator, services: Wired) -> JobBody:
    """Read the video again, after a failed or cancelled ingest."""
    return JobBody.model_validate(ingest_job.retry_ingest(services, recording_id, who.id))
