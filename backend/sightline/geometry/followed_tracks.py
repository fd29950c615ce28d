"""Points of one vehicle followed through its pass, and how uncertain each of them is.

A followed point errs in ways of its own on every frame, and in ways that it shares with the others of its
track: the template was begun by a person's click that is off by as much on every frame, and it drifts away
from what it was, as a random walk with the frames between (Matthews et al. 2004). Where all frames are
matched to a common picture, a point is known on the confirmed frame by the click alone; by what that
frame's own match is off, the points of all other frames are. A frame's time is wrong for all of its points
at once. Motion blur that grows or shrinks may hold a template by an edge of the blurred point instead of
its middle: anywhere within half of the change.
"""

from dataclasses import dataclass
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.enums import FollowedPoint

CONTACT, SECOND, TARGET = 0, 1, 2
EXACT_PX = 0.02  # of a point on the frame that it was confirmed on, beside the click: rounding, the lens
_MOST = 1e6  # of what is stated of following, px and s; squares of much larger numbers overflow
POINT_NAMES: tuple[FollowedPoint, ...] = get_args(FollowedPoint)


@dataclass(frozen=True, eq=False)
class Tracks:
    """N observations of a vehicle: `frame` (N,), `time_s` (N,), `point` (N,) one of CONTACT, SECOND (the
    other tyre of the same side) and TARGET, `points_px` (N, 2), `sigma_px` (N,) of each coordinate on its
    own frame, or (N, 2) of x and y: an edge tells little of the place along it.
    """

    frame: NDArray[np.int64]
    time_s: Floats
    point: NDArray[np.int64]
    points_px: Floats
    sigma_px: Floats

    def only(self, kept: NDArray[np.bool_]) -> "Tracks":
        """The observations for which `kept` (N,) holds."""
        return Tracks(
            self.frame[kept], self.time_s[kept], self.point[kept], self.points_px[kept], self.sigma_px[kept]
        )


@dataclass(frozen=True)
class Following:
    """How the points were followed. `confirmed_px`: standard uncertainty of the click that began each
    track, 0 where every frame was clicked by itself; `drift_px`: of a template's drift from one frame to
    the next; `begun_on`: the frame clicked on (None: the first). `matched`: places on the other frames count
    from that one by the shifts of both against a common picture; `Tracks.sigma_px` is then that of each
    frame's shift. `row_time_s`: from one row's exposure to
    the next, 0 for a global shutter. `exposure_s`: how long each row is exposed. `u_depth_share`: what is
    followed about the target may lie before or behind it, by so much of the distance to the camera.
    `view_px`: a point that is seen from another side is off by something that grows with the way through the
    picture, by so much in 100 px, and by half of it with the square of the way.
    """

    confirmed_px: float = 1.0
    drift_px: float = 0.0
    begun_on: int | None = None
    u_time_s: float = 0.0
    row_time_s: float = 0.0
    u_row_time_s: float = 0.0
    exposure_s: float = 0.0
    u_depth_share: float = 0.0
    view_px: float = 0.0
    matched: bool = False

    @property
    def can_be(self) -> bool:
        """Whether it is stated in numbers that can be: none but the row time lies below 0."""
        stated = (self.confirmed_px, self.drift_px, self.u_time_s, self.u_row_time_s, self.exposure_s,
                  self.u_depth_share, self.view_px)  # fmt: skip
        return all(0.0 <= one <= _MOST for one in stated) and abs(self.row_time_s) <= _MOST


def noise_parts(tracks: Tracks, following: Following, speed_px_s: Floats) -> dict[str, Floats]:
    """Covariance (2N, 2N), pixels squared, of each source; rows x, y of each observation. `speed_px_s` (N,
    2): how fast each point crosses the picture. Sources that are 0 are left out, but for `following`.

    Own derivation: CONVENTIONS.md, Whole passes. The drift is a random walk, covariance min(i, j).
    """
    each = np.square(np.broadcast_to(tracks.sigma_px.reshape(len(tracks.frame), -1), (len(tracks.frame), 2)))
    same = np.equal.outer(tracks.point, tracks.point)
    own = _of_matches(tracks, following, each, same) if following.matched else np.diag(each.ravel())
    parts = {"following": own + _blur(tracks, following, speed_px_s)}
    if following.confirmed_px > 0:
        parts["confirmed points"] = _both_axes(same * following.confirmed_px**2)
    if following.drift_px > 0:
        away = tracks.frame - _begun_on(tracks, following)
        shared = np.minimum.outer(np.abs(away), np.abs(away)) * np.equal.outer(np.sign(away), np.sign(away))
        parts["drift"] = _both_axes(same * shared * following.drift_px**2)
    if following.u_time_s > 0:
        at_once = np.repeat(np.repeat(np.equal.outer(tracks.frame, tracks.frame), 2, axis=0), 2, axis=1)
        moved = speed_px_s.ravel() * following.u_time_s
        parts["frame times"] = np.outer(moved, moved) * at_once
    if following.u_depth_share > 0:
        since = tracks.time_s - _begun_at_s(tracks, following)
        late = (speed_px_s * (since * (tracks.point == TARGET))[:, None]).ravel() * following.u_depth_share
        parts["depth of what is followed"] = np.outer(late, late)
    if following.view_px > 0:
        way = np.linalg.norm(speed_px_s, axis=1) * (tracks.time_s - _begun_at_s(tracks, following)) / 100.0
        grown = np.outer(way, way)
        parts["seen from another side"] = _both_axes(same * following.view_px**2 * (grown + grown**2 / 4.0))
    return parts


def _of_matches(tracks: Tracks, following: Following, each: Floats, same: NDArray[np.bool_]) -> Floats:
    """Covariance (2N, 2N) of places that count from the confirmed frame: shift of a frame minus that of the
    confirmed one, so the latter's error is common to all but itself.
    """
    begun = tracks.frame == _begun_on(tracks, following)
    common = np.zeros_like(each)
    for point in np.unique(tracks.point):
        mine = tracks.point == point
        confirmed = mine & begun  # none where it was left out: then about as the others
        common[mine] = np.median(each[confirmed if confirmed.any() else mine], axis=0)
    common[begun] = 0.0
    own = np.where(begun[:, None], EXACT_PX**2, each)
    out = np.diag(own.ravel())
    for axis in range(2):
        root = np.sqrt(common[:, axis])
        out[axis::2, axis::2] += np.outer(root, root) * same
    return np.asarray(out, dtype=np.float64)


def u_of_rounded_times(time_s: Floats, tick_s: float) -> float:
    """Standard uncertainty of frame times, `time_s` (N,), that a file keeps in whole ticks, seconds: that of
    rounding, the coarsest tick that all intervals hold over sqrt(12) (JCGM 100:2008, 4.3.7).

    0 where all intervals are multiples of the least one, for then nothing was rounded, and where the times
    are no multiples of `tick_s` (0: not known).
    """
    intervals = np.diff(np.unique(time_s))
    if len(intervals) == 0 or not tick_s > 0:
        return 0.0
    ticks = np.rint(intervals / tick_s).astype(np.int64)
    if np.abs(intervals / tick_s - ticks).max() > 0.01:
        return 0.0
    common = int(np.gcd.reduce(ticks))
    return 0.0 if common == ticks.min() else float(common * tick_s / np.sqrt(12.0))


def clicked_at_s(tracks: Tracks, following: Following, middle_row: float) -> float:
    """When the contact was where it was clicked, seconds: the time of the frame clicked on (else of the
    nearest one that shows a contact) and of its row; a frame's time is that of `middle_row`.

    Rolling shutter: CONVENTIONS.md, Whole passes. ValueError where no frame shows a contact.
    """
    contact = np.flatnonzero(tracks.point == CONTACT)
    on = contact[np.argmin(np.abs(tracks.frame[contact] - _begun_on(tracks, following)))]
    return float(tracks.time_s[on] + following.row_time_s * (tracks.points_px[on, 1] - middle_row))


def _begun_at_s(tracks: Tracks, following: Following) -> float:
    return float(tracks.time_s[np.argmin(np.abs(tracks.frame - _begun_on(tracks, following)))])


def _begun_on(tracks: Tracks, following: Following) -> int:
    return int(tracks.frame.min()) if following.begun_on is None else following.begun_on


def _both_axes(of_points: Floats) -> Floats:
    return np.asarray(np.kron(of_points, np.eye(2)), dtype=np.float64)


def _blur(tracks: Tracks, following: Following, speed_px_s: Floats) -> Floats:
    """Along the movement: uniform within half of what the blur's length changed since the track began."""
    out = np.zeros((2 * len(tracks.frame), 2 * len(tracks.frame)))
    if following.exposure_s <= 0:
        return out
    length = np.linalg.norm(speed_px_s, axis=1)
    for point in np.unique(tracks.point):
        mine = np.flatnonzero(tracks.point == point)
        began = mine[np.argmin(np.abs(tracks.frame[mine] - _begun_on(tracks, following)))]
        for i in mine:
            change = following.exposure_s * (length[i] - length[began])
            along = speed_px_s[i] / max(length[i], 1e-12)
            out[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] = np.outer(along, along) * change**2 / 12.0
    return out
