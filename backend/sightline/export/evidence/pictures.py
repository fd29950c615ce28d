"""Both pictures of an evidence file: the strips about one vehicle as PNG, eight bits, all rows."""

from dataclasses import dataclass

import numpy as np

from sightline.enums import JsonObject
from sightline.errors import BadInput
from sightline.infra.csv_package.schema import sha256_hex
from sightline.media.images import png
from sightline.media.strips.stored_reader import StripReader
from sightline.scans.records import ScanValues

#: A browser shows wider pictures slowly or not at all; of longer vehicles every so many lines are kept.
MOST_COLUMNS = 8192
MARGIN_SHARE, MARGIN_LINES = 0.15, 32
#: No vehicle takes longer: a train of 700 m at 7 m/s before cameras of 5,000 lines a second.
MOST_LINES = 500_000
_AT_ONCE = 128


@dataclass(frozen=True)
class StripPicture:
    """One camera's picture: its PNG and where it lies in the strip (`facts`, as the document says)."""

    name: str
    content: bytes
    facts: JsonObject


def pictures_of(readers: tuple[StripReader, StripReader], values: ScanValues) -> tuple[StripPicture, ...]:
    """The picture of either camera. Raises BadInput where a strip has no line of the vehicle, Damaged."""
    ends = ((values.front_line_1, values.rear_line_1), (values.front_line_2, values.rear_line_2))
    return tuple(
        _picture(camera, reader, min(pair), max(pair))
        for camera, (reader, pair) in enumerate(zip(readers, ends, strict=True), 1)
    )


def _picture(camera: int, reader: StripReader, front: float, rear: float) -> StripPicture:
    margin = MARGIN_SHARE * (rear - front) + MARGIN_LINES
    start = max(0, int(front - margin))
    stop = min(reader.lines, int(rear + margin) + 1)
    if stop - start < 2:
        raise BadInput("evidence-no-picture", camera=camera)
    if stop - start > MOST_LINES:
        raise BadInput("evidence-too-long", lines=stop - start, most=MOST_LINES)
    step = -(-(stop - start) // MOST_COLUMNS)
    at_once = _AT_ONCE * step  # a whole number of steps, so that pieces keep the same lines
    shown = [
        reader.shown(reader.read(n, min(n + at_once, stop))[::step]) for n in range(start, stop, at_once)
    ]
    content = png(np.ascontiguousarray(np.concatenate(shown, axis=1)))
    low, high = reader.shown_range
    name = f"camera-{camera}.png"
    facts: JsonObject = {
        "name": name,
        "camera": camera,
        "sha256": sha256_hex(content),
        "first_line": start,
        "columns": sum(one.shape[1] for one in shown),
        "step_lines": step,
        "rows_px": reader.rows,
        "grey_black": low,
        "grey_white": high,
    }
    return StripPicture(name, content, facts)
