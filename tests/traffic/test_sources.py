"""Files that hold recordings: read as they were written, refused in one sentence that is true."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sightline.errors import BadInput
from sightline.traffic.sources import read_recorded

VEHICLE = {
    "id": 1,
    "front_line_1": 100.0,
    "rear_line_1": 900.0,
    "front_s": 0.02,
    "rear_s": 0.18,
    "speed_mps": 20.0,
    "u_speed_mps": 0.01,
    "acceleration_mps2": 0.0,
    "u_acceleration_mps2": 0.1,
    "length_m": 4.2,
    "u_length_m": 0.004,
    "time_gap_s": None,
    "distance_gap_m": None,
    "status": "ok",
    "reason": None,
    "budget": [],
}


def written(folder: Path, text: str) -> Path:
    path = folder / "recording.json"
    path.write_text(text, encoding="utf-8")
    return path


def whole(*vehicles: Any, **more: Any) -> str:
    return json.dumps({"duration_s": 2.0, "notes": [], "vehicles": list(vehicles), **more})


def test_both_forms_hold_the_same(tmp_path: Path) -> None:
    second = {**VEHICLE, "id": 2, "front_s": 1.0, "rear_s": 1.2, "speed_mps": None, "length_m": None}
    both = (VEHICLE, second)
    one = read_recorded(written(tmp_path, whole(*both)), None)
    other = read_recorded(written(tmp_path, "\n".join(map(json.dumps, both)) + "\n"), 2.0)
    assert one.passings == other.passings and one.duration_s == other.duration_s == 2.0
    assert one.passings[0].speed_mps == 20.0 and one.passings[1].speed_mps is None
    assert one.sha256 != other.sha256


def test_lanes_are_those_of_the_rig_and_of_the_vehicles(tmp_path: Path) -> None:
    far = {**VEHICLE, "id": 2, "front_s": 1.0, "rear_s": 1.2, "lane": "far"}
    one = read_recorded(written(tmp_path, whole(VEHICLE, far, lanes=[{"name": "near"}])), None)
    assert one.lanes == ("near", "far") and [each.lane for each in one.passings] == [None, "far"]
    assert read_recorded(written(tmp_path, whole(VEHICLE)), None).lanes == ()
    with pytest.raises(BadInput):
        read_recorded(written(tmp_path, whole(lanes=["near"])), None)


def test_an_empty_road_is_a_recording(tmp_path: Path) -> None:
    assert read_recorded(written(tmp_path, whole()), None).passings == ()
    assert read_recorded(written(tmp_path, ""), 60.0).passings == ()


@pytest.mark.parametrize(
    ("text", "duration_s", "said"),
    [
        (whole(VEHICLE), 2.0, "leave --duration out"),
        (whole(VEHICLE, duration_s=None), None, "does not state its duration"),
        (json.dumps(VEHICLE), None, "give --duration"),
        ("id,front_line_1\n1,100\n", None, "is not output of sightline linescan --json"),
        ('{"a": 1}', 2.0, "is not output of sightline linescan --json"),
        (whole(3), None, "is not output of sightline linescan --json"),
        (whole(vehicles={"a": 1}), None, "is not output of sightline linescan --json"),
        (whole({**VEHICLE, "front_s": "soon"}), None, "Vehicle 1 .* has no readable front_s"),
        (whole({**VEHICLE, "speed_mps": True}), None, "Vehicle 1 .* has no readable speed_mps"),
        (whole(VEHICLE).replace("20.0", "1e999"), None, "Vehicle 1 .* has no readable speed_mps"),
        (whole({**VEHICLE, "speed_mps": -20.0}), None, "Vehicle 1 .* has no readable speed_mps"),
        (whole({**VEHICLE, "u_speed_mps": -0.01}), None, "Vehicle 1 .* has no readable u_speed_mps"),
        (whole({**VEHICLE, "length_m": 4200}), None, "Vehicle 1 .* has no readable length_m"),
        (whole({**VEHICLE, "speed_mps": 1e300}), None, "Vehicle 1 .* has no readable speed_mps"),
        (whole({**VEHICLE, "rear_line_1": 10**400}), None, "Vehicle 1 .* has no readable rear_line_1"),
        (whole({**VEHICLE, "axles": 1.5}), None, "Vehicle 1 .* has no readable axles"),
        (whole({**VEHICLE, "status": None}), None, "Vehicle 1 .* has no readable status"),
        (whole(VEHICLE, VEHICLE), None, "has vehicle 1 twice"),
        (whole({**VEHICLE, "rear_s": 3.0}), None, "outside the recording’s 2 s"),
        (whole({**VEHICLE, "front_s": -1}), None, "outside the recording’s 2 s"),
        ("[" * 100_000, None, "is not output of sightline linescan --json"),
    ],
)
def test_what_is_no_recording_is_refused(
    tmp_path: Path, text: str, duration_s: float | None, said: str
) -> None:
    with pytest.raises(BadInput, match=said):
        read_recorded(written(tmp_path, text), duration_s)


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match=r"none\.json cannot be read"):
        read_recorded(tmp_path / "none.json", None)


@pytest.mark.parametrize("spoil", [lambda text: text[:-40], lambda text: text.replace('"', "'")])
def test_a_file_cut_short_is_refused(tmp_path: Path, spoil: Callable[[str], str]) -> None:
    with pytest.raises(BadInput, match="is not output of"):
        read_recorded(written(tmp_path, spoil(whole(VEHICLE))), None)
