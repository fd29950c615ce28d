"""sightline adjust and its files, as the contract has them."""

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest

from sightline.cli import main
from sightline.commands.passes_csv import NEEDED, OPTIONS
from sightline.messages.said import Said
from tests.adjustment.survey import (
    BoardBudget,
    Fleet,
    eye_clicks,
    passes,
    prior_covariance,
    told_pose,
    truth_at,
)

COLUMNS = [*NEEDED, *OPTIONS]


@pytest.fixture
def files(tmp_path: Path) -> tuple[Path, Path]:
    truth, rng = truth_at(), np.random.default_rng(1)
    budget = BoardBudget()
    pose = tmp_path / "pose.json"
    pose.write_text(json.dumps(told_pose(truth, budget, prior_covariance(truth, budget), rng)))
    rows, _ = passes(truth, Fleet(vehicles=12, u_roof=0.01), rng)
    table = tmp_path / "passes.csv"
    table.write_text(text_of(rows))
    return pose, table


def text_of(rows: list[dict[str, object]]) -> str:
    out = io.StringIO()
    writer = csv.DictWriter(out, COLUMNS, lineterminator="\r\n")
    writer.writeheader()
    writer.writerows(rows)
    return "﻿" + out.getvalue()


def run(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, str, str]:
    status = main([str(one) for one in arguments])
    said = capsys.readouterr()
    return status, said.out, said.err


def test_an_adjusted_pose_is_written_told_and_taken(files, tmp_path, capsys) -> None:  # type: ignore[no-untyped-def]
    pose, table = files
    output = tmp_path / "adjusted.json"
    status, out, err = run(capsys, "adjust", "--pose", pose, "--passes", table, "-o", output, "--json")
    assert (status, err) == (0, "")
    document = json.loads(out)
    assert document == json.loads(output.read_text())
    told = document["adjustment"]
    assert (told["passes"], told["used"], told["left_out"]) == (12, 12, [])
    assert told["chi2"] > 0 and told["degrees_of_freedom"] > 0
    assert {"name", "value", "u_before", "u_after"} == set(told["moved"][0])
    assert {"board_lean_rad", "wheelbase_common_m", "camera_height_m", "fx_px", "tz_m"} <= {
        one["name"] for one in told["moved"]
    }
    contact, target = (f"{x},{y}" for x, y in eye_clicks(truth_at()))
    u = []
    for file in (pose, output):
        status, out, _ = run(
            capsys, "height", "--pose", file, "--contact", contact, "--target", target,
            "--inset", 0.45, "--sigma", 0, "--json",
        )  # fmt: skip
        assert status == 0
        measured = json.loads(out)
        u.append(measured["u_height_m"])
        assert measured["height_m"] == pytest.approx(1.15, abs=4 * u[-1])
    assert u[1] < 0.4 * u[0]
    assert {e["source"]: e["u_m"] for e in measured["budget"]}["board lean"] == 0.0


def test_what_cannot_be_read_is_left_out_by_name(files, tmp_path, capsys) -> None:  # type: ignore[no-untyped-def]
    pose, table = files
    rows = list(csv.DictReader(io.StringIO(table.read_text().lstrip("﻿"))))
    of = {name: [row for row in rows if row["pass"] == name] for name in ("1", "2", "3", "4", "5")}
    of["1"][0]["x_px"] = "here"
    of["2"][3]["point"] = "bonnet"
    of["3"][1]["wheelbase_m"] = "9.1"
    for row in of["4"]:
        row["u_roof_m"] = ""
    of["5"][0]["frame"] = "1.5"
    table.write_text(text_of(rows))
    output = tmp_path / "adjusted.json"
    status, _, _ = run(capsys, "adjust", "--pose", pose, "--passes", table, "-o", output)
    told = json.loads(output.read_text())["adjustment"]
    assert status == 0 and told["used"] == 7
    reasons = {one["pass"]: str(Said.read(one["reason"])) for one in told["left_out"]}
    assert list(reasons) == ["1", "2", "3", "4", "5"]
    for name, word in {"1": "x_px", "2": "point", "3": "wheelbase_m", "4": "u_roof_m", "5": "frame"}.items():
        assert word in reasons[name]


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("", "empty"),
        ("pass,frame,point,x_px\n1,2,roof,3\n", "y_px"),
        ("pass,frame,point,x_px,y_px\n,2,roof,3,4\n", "row 2"),
        ("pass,frame,point,x_px,y_px\n1,2,roof,3\n", "line 2 has 4 cells"),
        ("pass,pass,frame,point,x_px,y_px\n", "line 1: the column pass is named twice"),
    ],
)
def test_a_table_that_cannot_be_read_is_bad_input(files, tmp_path, capsys, text, word) -> None:  # type: ignore[no-untyped-def]
    pose, table = files
    table.write_text(text)
    output = tmp_path / "adjusted.json"
    status, out, err = run(capsys, "adjust", "--pose", pose, "--passes", table, "-o", output)
    assert (status, out) == (2, "")
    assert word in err and "passes.csv" in err
    assert not output.exists()


def test_options_that_cannot_be_are_refused(files, tmp_path, capsys) -> None:  # type: ignore[no-untyped-def]
    pose, table = files
    for option in ("--u-wheelbase-common", "--u-roof-common"):
        for value in ("-0.1", "nan", "1e300"):
            status, _, err = run(
                capsys, "adjust", "--pose", pose, "--passes", table, "-o", tmp_path / "a.json", option, value
            )
            assert status == 2 and option in err
