"""Whether live lines are kept up with: `python tests/bench/bench_stream.py [ROWS LINE_RATE_HZ VEHICLES]`.

Drawn traffic of both cameras goes through `sightline stream`, in a process of its own, as fast as it takes
it. Printed are the processor time as a share of the traffic's own (below 1: one core keeps up) and memory.
"""

from __future__ import annotations

import json
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.simulation.scan_strips import strips
from sightline.simulation.scan_traffic import ScanSite, traffic

ROUNDS = 3


def main(rows: int, line_rate_hz: float, vehicles: int) -> int:
    site = ScanSite(rows=rows, line_rate_hz=line_rate_hz)
    pair = strips(site, traffic(11, vehicles, speeds_mps=(14.0, 30.0), gaps_s=(0.6, 2.0), start_s=1.2))
    data = np.stack(pair, axis=1).astype(np.uint8)
    seconds = ROUNDS * len(data) / line_rate_hz
    command = [sys.executable, "-m", "sightline.cli", "stream", "--rows", str(rows)]
    command += ["--baseline", str(site.baseline_m), "--line-rate", str(line_rate_hz)]
    with tempfile.TemporaryFile() as out:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=out) as live:
            assert live.stdin is not None
            for _ in range(ROUNDS):
                live.stdin.write(data)
            most_kib = re.search(r"VmHWM:\s+(\d+)", Path(f"/proc/{live.pid}/status").read_text())
        out.seek(0)
        told = [json.loads(line) for line in out]
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = spent.ru_utime + spent.ru_stime
    ok = sum(one["status"] == "ok" for one in told)
    lines = f"{seconds:.0f} s of 2 x {line_rate_hz:g} lines/s of {rows} rows"
    print(f"{lines}: {ok} of {len(told)} vehicles measured")
    print(f"  processor time per second of traffic <= 1: {used / seconds:.2f}")
    if most_kib:
        print(f"  most memory <= 400 MiB: {int(most_kib[1]) / 1024:.0f} MiB")
    return 0


if __name__ == "__main__":
    given = [float(word) for word in sys.argv[1:]] or [1024, 5000, 12]
    sys.exit(main(int(given[0]), given[1], int(given[2])))
