"""How often U95 of an end holds on outlines whose true end is known, shape by shape.

300 lines/m, bands of 47 mm. The foremost point is line 100; what no band shows lies FAR behind it.
"""

from collections.abc import Callable
from math import hypot

import numpy as np
import pytest

from sightline.linescan.boundaries import BUMPY_M
from sightline.linescan.outline import DOUBT_M, Bands, Seen, fit_foremost_edge
from tests.bench.goals import rms
from tests.simulation.camera import Array
from tests.support.proofs import every

pytestmark = pytest.mark.once
PER_M, COUNT, END, FAR = 300.0, 44, 100.0, 60.0
place = np.arange(COUNT, dtype=float)
# lines: standard deviations by greys, of bands of an even grey, and median of those of greys that change.
# Neighbours' greys are alike: correlations of 0.56 and 0.10 (photographs: 0.3 and 0.15 with the noise).
EVEN, STRAYING = 0.1, 0.3
# lines: what bands stray by without noise, a tenth of a millimetre
BUMPS = 0.03
ALIKE = np.array([0.35, 1.0, 0.35]) / np.sqrt(1.0 + 2 * 0.35**2)
DRAWS = 200

Shape = Callable[[np.random.Generator], Array]


def upright(rng: np.random.Generator) -> Array:
    """20 to 30 bands, and nothing beside them."""
    first = rng.integers(3, 10)
    return np.where((place >= first) & (place < first + rng.integers(20, 31)), 0.0, FAR)


def corner(rng: np.random.Generator) -> Array:
    """8 to 14 upright bands, above which it falls back by 3 to 13 mm a band."""
    first = rng.integers(15, 25)
    fall = rng.uniform(1.0, 4.0) * np.maximum(first - place - rng.uniform(), 0.0)
    return np.where(place < first + rng.integers(8, 15), fall, FAR)


def round_end(rng: np.random.Generator) -> Array:
    """A parabola that falls back by 0.5 to 3 mm at one band."""
    return np.asarray(rng.uniform(0.15, 0.9) * (place - rng.uniform(12, 30)) ** 2)


def flat_topped(rng: np.random.Generator) -> Array:
    """Flat over 1 to 3 bands, beside which it falls back as a parabola does: by 1 to 5 mm at one band."""
    fall = np.maximum(np.abs(place - rng.uniform(12, 30)) - rng.uniform(0.5, 1.5), 0.0)
    return np.asarray(rng.uniform(0.3, 1.5) * fall**2)


def lopsided(rng: np.random.Generator, powers: tuple[float, float] = (1.25, 2.0)) -> Array:
    """Falls back above otherwise than below: by 3 to 40 mm over 3 bands, as a power of the way, of which a
    band shows the mean of its rows.
    """
    power, foremost = rng.uniform(*powers), rng.uniform(12, 30)
    rows = place[:, None] + np.linspace(-0.475, 0.475, 20) - foremost
    above, below = np.exp(rng.uniform(np.log(1.0), np.log(12.0), 2)) / 3**power
    return np.asarray((np.where(rows < 0, above, below) * np.abs(rows) ** power).mean(axis=1))


def pointed(rng: np.random.Generator) -> Array:
    """Falls back straight from a point, above otherwise than below."""
    return lopsided(rng, (1.0, 1.0))


def round_bumper(rng: np.random.Generator) -> Array:
    """A parabola over 11 bands, 5 to 11 mm before 15 to 20 bands of an upright grille above it."""
    foremost, before = rng.uniform(24, 32), rng.uniform(1.5, 3.3)
    bumper = before * ((place - foremost) / 5.5) ** 2
    top = foremost - 5.5 - rng.integers(15, 21)
    grille = np.where((place > top) & (place < foremost), before, FAR)
    return np.where(np.abs(place - foremost) <= 5.5, bumper, grille)


def small_flat(rng: np.random.Generator) -> Array:
    """4 to 8 bands, 3 to 7 cm before what is beside them."""
    first = rng.integers(8, 25)
    flat = (place >= first) & (place < first + rng.integers(4, 9))
    return np.where(flat, 0.0, rng.uniform(10.0, 20.0))


def slanted(rng: np.random.Generator) -> Array:
    """A straight line that falls back by 1 to 5 mm a band upwards, and nothing below it."""
    lowest = rng.integers(28, 40)
    return np.where(place <= lowest, rng.uniform(0.3, 1.5) * (lowest + 0.5 - place), FAR)


def shown(shape: Shape, noise: float, straying: bool, rng: np.random.Generator) -> tuple[Bands, Seen]:
    """Its bands with `noise`, lines, the bumps of its shape, and with greys that change, each by what it says
    of itself.
    """
    true = END + np.minimum(shape(rng), FAR)
    uneven = STRAYING * rng.lognormal(0.0, 1.0, COUNT) if straying else np.full(COUNT, EVEN)
    greys = np.convolve(rng.normal(size=COUNT + 2), ALIKE, "valid")
    bumps = BUMPY_M * PER_M
    edges = true + hypot(noise, BUMPS) * rng.normal(size=COUNT) + uneven * greys
    differs = np.where(np.arange(300)[:, None] >= edges, 60.0, 0.0)
    u, clear = np.full(COUNT, hypot(noise, bumps)), np.ones(COUNT, bool)
    bands = Bands(edges, u, uneven, np.zeros(COUNT), clear, bumps)
    return bands, Seen(differs, 4.0, 1.3, PER_M)


def held(shape: Shape, noise: float, straying: bool) -> tuple[float, float]:
    """Share of U95 that hold the end, and rms of its error over its u."""
    z = list[float]()
    for number in range(DRAWS):
        end = fit_foremost_edge(*shown(shape, noise, straying, np.random.default_rng((34, number))))
        assert end.line is not None
        u = hypot(end.u_lines, DOUBT_M * PER_M * end.doubtful)
        z.append((END - end.line) / u)
    share = float(np.mean(np.abs(z) <= 1.96))
    return share, rms(np.array(z))


SEEN = [(noise, straying) for straying in (False, True) for noise in (0.2, 0.5)]


@pytest.mark.parametrize(
    "case",
    [
        (round_bumper, 0.2, False),
        (round_bumper, 0.5, False),
        *every(
            4,
            [
                (shape, *how)
                for shape in (upright, corner, round_end, lopsided, flat_topped, small_flat, slanted)
                for how in SEEN[::-1]
            ],
        ),
    ],
)
def test_u95_of_an_end_holds(case: tuple[Shape, float, bool]) -> None:
    share, over_u = held(*case)
    assert share >= 0.93 and over_u <= 1.1


@pytest.mark.parametrize(
    "case", every(6, [(round_bumper, *how) for how in SEEN[2:]] + [(pointed, *how) for how in SEEN])
)
def test_u95_of_a_bumper_that_greys_hide_or_of_a_point_holds_less_often(
    case: tuple[Shape, float, bool],
) -> None:
    """Not mended: by greys that stray a bumper 5 mm before a grille may look upright; and of the shapes over
    which a round end is averaged, one that falls back straight is the foremost.
    """
    assert held(*case)[0] >= (0.92 if case[0] is round_bumper else 0.83)
