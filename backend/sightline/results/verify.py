"""Holding the table of standards in a package against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files
from sightline.results.csv import standards_in
from sightline.statistics.standards import STANDARDS, Standard


def check_standards(files: Files, chosen: Sequence[Mapping[str, Any]] | None) -> None:
    """The standards are those that the survey's events chose; None: the usual ones. Raises Damaged."""
    expected = STANDARDS if chosen is None else tuple(Standard(**one) for one in chosen)
    if standards_in(files) != tuple(expected):
        raise Damaged("results-standards-csv-not-what-surveys-audit")
