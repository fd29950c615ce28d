"""Two studies beside each other: is the difference of their figures more than noise?"""

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
    before = {_name(row): row for row in _compared_rows(first)}
    return [_difference(before[_name(row)], row) for row in _compared_rows(second) if _name(row) in before]


def shared_surveys(first: StudyResult, second: StudyResult) -> list[int]:
    """The surveys that both hold."""
    return sorted(set(first.heads) & set(second.heads))


def _compared_rows(result: StudyResult) -> Iterator[Row]:
    for row in result.document["figures"]:
        if row["figure"] in _COMPARED and row["n"]:
            yield row


def _name(row: Row) -> tuple[str, str, float | None]:
    return row["target"], row["figure"], row.get("percent")


def _difference(before: Row, after: Row) -> StudyDifference:
    return StudyDifference(
        target=after["target"],
        percent=after.get("percent"),
        n_first=before["n"],
        n_second=after["n"],
        **difference_in_cells(_figure(before), _figure(after)),
    )


def difference_in_cells(before: TotalFigure, after: TotalFigure) -> dict[str, Any]:
    """Two figures, the second less the first, by the fields of `StudyDifference`."""
    compared = difference_of_figures(before, after)
    told = compared.difference
    if told.value is None:
        return no_difference(told.reason)
    ends = {"low_m": told.U95_low, "high_m": told.U95_high}
    return {"value_m": told.value, **ends, "verdict": compared.verdict, "reason": told.reason}


def no_difference(reason: Said | None) -> dict[str, Any]:
    """The same fields where one of the two has no figure."""
    return {**dict.fromkeys(("value_m", "low_m", "high_m", "verdict")), "reason": reason}


def _figure(row: Row) -> TotalFigure:
    reason = Said.read(row["reason"]) if row.get("reason") else None
    return TotalFigure(row["value_m"], row["low_m"], row["high_m"], reason)
