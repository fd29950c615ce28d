"""ChArUco boards: a checkerboard whose white squares carry markers, so that every corner has a number.

Part of the board is enough, and no order can be mistaken. The markers sit close to the corners, so whatever
is fitted round a corner must stay within the plain part of the squares (`clear_share`).
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.errors import BadInput

DICTIONARIES = tuple(
    [f"{bits}X{bits}_{count}" for bits in (4, 5, 6, 7) for count in (50, 100, 250, 1000)]
    + ["ARUCO_ORIGINAL", "APRILTAG_16H5", "APRILTAG_25H9", "APRILTAG_36H10", "APRILTAG_36H11"]
)
LEAST_CORNERS = 6
Found = tuple[NDArray[np.intp], Floats]
_MOST_PIXELS = 9e6  # an enlarged picture of more takes longer than it is worth
_CUBIC = cv2.INTER_CUBIC


@dataclass(frozen=True)
class Charuco:
    """The markers in a board's white squares: their dictionary (OpenCV's name without DICT_) and side."""

    dictionary: str
    marker_m: float

    def clear_share(self, square_m: float) -> float:
        """Radius round a corner, in squares, that holds nothing but the four squares that meet there."""
        return float(0.5 * np.sqrt(2.0) * (1.0 - self.marker_m / square_m))


def charuco_of(dictionary: str, marker_m: float) -> Charuco:
    """Raises BadInput for a dictionary that is not known."""
    name = dictionary.strip().upper().removeprefix("DICT_")
    if name not in DICTIONARIES:
        raise BadInput(
            "geometry-dictionary-unknown", dictionary=repr(dictionary), dictionaries=", ".join(DICTIONARIES)
        )
    return Charuco(name, marker_m)


def require_charuco(charuco: Charuco, columns: int, rows: int, square_m: float) -> None:
    """Raise BadInput for markers that cannot be on a board of so many inner corners."""
    if charuco.dictionary not in DICTIONARIES:
        charuco_of(charuco.dictionary, charuco.marker_m)
    if not (np.isfinite(charuco.marker_m) and 0.2 * square_m <= charuco.marker_m < 0.97 * square_m):
        raise BadInput("geometry-markers-over-squares", marker_m=charuco.marker_m, square_m=square_m)
    needed, held = (columns + 1) * (rows + 1) // 2, len(_dictionary(charuco.dictionary).bytesList)
    if needed > held:
        raise BadInput(
            "geometry-board-marker-count",
            columns=columns,
            rows=rows,
            needed=needed,
            dictionary=charuco.dictionary,
            held=held,
        )


def find_charuco(
    gray: NDArray[np.uint8], charuco: Charuco, columns: int, rows: int, square_m: float
) -> Found | None:
    """Numbers (N,), row by row as printed, and places (N, 2), pixels, of the inner corners seen in `gray` (H,
    W); None for fewer than six, or six in one line.

    OpenCV's detector, whose markers are those of Garrido-Jurado et al. 2014. OpenCV 4.6 turned the pattern of
    boards with an even number of rows of squares round; both kinds are tried, for a board does not tell when
    it was made. A picture in which corners are missing is looked at again enlarged.
    """
    best: Found | None = None
    for scale in (1.0, 2.0):
        if scale > 1.0 and gray.size * scale**2 > _MOST_PIXELS:
            break
        size: Any = gray if scale == 1.0 else cv2.resize(gray, None, fx=scale, fy=scale, interpolation=_CUBIC)
        for legacy in (False, True) if rows % 2 else (False,):
            found = _detect_corners(_detector(charuco, columns, rows, square_m, legacy), size, columns)
            if found is not None and (best is None or len(found[0]) > len(best[0])):
                best = found[0], (found[1] + 0.5) / scale - 0.5
        if best is not None and len(best[0]) == columns * rows:
            break
    return best


def _detect_corners(detector: Any, gray: NDArray[np.uint8], columns: int) -> Found | None:
    points, ids, _, _ = detector.detectBoard(gray)
    if points is None or ids is None or len(ids) < LEAST_CORNERS:
        return None
    numbers = np.asarray(ids, dtype=np.intp).ravel()
    order = np.argsort(numbers)
    if not _spread(numbers, columns):
        return None
    return numbers[order], np.asarray(points, dtype=np.float64).reshape(-1, 2)[order]


def _spread(ids: NDArray[np.intp], columns: int) -> bool:
    """Whether the corners span a plane: two rows and two columns of them, not one diagonal."""
    at = np.column_stack([ids % columns, ids // columns]).astype(np.float64)
    return bool(np.linalg.matrix_rank(at - at.mean(axis=0)) == 2)


@lru_cache(maxsize=32)
def _detector(charuco: Charuco, columns: int, rows: int, square_m: float, legacy: bool) -> Any:
    size = (columns + 1, rows + 1)
    board = cv2.aruco.CharucoBoard(size, square_m, charuco.marker_m, _dictionary(charuco.dictionary))
    board.setLegacyPattern(legacy)
    how, read = cv2.aruco.CharucoParameters(), cv2.aruco.DetectorParameters()
    how.tryRefineMarkers = True  # markers missed at first are sought again where the board has them
    read.perspectiveRemovePixelPerCell = 8  # twice as many small markers are read
    read.minOtsuStdDev = 2.0
    return cv2.aruco.CharucoDetector(board, how, read)


def _dictionary(name: str) -> Any:
    return cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, f"DICT_{name}"))
