"""Calibrations as they go in and out."""

from datetime import datetime
from typing import Any, Literal

from pydantic import Field

from backend.api.bodies import FrameNumber, Id, In, Out, WhoBody

Source = Literal["images", "clip", "import"]


class CalibrationSummaryBody(Out):
    id: int
    camera_id: int
    created_at: datetime
    created_by: WhoBody | None
    source: Source
    trusted: bool
    summary: str


class ViewBody(Out):
    """One picture of a calibration; residuals are seen minus modelled, in the order of the corners."""

    file: str
    image_id: int | None
    frame: int | None
    used: bool
    reason: str | None
    rms_px: float | None
    corners_px: list[list[float]]
    residuals_px: list[list[float]]


class CalibrationBody(CalibrationSummaryBody):
    document: dict[str, Any] = Field(description="camera.json (contract.md).")
    warnings: list[str]
    coverage: list[list[int]] = Field(description="Corners per cell, 12 rows of 16; empty for an import.")
    views: list[ViewBody]
    recording_id: int | None


class CalibrationWish(In):
    """From the camera's images, or with `recording_id` from every n-th frame of a span of a recording."""

    columns: int = Field(ge=2, le=100)
    rows: int = Field(ge=2, le=100)
    square_m: float = Field(gt=0, le=10, allow_inf_nan=False)
    model: Literal["brown", "fisheye"] = "brown"
    recording_id: Id | None = None
    every: int | None = Field(default=None, ge=1, le=2**31 - 1)
    first_frame: FrameNumber | None = None
    last_frame: FrameNumber | None = None
