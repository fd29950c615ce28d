"""Records of people, surveys, cameras, recordings and road poses (see `records`)."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import Literal, TypedDict

import numpy as np
import numpy.typing as npt

from backend.storage.records_of_work import Job, Who
from backend.storage.words import (
    CalibrationSource,
    JsonObject,
    Lighting,
    RecordingState,
    Role,
    StepKey,
    StepState,
    UploadPurpose,
)


@dataclass(frozen=True, slots=True)
class Person:
    """An account. `session_key` changes when every signed-in session of theirs must end."""

    id: int
    name: str
    email: str
    role: Role
    active: bool
    created_at: datetime
    last_seen_at: datetime | None
    has_password: bool
    session_key: int


@dataclass(frozen=True, slots=True)
class Inset:
    """How far a target lies behind the side plane, metres, and its standard uncertainty."""

    inset_m: float
    u_inset_m: float
    note: str = ""


@dataclass(frozen=True, slots=True)
class Photograph:
    """A picture of a survey's set-up; `sha256` and the size are of the JPEG that is kept."""

    id: int
    survey_id: int
    name: str
    caption: str
    position: int
    media_key: str
    sha256: str
    size_bytes: int
    width_px: int
    height_px: int
    version: int
    created_at: datetime
    created_by: Who | None
    deleted: bool


@dataclass(frozen=True, slots=True)
class SurveyCounts:
    """Computed when asked, never stored."""

    recordings: int = 0
    vehicles: int = 0
    vehicles_measured: int = 0
    measurements: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a survey's work, and what to do next in it."""

    key: StepKey
    state: StepState
    summary: str


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """The line scans of a survey: vehicles by what was done with them, and what to do next."""

    state: Literal["none", "open", "done"]
    summary: str
    scans: int = 0
    ready: int = 0
    vehicles: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0
    not_measurable: int = 0


@dataclass(frozen=True, slots=True)
class Survey:
    id: int
    name: str
    site: str
    description: str
    is_demo: bool
    version: int
    created_at: datetime
    insets: Mapping[str, Inset]
    counts: SurveyCounts
    steps: tuple[Step, ...]
    scans: ScanProgress


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
class Calibration:
    """A calibration with its camera.json `document`; never changed once written."""

    id: int
    camera_id: int
    created_at: datetime
    created_by: Who | None
    source: CalibrationSource
    trusted: bool
    summary: str
    document: JsonObject
    warnings: list[str]
    coverage: list[list[int]]
    views: list[JsonObject]
    recording_id: int | None


@dataclass(frozen=True, slots=True)
class CalibrationImage:
    """A picture of the board and what was found in it. `ids`: which corners were seen, row by row, None for
    all; `dictionary` and `marker_share` (of a square's side): of a board with markers.
    """

    id: int
    camera_id: int
    name: str
    media_key: str
    width_px: int
    height_px: int
    found: bool
    reason: str | None
    corners_px: list[list[float]]
    columns: int
    rows: int
    sharpness: float | None
    ids: list[int] | None = None
    dictionary: str | None = None
    marker_share: float | None = None


@dataclass(frozen=True, slots=True)
class Camera:
    id: int
    survey_id: int
    name: str
    notes: str
    current_calibration_id: int | None
    images: int
    calibrations: tuple[CalibrationSummary, ...]


@dataclass(frozen=True, slots=True)
class Upload:
    """A file on its way in; `offset` bytes have arrived.

    A video becomes a recording; a strip waits, with its content's `sha256`, for the scan that it belongs to.
    """

    id: int
    survey_id: int
    filename: str
    size_bytes: int
    offset: int
    media_key: str
    created_at: datetime
    created_by: Who | None
    recording_id: int | None
    finished_at: datetime | None
    purpose: UploadPurpose = "video"
    sha256: str | None = None
    scan_id: int | None = None


@dataclass(frozen=True, slots=True)
class Facts:
    """What the ingest found out about a video."""

    width_px: int
    height_px: int
    duration_s: float
    codec: str
    container: str
    vfr: bool
    notes: list[str] = field(default_factory=list)
    report: JsonObject = field(default_factory=dict)
    thumbs: list[int] = field(default_factory=list)
    lighting_proposed: Lighting | None = None


@dataclass(frozen=True, slots=True)
class Recording:
    """A video. Facts are None until it is ready; `thumbs` are the frame numbers that have a thumbnail."""

    id: int
    survey_id: int
    name: str
    state: RecordingState
    error: str | None
    job: Job | None
    media_key: str
    sha256: str
    size_bytes: int
    width_px: int | None
    height_px: int | None
    frame_count: int | None
    duration_s: float | None
    codec: str | None
    container: str | None
    vfr: bool
    notes: list[str]
    report: JsonObject
    thumbs: list[int]
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None
    lighting_proposed: Lighting | None
    drift: JsonObject | None
    drift_decision: JsonObject | None
    created_at: datetime


class RecordingChanges(TypedDict, total=False):
    """What people may change of a recording; keys left out stay as they are."""

    name: str
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None


@dataclass(frozen=True, slots=True)
class Frame:
    n: int
    pts: int
    time_s: float
    key: bool
    crc32: int


@dataclass(frozen=True, eq=False, slots=True)
class FrameTable:
    """Frames `first .. first + len - 1` of a recording, as read-only arrays of equal length."""

    first: int
    pts: npt.NDArray[np.int64]
    time_s: npt.NDArray[np.float64]
    key: npt.NDArray[np.bool_]
    crc32: npt.NDArray[np.uint32]

    def __len__(self) -> int:
        return len(self.pts)


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
