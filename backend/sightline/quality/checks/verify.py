"""Holding the tyre contacts of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.verify import says
from sightline.quality.checks.csv import WHEEL_PAIRS


def check_wheel_pairs(
    files: Files, pairs: Mapping[int, Mapping[str, Any]], is_gone: Callable[[int], bool]
) -> None:
    """Tyre contacts are the newest of each vehicle as its events tell them, and none is missing.

    `is_gone`: whether a vehicle was deleted. Raises Damaged.
    """
    newest = {pair["vehicle_id"]: number for number, pair in sorted(pairs.items())}
    left = {n for vehicle, n in newest.items() if not (is_gone(vehicle) or pairs[n]["withdrawn"])}
    for row in read_rows(files, WHEEL_PAIRS.path):
        number = int(row["id"])
        if number not in left or not says(WHEEL_PAIRS, row, _values(pairs[number])):
            raise Damaged("quality-wheel-pairs-csv-not-what-audit", id=number)
        left.discard(number)
    if left:
        raise Damaged("quality-wheel-pairs-csv-not-what-audit", id=min(left))


def _values(pair: Mapping[str, Any]) -> dict[str, Any]:
    return {**pair, "created_at": stamp(pair["created_at"])}
