"""Two surveys beside each other on the statistics page: what differs is told, what is noise is not."""

from dataclasses import fields

import numpy as np

from sightline.results.measured_columns_query import Measured
from sightline.results.survey_comparison import PERCENTS, compared_surveys
from sightline.results.survey_statistics import height_sample

N = 300


def measured(moved_m: float, surveys: tuple[int, ...] = (3, 7)) -> Measured:
    """Roofs of as many surveys, the last one's higher by so much, each with a random error of 10 mm."""
    rng = np.random.default_rng(5)
    count = N * len(surveys)
    columns = {one.name: np.zeros(count, dtype=np.int64) for one in fields(Measured)}
    columns |= {name: np.zeros(count) for name in columns if name.endswith("_m")}
    columns["survey_id"] = np.repeat(surveys, N)
    columns["pose_id"] = columns["survey_id"]
    height_m = rng.normal(1.5, 0.06, count) + rng.normal(0.0, 0.010, count)
    columns["height_m"] = height_m + moved_m * (columns["survey_id"] == surveys[-1])
    columns["u_height_m"] = np.full(count, np.hypot(0.010, 0.003))
    columns["u_clicks_m"] = np.full(count, 0.010)
    return Measured(**columns)


def compared(of: Measured, names: dict[int, str] | None = None):  # type: ignore[no-untyped-def]
    rows = {
        "roof": np.ones(len(of.height_m), dtype=bool),
        "taillight": np.zeros(len(of.height_m), dtype=bool),
    }
    return compared_surveys(of, rows, names or {3: "2015", 7: "2025"}, height_sample)


def test_surveys_that_differ_are_told_apart() -> None:
    found = compared(measured(0.05))
    assert (found.first.name, found.second.name) == ("2015", "2025")
    assert [one.percent for one in found.figures] == [*PERCENTS, None]
    assert {one.target for one in found.figures} == {"roof"}, "no taillight was measured"
    mean = found.figures[-1]
    assert mean.verdict == "higher" and mean.U95_low_m < 0.05 < mean.U95_high_m
    assert (mean.n_first, mean.n_second) == (N, N)


def test_noise_is_not_called_a_difference() -> None:
    found = compared(measured(0.0))
    assert {one.verdict for one in found.figures if one.percent in (10.0, 50.0, 90.0, None)} == {
        "not_told_apart"
    }


def test_one_survey_or_three_are_not_compared() -> None:
    assert compared(measured(0.0, (3,)), {3: "2015"}) is None
    assert compared(measured(0.0, (3, 7, 9)), {3: "a", 7: "b", 9: "c"}) is None
