"""Computing every repeat of a package again, and holding its rows against their events."""

from collections.abc import Callable

from sightline.infra.csv_package.files import Files, read_rows
from sightline.measurements.verify import MeasurementEvents, Recomputed
from sightline.quality.repeats.csv import REPEATS


def check_repeats(
    files: Files, events: MeasurementEvents, is_gone: Callable[[int], bool], heights: Recomputed
) -> None:
    """Compute the height of every repeat again. `is_gone`: whether a vehicle was deleted. Raises Damaged."""
    for row in read_rows(files, REPEATS.key):
        number = int(row["id"])
        heights.check(f"repeats.csv: {number}", row, events.programs_of_repeats.get(number, ""))
        stored = {**row, "out_of_date": ""}  # its mark follows from more than its event
        events.repeats.hold((number,), stored)
    events.repeats.require_none_left(lambda number: is_gone(events.of_vehicle[number]))
