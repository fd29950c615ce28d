"""Answers are records: made by name, and described as whole."""

from dataclasses import dataclass

import pytest

from sightline.app import describe
from sightline.infra.by_name import filled_from


@dataclass(frozen=True)
class Inner:
    height_m: float
    frame: int


@dataclass(frozen=True, slots=True)
class Outer:
    id: int
    frame: str
    left_out: bool = True


@dataclass(frozen=True, slots=True)
class Answer:
    id: int
    frame: int | str
    height_m: float
    words: str


def test_an_answer_takes_its_fields_by_name_and_the_first_record_counts() -> None:
    inner, outer = Inner(height_m=1.5, frame=7), Outer(id=3, frame="outer")
    for _ in range(2):  # the second time from what is known of the kinds
        made = filled_from(Answer, outer, inner, words="so")
        assert made == Answer(id=3, frame="outer", height_m=1.5, words="so")
    assert filled_from(Answer, inner, outer, words="so").frame == 7
    assert filled_from(Answer, inner, outer, words="so", id=9).id == 9


def test_an_answer_that_no_record_fills_is_not_made() -> None:
    with pytest.raises(TypeError, match="words"):
        filled_from(Answer, Outer(id=3, frame="outer"), Inner(height_m=1.5, frame=7))


def test_what_is_answered_is_described_as_whole_and_what_comes_in_is_not() -> None:
    schemas = describe()["components"]["schemas"]
    for record in ("ReviewState", "Estimate", "MeasurementBody", "Answer"):  # each has fields with defaults
        assert schemas[record]["required"] == list(schemas[record]["properties"]), record
    assert "sigma_px" not in schemas["NewMeasurement"]["required"]
    assert schemas["ErrorBody"]["required"] == ["error"]
