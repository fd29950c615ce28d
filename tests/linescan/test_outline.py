"""The foremost point of an outline: greys too faint for one line, notches, greys that change in one band."""

import numpy as np
import pytest
from scipy.stats import norm

from sightline.linescan.boundaries import edge_near
from sightline.linescan.outline import Bands, Edge, Seen, fit_foremost_edge

pytestmark = pytest.mark.once
ROWS, PER_M = 240, 400.0
ROAD = np.linspace(150, 110, ROWS).astype(np.float32)
EDGE = 300.25


def faint_nose(by_dn: float, seed: int) -> np.ndarray:
    """(lines, rows) a round nose, foremost at EDGE in row 120, dark; 40 rows `by_dn` below the road."""
    height_m = (np.arange(ROWS) - 120) * 0.0094
    covered = norm.cdf((np.arange(1, 599)[:, None] - EDGE - 1.4 * height_m**2 * PER_M) / (0.0042 * PER_M))
    body = np.full(ROWS, 60.0)
    body[100:140] = ROAD[100:140] - by_dn
    noise = np.random.default_rng(seed).normal(size=covered.shape)
    scene = ROAD * (1 - covered) + body * covered + 8.0 * noise
    return np.clip(scene + 0.5, 0, 255).astype(np.uint8)


def test_an_end_that_differs_by_as_much_as_the_noise_is_found() -> None:
    """Its edge shows in no 5 lines: at 8 DN what differs by less than 10 is not seen in them."""
    found = [edge_near(faint_nose(8.0, seed), ROAD, EDGE - 1, False, PER_M, 8.0) for seed in range(8)]
    for one in found:
        assert one.line is not None and not one.doubtful
        # what it hides otherwise is 16 lines deep
        assert abs(one.line + 1 - EDGE) < min(2.5 * one.u_lines, 4.0)


def outline(notch: slice, before_dn: float) -> Edge:
    """A round end at line 100 in band 20, whose bands of `notch` show an edge 40 lines farther back."""
    place = np.arange(40)
    edges = 100 + 0.6 * (place - 20.0) ** 2
    differs = np.where(np.arange(300)[:, None] >= edges, 60.0, 0.0)
    differs[:, notch] = np.where(np.arange(300)[:, None] >= edges[notch], before_dn, 0.0)
    edges[notch] += 40
    differs[:, notch][np.arange(300)[:, None] >= edges[notch]] = 60.0
    none = np.zeros(40)
    bands = Bands(edges, np.full(40, 0.3), none, none, np.ones(40, bool))
    return fit_foremost_edge(bands, Seen(differs, 4.0, 1.3, PER_M))


def test_a_notch_hides_an_end_only_where_something_differs_before_it() -> None:
    whole, gap, faint = outline(slice(0, 0), 0.0), outline(slice(17, 24), 0.0), outline(slice(17, 24), 6.0)
    assert whole.line == pytest.approx(100, abs=0.1) and whole.u_lines < 0.5
    assert gap.line is not None and faint.line == gap.line
    assert faint.u_lines > 1.5 * gap.u_lines and abs(faint.line - 100) < 2 * faint.u_lines


def test_one_band_whose_grey_changes_makes_no_flat_end_unsure() -> None:
    none = np.zeros(40)
    uneven = none.copy()
    uneven[12] = 8.0
    edges = np.full(40, 100.0)
    edges[12] = 104.0
    seen = Seen(np.zeros((300, 40)), 4.0, 1.3, PER_M)
    even, changed = (
        fit_foremost_edge(Bands(edges, np.full(40, 0.3), one, none, np.ones(40, bool)), seen)
        for one in (none, uneven)
    )
    assert changed.line == pytest.approx(100.0, abs=0.05)
    assert changed.u_lines < 1.3 * even.u_lines < 0.2
