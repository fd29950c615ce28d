"""Calibrations as they go in and out."""

from typing import Any

import numpy as np
from pydantic import Field

from sightline.cameras.board_bodies import Markers
from sightline.cameras.calibrations.calibrating import CHECKS
from sightline.cameras.calibrations.records import Calibration
from sightline.enums import LensModel, Point
from sightline.geometry.camera import Camera, View
from sightline.geometry.height_effect import HeightDifference
from sightline.geometry.reshoot import places_missing
from sightline.infra.web.bodies import FrameNumber, Out, of_record
from sightline.infra.web.named import RecordingId
from sightline.messages.said import Said


class ViewBody(Out):
    """One picture of a calibration; residuals are seen minus modelled, in the order of the corners."""

    file: str
    image_id: int | None
    frame: int | None
    used: bool
    reason: Said | None
    rms_px: float | None
    corners_px: list[Point]
    residuals_px: list[Point]


class CrossValidationBody(Out):
    """Two halves of the pictures, calibrated separately. Where that could not be done, `reason` says why."""

    reason: Said | None
    views: list[int] | None = Field(description="How many are in each half.")
    fit_rms_px: float | None
    held_out_rms_px: float | None = Field(description="Of each half's views under the other half's lens.")
    height_differences: list[HeightDifference] = Field(
        description="Camera level, 1.5 m high, board at 3 m, eye at 1.16 m; at 2, 3 and 5 m."
    )


class BoardShapeBody(Out):
    """How far the board is from flat, from the pictures; `solved`: whether the calibration allows for it."""

    solved: bool
    bow_m: float = Field(description="From the most forward to the rearmost corner.")
    flat_rms_px: float | None
    bent_rms_px: float | None
    height_differences: list[HeightDifference] = Field(description="Taken as flat minus taken as bent.")


@of_record(Camera)
class CameraDocument(Out):
    """`camera.json` (docs/formats.md)."""

    format: str
    rms_px: float | None
    parameters: list[str]
    covariance: list[list[float]] | None
    views: list[View]


@of_record(Calibration)
class CalibrationBody(Out):
    document: CameraDocument
    cross_validation: CrossValidationBody | None = Field(description="Null for an import.")
    board_shape: BoardShapeBody | None
    reshoot: list[Said] = Field(description="What pictures are missing.")
    coverage: list[list[int]] = Field(description="Corners per cell, 12 rows of 16; empty for an import.")
    views: list[ViewBody]


class CalibrationWish(Markers):
    """From the camera's images, or with `recording_id` from every n-th frame of a span of a recording."""

    columns: int = Field(ge=2, le=100)
    rows: int = Field(ge=2, le=100)
    square_m: float = Field(gt=0, le=10, allow_inf_nan=False)
    model: LensModel = "brown"
    recording_id: RecordingId | None = None
    every: int | None = Field(default=None, ge=1, le=2**31 - 1)
    first_frame: FrameNumber | None = None
    last_frame: FrameNumber | None = None
    bent_board: bool = Field(default=False, description="Solve for the board's shape too.")


def camera_document(made: Calibration) -> dict[str, Any]:
    """`camera.json` without the checks that are stored beside its own keys."""
    return {name: value for name, value in made.document.items() if name != CHECKS}


def calibration_body(calibration: Calibration) -> CalibrationBody:
    """A calibration as it goes out, with checks beside camera.json; an import or an older one has none."""
    document = dict(calibration.document)
    checks = document.pop(CHECKS, {})
    told = {name: getattr(calibration, name) for name in Calibration.__dataclass_fields__}
    places = places_missing(np.array(calibration.coverage, dtype=np.float64)) if calibration.coverage else ()
    none: dict[str, Any] = {"cross_validation": None, "board_shape": None, "reshoot": list(places)}
    return CalibrationBody.model_validate({**told, **none, **checks, "document": document})
