"""Which pixels of strip 1 tell the motion: clear changes along time, inside the vehicle, spread over it."""

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.linescan.parts import Pixels

Floats = NDArray[np.float32]
ROWS = 256
# beyond so many rows a spline that is 1 in one place has fallen below 1e-6
_REACH_ROWS = 12


@dataclass(frozen=True, eq=False)
class Sheet:
    """A picture pooled for matching: values (n, rows), softened; `step` lines by `band` rows a value.

    `start_line`: strip line at the centre of row 0 of `values`.
    """

    values: Floats
    start_line: float
    step: int
    band: int

    @cached_property
    def splines(self) -> Floats:
        """(n, rows) weights of the cubic B-splines along time that pass through the values."""
        return np.asarray(
            scipy.ndimage.spline_filter1d(self.values, order=3, axis=0, output=np.float32, mode="mirror")
        )

    def place(self, line: NDArray[np.float64]) -> NDArray[np.float64]:
        """Places in `values`, of the same shape, of strip lines, `line` of any shape."""
        return np.asarray((line - self.start_line) / self.step)

    def line(self, place: NDArray[np.float64]) -> NDArray[np.float64]:
        """Strip lines, of the same shape, of places in `values`, `place` of any shape."""
        return np.asarray(self.start_line + place * self.step)


def softness(noise_dn: float) -> tuple[float, float]:
    """Standard deviations (samples, rows) of the softening before matching: wider where noise is high."""
    return float(np.clip(0.25 * noise_dn, 0.7, 1.4)), float(np.clip(0.35 * noise_dn, 1.0, 2.2))


def softened_noise(noise_dn: float) -> float:
    """What softening leaves of a pixel's noise: a Gaussian of s samples averages 2 s sqrt(pi) of them."""
    along, across = softness(noise_dn)
    return noise_dn / float(np.sqrt(4 * np.pi * along * across))


def pool_picture(picture: Pixels, start: int, step: int, band: int, soft: tuple[float, float]) -> Sheet:
    """Means over step x band pixels of a `picture` (lines, rows) that begins at line `start`, then softened.

    Softening keeps the error of interpolating between coarse samples small; both strips get the same. Own
    method: a Gaussian of standard deviations `soft` (lines, rows of the sheet), cut off at three of them.
    """
    lines, rows = len(picture) // step * step, picture.shape[1] // band * band
    means = _means_of_rows(np.ascontiguousarray(picture[:lines, :rows]), band)
    if step > 1:
        means = _means_of_lines(means, step)
    size = (2 * round(3 * soft[1]) + 1, 2 * round(3 * soft[0]) + 1)
    values = cv2.GaussianBlur(means, size, sigmaX=soft[1], sigmaY=soft[0])
    return Sheet(np.asarray(values, np.float32), start + (step - 1) / 2, step, band)


def _means_of_rows(picture: NDArray[np.unsignedinteger], band: int) -> Floats:
    """(lines, rows / band) means of `band` neighbours, not rounded.

    Two neighbours of n bits are one number of 2 n bits: halves added so are ten times as fast as a mean.
    """
    left, sums = band, picture
    while left % 2 == 0 and sums.itemsize < 8:
        bits = 8 * sums.itemsize
        both = sums.view(np.dtype(f"u{2 * sums.itemsize}"))
        sums, left = (both & ((1 << bits) - 1)) + (both >> bits), left // 2
    means = sums.astype(np.float32)
    if band > 1:
        means *= np.float32(left / band)
    if left > 1:
        size = (picture.shape[1] // band, len(picture))
        means = np.asarray(cv2.resize(means, size, interpolation=cv2.INTER_AREA), np.float32)
    return means


def _means_of_lines(values: Floats, times: int) -> Floats:
    """(n // times, rows) means of `times` neighbouring lines; lines left over are left out."""
    count = len(values) // times
    return np.asarray(values[: count * times].reshape(count, times, -1).mean(axis=1), np.float32)


def coarsen_sheet(sheet: Sheet, times: int) -> Sheet:
    """The same, `times` lines pooled to one."""
    small = _means_of_lines(sheet.values, times)
    start = sheet.start_line + (times - 1) / 2 * sheet.step
    values = cv2.GaussianBlur(small, (0, 0), sigmaX=0.01, sigmaY=0.8)
    return Sheet(np.asarray(values, np.float32), start, sheet.step * times, sheet.band)


def silhouette(sheet: Sheet, road: NDArray[np.float32], noise_dn: float) -> NDArray[np.bool_]:
    """(n, rows) whether a pixel of the sheet lies well inside the vehicle: from its upper edge down, the rim
    left out.

    `road` (R,): the empty road's line, grey values of the strip's R rows. Own method: a pixel is there where
    it differs from the road by four standard deviations of the softened noise and by 4 % of the road's grey.
    """
    line = road[: sheet.values.shape[1] * sheet.band].reshape(sheet.values.shape[1], sheet.band).mean(1)
    away = np.abs(sheet.values - line)
    limit = max(4 * noise_dn / np.sqrt(sheet.step * sheet.band * 5), 0.04 * float(np.median(line)))
    there = (away > limit).astype(np.uint8)
    there = cv2.morphologyEx(there, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    # from the first row that differs down; where none does, from below the last
    top = np.where(there.any(axis=1), there.argmax(axis=1), there.shape[1])
    filled = (np.arange(there.shape[1]) >= top[:, None]).astype(np.uint8)
    return np.asarray(cv2.erode(filled, np.ones((7, 5), np.uint8)) > 0)


@dataclass(frozen=True, eq=False)
class Points:
    """Chosen pixels (n,): place along time and row in the sheet, value, change along time and across."""

    place: NDArray[np.float64]
    row: NDArray[np.float64]
    value: NDArray[np.float64]
    along: NDArray[np.float64]
    across: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.place)

    def every(self, nth: int) -> "Points":
        """Each nth of them."""
        parts = (self.place, self.row, self.value, self.along, self.across)
        return Points(*(part[::nth] for part in parts))


def choose_points(sheet: Sheet, inside: NDArray[np.bool_], most: int, noise_dn: float) -> Points:
    """The `most` pixels with the clearest change along time, every part of the vehicle getting its share;
    `inside` (n, rows): the silhouette.

    noise_dn: of a pixel of the sheet before softening. Own method: half of them by |dI/dline|, the other half
    spread evenly over what is left; in the place of the Moravec gate of Douxchamps et al., section IV.
    """
    values = sheet.values
    along = np.zeros_like(values)
    np.subtract(values[2:], values[:-2], out=along[1:-1])
    along *= 0.5
    least = max(2.0 * softened_noise(noise_dn), 0.4)
    good = inside & (np.abs(along) > least)
    good[:3], good[-3:] = False, False
    good[:, :2], good[:, -2:] = False, False
    where = np.flatnonzero(good)
    if len(where) > most:
        strength = np.abs(along.ravel()[where])
        # the clearest half outright, the other half spread evenly over what is left
        order = np.argpartition(-strength, most // 2)
        rest = order[most // 2 :]
        where = where[np.concatenate([order[: most // 2], rest[:: max(1, len(rest) // (most // 2))]])]
    return points_at(sheet, *np.unravel_index(where, good.shape))


def points_at(sheet: Sheet, place: NDArray[np.generic], row: NDArray[np.generic]) -> Points:
    """The pixels at these places and rows, `place` and `row` (n,), rounded down, away from the rim;
    derivatives are central differences, grey values per pixel of the sheet.
    """
    values = sheet.values
    n = np.clip(place.astype(np.intp), 1, len(values) - 2)
    r = np.clip(row.astype(np.intp), 1, values.shape[1] - 2)
    return Points(
        n.astype(float),
        r.astype(float),
        values[n, r].astype(float),
        (values[n + 1, r] - values[n - 1, r]).astype(float) / 2,
        (values[n, r + 1] - values[n, r - 1]).astype(float) / 2,
    )


def sample_sheet(sheet: Sheet, place: NDArray[np.float64], row: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (n,) of a sheet between its lines at `place` (n,), at whole rows `row` (n,); the rim's outside.

    Cubic B-splines (Unser 1999). With cubic convolution (Keys 1981) a fast vehicle's speed was off by 0.011 %
    where nothing but the lines' spacing was at fault, alike all along it, so that no scatter told of it; by
    0.002 % with splines, and no less with those of the fifth degree. OpenCV's remap rounds places to 1/32 of
    a pixel.
    """
    lines, rows = sheet.values.shape
    place = np.clip(place, 1, lines - 2.001)
    at = place.astype(np.intp)
    flat = sheet.splines.ravel()
    base = (at - 1) * rows + row.astype(np.intp)
    # in 64 bits: differences of close looks (`spread`) would show how 32 round
    total = np.zeros(len(place))
    for by_line in _b_spline(place - at):
        total += by_line * flat.take(base)
        base += rows
    return total


def shift_sheet(sheet: Sheet, shift: float) -> Sheet:
    """The sheet whose row r shows what this one has at row r + shift: cubic splines, the rim repeated."""
    if shift == 0.0:
        return sheet
    kernel = _shift_kernel(shift)
    values = cv2.filter2D(sheet.values, -1, kernel[None], borderType=cv2.BORDER_REPLICATE)
    return Sheet(np.asarray(values, np.float32), sheet.start_line, sheet.step, sheet.band)


def _b_spline(part: NDArray[np.floating]) -> tuple[NDArray[np.floating], ...]:
    """The cubic B-spline's four weights for fractions in 0..1."""
    t, rest = part, 1 - part
    t2, rest2 = t * t, rest * rest
    return (
        rest2 * rest / 6,
        (3 * t2 * t - 6 * t2 + 4) / 6,
        (3 * rest2 * rest - 6 * rest2 + 4) / 6,
        t2 * t / 6,
    )


def _shift_kernel(shift: float) -> Floats:
    """Weights of a filter: the spline that is 1 in the middle and 0 elsewhere, read `shift` rows on."""
    whole = int(np.floor(shift))
    half = abs(whole) + _REACH_ROWS
    single = np.zeros(2 * half + 1)
    single[half] = 1.0
    splines = np.asarray(scipy.ndimage.spline_filter1d(single, order=3, mode="mirror"))
    weights = _b_spline(np.array(shift - whole, np.float32))
    # what filter2D sums at row r is kernel[k] of row r + k - half
    kernel = np.zeros(2 * half + 1, np.float32)
    for place, weight in zip(range(whole - 1, whole + 3), weights, strict=True):
        kernel += np.float32(weight) * np.roll(splines, place).astype(np.float32)
    return kernel
