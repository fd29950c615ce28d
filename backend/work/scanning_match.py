"""The second strip laid over the first by the fitted motion, to see whether they match."""

from __future__ import annotations

from backend.errors import BadInput
from backend.storage.scans_records import Scan, ScanMeasurement, ScanValues
from backend.work.services import Services

MARGIN = 0.08


def window_of(values: ScanValues, lines: int) -> tuple[int, int]:
    """The lines of strip 1 that are shown: the vehicle with a margin, (first, stop)."""
    margin = MARGIN * (values.rear_line_1 - values.front_line_1) + 8
    first = max(0, int(values.front_line_1 - margin))
    return first, min(lines, int(values.rear_line_1 + margin) + 1)


def match_picture(services: Services, scan: Scan, measured: ScanMeasurement | None, picture: str) -> bytes:
    """One picture of the match as JPEG. Raises BadInput for a vehicle without a motion."""
    raise BadInput("The match is not connected yet; try again later.")
