"""Whether what comes to rest before one that stands is the same vehicle, which moved on a little.

Own method: two cameras a baseline apart see the same places of one body one after the other, and those of
another body they do not.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from sightline.linescan.background import Grid, Road

Floats = NDArray[np.float32]
# of what a camera saw of one that stands, so many steps are kept: 20 s of motion, 6 MB of 64 bands
MOST_STEPS = 24_000
# two lines of the grid show the same place of a body where so many of its bands are alike: at least 0.95
# where simulated lorries crept on, up to 0.96 by chance where another stopped before them
ALIKE = 0.94
# and another where no more are
GONE = 0.85
# and of what camera 2 shows until then, camera 1 has shown so much before: all of it where textured
# lorries crept on, by chance up to 0.88; by chance two such steps were alike
SEEN_PART, SEEN_ALIKE, FEWEST_CAME = 0.95, 0.88, 5
# both cameras show at once what they showed at once before: by chance up to 0.85
BOTH_ALIKE = 0.9
_FEWEST_BANDS, _FEWEST_STEPS, _LOOKED_AT = 4, 4, 25


@dataclass(eq=False)
class Shown:
    """What a camera showed since something came into view: steps in which the picture changed, and one step
    of each time that it did not.
    """

    _parts: list[tuple[int, bool, Floats]] = field(default_factory=list)

    def add(self, line: int, cells: Floats, road: Road) -> None:
        """The next block's `cells` (steps, bands), which begins at `line`."""
        mean = np.asarray(cells.mean(0), np.float32)
        loose = 2.0 * road.cell_dn + 0.02 * mean
        calm = float(np.mean(cells.std(0) < loose)) > 0.97
        if calm and self._parts and self._parts[-1][1]:
            calm_before = np.abs(self._parts[-1][2][0] - mean) < loose
            if float(np.mean(calm_before)) > 0.97:
                return
        self._parts.append((line, calm, mean[None] if calm else cells))
        while sum(len(part) for _, _, part in self._parts) > MOST_STEPS:
            self._parts.pop(0)

    def forget(self) -> None:
        self._parts.clear()

    def steps(self, start: int, stop: int, step: int) -> tuple[NDArray[np.int64], Floats]:
        """Lines (n,) and cells (n, bands) of the blocks that begin from line `start` to before `stop`."""
        parts = [(line, part) for line, _, part in self._parts if start <= line < stop]
        if not parts:
            return np.zeros(0, np.int64), np.zeros((0, 0), np.float32)
        lines = [line + step * np.arange(len(part)) for line, part in parts]
        return np.concatenate(lines), np.concatenate([part for _, part in parts])


@dataclass(frozen=True, eq=False)
class View:
    """One camera's view of one that stands: the `road` behind it, the pooled lines (bands,) in which it
    `stood` and that rest `now`, and what was `shown`.
    """

    road: Road
    stood: Floats
    now: Floats
    shown: Shown


def share_alike(line: Floats, road: Road, seen: Floats, seen_road: Road, grid: Grid) -> Floats:
    """(n,) which part of the bands of a body, `line` (bands,) before `road`, each of `seen` (n, bands) of
    this camera or the other shows before its own road, under another light and a band higher or lower at
    most; where the body is not, the road has to be
    seen. Own method: each band by the least and the most of its neighbours.
    """
    upper = max(1, int(grid.bands * grid.upper_part))
    body_line, behind, other = line[:upper], road.pooled[:upper], seen_road.pooled[:upper]
    body = np.abs(body_line - behind) > road.threshold_dn[:upper]
    if not len(seen) or body.sum() < _FEWEST_BANDS:
        return np.zeros(len(seen), np.float32)
    padded, near = np.pad(body_line, 1, mode="edge"), np.pad(body, 1)
    around = np.stack([padded[:-2], padded[1:-1], padded[2:]])
    free = ~(near[:-2] | body | near[2:])
    rough = np.maximum(road.threshold_dn[:upper], 0.04 * body_line)[body]
    least, most = around.min(0)[body] - rough, around.max(0)[body] + rough
    shown = seen[:, :upper]
    light = np.clip(np.median(shown[:, body] / np.maximum(body_line[body], 1.0), axis=1), 0.8, 1.25)
    there = shown[:, body] / light[:, None]
    part = ((there > least) & (there < most)).mean(1)
    if free.sum() >= _FEWEST_BANDS:
        ratio = shown[:, free] / np.maximum(other[free], 1.0)
        light = np.clip(np.median(ratio, axis=1), 0.7, 1.3)
        away = np.abs(ratio - light[:, None]) * other[free]
        part = np.minimum(part, (away < 1.5 * seen_road.threshold_dn[:upper][free]).mean(1) + 0.04)
    return np.asarray(part, np.float32)


def has_moved_on(first: View, second: View, since: int, grid: Grid) -> bool:
    """Whether what rests now is what stood; `first`: of the camera that it reached first; `since`: the line
    from which on it stood. Of one that stopped before it neither is so.
    """
    return _follows(first, second, since, grid) or _stood_so_before(first, second, since, grid)


def _follows(first: View, second: View, since: int, grid: Grid) -> bool:
    """Whether the second camera came to show where the body stood before the first, and until then what the
    first had shown before.
    """
    _, cells = second.shown.steps(since, _ALL, grid.step)
    own = share_alike(second.stood, second.road, cells, second.road, grid)
    came = share_alike(first.stood, first.road, cells, second.road, grid) >= ALIKE
    number = np.arange(len(cells))
    was_still, was_gone = (
        np.maximum.accumulate(np.where(so, number, -1)) for so in (own >= ALIKE, own < GONE)
    )
    came_at = np.flatnonzero(came & (was_gone > was_still))
    if len(came_at) < FEWEST_CAME:
        return False
    between = cells[was_still[came_at[0]] + 1 : came_at[0]]
    if len(between) < _FEWEST_STEPS:
        return False
    _, before = first.shown.steps(0, since, grid.step)
    looked_at = between[:: max(1, len(between) // _LOOKED_AT)]
    shown = [share_alike(line, second.road, before, first.road, grid).max(initial=0.0) for line in looked_at]
    return bool(np.mean(np.array(shown) >= SEEN_ALIKE) >= SEEN_PART)


def _stood_so_before(first: View, second: View, since: int, grid: Grid) -> bool:
    """Whether both cameras show at once what they showed at once before."""
    lines, parts = [], []
    for view in (first, second):
        at, cells = view.shown.steps(0, since, grid.step)
        if not len(at):
            return False
        lines.append(at)
        parts.append(share_alike(view.now, view.road, cells, view.road, grid))
    every = np.union1d(*lines)
    at_once = [np.searchsorted(at, every, side="right") - 1 for at in lines]
    both = (at_once[0] >= 0) & (at_once[1] >= 0)
    found = np.minimum(*(part[at] for part, at in zip(parts, at_once, strict=True)))[both]
    return bool(found.max(initial=0.0) >= BOTH_ALIKE)


_ALL = 1 << 62
