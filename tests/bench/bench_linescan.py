"""The line-scan chains on simulated traffic, asked beside reached: `bench_linescan.py [parts]`.

Parts: accuracy, noisy, speed, fast. The truth is the demonstration generator's, which shares nothing with
the line-scan room. Times are the processor's, best of three, one thread; longer on a busy machine.
Seeds differ from those on which the chain was developed (101-103, 111).
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from time import process_time

import cv2
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.linescan.direct import measure_direct
from sightline.linescan.finding import Finder
from sightline.linescan.paper import measure_paper
from sightline.linescan.parts import Motion, Passage, Rig
from tests.bench.goals import Row, report, rms, row
from tests.simulation.scan_strips import recording, strips
from tests.simulation.scan_traffic import ScanSite, ScanTruth, traffic, truths

RIG = Rig(0.593, 4882.8)
VEHICLES = int(os.environ.get("VEHICLES", "30"))
Measure = Callable[[Passage, Rig], Motion]


@dataclass
class Errors:
    """Errors of a method over all vehicles: measured minus true; and error over claimed uncertainty."""

    speed: list[float] = field(default_factory=list)
    acceleration: list[float] = field(default_factory=list)
    length: list[float] = field(default_factory=list)
    shift: list[float] = field(default_factory=list)
    gap: list[float] = field(default_factory=list)
    ratios: list[tuple[float, float, float]] = field(default_factory=list)
    refused: int = 0

    def add(self, motion: Motion, true: ScanTruth, site: ScanSite) -> None:
        car = true.vehicle
        if motion.speed_mps is None or motion.acceleration_mps2 is None or motion.length_m is None:
            self.refused += 1
            return
        away = (
            motion.speed_mps - car.speed_mps,
            motion.acceleration_mps2 - car.acceleration_mps2,
            motion.length_m - car.length_m,
        )
        self.speed.append(100 * away[0] / car.speed_mps)
        self.acceleration.append(away[1])
        self.length.append(100 * away[2])
        if motion.misalignment_px is not None:
            self.shift.append(motion.misalignment_px - site.misalignment_px)
        claimed = (motion.u_speed_mps, motion.u_acceleration_mps2, motion.u_length_m)
        if None not in claimed:
            self.ratios.append(tuple(a / max(u, 1e-12) for a, u in zip(away, claimed, strict=True)))


def found(first: np.ndarray, second: np.ndarray, rig: Rig, piece: int = 1024) -> list[Passage]:
    finder = Finder(first.shape[1], rig)
    out: list[Passage] = []
    for start in range(0, len(first), piece):
        out += finder.push(first[start : start + piece], second[start : start + piece])
    return out + finder.finish()


def run(sites: list[ScanSite], methods: dict[str, Measure]) -> tuple[dict[str, Errors], int]:
    """Errors of each method on traffic of VEHICLES vehicles per site, and how many were missed."""
    errors = {name: Errors() for name in methods}
    missed = 0
    for site in sites:
        cars = traffic(site.seed, VEHICLES)
        truth = truths(site, cars)
        passages = found(*strips(site, cars), RIG)
        before = None
        for true in truth:
            near = [p for p in passages if abs(p.crossings.front_line_1 - true.front_line_1) < 60]
            if not near:
                missed += 1
                before = None
                continue
            for name, measure in methods.items():
                errors[name].add(measure(near[0], RIG), true, site)
            if before is not None and true.time_gap_s is not None:
                gap = (near[0].crossings.front_line_1 - before.crossings.rear_line_1) / RIG.line_rate_hz
                for kept in errors.values():
                    kept.gap.append(1e3 * (gap - true.time_gap_s))
            before = near[0]
    return errors, missed


def _of(errors: Errors) -> str:
    if not errors.speed:
        return f"none measured, {errors.refused} refused"
    return (
        f"speed {rms(errors.speed):.3f} %, acceleration {rms(errors.acceleration):.3f} m/s2, "
        f"length {rms(errors.length):.2f} cm, {len(errors.speed)} measured, {errors.refused} refused"
    )


def accuracy() -> Iterator[Row]:
    """256 rows, noise 2 DN, shadow, drift, unequal gains, misalignment up to 1 px, wheels, windows."""
    shifts = {201: 0.3, 202: -0.7, 203: 1.0}
    sites = [ScanSite(seed=seed, misalignment_px=shift) for seed, shift in shifts.items()]
    all_errors, missed = run(sites, {"direct": measure_direct, "paper": measure_paper})
    e = all_errors["direct"]
    within = float(np.mean(np.abs(e.speed) <= 0.12))
    yield row("vehicles missed or refused", "0", f"{missed + e.refused}", missed + e.refused == 0)
    yield row("speed, rms", "<= 0.06 %", f"{rms(e.speed):.4f} %", rms(e.speed) <= 0.06)
    yield row("vehicles within 0.12 % of their speed", ">= 95 %", f"{100 * within:.1f} %", within >= 0.95)
    reached = rms(e.acceleration)
    yield row("acceleration, rms", "<= 0.15 m/s2", f"{reached:.3f} m/s2", reached <= 0.15)
    yield row("length, rms", "<= 1.0 cm", f"{rms(e.length):.2f} cm", rms(e.length) <= 1.0)
    yield row("time gap, rms", "<= 0.5 ms", f"{rms(e.gap):.2f} ms", rms(e.gap) <= 0.5)
    worst = float(np.abs(e.shift).max())
    yield row("misalignment, worst vehicle", "<= 0.05 px", f"{worst:.3f} px", worst <= 0.05)
    inside = (np.abs(np.array(e.ratios)) <= 1.96).mean(0)
    for name, share in zip(("speed", "acceleration", "length"), inside, strict=True):
        yield row(f"coverage of U95, {name}", "0.93 .. 0.97", f"{share:.3f}", 0.93 <= share <= 0.97)
    yield row("the default", "-", _of(e), True)
    yield row("the paper's method", "-", _of(all_errors["paper"]), True)


def noisy() -> Iterator[Row]:
    """The same at 8 grey values of read noise."""
    sites = [ScanSite(seed=seed, read_noise_dn=8.0, misalignment_px=0.4) for seed in (211, 212)]
    all_errors, missed = run(sites, {"direct": measure_direct, "paper": measure_paper})
    e = all_errors["direct"]
    yield row("noise 8 DN: vehicles missed or refused", "0", f"{missed + e.refused}", missed + e.refused == 0)
    yield row("noise 8 DN: speed, rms", "<= 0.12 %", f"{rms(e.speed):.3f} %", rms(e.speed) <= 0.12)
    inside = (np.abs(np.array(e.ratios)) <= 1.96).mean(0)
    # 60 vehicles: two standard deviations of a share of 0.95 are 0.06
    for name, share in zip(("speed", "acceleration", "length"), inside, strict=True):
        yield row(f"noise 8 DN: coverage of U95, {name}", ">= 0.89", f"{share:.3f}", share >= 0.89)
    yield row("noise 8 DN: the default", "-", _of(e), True)
    yield row("noise 8 DN: the paper's method", "-", _of(all_errors["paper"]), True)


def _seconds(action: Callable[[], object]) -> float:
    times = []
    for _ in range(3):
        start = process_time()
        action()
        times.append(process_time() - start)
    return min(times)


def _rates(first: np.ndarray, second: np.ndarray, rig: Rig, asked: float, name: str) -> Iterator[Row]:
    real_s = len(first) / rig.line_rate_hz
    passages = found(first, second, rig)
    finding = _seconds(lambda: found(first, second, rig))
    about = f"{len(passages)} vehicles in {real_s:.1f} s, {first.shape[1]} rows"
    yield row(f"{name}: finding alone", about, f"{real_s / finding:.1f} x real time", True)
    for method, measure in (("default", measure_direct), ("paper's method", measure_paper)):
        measuring = _seconds(lambda measure=measure: [measure(p, rig) for p in passages])
        each = 1e3 * measuring / max(len(passages), 1)
        total = real_s / (finding + measuring)
        lines = len(first) / (finding + measuring) / 1e3
        reached = f"{total:.1f} x, {lines:.0f} klines/s, {each:.0f} ms a vehicle"
        limit = f">= {asked:g} x real time" if method == "default" else "-"
        yield row(
            f"{name}: finding and measuring, {method}", limit, reached, method != "default" or total >= asked
        )


def speed() -> Iterator[Row]:
    """1024 rows, 60 vehicles a minute, both strips in memory: reading comes on top (bench_strips.py)."""
    cv2.setNumThreads(1)
    site = ScanSite(rows=1024, seed=221, misalignment_px=0.5)
    cars = traffic(221, 12, speeds_mps=(12.0, 26.0), gaps_s=(0.55, 0.75))
    yield from _rates(*strips(site, cars), RIG, 15.0, "4,883 lines/s")


def fast() -> Iterator[Row]:
    """50,000 lines a second: the stretch goal is real time on one core, at the same traffic."""
    cv2.setNumThreads(1)
    site = ScanSite(rows=1024, seed=231, line_rate_hz=50_000.0, misalignment_px=0.5)
    rig = Rig(0.593, 50_000.0)
    cars = traffic(231, 3, speeds_mps=(12.0, 26.0), gaps_s=(0.55, 0.75))
    parts = list(recording(site, cars))
    first, second = (np.concatenate([part[k] for part in parts]) for k in (0, 1))
    yield from _rates(first, second, rig, 1.0, "50,000 lines/s")
    errors = Errors()
    for passage, true in zip(found(first, second, rig), truths(site, cars), strict=True):
        errors.add(measure_direct(passage, rig), true, site)
    yield row("50,000 lines/s: accuracy", "-", _of(errors), True)


if __name__ == "__main__":
    sys.exit(report((accuracy, noisy, speed, fast), sys.argv[1:]))
