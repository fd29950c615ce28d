"""What a container states of how it was filmed: when it was begun, and with what focal length."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime

from av.container import InputContainer

# Clocks that were never set say 1904, 1970 or 1980; digital video of a road is younger.
_EARLIEST = datetime(1995, 1, 1, tzinfo=UTC)
# QuickTime's own has the zone of the place; the others are UTC, or a camera's clock that is taken for it.
_BEGUN = ("com.apple.quicktime.creationdate", "creation_time", "date_utc", "datetimeoriginal", "icrd")
_FOCAL = "com.apple.quicktime.camera.focal_length.35mm_equivalent"
_MILLIMETRES = re.compile(r"\s*(\d{1,4}(?:\.\d+)?)\s*(?:mm)?\s*", re.IGNORECASE)


@dataclass(frozen=True)
class Stated:
    """`begun_at`: UTC; `focal_35mm_mm`: the focal length with the same view on 35 mm film."""

    begun_at: datetime | None = None
    focal_35mm_mm: float | None = None


def stated_of(container: InputContainer) -> Stated:
    """What an open container states; None where it is silent, or where nobody can have meant it."""
    tags = {name.lower(): value for name, value in _tags(container)}
    begun = (_instant(tags[name]) for name in _BEGUN if name in tags)
    focal = _MILLIMETRES.fullmatch(tags.get(_FOCAL, ""))
    millimetres = float(focal[1]) if focal else 0.0
    return Stated(next((one for one in begun if one), None), millimetres if millimetres >= 1.0 else None)


def _tags(container: InputContainer) -> Iterator[tuple[str, str]]:
    """The file's own come last, so they win over those of its streams."""
    for stream in container.streams.video:
        yield from stream.metadata.items()
    yield from container.metadata.items()


def _instant(text: str) -> datetime | None:
    try:
        told = datetime.fromisoformat(text.strip())
        at = told.replace(tzinfo=UTC) if told.tzinfo is None else told.astimezone(UTC)
    except (ValueError, OverflowError):
        return None
    return at if at >= _EARLIEST else None
