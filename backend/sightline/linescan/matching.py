"""Block matching of the two strips of a vehicle: sums of absolute differences, the paper's section IV.

One absolute difference of the whole vehicle serves every block of a shift: summed over the rows and
accumulated along the lines, a block's sum is a difference of two numbers. The modified Moravec gate keeps
only blocks whose grey changes enough along the time.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.linescan.parts import Pixels

BLOCK_LINES = 48
STEP_LINES = 8
# the paper's limited vertical scan; no offset first, so that it wins where all are alike
ROWS = (0, -1, 1)
# Times what noise alone shows: below this a block holds nothing to match.
GATE = 1.5


@dataclass(frozen=True, eq=False)
class Matches:
    """Blocks of the first picture with where they were found in the second.

    `middle`: (n,) line of each block's middle in the first picture (its row 0 is line 0); `shift`: (n,)
    lines to the second picture's line; `vertical`: (n,) rows, -1, 0 or 1; `used`: (n,) passed the gate and
    has its smallest sum inside the search; `at_end`: (n,) the smallest sum was at an end of the search.
    """

    middle: Floats
    shift: Floats
    vertical: NDArray[np.int64]
    used: NDArray[np.bool_]
    at_end: NDArray[np.bool_]


def match_blocks(first: Pixels, second: Pixels, shifts: range, noise_dn: float, *, lag: int = 1) -> Matches:
    """Sub-line shifts of blocks of BLOCK_LINES lines, every STEP_LINES: Douxchamps et al., section IV (block
    matching by sums of absolute differences, with a modified Moravec operator as gate).

    `first` (lines, rows); `second` (lines2, rows), line n of it at shift 0 beside line n of `first`. A block
    whose place in `second` is not there for every shift is left out. `lag`: lines over which the gate looks
    for a change. Shapes that leave no block give empty arrays.
    """
    starts = _starts(len(first), len(second), shifts)
    if len(starts) == 0 or len(shifts) < 3:
        nothing, none = np.zeros(0), np.zeros(0, dtype=np.bool_)
        return Matches(nothing, nothing, np.zeros(0, dtype=np.int64), none, none)
    sums = np.stack([_block_sums(first, second, shifts, starts, rows) for rows in ROWS])
    best_rows = np.argmin(sums.min(axis=1), axis=0)  # (blocks,)
    of_best = sums[best_rows, :, np.arange(len(starts))]  # (blocks, shifts)
    at = np.argmin(of_best, axis=1)
    at_end = (at == 0) | (at == len(shifts) - 1)
    inside = np.clip(at, 1, len(shifts) - 2)
    fine = _vertex(of_best, inside)
    enough = _activity(first, starts, lag) > GATE * _noise_activity(noise_dn, first.shape[1])
    return Matches(
        np.asarray(starts + (BLOCK_LINES - 1) / 2, dtype=np.float64),
        shifts.start + inside + fine,
        np.array(ROWS)[best_rows],
        enough & ~at_end,
        at_end,
    )


def _starts(lines: int, lines_2: int, shifts: range) -> NDArray[np.int64]:
    low = max(0, -shifts.start)
    high = min(lines, lines_2 - (shifts.stop - 1)) - BLOCK_LINES
    return np.arange(low, high + 1, STEP_LINES)


def _block_sums(
    first: Pixels, second: Pixels, shifts: range, starts: NDArray[np.int64], vertical: int
) -> Floats:
    """(shifts, blocks) mean absolute differences; `vertical` rows lower in the second picture."""
    rows = first.shape[1] - abs(vertical)
    left, right = max(0, -vertical), max(0, vertical)
    low, high = int(starts[0]), int(starts[-1]) + BLOCK_LINES
    base = first[low:high, left : left + rows]
    out = np.empty((len(shifts), len(starts)))
    # whole numbers are summed 40 times as fast; those of 16 bits cannot be
    kind = cv2.CV_32S if first.dtype == np.uint8 else cv2.CV_64F
    for number, shift in enumerate(shifts):
        other = second[low + shift : high + shift, right : right + rows]
        difference = cv2.absdiff(base, other)
        along = cv2.reduce(difference, 1, cv2.REDUCE_SUM, dtype=kind).ravel()
        summed = np.concatenate([[0.0], np.cumsum(along)])
        out[number] = summed[starts - low + BLOCK_LINES] - summed[starts - low]
    return np.asarray(out / (BLOCK_LINES * rows), dtype=np.float64)


def _vertex(sums: Floats, at: NDArray[np.int64]) -> Floats:
    """(blocks,) offset of the smallest sum between its neighbours.

    Sums of absolute differences of noisy texture lie between |x| and x^2: the vertex of two lines of equal
    slope is off by up to +0.04 lines, that of a parabola by as much the other way, their mean below 0.01.
    """
    number = np.arange(len(at))
    before, here, after = (sums[number, at + step] for step in (-1, 0, 1))
    steeper, bend = np.maximum(before, after) - here, before - 2 * here + after
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = (before - after) * (1 / steeper + 1 / bend) / 4
    return np.clip(np.where((steeper > 0) & (bend > 0), mean, 0.0), -0.5, 0.5)


def _activity(picture: Pixels, starts: NDArray[np.int64], lag: int) -> Floats:
    """(blocks,) mean squared grey difference of lines `lag` apart, summed over the rows."""
    lines = picture.astype(np.float32)
    step = lines[lag:] - lines[:-lag]
    summed = np.concatenate([[0.0], np.cumsum(np.einsum("ij,ij->i", step, step), dtype=np.float64)])
    return np.asarray((summed[starts + BLOCK_LINES - lag] - summed[starts]) / (BLOCK_LINES - lag))


def _noise_activity(noise_dn: float, rows: int) -> float:
    """What noise alone gives: the difference of two pixels has twice the variance of one."""
    return 2 * noise_dn**2 * rows
