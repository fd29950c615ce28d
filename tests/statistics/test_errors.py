"""The error table against SciPy's and Python's own figures, the rounding rule, and interval coverage."""

import json
import statistics
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from scipy.optimize import linprog

from sightline.cli import main
from sightline.commands.errors import errors
from sightline.enums import Rounding
from sightline.errors import BadInput
from sightline.messages.said import Said
from sightline.statistics.agreement import bland_altman, reference_part, trend
from sightline.statistics.errors import (
    ALL_FIGURES,
    FIGURES,
    MOST_FOR_BOOTSTRAP,
    error_group,
    error_table,
    round_to_cm,
    signed_errors,
)
from sightline.statistics.paper import PAPER
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample


def rows(n: int, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    reference = rng.normal(1.5, 0.1, n)
    return reference + rng.normal(0.004, 0.02, n), reference


@given(st.integers(0, 4000))
def test_rounding_is_half_up_from_whole_millimetres(mm: int) -> None:
    exact = Decimal(mm).scaleb(-1).quantize(Decimal(1), rounding=ROUND_HALF_UP)
    assert round_to_cm(mm / 1000) == float(exact) / 100


def test_figures_agree_with_other_implementations() -> None:
    measured, reference = rows(60)
    figures = error_group(measured - reference, reference).figures
    e = [float(v) for v in measured - reference]
    assert figures["bias_m"] == pytest.approx(statistics.fmean(e), abs=1e-15)
    assert figures["mae_m"] == pytest.approx(statistics.fmean(map(abs, e)), abs=1e-15)
    assert figures["mse_m2"] == pytest.approx(statistics.fmean(v * v for v in e), rel=1e-12)
    assert figures["rmse_m"] == pytest.approx(statistics.fmean(v * v for v in e) ** 0.5, rel=1e-12)
    assert figures["sd_m"] == pytest.approx(statistics.stdev(e), rel=1e-12)
    assert figures["pearson_error_vs_height"] == pytest.approx(stats.pearsonr(e, reference).statistic)
    assert figures["pearson_abs_error_vs_height"] == pytest.approx(
        stats.pearsonr(np.abs(e), reference).statistic
    )


def test_skewness_and_shares_agree_with_other_implementations() -> None:
    rng = np.random.default_rng(3)
    error = np.round(rng.gamma(2.0, 0.01, 400) - 0.01, 3)
    group = error_group(error, rng.normal(1.5, 0.1, 400))
    assert group.figures["skewness"] == pytest.approx(stats.skew(error), rel=1e-9)
    for mm in (10, 15, 20, 30, 40):
        name = f"share_within_{mm}_mm"
        within = sum(abs(round(1000 * e)) <= mm for e in error.tolist())
        interval = group.ci95[name]
        assert group.figures[name] == within / 400 and interval is not None
        # of Clopper and Pearson, by quantiles of the beta distribution
        assert interval.low == pytest.approx(stats.beta.ppf(0.025, within, 401 - within), rel=1e-6)
        assert interval.high == pytest.approx(stats.beta.ppf(0.975, within + 1, 400 - within), rel=1e-6)


def least_share_below_2_cm(mae_cm: float, rmse_cm: float, mse_cm2: float, most_cm: int) -> float:
    """By linear programming over whole centimetres; each figure as printed, to half of its last digit."""
    size = np.arange(most_cm + 1.0)
    last = {0.023: 0.05, 0.0147: 0.005, 0.0203: 0.005}[round(mae_cm / 100, 4)]
    squares = (
        max(mse_cm2 - (0.5 if mse_cm2 == 8 else 0.05), (rmse_cm - 0.05) ** 2),
        min(mse_cm2 + (0.5 if mse_cm2 == 8 else 0.05), (rmse_cm + 0.05) ** 2),
    )
    found = linprog(
        (size < 2).astype(float),
        A_ub=np.array([size, -size, size**2, -(size**2)]),
        b_ub=[mae_cm + last, last - mae_cm, squares[1], -squares[0]],
        A_eq=[np.ones(most_cm + 1)],
        b_eq=[1.0],
    )
    assert found.status == 0
    return float(found.fun)


def test_what_is_said_of_the_papers_shares_follows_from_its_table() -> None:
    day, low, both = ((100 * one.mae_m, 100 * one.rmse_m, round(1e4 * one.mse_m2, 3)) for one in PAPER)
    assert least_share_below_2_cm(*day, 7) < 0.03 and least_share_below_2_cm(*day, 9) == pytest.approx(0)
    assert least_share_below_2_cm(*low, 300) == pytest.approx(0.265, abs=0.002)
    assert least_share_below_2_cm(*both, 10) > 0.1 > least_share_below_2_cm(*both, 11)
    day, low_light, overall = (str(one.note) for one in PAPER)
    assert "is possible" in day and "26.5 %" in low_light and "more than 10 cm" in overall


def test_overall_is_the_pool_of_rows_and_not_of_figures() -> None:
    measured, reference = rows(30)
    lighting = ["daytime"] * 18 + ["low_light"] * 7 + [""] * 5
    table = error_table(measured, reference, lighting, "none")
    assert [table[g].n for g in ("daytime", "low_light", "overall")] == [18, 7, 30]
    assert table["overall"].figures["mae_m"] == pytest.approx(np.mean(np.abs(measured - reference)))


def test_intervals_of_many_rows_are_those_of_the_bootstrap() -> None:
    measured, reference = rows(MOST_FOR_BOOTSTRAP)
    few = error_group(measured - reference, reference)
    error, height = (np.concatenate([v, v[:1]]) for v in (measured - reference, reference))
    many = error_group(error, height)
    for name in FIGURES:
        one, other = few.ci95[name], many.ci95[name]
        assert one is not None and other is not None
        width = one.high - one.low
        assert abs(other.low - one.low) < 0.08 * width and abs(other.high - one.high) < 0.08 * width, name
    rng = np.random.default_rng(9)
    large = error_group(rng.normal(0.004, 0.02, 100_000), rng.normal(1.5, 0.1, 100_000))
    assert large.ci95["bias_m"] is not None
    assert large.ci95["bias_m"].high - large.ci95["bias_m"].low == pytest.approx(
        2 * 1.96 * 0.02 / 316.2, rel=0.01
    )


def test_too_few_rows_have_a_reason_and_no_interval() -> None:
    empty = error_group([], [])
    assert empty.n == 0 and empty.reason and set(empty.figures.values()) == {None}
    one = error_group([0.01], [1.5])
    assert one.figures["mae_m"] == 0.01 and one.figures["sd_m"] is None
    assert one.figures["pearson_error_vs_height"] is None
    assert str(one.reason).startswith("1 vehicle is too few") and set(one.ci95.values()) == {None}


@pytest.mark.parametrize("n", [6, 20, 400, MOST_FOR_BOOTSTRAP + 1])
@pytest.mark.parametrize("rounding", ["cm", "none"])
@pytest.mark.parametrize("error_m", [0.0, 0.02, 0.03, -0.01])
def test_equal_errors_have_no_spread_no_interval_and_no_correlation(
    n: int, rounding: Rounding, error_m: float
) -> None:
    """1.47 - 1.45 is not 1.52 - 1.50 in binary: what is left over is no error and no spread."""
    reference = np.round(np.random.default_rng(1).uniform(1.3, 2.0, n), 2)
    measured = np.round(reference + error_m, 2)
    group = error_table(measured, reference, ["daytime"] * n, rounding)["overall"]
    assert group.figures["bias_m"] == pytest.approx(error_m, abs=1e-15)
    assert group.figures["sd_m"] == pytest.approx(0.0, abs=1e-15)
    spread = ("pearson_error_vs_height", "pearson_abs_error_vs_height", "skewness")
    assert [group.figures[name] for name in spread] == [None, None, None]
    assert {group.ci95[name] for name in FIGURES} == {None}
    assert str(group.reason) == "all errors are the same, so bias, MAE, RMSE and SD have no interval"
    assert set(group.holds) == {name for name, interval in group.ci95.items() if interval}
    error, rounded = signed_errors(measured, reference, rounding)
    assert error_group(error, rounded, names=FIGURES).words is None
    for found in (reference_part(error, rounded), trend(rounded, error), bland_altman(error)):
        assert isinstance(found, Said)


@pytest.mark.parametrize("surveys", [70, *(pytest.param(n, marks=pytest.mark.proof) for n in (100, 200))])
def test_intervals_hold_what_they_promise(surveys: int) -> None:
    """Coverage of the 95 % interval of MAE and bias over simulated surveys of 60 vehicles."""
    rng = np.random.default_rng(7)
    true_mae, inside = 0.02 * (2 / np.pi) ** 0.5, {"mae_m": 0, "bias_m": 0}
    for _ in range(surveys):
        group = error_group(rng.normal(0, 0.02, 60), rng.normal(1.5, 0.1, 60))
        for name, truth in (("mae_m", true_mae), ("bias_m", 0.0)):
            interval = group.ci95[name]
            assert interval
            inside[name] += interval.low <= truth <= interval.high
    # BCa undercovers by about 1 % at n = 60; a standard deviation of such a share is 1.7 % of 200 draws, and
    # 2.6 % of 70: they are held to the same bounds.
    assert all(0.90 <= count / surveys <= 0.99 for count in inside.values()), inside


@pytest.mark.parametrize("surveys", [40, pytest.param(300, marks=pytest.mark.proof)])
def test_a_limit_between_whole_centimetres_parts_them_as_the_one_below_does(surveys: int) -> None:
    """Of errors in whole centimetres as many lie within 15 mm as within 10 mm, so both have one interval, and
    it holds the share that such surveys have on average, 0.595 (20 000 of them; one pose, u 10 mm).
    """
    rng = np.random.default_rng(1)
    one_pose = (SharedErrors(np.zeros(100, dtype=np.int64), np.full(100, 0.01)),)
    held = []
    for _ in range(surveys):
        reference = np.round(rng.uniform(1.3, 2.0, 100), 2)
        measured = reference + rng.normal(0.0, 0.015, 100) + rng.normal(0.0, 0.01)
        sample = HeightSample(measured, np.full(100, 0.015), one_pose)
        group = error_table(measured, reference, [""] * 100, "cm", sample)["overall"]
        within = group.ci95["share_within_10_mm"]
        assert within is not None and within == group.ci95["share_within_15_mm"]
        held.append(within.low <= 0.595 <= within.high)
    assert np.mean(held) >= 0.94


def heights_csv(folder: Path, text: str) -> Path:
    path = folder / "heights.csv"
    path.write_text(text, encoding="utf-8-sig")
    return path


def test_a_cell_with_an_unusual_line_break_is_still_one_cell(tmp_path: Path) -> None:
    path = tmp_path / "heights.csv"
    path.write_text("id,height_m,reference_height_m,status\na\u2028b,1.02,1.00,ok\n", encoding="utf-8")
    said = CliRunner().invoke(errors, [str(path), "--json"])
    assert json.loads(said.output)["groups"]["overall"]["n"] == 1


def test_command_prints_the_contract(tmp_path: Path) -> None:
    lines = ["id,lighting,reference_height_m,height_m,status"]
    lines += [f"{i},daytime,1.5,{1.5 + 0.01 * (i % 3)},ok" for i in range(12)]
    lines += ["x,low_light,1.5,,not_measurable", "y,,1.400,1.444,ok"]
    done = CliRunner().invoke(errors, [str(heights_csv(tmp_path, "\r\n".join(lines))), "--json"])
    assert done.exit_code == 0, done.output
    said = json.loads(done.output)
    assert said["rounding"] == "cm" and list(said["groups"]) == ["daytime", "low_light", "overall"]
    day = said["groups"]["daytime"]
    assert day["n"] == 12 and day["mae_m"] == pytest.approx(0.01) and set(day["ci95"]) == set(ALL_FIGURES)
    assert said["groups"]["low_light"]["n"] == 0
    assert said["groups"]["overall"]["n"] == 13


@pytest.mark.parametrize(
    ("text", "word"), [("id,height_m\n1,2\n", "reference_height_m"), ("", "height_m"), ("\x00\xff", "column")]
)
def test_a_file_without_the_columns_is_refused_in_one_sentence(tmp_path: Path, text: str, word: str) -> None:
    done = CliRunner().invoke(errors, [str(heights_csv(tmp_path, text))])
    assert isinstance(done.exception, BadInput)
    assert word in done.exception.message and done.exception.message.count("\n") == 0


def _shared_csv(path: Path, columns: str, cells: str) -> Path:
    """Heights of one pose with so many columns more."""
    rng = np.random.default_rng(4)
    rows = [f"{1.45 + 0.02 * e:.4f},1.45,ok{cells}" for e in rng.normal(0.3, 1.0, 60)]
    path.write_text(f"height_m,reference_height_m,status{columns}\n" + "\n".join(rows) + "\n")
    return path


def test_the_command_counts_what_heights_share(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told = []
    for columns, cells in (("", ""), (",shared_group,u_shared_m", ",pose 1,0.02")):
        path = _shared_csv(tmp_path / "heights.csv", columns, cells)
        assert main(["errors", str(path), "--json", "--round", "none"]) == 0
        told.append(json.loads(capsys.readouterr().out)["groups"]["overall"])
    alone, total = told
    for name in ("bias_m", "mae_m", "rmse_m", "mse_m2", "share_within_20_mm"):
        (low, high), (least, most) = alone["ci95"][name], total["ci95"][name]
        assert most - least > 1.5 * (high - low), name
        assert "shared_errors" in total["holds"][name] and "shared_errors" not in alone["holds"][name]
    assert total["ci95"]["skewness"] == alone["ci95"]["skewness"]
    assert main(["errors", str(path)]) == 0
    assert "Intervals include sampling, errors that heights share, random errors" in capsys.readouterr().out


def test_errors_below_what_is_printed_have_no_sign(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "heights.csv"
    rows = [f"{1.45 + e / 1e6:.6f},1.45,ok" for e in (-9, 7, -9, 7, -9, 7)]
    path.write_text("height_m,reference_height_m,status\n" + "\n".join(rows) + "\n")
    assert main(["errors", str(path), "--round", "none"]) == 0
    (bias,) = (one for one in capsys.readouterr().out.splitlines() if one.startswith("bias"))
    assert "0.0000 m (0.000 ft) [0.0000, 0.0000]" in bias and "-0" not in bias


@pytest.mark.parametrize(
    ("columns", "cells", "said"),
    [
        (",shared_group", ",a", "no column u_shared_m"),
        (",shared_group,u_shared_m", ",a,far", "line 2: u_shared_m is “far”"),
    ],
)
def test_shared_errors_that_are_not_told_are_refused(
    columns: str, cells: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = _shared_csv(tmp_path / "heights.csv", columns, cells)
    assert main(["errors", str(path)]) == 2
    printed = capsys.readouterr().err
    assert said in printed and printed.count("\n") == 1


def test_references_in_another_unit_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "heights.csv"
    rows = "".join(f"{i},{1.41 + i / 100:.2f},0.005,{1400 + 10 * i},daytime,ok\n" for i in range(12))
    path.write_text("id,height_m,u_height_m,reference_height_m,lighting,status\n" + rows)
    assert main(["errors", str(path)]) == 2
    assert (
        "line 2: reference_height_m is “1400”, and no vehicle has more than 20 m; in mm it would be 1.4 m"
        in (capsys.readouterr().err)
    )


TARGETS_CSV = """id,target,lighting,category,height_m,reference_height_m,status,check_target,counts
1,roof,daytime,saloon,1.51,1.50,ok,false,true
2,roof,low_light,van,1.93,1.90,ok,false,true
3,roof,daytime,saloon,1.80,1.50,ok,false,false
4,taillight,daytime,saloon,0.72,0.70,ok,false,true
5,driver_eye,daytime,saloon,1.18,1.16,ok,true,false
6,driver_eye,daytime,saloon,1.18,,ok,false,true
"""


def test_errors_by_a_column_are_of_each_value_alone(tmp_path: Path) -> None:
    """`{"groups": {VALUE: the object as without --by}}`, those of check targets apart."""
    path = str(heights_csv(tmp_path, TARGETS_CSV))

    def told(*asked: str, of: str = path) -> dict[str, Any]:
        done = CliRunner().invoke(errors, [of, "--json", "--round", "none", *asked])
        assert done.exit_code == 0, done.output
        found: dict[str, Any] = json.loads(done.output)
        return found

    groups = told("--by", "target")["groups"]
    assert set(groups) == {"roof", "taillight", "driver_eye", "driver_eye, check targets"}
    assert groups["roof"]["groups"]["overall"]["bias_m"] == pytest.approx(0.02)
    assert groups["roof"]["groups"]["daytime"]["bias_m"] == pytest.approx(0.01)
    assert groups["driver_eye, check targets"]["groups"]["overall"]["n"] == 1
    assert [one["left_out"] for one in groups.values()] == [1, 0, 0, 1]
    header, *lines = TARGETS_CSV.splitlines(keepends=True)
    for category, one in told("--by", "category")["groups"].items():
        if "check" in category:
            continue
        alone = (row for row in lines if row.split(",")[3] == category and ",true,false" not in row)
        assert one == told(of=str(heights_csv(tmp_path, header + "".join(alone))))
    path = str(heights_csv(tmp_path, TARGETS_CSV))
    words = CliRunner().invoke(errors, [path, "--by", "target"]).output
    assert "target driver_eye, check targets\n" in words and "1 rows have no height" in words
    # without shared errors and sites no interval is total
    assert "in brackets 95 % intervals" in words and "total" not in words
    # the table alone is of roofs of the traffic, and says what it leaves out
    plain = told()
    assert plain["groups"]["overall"]["n"] == 2 and plain["left_out"] == 2
    said = "Rows not in the table: 1 of driver_eye, check targets; 1 of taillight. --by target covers each."
    assert said in CliRunner().invoke(errors, [path]).output
    assert plain["other_targets"] == {"driver_eye, check targets": 1, "taillight": 1}
    eyes = heights_csv(tmp_path, TARGETS_CSV.replace(",roof,", ",headlight,"))
    refused = CliRunner().invoke(errors, [str(eyes)]).exception
    assert isinstance(refused, BadInput) and "use --by target" in refused.message


def test_groups_of_any_column_are_of_one_target_that_is_named(tmp_path: Path) -> None:
    """Roofs of vans beside eyes of buses would look like vans beside buses."""
    head = "target,category,height_m,reference_height_m,status,check_target\n"
    bus = "driver_eye,bus,2.05,2.00,ok,false\ndriver_eye,bus,2.06,2.00,ok,false\n"
    check = "roof,van,1.91,1.90,ok,true\ndriver_eye,van,1.81,1.80,ok,true\n"
    path = str(heights_csv(tmp_path, head + "roof,van,1.93,1.90,ok,false\n" + bus + check))
    told = json.loads(CliRunner().invoke(errors, [path, "--json", "--by", "category"]).output)["groups"]
    found = {name: (one["target"], one["groups"]["overall"]["n"]) for name, one in told.items()}
    assert found == {"van": ("roof", 1), "bus": ("roof", 0), "van, check targets": ("roof", 1)}
    others = {name: one["other_targets"] for name, one in told.items()}
    eye = "driver_eye, check targets"
    assert others == {"van": {}, "bus": {"driver_eye": 2}, "van, check targets": {eye: 1}}
    words = CliRunner().invoke(errors, [path, "--by", "category"]).output
    assert words.count("Target: roof.\n") == 3
    assert "Rows not in the table: 2 of driver_eye. --by target covers each.\n" in words
    # check targets of the table's own target are told too
    plain = json.loads(CliRunner().invoke(errors, [path, "--json"]).output)
    assert plain["target"] == "roof"
    assert plain["other_targets"] == {"driver_eye": 2, "roof, check targets": 1, eye: 1}
    # several targets without roofs: no group chooses one for itself
    path = str(heights_csv(tmp_path, head + "headlight,van,0.61,0.60,ok,false\n" + bus))
    refused = CliRunner().invoke(errors, [path, "--by", "category"]).exception
    assert isinstance(refused, BadInput) and "headlight, driver_eye; use --by target" in refused.message


def test_errors_by_target_are_rounded_unless_asked_otherwise(tmp_path: Path) -> None:
    row = "roof,1.516,1.504,ok\n"
    path = str(heights_csv(tmp_path, "target,height_m,reference_height_m,status\n" + row))
    found = []
    for asked in ((), ("--round", "none")):
        done = CliRunner().invoke(errors, [path, "--json", "--by", "target", *asked])
        one = json.loads(done.output)["groups"]["roof"]
        found.append((one["rounding"], round(one["groups"]["overall"]["bias_m"], 6)))
    assert found == [("cm", 0.02), ("none", 0.012)]


@pytest.mark.parametrize(
    ("asked", "old", "new", "said"),
    [
        ((), "roof,daytime", "roof,Daytime", "Line 2: lighting is “Daytime”; use one of daytime, low_light."),
        ((), "roof,daytime", "Roof,daytime", "Line 2: target is “Roof”; use one of roof, driver_eye,"),
        (("--by", "colour"), "", "", "no column colour"),
    ],
)
def test_words_that_no_row_can_have_are_refused(
    asked: tuple[str, ...], old: str, new: str, said: str, tmp_path: Path
) -> None:
    """A row of a lighting that nobody knows would count overall alone, and say nothing of it."""
    path = str(heights_csv(tmp_path, TARGETS_CSV.replace(old, new, 1)))
    refused = CliRunner().invoke(errors, [path, *asked]).exception
    assert isinstance(refused, BadInput) and said in refused.message
