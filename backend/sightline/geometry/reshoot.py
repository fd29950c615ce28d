"""What pictures a calibration still lacks, in words: where in the picture, which tilt, how near."""

from collections.abc import Sequence

import numpy as np

from sightline.geometry.arrays import Floats
from sightline.geometry.verdict import Evidence

_TILT_RAD = np.deg2rad(15.0)
_THIN = 36  # a ninth of the picture with less than a quarter of an even share is thin
_NEAR_SHARE = 0.2  # of the picture that the largest board should fill
_ROWS, _COLUMNS = ("top", "middle", "bottom"), ("left", "centre", "right")
_EDGES = (("right", 0, 1.0), ("left", 0, -1.0), ("bottom", 1, 1.0), ("top", 1, -1.0))


def reshoot_advice(evidence: Evidence) -> tuple[str, ...]:
    """One sentence per kind of picture that is missing; empty where nothing is."""
    return (*places_missing(evidence.coverage), *_tilts(evidence.normals), *_nearness(evidence))


def thin_parts(coverage: Floats) -> tuple[str, ...]:
    """Names of the ninths of the picture that hold few of the corners; coverage (12, 16): corners per cell.

    Own method: few is less than a quarter of an even share.
    """
    ninths = coverage_ninths(coverage)
    total = float(coverage.sum())
    return tuple(
        "centre" if (row, column) == ("middle", "centre") else f"{row} {column}"
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


def places_missing(coverage: Floats) -> tuple[str, ...]:
    """Where in the picture the board should be held more, in words; coverage (12, 16). As `thin_parts`."""
    parts = thin_parts(coverage)
    return (f"Hold the board in the {listed(parts)} of the image.",) if parts else ()


def _tilts(normals: tuple[Floats, ...]) -> tuple[str, ...]:
    """The normal points away from the camera: where it leans to the right, the right edge is the nearer."""
    n = np.array(normals)
    angles = np.arctan2(n[:, :2], n[:, 2:])
    missing = [edge for edge, axis, sign in _EDGES if not (sign * angles[:, axis] > _TILT_RAD).any()]
    if not missing:
        return ()
    edge = f"{missing[0]} edge" if len(missing) == 1 else f"{listed(missing)} edge in turn"
    return (f"Tilt the board by about 30 degrees, its {edge} nearer the camera.",)


def _nearness(evidence: Evidence) -> tuple[str, ...]:
    spans = [np.ptp(points, axis=0) for points in evidence.corners_px]
    share = max(float(w * h) for w, h in spans) / (evidence.camera.width_px * evidence.camera.height_px)
    if share >= _NEAR_SHARE:
        return ()
    return (
        f"Bring the board nearer: it never fills more than {100 * share:.0f} % of the image; a "
        "third or more is good.",
    )


def listed(words: Sequence[str]) -> str:
    """`a, b and c`."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
