"""Following a board from frame to frame: a sub-pixel search from where it was, instead of a new detection."""

import cv2
import numpy as np

from sightline.geometry.arrays import freeze_array
from sightline.geometry.corners import Corners, Gray, find_board, flaw, not_found, refine_subpixel, spacing_px
from sightline.messages.said import Said

_STOP = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 20, 0.01)
_LOOK_AGAIN_PX = 1.0  # a board that moved less is not checked again


def track(gray: Gray, last: Corners) -> Corners:
    """The board of the last frame in this one, `gray` (H, W), where it moved by less than a third of a
    square; else not found, with a reason. Own method: `refine_subpixel` (Foerstner 1987) from where it was,
    looked at again as a detection where it moved.
    """
    board = last.board_as_seen
    share = 0.4 if board.charuco is None else 0.7 * board.clear_share
    grid = refine_subpixel(gray, last.points_px, _STOP, share)
    shift = grid - last.points_px
    moved = float(np.sqrt((shift * shift).sum(axis=-1).max()))
    if moved > 0.3 * spacing_px(last.points_px):
        return not_found(last.board_as_seen, Said("board-moved-far"))
    if board.charuco is not None and moved > _LOOK_AGAIN_PX:
        return find_board(gray, board)  # its numbers tell more than a look at the grid
    reason = flaw(gray, grid) if moved > _LOOK_AGAIN_PX else None
    if reason is not None:
        return not_found(last.board_as_seen, reason)
    return Corners(
        found=True,
        points_px=freeze_array(grid),
        board_as_seen=last.board_as_seen,
        reason=None,
        sharpness=last.sharpness,
        detector="followed",
        ids=last.ids,
    )
