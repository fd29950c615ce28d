"""The command pose (docs/formats.md)."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click

from sightline.commands.files import write_json
from sightline.commands.geometry_input import board_options, problems_of, read_camera_file
from sightline.commands.options import (
    FILE,
    choice_option,
    json_option,
    number_option,
    output_option,
    stream_option,
    tell,
)
from sightline.coverage import expanded
from sightline.enums import BoardSide
from sightline.geometry.board import Board
from sightline.geometry.documents import pose_to_dict
from sightline.geometry.pose import expected_u, pose_from_corners
from sightline.geometry.road_pose import DEFAULT_U_BOW_M, DEFAULT_U_HEIGHT_M, DEFAULT_U_LEAN_RAD, Reference
from sightline.messages import write_small


@click.command()
@click.argument("pictures", metavar="IMAGES...", nargs=-1, required=True, type=FILE)
@click.option("--camera", "camera_file", type=FILE, required=True, help="camera.json of the camera.")
@board_options
@number_option(
    "--reference-height",
    "height_m",
    required=True,
    help="Height of the reference row of corners above the road, metres.",
)
@choice_option(
    "--reference",
    "side",
    of=BoardSide,
    default="top",
    help="Reference row: the top or the bottom row of inner corners.",
)
@number_option(
    "--u-reference-height",
    "u_height_m",
    default=DEFAULT_U_HEIGHT_M,
    help="u of the reference height, metres.",
)
@number_option(
    "--u-lean", "u_lean_rad", default=DEFAULT_U_LEAN_RAD, help="u of board tilt and roll, radians."
)
@number_option(
    "--u-square", "u_square_m", help="u of the square size, metres (default: 0.1 % of it, an estimate)."
)
@number_option(
    "--u-bow",
    "u_bow_m",
    default=DEFAULT_U_BOW_M,
    help="u of the board's flatness (middle out of plane), metres.",
)
@output_option("pose.json to write.")
@stream_option
@json_option
def pose(
    pictures: tuple[Path, ...],
    camera_file: Path,
    board: Board,
    output: Path,
    stream_number: int | None,
    as_json: bool,
    **reference: Any,
) -> None:
    """Compute the camera pose from a clip or IMAGES of the checkerboard on the road, as pose.json."""
    from sightline.cameras.camera_files import pose_detections

    camera = read_camera_file(camera_file)
    frames, mean_picture, twice = pose_detections(pictures, camera, board, stream_number)
    with problems_of(*pictures[:3]):
        solved = pose_from_corners(camera, frames, board, Reference(**reference), mean_picture)
    document = pose_to_dict(solved)
    write_json(output, document)
    expected, warnings = expected_u(solved), [*twice, *solved.warnings]
    extra = {
        "warnings": warnings,
        "expected": [{"distance_m": d, "u_height_m": u} for d, u in expected],
    }
    tell(
        as_json,
        {**document, **extra},
        f"{output}: {solved.frames_used} frames, residual {solved.rms_px or 0.0:.3f} px, camera "
        f"{solved.centre_m[2]:.3f} m above the road",
        *expected_lines(expected),
        *(f"warning: {warning}" for warning in warnings),
    )


def expected_lines(expected: Iterable[tuple[float, float | None]]) -> list[str]:
    """What heights of 1.2 m will be worth at some distances, a line each; insets are not the pose's."""
    told = ((distance, u) for distance, u in expected if u is not None)
    return [
        f"expected at {distance:g} m: ± {write_small(expanded(u))} (95 %) without the inset's part"
        for distance, u in told
    ]
