"""Recordings of a survey: what they are, what belongs to them, and trying an ingest again."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Annotated, Any

from fastapi import APIRouter
from fastapi.responses import FileResponse
from pydantic import Field

from sightline.cameras.calibrations.store import documents_in_force
from sightline.enums import FILMED_HZ, ClockDoubt, Lighting, StreetLamps, StreetLighting
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.web.bodies import In, JobBody, Name, Out, example
from sightline.infra.web.deps import Exporter, Operator, PathId, Reading, Uploader, Viewer, Wired, Writing
from sightline.infra.web.named import CameraId, PoseId
from sightline.media.video.decode import Picture
from sightline.messages.said import Said
from sightline.recordings import ingest_job, store
from sightline.recordings.bodies import StartIn
from sightline.recordings.csv import started_text
from sightline.recordings.drift_request import request_if_posed
from sightline.recordings.filming import lamps_misfits, misfits, start_of
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.records import Recording, RecordingChanges, RecordingFacts
from sightline.surveys.store import get_survey

router = APIRouter()


class Thumb(Out):
    frame: int
    url: str


class RateIn(In):
    filmed_hz: float = Field(
        ge=FILMED_HZ[0], le=FILMED_HZ[1], description="Frames per second when it was filmed."
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class RecordingBody(RecordingFacts):
    """A recording with the addresses of its thumbnails."""

    job: JobBody | None
    pictures: list[Picture]
    clock_doubt: Annotated[
        ClockDoubt | None,
        Field(description="Why its times are not those of filming, so that no motion is measured."),
    ]
    started_local: Annotated[
        str | None, Field(description="`started_at` by the clocks of `time_zone`, ISO 8601 with offset.")
    ]
    misfits: Annotated[
        list[Said],
        Field(description="Where it does not fit its camera's calibration or its survey, in sentences."),
    ]
    thumbs: list[Thumb]


class RecordingChange(In):
    """Any subset; what is left out stays."""

    model_config = example(
        name="Hill road, morning", lighting="daytime", weather="dry", street_lighting="off"
    )

    name: Name = Field(default="", validate_default=False)
    camera_id: CameraId | None = None
    pose_id: PoseId | None = None
    lighting: Lighting | None = None
    start: Annotated[StartIn | None, Field(description="Null: nobody has confirmed it.")] = None
    weather: Annotated[str, Field(max_length=100)] | None = None
    street_lighting: StreetLighting | None = None


def recording_body(
    recording: Recording, lens: Mapping[str, Any] | None, lamps: StreetLamps | None
) -> RecordingBody:
    """A recording as it goes out; `lens`: its camera's calibration, `lamps`: whether its road has lamps."""
    size, focal = (recording.width_px, recording.height_px), recording.report.get("focal_35mm_mm")
    of_lens = [] if lens is None else misfits(size, focal, lens)
    address = f"/api/recordings/{recording.id}/thumbs"
    return filled_from(
        RecordingBody,
        recording,
        job=None if recording.job is None else JobBody.model_validate(recording.job),
        started_local=started_text(recording.started_at, recording.time_zone),
        pictures=[Picture(**one) for one in recording.report.get("pictures", [])],
        clock_doubt=recording.report.get("clock_doubt"),
        misfits=[*of_lens, *lamps_misfits(recording.street_lighting, lamps)],
        thumbs=[Thumb(frame=n, url=f"{address}/{n}.jpg?v={recording.sha256[:12]}") for n in recording.thumbs],
    )


@router.get("/surveys/{survey_id}/recordings")
def list_recordings(survey_id: PathId, who: Viewer, session: Reading) -> list[RecordingBody]:
    """The recordings of a survey, in the order in which they came."""
    found = store.list_recordings(session, survey_id)
    lenses = documents_in_force(session, [one.camera_id for one in found])
    lamps = get_survey(session, survey_id).place.street_lamps
    return [recording_body(one, lenses.get(one.camera_id), lamps) for one in found]


@router.get("/recordings/{recording_id}")
def get_recording(recording_id: PathId, who: Viewer, session: Reading) -> RecordingBody:
    """One recording with its latest job."""
    return _body(session, store.get_recording(session, recording_id))


def _body(session: Session, recording: Recording) -> RecordingBody:
    lenses = documents_in_force(session, [recording.camera_id])
    lamps = get_survey(session, recording.survey_id).place.street_lamps
    return recording_body(recording, lenses.get(recording.camera_id), lamps)


@router.get("/recordings/{recording_id}/video", response_class=FileResponse)
def download_video(recording_id: PathId, who: Exporter, services: Wired) -> FileResponse:
    """The video as it was uploaded, byte for byte, under the name of its recording."""
    with services.reading() as session:
        recording = store.get_recording(session, recording_id)
    path = services.media.local_path(recording.media_key)
    # never shown within the app's own origin, whatever was uploaded as a video
    return FileResponse(
        path, media_type="application/octet-stream", filename=_file_name(recording.name, path.suffix)
    )


def _file_name(name: str, suffix: str) -> str:
    """A recording's name as a file's, with the ending that its file came with."""
    plain = re.sub(r"[\\/:*?\"<>|\x00-\x1f]+", "-", name).strip(" .-") or "recording"
    return plain if plain.lower().endswith(suffix) else f"{plain}{suffix}"


@router.put("/recordings/{recording_id}")
def change_recording(
    recording_id: PathId, body: RecordingChange, who: Operator, services: Wired
) -> RecordingBody:
    """Change name, camera, road pose, lighting, or when and in what weather it was filmed."""
    given = body.model_dump(exclude_unset=True, exclude={"start"})
    if body.weather is not None:
        given["weather"] = body.weather.strip() or None
    if "start" in body.model_fields_set:
        said = body.start
        given["filming"] = said and start_of(said.local, said.time_zone, datetime.now(UTC))
    changes = RecordingChanges(**given)  # type: ignore[typeddict-item]
    with services.writing() as session:
        changed = store.update_recording(session, recording_id, changes, actor=who.id)
        if changes.get("pose_id") is not None:
            request_if_posed(session, recording_id, actor=who.id)
        answer = _body(session, changed)
    stills_of(services).forget(recording_id)
    return answer


@router.delete("/recordings/{recording_id}", status_code=204)
def remove_recording(recording_id: PathId, who: Operator, services: Wired) -> None:
    """Delete a recording without measurements, and its file if no other recording has it."""
    ingest_job.remove_recording(services, recording_id, who.id)


@router.post("/recordings/{recording_id}/ingest", status_code=202)
def retry_ingest(recording_id: PathId, who: Uploader, services: Wired) -> JobBody:
    """Read the video again, after a failed or cancelled ingest."""
    return JobBody.model_validate(ingest_job.retry_ingest(services, recording_id, who.id))


@router.put("/recordings/{recording_id}/filming-rate", status_code=202)
def state_filming_rate(recording_id: PathId, body: RateIn, who: Operator, services: Wired) -> JobBody:
    """State at what rate it was filmed, where its times are in doubt; it is read again with those times."""
    return JobBody.model_validate(ingest_job.read_at_rate(services, recording_id, body.filmed_hz, who.id))


@router.post("/recordings/{recording_id}/pictures/{number}", status_code=201)
def add_picture(recording_id: PathId, number: PathId, who: Operator, session: Writing) -> RecordingBody:
    """Read another picture of its file, as a recording of its own."""
    return _body(session, ingest_job.add_picture(session, recording_id, number, who.id))
