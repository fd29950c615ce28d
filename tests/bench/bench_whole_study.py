"""A study of 650 vehicles by the API: `python tests/bench/bench_whole_study.py [DAYTIME [LOW_LIGHT]]`.

`tests/studies/test_whole_study.py` at the size of Dupuis et al.: 400 vehicles by day and 250 in low light,
each marked, clicked on, judged, held against its true height; statistics, error table, packages, verified.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def main(daytime: int, low_light: int) -> int:
    env = {
        **os.environ,
        "SIGHTLINE_STUDY_VEHICLES": f"{daytime},{low_light}",
        "SIGHTLINE_TEST_DATABASE_URL": "",
    }
    command = [sys.executable, "-m", "pytest", "-q", "-s", "-p", "no:cacheprovider"]
    begun = time.perf_counter()
    done = subprocess.run([*command, "tests/studies/test_whole_study.py"], cwd=ROOT, env=env, check=False)
    print(f"{daytime + low_light} vehicles from the first request to two verified packages: ", end="")
    print(f"{time.perf_counter() - begun:.0f} s")
    return done.returncode


if __name__ == "__main__":
    numbers = [int(one) for one in sys.argv[1:]]
    sys.exit(main(*(numbers + [400, 250][len(numbers) :])))
