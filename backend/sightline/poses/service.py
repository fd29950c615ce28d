"""Road poses: the board on one frame, the pose from a span of frames, and what is drawn and said about it."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import scipy
from pydantic import Field

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.errors import BadInput
from sightline.geometry.board import Board
from sightline.geometry.camera import Camera, project
from sightline.geometry.corners import Corners, Gray, find_board
from sightline.geometry.documents import pose_to_dict
from sightline.geometry.mean_picture import MeanPicture
from sightline.geometry.pose import expected_u, pose_from_corners
from sightline.geometry.road import axes_at_contact, iso_heights, road_grid
from sightline.geometry.road_pose import Reference, RoadPose
from sightline.geometry.ruler import DrawnAxes, Polyline, drawn_axes, polyline
from sightline.messages.said import Said, with_commas
from sightline.poses.records import ExpectedHeight, IsoHeight, PoseOverlay, SolvedPose

# Corner errors of neighbouring frames are correlated: more frames add time, not accuracy.
MOST_FRAMES = 15
#: A corner that moved less has not moved: beyond the scatter of its detection, below any push of the board.
STILL_PX = 1.0
EXPECTED_AT_M = (2.0, 3.0, 5.0)
_ORDER = Said("board-order")

Progress = Callable[[float, Said], None]


@dataclass(frozen=True)
class BoardView:
    """The board on one frame; where it was not found, why."""

    found: bool
    reason: Said | None
    columns: int
    rows: int
    corners_px: Polyline
    outline_px: Polyline
    ids: Annotated[
        list[int] | None,
        Field(description="Which corners were seen, counted row by row; null for all of them."),
    ]
    order_notes: list[Said]


@dataclass(frozen=True, eq=False)
class BoardSeen:
    """The board in frames of a span: its corners in each, and the mean picture of the still ones."""

    corners: tuple[Corners, ...]
    mean_picture: Floats | None


def preview_board(pictures: Iterable[Gray], board: Board) -> BoardSeen:
    """Detect the board in grey pictures in time order; where it is not found, the reason stays."""
    mean, detections = MeanPicture(), []
    for gray in pictures:
        corners = find_board(gray, board)
        detections.append(corners)
        if corners.found and corners.ids is None:
            mean.add(gray, corners)
    return BoardSeen(tuple(detections), mean.result())


def board_view(gray: Gray, board: Board) -> BoardView:
    """Look for the board in one grey picture (H, W). Raises BadInput for an impossible board."""
    corners = find_board(gray, board)
    is_found, board_as_seen, notes = corners.found, corners.board_as_seen, [_ORDER]
    if (board_as_seen.columns, board_as_seen.rows) != (board.columns, board.rows):
        notes.append(Said("board-order-turned", columns=board_as_seen.columns, rows=board_as_seen.rows))
    ids = None if corners.ids is None else corners.ids.tolist()
    if ids is not None:
        notes.insert(0, Said("board-order-part", seen=len(ids), all=board_as_seen.corners))
    return BoardView(
        found=is_found,
        reason=None if is_found else corners.reason,
        columns=board_as_seen.columns,
        rows=board_as_seen.rows,
        corners_px=polyline(corners.points_px.reshape(-1, 2)),
        outline_px=outline(corners) if is_found else [],
        ids=ids,
        order_notes=notes,
    )


@dataclass(frozen=True, slots=True)
class StillSpan:
    """Frames, both included, in which the board stands where it stands on one of them."""

    first_frame: int
    last_frame: int


def still_span(look: Callable[[int], Corners], frame: int, last: int) -> StillSpan | None:
    """The span around `frame` in which the board stands still, of a recording that ends with frame `last`.

    Steps double outwards, then halve: some twenty looks for any length. What covers the board ends the span.
    None where it is not found on the frame itself.
    """
    here = look(frame)
    if not here.found:
        return None

    def stands(n: int) -> bool:
        there = look(n)
        if not there.found or there.points_px.shape != here.points_px.shape:
            return False
        return bool(np.abs(there.points_px - here.points_px).max() < STILL_PX)

    return StillSpan(_furthest(stands, frame, 0), _furthest(stands, frame, last))


def _furthest(stands: Callable[[int], bool], start: int, end: int) -> int:
    """The frame furthest towards `end` up to which it stands, as far as doubled and halved steps tell."""
    way = 1 if end >= start else -1
    good, step = start, 1
    while good != end:
        n = good + way * min(step, abs(end - good))
        if not stands(n):
            bad = n
            while abs(bad - good) > 1:
                middle = (good + bad) // 2
                good, bad = (middle, bad) if stands(middle) else (good, middle)
            break
        good, step = n, 2 * step
    return good


def outline(corners: Corners) -> Polyline:
    """The outermost inner corners, clockwise from the top left, closed; of a board seen in part its hull."""
    grid = corners.points_px
    if corners.ids is None:
        ring = np.array([grid[0, 0], grid[0, -1], grid[-1, -1], grid[-1, 0]])
    else:
        ring = grid[scipy.spatial.ConvexHull(grid).vertices]
    return polyline(np.array([*ring, ring[0]]))


def frames_to_try(first: int, last: int) -> list[int]:
    """Frame numbers spread evenly over the span, both ends included."""
    count = min(MOST_FRAMES, last - first + 1)
    return sorted({round(float(n)) for n in np.linspace(first, last, count)})


def board_in_span(
    gray_of: Callable[[int], Gray], first: int, last: int, board: Board, progress: Progress
) -> BoardSeen:
    """The board in frames of the span. Raises BadInput, saying why, where no frame shows it."""
    wanted = frames_to_try(first, last)

    def pictures() -> Iterator[Gray]:
        for index, n in enumerate(wanted):
            progress(0.05 + 0.75 * index / len(wanted), Said("job-board-searching-frame", frame=n))
            yield gray_of(n)

    board_seen = preview_board(pictures(), board)
    if not any(corners.found for corners in board_seen.corners):
        reasons = Counter(corners.reason or Said("board-not-found") for corners in board_seen.corners)
        reason, _ = reasons.most_common(1)[0]
        raise BadInput("poses-board-not-shown", first=first, last=last, reason=reason)
    return board_seen


def solve(camera: Camera, board_seen: BoardSeen, board: Board, reference: Reference) -> SolvedPose:
    """The camera pose from the board as seen, with its verdict and drawing.

    Raises BadInput with the reason (board or camera moved, board seen edge-on, height that cannot be).
    """
    pose = pose_from_corners(camera, list(board_seen.corners), board, reference, board_seen.mean_picture)
    found = [corners for corners in board_seen.corners if corners.found and corners.ids is None]
    return describe_pose(pose, found[len(found) // 2].points_px.reshape(-1, 2))


def describe_pose(pose: RoadPose, corners_px: Floats) -> SolvedPose:
    """A pose with its verdict and drawing; corners_px (N, 2): the board on the frame that is drawn over."""
    expected = [_expected(*at) for at in expected_u(pose, EXPECTED_AT_M)]
    distance_m = None if pose.board is None else pose.board.distance_m
    return SolvedPose(
        rms_px=pose.rms_px,
        document=pose_to_dict(pose),
        warnings=list(pose.warnings),
        expected=expected,
        overlay=overlay(pose, corners_px),
        distance_m=distance_m,
        summary=verdict(expected, distance_m, float(pose.centre_m[2])),
    )


def _expected(distance_m: float, u_m: float | None) -> ExpectedHeight:
    reason = None if u_m is not None else Said("pose-no-road-at-distance")
    u95_m = None if u_m is None else COVERAGE_95 * u_m
    return ExpectedHeight(distance_m=distance_m, u_height_m=u_m, U95_height_m=u95_m, reason=reason)


def verdict(
    expected: Sequence[ExpectedHeight], distance_m: float | None, camera_height_m: float
) -> list[Said]:
    """Where the board stood, how high the camera is, how well heights will be known."""
    board = [] if distance_m is None else [Said("pose-board-distance", distance_m=round(distance_m, 2))]
    camera = Said("pose-camera-height", height_m=round(camera_height_m, 2))
    known = [
        Said("pose-expected-at", U95_height_m=round(u95_m, 4), distance_m=round(one["distance_m"]))
        for one in expected
        if (u95_m := one["U95_height_m"]) is not None
    ]
    heights = [Said("pose-expected-heights", figures=with_commas(known))] if known else []
    return [*board, camera, *heights]


def overlay(pose: RoadPose, corners_px: Floats) -> PoseOverlay:
    """Road grid, axes below the board and lines of equal height, as pixel polylines for the browser."""
    across_m = -float(pose.centre_m[1])
    lines = iso_heights(pose, across_m, iso_steps(float(pose.centre_m[2])))
    return PoseOverlay(
        grid=[polyline(line) for line in road_grid(pose)],
        iso_heights=[IsoHeight(height_m=height_m, points=polyline(line)) for height_m, line in lines],
        axes=_axes_of_board(pose),
        corners_px=polyline(corners_px),
    )


def iso_steps(camera_height_m: float) -> tuple[float, ...]:
    """Four heights to draw lines at: half metres beside a road, less where a camera stands lower."""
    step = 0.5 if camera_height_m > 0.6 else 0.1 if camera_height_m > 0.1 else 0.02
    return tuple(round(step * count, 3) for count in range(1, 5))


def _axes_of_board(pose: RoadPose) -> DrawnAxes | None:
    """The axes through the road's origin (below the board), None where it is out of sight."""
    origin_px = project(pose.camera, pose.translation_m.reshape(1, 3))[0]
    axes = axes_at_contact(pose, origin_px, length_m=1.0, height_m=1.5)
    return None if isinstance(axes, Said) else drawn_axes(axes)


def check_fits(camera: Camera, width_px: int, height_px: int, name: str) -> None:
    """Refuse a calibration of another picture size: its pixels mean something else."""
    if (camera.width_px, camera.height_px) != (width_px, height_px):
        raise BadInput(
            "poses-calibration-image-size",
            width_px=camera.width_px,
            height_px=camera.height_px,
            name=name,
            width_px_2=width_px,
            height_px_2=height_px,
        )
