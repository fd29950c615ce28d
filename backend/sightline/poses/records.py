"""A road pose, and what is told of it in a list."""

from dataclasses import dataclass
from datetime import datetime
from typing import NotRequired

from typing_extensions import TypedDict

from sightline.enums import JsonObject
from sightline.geometry.ruler import DrawnAxes, Polyline
from sightline.infra.audit.records import Who
from sightline.infra.meaning import explained_as
from sightline.messages.said import Said


class ExpectedHeight(TypedDict):
    """How well a height of 1.2 m will be known at a distance; where the picture shows no road there, why."""

    distance_m: float
    u_height_m: float | None
    U95_height_m: float | None
    reason: Said | None


class IsoHeight(TypedDict):
    """A line of equal height above the road, in pixels."""

    height_m: float
    points: Polyline


class PoseOverlay(TypedDict):
    """A road pose as it is drawn over its picture: pixel polylines."""

    grid: list[Polyline]
    iso_heights: list[IsoHeight]
    axes: DrawnAxes | None
    corners_px: Polyline


@dataclass(frozen=True, slots=True)
@explained_as("poses")
class PoseSummary:
    """`turned_from`: the pose that it was before it was turned about the road's normal by `turned_by_rad`,
    `adjusted_from`: before it was adjusted by its traffic.
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
    summary: list[Said]
    turned_from: int | None
    turned_by_rad: float | None
    adjusted_from: int | None


class SolvedPose(TypedDict):
    """What is stored of a pose as it was solved: its pose.json, its verdict and its drawing."""

    rms_px: float | None
    distance_m: float | None
    summary: list[Said]
    document: JsonObject
    warnings: list[Said]
    expected: list[ExpectedHeight]
    overlay: PoseOverlay


class NewPose(SolvedPose):
    """One to be stored; it is made of no other one where nothing is said of that."""

    calibration_id: int
    first_frame: int
    last_frame: int
    turned_from: NotRequired[int | None]
    turned_by_rad: NotRequired[float | None]
    adjusted_from: NotRequired[int | None]


@dataclass(frozen=True, slots=True)
class Pose(PoseSummary):
    """A road pose with its pose.json `document`; never changed once written."""

    document: JsonObject
    warnings: list[Said]
    expected: list[ExpectedHeight]
    overlay: PoseOverlay
