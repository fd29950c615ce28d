"""When a recording was filmed, by the clocks of its place, and whether its camera's calibration fits it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from math import hypot
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sightline.enums import StreetLamps, StreetLighting
from sightline.errors import BadInput
from sightline.infra.local_time import instant_of, local_day, local_text
from sightline.messages import say

_EARLIEST = datetime(1990, 1, 1, tzinfo=UTC)
_FILM_DIAGONAL_MM = hypot(36.0, 24.0)
# A video is cut out of the sensor's picture and steadied: its view is narrower than stated by up to a fifth.
_FOCAL_RATIO = 1.25


@dataclass(frozen=True, slots=True)
class Filming:
    """The instant of a recording's first frame, and the zone by whose clocks it is told."""

    started_at: datetime
    time_zone: str

    def at(self, seconds: float = 0.0) -> str:
        """So many seconds after the first frame: ISO 8601 with offset, milliseconds."""
        return local_text(self.started_at, self.time_zone, seconds)

    def days(self, seconds: NDArray[np.float64]) -> NDArray[np.int64]:
        """The days (N,), since 1970-01-01, that clocks showed so many seconds (N,) after the first frame."""
        if len(seconds) == 0:
            return np.zeros(0, dtype=np.int64)
        first, last = (
            local_day(self.started_at, self.time_zone, one) for one in (seconds.min(), seconds.max())
        )
        if first == last:
            return np.full(len(seconds), first, dtype=np.int64)
        days = [local_day(self.started_at, self.time_zone, one) for one in seconds.tolist()]
        return np.array(days, dtype=np.int64)


def filming_of(row: Mapping[Any, Any]) -> Filming | None:
    """Of a recording's row, or one joined with it; None while nobody has confirmed the start."""
    return None if row["started_at"] is None else Filming(row["started_at"], row["time_zone"])


def frame_s(duration_s: float | None, frame_count: int | None) -> float:
    """How long a frame of a recording is on average, seconds; 0 where that is not known."""
    return duration_s / frame_count if duration_s and frame_count else 0.0


def start_of(local: str, zone: str, present: datetime) -> Filming:
    """What a person said of a start. Raises BadInput: see `instant_of`; and a start in the future."""
    at = instant_of(local, zone)
    at = at.replace(microsecond=at.microsecond // 1000 * 1000)
    if at > present:
        raise BadInput(
            "recordings-start-in-future", start=local_text(at, zone)[:16].replace("T", " "), zone=zone
        )
    if at < _EARLIEST:
        raise BadInput("recordings-start-too-early", start=local_text(at, zone)[:10])
    return Filming(at, zone)


def lamps_misfits(street_lighting: StreetLighting | None, lamps: StreetLamps | None) -> list[str]:
    """A sentence where street lighting is said to have been on along a road that is said to have none."""
    return [say("recordings-misfit-lamps", {})] if street_lighting == "on" and lamps == "none" else []


def misfits(
    size_px: tuple[int | None, int | None], focal_35mm_mm: float | None, lens: Mapping[str, Any]
) -> list[str]:
    """Sentences on where a recording does not fit its camera's calibration (`sightline-camera-1`)."""
    width, height = size_px
    lens_width, lens_height = lens.get("width_px"), lens.get("height_px")
    if width is None or height is None or lens_width is None or lens_height is None:
        return []
    if (width, height) != (lens_width, lens_height):
        sizes = {"width": width, "height": height, "lens_width": lens_width, "lens_height": lens_height}
        return [say("recordings-misfit-size", sizes)]
    fx, fy = lens.get("fx_px"), lens.get("fy_px")
    if focal_35mm_mm is None or fx is None or fy is None:
        return []
    stated_px = focal_35mm_mm / _FILM_DIAGONAL_MM * hypot(width, height)
    ratio = (float(fx) * float(fy)) ** 0.5 / stated_px
    if 1.0 / _FOCAL_RATIO <= ratio <= _FOCAL_RATIO:
        return []
    fits_mm = focal_35mm_mm * ratio
    return [
        say("recordings-misfit-focal", {"stated_mm": f"{focal_35mm_mm:.3g}", "lens_mm": f"{fits_mm:.3g}"})
    ]
