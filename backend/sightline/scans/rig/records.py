"""Calibrations of a rig, as they are stored and as they are answered."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import JsonObject, ScanPoseStatus
from sightline.infra.audit.records import Who
from sightline.linescan.rig_calibration import FittedPass
from sightline.messages.said import Said
from sightline.scans.records import StoredRevision
from sightline.scans.rig.passes_csv import RefusedRow


@dataclass(frozen=True, slots=True, kw_only=True)
class RigCalibrationValues:
    """A calibration: its passes (fields of a linescan `RigPass` each), what they share, what both give."""

    passes: list[JsonObject]
    line_rate_hz: float
    u_line_rate_ratio: float
    u_tape_ratio: float
    u_speed_ratio: float
    baseline_m: float
    u_baseline_m: float
    divergence_rad: float
    u_divergence_rad: float
    baseline_correlation: float
    chi2: float
    degrees_of_freedom: int
    p_value: float
    code_version: str


StoredRigCalibration = StoredRevision[RigCalibrationValues]


@dataclass(frozen=True, slots=True, kw_only=True)
class LaneOfRig:
    """The baseline at the distance of the rig's vehicles, with what every speed there has of it. `name`: of
    the lane, where the rig has several.
    """

    name: str | None = None
    distance_m: float
    baseline_m: float
    u_baseline_m: float
    U95_baseline_m: float
    U95_percent: Annotated[float, Field(description="Of every speed and length there.")]
    warning: Said | None


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationFigures:
    """What passes give; U95 beside each value. `lane`: None where the rig has no distance to its vehicles;
    `lanes`: each lane of the rig.
    """

    baseline_m: float
    u_baseline_m: float
    U95_baseline_m: float
    divergence_rad: float
    u_divergence_rad: float
    U95_divergence_rad: float
    baseline_correlation: float
    chi2: float
    degrees_of_freedom: int
    p_value: float
    nearest_m: float
    farthest_m: float
    passes: tuple[FittedPass, ...]
    lane: LaneOfRig | None
    lanes: tuple[LaneOfRig, ...]
    warnings: tuple[Said, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationLook:
    """What passes of a table would give, or why nothing; rows that cannot be used."""

    status: ScanPoseStatus
    reason: Said | None
    figures: CalibrationFigures | None
    refused: tuple[RefusedRow, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class RigCalibrationShown:
    """A stored calibration. `in_force`: the rig has its values now."""

    id: int
    revision: int
    in_force: bool
    figures: CalibrationFigures
    created_by: Who | None
    created_at: datetime
