"""When a calibration is not to be trusted, in words.

A low residual proves little: one view of a board gives a small residual and a focal length that is wrong by
a third.
"""

from dataclasses import dataclass

import numpy as np

from sightline.errors import BadInput
from sightline.geometry.arrays import Floats
from sightline.geometry.camera import Camera

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


def calibration_warnings(evidence: Evidence) -> tuple[tuple[str, ...], bool]:
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


def _views(evidence: Evidence) -> list[str]:
    """Few views, or few that differ: a board that did not move between two pictures is one view."""
    count = len(evidence.files)
    if count < _FEW_VIEWS:
        return [
            f"Only {count} views were used; with fewer than {_FEW_VIEWS} a small residual proves little; "
            "take 15 to 25."
        ]
    different = different_views(evidence)
    if different < _FEW_VIEWS:
        return [
            f"Only {different} of the {count} views differ because the board hardly moved between "
            "the others; move and tilt it between images, or use frames further apart."
        ]
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


def _spread(evidence: Evidence) -> list[str]:
    """Coverage of the picture and variety of the board's directions."""
    out = []
    share = covered_share(evidence.coverage)
    if share < _LITTLE_COVERAGE:
        out.append(
            f"The boards cover {share:.0%} of the image; add views that reach its edges and "
            "corners, where the distortion is largest."
        )
    normals = np.array(evidence.normals)
    cosines = np.clip(normals @ normals.T, -1.0, 1.0)
    if float(np.arccos(cosines.min())) < _PARALLEL_RAD:
        out.append(
            "All board views have the same orientation, so focal length and distance cannot be separated; "
            "tilt the board by 30 to 45 degrees in several directions."
        )
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


def _model(evidence: Evidence) -> list[str]:
    camera, rms = evidence.camera, evidence.camera.rms_px or 0.0
    out = []
    limit = max(0.5, _HIGH_RMS * camera.width_px / 1000.0)
    if rms > limit:
        out.append(
            f"The residual of {rms:.2f} px is high; the board may not be flat, its size may be wrong, or the "
            "lens needs another model."
        )
    other = evidence.other_rms_px
    if other is not None and other < _BETTER * rms:
        better = "fisheye" if camera.model == "brown" else "brown"
        out.append(
            f"The {better} model fits better ({other:.2f} px against {rms:.2f} px); "
            "calibrate with that model."
        )
    return out


def _precision(camera: Camera) -> list[str]:
    if camera.covariance is None:
        return ["The views do not determine the lens; its uncertainty cannot be stated."]
    sigma = np.sqrt(np.diag(camera.covariance))
    out = []
    relative = float(max(sigma[0] / camera.fx_px, sigma[1] / camera.fy_px))
    if relative > 0.01:
        out.append(f"The focal length is known to {relative:.1%} only; take more views, tilted and near.")
    return [*out, *_axis(camera)]


def require_plausible(camera: Camera, file_name: str) -> None:
    """Raises BadInput, naming the file, for a camera that is none of pictures of its size."""
    size = camera.width_px, camera.height_px
    shortest, longest = (share * max(size) for share in _FOCAL_OF_WIDTH)
    focal = camera.fx_px, camera.fy_px
    if not (shortest <= min(focal) and max(focal) <= longest):
        raise BadInput(
            "geometry-focal-length-not-of-these-pixels",
            file_name=file_name,
            focal=f"{camera.fx_px:.6g}",
            width=size[0],
        )
    if not (-size[0] < camera.cx_px < 2 * size[0] and -size[1] < camera.cy_px < 2 * size[1]):
        raise BadInput("geometry-principal-point-lies-far-outside-picture", file_name=file_name)
    if reach(camera) < _LEAST_REACH:
        raise BadInput("geometry-lens-turns-back-early", file_name=file_name)


def lens_warnings(camera: Camera) -> tuple[str, ...]:
    """What is to be said of a lens alone, calibrated here or imported: where its axis lies, whether its
    pixels are square, and whether it turns back inside the picture.
    """
    return (*_axis(camera), *_corners(camera))


def _axis(camera: Camera) -> list[str]:
    out = []
    off = max(
        abs(camera.cx_px - (camera.width_px - 1) / 2) / camera.width_px,
        abs(camera.cy_px - (camera.height_px - 1) / 2) / camera.height_px,
    )
    if off > 0.15:
        out.append("The optical axis lies far from the middle of the image; was the image cropped?")
    if not 0.9 < camera.fx_px / camera.fy_px < 1.1:
        out.append("The two focal lengths differ by more than 10 %; are the pixels square?")
    return out


def _corners(camera: Camera) -> list[str]:
    """Not a reason for distrust: clicks out there are refused, those elsewhere are as good as ever."""
    if reach(camera) >= 0.999:
        return []
    return [
        "The lens model cannot be inverted in the corners of the image, so nothing is measured "
        "there; add images that reach the corners."
    ]


def reach(camera: Camera) -> float:
    """How far from its axis a lens can be inverted, as a share of the distance to the picture's farthest
    corner; 1.05 where the model turns back nowhere in the picture (`geometry.lens_limit`).
    """
    x = max(camera.cx_px + 0.5, camera.width_px - 0.5 - camera.cx_px) / camera.fx_px
    y = max(camera.cy_px + 0.5, camera.height_px - 0.5 - camera.cy_px) / camera.fy_px
    return camera.limit.table_step * (len(camera.limit.table_gain) - 1) / float(np.hypot(x, y))


def _small_squares(evidence: Evidence) -> list[str]:
    """Below some ten pixels a corner is fitted from a handful of pixels."""
    small = sum(spacing < _SMALL_SQUARE_PX for spacing in evidence.spacings_px)
    if 2 * small <= len(evidence.spacings_px):
        return []
    return [
        f"In {small} of {len(evidence.spacings_px)} views the squares are smaller than "
        f"{_SMALL_SQUARE_PX:.0f} px and their corners inexact; bring the board nearer or use larger squares."
    ]


def _left_out(evidence: Evidence) -> list[str]:
    """Pictures of several sizes, and boards that were mostly not found."""
    out = []
    camera, used = evidence.camera, len(evidence.files)
    if evidence.other_size:
        out.append(
            f"Images of several sizes: {len(evidence.other_size)} skipped that are not "
            f"{camera.width_px}x{camera.height_px} px ({evidence.other_size[0]} first); a "
            "calibration holds for one size only, so use images of the recordings' size."
        )
    if evidence.missed > used:
        out.append(
            f"The board was used in only {used} of {used + evidence.missed} images; count its "
            "inner corners again, and show the whole board, sharp and evenly lit."
        )
    return out


def _outliers(evidence: Evidence) -> list[str]:
    rms = np.array(evidence.rms_px)
    usual = float(np.median(rms))
    return [
        f"{file} fits much worse than the others ({value:.2f} px against {usual:.2f} px); check its corners."
        for file, value in zip(evidence.files, rms, strict=True)
        if value > _OUTLIER * usual and value > 0.3
    ]
