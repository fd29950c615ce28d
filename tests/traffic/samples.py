"""Recordings of traffic out of a generator, for tests of the archive and its bench."""

from __future__ import annotations

import hashlib

import numpy as np

from sightline.traffic.records import Passing, Recorded


def recorded(seed: int, vehicles: int, duration_s: float, *, unmeasured: float = 0.1) -> Recorded:
    """Vehicles at random moments of a recording; a share of them could not be measured."""
    rng = np.random.default_rng(seed)
    fronts = np.sort(rng.uniform(0.0, duration_s - 2.0, vehicles))
    speeds, lengths = rng.normal(25.0, 4.0, vehicles).clip(5.0), rng.uniform(3.0, 18.0, vehicles)
    refused = rng.random(vehicles) < unmeasured
    passings = tuple(
        _passing(at + 1, *map(float, row), bool(no))
        for at, (row, no) in enumerate(
            zip(np.stack([fronts, speeds, lengths], axis=1).tolist(), refused, strict=True)
        )
    )
    name = f"recording-{seed}.json"
    return Recorded(name, hashlib.sha256(name.encode()).hexdigest(), duration_s, passings)


def _passing(number: int, front_s: float, speed_mps: float, length_m: float, refused: bool) -> Passing:
    rear_s = front_s + min(length_m / speed_mps, 1.9)
    lines = {"front_line_1": 5000 * front_s, "rear_line_1": 5000 * rear_s}
    measured = dict.fromkeys(
        ("speed_mps", "u_speed_mps", "acceleration_mps2", "u_acceleration_mps2", "length_m", "u_length_m")
    )
    if not refused:
        measured = {
            "speed_mps": speed_mps,
            "u_speed_mps": 4e-4 * speed_mps,
            "acceleration_mps2": 0.1,
            "u_acceleration_mps2": 0.05,
            "length_m": length_m,
            "u_length_m": 0.004,
        }
    return Passing(
        number=number,
        front_s=front_s,
        rear_s=rear_s,
        **lines,
        **measured,
        time_gap_s=None if number == 1 else 1.0 + number % 7,
        distance_gap_m=None,
        status="not_measurable" if refused else "ok",
        reason="The strips show no pattern." if refused else None,
    )
