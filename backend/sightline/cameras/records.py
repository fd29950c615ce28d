"""A camera, and what is told of its calibration in a list."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, TypedDict

from pydantic import Field

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


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraFacts:
    """A body and lens at one setting; `lens`, `zoom` and `focus` in words."""

    id: int
    survey_id: int
    name: str
    notes: str
    lens: str
    zoom: str
    focus: str
    taken_from: Annotated[
        str, Field(description="Survey and camera that it was taken from; empty for one of its own.")
    ]
    current_calibration_id: int | None
    calibrations: tuple[CalibrationSummary, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Camera(CameraFacts):
    """A camera with the number of its images."""

    images: int


class CameraWords(TypedDict, total=False):
    """What people say of a camera; keys left out stay as they are."""

    name: str
    notes: str
    lens: str
    zoom: str
    focus: str
