"""The commands calibrate, import-camera, pose and height (docs/formats.md)."""

import functools
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import click
import numpy as np

from sightline.commands.clicks import OF_HEIGHT, Assumed, assumed_inset, heights_csv
from sightline.commands.files import read_json, read_text, write_json, write_whole
from sightline.commands.options import (
    FILE,
    choice_option,
    json_option,
    number_option,
    output_option,
    refuse_ignored,
    stream_option,
    tell,
)
from sightline.commands.tracks_csv import pass_to_dict, read_tracks
from sightline.coverage import expanded
from sightline.enums import BoardSide, DriverSide, LensModel, Target
from sightline.errors import BadInput
from sightline.geometry.board import Board, require_board
from sightline.geometry.calibration_checks import CheckedCalibration, calibrate_and_check
from sightline.geometry.camera import Camera
from sightline.geometry.charuco import charuco_of
from sightline.geometry.crossvalidation import CrossValidation
from sightline.geometry.documents import (
    LARGEST,
    camera_from_dict,
    camera_to_dict,
    pose_from_dict,
    pose_to_dict,
)
from sightline.geometry.followed_tracks import Following
from sightline.geometry.height import Height, measure_height, not_measurable
from sightline.geometry.imports import read_camera
from sightline.geometry.pose import expected_u, pose_from_corners
from sightline.geometry.road_pose import (
    DEFAULT_U_BOW_M,
    DEFAULT_U_HEIGHT_M,
    DEFAULT_U_LEAN_RAD,
    Reference,
    RoadPose,
)
from sightline.geometry.verdict import require_plausible
from sightline.geometry.whole_pass import WholePass, measure_pass
from sightline.infra.given_csv import given_number
from sightline.messages.said import Said

Command = Callable[..., None]
_BOARD = (
    number_option("--marker", "marker_m", help="Marker side, metres."),
    click.option(
        "--charuco",
        metavar="DICT",
        help="Use a ChArUco board with markers of this dictionary, such as 4X4_50.",
    ),
    number_option("--square", "square_m", required=True, help="Square size, metres."),
    click.option(
        "--board", "text", required=True, metavar="CxR", help="Number of inner corners, across x down."
    ),
)


def board_options(command: Command) -> Command:
    """The four options that tell a board: what the command is given of them is the `board`."""

    @functools.wraps(command)
    def with_board(
        *, text: str, square_m: float, charuco: str | None, marker_m: float | None, **given: Any
    ) -> None:
        command(board=_board(text, square_m, charuco, marker_m), **given)

    return functools.reduce(lambda made, option: option(made), _BOARD, with_board)


def _board(text: str, square_m: float, dictionary: str | None, marker_m: float | None) -> Board:
    if (dictionary is None) != (marker_m is None):
        raise BadInput("commands-charuco-marker-together")
    match = re.fullmatch(r"\s*(\d{1,4})\s*[xX×*]\s*(\d{1,4})\s*", text)
    if match is None:
        raise BadInput("commands-board-form", text=repr(text))
    charuco = None if dictionary is None or marker_m is None else charuco_of(dictionary, marker_m)
    board = Board(int(match[1]), int(match[2]), square_m, charuco)
    require_board(board)
    return board


def parse_point(text: str, option: str) -> tuple[float, float]:
    """`X,Y` in pixels. Raises BadInput."""
    match [given_number(part) for part in text.split(",")]:
        case [float(x), float(y)]:
            return x, y
    raise BadInput("commands-point-form", option=option, text=repr(text))


@contextmanager
def problems_of(*files: Path) -> Iterator[None]:
    """What cannot be done is said with the files that it is done with."""
    try:
        yield
    except BadInput as error:
        names = ", ".join(map(str, files))
        raise BadInput("commands-problem", names=names, message=error.message) from None


def read_camera_file(path: Path) -> Camera:
    document = read_json(path, "a camera.json made by sightline calibrate or import-camera")
    camera = camera_from_dict(document, str(path))
    require_plausible(camera, str(path))
    return camera


def read_pose_file(path: Path) -> RoadPose:
    pose = pose_from_dict(read_json(path, "a pose.json made by sightline pose"), str(path))
    require_plausible(pose.camera, str(path))
    return pose


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
    used = sum(view.used for view in camera.views)
    lines = [
        f"{output}: {used} of {len(camera.views)} images used, residual {camera.rms_px:.3f} px, "
        f"fx {camera.fx_px:.2f}, fy {camera.fy_px:.2f}, cx {camera.cx_px:.2f}, cy {camera.cy_px:.2f} px"
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
        f"{1000 * abs(d.difference_m):.1f} mm at {d.distance_m:g} m"
        for d in validation.height_differences
        if d.difference_m is not None
    ]
    heights = (
        f"differ by {', '.join(differences)} in a height" if differences else "cannot be compared in a height"
    )
    return (
        f"cross-validation, two halves calibrated separately, {heights}; "
        f"held-out residual {validation.all_held_out_rms_px:.3f} px"
    )


@click.command("import-camera")
@click.argument("file", type=FILE)
@output_option("camera.json to write.")
@choice_option("--model", of=LensModel, help="Lens model, if the file does not state it.")
@click.option("--size", "size_text", metavar="WxH", help="Image size, if the file does not state it.")
@click.option("--which", help="Camera to use from a file with several: left, right or its name.")
@json_option
def import_camera(
    file: Path, output: Path, model: Any, size_text: str | None, which: str | None, as_json: bool
) -> None:
    """Import a calibration: OpenCV YAML/JSON, ROS camera_info, Kalibr camchain or mrcal .cameramodel."""
    text = read_text(file, "a camera file of OpenCV, ROS, Kalibr or mrcal")
    imported = read_camera(text, str(file), model, parse_size(size_text), which)
    document = camera_to_dict(imported.camera)
    write_json(output, document)
    for note in imported.notes:
        click.echo(str(note), err=True)
    camera = imported.camera
    size = f"{camera.width_px}x{camera.height_px}"
    covariance = "no covariance" if camera.covariance is None else "with its covariance"
    tell(as_json, document, f"{output}: {camera.model} camera, {size} px, {covariance}")


def parse_size(text: str | None) -> tuple[int, int] | None:
    if text is None:
        return None
    match = re.fullmatch(r"(\d{1,6})[xX](\d{1,6})", text.strip())
    if match is None:
        raise BadInput("commands-size-form", text=repr(text))
    return int(match[1]), int(match[2])


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
    frames, mean_picture = pose_detections(pictures, camera, board, stream_number)
    with problems_of(*pictures[:3]):
        solved = pose_from_corners(camera, frames, board, Reference(**reference), mean_picture)
    document = pose_to_dict(solved)
    write_json(output, document)
    expected = expected_u(solved)
    extra = {
        "warnings": list(solved.warnings),
        "expected": [{"distance_m": d, "u_height_m": u} for d, u in expected],
    }
    tell(
        as_json,
        {**document, **extra},
        f"{output}: {solved.frames_used} frames, residual {solved.rms_px or 0.0:.3f} px, camera "
        f"{solved.centre_m[2]:.3f} m above the road",
        *expected_lines(expected),
        *(f"warning: {warning}" for warning in solved.warnings),
    )


def expected_lines(expected: Iterable[tuple[float, float | None]]) -> list[str]:
    """What heights of 1.2 m will be worth at some distances, a line each; insets are not the pose's."""
    told = ((distance, u) for distance, u in expected if u is not None)
    return [
        f"expected at {distance:g} m: ± {1000 * expanded(u):.0f} mm (95 %) without the inset's part"
        for distance, u in told
    ]


@click.command()
@click.option("--pose", "pose_file", type=FILE, required=True, help="pose.json of the recording.")
@click.option("--contact", metavar="X,Y", help="Tyre contact point, pixels.")
@click.option("--target", metavar="X,Y", help="Target point, pixels.")
@choice_option("--kind", of=Target, help="Kind of target; sets the default inset.")
@choice_option("--side", of=DriverSide, help="Driver's side of the vehicle.")
@number_option(
    "--inset",
    help="Inset: distance of the target behind the side plane, metres (default: that of --kind, else 0).",
)
@number_option("--u-inset", help="u of the inset, metres (default: that of --kind, else 0).")
@number_option("--sigma", default=1.0, help="u of each click coordinate, pixels.")
@click.option("--clicks", type=FILE, help="clicks.csv instead of one pair of clicks.")
@click.option("--tracks", type=FILE, help="tracks.csv: one vehicle followed through its pass.")
@number_option("--confirmed", "confirmed_px", default=1.0, help="u of each track's first click, pixels.")
@click.option("--begun-on", type=int, help="Frame that was clicked on (default: the first of the table).")
@number_option("--drift", "drift_px", default=0.0, help="u of a followed point from frame to frame, pixels.")
@number_option("--u-time", "u_time_s", default=0.0, help="u of the time of a frame, seconds.")
@number_option(
    "--row-time", "row_time_s", default=0.0, help="Rolling shutter: time from one row to the next, seconds."
)
@number_option("--u-row-time", "u_row_time_s", default=0.0, help="u of the rolling-shutter time, seconds.")
@number_option("--exposure", "exposure_s", default=0.0, help="Exposure of a row, seconds (motion blur).")
@number_option(
    "--view",
    "view_px",
    default=0.0,
    help="u of a point due to its changing aspect, pixels per 100 px of travel.",
)
@number_option(
    "--depth-share", "u_depth_share", default=0.0, help="Relief around the followed target: depth / distance."
)
@click.option("--matched", is_flag=True, help="Followed points are given as shifts from the clicked frame.")
@output_option("heights.csv to write.", required=False)
@json_option
def height(
    pose_file: Path,
    contact: str | None,
    target: str | None,
    kind: str | None,
    side: str | None,
    inset: float | None,
    u_inset: float | None,
    sigma: float,
    clicks: Path | None,
    tracks: Path | None,
    output: Path | None,
    as_json: bool,
    **followed: Any,
) -> None:
    """Compute one height from two clicks or a followed pass, or all heights of a clicks.csv."""
    solved = read_pose_file(pose_file)
    if tracks is not None:
        one_or_many = (contact, target, clicks)
        if any(given is not None for given in one_or_many):
            raise BadInput("commands-tracks-alone")
        refuse_ignored(("sigma",), "the CSV's column sigma_px")
        refuse_ignored(("inset", "u_inset", "kind", "side"), "nothing: a whole pass is solved for its inset")
        refuse_ignored(("output",), "--json and a redirection")
        following = Following(**followed)
        if not following.can_be:
            raise BadInput("height-pass-statement-not-valid")
        tell_pass(measure_pass(solved, read_tracks(tracks), following), as_json)
        return
    refuse_ignored(tuple(followed), "--tracks with a CSV file")
    if clicks is not None:
        if contact is not None or target is not None:
            raise BadInput("commands-points-or-clicks")
        columns = "the CSV's columns sigma_px, inset_m, u_inset_m, target, side"
        refuse_ignored(("sigma", "inset", "u_inset", "kind", "side"), columns)
        _measure_file(solved, clicks, output, as_json)
        return
    refuse_ignored(("output",), "--json and a redirection, or --clicks with a CSV file")
    if contact is None or target is None:
        raise BadInput("commands-points-missing")
    points = parse_point(contact, "--contact"), parse_point(target, "--target")
    assumed = assumed_inset(kind or "", side or "", inset, u_inset)
    measured = _measure_one(solved, *points, sigma, assumed)
    unknown = {"inset_m": None, "u_inset_m": None} if isinstance(assumed, Said) else {}
    tell(as_json, height_to_dict(measured) | unknown, *_height_lines(measured))


def tell_pass(found: WholePass, as_json: bool, also: Mapping[str, Any] | None = None) -> None:
    """A whole pass as a sentence and notes, or as JSON with more beside it."""
    value, *notes = _height_lines(found.height, f", followed on {found.frames} frames")
    dropped = (f"excluded: {one.point} on frame {one.frame}. {one.reason}" for one in found.dropped)
    document = height_to_dict(found.height) | pass_to_dict(found) | dict(also or {})
    tell(as_json, document, value, *dropped, *notes)


def _height_lines(measured: Height, how: str = "") -> list[str]:
    """A height and its notes, a line each; `how`: what is said of it behind its interval."""
    if measured.height_m is None or measured.U95_height_m is None:
        return [f"not measurable: {measured.reason}"]
    value = f"{measured.height_m:.3f} m ± {measured.U95_height_m:.3f} m (95 %){how}"
    return [value, *(f"note: {flag}" for flag in measured.flags)]


def _measure_one(
    solved: RoadPose,
    contact: tuple[float, float],
    target: tuple[float, float],
    sigma: float,
    inset: Assumed | Said,
) -> Height:
    """One height with the flags of its inset. Raises BadInput for a number that cannot be used."""
    numbers = (sigma, 0.0, 0.0) if isinstance(inset, Said) else (sigma, inset.inset_m, inset.u_inset_m)
    if not (np.abs(numbers) <= LARGEST).all() or sigma < 0 or numbers[2] < 0:
        raise BadInput("commands-sigmas-not-finite")
    if isinstance(inset, Said):
        return not_measurable(inset)
    measured = measure_height(solved, contact, target, *numbers)
    return replace(measured, flags=(*inset.flags, *measured.flags)) if measured.status == "ok" else measured


def _measure_file(solved: RoadPose, clicks: Path, output: Path | None, as_json: bool) -> None:
    if output is None:
        raise BadInput("commands-output-missing")
    text, counts = heights_csv(solved, clicks)
    write_whole(output, text)
    told = f"{output}: {counts.measured} of {counts.rows} rows have a height"
    tell(as_json, {**asdict(counts), "output": str(output)}, told)


def height_to_dict(measured: Height) -> dict[str, Any]:
    """A height as `sightline height --json` prints it."""
    said = {name: getattr(measured, name) for name in _PRINTED}
    return said | {
        "reason": measured.reason and str(measured.reason),
        "budget": [asdict(entry) for entry in measured.budget],
        "flags": [str(flag) for flag in measured.flags],
    }


_PRINTED = (*OF_HEIGHT, "inset_m", "u_inset_m", "status")
