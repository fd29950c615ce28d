"""A calibration, and the pictures that it was made of."""

from dataclasses import dataclass

from sightline.cameras.records import CalibrationSummary
from sightline.enums import JsonObject
from sightline.messages.said import Said


@dataclass(frozen=True, slots=True)
class Calibration(CalibrationSummary):
    """A calibration with its camera.json `document`; never changed once written."""

    document: JsonObject
    warnings: list[Said]
    coverage: list[list[int]]
    views: list[JsonObject]
    recording_id: int | None


@dataclass(frozen=True, slots=True)
class Detection:
    """What was found of a board in one picture, or the `reason` why not.

    `corners_px`: (x, y) row by row of the board as seen, which has `columns` by `rows` inner corners. `ids`:
    which of them were seen, None for all; `dictionary` and `marker_share` (of a square's side): of a board
    with markers.
    """

    found: bool
    reason: Said | None
    corners_px: list[list[float]]
    columns: int
    rows: int
    sharpness: float | None
    ids: list[int] | None = None
    dictionary: str | None = None
    marker_share: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationImage(Detection):
    """A picture of the board and what was found in it."""

    id: int
    camera_id: int
    name: str
    media_key: str
    width_px: int
    height_px: int
