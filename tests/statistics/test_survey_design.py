"""Designs and weights held against R's package `survey` 4.1-1 on the examples of its own manual.

The data are samples of California schools of 2000 (Academic Performance Index, public record of the State's
Department of Education) as `data(api)` has them: clusters of districts, strata of school types.
The figures beside each name were made with R (`svydesign`, `svymean`, `svytotal`, `postStratify`, `rake`);
no R is needed to run this.
"""

import csv
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from sightline.statistics.survey_design import Design, weighting_effect
from sightline.statistics.survey_weights import Margin, calibrate_weights, residuals
from tests.statistics.textbook import mean, total

DATA = Path(__file__).parent / "data"
Floats = NDArray[np.float64]
CLOSE = {"rel": 1e-9}
TYPES = {"E": 4421.0, "H": 755.0, "M": 1018.0}
SCHOOLWIDE = {"No": 1072.0, "Yes": 5122.0}


class Schools:
    """One sample, by column; enrolments that are not known are left out as R's na.rm does."""

    def __init__(self, name: str) -> None:
        with (DATA / f"{name}.csv").open(encoding="utf-8", newline="") as file:
            self._rows = list(csv.DictReader(file))

    def numbers(self, name: str) -> Floats:
        return np.array([float(row[name]) if row[name] != "NA" else np.nan for row in self._rows])

    def codes(self, name: str) -> NDArray[np.int64]:
        found = np.unique([row[name] for row in self._rows], return_inverse=True)[1]
        return found.astype(np.int64)

    def margin(self, name: str, there: dict[str, float]) -> Margin:
        share = np.array([there[word] for word in sorted(there)])
        return Margin(self.codes(name), share / share.sum())


def clusters(weight: Floats | None = None, margins: tuple[Margin, ...] = (), there: float = 757.0) -> Design:
    schools = Schools("apiclus1")
    own = schools.numbers("pw") if weight is None else weight
    one = np.zeros(len(own), dtype=np.int64)
    drawn = schools.numbers("pw")
    return Design(own, one, schools.codes("dnum"), np.array([there]), margins=margins, drawn=drawn)


def strata() -> Design:
    schools = Schools("apistrat")
    weight, stratum = schools.numbers("pw"), schools.codes("stype")
    there = np.array([schools.numbers("fpc")[stratum == h][0] for h in range(3)])
    return Design(weight, stratum, np.arange(len(weight)), there)


def test_clusters_of_a_finite_number() -> None:
    schools = Schools("apiclus1")
    found = mean(clusters(), schools.numbers("api00"))
    assert found.value == pytest.approx(644.1693989071, **CLOSE)
    assert found.u == pytest.approx(23.54224069378, **CLOSE)
    enrolled = total(clusters(), schools.numbers("enroll"))
    assert (enrolled.value, enrolled.u) == pytest.approx((3404940.134529, 932235.0270412), **CLOSE)
    unknown = mean(clusters(there=np.inf), schools.numbers("api00"))
    assert unknown.u == pytest.approx(23.77901072089, **CLOSE)


def test_strata_of_schools_drawn_one_by_one() -> None:
    schools = Schools("apistrat")
    found = mean(strata(), schools.numbers("api00"))
    assert (found.value, found.u) == pytest.approx((662.2873631593, 9.408940802785), **CLOSE)
    enrolled = total(strata(), schools.numbers("enroll"))
    assert (enrolled.value, enrolled.u) == pytest.approx((3687177.532438, 114641.7161008), **CLOSE)


def test_weights_that_differ_widen_a_mean() -> None:
    assert weighting_effect(np.array([1.0, 1.0, 2.0])) == pytest.approx(18.0 / 16.0)


def test_post_stratification_by_school_type() -> None:
    schools = Schools("apiclus1")
    margin = schools.margin("stype", TYPES)
    weight = calibrate_weights(schools.numbers("pw"), (margin,))
    assert weight is not None
    design = clusters(weight, (margin,))
    found = mean(design, schools.numbers("api00"))
    assert (found.value, found.u) == pytest.approx((642.3107882116, 23.92048644509), **CLOSE)
    scaled = clusters(weight * (6194.0 / weight.sum()), (margin,))
    enrolled = total(scaled, schools.numbers("enroll"))
    assert (enrolled.value, enrolled.u) == pytest.approx((3680892.945119, 406292.6362948), **CLOSE)


def test_raking_by_two_margins() -> None:
    schools = Schools("apiclus1")
    margins = (schools.margin("stype", TYPES), schools.margin("sch.wide", SCHOOLWIDE))
    weight = calibrate_weights(schools.numbers("pw"), margins)
    assert weight is not None
    weight = weight * (6194.0 / weight.sum())
    first = (50.3294011160, 29.8706754927, 29.8706754927, 29.8706754927)
    assert weight[:4] == pytest.approx(first, rel=1e-8)
    found = mean(clusters(weight, margins), schools.numbers("api00"))
    assert found.value == pytest.approx(641.2303209268, rel=1e-8)
    assert found.u == pytest.approx(23.70361688792, **CLOSE)


def test_margins_that_contradict_each_other_have_no_weights() -> None:
    code = np.array([0, 0, 1, 1])
    same = Margin(code, np.array([0.5, 0.5])), Margin(code, np.array([0.7, 0.3]))
    assert calibrate_weights(np.ones(4), same) is None


def test_residuals_hold_nothing_of_the_margins() -> None:
    rng = np.random.default_rng(1)
    margins = (
        Margin(rng.integers(0, 3, 500), np.array([0.2, 0.3, 0.5])),
        Margin(rng.integers(0, 2, 500), np.array([0.6, 0.4])),
    )
    weight = rng.uniform(1.0, 3.0, 500)
    found = residuals(rng.normal(size=500), weight, margins)
    for one in margins:
        assert np.bincount(one.code, weight * found) == pytest.approx(np.zeros(len(one.share)), abs=1e-7)
