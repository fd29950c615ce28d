"""Words beside the curves that they name, where no other curve runs and no other word stands."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Annotation
from matplotlib.transforms import Bbox

from sightline.arrays import Floats
from sightline.export.report.canvas import INK, TEXT_PT

_ALONG = np.linspace(0.04, 0.96, 93)
_DENSE = 800
_AIR_PX = 1.5
_APART_PT = 7.0  # a word is nearer to its own curve than to any other
# Where a word stands from its point of the curve: points right and up, and its edge that is turned to it.
_SIDES = (
    (4.0, -2.0, "left", "top"),
    (-4.0, 2.0, "right", "bottom"),
    (4.0, 2.0, "left", "bottom"),
    (-4.0, -2.0, "right", "top"),
)
Side = tuple[float, float, str, str]


@dataclass(frozen=True, eq=False)
class Named:
    """A curve as drawn, (M,) each in data units, and its word, best placed at this share `at` of its way."""

    x: Floats
    y: Floats
    word: str
    at: float = 0.5


@dataclass(frozen=True, eq=False)
class _Place:
    x: float
    y: float
    side: Side
    box: Bbox


def label(axes: Axes, curves: Sequence[Named]) -> bool:
    """Write each curve's word beside it; False, and none, where one has no room. Limits must be final."""
    paths = [_dense(axes, one) for one in curves]
    taken: list[Bbox] = []
    places: list[_Place] = []
    for one, path in zip(curves, paths, strict=True):
        others = [other for other in paths if other is not path]
        place = _place(axes, one, path, np.concatenate([np.empty((0, 2)), *others]), taken)
        if place is None:
            return False
        places.append(place)
        taken.append(place.box)
    for one, place in zip(curves, places, strict=True):
        write(axes, one.word, place.x, place.y, place.side)
    return True


def write(axes: Axes, word: str, x: float, y: float, side: Side) -> Annotation:
    """A word beside a place of the sheet, in pixels."""
    right, up, ha, va = side
    return axes.annotate(
        word,
        (x, y),
        xycoords="figure pixels",
        xytext=(right, up),
        textcoords="offset points",
        ha=ha,
        va=va,
        fontsize=TEXT_PT,
        color=INK,
        annotation_clip=False,
    )


def _dense(axes: Axes, one: Named) -> Floats:
    """Points along the curve at equal steps of the sheet, (_DENSE, 2) pixels."""
    at = np.asarray(axes.transData.transform(np.column_stack([one.x, one.y])), dtype=np.float64)
    run = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(at, axis=0).T))])
    along = np.linspace(0.0, run[-1], _DENSE)
    return np.column_stack([np.interp(along, run, at[:, 0]), np.interp(along, run, at[:, 1])])


def _place(axes: Axes, curve: Named, path: Floats, others: Floats, taken: Sequence[Bbox]) -> _Place | None:
    """The free place nearest to the wished one."""
    frame, size = axes.get_window_extent(), _size(axes, curve.word)
    dots = axes.figure.dpi / 72.0
    for share in sorted(_ALONG, key=lambda share: abs(share - curve.at)):
        x, y = (float(v) for v in path[round(share * (_DENSE - 1))])
        for side in _SIDES:
            right, up, ha, va = side
            left = x + dots * right - (size[0] if ha == "right" else 0.0)
            foot = y + dots * up - (size[1] if va == "top" else 0.0)
            box = Bbox.from_bounds(left, foot, *size)
            if _crossed(box.padded(dots * _APART_PT), others):
                continue
            if _free(box.padded(_AIR_PX), frame, path, taken):
                return _Place(x, y, side, box)
    return None


def _size(axes: Axes, word: str) -> tuple[float, float]:
    text = write(axes, word, 0.0, 0.0, _SIDES[0])
    box = text.get_window_extent()
    text.remove()
    return box.width, box.height


def _free(box: Bbox, frame: Bbox, own: Floats, taken: Sequence[Bbox]) -> bool:
    if box.x0 < frame.x0 or box.x1 > frame.x1 or box.y0 < frame.y0 or box.y1 > frame.y1:
        return False
    return not _crossed(box, own) and not any(box.overlaps(other) for other in taken)


def _crossed(box: Bbox, points: Floats) -> bool:
    x, y = points[:, 0], points[:, 1]
    return bool(((x > box.x0) & (x < box.x1) & (y > box.y0) & (y < box.y1)).any())
