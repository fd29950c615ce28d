"""Statistics are the same to the last bit however many threads BLAS has: `verify` calls others changed."""

import os
import subprocess
import sys

# So many heights that a product of two vectors would be summed in threads (OpenBLAS: more than 10,000).
_MADE = """
import numpy as np
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty
n = 12_000
height = np.random.default_rng(7).normal(1.24, 0.075, n)
shared = SharedErrors(np.zeros(n, np.int64), np.full(n, 0.007))
found = TotalUncertainty(HeightSample(height, np.full(n, 0.012), (shared,)))
print(found.mean(), found.sd(), found.percentile(10.0), found.share_below(1.08))
"""


def test_figures_do_not_hang_on_the_threads_of_blas() -> None:
    told = {
        subprocess.run(
            [sys.executable, "-c", _MADE],
            env={**os.environ, "OPENBLAS_NUM_THREADS": threads, "OMP_NUM_THREADS": threads},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for threads in ("1", "2")
    }
    assert len(told) == 1 and "TotalFigure" in told.pop()
