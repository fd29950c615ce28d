"""What pictures a calibration still lacks: where in the picture, which tilt, how near."""

import numpy as np

from sightline.arrays import Floats
from sightline.geometry.verdict import Evidence
from sightline.messages.said import Said, join_with_and

_TILT_RAD = np.deg2rad(15.0)
_THIN = 36  # a ninth of the picture with less than a quarter of an even share is thin
_NEAR_SHARE = 0.2  # of the picture that the largest board should fill
_ROWS, _COLUMNS = ("top", "middle", "bottom"), ("left", "centre", "right")
_EDGES = (("right", 0, 1.0), ("left", 0, -1.0), ("bottom", 1, 1.0), ("top", 1, -1.0))


def reshoot_advice(evidence: Evidence) -> tuple[Said, ...]:
    """A saying per kind of picture that is missing; empty where nothing is."""
    return (*places_missing(evidence.coverage), *_tilts(evidence.normals), *_nearness(evidence))


def thin_parts(coverage: Floats) -> tuple[str, ...]:
    """Names (`top-left`) of the ninths of the picture that hold few corners; coverage (12, 16): of each cell.

    Own method: few is less than a quarter of an even share.
    """
    ninths = coverage_ninths(coverage)
    total = float(coverage.sum())
    return tuple(
        f"{row}-{column}"
        for row, counts in zip(_ROWS, ninths, strict=True)
        for column, count in zip(_COLUMNS, counts, strict=True)
        if count < total / _THIN
    )


def coverage_ninths(coverage: Floats) -> Floats:
    """Corners per ninth of the picture, (3, 3), top left first; coverage (12, 16)."""
    height, width = coverage.shape
    row, column = np.arange(height) * 3 // height, np.arange(width) * 3 // width
    out = np.zeros((3, 3))
    np.add.at(out, (row[:, None], column[None, :]), coverage)
    return out


def places_missing(coverage: Floats) -> tuple[Said, ...]:
    """Where in the picture the board should be held more; coverage (12, 16). As `thin_parts`."""
    parts = thin_parts(coverage)
    named = [Said("image-part", place=one) for one in parts]
    return (Said("calibration-hold-in", parts=join_with_and(named)),) if named else ()


def _tilts(normals: tuple[Floats, ...]) -> tuple[Said, ...]:
    """The normal points away from the camera: where it leans to the right, the right edge is the nearer."""
    n = np.array(normals)
    angles = np.arctan2(n[:, :2], n[:, 2:])
    missing = [edge for edge, axis, sign in _EDGES if not (sign * angles[:, axis] > _TILT_RAD).any()]
    if not missing:
        return ()
    named = [Said("board-edge", edge=edge) for edge in missing]
    if len(named) == 1:
        return (Said("calibration-tilt-edge", edge=named[0]),)
    return (Said("calibration-tilt-edges", edges=join_with_and(named)),)


def _nearness(evidence: Evidence) -> tuple[Said, ...]:
    spans = [np.ptp(points, axis=0) for points in evidence.corners_px]
    share = max(float(w * h) for w, h in spans) / (evidence.camera.width_px * evidence.camera.height_px)
    if share >= _NEAR_SHARE:
        return ()
    return (Said("calibration-bring-nearer", percent=round(100 * share)),)
