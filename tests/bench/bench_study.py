"""A study of many packages from Parquet alone: `python tests/bench/bench_study.py [PACKAGES [HEIGHTS]]`.

Invented packages are written once (1,000 with 1e7 heights), then `sightline study --quick` runs in a process
of its own: files held against the seals, error table, percentiles, mean and SD of three targets with total
intervals, class shares, plan. Goals: 30 s and 2 GB on two cores.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.support.studies import TARGETS, Invented, invent

_S, _GB = 30.0, 2.0


def main(packages: int, heights: int) -> int:
    each = heights // packages // len(TARGETS)
    with tempfile.TemporaryDirectory(prefix="sightline-bench-study-") as folder:
        place = Path(folder)
        begun = time.perf_counter()
        for n in range(packages):
            survey = Invented(f"survey {n}", f"site {n // 2}", each, moved_m=0.01 * ((n // 2) % 7 - 3) / 3)
            invent(place / "packages" / f"site={n // 2}" / f"date={n % 2}", survey, n, with_csv=False)
        print(f"written {packages} packages of {3 * each} heights in {time.perf_counter() - begun:.0f} s")
        fleet = place / "fleet.csv"
        fleet.write_text("category,share\nhatchback,0.5\nsuv,0.4\nvan,0.1\n")
        command = [sys.executable, "-m", "sightline.cli", "study", str(place / "packages")]
        command += ["-o", str(place / "study"), "--quick", "--json", "--weights", str(fleet)]
        begun = time.perf_counter()
        done = subprocess.run(command, capture_output=True, env=os.environ, check=False)
        took = time.perf_counter() - begun
        if done.returncode:
            print(done.stderr.decode())
            return 1
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        told = json.loads(done.stdout)
        gb = used.ru_maxrss / 1e6
        spent = used.ru_utime + used.ru_stime
        print(f"{told['heights']} heights: {took:.1f} s (goal {_S:.0f}), {spent:.1f} s of processor,")
        print(f"{gb:.2f} GB at most (goal {_GB:.0f})")
        for row in told["figures"][:3]:
            print(row)
        return int(took > _S or gb > _GB)


if __name__ == "__main__":
    numbers = [int(float(one)) for one in sys.argv[1:]]
    sys.exit(main(*(numbers + [1_000, 10_000_000][len(numbers) :])))
