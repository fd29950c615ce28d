"""`sightline distribution`: the contract's object, groups, defaults, and its refusals."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from sightline.cli import main

pytestmark = pytest.mark.once
HEADER = "id,height_m,u_height_m,status,lighting,u_random_m,shared_group,u_shared_m,site"


def written(tmp_path: Path, header: str = HEADER, n: int = 240, more: str = "") -> Path:
    rng = np.random.default_rng(5)
    heights = rng.normal(1.16, 0.06, n)
    cells = {
        "id": [str(i) for i in range(n)],
        "height_m": [f"{one:.6f}" for one in heights],
        "u_height_m": ["0.015"] * n,
        "status": ["ok"] * n,
        "lighting": ["daytime" if i % 3 else "low_light" for i in range(n)],
        "u_random_m": ["0.01"] * n,
        "shared_group": [f"pose {i % 4}" for i in range(n)],
        "u_shared_m": ["0.011"] * n,
        "site": [f"site {i % 4}" for i in range(n)],
    }
    names = header.split(",")
    rows = [",".join(cells[name][i] for name in names) for i in range(n)]
    path = tmp_path / "heights.csv"
    path.write_text("\ufeff" + "\r\n".join([header, *rows]) + "\r\n" + more, encoding="utf-8")
    return path


def answer(capsys: pytest.CaptureFixture[str], *arguments: object) -> dict:
    assert main(["distribution", *map(str, arguments), "--json"]) == 0
    return json.loads(capsys.readouterr().out)["groups"]


def test_groups_figures_and_rows_without_a_height(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, n=480, more=",,,not_measurable,daytime,,,,\r\n")
    found = answer(capsys, path, "--by", "lighting", "--percentile", "2.5,10, 50")
    assert {name: one["n"] for name, one in found.items()} == {"low_light": 160, "daytime": 320}
    for one in found.values():
        assert list(one["percentiles"]) == ["2.5", "10", "50"]
        for figure in (one["mean_m"], one["sd_m"], *one["percentiles"].values()):
            assert figure["U95_low"] < figure["value"] < figure["U95_high"]
        assert one["holds"] == ["sampling", "sites", "shared_errors", "random_error"]
    whole = answer(capsys, path, "--percentile", "10")["all"]
    lines = path.read_text("utf-8-sig").splitlines()[1:-1]
    heights = [float(line.split(",")[1]) for line in lines]
    assert whole["percentiles"]["10"]["raw"] == pytest.approx(np.percentile(heights, 10))


def test_a_shared_error_widens_and_u_height_is_the_random_part_by_default(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    plain = answer(capsys, written(tmp_path, "height_m,u_height_m,status"), "--percentile", "10")["all"]
    assert plain["holds"] == ["sampling", "random_error"]
    spread = np.hypot(plain["sd_m"]["value"], 0.015)
    shared = answer(capsys, written(tmp_path, HEADER.removesuffix(",site")), "--percentile", "10")["all"]
    assert np.hypot(shared["sd_m"]["value"], np.hypot(0.01, 0.011 * np.sqrt(0.75))) == pytest.approx(spread)
    width = {
        name: one["mean_m"]["U95_high"] - one["mean_m"]["U95_low"]
        for name, one in (("plain", plain), ("shared", shared))
    }
    assert width["shared"] ** 2 - width["plain"] ** 2 == pytest.approx((3.92 * 0.011 / 2) ** 2, rel=0.05)


def test_the_plain_table_says_what_the_intervals_hold(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["distribution", str(written(tmp_path))]) == 0
    said = capsys.readouterr().out
    assert "P2.5" in said and "mean" in said and "differences between 4 sites" in said


@pytest.mark.parametrize(
    ("header", "arguments", "word"),
    [
        (HEADER, ["--percentile", "10,x"], "“x”"),
        (HEADER, ["--percentile", "100"], "“100”"),
        (HEADER, ["--by", "colour"], "colour"),
        ("height_m,status", [], "u_height_m"),
        ("u_height_m,status", [], "height_m"),
        ("height_m,u_height_m,shared_group", [], "u_shared_m"),
    ],
)
def test_bad_input_is_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], header: str, arguments: list[str], word: str
) -> None:
    assert main(["distribution", str(written(tmp_path, header)), *arguments, "--json"]) == 2
    printed = capsys.readouterr()
    assert word in printed.err and printed.err.count("\n") == 1 and printed.out == ""


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("height_m,u_height_m,status\n1.2,-0.01,ok\n", "line 2"),
        ("height_m,u_height_m,status\n1.2,0.01,ok\nabc,0.01,ok\n", "line 3"),
        ("height_m,u_height_m,status\n,,not_measurable\n", "no row with a height"),
        ("height_m,u_height_m,shared_group,u_shared_m\n1.2,0.01,a,\n", "u_shared_m"),
        ("", "height_m"),
        ("height_m,u_height_m,status\n1,15,0.01,ok\n", "line 2 has 4 cells, but the header names 3"),
        ("height_m,u_height_m,status\n1.2,0.01,ok\n1.2,0.01\n", "line 3 has 2 cells"),
        ("height_m,height_m,u_height_m\n1.2,1.3,0.01\n", "line 1: the column height_m is named twice"),
        ('height_m,u_height_m,status\n"1.2,0.01,ok\n', "line 2: a quote is not closed"),
    ],
)
def test_rows_that_cannot_be_are_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, word: str
) -> None:
    path = tmp_path / "heights.csv"
    path.write_text(text)
    assert main(["distribution", str(path)]) == 2
    assert word in capsys.readouterr().err


def two_years(tmp_path: Path, moved_m: float, n: int = 400, pose_mm: float = 4.0, seed: int = 7) -> Path:
    """Heights of two years whose fleets lie `moved_m` apart, each year with the error of its own pose."""
    rng = np.random.default_rng(seed)
    lines = ["height_m,u_height_m,status,u_random_m,shared_group,u_shared_m,year"]
    for year, shift in (("2020", 0.0), ("2026", moved_m)):
        pose = rng.normal(0.0, pose_mm / 1000)
        for height in rng.normal(1.16 + shift, 0.06, n) + pose + rng.normal(0.0, 0.01, n):
            lines.append(f"{height:.6f},0.0108,ok,0.01,pose {year},{pose_mm / 1000},{year}")
    path = tmp_path / "years.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


def compared(capsys: pytest.CaptureFixture[str], path: Path, pair: str = "2020,2026") -> dict:
    asked = ["distribution", str(path), "--by", "year", "--compare", pair, "--percentile", "10,50"]
    assert main([*asked, "--json"]) == 0
    return json.loads(capsys.readouterr().out)["comparison"]


def test_two_years_that_differ_are_told_apart_and_two_alike_are_not(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    apart = compared(capsys, two_years(tmp_path, 0.05))
    assert (apart["first"], apart["second"]) == ("2020", "2026")
    for one in (*apart["percentiles"].values(), apart["mean_m"]):
        assert one["verdict"] == "higher" and one["U95_low"] < 0.05 < one["U95_high"]
    back = compared(capsys, two_years(tmp_path, 0.05), "2026,2020")
    assert back["mean_m"]["verdict"] == "lower"
    assert back["mean_m"]["value"] == pytest.approx(-apart["mean_m"]["value"], abs=1e-12)
    alike = compared(capsys, two_years(tmp_path, 0.0))
    assert {one["verdict"] for one in alike["percentiles"].values()} == {"not_told_apart"}


# 1 of 20 and 3 of 60 are expected; more than these have a probability of 1.6 % and 0.4 %
@pytest.mark.parametrize(("surveys", "most"), [(20, 3), pytest.param(60, 8, marks=pytest.mark.proof)])
def test_years_alike_are_taken_for_different_as_seldom_as_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], surveys: int, most: int
) -> None:
    """Shared errors of 10 mm: intervals of sampling alone (7 mm of the mean) would say so most times."""
    found = [
        compared(capsys, two_years(tmp_path, 0.0, n=150, pose_mm=10.0, seed=seed))["mean_m"]["verdict"]
        for seed in range(surveys)
    ]
    assert sum(one != "not_told_apart" for one in found) <= most


def test_a_comparison_of_few_heights_says_what_is_missing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = compared(capsys, two_years(tmp_path, 0.0, n=5))
    one = found["percentiles"]["10"]
    assert one["value"] is None and one["verdict"] is None and one["reason"] == "P10 needs 36; there are 5"
    assert (
        main(["distribution", str(two_years(tmp_path, 0.0)), "--by", "year", "--compare", "2020,2026"]) == 0
    )
    assert "2026 less 2020" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--compare", "2020,2026"], "needs --by"),
        (["--by", "year", "--compare", "2020"], "two different values"),
        (["--by", "year", "--compare", "2020,2020"], "two different values"),
        (["--by", "year", "--compare", "2020,1999"], "has 1999 in year"),
    ],
)
def test_a_comparison_that_cannot_be_is_refused(
    arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["distribution", str(two_years(tmp_path, 0.0)), *arguments]) == 2
    printed = capsys.readouterr()
    assert said in printed.err and printed.err.count("\n") == 1 and not printed.out


def test_two_heights_have_no_spread_that_could_be_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "heights.csv"
    path.write_text("height_m,u_height_m,status\n1.40,0.01,ok\n1.50,0.01,ok\n")
    assert answer(capsys, path)["all"]["sd_m"]["value"] is None
    assert main(["distribution", str(path)]) == 0
    (line,) = (line for line in capsys.readouterr().out.splitlines() if line.strip().startswith("SD"))
    assert line.split()[:3] == ["SD", "–", "-"] and "needs 3 heights" in line
