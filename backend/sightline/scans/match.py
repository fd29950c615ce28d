"""The second strip laid over the first by the fitted motion, to see whether they match."""

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.infra.services import Services
from sightline.linescan.rig import baseline_of, rig_from
from sightline.linescan.warp import Course
from sightline.media.images import jpeg
from sightline.media.strips.stored_reader import StripReader
from sightline.scans.records import Scan, ScanMeasurement, ScanValues
from sightline.scans.service import open_strips

MARGIN = 0.08
MOST_COLUMNS = 4096
QUALITY = 90
_GREY = 128.0
_AT_ONCE = 256  # columns of the picture; remap takes no more than 32767 lines of a strip


def window_of(values: ScanValues, lines: int) -> tuple[int, int, int]:
    """The lines of strip 1 that are shown: the vehicle with a margin; (first, stop, every so many)."""
    margin = MARGIN * (values.rear_line_1 - values.front_line_1) + 8
    first = max(0, int(values.front_line_1 - margin))
    stop = min(lines, int(values.rear_line_1 + margin) + 1)
    return first, stop, max(1, -(-(stop - first) // MOST_COLUMNS))


def match_picture(services: Services, scan: Scan, measured: ScanMeasurement | None, picture: str) -> bytes:
    """One picture of the match as JPEG (rows, lines): "first", "second" (moved and its gain taken out) or
    "difference" (second - first, grey where they are alike).

    Raises BadInput for a vehicle without a motion.
    """
    if measured is None or measured.values.status != "ok" or measured.values.speed_mps is None:
        raise BadInput("scans-no-motion")
    values = measured.values
    reader_1, reader_2 = open_strips(services, scan)
    start, stop, step = window_of(values, reader_1.lines)
    low, high = reader_1.shown_range
    at_once = _AT_ONCE * step
    pieces = [reader_1.read(n, min(n + at_once, stop))[::step] for n in range(start, stop, at_once)]
    first = np.concatenate(pieces).astype(np.float32)
    if picture == "first":
        return _encoded(first, low, high)
    at = partner_lines(values, np.arange(start, stop, step, dtype=np.float64))
    misalignment = values.misalignment_px or values.rig["misalignment_px"] or 0.0
    second = _same_light(first, laid_over(reader_2, at, misalignment))
    if picture == "second":
        return _encoded(second, low, high)
    return _encoded(_GREY + (second - first) * 255.0 / max(high - low, 1.0), 0.0, 255.0)


def partner_lines(values: ScanValues, lines: NDArray[np.float64]) -> NDArray[np.float64]:
    """Lines (n,) of strip 2 at which the fitted motion brings what strip 1 saw at `lines` (n,)."""
    rig = rig_from(values.rig)
    assert values.speed_mps is not None
    # of the other direction, camera 2 lies the baseline before camera 1
    ahead_m = baseline_of(rig)[0] * (1 if values.direction == "camera_1_first" else -1)
    course = Course(values.speed_mps, values.acceleration_mps2 or 0.0, ahead_m)
    second_s = course.second_s((lines - values.front_line_1) / rig.line_rate_hz)
    return np.asarray(values.front_line_1 + second_s * rig.line_rate_hz)


def laid_over(reader: StripReader, at: NDArray[np.float64], misalignment_px: float) -> NDArray[np.float32]:
    """Lines `at` (n,), each moved up by the misalignment, (n, rows). Raises BadInput where none exists."""
    if at.min() > reader.lines - 1:
        raise BadInput("scans-second-strip-ends")
    parts = []
    rows = np.arange(reader.rows) + misalignment_px
    for part in np.array_split(np.clip(at, 0, reader.lines - 1), -(-len(at) // _AT_ONCE)):
        begin = max(0, int(part.min()) - 1)
        block = reader.read(begin, int(part.max()) + 3).astype(np.float32)
        x, y = (grid.astype(np.float32) for grid in np.meshgrid(rows, part - begin))
        parts.append(cv2.remap(block, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE))
    return np.asarray(np.concatenate(parts), np.float32)


def _same_light(first: NDArray[np.float32], second: NDArray[np.float32]) -> NDArray[np.float32]:
    """The second picture with mean and spread of the first, so that only what differs shows."""
    gain = float(first.std()) / max(float(second.std()), 1e-6)
    return np.asarray((second - second.mean()) * gain + first.mean(), np.float32)


def _encoded(lines: NDArray[np.float32], low: float, high: float) -> bytes:
    shown = np.clip((lines - low) * (255.0 / max(high - low, 1.0)), 0, 255)
    return jpeg(np.ascontiguousarray(np.round(shown).astype(np.uint8).T), QUALITY)
