"""What road poses take and answer."""

from typing import Annotated

from pydantic import Field

from sightline.cameras.board_bodies import BoardIn, Markers
from sightline.cameras.calibrations.bodies import CameraDocument
from sightline.enums import BoardSide
from sightline.geometry.road_pose import BoardOnRoad
from sightline.infra.web.bodies import Finite, FrameNumber, Out, of_record
from sightline.infra.web.named import CalibrationId
from sightline.messages.said import Said
from sightline.poses.records import ExpectedHeight, PoseOverlay, PoseSummary

Corners = Annotated[int, Field(ge=2, le=60, description="Inner corners: where four squares meet.")]


HeightAboveRoad = Annotated[Finite, Field(ge=-1, le=10)]


class BoardWanted(BoardIn):
    frame: FrameNumber
    columns: Corners
    rows: Corners
    calibration_id: CalibrationId | None = None


class PoseWanted(Markers):
    calibration_id: CalibrationId
    first_frame: FrameNumber
    last_frame: FrameNumber
    columns: Corners
    rows: Corners
    square_m: Annotated[Finite, Field(gt=0, le=5)]
    reference: BoardSide
    reference_height_m: HeightAboveRoad
    u_reference_height_m: Annotated[Finite, Field(ge=0, le=1)] = 0.003
    u_lean_rad: Annotated[Finite, Field(ge=0, le=1)] = 0.005
    u_square_m: Annotated[
        Finite | None, Field(ge=0, le=1, description="Of a square's side; null: 0.1 % of it, an estimate.")
    ] = None
    u_bow_m: Annotated[Finite, Field(ge=0, le=1, description="Middle of the board out of plane.")] = 0.0005


@of_record(PoseSummary, "survey_id", "created_by", "turned_from", "turned_by_rad", "adjusted_from")
class PoseSummaryBody(Out):
    pass


class CamFromRoad(Out):
    rotation: list[list[float]]
    translation_m: list[float]


class PoseDocument(Out):
    """`pose.json` (docs/formats.md)."""

    format: str
    camera: CameraDocument
    cam_from_road: CamFromRoad
    parameters: list[str]
    covariance: list[list[float]] | None
    board: BoardOnRoad | None = Field(description="Null for a pose that was not made from a board.")
    frames_used: int
    rms_px: float | None


class PoseBody(PoseSummaryBody):
    document: PoseDocument = Field(description="The pose as pose.json.")
    warnings: list[Said]
    expected: list[ExpectedHeight]
    overlay: PoseOverlay
