"""Figures as SVG: what is drawn, in greys and paths only, always the same bytes, whatever a name holds."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.axes import Axes

from sightline.enums import LengthUnit, StatisticsTarget
from sightline.export.crops import label_of
from sightline.export.report import labels, marks
from sightline.export.report.canvas import FAINT, FULL, HALF, Drawing, svg
from sightline.export.report.error_figures import error_figures
from sightline.export.report.figures import drawings, figures
from sightline.export.report.height_figures import height_figures
from sightline.export.report.marks import MAIN
from sightline.export.report.said import speaking
from sightline.export.report.units import format_fixed, limit
from sightline.export.scans import TABLES as SCAN_TABLES
from sightline.export.statistics_csv import TABLES as STATISTICS_TABLES
from sightline.messages.said import Said
from sightline.results.survey_statistics import Statistics, StatisticsOptions, standards_of
from sightline.statistics.agreement import Trend
from sightline.statistics.distributions import ecdf, sorted_values
from sightline.statistics.errors import Interval
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Grouping
from tests.export.report.sample import statistics

ERRORS = {"absolute-error-ecdf", "relative-error-ecdf", "signed-error-density", "error-against-height"}
_SVG = "{http://www.w3.org/2000/svg}"


EYES = ("taillight", "headlight", "roof")  # what a survey of eyes alone lacks


@pytest.fixture(scope="module")
def drawn() -> dict[str, Drawing | str]:
    return drawings(statistics(80))


def figures_of_all(result: Statistics, name: StatisticsTarget) -> dict[str, Drawing | str]:
    """A target's figures but those by group, on which no standard is named."""
    target = replace(result.targets[name], groups={})
    return height_figures(name, target, standards_of(result.standards, name), "m")


def test_every_figure_of_the_page_is_drawn(drawn: dict[str, Drawing | str]) -> None:
    there = {name for name, one in drawn.items() if isinstance(one, Drawing)}
    heights = {
        f"{target}-{kind}"
        for target in ("driver_eye", "taillight", "roof")
        for kind in ("ecdf", "density", "by-category", "by-lighting")
    }
    assert there == ERRORS | heights | {"crest-k", "lateral-position"}
    assert isinstance(drawn["headlight-ecdf"], str) and isinstance(drawn["headlight-density"], str)


def test_figures_are_svg_in_greys_whose_words_need_no_font(drawn: dict[str, Drawing | str]) -> None:
    for one in drawn.values():
        if isinstance(one, str):
            continue
        root = ElementTree.fromstring(one.svg)
        assert root.findtext(f"{_SVG}title") == one.title
        assert not root.findall(f".//{_SVG}text")
        colours = re.findall(rb"(?:fill|stroke): #([0-9a-f]{6})", one.svg)
        assert colours and all(c[:2] == c[2:4] == c[4:] for c in colours)
        assert b"Date" not in one.svg and b"date" not in one.svg


def test_the_same_result_gives_the_same_bytes(drawn: dict[str, Drawing | str]) -> None:
    again = figures(statistics(80, absent=EYES))
    assert len(again) == 9
    for name, found in again.items():
        before = drawn[name]
        assert isinstance(before, Drawing) and found == before.svg, name


def of_eyes(result: Statistics, unit: LengthUnit = "m", *, groups: bool = False) -> dict[str, Drawing | str]:
    """The figures of errors and of eyes' heights, of which those by group where they are looked at."""
    errors = {} if groups else error_figures(result.errors, unit)
    eyes = result.targets["driver_eye"]
    limits = standards_of(result.standards, "driver_eye")
    target = eyes if groups else replace(eyes, groups={})
    return {**errors, **height_figures("driver_eye", target, limits, unit)}


def test_feet_are_drawn_in_feet_and_inches() -> None:
    result = statistics(40, absent=EYES)
    metres, feet = of_eyes(result), of_eyes(result, "ft")
    for name in ("absolute-error-ecdf", "driver_eye-ecdf"):
        assert metres[name] != feet[name]
    density = feet["signed-error-density"]
    assert isinstance(density, Drawing) and "\u00a0in " in density.caption


def test_a_slope_in_inches_per_foot_is_as_fine_as_one_in_millimetres_per_metre() -> None:
    errors = statistics(80).errors
    assert isinstance(errors.trend, Trend)
    flat = replace(errors.trend, slope=-0.0043, slope_ci95=Interval(-0.0081, -0.0005))
    said_of: dict[LengthUnit, str] = {
        "m": "−4.3 mm per m (−8.1 to −0.5)",
        "ft": "−0.052 in per ft (−0.097 to −0.006)",
    }
    for unit, words in said_of.items():
        one = error_figures(replace(errors, trend=flat), unit)["error-against-height"]
        assert isinstance(one, Drawing)
        assert words in one.caption.replace("\u00a0", " ")


def test_without_anything_there_are_sentences_and_no_figures() -> None:
    nothing = statistics(0)
    assert figures(nothing) == {}
    assert all(isinstance(one, str) and one.endswith(".") for one in drawings(nothing).values())


@pytest.mark.parametrize(("n", "said"), [(1, "there is 1"), (5, "there are 5")])
def test_few_vehicles_are_drawn_and_what_cannot_be_is_a_sentence(n: int, said: str) -> None:
    found = drawings(statistics(n, low_light=0.0, absent=EYES))
    assert isinstance(found["driver_eye-ecdf"], Drawing)
    assert found["signed-error-density"] == f"A density needs at least 10 vehicles; {said}."


def test_a_band_is_drawn_for_thirty_vehicles_and_more_and_the_caption_says_which() -> None:
    for n, banded in ((29, False), (30, True)):
        found = of_eyes(statistics(n, low_light=0.0, absent=EYES))
        for name in ("driver_eye-ecdf", "driver_eye-density", "absolute-error-ecdf", "signed-error-density"):
            one = found[name]
            assert isinstance(one, Drawing)
            assert (b"fill-opacity: 0.11" in one.svg or b"opacity: 0.11" in one.svg) == banded, name
            assert ("Band: 95 %" in one.caption) == banded, one.caption
            assert ("sampling only." in one.caption) == banded, one.caption
            assert ("No band for fewer than 30 vehicles." in one.caption) != banded, one.caption


@pytest.mark.parametrize(
    "name", ["absolute-note", "density-note", "target-ecdf-note", "target-density-note", "percentiles-note"]
)
def test_the_pages_say_that_bands_include_sampling_only(name: str) -> None:
    """Heights that share errors lie beside the truth together; no band of their shares or density knows."""
    values = {"groups": "", "bandwidths": ""}
    assert "sampling only" in str(Said(f"statistics-{name}", **values))


def test_a_package_says_that_bands_include_sampling_only() -> None:
    edges = [
        one
        for table in (*STATISTICS_TABLES, *SCAN_TABLES)
        for one in table.columns
        if "edge of the" in one.meaning
    ]
    assert len(edges) >= 12
    assert all("sampling only" in one.meaning for one in edges), [one.meaning for one in edges]


def test_standards_that_a_figure_does_not_reach_are_counted_below_it() -> None:
    low = Standard("Far below", "object_stopping", 0.1, "me")
    before, after = (
        figures_of_all(statistics(9, choices=StatisticsOptions(own_standards=own)), "taillight")[
            "taillight-ecdf"
        ]
        for own in ((), (low,))
    )
    assert isinstance(before, Drawing) and isinstance(after, Drawing)
    counts = [re.search(r"(\d+) standards? off scale", one.caption) for one in (before, after)]
    away = [int(one[1]) if one else 0 for one in counts]
    assert away[1] == away[0] + 1 and "Far below" not in after.caption


def test_a_group_of_few_vehicles_shows_each_of_them() -> None:
    few = of_eyes(statistics(12, absent=EYES), groups=True)["driver_eye-by-category"]
    assert isinstance(few, Drawing) and "each vehicle (stroke)" in few.caption
    each = re.findall(rb'<use [^>]*style="[^>]*stroke: #666666; stroke-width: 0\.8"', few.svg)
    assert len(each) == 12


def test_names_with_signs_are_drawn_as_they_are() -> None:
    names = ("A $x^2$ & <b>", "A x^2 & <b>")
    own = (Standard("Own $limit$", "eye_car", 1.1, "me"),)
    group = Grouping(np.arange(40) % 2, names)
    result = statistics(40, choices=StatisticsOptions(own_standards=own), site=group, absent=EYES)
    found = of_eyes(result, groups=True)
    by_site = found["driver_eye-by-site"]
    assert isinstance(by_site, Drawing) and "Own $limit$ 1.10" in by_site.caption
    ElementTree.fromstring(by_site.svg)
    # As mathematics the first name would lose its dollar signs, whose glyph the second name has not.
    assert by_site.svg.count(b"DejaVuSans-24") > 0


def test_a_large_sample_is_thinned_without_visible_change() -> None:
    ordered = sorted_values(np.random.default_rng(3).normal(1.2, 0.07, 200_000))
    thin = ecdf(ordered)
    assert thin is not None
    kept: list[labels.Named] = []
    picture = svg(lambda axes: kept.append(marks.steps(axes, thin, MAIN, 1.0)), "A large sample", FULL)
    at = np.linspace(ordered[10], ordered[-10], 4001)
    true = 100.0 * np.searchsorted(ordered, at, side="right") / len(ordered)
    curve = kept[0]
    shown = curve.y[np.searchsorted(curve.x, at, side="right") - 1]
    height_mm = FULL.height - FULL.top - FULL.bottom
    assert np.abs(shown - true).max() / 100.0 * height_mm < 0.15  # a third of a line's width
    few = ecdf(ordered[::100])
    assert few is not None
    small = svg(lambda axes: kept.append(marks.steps(axes, few, MAIN, 1.0)), "A small sample", FULL)
    assert len(picture) < 1.1 * len(small)


def test_words_stand_beside_their_curves_and_not_on_any() -> None:
    x = np.linspace(0.0, 1.0, 50)
    curves = [labels.Named(x, x, "first of two"), labels.Named(x + 0.3, x, "second of two")]
    boxes = []

    def draw(axes: Axes) -> None:
        axes.set(xlim=(-0.5, 2.0), ylim=(0, 1))
        assert labels.label(axes, curves)
        texts = [one.get_window_extent() for one in axes.texts]
        paths = [axes.transData.transform(np.column_stack([one.x, one.y])) for one in curves]
        boxes.extend((box, path) for box in texts for path in paths)

    svg(draw, "Two curves", HALF)
    assert len(boxes) == 4
    for box, path in boxes:
        inside = (path > [box.x0, box.y0]).all(axis=1) & (path < [box.x1, box.y1]).all(axis=1)
        assert not inside.any()


@pytest.mark.parametrize("language", ["fr", pytest.param("en", marks=pytest.mark.proof)])
def test_names_of_standards_stand_on_no_curve_and_on_no_rule(
    language: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[tuple[Axes, marks.Limit]] = []

    def draw(axes: Axes, limits: Sequence[marks.Limit]) -> None:
        limits_drawn(axes, limits)
        names = [one.word for one in limits]
        frame, words = axes.get_window_extent(), [one for one in axes.texts if one.get_text() in names]
        assert len(words) == len(names)
        rules = [one for one in axes.lines if one.get_color() == FAINT]
        for word, own in zip(words, rules, strict=True):
            box = word.get_window_extent()
            assert box.y0 >= frame.y1 and axes.figure.bbox.contains(box.x1 - 0.5, box.y1 - 0.5)
            others = [one.get_window_extent() for one in (*rules, *words) if one not in (word, own)]
            assert not any(box.overlaps(other) for other in others), word.get_text()
            drawn.append((axes, limits[0]))

    limits_drawn = marks.limits
    monkeypatch.setattr(marks, "limits", draw)
    with speaking(language):
        for result in (statistics(9), statistics(400)):
            for name in result.targets:
                figures_of_all(result, name)
    assert len(drawn) > 10


def test_a_word_that_no_place_tells_from_the_next_curve_is_not_written() -> None:
    x = np.linspace(0.0, 1.0, 50)

    def draw(axes: Axes) -> None:
        axes.set(xlim=(-0.5, 1.5), ylim=(0, 1))
        near = [labels.Named(x + 0.02 * n, x, f"curve {n}") for n in range(3)]
        assert not labels.label(axes, near)
        assert labels.label(axes, [near[0], labels.Named(x + 0.3, x, "far curve")])

    svg(draw, "Three curves", HALF)


def test_without_room_no_word_is_written() -> None:
    x = np.linspace(0.0, 1.0, 50)

    def draw(axes: Axes) -> None:
        axes.set(xlim=(0, 1), ylim=(0, 1))
        assert not labels.label(axes, [labels.Named(x, x, "far too long a word " * 8)])
        assert not axes.texts

    svg(draw, "No room", HALF)


def test_numbers_for_people() -> None:
    assert format_fixed(-0.0004, 3) == "0.000"
    assert format_fixed(-1.25, 1, signed=True) == "−1.3"
    # as the pages print them (frontend/src/core/units.test.ts), though 1.1475 in binary lies below the half
    assert [format_fixed(value, 3) for value in (1.1475, 1.0005, 1.2345)] == ["1.148", "1.001", "1.235"]
    assert [format_fixed(value, 1) for value in (2.15, 0.35)] == ["2.2", "0.4"]
    assert label_of("roof", 1.1475, 0.0125) == "roof 1.148 ± 0.013 m"
    assert [limit(1.08, "m"), limit(1.105, "m"), limit(1.08, "ft")] == [
        "1.08\u00a0m",
        "1.105\u00a0m",
        "3.54\u00a0ft",
    ]
