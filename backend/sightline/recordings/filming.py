"""When a recording was filmed, by the clocks of its place, and whether its camera's calibration fits it."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, date, datetime
from math import hypot
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sightline.enums import StreetLamps, StreetLighting
from sightline.errors import BadInput
from sightline.infra.local_time import instant_of, local_text, local_us, to_millisecond
from sightline.messages.said import Said

_EARLIEST = datetime(1990, 1, 1, tzinfo=UTC)
_FILM_DIAGONAL_MM = hypot(36.0, 24.0)
# A video is cut out of the sensor's picture and steadied: its view is narrower than stated by up to a fifth.
_FOCAL_RATIO = 1.25
_EPOCH = date(1970, 1, 1)
_DAY_H, _HOUR_US = 24, 3_600_000_000


@dataclass(frozen=True, slots=True)
class Filming:
    """The instant of a recording's first frame, and the zone by whose clocks it is told."""

    started_at: datetime
    time_zone: str

    def at(self, seconds: float = 0.0) -> str:
        """So many seconds after the first frame: ISO 8601 with offset, milliseconds."""
        return local_text(self.started_at, self.time_zone, seconds)

    def hours(self, seconds: NDArray[np.float64]) -> NDArray[np.int64]:
        """The full hours (N,), since the beginning of 1970-01-01, that clocks showed so many seconds (N,)
        after the first frame.
        """
        if len(seconds) == 0:
            return np.zeros(0, dtype=np.int64)
        ends = (float(seconds.min()), float(seconds.max()))
        first_us, last_us = (local_us(self.started_at, self.time_zone, one) for one in ends)
        since_us = 1000 * (np.rint(1000.0 * seconds) - round(1000.0 * ends[0])).astype(np.int64)
        if last_us - first_us == since_us.max():  # the clocks were not changed meanwhile
            return (first_us + since_us) // _HOUR_US
        each_us = [local_us(self.started_at, self.time_zone, one) for one in seconds.tolist()]
        return np.array(each_us, dtype=np.int64) // _HOUR_US


@dataclass(frozen=True, slots=True)
class FilmedWithin:
    """What was filmed on these days, the last included, and at these hours of the day, by the clocks of the
    place. None: no limit.

    `hour_from`: 0 to 23; `hour_to`: 1 to 24, not included. Where it comes first, midnight lies between, and
    the hours after it are of the day before, on which the night began.
    """

    filmed_from: date | None = None
    filmed_to: date | None = None
    hour_from: int | None = None
    hour_to: int | None = None

    @property
    def limits_time(self) -> bool:
        """Whether what has no time of filming is left out."""
        return any(getattr(self, one) is not None for one in FILMED)

    @property
    def hours(self) -> tuple[int, int]:
        """From which full hour, up to which; the whole day where nothing limits it."""
        return self.hour_from or 0, _DAY_H if self.hour_to is None else self.hour_to

    def require_sense(self) -> None:
        """Raise BadInput where nothing could be of it."""
        if self.filmed_from and self.filmed_to and self.filmed_to < self.filmed_from:
            raise BadInput("results-days-exchanged")
        if self.hour_from is not None and self.hour_from == self.hour_to:
            raise BadInput("recordings-hours-are-none")

    def holding(self, hours: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Which hours (N,), since the beginning of 1970-01-01, are of it; -1 for not known."""
        keep = np.ones(len(hours), dtype=np.bool_)
        if not self.limits_time:
            return keep
        day, hour = np.divmod(hours, _DAY_H)
        begins, ends = self.hours
        after, before = hour >= begins, hour < ends
        if begins > ends:
            day -= before
        if self.filmed_from is not None:
            keep &= day >= (self.filmed_from - _EPOCH).days
        if self.filmed_to is not None:
            keep &= day <= (self.filmed_to - _EPOCH).days
        return keep & (hours >= 0) & (after & before if begins < ends else after | before)

    def holds(self, filmed_at: str) -> bool:
        """Whether a time (ISO 8601, by the clocks of the place) is of it; empty where it is not known."""
        if not self.limits_time:
            return True
        return bool(self.holding(np.array([hour_filmed(filmed_at)], dtype=np.int64))[0])


#: The names of its limits.
FILMED = ("filmed_from", "filmed_to", "hour_from", "hour_to")


def hour_filmed(filmed_at: str) -> int:
    """Full hours from the beginning of 1970-01-01 to a time as clocks showed it (ISO 8601); -1: empty."""
    if not filmed_at:
        return -1
    return (date.fromisoformat(filmed_at[:10]) - _EPOCH).days * _DAY_H + int(filmed_at[11:13])


def filming_of(row: Mapping[Any, Any]) -> Filming | None:
    """Of a recording's row, or one joined with it; None while nobody has confirmed the start."""
    return None if row["started_at"] is None else Filming(row["started_at"], row["time_zone"])


def start_of(local: str, zone: str, present: datetime) -> Filming:
    """What a person said of a start. Raises BadInput: see `instant_of`; and a start in the future."""
    at = to_millisecond(instant_of(local, zone))
    if at > present:
        raise BadInput(
            "recordings-start-in-future", start=local_text(at, zone)[:16].replace("T", " "), zone=zone
        )
    if at < _EARLIEST:
        raise BadInput("recordings-start-too-early", start=local_text(at, zone)[:10])
    return Filming(at, zone)


def lamps_misfits(street_lighting: StreetLighting | None, lamps: StreetLamps | None) -> list[Said]:
    """What is said where street lighting is said to have been on along a road that is said to have none."""
    return [Said("recordings-misfit-lamps")] if street_lighting == "on" and lamps == "none" else []


def misfits(
    size_px: tuple[int | None, int | None], focal_35mm_mm: float | None, lens: Mapping[str, Any]
) -> list[Said]:
    """Where a recording does not fit its camera's calibration (`sightline-camera-1`)."""
    width, height = size_px
    lens_width, lens_height = lens.get("width_px"), lens.get("height_px")
    if width is None or height is None or lens_width is None or lens_height is None:
        return []
    if (width, height) != (lens_width, lens_height):
        return [
            Said(
                "recordings-misfit-size",
                width=width,
                height=height,
                lens_width=lens_width,
                lens_height=lens_height,
            )
        ]
    fx, fy = lens.get("fx_px"), lens.get("fy_px")
    if focal_35mm_mm is None or fx is None or fy is None:
        return []
    stated_px = focal_35mm_mm / _FILM_DIAGONAL_MM * hypot(width, height)
    ratio = (float(fx) * float(fy)) ** 0.5 / stated_px
    if 1.0 / _FOCAL_RATIO <= ratio <= _FOCAL_RATIO:
        return []
    stated_mm, lens_mm = (float(f"{one:.3g}") for one in (focal_35mm_mm, focal_35mm_mm * ratio))
    return [Said("recordings-misfit-focal", stated_mm=stated_mm, lens_mm=lens_mm)]
