"""A job."""

from dataclasses import dataclass
from datetime import datetime
from typing import TypedDict

from sightline.enums import JobState, JsonObject
from sightline.messages.said import Said


class JobOf(TypedDict, total=False):
    """What a job is of, beside its survey."""

    recording_id: int | None
    scan_id: int | None
    study_id: int | None


@dataclass(frozen=True, slots=True)
class Job:
    """A piece of long work; the job table owns the truth about it.

    `message`: what is being done. `error`: why it failed. `outages`: how often the database or the storage
    was away while it was done; it is begun again `not_before` then.
    """

    id: int
    kind: str
    state: JobState
    payload: JsonObject
    progress: float
    message: Said | None
    error: Said | None
    result: JsonObject | None
    survey_id: int | None
    recording_id: int | None
    created_by: int | None
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None
    attempts: int
    worker: str | None
    cancel_requested: bool
    scan_id: int | None = None
    study_id: int | None = None
    outages: int = 0
    not_before: datetime | None = None
