"""The report as PDF: what it says, in which words, alike each time, whatever people call things."""

from __future__ import annotations

import hashlib
import io
import os
import re
import subprocess
import sys
from dataclasses import replace
from html import unescape
from pathlib import Path

import matplotlib
import numpy as np
import pytest
import typst
from PIL import Image

from sightline.export.report.conclusion import conclusion
from sightline.export.report.facts import ReportFacts, ScanFacts
from sightline.export.report.photos import as_svg
from sightline.export.report.report import report, sources
from sightline.export.report.results import rule_values
from sightline.export.report.sight import sight
from sightline.export.verdicts import VerdictCounts
from sightline.results.survey_statistics import StatisticsOptions
from sightline.scans.statistics.heights import ScannedHeights
from sightline.surveys.photographs.records import PhotographFile
from tests.export.report.pdf_text import words
from tests.export.report.sample import statistics
from tests.export.report.sample_facts import exclusion, facts

ROOT = Path(__file__).resolve().parents[3]
LONG = "a_name_without_any_place_to_break_it_" * 5
HOSTILE = (
    '#panic("x") $a^b$ *b* _e_ "q" \'s\' \\ `raw` @ref <label> // c /* d */ [x] {y} ~ = + - 1. ---',
    "<script>alert(1)</script> & &amp; %s {0} ${1}",
    "tab\tand\x00control\x1f, \u202eturned\u202c, half \ud800",
)


def flat(text: str) -> str:
    """Without any blanks: where lines end is the paper's affair."""
    return "".join(text.split())


@pytest.fixture(scope="module")
def example() -> ReportFacts:
    return facts(statistics(120, absent=("headlight", "roof")))


@pytest.fixture(scope="module")
def pdf(example: ReportFacts) -> bytes:
    return report(example)


def test_the_report_is_an_archival_and_accessible_pdf(pdf: bytes) -> None:
    assert pdf.startswith(b"%PDF-1.7")
    assert b"<pdfaid:part>2</pdfaid:part>" in pdf and b"<pdfuaid:part>1</pdfuaid:part>" in pdf
    assert b"CreationDate(D:20260504131209" in pdf


def test_the_report_says_what_was_found(example: ReportFacts, pdf: bytes) -> None:
    said = flat(words(pdf))
    result = example.statistics
    mae = result.errors.groups["low_light"].figures["mae_m"]
    assert mae is not None
    total = result.targets["driver_eye"].total
    assert total is not None
    rule = next(one for one in result.rules if one.standard.percent == 10.0)
    assert rule.verdict == "higher"
    half = next(one for one in total.percentiles if one.percent == 50.0)
    true = f"{half.value:.3f} {half.U95_low:.3f} to {half.U95_high:.3f} {half.value / 0.3048:.3f}"
    for expected in (
        example.survey,
        example.site,
        "2026-04-20 to 2026-05-03",
        f"{1000 * mae:.1f} (",
        f"P50 {true}",
        str(total.words),
        f"Driver’s eye: P10 of {rule.standard.vehicle_class} here: passenger cars, n = {rule.n} "
        f"{rule.standard.height_m:.3f} {rule.value_m:.3f}",
        f"{rule.verdict} (risk of error",
        "fx px",
        "lane-1-dusk.mkv",
        "The driver leans forward.",
        "sightline verify PACKAGE",
        example.audit_head,
        example.checksums["audit.csv"],
        "Misprints of the paper",
        "1.96",
        "There is no photograph of the set-up.",
        "is within the 95 % interval: the survey gives no reason to build crests differently.",
        "100 185 52.0 ",
    ):
        assert flat(expected) in said, expected


def test_heights_without_a_class_are_not_said_to_be_of_one(example: ReportFacts) -> None:
    result = example.statistics
    assert result.sight is not None
    eye, thing = result.sight
    some = replace(example, statistics=replace(result, sight=(eye, replace(thing, whose="all"))))
    expected = {
        "of the class that each rule names": example,
        "the eyes of the class that their rule names, the objects of all vehicles": some,
    }
    for words_of_it, of in expected.items():
        assert words_of_it in str((sight(of) or {})["classes"])


@pytest.mark.parametrize("n", [5, pytest.param(30, marks=pytest.mark.proof)])
def test_the_same_facts_give_the_same_bytes_in_another_process(n: int) -> None:
    few = {"n": n, "absent": ("taillight", "headlight", "roof")}
    program = (
        "import hashlib\n"
        "from sightline.export.report.report import report\n"
        "from tests.export.report.sample import statistics\n"
        "from tests.export.report.sample_facts import facts\n"
        f"print(hashlib.sha256(report(facts(statistics(**{few})))).hexdigest())"
    )
    far = {
        **os.environ,
        "PYTHONHASHSEED": "77",
        "TZ": "Asia/Kolkata",
        "LC_ALL": "C",
        "SOURCE_DATE_EPOCH": "1",
    }
    made = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, env=far, capture_output=True, text=True, check=True
    )
    assert made.stdout.strip() == hashlib.sha256(report(facts(statistics(**few)))).hexdigest()


@pytest.mark.parametrize("name", HOSTILE)
def test_names_come_out_as_text(name: str) -> None:
    shown = name.replace("\t", " ").replace("\x00", " ").replace("\x1f", " ").replace("\ud800", "\ufffd")
    shown = shown.replace("\u202e", "").replace("\u202c", "")
    few = ReportFacts(name, name, statistics(0), StatisticsOptions(), description=name)
    odd = replace(few, exclusions=(exclusion(1, name, "roof", name, name),), audit_head="ab" * 32)
    made = report(odd)
    said = flat(words(made))
    assert said.count(flat(shown)) >= 6
    assert flat(shown) in flat(words(report(_called(name))))
    title = re.search(rb"<dc:title>.*?<rdf:li[^>]*>(.*?)</rdf:li>", made, re.DOTALL)
    assert title and unescape(title.group(1).decode()) == f"{shown}, measurement report"


def _called(name: str) -> ReportFacts:
    """A survey in which everything is called that."""
    named = facts(statistics(0))
    (lens,), (pose, *_), (recording, *_) = named.calibrations, named.poses, named.recordings
    return replace(
        named,
        recordings=({**recording, "name": name, "camera": name},),
        calibrations=({**lens, "camera_name": name, "source": name, "warnings": (name,)},),
        poses=({**pose, "recording": name, "camera": name, "warnings": (name,)},),
        insets=({**named.insets[0], "note": name},),
    )


def test_other_scripts_are_set_from_the_fonts_at_hand() -> None:
    name = "سلام שלום Ολυμπία Москва 😀"
    made = report(ReportFacts(name, "", statistics(0), StatisticsOptions()))
    said = words(made)
    assert all(word in said for word in ("Ολυμπία", "Москва", "😀"))
    assert "שלום"[::-1] in said  # glyphs are written from left to right
    assert b"<pdfaid:part>2</pdfaid:part>" in made


def test_signs_that_no_font_has_are_no_boxes_but_a_mark_that_is_explained() -> None:
    made = report(ReportFacts("東京 Road", "도로", statistics(0), StatisticsOptions()))
    said = flat(words(made))
    assert flat("[…]† Road") in said and "東" not in said
    assert flat("characters of a script that this report’s fonts lack") in said
    assert b"<pdfaid:part>2</pdfaid:part>" in made
    assert "†" not in flat(words(report(ReportFacts("Åsgatan", "", statistics(0), StatisticsOptions()))))


def test_an_empty_survey_has_a_report_that_says_so() -> None:
    said = flat(words(report(ReportFacts("", "", statistics(0), StatisticsOptions()))))
    for expected in (
        "No accepted heights: drivers’ eyes, taillights’ lower edges.",
        "0 accepted heights of 0 vehicles",
        "No measurement uses a calibration yet.",
        "No accepted roof height has a reference height",
        "No measurements were excluded",
        "The audit trail is empty.",
    ):
        assert flat(expected) in said, expected


def test_not_covered_names_lots_and_line_scans(example: ReportFacts) -> None:
    heights = ScannedHeights("roof", 15, 2, 0, 1.5, 0.1, 1.5, 0.04)
    scans = ScanFacts(rigs=(), statistics=None, heights=(heights,))  # type: ignore[arg-type]
    judged = VerdictCounts(individual=20, by_lot=180, lots=2)
    found = " ".join(conclusion(replace(example, verdicts=judged, scans=scans)).not_covered)
    assert "180 accepted heights were not reviewed individually" in found
    assert "15 accepted heights of line scans" in found
    without = " ".join(conclusion(example).not_covered)
    assert "individually" not in without and "line scans" not in without


def test_what_is_missing_is_said(example: ReportFacts) -> None:
    day = replace(
        example, statistics=statistics(60, low_light=0.0, absent=("taillight", "headlight", "roof"))
    )
    said = flat(words(report(day)))
    assert flat("There are no accepted low light vehicles with a reference height.") in said
    assert flat("No accepted heights: taillight, lower edge, headlight, roof.") in said
    assert flat("P2 needs 183; there are 60") in said
    # taillights are absent, so there is a reason and no crest
    assert flat("no accepted heights of taillight") in said


@pytest.mark.parametrize(
    ("n", "eye"),
    [
        (8, "P50 1.216 1.113 to 1.253"),
        (4, "P50 – – –"),
    ],
)
def test_no_interval_is_spoken_of_that_is_not_there(n: int, eye: str) -> None:
    said = flat(words(report(facts(statistics(n, absent=("headlight", "roof"))))))
    assert flat(eye) in said
    none = f"P10 of drivers’ eyes (passenger cars, n = {n}) cannot be stated: P10 needs 36; there are {n}."
    assert flat(none) in said
    # and no crest is drawn from a percentile that the heights do not support
    assert flat("so K changes by") not in said


def test_a_long_table_repeats_its_head_and_no_word_leaves_the_page() -> None:
    left_out = tuple(exclusion(k, LONG if k % 9 == 0 else "a van", "roof", LONG) for k in range(70))
    few = ReportFacts(LONG, LONG, statistics(0), StatisticsOptions(), description=LONG, exclusions=left_out)
    long = replace(few, exclusions_total=900)
    said = words(report(long))
    assert said.count("\nReason\n") >= 3
    assert flat("900 measurements are excluded from the results. The first 70 are listed here.") in flat(said)
    fonts = os.path.join(matplotlib.get_data_path(), "fonts", "ttf")
    pages = typst.compile(sources(long), font_paths=[fonts], ignore_system_fonts=True, format="png", ppi=36)
    assert len(pages) > 3
    for page in pages:
        grey = np.asarray(Image.open(io.BytesIO(page)).convert("L"))
        margin = round(15 / 210 * grey.shape[1])
        assert grey[:, :margin].min() > 240 and grey[:, -margin:].min() > 240


def test_feet_and_inches() -> None:
    said = words(report(facts(statistics(30, absent=("taillight", "headlight", "roof")), unit="ft")))
    assert "True heights ft" in " ".join(said.split()) and flat("MAE (in)") in flat(said) and "3.54" in said


def test_photographs_are_turned_upright_and_tell_no_place() -> None:
    picture = Image.new("RGB", (300, 200), "white")
    exif = Image.Exif()
    exif[0x0112] = 6  # the camera stood on its side
    exif[0x010E] = "48.85 N, 2.35 E"
    out = io.BytesIO()
    picture.save(out, "JPEG", exif=exif)
    made = as_svg(out.getvalue())
    assert made is not None and b'width="200" height="300"' in made
    assert b"48.85" in out.getvalue() and b"48.85" not in made
    assert as_svg(b"no picture") is None


def test_a_photograph_stands_in_the_report_and_a_broken_one_is_named() -> None:
    out = io.BytesIO()
    Image.new("RGB", (300, 200), "grey").save(out, "PNG")
    photos = (PhotographFile("From the verge", out.getvalue()), PhotographFile("Torn", out.getvalue()[:90]))
    made = report(replace(ReportFacts("A", "", statistics(0), StatisticsOptions()), photos=photos))
    said = flat(words(made))
    assert flat("Figure 1 From the verge") in said
    assert flat("The photograph “Torn” cannot be read as PNG or JPEG.") in said
    assert made.count(b"/Subtype/Image") >= 1


def test_heights_of_chosen_classes_are_said_to_be_of_those(example: ReportFacts) -> None:
    chosen = replace(example, statistics=replace(example.statistics, of_chosen=True))
    for words_of_it, of in {
        "passenger cars": example,
        "passenger cars of the chosen classes": chosen,
    }.items():
        (rule, *_) = of.statistics.rules
        assert f"here: {words_of_it}, n" in rule_values(rule, of.statistics.of_chosen)["read"]
        assert f"({words_of_it}, n" in "".join(conclusion(of).found)
    assert (sight(chosen) or {})["classes"] == "of the chosen classes within the class that each rule names"
