"""The pose of a scan's line camera from rod marks: solved to look at, and stored."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from datetime import datetime
from math import sqrt
from typing import Annotated

import numpy as np
from pydantic import Field

from sightline.coverage import expanded
from sightline.enums import ScanPoseStatus
from sightline.errors import BadInput
from sightline.infra.audit.records import Who
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.version import code_version
from sightline.linescan.line_pose import LinePose, LinePoseError, solve_line_pose
from sightline.messages.said import Said
from sightline.scans.heights.pose_store import append_line_pose, line_pose_history
from sightline.scans.heights.records import LinePoseValues, StoredLinePose
from sightline.scans.service import is_within_strips, require_ready
from sightline.scans.store import get_scan

# Lengths are kept to the micrometre, which is what the CSV carries: an export recomputes to the same figure.
LENGTH_DECIMALS = 6
_WIDE_RESIDUALS = 2.5
_WIDE_HEIGHT_M = 0.05


@dataclass(frozen=True)
class Mark:
    """A mark of the rod: its stand's distance, its height above the road, its row and line in strip 1."""

    distance_m: float
    height_m: float
    row_px: float
    line: float


@dataclass(frozen=True)
class Rod:
    """All marks; uncertainties (k = 1) of a row (None: from the residuals), a distance, the lean."""

    marks: tuple[Mark, ...]
    sigma_px: float | None = None
    u_distance_m: float = 0.0
    u_lean_rad: float = 0.0


@dataclass(frozen=True)
class SolvedRod:
    """The line camera's pose from the marks, or the reason why they give none."""

    status: ScanPoseStatus
    reason: Said | None = None
    camera_height_m: float | None = None
    u_camera_height_m: float | None = None
    U95_camera_height_m: float | None = None
    rms_px: float | None = None
    residuals_px: Annotated[
        tuple[float, ...], Field(description="Row of the model minus the mark's, in the marks' order.")
    ] = ()
    warnings: tuple[Said, ...] = ()


@dataclass(frozen=True, kw_only=True)
class ShownLinePose(Rod):
    """One calibration of camera 1 with its marks."""

    id: int
    revision: int
    solved: SolvedRod
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True)
class LinePoses:
    """The calibration that counts, and all there were, oldest first."""

    current: ShownLinePose | None
    history: tuple[ShownLinePose, ...]


def preview_line_pose(rod: Rod) -> SolvedRod:
    """The pose that these marks would be stored with. Never raises for what was clicked."""
    try:
        pose = _solved(rod)
    except LinePoseError as error:
        return SolvedRod("not_solvable", error.said)
    return _describe_rod(pose, rod)


def line_pose_result(stored: StoredLinePose) -> SolvedRod:
    """The same of a stored pose."""
    return _describe_rod(pose_of(stored.values), rod_of(stored.values))


def shown_line_pose(stored: StoredLinePose) -> ShownLinePose:
    """A stored pose with what its marks say."""
    return filled_from(ShownLinePose, stored, rod_of(stored.values), solved=line_pose_result(stored))


def line_poses_of(session: Session, scan_id: int) -> LinePoses:
    """The calibrations of a scan's camera 1."""
    history = tuple(shown_line_pose(one) for one in line_pose_history(session, scan_id))
    return LinePoses(history[-1] if history else None, history)


def store_line_pose(
    session: Session, scan_id: int, rod: Rod, *, seen_revision: int, actor: int | None
) -> StoredLinePose:
    """Store a calibration, which supersedes the one before; heights keep theirs until computed again.

    Raises NotFound, Conflict, BadInput where the marks give no pose or lie outside the strip.
    """
    scan = get_scan(session, scan_id)
    require_ready(scan)
    rounded = _rounded(rod)
    for mark in rounded.marks:
        if not is_within_strips(scan, mark.line, mark.row_px):
            raise BadInput("scans-mark-outside", row_px=mark.row_px, line=mark.line)
    values = solved_values(_solved(rounded), rounded)
    return append_line_pose(session, scan_id, values, seen_revision=seen_revision, actor=actor)


def solved_values(pose: LinePose, rod: Rod) -> LinePoseValues:
    """A solved pose as it is stored."""
    return filled_from(
        LinePoseValues,
        rod,
        marks=[asdict(mark) for mark in rod.marks],
        pose={
            "parameters": pose.parameters.tolist(),
            "covariance": pose.covariance.tolist(),
            "row_span": list(pose.row_span),
        },
        camera_height_m=pose.camera_height_m,
        u_camera_height_m=sqrt(pose.covariance[3, 3]),
        rms_px=pose.rms_px,
        code_version=code_version(),
    )


def pose_of(values: LinePoseValues) -> LinePose:
    """The pose of a stored calibration."""
    document = values.pose
    low, high = document["row_span"]
    return LinePose(
        np.array(document["parameters"]), np.array(document["covariance"]), values.rms_px, (low, high)
    )


def rod_of(values: LinePoseValues) -> Rod:
    """The marks of a stored calibration."""
    marks = tuple(Mark(**mark) for mark in values.marks)
    return Rod(marks, values.sigma_px, values.u_distance_m, values.u_lean_rad)


def solve(rod: Rod) -> LinePose:
    """The pose of a rod's marks. Raises LinePoseError."""
    return _solved(_rounded(rod))


def _solved(rod: Rod) -> LinePose:
    return solve_line_pose(
        *_columns(rod.marks), sigma_px=rod.sigma_px, u_distance_m=rod.u_distance_m, u_lean_rad=rod.u_lean_rad
    )


def _describe_rod(pose: LinePose, rod: Rod) -> SolvedRod:
    distance, height, row = _columns(rod.marks)
    residuals = pose.rows_of(distance, height) - np.array(row)
    u_height = sqrt(pose.covariance[3, 3])
    warnings = []
    if rod.sigma_px is not None and pose.rms_px > _WIDE_RESIDUALS * rod.sigma_px:
        warnings.append(Said("line-pose-wide", rms_px=round(pose.rms_px, 1), sigma_px=rod.sigma_px))
    if u_height > _WIDE_HEIGHT_M:
        warnings.append(Said("line-pose-vague", u_height=round(u_height, 2)))
    return SolvedRod(
        status="ok",
        reason=None,
        camera_height_m=pose.camera_height_m,
        u_camera_height_m=u_height,
        U95_camera_height_m=expanded(u_height),
        rms_px=pose.rms_px,
        residuals_px=tuple(float(one) for one in residuals),
        warnings=tuple(warnings),
    )


def _columns(marks: Sequence[Mark]) -> tuple[list[float], list[float], list[float]]:
    return [m.distance_m for m in marks], [m.height_m for m in marks], [m.row_px for m in marks]


def _rounded(rod: Rod) -> Rod:
    marks = tuple(
        Mark(round(m.distance_m, LENGTH_DECIMALS), round(m.height_m, LENGTH_DECIMALS), m.row_px, m.line)
        for m in rod.marks
    )
    return Rod(marks, rod.sigma_px, round(rod.u_distance_m, LENGTH_DECIMALS), rod.u_lean_rad)
