"""Statistics are the same however many threads BLAS has: sums over heights to the last bit, what rests on a
fitted density far within what `verify` calls changed (1.1e-6).
"""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

# So many heights that a product of two vectors would be summed in threads (OpenBLAS: more than 10,000).
_MADE = """
import json
import numpy as np
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty
n = 12_000
height = np.random.default_rng(7).normal(1.24, 0.075, n)
shared = SharedErrors(np.zeros(n, np.int64), np.full(n, 0.007))
found = TotalUncertainty(HeightSample(height, np.full(n, 0.012), (shared,)))
fitted = [found.percentile(10.0), found.share_below(1.08)]
for figures in ([found.mean(), found.sd()], fitted):
    print(json.dumps([(one.value, one.U95_low, one.U95_high) for one in figures]))
"""


def test_figures_do_not_hang_on_the_threads_of_blas() -> None:
    sums, fitted = zip(*map(figures_with, ("1", "2")), strict=True)
    assert sums[0] == sums[1]
    assert np.array(fitted[1]) == pytest.approx(np.array(fitted[0]), rel=1e-8)


def figures_with(threads: str) -> list[list[list[float]]]:
    told = subprocess.run(
        [sys.executable, "-c", _MADE],
        env={**os.environ, "OPENBLAS_NUM_THREADS": threads, "OMP_NUM_THREADS": threads},
        capture_output=True,
        text=True,
        check=True,
    )
    return [json.loads(line) for line in told.stdout.splitlines()]
