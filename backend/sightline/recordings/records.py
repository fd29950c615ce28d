"""A recording, what its ingest found, and what a person may change of it."""

from dataclasses import dataclass, field
from datetime import datetime
from typing import TypedDict

from sightline.enums import (
    JsonObject,
    Lighting,
    RecordingState,
    StreetLighting,
)
from sightline.infra.jobs.records import Job
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


@dataclass(frozen=True, slots=True)
class Recording:
    """A video. Facts are None until it is ready; `thumbs` are the frame numbers that have a thumbnail.

    `start_proposed`: when the file states that it was begun; `started_at`: what a person said, with the zone
    whose clocks it is told by. `stream_number`: which of its file's pictures is read, from 1, where there are
    several; `filmed_hz`: frames per second when it was filmed, as a person said.
    """

    id: int
    survey_id: int
    name: str
    state: RecordingState
    error: Said | None
    job: Job | None
    media_key: str
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
    report: JsonObject
    thumbs: list[int]
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None
    lighting_proposed: Lighting | None
    stream_number: int | None
    filmed_hz: float | None
    start_proposed: datetime | None
    started_at: datetime | None
    time_zone: str | None
    weather: str | None
    street_lighting: StreetLighting | None
    drift: DriftChecks | None
    drift_decision: DriftDecision | None
    created_at: datetime


class RecordingChanges(TypedDict, total=False):
    """What people may change of a recording; keys left out stay as they are."""

    name: str
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None
    filming: Filming | None
    weather: str | None
    street_lighting: StreetLighting | None
