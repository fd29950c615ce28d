"""Holding the tyre contacts of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.verify import says
from sightline.quality.checks.csv import WHEEL_PAIRS


def check_wheel_pairs(files: Files, pairs: Mapping[int, Mapping[str, Any]]) -> None:
    """Tyre contacts are those of their events, by number. Raises Damaged."""
    for row in read_rows(files, WHEEL_PAIRS.path):
        pair = pairs.get(int(row["id"]))
        if pair is None or not says(WHEEL_PAIRS, row, _values(pair)):
            raise Damaged("quality-wheel-pairs-csv-not-what-audit", id=row["id"])


def _values(pair: Mapping[str, Any]) -> dict[str, Any]:
    return {**pair, "created_at": stamp(pair["created_at"])}
