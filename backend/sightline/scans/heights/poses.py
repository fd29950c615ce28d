"""The pose of a scan's line camera from rod marks: solved to look at, and stored."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from math import sqrt

import numpy as np

from sightline.enums import JsonObject
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.infra.version import code_version
from sightline.linescan.line_pose import LinePose, LinePoseError, solve_line_pose
from sightline.messages.said import Said
from sightline.scans.heights.pose_store import append_line_pose
from sightline.scans.heights.records import LinePoseValues, StoredLinePose
from sightline.scans.service import require_ready, shows
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
    """What the marks give, or the reason why nothing. `residuals_px`: row of the model minus mark."""

    status: str
    reason: Said | None = None
    camera_height_m: float | None = None
    u_camera_height_m: float | None = None
    rms_px: float | None = None
    residuals_px: tuple[float, ...] = ()
    warnings: tuple[Said, ...] = ()


def preview_line_pose(rod: Rod) -> SolvedRod:
    """The pose that these marks would be stored with. Never raises for what was clicked."""
    try:
        pose = _solved(rod)
    except LinePoseError as error:
        return SolvedRod("not_solvable", error.said)
    return _told(pose, rod)


def line_pose_result(stored: StoredLinePose) -> SolvedRod:
    """The same of a stored pose."""
    return _told(pose_of(stored.values), rod_of(stored.values))


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
        if not shows(scan, mark.line, mark.row_px):
            raise BadInput("scans-mark-row-line-lies-outside-strip", row_px=mark.row_px, line=mark.line)
    pose = _solved(rounded)
    values = solved_values(
        pose,
        [asdict(mark) for mark in rounded.marks],
        sigma_px=rounded.sigma_px,
        u_distance_m=rounded.u_distance_m,
        u_lean_rad=rounded.u_lean_rad,
    )
    return append_line_pose(session, scan_id, values, seen_revision=seen_revision, actor=actor)


def solved_values(
    pose: LinePose,
    marks: list[JsonObject],
    *,
    sigma_px: float | None,
    u_distance_m: float,
    u_lean_rad: float,
) -> LinePoseValues:
    """A solved pose as it is stored."""
    return LinePoseValues(
        marks=marks,
        sigma_px=sigma_px,
        u_distance_m=u_distance_m,
        u_lean_rad=u_lean_rad,
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
    distance, height, row = _columns(rod.marks)
    return solve_line_pose(
        distance,
        height,
        row,
        sigma_px=rod.sigma_px,
        u_distance_m=rod.u_distance_m,
        u_lean_rad=rod.u_lean_rad,
    )


def _told(pose: LinePose, rod: Rod) -> SolvedRod:
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
