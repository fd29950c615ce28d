"""What a container states of how it was filmed: when it was begun, at what rate, with what focal length."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from av.container import InputContainer

from sightline.media.video.sniff import boxes, states_no_rate

# Clocks that were never set say 1904, 1970 or 1980; digital video of a road is younger.
_EARLIEST = datetime(1995, 1, 1, tzinfo=UTC)
# QuickTime's own has the zone of the place; the others are UTC, or a camera's clock that is taken for it.
_BEGUN = ("com.apple.quicktime.creationdate", "creation_time", "date_utc", "datetimeoriginal", "icrd")
_FOCAL = "com.apple.quicktime.camera.focal_length.35mm_equivalent"
# com.android.capture.fps and what other makers call it; Sony's cameras have captureFps in a box of their own.
_FILMED = re.compile(r".*capture[._-]?(?:fps|frame[._-]?rate)", re.IGNORECASE)
_SONY = re.compile(rb'captureFps="(\d{1,5}(?:\.\d+)?)[pi]?"')
_LONGEST_META = 1_000_000
# QuickTime: 0 where a telephone's recording is to be shown slowly.
_PLAYED_AS_FILMED = "com.apple.quicktime.full-frame-rate-playback-intent"
_NUMBER = re.compile(r"\s*(\d{1,6}(?:\.\d+)?)\s*(?:fps)?\s*", re.IGNORECASE)
_MILLIMETRES = re.compile(r"\s*(\d{1,4}(?:\.\d+)?)\s*(?:mm)?\s*", re.IGNORECASE)


@dataclass(frozen=True)
class Stated:
    """`begun_at`: UTC; `focal_35mm_mm`: the focal length with the same view on 35 mm film; `filmed_hz`:
    pictures a second when it was filmed; `to_be_slow`: it is meant to be shown slowly; `no_rate`: its header
    has 0 in the place of a rate.
    """

    begun_at: datetime | None = None
    focal_35mm_mm: float | None = None
    filmed_hz: float | None = None
    to_be_slow: bool = False
    no_rate: bool = False


def stated_of(container: InputContainer, path: Path) -> Stated:
    """What an open container, the file at `path`, states; None where silent, or where nobody can mean it."""
    tags = {name.lower(): value for name, value in _tags(container)}
    begun = (_instant(tags[name]) for name in _BEGUN if name in tags)
    focal = _MILLIMETRES.fullmatch(tags.get(_FOCAL, ""))
    millimetres = float(focal[1]) if focal else 0.0
    return Stated(
        begun_at=next((one for one in begun if one), None),
        focal_35mm_mm=millimetres if millimetres >= 1.0 else None,
        filmed_hz=_filmed_hz(tags) or _sony_hz(path),
        to_be_slow=tags.get(_PLAYED_AS_FILMED, "").strip() == "0",
        no_rate=states_no_rate(path),
    )


def _filmed_hz(tags: Mapping[str, str]) -> float | None:
    told = (_NUMBER.fullmatch(value) for name, value in tags.items() if _FILMED.fullmatch(name))
    return next((float(one[1]) for one in told if one and float(one[1]) > 0), None)


def _sony_hz(path: Path) -> float | None:
    """From the NonRealTimeMeta that Sony's cameras put beside the index of their MP4 files."""
    for box in boxes(path):
        if box.kind not in (b"meta", b"uuid") or box.end - box.start > _LONGEST_META:
            continue
        with path.open("rb") as file:
            file.seek(box.start)
            told = _SONY.search(file.read(box.end - box.start))
        if told and float(told[1]) > 0:
            return float(told[1])
    return None


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
