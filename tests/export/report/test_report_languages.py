"""The report in French: no sentence of the English catalogue is left; numbers and dates are French."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import Any, get_args

import numpy as np
import pytest
import typst

from sightline import messages
from sightline.enums import (
    Category,
    ClassSet,
    Direction,
    InsetName,
    ReferenceSource,
    StatisticsTarget,
    Target,
)
from sightline.export.exclusions import STATES
from sightline.export.report.facts import ReportFacts, ScanFacts
from sightline.export.report.report import report, sources
from sightline.export.report.said import Called, catalogue_json, sentence_of_key, speaking, spoken_language
from sightline.export.report.units import format_fixed
from sightline.export.report.words import (
    CATEGORIES,
    CLASS_SETS,
    GROUPINGS,
    LANES,
    LIGHTING,
    MANY,
    QUANTITIES,
    TARGETS,
)
from sightline.messages.parts import parts_of, plurals
from sightline.results.survey_statistics import StatisticsOptions
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.service import VehicleMotion, statistics_of_seen
from sightline.statistics.errors import GROUPS
from tests.export.report.pdf_text import words
from tests.export.report.sample import statistics
from tests.export.report.sample_facts import facts

LEAST = 14  # letters of a run that tells a sentence from a name
# Of the sample's own people and files.
TYPED = ("from 24 pictures of a checkerboard",)


def flat(text: str) -> str:
    return "".join(text.split()).replace("\u00ad", "")


def runs(parts: Any) -> Iterator[str]:
    """The texts of a message between its values, those within its choices among them."""
    for part in parts:
        if isinstance(part, str):
            yield part
        elif "among" in part:
            for one in part["among"].values():
                yield from runs(one)
        else:
            yield from (text for name, text in part.items() if name in ("strong", "sub"))


def english_only() -> set[str]:
    """The runs of the English report that no French message has."""
    beginnings = ("report-", "standard-", "inset-note-", "sight-verdict-")
    french = "\n".join(
        flat(run) for one in beginnings for said in parts_of(one, "fr").values() for run in runs(said)
    )
    english = {flat(run) for one in beginnings for said in parts_of(one, "en").values() for run in runs(said)}
    return {run for run in english if len(run) >= LEAST and run not in french}


def left_in(text: str) -> list[str]:
    for typed in TYPED:
        text = text.replace(flat(typed), "")
    return sorted(run for run in english_only() if run in text)


@cache
def _example() -> ReportFacts:
    return replace(facts(statistics(120)), site="N138, direction of Rouen")  # typed, so without a number


@cache
def _pdf(language: str) -> bytes:
    return report(replace(_example(), language=language))


@pytest.fixture
def example() -> ReportFacts:
    return _example()


@pytest.fixture
def pdfs() -> dict[str, bytes]:
    return {name: _pdf(name) for name in ("en", "fr")}


@pytest.fixture
def french(pdfs: dict[str, bytes]) -> str:
    return flat(words(pdfs["fr"]))


def test_no_english_sentence_is_left(french: str) -> None:
    assert left_in(french) == []


def test_the_search_finds_what_is_english(pdfs: dict[str, bytes]) -> None:
    assert len(left_in(flat(words(pdfs["en"])))) > 100


def test_an_empty_survey_and_one_with_gaps_are_french() -> None:
    empty = ReportFacts("", "", statistics(0), StatisticsOptions(), language="fr")
    told = flat(words(report(empty)))
    assert left_in(told) == []
    for expected in ("Aucune mesure n’utilise encore d’étalonnage.", "Le journal d’audit est vide."):
        assert flat(expected) in told
    few = facts(statistics(60, low_light=0.0, absent=("taillight", "headlight", "roof")))
    assert left_in(flat(words(report(replace(few, language="fr"))))) == []


def test_french_words_numbers_and_dates(example: ReportFacts, french: str) -> None:
    half = next(
        one for one in example.statistics.targets["driver_eye"].corrected.percentiles if one.percent == 50.0
    )
    for expected in (
        "Non couvert",
        "du 20/04/2026 au 03/05/2026",
        "État au 04/05/2026 à 13:12:09 UTC",
        f"{half.value:.3f}".replace(".", ","),
        "Tableau 1",
        "Page 1 sur",
        "49,44315 ; 1,09932 (WGS84)",
        "limitée à 90 km/h",
        "P10, voitures particulières",
    ):
        assert flat(expected) in french, expected


def numbers(pdf: bytes) -> list[str]:
    """The words that are a number with a point in it, with its sign and what stands around it."""
    return [word for word in words(pdf).split() if re.fullmatch(r"[(−+±]?\d+\.\d+[);:,]?", word)]


def test_no_number_keeps_its_point(pdfs: dict[str, bytes]) -> None:
    of = {name: numbers(pdf) for name, pdf in pdfs.items()}
    assert len(of["en"]) > 100 and not of["fr"]


@pytest.mark.parametrize("language", messages.languages())
def test_tables_round_as_sentences_and_figures_do(example: ReportFacts, language: str) -> None:
    """Ties are those of the fewest decimals that tell a number, as in browsers."""
    rng = np.random.default_rng(5)
    ties = [
        ((2 * n + 1) / 2 / 10**d, d)
        for n, d in zip(rng.integers(-9000, 9000, 900), [0, 1, 2] * 300, strict=True)
    ]
    given = [
        *ties,
        *((float(x), 3) for x in rng.normal(0, 3, 300)),
        *((float(x), 7) for x in rng.normal(0, 1e-4, 300)),
    ]
    given += [(0.0, 2), (-0.0004, 3), (1e-12, 1), (0.0625, 3), (1.0005, 3), (2.675, 2), (1234567.5, 0)]
    given += [(-1.1475, 3), (2.15, 1), (4.4e-14, 7), (3e-9, 7)]
    files = sources(replace(example, language=language))
    files["numbers.json"] = json.dumps(given).encode()
    files["main.typ"] = (
        b'#import "blocks.typ": fixed\n'
        b'#metadata(json("numbers.json").map(((value, digits)) => fixed(value, digits, signed: true)))'
        b" <rounded>"
    )
    rounded = json.loads(typst.query(files, "<rounded>", field="value", one=True))
    with speaking(language):
        assert rounded == [format_fixed(value, digits, signed=True) for value, digits in given]


@pytest.mark.parametrize(
    ("called", "names"),
    [
        (TARGETS, (*get_args(Target), *get_args(InsetName))),
        (MANY, get_args(StatisticsTarget)),
        (LIGHTING, (*GROUPS, "unknown")),
        (CATEGORIES, get_args(Category)),
        (LANES, get_args(Direction)),
        (CLASS_SETS, (*get_args(ClassSet), "all", "none", "unknown")),
        (GROUPINGS, ("category", "class_set", "site", "operator", "lighting", "stratum")),
        (QUANTITIES, ("speed", "length", "wheelbase", "time_gap", "distance_gap", "headway")),
        (Called("report-measured-by-"), get_args(ReferenceSource)),
        (Called("report-excluded-as-"), STATES),
    ],
)
def test_everything_that_a_report_names_has_words(called: Called, names: tuple[str, ...]) -> None:
    assert [name for name in names if not called[name]] == []


def test_figures_are_drawn_in_the_language(example: ReportFacts) -> None:
    english, french = (sources(replace(example, language=name)) for name in ("en", "fr"))
    figures = [name for name in english if name.endswith(".svg")]
    assert figures and all(english[name] != french[name] for name in figures)
    assert "Hauteurs, répartition" in french["driver_eye-ecdf.svg"].decode()


def test_line_scans_are_french() -> None:
    rig = {
        "name": "A13",
        "source": "video",
        "lighting": "low_light",
        "lines": 90000,
        "baseline_m": 0.61,
        "u_baseline_m": 0.002,
        "line_rate_hz": 1500.0,
        "u_line_rate_ratio": 1e-5,
        "divergence_rad": 1e-3,
        "u_divergence_rad": 1e-4,
        "distance_m": 4.1,
        "misalignment_px": None,
        "u_misalignment_px": 0.3,
    }
    scans = ScanFacts(
        (rig, {**rig, "source": "strips", "misalignment_px": 1.5}),
        statistics_of_seen([_moving(k) for k in range(8)], accepted_only=True),
        (("direct", 1), ("paper", 3)),
        (ScannedHeights("roof", 1, 0, 0, 1.4, 0.1, 1.4, 0.02),),
    )
    told = flat(words(report(replace(facts(statistics(0)), scans=scans, language="fr"))))
    assert flat("que la dispersion de ces erreurs, sans l’erreur de la base, commune à tous") in told
    assert left_in(told) == []
    expected = "Méthode : 1 véhicule par recalage de ses deux bandes entières (recalage direct) et 3 "
    # a page may end in the sentence, a line in a word
    unbroken = re.sub(r"Étatau.{0,120}?Page\d+sur\d+Rouensouth,springRapportdemesure", "", told)
    assert flat(expected).replace("-", "") in unbroken.replace("-", "")


def _moving(k: int) -> VehicleMotion:
    """A vehicle of 4.2 m, a little off; every other one is known to its maker."""
    values: dict[str, float | None] = {"speed_mps": 14.0 + k, "u_speed_mps": 0.02, "acceleration_mps2": 0.1}
    values |= {
        "length_m": 4.2 + 0.01 * k,
        "u_length_m": 0.01,
        "time_gap_s": 2.0 + k,
        "fit_error_percent": 0.4,
    }
    known: dict[str, float | None] = {"length_m": 4.2} if k % 2 else {}
    return VehicleMotion(k, 1, k, "accepted" if k else "rejected", True, "daytime", values, known)


@pytest.mark.parametrize("n", [5, pytest.param(30, marks=pytest.mark.proof)])
def test_the_same_facts_give_the_same_bytes_in_a_language(n: int) -> None:
    few = replace(facts(statistics(n, absent=("taillight", "headlight", "roof"))), language="fr")
    assert report(few) == report(few) != report(replace(few, language="en"))


def test_a_language_is_spoken_within_and_no_longer() -> None:
    with speaking("fr"):
        assert (spoken_language(), sentence_of_key("report-target-roof"), format_fixed(-1.25, 2)) == (
            "fr",
            "toit",
            "−1,25",
        )
    assert (spoken_language(), sentence_of_key("report-target-roof"), format_fixed(-1.25, 2)) == (
        "en",
        "roof",
        "−1.25",
    )


@pytest.mark.parametrize("language", messages.languages())
def test_templates_get_every_message_with_the_plurals_of_the_language(language: str) -> None:
    told = json.loads(catalogue_json(language))
    assert set(told["messages"]) == set(parts_of("report-", "en")) and told["language"] == language
    assert told["plurals"][:3] == (["one", "one", "other"] if language == "fr" else ["other", "one", "other"])
    assert len(plurals(language)) == 200
