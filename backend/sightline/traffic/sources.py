"""Recordings as the command line writes them: `sightline linescan --json`, or the lines of `stream`."""

import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import fields
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any, TypeGuard, get_args

from sightline.enums import ScanDirection
from sightline.errors import BadInput
from sightline.linescan.finding import LENGTHS_M
from sightline.traffic.records import Passing, Recorded

_LARGEST_BYTES = 2_000_000_000
_LARGEST = 1e12
_HEAD_BYTES = 100_000
_NAMES = {"number": "id"}
_WORDS = ("status", "reason", "lane", "direction")
_CLOSED = {"direction": get_args(ScanDirection)}
_COUNTS = ("number", "axles")
#: Of a vehicle always; any other may be null.
_NEEDED = ("number", "front_s", "front_line_1", "status")


def read_recorded(path: Path, duration_s: float | None) -> Recorded:
    """One recording's vehicles out of a file: one JSON object with `vehicles`, or one object a line.

    duration_s: how long the recording lasted; only for lines of `stream`, which do not say it. Raises
    BadInput naming the file, and the vehicle where it is one's.
    """
    data = bytes_of(path)
    whole, vehicles = vehicles_in(path, data)
    if whole is not None:
        if duration_s is not None:
            raise BadInput("traffic-duration-twice", path=path)
        duration_s = whole["duration_s"]
    elif duration_s is None:
        raise BadInput("traffic-no-duration", path=path)
    passings = tuple(passing_of(path, one, at) for at, one in enumerate(vehicles, 1))
    assert duration_s is not None
    check_passings(path, passings, duration_s)
    lanes = _lanes(path, whole, passings)
    sha256 = hashlib.sha256(data).hexdigest()
    return Recorded(
        name=path.name,
        sha256=sha256,
        duration_s=float(duration_s),
        passings=passings,
        lanes=lanes,
        u_start_s=u_told(whole, "u_start_s"),
        u_line_rate_ratio=u_told(whole, "u_line_rate_ratio"),
        begun=_begun_of(vehicles) if whole is None else instant_told(whole.get("start")),
    )


def vehicles_in(path: Path, data: bytes) -> tuple[dict[str, Any] | None, list[Any]]:
    """What is said of a whole recording, None in lines of `stream`, and its vehicles. Raises BadInput."""
    whole = _object_of(data)
    if whole is None or "vehicles" not in whole:
        return None, _on_one_clock([row | _told_before(row) for row in _lines_of(path, data)])
    if not is_number(whole.get("duration_s")):
        raise BadInput("traffic-no-duration-inside", path=path)
    if not isinstance(whole["vehicles"], list):
        raise BadInput("traffic-no-recording", path=path)
    return whole, whole["vehicles"]


def is_of_nobody(data: bytes) -> bool:
    """Whether it is the JSON of a recording that nobody passed."""
    whole = _object_of(data)
    return whole is not None and whole.get("vehicles") == [] and is_number(whole.get("duration_s"))


def _lanes(path: Path, whole: dict[str, Any] | None, passings: tuple[Passing, ...]) -> tuple[str, ...]:
    """Names of the rig's lanes: those that the file tells of, and those of its vehicles."""
    lanes = (whole or {}).get("lanes", [])
    if not isinstance(lanes, list) or not all(
        isinstance(one, dict) and isinstance(one.get("name"), str) for one in lanes
    ):
        raise BadInput("traffic-no-recording", path=path)
    names = [one["name"] for one in lanes] + [one.lane for one in passings if one.lane is not None]
    return tuple(dict.fromkeys(names))


def bytes_of(path: Path, mark: bytes = b"") -> bytes:
    """A file's bytes; none where its beginning lacks the mark. Raises BadInput where it cannot be read or is
    too large.
    """
    try:
        with path.open("rb") as file:
            head = file.read(_HEAD_BYTES)
            if mark not in head:
                return b""
            if os.fstat(file.fileno()).st_size > _LARGEST_BYTES:
                raise BadInput("traffic-file-too-large", path=path, most_gb=_LARGEST_BYTES // 10**9)
            return head + file.read()
    except OSError as error:
        raise BadInput("traffic-cannot-read", path=path, strerror=error.strerror) from None


def _object_of(data: bytes) -> dict[str, Any] | None:
    try:
        found = json.loads(data)
    except (ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) else None


def _lines_of(path: Path, data: bytes) -> list[Any]:
    try:
        rows = [json.loads(line) for line in data.splitlines() if line.strip()]
    except (ValueError, RecursionError):
        raise BadInput("traffic-no-recording", path=path) from None
    if not all(isinstance(one, dict) and "front_line_1" in one for one in rows):
        raise BadInput("traffic-no-recording", path=path)
    return rows


def _told_before(row: dict[str, Any]) -> dict[str, Any]:
    """Of a line of `stream`: seconds count from the stream's begin, lines from its segment's."""
    line, front_s = row.get("front_line_1"), row.get("front_s")
    return {"told_before": is_number(line) and is_number(front_s) and line <= 0 < front_s}


def _on_one_clock(rows: list[Any]) -> list[Any]:
    """Lines of `stream`, whose seconds begin anew where it was resumed: all from line 0 of the first run, as
    `front_at` tells them, and every vehicle once.

    One may be printed again after a stop: two of one number that were before camera 1 at one time are one.
    Of a rear that nobody saw the front alone tells when. Lines without their time of day stay as they are.
    """
    known = [
        (at, row)
        for row in rows
        if (at := instant_told(row.get("front_at"))) and is_number(row.get("front_s"))
    ]
    if not rows or len(known) < len(rows):
        return rows
    begun = [at - timedelta(seconds=row["front_s"]) for at, row in known]
    out, spans = [], dict[Any, list[tuple[float, float]]]()
    for row, own in zip(rows, begun, strict=True):
        late_s = (own - min(begun)).total_seconds()
        times = {name: row[name] + late_s for name in ("front_s", "rear_s") if is_number(row.get(name))}
        front_s, rear_s = times["front_s"], times.get("rear_s", times["front_s"])
        before = spans.setdefault(row.get("id"), [])
        if not any(front_s <= rear and front <= rear_s for front, rear in before):
            before.append((front_s, rear_s))
            out.append(row | times)
    return out


def _begun_of(rows: Sequence[Any]) -> datetime | None:
    """When line 0 of lines of `stream` was taken, by their times of day, which have milliseconds."""
    return min(
        (
            at - timedelta(milliseconds=round(1000 * row["front_s"]))
            for row in rows
            if (at := instant_told(row.get("front_at")))
        ),
        default=None,
    )


def instant_told(said: object) -> datetime | None:
    """A time of day with its offset from UTC; None for anything else."""
    try:
        at = datetime.fromisoformat(said) if isinstance(said, str) else None
    except ValueError:
        return None
    return at if at is not None and at.tzinfo is not None else None


def passing_of(path: Path, document: Any, at: int | str) -> Passing:
    """A vehicle of the JSON. Raises BadInput naming it where a value is missing or is none that can be."""
    if not isinstance(document, dict):
        raise BadInput("traffic-no-recording", path=path)
    held: dict[str, Any] = {}
    for name in (one.name for one in fields(Passing)):
        value = document.get(_NAMES.get(name, name))
        if name == "told_before":
            held[name] = value is True
        elif value is None and name not in _NEEDED:
            held[name] = None
        elif name in _WORDS and isinstance(value, str) and value in _CLOSED.get(name, (value,)):
            held[name] = value
        elif name not in _WORDS and is_number(value) and _can_be(name, value):
            held[name] = int(value) if name in _COUNTS else float(value)
        else:
            raise BadInput("traffic-vehicle-without", path=path, vehicle=at, column=_NAMES.get(name, name))
    return Passing(**held)


def _can_be(name: str, value: float) -> bool:
    """Whether a scanned vehicle may have this number: a count is whole, and no u lies below 0."""
    if name in _COUNTS:
        return value == int(value)
    if name == "length_m":
        return 0.0 < value <= LENGTHS_M[1]
    if name == "speed_mps":
        return value > 0.0
    return value >= 0.0 or not name.startswith("u_")


def check_passings(path: Path, passings: Sequence[Passing], duration_s: float) -> None:
    """A vehicle outside its recording, or two with one number, are of another recording or time: BadInput."""
    seen = set[int]()
    for passing in passings:
        if passing.number in seen:
            raise BadInput("traffic-number-twice", path=path, vehicle=passing.number)
        seen.add(passing.number)
        rear_s = passing.front_s if passing.rear_s is None else passing.rear_s
        if not 0 <= passing.front_s <= rear_s <= duration_s:
            raise BadInput(
                "traffic-outside-recording",
                path=path,
                vehicle=passing.number,
                front_s=round(passing.front_s, 3),
                rear_s=round(rear_s, 3),
                duration_s=round(duration_s, 3),
            )


def u_told(whole: Mapping[str, Any] | None, name: str) -> float:
    """A standard uncertainty of a whole recording; 0 where it is not told."""
    told = (whole or {}).get(name)
    return float(told) if is_number(told) and told > 0 else 0.0


def is_number(value: object) -> TypeGuard[float]:
    """A number of JSON, of any size that seconds, lines and metres have."""
    return type(value) in (int, float) and abs(value) <= _LARGEST  # type: ignore[arg-type]
