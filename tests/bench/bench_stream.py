"""Whether live lines are kept up with: `python tests/bench/bench_stream.py [ROWS RATE_HZ VEHICLES SECONDS]`.

Drawn traffic of both cameras goes through `sightline stream --spool`, in a process of its own: first as fast
as it takes it (processor time as a share of the traffic's own: below 1, one core keeps up; most memory), for
SECONDS of traffic; then at the cameras' own pace. Printed then are how long after its rear left camera 2 each
vehicle was told, and how long a sender that cannot wait would have had to.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, traffic

PACE_S = 0.02


def main(rows: int, line_rate_hz: float, vehicles: int, seconds: float) -> int:
    site = ScanSite(rows=rows, line_rate_hz=line_rate_hz)
    pair = strips(site, traffic(11, vehicles, speeds_mps=(14.0, 30.0), gaps_s=(0.6, 2.0), start_s=1.2))
    data = np.stack(pair, axis=1).astype(np.uint8)
    command = [sys.executable, "-m", "sightline.cli", "stream", "--rows", str(rows)]
    command += ["--baseline", str(site.baseline_m), "--line-rate", str(line_rate_hz)]
    print(f"2 x {line_rate_hz:g} lines/s of {rows} rows")
    as_fast_as_it_takes(command, data, max(1, round(seconds * line_rate_hz / len(data))), line_rate_hz)
    at_their_pace(command, data, line_rate_hz)
    return 0


def as_fast_as_it_takes(command: list[str], data: np.ndarray, rounds: int, line_rate_hz: float) -> None:
    """The same traffic again and again, on one core, kept in segments that are deleted as they end."""
    seconds = rounds * len(data) / line_rate_hz
    with tempfile.TemporaryDirectory() as spool, tempfile.TemporaryFile() as out:
        command = ["taskset", "-c", "0", *command, "--spool", spool, "--segment-minutes", "2"]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=out, stderr=subprocess.DEVNULL) as live:
            assert live.stdin is not None
            for _ in range(rounds):
                live.stdin.write(data)
                for old in sorted(Path(spool).glob("*-camera-*.tif"))[:-2]:
                    old.unlink()  # the disk of a test is small
            live.stdin.flush()
            status = Path(f"/proc/{live.pid}/status").read_text()
            live.stdin.close()
            _, _, spent = os.wait4(live.pid, 0)
            live.returncode = 0
        out.seek(0)
        told = [json.loads(line) for line in out]
    ok = sum(one["status"] == "ok" for one in told)
    print(f"  {seconds:.0f} s of traffic: {ok} of {len(told)} vehicles measured")
    print(f"  processor time per second of traffic <= 1: {(spent.ru_utime + spent.ru_stime) / seconds:.2f}")
    if most_kib := re.search(r"VmHWM:\s+(\d+)", status):
        print(f"  most memory <= 400 MiB: {int(most_kib[1]) / 1024:.0f} MiB")


def at_their_pace(command: list[str], data: np.ndarray, line_rate_hz: float) -> None:
    """Lines are written when they would be taken; each vehicle is told so long after it left camera 2."""
    late: list[float] = []
    with tempfile.TemporaryDirectory() as spool:
        command = ["taskset", "-c", "0", *command, "--spool", spool]
        with subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        ) as live:
            assert live.stdin is not None and live.stdout is not None
            live.stdin.write(data[:100])  # it has been started before the traffic comes
            live.stdin.flush()
            while not list(Path(spool).glob("*.tif")):
                time.sleep(0.05)
            begun, sent = time.monotonic() - 100 / line_rate_hz, 100

            def listen() -> None:
                assert live.stdout is not None
                for line in live.stdout:
                    left = json.loads(line)["rear_line_2"] / line_rate_hz
                    late.append(time.monotonic() - begun - left)

            listener = threading.Thread(target=listen)
            listener.start()
            waited = 0.0
            while sent < len(data):
                due = min(len(data), int((time.monotonic() - begun) * line_rate_hz))
                before = time.monotonic()
                live.stdin.write(data[sent:due])
                live.stdin.flush()
                waited = max(waited, time.monotonic() - before)
                sent = due
                time.sleep(PACE_S)
            live.stdin.close()
            listener.join()
    median, latest = np.median(late), max(late)
    print(f"  told after it left <= 2 s: median {median:.2f} s, latest {latest:.2f} s, n {len(late)}")
    print(f"  longest wait of the sender: {1000 * waited:.0f} ms")


if __name__ == "__main__":
    given = [float(word) for word in sys.argv[1:]] or [1024, 5000, 12, 70]
    sys.exit(main(int(given[0]), given[1], int(given[2]), given[3]))
