"""Boundaries to a fraction of a line: light that drifts, greys that change behind an edge, noise."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d
from scipy.stats import norm

from sightline.linescan.boundaries import _band_edges, _box, edge_near, left_between_lines
from sightline.linescan.outline import Bands, Seen, fit_foremost_edge

pytestmark = pytest.mark.once
ROWS, PER_M = 240, 400.0
ROAD = np.linspace(150, 110, ROWS).astype(np.float32)
EDGE = 300.25


def picture(
    *,
    rear: bool = False,
    light: float = 1.0,
    slope_dn_per_m: float = 0.0,
    noise_dn: float = 1.0,
    seed: int = 1,
) -> np.ndarray:
    """(lines, rows) a flat dark end at EDGE before a road that became `light` times as bright."""
    fine = np.arange(0, 600, 0.05)
    inside = (fine < EDGE) if rear else (fine >= EDGE)
    depth_m = np.abs(fine - EDGE) / PER_M
    body = 60 + slope_dn_per_m * np.minimum(depth_m, 0.1)
    values = np.where(inside[:, None], body[:, None], light * ROAD[None, ::8].astype(float))
    blurred = gaussian_filter1d(values, 0.004 * PER_M / 0.05, axis=0, mode="nearest")
    # a line's exposure runs half a line to either side of its number
    lines = blurred[10:-10].reshape(-1, 20, values.shape[1]).mean(axis=1)
    noise = np.random.default_rng(seed).normal(size=(len(lines), ROWS))
    scene = np.repeat(lines, 8, axis=1) + noise_dn * noise
    return np.clip(scene + 0.5, 0, 255).astype(np.uint8)


def found(strip: np.ndarray, rear: bool = False, noise_dn: float = 1.0):
    """The edge; row 0 of `strip` is line 1."""
    return edge_near(strip, ROAD, EDGE - 1, rear, PER_M, noise_dn)


@pytest.mark.parametrize("rear", [False, True])
@pytest.mark.parametrize("light", [0.94, 1.0, 1.06])
def test_light_that_changed_since_the_road_was_seen_moves_no_boundary(rear: bool, light: float) -> None:
    edge = found(picture(rear=rear, light=light), rear)
    assert edge.line is not None and not edge.doubtful
    assert edge.line + 1 == pytest.approx(EDGE, abs=0.5)
    assert edge.u_lines < 0.4


def test_greys_that_change_behind_the_edge_make_it_less_sure_by_what_they_move_it() -> None:
    even, uneven = found(picture()), found(picture(slope_dn_per_m=900.0))
    assert even.line is not None and uneven.line is not None
    moved = abs(uneven.line - even.line)
    assert 0.2 < moved < 3 * uneven.u_lines and even.u_lines < uneven.u_lines / 2


def test_u_follows_the_noise() -> None:
    errors, told = [], []
    for seed in range(10):
        edge = found(picture(noise_dn=8.0, seed=seed), noise_dn=8.0)
        assert edge.line is not None
        errors.append(edge.line + 1 - EDGE)
        told.append(edge.u_lines)
    z = np.array(errors) / np.array(told)
    assert 0.3 < np.sqrt(np.mean(z**2)) < 1.6 and np.mean(told) > found(picture()).u_lines


def test_a_flat_end_is_not_found_where_noise_is_foremost() -> None:
    """The vertex of a parabola through noise would lie 0.17 lines too far out."""
    edges = [found(picture(noise_dn=8.0, seed=seed), noise_dn=8.0) for seed in range(10)]
    assert abs(np.mean([one.line for one in edges]) + 1 - EDGE) < 0.08


def nose(hidden: slice, noise_dn: float, seed: int) -> np.ndarray:
    """(lines, rows) a round dark nose, foremost at EDGE in row 120; `hidden` rows have the road's grey."""
    height_m = (np.arange(ROWS) - 120) * 0.0094
    edge = EDGE + 1.4 * height_m**2 * PER_M
    covered = norm.cdf((np.arange(1, 599)[:, None] - edge) / (0.0042 * PER_M))
    body = np.full(ROWS, 60.0)
    body[hidden] = ROAD[hidden]
    noise = np.random.default_rng(seed).normal(size=covered.shape)
    scene = ROAD * (1 - covered) + body * covered + noise_dn * noise
    return np.clip(scene + 0.5, 0, 255).astype(np.uint8)


@pytest.mark.parametrize("noise_dn", [1.0, 8.0])
def test_rows_of_the_roads_own_grey_make_a_round_end_less_sure_by_what_they_hide(noise_dn: float) -> None:
    whole = [found(nose(slice(0, 0), noise_dn, seed), noise_dn=noise_dn) for seed in range(5)]
    hidden = [found(nose(slice(112, 124), noise_dn, seed), noise_dn=noise_dn) for seed in range(5)]
    for edges, most in ((whole, 0.3 if noise_dn < 2 else 0.4), (hidden, 1.5)):
        for one in edges:
            assert one.line is not None and one.u_lines < most
            assert abs(one.line + 1 - EDGE) < 2 * one.u_lines
    assert min(one.u_lines for one in hidden) > 2 * max(one.u_lines for one in whole)


def interpolated(optics_lines: float) -> tuple[float, float]:
    """What interpolation leaves of a step blurred so much, root mean square over where in a line it lies, and
    by which share it rises from line to line there: integrals of a Gaussian's distribution over each line.
    """
    errors, rises = [], []
    lines = np.arange(-8, 9)
    for edge in np.linspace(-0.5, 0.5, 100, endpoint=False):
        below, above = ((lines + half - edge) / optics_lines for half in (-0.5, 0.5))
        area = [optics_lines * (x * norm.cdf(x) + norm.pdf(x)) for x in (below, above)]
        seen = area[1] - area[0]
        last = int(np.flatnonzero(seen < 0.5)[-1])
        rise = seen[last + 1] - seen[last]
        errors.append(lines[last] + (0.5 - seen[last]) / rise - edge)
        rises.append(rise)
    return float(np.std(errors)), float(np.mean(rises))


@pytest.mark.parametrize("optics_lines", [0.02, 0.3, 0.5, 0.8, 1.3])
def test_less_is_left_between_lines_of_an_edge_that_rises_over_several(optics_lines: float) -> None:
    left, rise = interpolated(optics_lines)
    assert left_between_lines(rise) == pytest.approx(left, rel=0.1)


def test_a_blurred_edge_says_what_is_left_between_its_lines() -> None:
    """The picture's optics are 1.6 lines, means over 3 lines widen them: less than a hundredth is left."""
    assert 0 < found(picture()).u_between_lines < 0.01


@pytest.mark.parametrize("size", [1, 3, 7])
def test_u_of_a_bands_edge_is_the_scatter_that_noise_gives_it(size: int) -> None:
    """Over 4000 bands of the same edge, noise of 3 per line; the optics are 1.2 lines."""
    lines = np.arange(120)[:, None]
    noise = np.random.default_rng(size).normal(0.0, 3.0, (120, 4000))
    smooth = _box(80 * norm.cdf((lines - 60.3) / 1.2) + noise, size)
    (edges, u, _, clear), _ = _band_edges(smooth, (3.0 / np.sqrt(size), 3.0), (2.0, 3.0), 300.0, size)
    # means repeat the first line, whose noise may pass for an edge
    assert clear.mean() > 0.98
    assert float(np.sqrt(np.mean(u[clear] ** 2))) == pytest.approx(float(np.std(edges[clear])), rel=0.12)


@pytest.mark.parametrize("bend", [1.0, 3.0])
def test_a_round_end_is_found_whether_it_is_a_parabola_or_flat_about_its_foremost_point(bend: float) -> None:
    """A parabola through all bands would lie 0.4 to 0.8 times the bend before the last two."""
    place, none = np.arange(40) - 20.0, np.zeros(40)
    # a band shows its rows' mean
    of_rows = place[:, None] + np.linspace(-0.45, 0.45, 10)
    for shape in (of_rows**2, np.maximum(np.abs(of_rows) - 1, 0) ** 2, of_rows**4 / 9.6):
        bands = Bands(100 + bend * shape.mean(axis=1), np.full(40, 0.1), none, none, np.ones(40, bool))
        end = fit_foremost_edge(bands, Seen(np.zeros((300, 40)), 4.0, 1.3, PER_M))
        assert end.line is not None and abs(end.line - 100) < min(0.15 * bend, 2 * end.u_lines)
