"""Following a board from frame to frame: a sub-pixel search from where it was, instead of a new detection."""

import cv2
import numpy as np

from backend.geometry.arrays import frozen
from backend.geometry.corners import Corners, Gray, flaw, not_found, refine_subpixel, spacing_px

_STOP = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 20, 0.01)
_LOOK_AGAIN_PX = 1.0  # a board that moved less is not checked again


def track(gray: Gray, last: Corners) -> Corners:
    """The board of the last frame in this one, where it moved by less than a third of a square; else not
    found.
    """
    grid = refine_subpixel(gray, last.points_px, _STOP)
    moved = float(np.linalg.norm(grid - last.points_px, axis=2).max())
    if moved > 0.3 * spacing_px(last.points_px):
        return not_found(last.board_as_seen, "The board moved too far between two frames.")
    reason = flaw(gray, grid) if moved > _LOOK_AGAIN_PX else None
    if reason is not None:
        return not_found(last.board_as_seen, reason)
    return Corners(True, frozen(grid), last.board_as_seen, None, last.sharpness, "followed")
