"""A road pose, and what is told of it in a list."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import JsonObject
from sightline.infra.audit.records import Who


@dataclass(frozen=True, slots=True)
class PoseSummary:
    id: int
    survey_id: int
    recording_id: int
    calibration_id: int
    created_at: datetime
    created_by: Who | None
    first_frame: int
    last_frame: int
    rms_px: float | None
    distance_m: float | None
    summary: str
    turned_from: int | None
    turned_by_rad: float | None


@dataclass(frozen=True, slots=True)
class Pose:
    """A road pose with its pose.json `document`; never changed once written.

    `turned_from`: the pose that it was before it was turned about the road's normal by `turned_by_rad`.
    """

    id: int
    survey_id: int
    recording_id: int
    calibration_id: int
    created_at: datetime
    created_by: Who | None
    first_frame: int
    last_frame: int
    rms_px: float | None
    distance_m: float | None
    summary: str
    document: JsonObject
    warnings: list[str]
    expected: list[JsonObject]
    overlay: JsonObject
    turned_from: int | None
    turned_by_rad: float | None
