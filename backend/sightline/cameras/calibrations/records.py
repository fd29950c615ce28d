"""A calibration, and the pictures that it was made of."""

from dataclasses import dataclass
from typing import Annotated, NotRequired, TypedDict

from pydantic import Field

from sightline.cameras.records import CalibrationSummary
from sightline.enums import CalibrationSource, JsonObject, Point
from sightline.messages.said import Said


class NewCalibration(TypedDict):
    """What is to be stored of a calibration."""

    source: CalibrationSource
    document: JsonObject
    trusted: bool
    warnings: list[Said]
    coverage: list[list[int]]
    views: list[JsonObject]
    summary: Said
    recording_id: NotRequired[int | None]


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
    """The board found in one picture, `columns` by `rows` inner corners as seen, or the `reason` why not."""

    found: bool
    reason: Said | None
    corners_px: Annotated[list[Point], Field(description="Row by row, from the top left as seen.")]
    columns: int
    rows: int
    sharpness: float | None
    ids: Annotated[
        list[int] | None, Field(description="Which corners were seen, row by row; null for all of them.")
    ] = None
    dictionary: Annotated[
        str | None, Field(description="Of a ChArUco board's markers; null for a checkerboard.")
    ] = None
    marker_share: Annotated[
        float | None, Field(description="Side of a marker over the side of a square.")
    ] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ImageFacts(Detection):
    """A picture of the board and what was found in it."""

    id: int
    name: str
    width_px: int
    height_px: int


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationImage(ImageFacts):
    """One as it is stored."""

    camera_id: int
    media_key: str
