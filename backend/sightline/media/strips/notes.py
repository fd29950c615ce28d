"""What a recorder writes beside a strip: its line rate, and the lines that it lost.

Lost lines are put back as copies of the line before, so that line n was always taken at n / line rate;
`column_of` leads back to the file's own lines, `lost_lines` says where nothing can be measured.
"""

import json
import math
import sys
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sightline.errors import BadInput
from sightline.linescan.parts import Crossings
from sightline.media.strips.sheet import Pixels

_SIDECAR_BYTES = 10_000_000


@dataclass(frozen=True)
class Dropped:
    """So many lines were lost just before line `line` of the file."""

    line: int
    count: int


@dataclass(frozen=True)
class StripNotes:
    """What a recorder wrote beside the pixels; None or empty where it is silent."""

    line_rate_hz: float | None = None
    dropped: tuple[Dropped, ...] = ()


def read_notes(name: str, description: str, path: Path) -> StripNotes:
    """From a JSON file beside the picture (its name and ".json"), else from the TIFF's description."""
    sidecar = path.with_name(path.name + ".json")
    what = f"The notes in {sidecar.name}"
    if sidecar.is_file():
        if sidecar.stat().st_size > _SIDECAR_BYTES:
            raise BadInput("strips-notes-too-large", what=what, sidecar_bytes=_SIDECAR_BYTES // 10**6)
        try:
            document = json.loads(sidecar.read_bytes())
        except (ValueError, RecursionError):
            raise BadInput("strips-notes-not-json", what=what) from None
    else:
        what = f"The description inside {name}"
        try:
            document = json.loads(description)
        except (ValueError, RecursionError):
            return StripNotes()
        if not isinstance(document, dict) or not {"line_rate_hz", "dropped_lines"} & document.keys():
            return StripNotes()
    return notes_of(document, what)


def notes_of(document: object, what: str) -> StripNotes:
    """Notes from JSON: `line_rate_hz` (number or null), `dropped_lines` (list of [line, count], each the
    number of lines lost just before that line of the file). Raises BadInput, beginning with `what`.
    """
    if not isinstance(document, dict):
        raise BadInput("strips-notes-not-object", what=what)
    rate = document.get("line_rate_hz")
    if rate is not None and not _is_number(rate, 0.0):
        raise BadInput("strips-rate-not-positive", what=what)
    dropped = document.get("dropped_lines") or []
    pairs = isinstance(dropped, list) and all(
        isinstance(one, list) and len(one) == 2 and all(type(n) is int and n >= 0 for n in one)
        for one in dropped
    )
    if not pairs or dropped != sorted(dropped):
        raise BadInput("strips-dropped-lines-form", what=what)
    found = tuple(Dropped(line, count) for line, count in dropped if count)
    return StripNotes(float(rate) if rate is not None else None, found)


def _is_number(value: object, above: float) -> bool:
    return type(value) in (int, float) and above < value <= sys.float_info.max  # type: ignore[operator]


def with_gaps(pieces: Iterator[Pixels], dropped: Sequence[Dropped], most: int) -> Iterator[Pixels]:
    """The same lines with the lost ones put back as copies of the line before, `most` at a time."""
    gaps = deque(dropped)
    first = 0
    before: Pixels | None = None
    for piece in pieces:
        while gaps and gaps[0].line < first + len(piece):
            gap = gaps.popleft()
            head = piece[: gap.line - first]
            yield head
            piece, first = piece[len(head) :], gap.line
            line = head[-1] if len(head) else piece[0] if before is None else before
            for done in range(0, gap.count, most):
                yield np.repeat(line[None], min(most, gap.count - done), axis=0)
        yield piece
        first += len(piece)
        before = piece[-1] if len(piece) else before


def lost_lines(dropped: Sequence[Dropped], start: float, stop: float) -> int:
    """How many lines from `start` to `stop` (line numbers that count the lost ones) were not recorded."""
    lost = before = 0
    for gap in dropped:
        begin = gap.line + before
        lost += max(0, min(math.ceil(stop), begin + gap.count) - max(math.floor(start), begin))
        before += gap.count
    return lost


def column_of(line: float, dropped: Sequence[Dropped]) -> float:
    """The fractional column of the file for a line number that counts the lost lines too.

    Within a gap it is the middle between the columns beside it.
    """
    lost = 0
    for gap in dropped:
        begin = gap.line + lost
        if line <= begin - 0.5:
            break
        if line < begin + gap.count - 0.5:
            return gap.line - 0.5
        lost += gap.count
    return line - lost


def columns_of(crossings: Crossings, first: Sequence[Dropped], second: Sequence[Dropped]) -> Crossings:
    """The same crossings as columns of both files; what was lost of each."""
    if not first and not second:
        return crossings
    return Crossings(
        column_of(crossings.front_line_1, first),
        column_of(crossings.rear_line_1, first),
        column_of(crossings.front_line_2, second),
        column_of(crossings.rear_line_2, second),
    )
