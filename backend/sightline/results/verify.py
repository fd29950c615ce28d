"""Holding the table of standards in a package against the audit chain."""

from collections.abc import Mapping
from typing import Any

from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.replay import hold_all, values_of
from sightline.results.csv import STANDARDS as TABLE
from sightline.results.usual_standards import STANDARDS, stored_standards


def check_standards(files: Files, survey: Mapping[str, Any]) -> None:
    """The standards are those that the survey's events chose, or the usual ones. Raises Damaged."""
    chosen = survey.get("standards")
    expected = STANDARDS if chosen is None else stored_standards(chosen)
    hold_all(files, TABLE, (values_of(TABLE, one) for one in expected), in_order=True)
