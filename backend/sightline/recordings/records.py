"""A recording, what its ingest found, and what a person may change of it."""

from dataclasses import dataclass, field
from datetime import datetime
from typing import Annotated, TypedDict

from pydantic import Field

from sightline.enums import JsonObject, Lighting, RecordingState, StreetLighting
from sightline.infra.jobs.records import Job
from sightline.infra.meaning import explained_as
from sightline.messages.said import Said
from sightline.recordings.drift import DriftChecks, DriftDecision
from sightline.recordings.filming import Filming


@dataclass(frozen=True, slots=True)
class Facts:
    """What the ingest found out about a video."""

    width_px: int
    height_px: int
    duration_s: float
    codec: str
    container: str
    vfr: bool
    notes: list[Said] = field(default_factory=list)
    report: JsonObject = field(default_factory=dict)
    thumbs: list[int] = field(default_factory=list)
    lighting_proposed: Lighting | None = None
    start_proposed: datetime | None = None
    stream_number: int | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("recordings")
class RecordingFacts:
    """What is said of a video; facts None until ready. `started_at`: as said, by the clocks of its zone."""

    id: int
    survey_id: int
    name: str
    state: RecordingState
    error: Said | None
    sha256: str
    size_bytes: int
    width_px: int | None
    height_px: int | None
    frame_count: int | None
    duration_s: float | None
    codec: str | None
    container: str | None
    vfr: bool
    notes: list[Said]
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None
    lighting_proposed: Lighting | None
    stream_number: int | None
    filmed_hz: float | None
    start_proposed: Annotated[
        datetime | None, Field(description="When it was begun, as its file states; for a person to confirm.")
    ]
    started_at: Annotated[datetime | None, Field(description="As a person confirmed.")]
    time_zone: str | None
    weather: str | None
    street_lighting: StreetLighting | None
    created_at: datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class Recording(RecordingFacts):
    """A video; `thumbs` are the frame numbers that have a thumbnail."""

    job: Job | None
    media_key: str
    report: JsonObject
    thumbs: list[int]
    drift: DriftChecks | None
    drift_decision: DriftDecision | None


class RecordingChanges(TypedDict, total=False):
    """What people may change of a recording; keys left out stay as they are."""

    name: str
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None
    filming: Filming | None
    weather: str | None
    street_lighting: StreetLighting | None
