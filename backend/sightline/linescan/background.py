"""The empty road as one line per camera: first found, then refreshed; and how restless it is.

Pictures are looked at through a coarse grid of bands (rows) and steps (lines), whose means hide the noise.
"""

from dataclasses import dataclass
from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.linescan.parts import USUAL_SHADOW_SHARE, Pixels

Floats = NDArray[np.float32]
ENOUGH_LINES = 100
# a slower camera, such as a video's columns, would wait too long for so many
ENOUGH_S, FEWEST_LINES = 0.3, 12
SIGMAS = 6.0
LEAST_CONTRAST = 0.035
# a road that changes so much from line to line, as a share of its grey, hides what stands out
# by no more: snow, or traffic itself where the recording never shows the road
MOST_UNREST = LEAST_CONTRAST
# a camera that moved shows the same road some rows higher or lower, up to this share of the rows
MOVED_SHARE = 0.02
# by how much its rows follow the old ones then: 0.92 and more in a video of a train whose camera gave way by
# 1.2 px, 0.64 at most where simulated vehicles stood before the road
MOVED_ALIKE = 0.8


@dataclass(frozen=True)
class Grid:
    """Pools `step` lines by `band` rows to one cell; rows left over are not looked at.

    `upper_part`: of rows and bands, the share above the shadow zone, in which vehicles are looked for.
    """

    rows: int
    step: int
    band: int
    upper_part: float = 1.0 - USUAL_SHADOW_SHARE

    @property
    def bands(self) -> int:
        return self.rows // self.band

    def pooled(self, block: Pixels) -> Floats:
        """Cell means (steps, bands) of a `block` (lines, rows); lines left over are not looked at."""
        steps = len(block) // self.step
        cut = cast(Pixels, np.ascontiguousarray(block[: steps * self.step, : self.bands * self.band]))
        if not steps:
            return np.empty((0, self.bands), np.float32)
        if self.band % 2 == 0 and self.step % 2 == 0:
            # halving first is twice as quick as one long mean
            half = (cut.shape[1] // 2, len(cut) // 2)
            cut = cast(Pixels, cv2.resize(cut, half, interpolation=cv2.INTER_AREA))
        small = cv2.resize(cut, (self.bands, steps), interpolation=cv2.INTER_AREA)
        return np.asarray(small, np.float32)


@dataclass(frozen=True, eq=False)
class Road:
    """One camera's empty road: line (rows,), pooled line (bands,), scatter of a cell (bands,) and of a pixel.

    `common_dn`: scatter of whole lines, far above the cells' own where lamps flicker. `unrest`: by what share
    of its grey the road changes from line to line, without that and without the pixels' noise.
    """

    line: Floats
    pooled: Floats
    cell_dn: Floats
    noise_dn: float
    common_dn: float
    unrest: float = 0.0

    @property
    def threshold_dn(self) -> Floats:
        """A cell that differs by more, (bands,), is no road: it follows the noise, and is never too small."""
        floor = LEAST_CONTRAST * float(np.median(self.pooled))
        return np.asarray(np.maximum(SIGMAS * self.cell_dn, floor), np.float32)


def enough_lines(line_rate_hz: float) -> int:
    """Lines that show the empty road: about 100 as in the paper, of a slow camera those of ENOUGH_S."""
    return min(ENOUGH_LINES, max(FEWEST_LINES, round(ENOUGH_S * line_rate_hz)))


def pixel_noise(block: Pixels) -> float:
    """Standard deviation of a pixel of a block (lines, rows), grey values, slow change left out.

    sigma^2 = mean((x0 - 2 x1 + x2)^2) / 6 along the lines: the second difference also hides a slope, and its
    variance is six times a pixel's (Gasser et al. 1986).
    """
    few = block[: min(len(block), 66), :: max(1, block.shape[1] // 256)].astype(np.float32)
    if len(few) < 3:
        return 1.0
    # the second difference also hides a slope; its variance is six times a pixel's
    bend = few[2:] - 2 * few[1:-1] + few[:-2]
    return float(max(np.sqrt(np.mean(bend**2) / 6), 0.3))


def road_from(block: Pixels, grid: Grid) -> Road:
    """The road seen in a block (lines, rows) that holds nothing else.

    Its line is the mean of the lines, as the background of Douxchamps et al., section IV. Own method for its
    unrest: the scatter of the grid's cells, at least their noise / sqrt(pixels of a cell).
    """
    cells = grid.pooled(block)
    line = np.asarray(cv2.reduce(block, 0, cv2.REDUCE_AVG, dtype=cv2.CV_32F), np.float32)[0]
    spread = cells.std(0) if len(cells) > 3 else np.zeros(grid.bands)
    noise = pixel_noise(block)
    # rounding to whole grey values hides part of the noise of a cell
    least = np.hypot(noise / np.sqrt(grid.step * grid.band), 0.35)
    common = float(cells.mean(1).std()) if len(cells) > 3 else 0.0
    pooled = line[: grid.bands * grid.band].reshape(grid.bands, -1).mean(1)
    return Road(
        line=line,
        pooled=pooled,
        cell_dn=np.maximum(spread, least).astype(np.float32),
        noise_dn=noise,
        common_dn=common,
        unrest=_unrest(block, line, grid.upper_part),
    )


def _unrest(block: Pixels, line: Floats, upper_part: float) -> float:
    """By what share of its grey a road, `block` (lines, rows) of the mean `line` (rows,), changes.

    Own method: the covariance of neighbouring rows of the upper part, in which noise drops out, after each
    line's common light was taken off.
    """
    upper = max(2, int(block.shape[1] * upper_part))
    away = block[:, :upper].astype(np.float32) - line[:upper]
    away -= away.mean(axis=1, keepdims=True)
    together = float(np.mean(away[:, 1:] * away[:, :-1]))
    return float(np.sqrt(max(together, 0.0))) / max(float(np.median(line)), 1.0)


def blend_roads(old: Road, new: Road, weight: float) -> Road:
    """The old road moved towards the new one; scatter follows more slowly, upwards as downwards."""
    slow = 0.2 * weight

    def towards(before: Floats, after: Floats, share: float) -> Floats:
        return np.asarray(before + np.float32(share) * (after - before), np.float32)

    return Road(
        line=towards(old.line, new.line, weight),
        pooled=towards(old.pooled, new.pooled, weight),
        cell_dn=towards(old.cell_dn, new.cell_dn, slow),
        noise_dn=old.noise_dn + slow * (new.noise_dn - old.noise_dn),
        common_dn=old.common_dn + slow * (new.common_dn - old.common_dn),
        unrest=old.unrest + slow * (new.unrest - old.unrest),
    )


def first_road(block: Pixels, grid: Grid, window: int = ENOUGH_LINES) -> Road:
    """The road of a recording's first part, a block (lines, rows), in which vehicles may already be passing.

    Of all windows of so many lines, the quietest are taken, and of these the median line: a vehicle is rarely
    as still as the road, and rarely there for most of the time. Own method: quiet is a mean variance of the
    cells of at most 1.6 times the least (Douxchamps et al., section IV, average a bundle of some hundred
    lines).
    """
    size = min(window, len(block))
    starts = range(0, len(block) - size + 1, size)
    windows = [road_from(block[start : start + size], grid) for start in starts]
    unrest = np.array([float(np.mean(window.cell_dn**2)) for window in windows])
    quiet = [window for window, value in zip(windows, unrest, strict=True) if value <= 1.6 * unrest.min()]
    middle = np.median([window.pooled for window in quiet], axis=0)
    away = [float(np.mean(np.abs(window.pooled - middle))) for window in quiet]
    return quiet[int(np.argmin(away))]


def same_but_for_light(seen: Floats, road: Road, grid: Grid) -> bool:
    """Whether a pooled line, `seen` (bands,), is the road under another light: gain and offset explain it.

    Own method: seen = gain road + offset by least squares in three rounds, bands far off left out; the gain
    is 0.4 to 2.5, and 88 % of the upper bands are explained.
    """
    upper = max(1, int(len(seen) * grid.upper_part))
    x, y = road.pooled.astype(float), seen.astype(float)
    design = np.stack([x, np.ones_like(x)], -1)
    for _ in range(3):
        answer = np.linalg.lstsq(design, y, rcond=None)[0]
        away = np.abs(design @ answer - y)
        limit = np.maximum(1.5 * road.threshold_dn, 2.5 * np.median(away))
        weight = np.sqrt(np.where(away < limit, 1.0, 0.0))
        design, y = np.stack([x, np.ones_like(x)], -1) * weight[:, None], seen * weight
    left = np.abs(x * answer[0] + answer[1] - seen)
    return bool(0.4 < answer[0] < 2.5 and np.mean((left < 1.5 * road.threshold_dn)[:upper]) > 0.88)


def same_but_moved(seen: Floats, road: Road, grid: Grid) -> bool:
    """Whether a line, `seen` (rows,), is the road as a camera that moved a little sees it.

    Own method: of the upper rows only those of bands that differ now are compared, for over a vehicle that
    stands the old road is still to be seen. Both lines less their running mean over 8 % of the rows; their
    correlation, at the best shift of up to 2 % of the rows, is that of one and the same road from 0.8 on.
    """
    reach = max(2, round(MOVED_SHARE * grid.rows))
    upper = max(1, int(grid.bands * grid.upper_part))
    pooled = seen[: grid.bands * grid.band].reshape(grid.bands, -1).mean(1)
    differs = np.abs(pooled - road.pooled)[:upper] > road.threshold_dn[:upper]
    row = np.flatnonzero(np.repeat(differs, grid.band))
    row = row[(row >= reach) & (row < grid.rows - reach)]
    if len(row) < 2 * grid.band:
        return False
    wide = max(3, round(0.08 * grid.rows)) | 1
    now, then = (line - cv2.blur(line[:, None], (1, wide))[:, 0] for line in (seen, road.line))
    if not now[row].any() or not np.ptp(now[row]):
        return False
    with np.errstate(invalid="ignore", divide="ignore"):
        alike = [np.corrcoef(then[row + by], now[row])[0, 1] for by in range(-reach, reach + 1)]
    return bool(np.nanmax([*alike, -1.0]) > MOVED_ALIKE)
