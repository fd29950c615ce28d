"""`sightline sightdistance` from the outside, as the contract says."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from tests.commands.test_distribution import written


def asked(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, Any]:
    assert main(["sightdistance", *arguments, "--json"]) == 0
    return dict(json.loads(capsys.readouterr().out))


def test_heights_and_a_distance(capsys: pytest.CaptureFixture[str]) -> None:
    found = asked(capsys, "--eye", "1.08", "--object", "0.60", "--distance", "185")
    assert found["constant"] == pytest.approx(100 * (math.sqrt(2.16) + math.sqrt(1.2)) ** 2, rel=1e-12)
    assert found["crest_k_m"] == pytest.approx(185**2 / found["constant"], rel=1e-12)
    assert not {"u_constant", "u_crest_k_m", "stopping_distance_m", "formula"} & set(found)


def test_a_speed_gives_its_stopping_distance_with_the_formula(capsys: pytest.CaptureFixture[str]) -> None:
    found = asked(capsys, "--eye", "1.08", "--object", "0.60", "--speed", "100")
    assert found["stopping_distance_m"] == pytest.approx(0.278 * 100 * 2.5 + 0.039 * 100**2 / 3.4)
    assert "0.278 V t + 0.039 V² / a" in found["formula"]
    assert found["crest_k_m"] == pytest.approx(found["stopping_distance_m"] ** 2 / found["constant"])
    assert (found["design_stopping_distance_m"], round(found["design_crest_k_m"])) == (185, 52)


def test_uncertainties_of_the_heights(capsys: pytest.CaptureFixture[str]) -> None:
    heights = ("--eye", "1.08", "--object", "0.60", "--distance", "185")
    found = asked(capsys, *heights, "--u-eye", "0.01", "--u-object", "0.02")
    up, down = (
        asked(capsys, "--eye", str(1.08 + d), "--object", "0.60")["constant"] for d in (0.0005, -0.0005)
    )
    higher, lower = (
        asked(capsys, "--eye", "1.08", "--object", str(0.60 + d))["constant"] for d in (0.0005, -0.0005)
    )
    u = math.hypot((up - down) / 0.001 * 0.01, (higher - lower) / 0.001 * 0.02)
    assert found["u_constant"] == pytest.approx(u, rel=1e-5)
    assert found["u_crest_k_m"] == pytest.approx(185**2 / found["constant"] ** 2 * u, rel=1e-5)
    alone = asked(capsys, *heights, "--u-eye", "0.01")
    assert alone["u_constant"] < u and "taken as exact" in alone["notes"][0]


def test_without_a_distance_there_is_no_k(capsys: pytest.CaptureFixture[str]) -> None:
    found = asked(capsys, "--eye", "1.08", "--object", "1.08", "--u-eye", "0.01", "--u-object", "0.01")
    assert found["crest_k_m"] is None and found["u_crest_k_m"] is None
    assert round(found["constant"]) == 864


def test_the_fastest_design_speed_is_one(capsys: pytest.CaptureFixture[str]) -> None:
    assert asked(capsys, "--eye", "1.08", "--object", "0.60", "--speed", "300")["distance_m"] > 1000


def test_k_and_lengths_have_the_intervals_of_the_heights(capsys: pytest.CaptureFixture[str]) -> None:
    """Limits recovered by Zou and Donner, here worked out by hand of both ends of both heights."""
    heights = ("--eye", "1.08", "--object", "0.60", "--speed", "100", "--grade-difference", "6")
    found = asked(capsys, *heights, "--u-eye", "0.01", "--u-object", "0.02", "--headlight", "0.6")
    roots = [
        [math.sqrt(height + side * 1.959963984540054 * u) - math.sqrt(height) for side in (-1, 1)]
        for height, u in ((1.08, 0.01), (0.60, 0.02))
    ]
    middle = math.sqrt(1.08) + math.sqrt(0.60)
    low = 200 * (middle - math.hypot(roots[0][0], roots[1][0])) ** 2
    high = 200 * (middle + math.hypot(roots[0][1], roots[1][1])) ** 2
    assert (found["constant_U95_low"], found["constant_U95_high"]) == pytest.approx((low, high), rel=1e-9)
    square = found["distance_m"] ** 2
    ends = (found["crest_k_m_U95_low"], found["crest_k_m_U95_high"])
    assert ends == pytest.approx((square / high, square / low), rel=1e-9)
    assert found["case"] == "S < L"
    assert found["crest_length_m_U95_high"] == pytest.approx(6 * ends[1], rel=1e-9)
    design = 185**2
    assert found["design_crest_k_m_U95_high"] == pytest.approx(design / low, rel=1e-9)
    assert "sag_k_m_U95_low" not in found  # the headlight's height was given as exact
    assert found["sag_k_m"] == pytest.approx(
        found["distance_m"] ** 2 / (200 * (0.6 + found["distance_m"] * math.tan(math.radians(1)))), rel=1e-9
    )


@pytest.mark.parametrize(
    ("kind", "speed_kmh", "distance_m", "design_m"),
    [
        ("decision_a", "100", 0.278 * 100 * 3.0 + 0.039 * 100**2 / 3.4, 200),
        ("intersection_left", "100", 0.278 * 100 * 7.5, 210),
        ("passing", "100", 320.0, 320),
    ],
)
def test_other_kinds(
    capsys: pytest.CaptureFixture[str], kind: str, speed_kmh: str, distance_m: float, design_m: float
) -> None:
    """AASHTO 2018: table 3-3 and equation 3-4, table 9-6, table 3-4."""
    found = asked(capsys, "--eye", "1.08", "--object", "1.08", "--speed", speed_kmh, "--kind", kind)
    assert found["kind"] == kind and "stopping_distance_m" not in found
    assert found["sight_distance_m"] == pytest.approx(distance_m)
    assert found["design_sight_distance_m"] == design_m
    assert found["design_crest_k_m"] == pytest.approx(design_m**2 / found["constant"])


def test_heights_of_a_file_are_the_figures_of_distribution(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    eyes, lamps = written(tmp_path, n=120), tmp_path / "lamps.csv"
    lamps.write_text(written(tmp_path, n=60).read_text("utf-8-sig"), "utf-8")
    eyes = written(tmp_path, n=120)
    assert main(["distribution", str(eyes), "--percentile", "10", "--json"]) == 0
    figure = json.loads(capsys.readouterr().out)["groups"]["all"]["percentiles"]["10"]
    found = asked(capsys, "--eye-heights", str(eyes), "--object", "0.6", "--speed", "100")
    assert (found["eye_m"], found["eye_m_U95_low"], found["eye_m_U95_high"]) == (
        figure["value"],
        figure["U95_low"],
        figure["U95_high"],
    )
    assert found["crest_k_m_U95_low"] < found["crest_k_m"] < found["crest_k_m_U95_high"]
    assert main(["sightdistance", "--eye", "1.08", "--object-heights", str(lamps)]) == 2
    assert "P5 needs 72; there are 60" in capsys.readouterr().err


def test_one_pose_behind_both_files_is_one_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Both percentiles rest on the same poses almost alone: the root of the constant is off by their sum."""
    heights = written(tmp_path).read_text("utf-8-sig").replace("0.011", "0.05")
    for name, text in (("one", heights), ("two", heights), ("apart", heights.replace("pose", "camera"))):
        (tmp_path / name).write_text(text, "utf-8")
    eyes = ("--eye-heights", str(tmp_path / "one"), "--object-percentile", "10")
    together = asked(capsys, *eyes, "--object-heights", str(tmp_path / "two"))
    apart = asked(capsys, *eyes, "--object-heights", str(tmp_path / "apart"))
    roots = [
        math.sqrt(together[f"{name}_U95_high"]) - math.sqrt(together[name]) for name in ("eye_m", "object_m")
    ]
    above = [math.sqrt(found["constant_U95_high"] / 200) for found in (apart, together)]
    middle = math.sqrt(together["constant"] / 200)
    assert above[0] - middle == pytest.approx(math.hypot(*roots), rel=1e-9)
    assert 0.9 * sum(roots) < above[1] - middle <= sum(roots)


def test_a_files_percentile_has_an_interval_and_no_u(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A u of the constant by the object's alone would leave out most of what its interval holds."""
    eyes = ("--eye-heights", str(written(tmp_path)))
    found = asked(capsys, *eyes, "--object", "0.6", "--u-object", "0.005", "--distance", "185")
    assert "constant_U95_low" in found and not {"u_constant", "u_crest_k_m"} & set(found)


def test_a_file_of_several_targets_has_no_percentile_of_eyes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    header, *rows = written(tmp_path).read_text("utf-8-sig").splitlines()
    path = tmp_path / "mixed.csv"
    cells = [f"{row},{'taillight' if i % 2 else 'driver_eye'}" for i, row in enumerate(rows)]
    path.write_text("\n".join([header + ",target", *cells]))
    assert main(["sightdistance", "--eye-heights", str(path), "--object", "0.6"]) == 2
    assert "mixed.csv has heights of driver_eye, taillight; give a file" in capsys.readouterr().err
    assert main(["distribution", str(path), "--json"]) == 0
    mixed = json.loads(capsys.readouterr().out)
    assert mixed["notes"] == [
        "all mixes heights of driver_eye, taillight; --by target computes each separately."
    ]
    assert main(["distribution", str(path), "--by", "target", "--json"]) == 0
    assert "notes" not in json.loads(capsys.readouterr().out)


def test_in_words(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = [
        "--eye",
        "1.18",
        "--object",
        "0.53",
        "--speed",
        "100",
        "--u-eye",
        "0.01",
        "--grade-difference",
        "6",
    ]
    assert main(["sightdistance", *arguments]) == 0
    said = capsys.readouterr().out
    for word in (
        "658.3 m",
        "184.2 m",
        "at the design distance of 185 m",
        "within the curve",
        "taken as exact",
    ):
        assert word in said


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        ("--eye 1.08 --object 0.6 --distance 185 --speed 100", "not both"),
        ("--eye 108 --object 60", "metres"),
        ("--eye nan --object 0.6", "metres"),
        ("--eye 1.08 --object 0.6 --distance -1", "sight distance"),
        ("--eye 1.08 --object 0.6 --speed 0", "design speed"),
        ("--eye 1.08 --object 0.6 --u-eye -0.1", "uncertainty"),
        ("--eye 1.08 --object 0.6 --u-eye 1e300", "uncertainty"),
        ("--eye 1.08 --object 0.6 --grade-difference 5", "--distance"),
        ("--eye 1.08", "--object"),
        ("--eye 1.08 --object 0.6 --headlight 0.6", "--distance"),
        (
            "--eye 1.08 --object 0.6 --distance 185 --kind passing",
            "--kind has no effect here; use it with --speed",
        ),
        ("--eye 1.08 --object 0.6 --u-headlight 0.1", "use it with --headlight"),
        ("--eye 1.08 --object 0.6 --eye-percentile 5", "use it with --eye-heights"),
        ("--eye 1.08 --object 0.6 --object-percentile 5", "use it with --object-heights"),
    ],
)
def test_bad_input_is_one_sentence(capsys: pytest.CaptureFixture[str], arguments: str, word: str) -> None:
    assert main(["sightdistance", *arguments.split(), "--json"]) == 2
    printed = capsys.readouterr()
    assert word in printed.err and printed.err.count("\n") == 1 and not printed.out
