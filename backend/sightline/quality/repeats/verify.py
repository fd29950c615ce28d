"""Computing every repeat of a package again, and holding its rows against their events."""

from __future__ import annotations

from collections.abc import Callable

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_rows
from sightline.measurements.verify import MeasurementEvents, Recomputed, same_repeat
from sightline.quality.repeats.csv import REPEATS


def check_repeats(
    files: Files, events: MeasurementEvents, is_gone: Callable[[int], bool], heights: Recomputed
) -> int:
    """Compute the height of every repeat again; how many were. `is_gone`: whether a vehicle was deleted.

    Raises Damaged.
    """
    count = 0
    for row in read_rows(files, REPEATS.path):
        number = int(row["id"])
        heights.check(f"repeats.csv: {number}", row)
        digest = events.repeats.pop(number, None)
        if digest is None or not same_repeat(digest, row):
            raise Damaged("quality-repeats-csv-not-what-audit-event", number=number)
        count += 1
    left = [number for number in events.repeats if not is_gone(events.of_vehicle[number])]
    if left:
        raise Damaged("quality-repeats-csv-repeat-missing-though-audit", left=left[0])
    return count
