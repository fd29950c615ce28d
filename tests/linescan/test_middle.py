"""Short cuts that must give what NumPy gives: medians, and means of neighbouring rows and lines."""

import numpy as np
import pytest

from sightline.linescan.masks import pool_picture
from sightline.linescan.middle import median

pytestmark = pytest.mark.once


@pytest.mark.parametrize("shape", [(1,), (2,), (7,), (6, 5), (6, 8)])
def test_the_median_is_numpys(shape):
    values = np.random.default_rng(3).normal(size=shape)
    assert median(values) == pytest.approx(np.median(values, axis=-1, keepdims=True), abs=0)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
@pytest.mark.parametrize(("step", "band"), [(1, 1), (1, 4), (3, 2), (2, 3), (1, 6), (2, 16)])
def test_pooling_is_the_mean_of_the_pixels(dtype, step, band):
    most = np.iinfo(dtype).max + 1
    picture = np.random.default_rng(4).integers(0, most, (31, 97), dtype)
    sheet = pool_picture(picture, 100, step, band, (1e-3, 1e-3))
    lines, rows = 31 // step, 97 // band
    means = picture[: lines * step, : rows * band].reshape(lines, step, rows, band).mean((1, 3))
    assert sheet.values == pytest.approx(means, rel=1e-5)
    assert sheet.start_line == 100 + (step - 1) / 2
