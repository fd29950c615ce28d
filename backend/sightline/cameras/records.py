"""A camera, and what is told of its calibration in a list."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import CalibrationSource
from sightline.infra.audit.records import Who


@dataclass(frozen=True, slots=True)
class CalibrationSummary:
    id: int
    camera_id: int
    created_at: datetime
    created_by: Who | None
    source: CalibrationSource
    trusted: bool
    summary: str


@dataclass(frozen=True, slots=True)
class Camera:
    id: int
    survey_id: int
    name: str
    notes: str
    current_calibration_id: int | None
    images: int
    calibrations: tuple[CalibrationSummary, ...]
