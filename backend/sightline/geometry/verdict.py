"""When a calibration is not to be trusted.

A low residual proves little: one view of a board gives a small residual and a focal length that is wrong by
a third.
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.errors import BadInput
from sightline.geometry.camera import Camera
from sightline.messages.said import Said

_FEW_VIEWS = 8
_LITTLE_COVERAGE = 0.45  # share of the picture's cells within the hull of the corners seen
_PARALLEL_RAD = np.deg2rad(15.0)
_HIGH_RMS = 1.0  # px per 1000 px of picture width, at least 0.5 px
_BETTER = 0.8  # the other model leaves less than this share of the residual
_OUTLIER = 3.0
_SAME_VIEW = 0.005  # of the picture's width
_SMALL_SQUARE_PX = 10.0
_FOCAL_OF_WIDTH = (0.05, 1000.0)  # from a fisheye of 180 degrees and more to the longest telescope
_LEAST_REACH = 0.25  # of the picture's radius: a model that turns back before that is none of this camera


@dataclass(frozen=True, eq=False)
class Evidence:
    """What a verdict rests on. Per used view: `normals`, the boards' normals in the camera frame;
    `corners_px` (N, 2); `spacings_px`, the smallest distance between neighbouring corners. `other_size`: the
    pictures left out for their size; `missed`: how many were left out otherwise.
    """

    camera: Camera
    coverage: Floats
    files: tuple[str, ...]
    rms_px: tuple[float, ...]
    normals: tuple[Floats, ...]
    other_rms_px: float | None
    other_size: tuple[str, ...]
    missed: int
    corners_px: tuple[Floats, ...]
    spacings_px: tuple[float, ...]


def calibration_warnings(evidence: Evidence) -> tuple[tuple[Said, ...], bool]:
    """Warnings, and whether the calibration can be trusted in spite of them."""
    serious = [
        *_views(evidence),
        *_spread(evidence),
        *_model(evidence),
        *_precision(evidence.camera),
    ]
    mild = [
        *_corners(evidence.camera),
        *_small_squares(evidence),
        *_outliers(evidence),
        *_left_out(evidence),
    ]
    return (*serious, *mild), not serious


def _views(evidence: Evidence) -> list[Said]:
    """Few views, or few that differ: a board that did not move between two pictures is one view."""
    count = len(evidence.files)
    if count < _FEW_VIEWS:
        return [Said("calibration-few-views", count=count, few=_FEW_VIEWS)]
    different = different_views(evidence)
    if different < _FEW_VIEWS:
        return [Said("calibration-views-alike", different=different, count=count)]
    return []


def different_views(evidence: Evidence) -> int:
    """How many views differ from every earlier one, by over half a per cent of the picture's width."""
    kept: list[Floats] = []
    for points in evidence.corners_px:
        same = (
            float(np.abs(points - other).max()) < _SAME_VIEW * evidence.camera.width_px
            for other in kept
            if other.shape == points.shape
        )
        if not any(same):
            kept.append(points)
    return len(kept)


def _spread(evidence: Evidence) -> list[Said]:
    """Coverage of the picture and variety of the board's directions."""
    out = []
    share = covered_share(evidence.coverage)
    if share < _LITTLE_COVERAGE:
        out.append(Said("calibration-little-covered", percent=round(100 * share)))
    normals = np.array(evidence.normals)
    cosines = np.clip(normals @ normals.T, -1.0, 1.0)
    if float(np.arccos(cosines.min())) < _PARALLEL_RAD:
        out.append(Said("calibration-boards-parallel"))
    return out


def covered_share(coverage: Floats) -> float:
    """Share of the picture within the outline of the covered cells, by row: a board hides no cell inside
    itself. coverage (rows, columns): corners per cell. Own method: from the first to the last covered cell of
    each row.
    """
    inside = 0
    for row in coverage:
        filled = np.flatnonzero(row)
        inside += int(filled[-1] - filled[0] + 1) if filled.size else 0
    return inside / coverage.size


def _model(evidence: Evidence) -> list[Said]:
    camera, rms = evidence.camera, evidence.camera.rms_px or 0.0
    out = []
    limit = max(0.5, _HIGH_RMS * camera.width_px / 1000.0)
    if rms > limit:
        out.append(Said("calibration-residual-high", rms_px=round(rms, 2)))
    other = evidence.other_rms_px
    if other is not None and other < _BETTER * rms:
        better = "fisheye" if camera.model == "brown" else "brown"
        out.append(
            Said(
                "calibration-other-model-better", model=better, other_px=round(other, 2), rms_px=round(rms, 2)
            )
        )
    return out


def _precision(camera: Camera) -> list[Said]:
    if camera.covariance is None:
        return [Said("calibration-lens-undetermined")]
    sigma = np.sqrt(np.diag(camera.covariance))
    out = []
    relative = float(max(sigma[0] / camera.fx_px, sigma[1] / camera.fy_px))
    if relative > 0.01:
        out.append(Said("calibration-focal-vague", percent=round(100 * relative, 1)))
    return [*out, *_axis(camera)]


def require_plausible(camera: Camera, file_name: str) -> None:
    """Raises BadInput, naming the file, for a camera that is none of pictures of its size."""
    size = camera.width_px, camera.height_px
    shortest, longest = (share * max(size) for share in _FOCAL_OF_WIDTH)
    focal = camera.fx_px, camera.fy_px
    if not (shortest <= min(focal) and max(focal) <= longest):
        raise BadInput(
            "geometry-focal-implausible", file_name=file_name, focal=f"{camera.fx_px:.6g}", width=size[0]
        )
    if not (-size[0] < camera.cx_px < 2 * size[0] and -size[1] < camera.cy_px < 2 * size[1]):
        raise BadInput("geometry-principal-point-outside", file_name=file_name)
    if reach(camera) < _LEAST_REACH:
        raise BadInput("geometry-lens-turns-back", file_name=file_name)


def lens_warnings(camera: Camera) -> tuple[Said, ...]:
    """What is to be said of a lens alone, calibrated here or imported: where its axis lies, whether its
    pixels are square, and whether it turns back inside the picture.
    """
    return (*_axis(camera), *_corners(camera))


def _axis(camera: Camera) -> list[Said]:
    out = []
    off = max(
        abs(camera.cx_px - (camera.width_px - 1) / 2) / camera.width_px,
        abs(camera.cy_px - (camera.height_px - 1) / 2) / camera.height_px,
    )
    if off > 0.15:
        out.append(Said("lens-axis-off-middle"))
    if not 0.9 < camera.fx_px / camera.fy_px < 1.1:
        out.append(Said("lens-pixels-not-square"))
    return out


def _corners(camera: Camera) -> list[Said]:
    """Not a reason for distrust: clicks out there are refused, those elsewhere are as good as ever."""
    if reach(camera) >= 0.999:
        return []
    return [Said("lens-no-inverse-in-corners")]


def reach(camera: Camera) -> float:
    """How far from its axis a lens can be inverted, as a share of the distance to the picture's farthest
    corner; 1.05 where the model turns back nowhere in the picture (`geometry.lens_limit`).
    """
    x = max(camera.cx_px + 0.5, camera.width_px - 0.5 - camera.cx_px) / camera.fx_px
    y = max(camera.cy_px + 0.5, camera.height_px - 0.5 - camera.cy_px) / camera.fy_px
    return camera.limit.table_step * (len(camera.limit.table_gain) - 1) / float(np.hypot(x, y))


def _small_squares(evidence: Evidence) -> list[Said]:
    """Below some ten pixels a corner is fitted from a handful of pixels."""
    small = sum(spacing < _SMALL_SQUARE_PX for spacing in evidence.spacings_px)
    if 2 * small <= len(evidence.spacings_px):
        return []
    views = len(evidence.spacings_px)
    return [Said("calibration-squares-small", small=small, views=views, least_px=round(_SMALL_SQUARE_PX))]


def _left_out(evidence: Evidence) -> list[Said]:
    """Pictures of several sizes, and boards that were mostly not found."""
    out = []
    camera, used = evidence.camera, len(evidence.files)
    if evidence.other_size:
        out.append(
            Said(
                "calibration-several-sizes",
                count=len(evidence.other_size),
                width_px=camera.width_px,
                height_px=camera.height_px,
                file=evidence.other_size[0],
            )
        )
    if evidence.missed > used:
        out.append(Said("calibration-board-seldom", used=used, given=used + evidence.missed))
    return out


def _outliers(evidence: Evidence) -> list[Said]:
    rms = np.array(evidence.rms_px)
    usual = float(np.median(rms))
    return [
        Said("calibration-image-outlier", file=file, rms_px=round(float(value), 2), usual_px=round(usual, 2))
        for file, value in zip(evidence.files, rms, strict=True)
        if value > _OUTLIER * usual and value > 0.3
    ]
