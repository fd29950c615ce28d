"""A camera, and what is told of its calibration in a list."""

from dataclasses import dataclass
from datetime import datetime
from typing import TypedDict

from sightline.enums import CalibrationSource
from sightline.infra.audit.records import Who
from sightline.messages.said import Said


@dataclass(frozen=True, slots=True)
class CalibrationSummary:
    id: int
    camera_id: int
    created_at: datetime
    created_by: Who | None
    source: CalibrationSource
    trusted: bool
    summary: Said


@dataclass(frozen=True, slots=True)
class Camera:
    """A body and lens at one setting; `lens`, `zoom` and `focus` in words, `taken_from` the survey and camera
    that it was taken from, empty for one of this survey's own.
    """

    id: int
    survey_id: int
    name: str
    notes: str
    lens: str
    zoom: str
    focus: str
    taken_from: str
    current_calibration_id: int | None
    images: int
    calibrations: tuple[CalibrationSummary, ...]


class CameraWords(TypedDict, total=False):
    """What people say of a camera; keys left out stay as they are."""

    name: str
    notes: str
    lens: str
    zoom: str
    focus: str
