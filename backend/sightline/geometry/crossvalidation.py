"""Two calibrations from two halves of the views: what their difference does to a height.

A covariance holds corner noise only. Two halves that share a wrong lens model still differ more than their
covariances say (mrcal's tour of cross-validation), so the difference is shown as what it makes of a height:
the same board and the same clicks, measured through either half.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sightline.enums import LensModel
from sightline.errors import BadInput
from sightline.geometry.board import Board, board_points
from sightline.geometry.board_shape import BoardShape
from sightline.geometry.calibration import (
    LEAST_BENT_VIEWS,
    LEAST_VIEWS,
    NamedCorners,
    fitted_lens,
    usable_views,
)
from sightline.geometry.camera import Camera
from sightline.geometry.height_effect import HeightDifference, height_differences
from sightline.geometry.planar import planar_roots, refine
from sightline.messages.said import Said

EXCEEDS = 2.5  # times the standard uncertainty that the covariances give it; noise alone: one set in 80
LARGE_M = 0.003  # at the board's distance, where errors of the lens nearly vanish
_NEGLIGIBLE_M = 0.002
_HELD_OUT_RATIO = 1.5


@dataclass(frozen=True)
class CrossValidation:
    """`views`: how many are in each half. `fit_rms_px`: residual of all views under the lens found from them
    all; `held_out_rms_px`: residual of each half's views under the other half's lens.
    `height_differences`: height by the first half minus height by the second.
    """

    views: tuple[int, int]
    fit_rms_px: float
    held_out_rms_px: tuple[float, float]
    height_differences: tuple[HeightDifference, ...]

    @property
    def all_held_out_rms_px(self) -> float:
        """Over both halves together."""
        (n1, n2), (second, first) = self.views, self.held_out_rms_px
        return float(np.sqrt((n2 * second**2 + n1 * first**2) / (n1 + n2)))


def cross_validate(
    views: Sequence[NamedCorners], board: Board, model: LensModel = "brown", bent_board: bool = False
) -> CrossValidation | Said:
    """Calibrate from every other usable view, twice, and compare; or the reason why that cannot be done.

    The arguments are those of `calibration.calibrate`; the set-up is that of `height_effect`.
    """
    usable = usable_views(views)[0]
    least = 2 * (LEAST_BENT_VIEWS if bent_board else LEAST_VIEWS)
    if len(usable) < least:
        board_is = "bent" if bent_board else "flat"
        return Said("calibration-halves-few", least=least, usable=len(usable), board=board_is)
    halves = usable[::2], usable[1::2]
    try:
        whole, _ = fitted_lens(usable, board, model, bent_board)
        (first, bow1), (second, bow2) = (
            fitted_lens(half, board, model, bent_board, whole) for half in halves
        )
    except BadInput as error:
        return Said("calibration-halves-failed", message=error.said)
    held_out = (
        _residual(whole, first, bow1, halves[1], board),
        _residual(whole, second, bow2, halves[0], board),
    )
    if not np.isfinite(held_out).all():
        return Said("calibration-halves-no-inverse")
    return CrossValidation(
        (len(halves[0]), len(halves[1])),
        whole.rms_px or 0.0,
        held_out,
        height_differences(whole, first, second),
    )


def _residual(
    whole: Camera, half: Camera, shape: BoardShape | None, views: Sequence[NamedCorners], board: Board
) -> float:
    """RMS point residual of views under a lens that they did not help to find; infinite where a board cannot
    be placed. The poses start from the whole's: the half's model may have no inverse where it saw no corner.
    """
    squares, count = 0.0, 0
    for _, corners, _ in views:
        seen_as = Board(corners.board_as_seen.columns, corners.board_as_seen.rows, board.square_m)
        pixels = corners.points_px.reshape(-1, 2)
        flat = board_points(seen_as)[corners.which]
        points = flat if shape is None else shape.points(seen_as)[corners.which]
        roots = planar_roots(whole, flat, pixels)
        if not roots:
            return float("inf")
        pose = refine(half, roots[0].rotation, roots[0].translation, points, pixels)
        squares, count = squares + pose.cost, count + len(pixels)
    return float(np.sqrt(squares / count))


def cross_validation_warnings(validation: CrossValidation) -> tuple[Said, ...]:
    """What the comparison says against the calibration, with what to do; empty where nothing.

    A difference counts where it is more than 2.5 times its standard uncertainty and over 2 mm, or over 3 mm
    at the board's distance.
    """
    out = []
    worst = _worst(validation)
    if worst is not None and worst.difference_m is not None:
        difference_m, distance_m = round(abs(worst.difference_m), 4), worst.distance_m
        out.append(
            Said("calibration-halves-differ", difference_m=difference_m, distance_m=distance_m)
            if worst.expected_m is None
            else Said(
                "calibration-halves-differ-beyond",
                difference_m=difference_m,
                distance_m=distance_m,
                expected_m=round(worst.expected_m, 4),
            )
        )
    held_out, fit = validation.all_held_out_rms_px, validation.fit_rms_px
    if held_out > _HELD_OUT_RATIO * fit:
        out.append(Said("calibration-held-out-worse", held_out_px=round(held_out, 2), fit_px=round(fit, 2)))
    return tuple(out)


def _worst(found: CrossValidation) -> HeightDifference | None:
    """The difference that exceeds its expectation most, if any counts."""
    counted = [d for d in found.height_differences if _counts(d)]
    return max(counted, key=lambda d: abs(d.difference_m or 0.0) / (d.expected_m or 1e-3), default=None)


def _counts(d: HeightDifference) -> bool:
    if d.difference_m is None:
        return False
    size = abs(d.difference_m)
    beyond = d.expected_m is not None and size > max(EXCEEDS * d.expected_m, _NEGLIGIBLE_M)
    return beyond or (size > LARGE_M and d.distance_m == 3.0)
