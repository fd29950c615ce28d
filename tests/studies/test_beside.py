"""Two studies beside each other, from what is stored of both."""

from datetime import UTC, datetime
from typing import Any

import numpy as np
import pytest

from sightline.messages.said import Said
from sightline.studies.beside import shared_surveys, study_differences
from sightline.studies.records import StudyResult


def row(value_m: float | None, half_m: float = 0.01, **more: Any) -> dict[str, Any]:
    low, high = (None, None) if value_m is None else (value_m - half_m, value_m + half_m)
    common = {"target": "roof", "figure": "percentile", "percent": 10.0, "n": 100, "reason": None}
    return {**common, "value_m": value_m, "low_m": low, "high_m": high, **more}


def result(*rows: dict[str, Any], surveys: tuple[int, ...] = (1,)) -> StudyResult:
    return StudyResult(
        id=1,
        study_id=1,
        study_version=1,
        heads=dict.fromkeys(surveys, ""),
        document={"figures": list(rows)},
        media_key="",
        size_bytes=0,
        sha256="",
        report_key="",
        report_sha256="",
        code_version="",
        created_at=datetime.now(UTC),
        created_by=None,
    )


@pytest.mark.parametrize(
    ("moved_m", "verdict"), [(0.02, "higher"), (-0.02, "lower"), (0.01, "not_told_apart")]
)
def test_a_difference_is_told_from_noise_by_both_intervals(moved_m: float, verdict: str) -> None:
    (one,) = study_differences(result(row(1.4)), result(row(1.4 + moved_m)))
    assert one.value_m == pytest.approx(moved_m) and one.verdict == verdict
    assert one.high_m is not None and one.high_m - moved_m == pytest.approx(0.01 * np.sqrt(2))


def test_what_one_of_them_lacks_is_left_out_and_a_missing_figure_keeps_its_reason() -> None:
    none = row(None, target="taillight", reason=Said("stat-true-heights-alike").document)
    first = result(row(1.4), row(0.2, figure="sd", percent=None), none)
    second = result(
        row(1.4, target="driver_eye"), row(0.2, figure="sd", percent=None), row(0.8, target="taillight")
    )
    (one,) = study_differences(first, second)
    assert (one.target, one.value_m, one.verdict, one.reason) == (
        "taillight",
        None,
        None,
        Said("stat-true-heights-alike"),
    )


def test_surveys_of_both_are_named() -> None:
    assert shared_surveys(result(surveys=(1, 2, 3)), result(surveys=(3, 2, 9))) == [2, 3]
