"""The command calibrate (docs/formats.md)."""

from pathlib import Path
from typing import Any

import click

from sightline.commands.files import write_json
from sightline.commands.geometry_input import board_options, problems_of
from sightline.commands.options import FILE, choice_option, json_option, output_option, stream_option, tell
from sightline.enums import LensModel
from sightline.geometry.board import Board
from sightline.geometry.calibration_checks import CheckedCalibration, calibrate_and_check
from sightline.geometry.crossvalidation import CrossValidation
from sightline.geometry.documents import camera_to_dict
from sightline.messages import write_fixed
from sightline.messages.said import Said


@click.command()
@click.argument("images", nargs=-1, required=True, type=FILE)
@board_options
@choice_option("--model", of=LensModel, default="brown", help="Lens model.")
@click.option("--bent-board", is_flag=True, help="The board may be bent: model its shape too.")
@output_option("camera.json to write.")
@stream_option
@json_option
def calibrate(
    images: tuple[Path, ...],
    board: Board,
    model: Any,
    bent_board: bool,
    output: Path,
    stream_number: int | None,
    as_json: bool,
) -> None:
    """Calibrate a camera from checkerboard IMAGES (or a clip) and write camera.json."""
    from sightline.cameras.camera_files import calibration_views

    views = calibration_views(images, board, stream_number)
    with problems_of(*images[:3]):
        checked = calibrate_and_check(views, board, model, bent_board)
    result = checked.result
    document = camera_to_dict(result.camera)
    write_json(output, document)
    extra = {
        **checked.documents(),
        "warnings": list(result.warnings),
        "trusted": result.trusted,
        "coverage": result.coverage.astype(int).tolist(),
    }
    tell(as_json, {**document, **extra}, _calibration_text(checked, output))


def _calibration_text(checked: CheckedCalibration, output: Path) -> str:
    result, camera = checked.result, checked.result.camera
    assert camera.rms_px is not None  # only a lens that was told without its images has none
    used = sum(view.used for view in camera.views)
    lines = [
        f"{output}: {used} of {len(camera.views)} images used, residual {write_fixed(camera.rms_px, 3)} px, "
        f"fx {write_fixed(camera.fx_px, 2)}, fy {write_fixed(camera.fy_px, 2)}, "
        f"cx {write_fixed(camera.cx_px, 2)}, cy {write_fixed(camera.cy_px, 2)} px"
    ]
    lines += [f"excluded {view.file}: {view.reason}" for view in camera.views if not view.used]
    lines.append(_halves_text(checked.cross_validation))
    lines += [f"warning: {warning}" for warning in result.warnings]
    lines += [f"add images: {advice}" for advice in result.reshoot]
    if not result.trusted:
        lines.append("This calibration is unreliable.")
    return "\n".join(lines)


def _halves_text(validation: CrossValidation | Said) -> str:
    if isinstance(validation, Said):
        return f"no cross-validation: {validation}"
    differences = [
        f"{write_fixed(1000 * abs(d.difference_m), 1)} mm at {d.distance_m:g} m"
        for d in validation.height_differences
        if d.difference_m is not None
    ]
    heights = (
        f"differ by {', '.join(differences)} in a height" if differences else "cannot be compared in a height"
    )
    return (
        f"cross-validation, two halves calibrated separately, {heights}; "
        f"held-out residual {write_fixed(validation.all_held_out_rms_px, 3)} px"
    )
