"""Time and size of figures and report of made-up surveys, small and large: asked and reached.

`python -m tests.bench.bench_report [VEHICLES ...]`. CPU time, for the machine may be shared; what the figures
are drawn from is computed before. The first line holds the loading of Matplotlib and Typst.
"""

from __future__ import annotations

import sys
from pathlib import Path
from time import perf_counter, process_time

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.export.report.sample import statistics
from tests.export.report.sample_facts import facts

LIMIT_S = 3.0


def main(counts: list[int]) -> int:
    for count in counts:
        found = statistics(count)
        cpu, wall = process_time(), perf_counter()
        from sightline.export.report.figures import drawings
        from sightline.export.report.report import report

        drawn = drawings(found)
        figures = process_time() - cpu
        pdf = report(facts(found), drawn)
        cpu, wall = process_time() - cpu, perf_counter() - wall
        missed = "   <-- missed" if cpu > LIMIT_S else ""
        print(
            f"report of {count} vehicles <= {LIMIT_S:g} s: {cpu:.2f} s CPU, {wall:.2f} s, of it "
            f"the figures {figures:.2f} s CPU; {len(pdf) / 1e6:.2f} MB{missed}"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main([int(word) for word in sys.argv[1:]] or [400, 400, 333_333]))
