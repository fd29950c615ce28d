"""The report in French: no sentence of the English catalogue is left; numbers and dates are French."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import pytest

from sightline import messages
from sightline.export.report.facts import ReportFacts, RigFacts, ScanFacts
from sightline.export.report.report import report, sources
from sightline.export.report.said import catalogue_json, said, speaking, spoken
from sightline.export.report.units import fixed
from sightline.messages.parts import parts_of, plurals
from sightline.results.survey_statistics import StatisticsOptions
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.service import VehicleMotion, statistics_of_seen
from tests.export.report.pdf_text import words
from tests.export.report.sample import statistics
from tests.export.report.sample_facts import facts

LEAST = 14  # letters of a run that tells a sentence from a name
# Of the sample's own people and files.
TYPED = ("from 24 pictures of a checkerboard", "inner corners of 100 mm")


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
    beginnings = ("report-", "told-", "sight-verdict-")
    french = "\n".join(
        flat(run) for one in beginnings for said in parts_of(one, "fr").values() for run in runs(said)
    )
    english = {flat(run) for one in beginnings for said in parts_of(one, "en").values() for run in runs(said)}
    return {run for run in english if len(run) >= LEAST and run not in french}


def left_in(text: str) -> list[str]:
    for typed in TYPED:
        text = text.replace(flat(typed), "")
    return sorted(run for run in english_only() if run in text)


@pytest.fixture(scope="module")
def example() -> ReportFacts:
    return facts(statistics(120))


@pytest.fixture(scope="module")
def french(example: ReportFacts) -> str:
    return flat(words(report(replace(example, language="fr"))))


def test_no_english_sentence_is_left(french: str) -> None:
    assert left_in(french) == []


def test_the_search_finds_what_is_english(example: ReportFacts) -> None:
    assert len(left_in(flat(words(report(example))))) > 100


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
        "limitation à 90 km/h",
        "P10, voitures particulières",
    ):
        assert flat(expected) in french, expected


def numbers(value: Any) -> Iterator[str]:
    """Texts of the values that are a number, with its unit or without."""
    if isinstance(value, str) and re.fullmatch(r"[−+]?\d+\.\d+\D{0,4}", value):
        yield value
    elif isinstance(value, Mapping):
        for one in value.values():
            yield from numbers(one)
    elif isinstance(value, list):
        for one in value:
            yield from numbers(one)


def test_no_number_keeps_its_point(example: ReportFacts) -> None:
    of = {name: json.loads(sources(replace(example, language=name))["values.json"]) for name in ("en", "fr")}
    assert len(list(numbers(of["en"]))) > 100 and not list(numbers(of["fr"]))


def test_figures_are_drawn_in_the_language(example: ReportFacts) -> None:
    english, french = (sources(replace(example, language=name)) for name in ("en", "fr"))
    figures = [name for name in english if name.endswith(".svg")]
    assert figures and all(english[name] != french[name] for name in figures)
    assert "Hauteurs, distribution cumulée" in french["driver_eye-ecdf.svg"].decode()


def test_line_scans_are_french(example: ReportFacts) -> None:
    rig = RigFacts(
        "A13", "video", "low_light", 90000, 400, 0.61, 0.002, 1500.0, 1e-5, 1e-3, 1e-4, 4.1, None, 0.3
    )
    scans = ScanFacts(
        (rig, replace(rig, source="strips", misalignment_px=1.5)),
        statistics_of_seen([_moving(k) for k in range(8)], accepted_only=True),
        (("direct", 1), ("paper", 3)),
        (ScannedHeights("roof", 1, 0, 0, 1.4, 0.1, 1.4, 0.02),),
    )
    told = flat(words(report(replace(example, scans=scans, language="fr"))))
    assert left_in(told) == []
    expected = "Méthode : 1 véhicule par superposition de ses deux bandes entières (recalage direct) et 3 "
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


def test_the_same_facts_give_the_same_bytes_in_a_language(example: ReportFacts) -> None:
    few = replace(facts(statistics(30, absent=("taillight", "headlight", "roof"))), language="fr")
    assert report(few) == report(few) != report(replace(few, language="en"))


def test_a_language_is_spoken_within_and_no_longer() -> None:
    with speaking("fr"):
        assert (spoken(), said("report-roof"), fixed(-1.25, 2)) == ("fr", "toit", "−1,25")
    assert (spoken(), said("report-roof"), fixed(-1.25, 2)) == ("en", "roof", "−1.25")


@pytest.mark.parametrize("language", messages.languages())
def test_templates_get_every_message_with_the_plurals_of_the_language(language: str) -> None:
    told = json.loads(catalogue_json(language))
    assert set(told["messages"]) == set(parts_of("report-", "en")) and told["language"] == language
    assert told["plurals"][:3] == (["one", "one", "other"] if language == "fr" else ["other", "one", "other"])
    assert len(plurals(language)) == 200
