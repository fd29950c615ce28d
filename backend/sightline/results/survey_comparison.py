"""Two surveys (or years) beside each other: of each target the second's figures less the first's."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field

from sightline.enums import ComparisonVerdict, StatisticsTarget
from sightline.infra.audit.records import Who
from sightline.messages.said import Said
from sightline.results.measured_columns_query import Measured
from sightline.statistics.comparison import Compared, compare
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

PERCENTS = (2.5, 5.0, 10.0, 15.0, 50.0, 85.0, 90.0, 95.0, 97.5)
_LEAST = 2


@dataclass(frozen=True, slots=True, kw_only=True)
class ComparedFigure:
    """A figure of true heights, the second survey's less the first's, metres, with its total interval."""

    target: StatisticsTarget
    percent: Annotated[float | None, Field(description="Of a percentile: which; null: the mean.")]
    n_first: int
    n_second: int
    value_m: float | None
    U95_low_m: float | None
    U95_high_m: float | None
    verdict: ComparisonVerdict | None
    reason: Said | None


@dataclass(frozen=True, slots=True, kw_only=True)
class ComparedSurveys:
    """The second survey beside the first, which was made before it."""

    first: Who
    second: Who
    figures: list[ComparedFigure]


def compared_surveys(
    measured: Measured,
    targets: Mapping[StatisticsTarget, np.ndarray[tuple[int, ...], np.dtype[np.bool_]]],
    surveys: Mapping[int, str],
    sample_of: Callable[[Measured], HeightSample],
) -> ComparedSurveys | None:
    """The comparison of two surveys; None where the heights (N,) are of one, or of more.

    targets: which heights (N,) are of each target; errors are taken to be each survey's own (`compare`).
    """
    ids = np.unique(measured.survey_id).tolist()
    if len(ids) != 2 or not all(id_ in surveys for id_ in ids):
        return None
    figures: list[ComparedFigure] = []
    for target, rows in targets.items():
        of_each = [rows & (measured.survey_id == id_) for id_ in ids]
        counts = [int(np.count_nonzero(one)) for one in of_each]
        if min(counts) < _LEAST:
            continue
        first, second = (TotalUncertainty(sample_of(measured.where(one))) for one in of_each)
        told = compare(first, second, PERCENTS)
        pairs = [*zip(PERCENTS, told.percentiles, strict=True), (None, told.mean)]
        figures += [_figure(target, percent, counts, one) for percent, one in pairs]
    first_id, second_id = ids
    return ComparedSurveys(
        first=Who(first_id, surveys[first_id]), second=Who(second_id, surveys[second_id]), figures=figures
    )


def _figure(
    target: StatisticsTarget, percent: float | None, counts: list[int], compared: Compared
) -> ComparedFigure:
    difference = compared.difference
    return ComparedFigure(
        target=target,
        percent=percent,
        n_first=counts[0],
        n_second=counts[1],
        value_m=difference.value,
        U95_low_m=difference.U95_low,
        U95_high_m=difference.U95_high,
        verdict=compared.verdict,
        reason=difference.reason,
    )
