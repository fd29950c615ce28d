"""Whether the camera stood still, and how to lay each picture on the first where it did not.

The best corner of each cell of a reference picture is found again in each picture (Bouguet 2000); a turn,
shift and scale that most of the cells share is the camera's (Fischler and Bolles 1981). What a vehicle
hides is not found again, and what it carries along is no majority. Where some corners stay where they were,
the camera stood: a lorry that fills the picture moves everything else. Where the reference is lost, the
picture before tells whether it moves on.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import Small

WIDTH_PX = 320
CELL_PX = 24
LEAST_CELLS = 20
STANDS_PX = 0.35
STANDING_SHARE = 0.2
AGREE_PX = 1.0
AGREE_SHARE = 0.25  # of the cells of the reference, in which no vehicle is that is here now
CLEAR_SHARE = 0.5  # to be a new reference, or to be believed of two pictures that may show the same lorry
PATIENCE_S = 2.0
RENEWED_S = 8.0
STEADY_SHARE = 0.003  # of the width: below it nothing is done
SAID_SHARE = 0.005  # of the width: below it nothing is said
FAR_SHARE = 0.12  # of the picture's width: beyond it the road behind is another
STRAYING_SHARE = 0.3  # of the pictures
ASKED_HZ = 5.0  # as long as it stands
JUMP_SHARE = 0.003  # of the width: asked of the picture before as well

Transform = NDArray[np.float64]


@dataclass(frozen=True)
class Wander:
    """How far the picture wandered, shares of its width: `usual` 19 of 20 pictures stay below, `most`; and
    the share of pictures that strayed: on which nothing stood, and which could not be laid on the first.
    """

    usual: float
    most: float
    strayed: float

    @property
    def still(self) -> bool:
        """Whether there is nothing to be said about it."""
        return self.usual <= SAID_SHARE and self.strayed <= STRAYING_SHARE

    @property
    def hopeless(self) -> bool:
        """Whether no road behind can be told."""
        return self.strayed > STRAYING_SHARE or self.usual > FAR_SHARE


class Steadiness:
    """Feed it the pictures in order; each answer lays that picture on the first."""

    def __init__(self, rate_hz: float) -> None:
        self._renewed = max(2, round(RENEWED_S * rate_hz))
        self._patience = max(2, round(PATIENCE_S * rate_hz))
        self._every = max(1, round(rate_hz / ASKED_HZ))
        self._count = -1
        self._reference: Small | None = None
        self._before: Small | None = None
        self._corners = np.zeros((0, 1, 2), np.float32)
        self._base = _identity()
        self._now = _identity()
        self._age = 0
        self._hidden = 0
        self._strayed = 0
        self._off: list[float] = []

    def place(self, picture: Small) -> Transform | None:
        """The transform (2, 3) that takes points of this picture, `picture` (h, w), to the first one, both in
        shares of the width; None where it stands as the first did.

        Own method: the module's.
        """
        tall = picture.shape[0] / picture.shape[1]
        self._count += 1
        if self._count % self._every and _reach(self._now, tall) == 0:
            self._age += 1
            self._off.append(0.0)
            return None
        if self._reference is None or self._before is None:
            self._renew(picture, tall)
        else:
            self._follow(picture, tall)
        self._before = picture
        off = _reach(self._now, tall)
        self._off.append(off)
        return None if off <= STEADY_SHARE else self._now

    def wander(self) -> Wander:
        """What it came to so far."""
        off = np.array(self._off or [0.0])
        return Wander(float(np.percentile(off, 95)), float(off.max()), self._strayed / len(off))

    def _follow(self, picture: Small, tall: float) -> None:
        """Lay this picture by the reference. Where that is hidden, the last place holds for a while."""
        assert self._reference is not None and self._before is not None
        self._age += 1
        found = shared_motion(self._reference, picture, self._corners)
        if found is not None and found.share >= AGREE_SHARE:
            self._hidden = 0
            self._now = self._reject_jump(_compose(self._base, found.transform), picture, tall)
            if self._age >= self._renewed and found.share >= CLEAR_SHARE:
                self._renew(picture, tall)
            return
        self._hidden += 1
        self._strayed += not self._stands(picture, tall)
        if self._hidden >= self._patience:
            self._renew(picture, tall)

    def _stands(self, picture: Small, tall: float) -> bool:
        """Whether nothing says that the camera moved since the picture before."""
        assert self._before is not None
        step = shared_motion(self._before, picture, corners_by_cell(self._before))
        return step is None or step.share < CLEAR_SHARE or _reach(step.transform, tall) == 0

    def _reject_jump(self, found: Transform, picture: Small, tall: float) -> Transform:
        """`found`, unless it jumped away from the last while the picture before says that nothing moved."""
        jump = abs(_reach(found, tall) - _reach(self._now, tall))
        return self._now if jump > JUMP_SHARE and self._stands(picture, tall) else found

    def _renew(self, picture: Small, tall: float) -> None:
        """This picture is the reference from now on; a small error does not add up."""
        self._reference, self._age, self._hidden = picture, 0, 0
        self._corners = corners_by_cell(picture)
        steady = _reach(self._now, tall) <= STEADY_SHARE
        self._base = self._now = _identity() if steady else self._now


def corners_by_cell(picture: Small) -> NDArray[np.float32]:
    """The best corner of each cell of CELL_PX, (N, 1, 2) pixels, of `picture` (h, w).

    Least eigenvalue of the structure tensor (Shi and Tomasi 1994), one a cell, so that a vehicle full of
    corners does not outvote a plain road.
    """
    strength = cv2.cornerMinEigenVal(picture, 5)
    rows, columns = (size // CELL_PX for size in picture.shape)
    cells = strength[: rows * CELL_PX, : columns * CELL_PX].reshape(rows, CELL_PX, columns, CELL_PX)
    best = cells.transpose(0, 2, 1, 3).reshape(rows, columns, -1).argmax(axis=2)
    at = np.indices((rows, columns)) * CELL_PX
    points = np.stack([at[1] + best % CELL_PX, at[0] + best // CELL_PX], axis=-1).reshape(-1, 1, 2)
    return points.astype(np.float32)


@dataclass(frozen=True, eq=False)
class Shared:
    """The turn, shift and scale (2, 3) that most of what was found again shares, and the share of corners."""

    transform: Transform
    share: float


def shared_motion(before: Small, after: Small, corners: NDArray[np.float32]) -> Shared | None:
    """What the `corners` (N, 1, 2) of `before` (h, w) share on the way back from `after` (h, w), shifts in
    shares of the width; exactly nothing where some of them stand; None where too few are found again.

    Fischler and Bolles 1981, on corners that are found there and back (Bouguet 2000).
    """
    if len(corners) < LEAST_CELLS:
        return Shared(_identity(), 1.0)
    there, status, _ = cv2.calcOpticalFlowPyrLK(
        before, after, corners, np.zeros_like(corners), winSize=(15, 15), maxLevel=3
    )
    back, again, _ = cv2.calcOpticalFlowPyrLK(
        after, before, there, np.zeros_like(there), winSize=(15, 15), maxLevel=3
    )
    same = np.hypot(*(back - corners)[:, 0].T) < 0.5
    good = (status[:, 0] > 0) & (again[:, 0] > 0) & same
    here, gone = corners[good, 0], there[good, 0]
    if (np.hypot(*(gone - here).T) < STANDS_PX).sum() >= STANDING_SHARE * len(corners):
        return Shared(_identity(), 1.0)
    if len(here) < LEAST_CELLS:
        return None
    found, agreeing = cv2.estimateAffinePartial2D(gone, here, ransacReprojThreshold=AGREE_PX)
    if found is None:
        return None
    step = np.asarray(found, np.float64)
    step[:, 2] /= before.shape[1]
    return Shared(step, float(agreeing.sum()) / len(corners))


def warp_onto_first(small: Small, place: Transform) -> Small:
    """`small` (h, w) as it would be seen by the camera of the first picture, (h, w); its border goes on
    outwards.

    Own method: OpenCV's warpAffine with `place` (2, 3), in shares of the width.
    """
    matrix = place.copy()
    matrix[:, 2] *= small.shape[1]
    size = small.shape[1], small.shape[0]
    return np.asarray(
        cv2.warpAffine(small, matrix, size, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE), np.uint8
    )


def map_back(place: Transform, x: float, y: float) -> tuple[float, float]:
    """Where a point of the first picture lies in the picture that `place` (2, 3) lays on it; shares of the
    width.

    Own method: the inverse of the transform.
    """
    at = np.linalg.solve(place[:, :2], np.array([x, y]) - place[:, 2])
    return float(at[0]), float(at[1])


def _identity() -> Transform:
    return np.eye(2, 3)


def _compose(second: Transform, first: Transform) -> Transform:
    """The transform that does `first`, then `second`."""
    return np.column_stack([second[:, :2] @ first[:, :2], second[:, :2] @ first[:, 2] + second[:, 2]])


def _reach(transform: Transform, tall: float) -> float:
    """How far it moves the corner of the picture that it moves most, in shares of the width."""
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, tall], [1.0, tall]])
    return float(np.hypot(*(corners @ transform[:, :2].T + transform[:, 2] - corners).T).max())
