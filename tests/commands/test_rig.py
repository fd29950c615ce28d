"""`sightline rig calibrate` from the outside."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.scans.rig.passes_csv import COLUMNS
from tests.linescan.test_rig_calibration import (
    RATE_HZ,
    STANDS_M,
    Errors,
    Planes,
    by_board,
    by_positions,
    by_speed,
    planes,
)

HEADER = ",".join(COLUMNS)


def row(name: str, told: float, way: Any, rig: Planes) -> str:
    one = {**vars(way(rig, told, Errors(None))), "pass": name}
    return ",".join("" if one[column] is None else str(one[column]) for column in COLUMNS)


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """Six good passes by two ways, and three rows that cannot be used."""
    rows = [row(f"n{k}", told, (by_board, by_positions)[k % 2], planes()) for k, told in enumerate(STANDS_M)]
    bad = ["far,far" + "," * (len(COLUMNS) - 2), "short,3.0", "n0,3.0" + "," * (len(COLUMNS) - 2)]
    path = tmp_path / "passes.csv"
    path.write_text("﻿" + "\r\n".join([HEADER, *rows, *bad]) + "\r\n", encoding="utf-8")
    return path


def test_passes_give_the_rig_and_its_lanes(
    table: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rig, written = planes(), tmp_path / "rig.json"
    lanes = ["--distance", "5.5,0.1", "--distance", "8", "--u-tape", "4e-4"]
    assert main(["rig", "calibrate", str(table), *lanes, "-o", str(written), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found == json.loads(written.read_text())
    assert found["baseline_m"] == pytest.approx(rig.between(0.0), abs=1e-9)
    assert [one["baseline_m"] for one in found["lanes"]] == [
        pytest.approx(rig.between(5.5), abs=1e-9),
        pytest.approx(rig.between(8.0), abs=1e-9),
    ]
    assert found["U95_baseline_m"] == pytest.approx(1.959964 * found["u_baseline_m"], rel=1e-6)
    assert found["lanes"][0]["u_baseline_m"] < found["u_baseline_m"]
    left_out = [(one["row"], one["name"], one["reason"].split(", ", 1)[-1]) for one in found["left_out"]]
    assert left_out == [
        (8, "far", "line 8: distance_m is “far”, which is not a number; correct the cell."),
        (9, "short", f"line 9 has 2 cells, but the header names {len(COLUMNS)}; fill in the row."),
        (10, "n0", "Another row has the same name; name each pass once."),
    ]
    assert [one["name"] for one in found["passes"]] == [f"n{k}" for k in range(6)]


def test_the_text_says_it_in_lines(table: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rig", "calibrate", str(table), "--distance", "40"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("baseline at the cameras 593.00 ± ")
    assert "6 passes from 3.00 to 9.50 m: chi-square 0.0 (degrees of freedom: 4)" in said
    assert "at 40.00 m: baseline " in said
    assert "line 9 has 2 cells" in said
    assert "note: 40.00 m is far outside the passes" in said


def test_a_line_rate_whose_u_is_not_given_is_noted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Only where passes of known speed need it."""
    note, path = "uncertainty of the line rate is not included", tmp_path / "passes.csv"
    for way, noted in ((by_speed, True), (by_board, False)):
        rows = [row(f"n{k}", told, way, planes()) for k, told in enumerate(STANDS_M)]
        path.write_text("\n".join([HEADER, *rows]) + "\n")
        asked = ["rig", "calibrate", str(path), "--line-rate", str(RATE_HZ)]
        assert main([*asked, "--json"]) == 0
        assert any(note in one for one in json.loads(capsys.readouterr().out)["warnings"]) == noted
        assert main(asked) == 0
        assert (note in capsys.readouterr().out) == noted
        assert main([*asked, "--u-line-rate", "1e-5"]) == 0
        assert note not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "arguments", "said"),
    [
        ("distance_m,speed_mps\n3,2\n", [], "lacks columns; give distance_m and all columns of one method"),
        ("", [], "lacks columns"),
        (HEADER + "," + COLUMNS[1] + "\n", [], "line 1: the column distance_m is named twice"),
        (HEADER + "\nx,far\n", [], "0 usable passes are too few"),
        (HEADER + "\n", ["--distance", "near"], "--distance near is not a distance to a lane"),
        (HEADER + "\n", ["--distance", "3,1,2"], "is not a distance to a lane"),
        (HEADER + "\n", ["--line-rate", "0"], "--line-rate must be a finite number above 0"),
        (HEADER + "\n" + "1,3\n" * 501, [], "more than 500 rows"),
    ],
)
def test_what_is_no_calibration_is_one_sentence(
    text: str, arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "p.csv"
    path.write_text(text)
    assert main(["rig", "calibrate", str(path), *arguments]) == 2
    told = capsys.readouterr()
    assert said in told.err
    assert told.out == "" and told.err.count("\n") == 1


def test_an_unusable_row_is_named_where_too_few_are_left(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "p.csv"
    path.write_text(HEADER + "\nx,far" + "," * (len(COLUMNS) - 2) + "\n")
    assert main(["rig", "calibrate", str(path)]) == 2
    assert "line 2: distance_m is “far”, which is not a number" in capsys.readouterr().err
    assert main(["rig", "calibrate", str(tmp_path / "none.csv")]) == 2
