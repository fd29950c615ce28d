"""Boundaries to a fraction of a line: light that drifts, greys that change behind an edge, noise."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d
from scipy.stats import norm

from sightline.linescan.boundaries import edge_near

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
    for edges, most in ((whole, 0.3), (hidden, 1.5)):
        for one in edges:
            assert one.line is not None and one.u_lines < most
            assert abs(one.line + 1 - EDGE) < 2 * one.u_lines
    assert min(one.u_lines for one in hidden) > 3 * max(one.u_lines for one in whole)
