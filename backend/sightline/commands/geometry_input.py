"""What the commands of geometry are given: boards, points, sizes, and the files of cameras and poses."""

import functools
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from sightline.commands.files import read_json
from sightline.commands.options import number_option
from sightline.errors import BadInput
from sightline.geometry.board import Board, require_board
from sightline.geometry.camera import Camera
from sightline.geometry.charuco import charuco_of
from sightline.geometry.documents import camera_from_dict, pose_from_dict
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.verdict import require_plausible
from sightline.infra.given_csv import given_number

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


def parse_size(text: str | None) -> tuple[int, int] | None:
    if text is None:
        return None
    match = re.fullmatch(r"(\d{1,6})[xX](\d{1,6})", text.strip())
    if match is None:
        raise BadInput("commands-size-form", text=repr(text))
    return int(match[1]), int(match[2])


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
