"""Two studies beside each other: is the difference of their figures more than noise?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sightline.messages.said import Said
from sightline.statistics.comparison import difference_of_figures
from sightline.statistics.figures import TotalFigure
from sightline.studies.records import StudyDifference, StudyResult

Row = Mapping[str, Any]
#: What is compared; a difference of spreads has no interval of its own here.
_COMPARED = ("percentile", "mean")


def study_differences(first: StudyResult, second: StudyResult) -> list[StudyDifference]:
    """Percentiles and mean of the second study less those of the first, of each target that both have.

    By the total intervals that both were computed with (Zou & Donner 2008). The two are taken to share no
    error: of a survey, a site or a mean inset that both hold the intervals are too wide, never too narrow.
    """
    before = {_name(row): row for row in _rows(first)}
    return [_difference(before[_name(row)], row) for row in _rows(second) if _name(row) in before]


def shared_surveys(first: StudyResult, second: StudyResult) -> list[int]:
    """The surveys that both hold."""
    return sorted(set(first.heads) & set(second.heads))


def _rows(result: StudyResult) -> Iterator[Row]:
    for row in result.document["figures"]:
        if row["figure"] in _COMPARED and row["n"]:
            yield row


def _name(row: Row) -> tuple[str, str, float | None]:
    return row["target"], row["figure"], row.get("percent")


def _difference(before: Row, after: Row) -> StudyDifference:
    if before["value_m"] is None or after["value_m"] is None:
        value, low, high, verdict = None, None, None, None
        reason = _reason(before if before["value_m"] is None else after)
    else:
        one = difference_of_figures(_figure(before), _figure(after))
        told, verdict = one.difference, one.verdict
        value, low, high, reason = told.value, told.U95_low, told.U95_high, told.reason
    return StudyDifference(
        target=after["target"],
        percent=after.get("percent"),
        n_first=before["n"],
        n_second=after["n"],
        value_m=value,
        low_m=low,
        high_m=high,
        verdict=verdict,
        reason=reason,
    )


def _figure(row: Row) -> TotalFigure:
    return TotalFigure(row["value_m"], row["low_m"], row["high_m"], _reason(row))


def _reason(row: Row) -> Said | None:
    return Said.read(row["reason"]) if row.get("reason") else None
