"""Road pose from the checkerboard that stands on the road: one joint solution from all still frames."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sightline.arrays import Floats
from sightline.errors import BadInput
from sightline.geometry.board import Board, board_points, require_board, road_points
from sightline.geometry.board_errors import bow_profiles, bow_response
from sightline.geometry.camera import Camera, project, undistort
from sightline.geometry.corners import Corners, spacing_px
from sightline.geometry.documents import LARGEST
from sightline.geometry.height import measure_height
from sightline.geometry.planar import PlanarPose, linearise, planar_roots
from sightline.geometry.road_pose import DEFAULT_U_SQUARE, BoardOnRoad, Reference, RoadPose
from sightline.geometry.saddle import refine_saddles
from sightline.geometry.stillness import STILL_PX, Still, displacements_px, find_still, mean_sigma_px
from sightline.messages.said import Said

# board frame (x right, y down, z away) from road frame (X right, Y away, Z up), but for the origin's shift
_BOARD_FROM_ROAD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
_HIGHEST_RMS_PX = 3.0
_LYING = float(np.cos(np.deg2rad(45.0)))
_EDGE_ON_RAD = np.deg2rad(10.0)
_AMBIGUOUS = 1.5  # ratio of the costs of the two planar poses below which the choice is doubtful


def pose_from_corners(
    camera: Camera,
    frames: Sequence[Corners],
    board: Board,
    reference: Reference,
    mean_picture: Floats | None = None,
) -> RoadPose:
    """Where the camera stood, from one detection per frame of the span in which the board stood still.

    All still frames share one pose; least squares over them equals least squares on their mean corners, so
    that is what is solved (Gauss-Newton from both planar solutions). The covariance is joint with the lens's:
    an error of the lens moves the pose, A = -(J'J)^-1 J'J_lens. It comes from the residuals and their
    correlation in time and is never divided by the number of frames; what the board may be off by is left to
    the height's budget (CONVENTIONS.md, Pose).

    In place of Dupuis et al. 2019, eqs. (5) to (8): there R, t are said to lead from the camera to the board
    (they lead back), and (5) to (7) translate directions.

    Parameters
    ----------
    camera : Camera
    frames : sequence of Corners
        `points_px` (rows, columns, 2), one detection a frame.
    board : Board
        Squares of `square_m`, metres.
    reference : Reference
        Which row of inner corners was measured with a tape, and its height above the road, metres.
    mean_picture : (H, W) array, optional
        The mean of the still frames (mean_picture.py), on which the corners are then fitted again.

    Returns
    -------
    RoadPose
        With the covariance of lens and pose, and warnings.

    Raises
    ------
    BadInput
        With a reason: no detection, board or camera moving, board edge-on, wrong board or camera.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> camera = sightline.plain_camera(1920, 1080, field_of_view_rad=1.0)
    >>> board = sightline.Board(columns=6, rows=4, square_m=0.1)
    >>> across, down = np.meshgrid(np.arange(6) * 0.1, np.arange(4) * 0.1)
    >>> seen = np.stack([across - 0.25, down + 0.2, np.full((4, 6), 4.0)], axis=-1)
    >>> points_px = sightline.project(camera, seen.reshape(-1, 3)).reshape(4, 6, 2)
    >>> corners = sightline.Corners(True, points_px, board, None, 2.0, "drawn")
    >>> pose = sightline.pose_from_corners(camera, [corners], board, sightline.Reference("top", 1.2))
    >>> [round(float(metres), 3) for metres in pose.centre_m]
    [0.25, -4.0, 1.4]
    """
    require_board(board)
    _require_reference(reference)
    used = [c for c in frames if c.found and c.ids is None]
    if not used:
        reason = _why_none(frames)
        raise BadInput("geometry-board-not-found", count=len(frames), reason=reason)
    seen_as = used[0].board_as_seen
    used = [c for c in used if c.points_px.shape == used[0].points_px.shape]
    seen_board = replace(seen_as, square_m=board.square_m)
    still = _require_still(np.stack([c.points_px.reshape(-1, 2) for c in used]))
    if mean_picture is not None:
        still = _on_mean(mean_picture, still, seen_board)
    roots = planar_roots(camera, board_points(seen_board), still.mean_px)
    if not roots:
        raise BadInput("geometry-pose-misfit")
    best = roots[0]
    warnings = _check_pose(best, roots, still, seen_board, len(frames) - len(used))
    return _on_road(camera, best, seen_board, reference, still, warnings)


def _why_none(frames: Sequence[Corners]) -> Said:
    if not frames:
        return Said("board-no-frame")
    parts = [len(c.ids) for c in frames if c.ids is not None]
    if parts:
        whole = frames[0].board_as_seen.corners
        return Said("board-corners-few", parts=max(parts), whole=whole)
    return frames[0].reason or Said("board-not-found")


def _require_reference(reference: Reference) -> None:
    doubts = (reference.u_height_m, reference.u_lean_rad, reference.u_square_m or 0.0, reference.u_bow_m)
    if not (np.abs((reference.height_m, *doubts)) <= LARGEST).all() or min(doubts) < 0:
        raise BadInput("geometry-heights-not-numbers")
    if not 0.0 <= reference.height_m <= 20.0:
        raise BadInput("geometry-row-height-implausible", height_m=reference.height_m, side=reference.side)


def _require_still(frames_px: Floats) -> Still:
    """The still part of the span; BadInput when board or camera moves through most of it."""
    still = find_still(frames_px)
    if len(frames_px) > 1 and len(still.kept) < max(1, (len(frames_px) + 1) // 2):
        raise BadInput("geometry-board-moves", moved_px=still.moved_px)
    return still


def _on_mean(mean_picture: Floats, still: Still, board: Board) -> Still:
    """Corners fitted on the mean picture instead of the mean of the corners, where both agree."""
    grid = still.mean_px.reshape(board.rows, board.columns, 2)
    fitted = refine_saddles(mean_picture, grid, board.clear_share)
    if (
        not fitted.ok.all()
        or displacements_px((fitted.points_px - still.mean_px)[None], still.mean_px)[0] > STILL_PX
    ):
        return still
    return replace(still, mean_px=fitted.points_px)


def _check_pose(
    best: PlanarPose, roots: list[PlanarPose], still: Still, board: Board, missed: int
) -> tuple[Said, ...]:
    """Refuse what cannot be a pose of this board, and say what is doubtful."""
    rms = float(np.sqrt(best.cost / len(best.residuals_px)))
    if rms > _HIGHEST_RMS_PX:
        raise BadInput("geometry-corners-misfit", rms=rms)
    slant = abs(float(best.rotation[:, 2] @ _unit(best.translation)))
    if slant < np.sin(_EDGE_ON_RAD):
        raise BadInput("geometry-board-edge-on")
    warnings = []
    if missed:
        warnings.append(Said("pose-frames-without-board", missed=missed))
    if still.moved_px > 0.3 and len(still.kept) > 1:
        warnings.append(Said("pose-frames-moved"))
    if rms > 0.5:
        warnings.append(Said("pose-corners-miss-model", rms_px=round(rms, 2)))
    if len(roots) > 1 and roots[1].cost < _AMBIGUOUS * best.cost + 1e-12:
        warnings.append(Said("pose-two-fit"))
    if spacing_px(still.mean_px.reshape(board.rows, board.columns, 2)) < 8:
        warnings.append(Said("pose-squares-small"))
    roll = float(np.rad2deg(np.arctan2(abs(best.rotation[0, 1]), best.rotation[1, 1])))
    if roll > 28.0:
        warnings.append(Said("pose-board-rolled", roll_deg=round(roll)))
    if len(still.kept) == 1:
        warnings.append(Said("pose-one-frame"))
    return tuple(warnings)


def _unit(v: Floats) -> Floats:
    return np.asarray(v / np.linalg.norm(v), dtype=np.float64)


def _on_road(
    camera: Camera,
    best: PlanarPose,
    board: Board,
    reference: Reference,
    still: Still,
    warnings: tuple[Said, ...],
) -> RoadPose:
    """Express the board pose in the road frame, with the joint covariance of lens and pose."""
    points = road_points(board, reference.side, reference.height_m)
    rotation = best.rotation @ _BOARD_FROM_ROAD
    translation = best.translation - rotation @ points[0]
    at = linearise(camera, rotation, translation, points, still.mean_px)
    freedom = max(2 * len(points) - 6, 1)
    sigma = mean_sigma_px(float(np.sqrt(at.cost / freedom)), still)
    pose = RoadPose(camera, rotation, translation, joint_covariance(camera, at, sigma))
    if lies_on_road(pose):
        raise BadInput("geometry-board-lies-flat")
    if pose.centre_m[2] <= 0:
        raise BadInput("geometry-camera-below-road", height_m=reference.height_m, side=reference.side)
    return replace(
        pose,
        board=board_on_road(board, reference, at, points),
        frames_used=len(still.kept),
        rms_px=float(np.sqrt(at.cost / len(points))),
        warnings=warnings,
    )


def lies_on_road(pose: RoadPose) -> bool:
    """Whether the board of `pose`, which is taken to stand, lies on the road instead: the camera would be
    below the road and look along the board's rows of squares rather than at them, which its upright picture
    contradicts.

    Own method: a camera that is not tipped by more than 45 degrees sees a board that stands with its normal
    across the picture's vertical, one that lies with its normal along it.
    """
    normal_down = abs(float(pose.rotation[1, 1]))
    return bool(pose.centre_m[2] <= 0 and normal_down > _LYING)


def board_on_road(board: Board, reference: Reference, at: PlanarPose, points: Floats) -> BoardOnRoad:
    """The board as it stood, with what it may be off by; `at`: the solution for its `points` (N, 3), metres,
    road frame.

    CONVENTIONS.md, Pose (The board's own errors).
    """
    square = DEFAULT_U_SQUARE * board.square_m if reference.u_square_m is None else reference.u_square_m
    return BoardOnRoad(
        columns=board.columns,
        rows=board.rows,
        square_m=board.square_m,
        reference=reference.side,
        reference_height_m=reference.height_m,
        u_reference_height_m=reference.u_height_m,
        u_lean_rad=reference.u_lean_rad,
        distance_m=float(np.linalg.norm(at.rotation @ points.mean(axis=0) + at.translation)),
        u_square_m=square,
        u_bow_m=reference.u_bow_m,
        bow_response=tuple(tuple(float(v) for v in one) for one in bow_response(at, bow_profiles(board)).T),
    )


def joint_covariance(camera: Camera, at: PlanarPose, sigma_px: float) -> Floats:
    """Covariance (n + 6, n + 6) of the lens's parameters and of a pose solved with them.

    The solved pose answers an error of the lens with A = -(J'J)^-1 J'J_lens; a lens without covariance counts
    as exact (the height's flags say so). Own derivation: CONVENTIONS.md, Pose.
    """
    n = at.lens_jacobian.shape[1]
    inverse = np.linalg.inv(at.jacobian.T @ at.jacobian)
    out = np.zeros((n + 6, n + 6))
    out[n:, n:] = sigma_px**2 * inverse
    if camera.covariance is not None:
        answer = -inverse @ at.jacobian.T @ at.lens_jacobian
        out[:n, :n] = camera.covariance
        out[n:, :n] = answer @ camera.covariance
        out[:n, n:] = out[n:, :n].T
        out[n:, n:] += answer @ camera.covariance @ answer.T
    return 0.5 * (out + out.T)


def expected_u(
    pose: RoadPose, distances_m: Sequence[float] = (2.0, 3.0, 5.0)
) -> tuple[tuple[float, float | None], ...]:
    """What a height will be worth: (distance, u_height_m) per distance across the road, for a target at
    1.2 m in the middle of the picture; None where the picture shows no contact point at that distance.
    """
    out: list[tuple[float, float | None]] = []
    for distance in distances_m:
        clicks = _clicks_at(pose, distance, 1.2)
        height = None if clicks is None else measure_height(pose, clicks[0], clicks[1])
        out.append((distance, None if height is None else height.u_height_m))
    return tuple(out)


def _clicks_at(pose: RoadPose, distance_m: float, height_m: float) -> Floats | None:
    """Pixels of contact and target on the plane at a distance, where the picture's middle column meets it."""
    camera = pose.camera
    middle = undistort(camera, [[(camera.width_px - 1) / 2, (camera.height_px - 1) / 2]])
    forward = pose.rotation.T @ np.array([*middle.points[0], 1.0])
    if not middle.ok[0] or forward[1] <= 0.05:
        return None
    x, y = (pose.centre_m + forward * (distance_m / forward[1]))[:2]
    clicks = project(camera, pose.to_camera(np.array([[x, y, 0.0], [x, y, height_m]])))
    return clicks if np.isfinite(clicks).all() and camera.inside(clicks).all() else None
