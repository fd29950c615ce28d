"""The table of road poses in the package."""

from collections.abc import Callable
from typing import get_args

from sightline.enums import BoardSide
from sightline.infra.csv_package.columns import columns_for, integer, metres, number, text
from sightline.infra.csv_package.schema import Cell, Table, ids_of
from sightline.poses.records import Pose


def pose_path(pose_id: int) -> str:
    """Where a road pose is, as `sightline height --pose` reads it."""
    return f"poses/pose-{pose_id}.json"


def _of_board(name: str) -> Callable[[Pose], Cell]:
    """What the pose states of its board; None where there was none."""

    def of(pose: Pose) -> Cell:
        value: Cell = (pose.document.get("board") or {}).get(name)
        return value

    return of


POSES: Table[Pose] = Table(
    "poses",
    "Where the camera stood with respect to the road; the whole of each is in poses/pose-N.json.",
    (
        *columns_for(Pose, "id recording_id calibration_id first_frame last_frame"),
        integer("frames_used", "frames that entered the solution", lambda p: p.document.get("frames_used")),
        *columns_for(Pose, "rms_px"),
        metres("board_distance_m", "from the camera's centre to the board", lambda p: p.distance_m),
        integer("board_columns", "inner corners in a row of the board", _of_board("columns")),
        integer("board_rows", "rows of inner corners", _of_board("rows")),
        metres("square_m", "side of a square", _of_board("square_m")),
        text("reference", "column-poses-reference", _of_board("reference"), enum=get_args(BoardSide)),
        metres("reference_height_m", "height of that row above the road", _of_board("reference_height_m")),
        metres(
            "u_reference_height_m",
            "standard uncertainty of that height (k = 1)",
            _of_board("u_reference_height_m"),
        ),
        number("u_lean_rad", "column-poses-u-lean-rad", "rad", _of_board("u_lean_rad")),
        metres("u_square_m", "standard uncertainty of the side of a square (k = 1)", _of_board("u_square_m")),
        metres("u_bow_m", "column-poses-u-bow-m", _of_board("u_bow_m")),
        *columns_for(Pose, "turned_from turned_by_rad adjusted_from"),
        text("document", "column-poses-document", lambda p: pose_path(p.id), required=True),
        *columns_for(Pose, "created_by_id created_at"),
    ),
    primary=("id",),
    foreign=ids_of(calibration_id="calibrations"),
)
