"""Computing every repeat of a package again, and holding its rows against their events."""

from collections.abc import Callable

from sightline.errors import Damaged
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
        if events.repeats.pop(number, None) != events.of_row(REPEATS, stored):
            raise Damaged("quality-repeat-differs", number=number)
    left = [number for number in events.repeats if not is_gone(events.of_vehicle[number])]
    if left:
        raise Damaged("quality-repeat-missing", left=left[0])
