"""A calibration with what speaks for or against it: warnings, cross-validation, the board's shape."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

from sightline.enums import LensModel
from sightline.geometry.board import Board
from sightline.geometry.calibration import BoardFlatness, CalibrationResult, NamedCorners, calibrate
from sightline.geometry.crossvalidation import CrossValidation, cross_validate, cross_validation_warnings
from sightline.geometry.height_effect import HeightDifference, height_differences
from sightline.messages.said import Said

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
