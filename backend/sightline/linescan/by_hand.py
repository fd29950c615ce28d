"""A vehicle that a person marked: its pictures cut out, the empty road beside it, its place in strip 2."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.linescan.background import Road, first_road
from sightline.linescan.depth import in_8_bits
from sightline.linescan.finding import SPEEDS_MPS, Finder
from sightline.linescan.parts import Crossings, Passage, Pixels, Rig

Read = Callable[[int, int], Pixels]
BESIDE_S = 1.0
SEARCH_S = 6.0
LEAST_LIKENESS = 0.6


def passage_at(crossings: Crossings, rig: Rig, rows: int, reads: tuple[Read, Read], bits: int = 8) -> Passage:
    """The pictures of a vehicle between these crossings, with a margin and the road as seen beside it.

    reads: for each strip the function that gives its lines start..stop as (n, rows), cut to what there is.
    bits: of the cameras, see `in_8_bits`.
    """
    finder = Finder(rows, rig)
    first_cut = _cut(finder, crossings.front_line_1, crossings.rear_line_1, reads[0])
    second_cut = _cut(finder, crossings.front_line_2, crossings.rear_line_2, reads[1])
    noise_dn = max(first_cut.road.noise_dn, second_cut.road.noise_dn)
    passage = Passage(
        crossings=crossings,
        first=first_cut.picture,
        second=second_cut.picture,
        start_1=first_cut.start,
        start_2=second_cut.start,
        background_1=first_cut.road.line,
        background_2=second_cut.road.line,
        noise_dn=noise_dn,
    )
    return in_8_bits(passage, bits)


@dataclass(frozen=True, eq=False)
class _Cut:
    picture: Pixels
    start: int
    road: Road


def _cut(finder: Finder, front: float, rear: float, read: Read) -> _Cut:
    start = max(0, int(front) - finder.margin)
    picture = read(start, int(rear) + finder.margin + 1)
    return _Cut(picture, start, road_beside(finder, front, rear, read))


def road_beside(finder: Finder, front: float, rear: float, read: Read) -> Road:
    """The empty road of the second before a vehicle and the second after it."""
    lines = max(32, round(BESIDE_S * finder.rig.line_rate_hz))
    away = 2 * finder.margin
    before = read(max(0, int(front) - away - lines), max(0, int(front) - away))
    after = read(int(rear) + away, int(rear) + away + lines)
    beside = cast(Pixels, np.concatenate([before, after]))
    if len(beside) < 8:
        beside = read(max(0, int(front) - 16), int(rear) + 16)
    return first_road(beside, finder.grid, finder.spans.road)


def seen_by_camera_2(
    front_1: float, rear_1: float, rig: Rig, rows: int, reads: tuple[Read, Read]
) -> Crossings:
    """Where a vehicle marked in strip 1 alone crosses camera 2, after or before camera 1, by the likeness of
    both pictures in time.

    Raises LookupError where nothing in strip 2 looks like it.
    """
    finder = Finder(rows, rig)
    pace = finder.baseline_m * rig.line_rate_hz
    nearest = int(pace / SPEEDS_MPS[1])
    farthest = int(min(pace / SPEEDS_MPS[0], SEARCH_S * rig.line_rate_hz)) + 2
    start, stop = max(0, int(front_1)), int(rear_1) + 1
    roads = [road_beside(finder, front_1, rear_1, read) for read in reads]
    first = _unlike(reads[0](start, stop), roads[0], finder)
    candidates = [
        _most_like(first, start, _unlike(reads[1](begin, end), roads[1], finder), begin, finder.grid.step)
        for begin, end in (
            (start + nearest, stop + farthest),
            (max(0, start - farthest), max(0, stop - nearest)),
        )
    ]
    likeness, shift = max(candidates)
    if not likeness >= LEAST_LIKENESS:
        raise LookupError
    return Crossings(front_1, rear_1, front_1 + shift, rear_1 + shift)


def _most_like(
    first: NDArray[np.float32], start: int, second: NDArray[np.float32], begin: int, step: int
) -> tuple[float, int]:
    """How like `first` (steps, bands; from line `start`) the likest part of `second` (from line `begin`) is,
    and the shift to it in lines.
    """
    if len(first) < 4 or len(second) < len(first):
        return -1.0, 0
    likeness = cv2.matchTemplate(second, first, cv2.TM_CCOEFF_NORMED)[:, 0]
    at = int(np.argmax(likeness))
    return float(likeness[at]), begin + at * step - start


def _unlike(picture: Pixels, road: Road, finder: Finder) -> NDArray[np.float32]:
    """How a picture differs from the road, cell by cell (steps, bands)."""
    cells = finder.grid.pooled(picture)
    return np.asarray(np.abs(cells - road.pooled), np.float32)
