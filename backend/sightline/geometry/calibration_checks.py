"""A calibration with what speaks for or against it: warnings, cross-validation, the board's shape."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from sightline.enums import LensModel
from sightline.errors import BadInput
from sightline.geometry.board import Board, board_points
from sightline.geometry.board_shape import BoardShape
from sightline.geometry.calibration import (
    LEAST_BENT_VIEWS,
    LEAST_VIEWS,
    BoardFlatness,
    CalibrationResult,
    NamedCorners,
    calibrate,
    fitted_lens,
    usable_views,
)
from sightline.geometry.camera import Camera
from sightline.geometry.height_effect import HeightDifference, height_differences
from sightline.geometry.planar import planar_roots, refine
from sightline.messages.said import Said

# Two calibrations from two halves of the views: what their difference does to a height.
#
# A covariance holds corner noise only. Two halves that share a wrong lens model still differ more than their
# covariances say (mrcal's tour of cross-validation), so the difference is shown as what it makes of a height:
# the same board and the same clicks, measured through either half.


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


_BENT_RATIO = 0.9  # a bent board is believed where its shape takes a tenth of the residual


@dataclass(frozen=True, eq=False)
class CheckedCalibration:
    """`result`: the calibration, its warnings including those of the checks. `cross_validation`: a reason
    where it could not be done. `board_effect`: height with the board taken as flat minus height with its
    shape solved for; empty where that is unknown.
    """

    result: CalibrationResult
    cross_validation: CrossValidation | Said
    board_effect: tuple[HeightDifference, ...]

    def documents(self) -> dict[str, Any]:
        """The checks as they are stored: `cross_validation`, `board_shape` (or null) and `reshoot`."""
        flatness = self.result.flatness
        return {
            "cross_validation": cross_validation_to_dict(self.cross_validation),
            "board_shape": None if flatness is None else _shape_to_dict(flatness, self.board_effect),
            "reshoot": list(self.result.reshoot),
        }


def calibrate_and_check(
    views: Sequence[NamedCorners], board: Board, model: LensModel = "brown", bent_board: bool = False
) -> CheckedCalibration:
    """As `calibration.calibrate`, with the checks; a second of work for 60 views. Raises BadInput."""
    result = calibrate(views, board, model, bent_board)
    crossed = cross_validate(views, board, model, bent_board)
    flatness = result.flatness
    effect = () if flatness is None else height_differences(flatness.bent, flatness.flat, flatness.bent)
    warnings = (
        *result.warnings,
        *(() if isinstance(crossed, Said) else cross_validation_warnings(crossed)),
        *(() if flatness is None else _flatness_warnings(flatness, effect)),
    )
    return CheckedCalibration(replace(result, warnings=warnings), crossed, effect)


def _flatness_warnings(flatness: BoardFlatness, effect: Sequence[HeightDifference]) -> tuple[Said, ...]:
    flat, bent = flatness.flat.rms_px or 0.0, flatness.bent.rms_px or 0.0
    if flatness.solved or bent >= _BENT_RATIO * flat:
        return ()
    bow = round(100.0 * flatness.shape.bow_m / flatness.shape.board.square_m, 1)
    flat_px, bent_px = round(flat, 2), round(bent, 2)
    worst = max((d for d in effect if d.difference_m is not None), key=_size, default=None)
    if worst is None:
        return (Said("calibration-board-bent", bow_percent=bow, flat_px=flat_px, bent_px=bent_px),)
    return (
        Said(
            "calibration-board-bent-changes",
            bow_percent=bow,
            flat_px=flat_px,
            bent_px=bent_px,
            distance_m=worst.distance_m,
            change_m=round(_size(worst), 4),
        ),
    )


def _size(d: HeightDifference) -> float:
    return abs(d.difference_m or 0.0)


def cross_validation_to_dict(validation: CrossValidation | Said) -> dict[str, Any]:
    """All keys are always there; where it could not be done, the numbers are null and `reason` says why."""
    if isinstance(validation, Said):
        nothing = {"views": None, "fit_rms_px": None, "held_out_rms_px": None}
        return {"reason": validation, **nothing, "height_differences": []}
    return {
        "reason": None,
        "views": list(validation.views),
        "fit_rms_px": validation.fit_rms_px,
        "held_out_rms_px": validation.all_held_out_rms_px,
        "height_differences": [asdict(d) for d in validation.height_differences],
    }


def _shape_to_dict(flatness: BoardFlatness, effect: Sequence[HeightDifference]) -> dict[str, Any]:
    return {
        "solved": flatness.solved,
        "bow_m": flatness.shape.bow_m,
        "flat_rms_px": flatness.flat.rms_px,
        "bent_rms_px": flatness.bent.rms_px,
        "height_differences": [{"distance_m": d.distance_m, "difference_m": d.difference_m} for d in effect],
    }
