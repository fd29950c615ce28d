"""The shape of a board that is not flat, solved for together with the lens.

Paper on a wall or on a thin sheet bends by a millimetre or more. Taken as flat, such a board leaves residuals
far above the corners' own noise and pulls the focal length (Strobl and Hirzinger 2011; mrcal's board warp).
Here the board's height out of its plane is a sum of products of Legendre polynomials of total degree 2 and 4:
even degrees only, because a board that is the same after half a turn does not tell which way up it was held,
and even terms do not mind.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import legvander

from sightline.arrays import Floats
from sightline.geometry.arrays import freeze_array
from sightline.geometry.board import Board, board_points

_TERMS = ((2, 0), (1, 1), (0, 2), (4, 0), (3, 1), (2, 2), (1, 3), (0, 4))


@dataclass(frozen=True, eq=False)
class BoardShape:
    """`coefficients_m` (8,): how far the board's corners lie behind its plane, per term."""

    board: Board
    coefficients_m: Floats

    def points(self, as_seen: Board) -> Floats:
        """Corners (N, 3) in the board's own frame, in the order as seen."""
        points = board_points(as_seen)
        points[:, 2] = shape_basis(self.board, as_seen) @ self.coefficients_m
        return points

    @property
    def bow_m(self) -> float:
        """From the most forward to the rearmost corner."""
        return float(np.ptp(self.points(self.board)[:, 2]))


def shape_basis(board: Board, as_seen: Board) -> Floats:
    """Height of every corner per unit of each term, (N, 8). A board on its side is turned back first; by
    which of the two quarter turns does not matter to even terms.

    Legendre products P_i(x) P_j(y), i + j = 2 or 4, on -1..1 (CONVENTIONS.md, Calibration; the idea is that
    of Strobl and Hirzinger 2011).
    """
    right, down = np.linspace(-1.0, 1.0, as_seen.columns), np.linspace(-1.0, 1.0, as_seen.rows)
    across, along = (v.ravel() for v in np.meshgrid(right, down))
    lying = as_seen.columns != board.columns
    x, y = (along, -across) if lying else (across, along)
    by_x, by_y = legvander(x, 4), legvander(y, 4)
    return freeze_array(np.stack([by_x[:, i] * by_y[:, j] for i, j in _TERMS], axis=1))
