"""What `sightline flow` reads, written by hand, and what it answers."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main

Row = dict[str, str]
RATE_HZ = 5000
LINE_0 = datetime.fromisoformat("2026-05-04T06:04:50.000+02:00")
# seconds after line 0, seconds before camera 1, speed, length, axles; None: refused
BY_HAND = (
    (8.0, 0.20, 20.0, 4.0, 2),
    (11.0, 0.30, None, None, None),
    (16.0, 0.30, 30.0, 9.0, 3),
    (20.0, 0.22, 20.0, 4.4, 2),
    (670.0, 0.50, 25.0, 12.5, 5),
)


def vehicle(number: int, since_s: float, long_s: float, speed: Any, length: Any, axles: Any) -> Row:
    """A row of vehicles.csv."""
    at = LINE_0 + timedelta(seconds=since_s)
    lines = since_s * RATE_HZ, (since_s + long_s) * RATE_HZ
    held = {
        "id": number,
        "front_line_1": lines[0],
        "rear_line_1": lines[1],
        "speed_mps": speed,
        "u_speed_mps": speed and 0.001 * speed,
        "length_m": length,
        "u_length_m": length and 0.004,
        "axles": axles,
        "direction": "camera_1_first",
        "status": "ok" if speed else "not_measurable",
        "reason": None if speed else "The strips show no pattern.",
        "front_at": at.isoformat(timespec="milliseconds"),
        "u_front_at_s": speed and 0.01,
    }
    return {name: "" if value is None else str(value) for name, value in held.items()}


ROWS = [vehicle(number, *one) for number, one in enumerate(BY_HAND, 1)]


def written(path: Path, rows: Sequence[Row]) -> Path:
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    return path


def as_json(path: Path, duration_s: float, **more: Any) -> Path:
    """The same vehicles as the JSON of `linescan`."""
    cars = []
    for number, (since_s, long_s, speed, length, axles) in enumerate(BY_HAND, 1):
        row: dict[str, Any] = dict(vehicle(number, since_s, long_s, speed, length, axles))
        numbers = {name: float(row[name]) for name in ("front_line_1", "rear_line_1")}
        named = {"id": number, "speed_mps": speed, "length_m": length, "axles": axles}
        shown = {"front_s": since_s, "rear_s": since_s + long_s, "direction": row["direction"]}
        words = {name: row[name] for name in ("status", "reason")}
        u = {"u_speed_mps": speed and 0.001 * speed, "u_length_m": length and 0.004}
        cars.append({**numbers, **named, **shown, **words, **u})
    whole = {"duration_s": duration_s, "start": LINE_0.isoformat(), **more, "vehicles": cars}
    path.write_text(json.dumps(whole))
    return path


def flow(capsys: pytest.CaptureFixture[str], *arguments: object, status: int = 0) -> str:
    assert main(["flow", *map(str, arguments)]) == status
    printed = capsys.readouterr()
    assert "Traceback" not in printed.err
    return printed.out if status == 0 else printed.err


def table(text: str) -> list[Row]:
    return list(csv.DictReader(io.StringIO(text)))
