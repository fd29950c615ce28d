"""Line-scan files: one long grey picture each, read in order as (lines, rows) whatever its length.

A strip is line-major: one line a row of memory, time downwards, row 0 the top of the picture. In files time
runs along the width (the scan line stands upright) or along the height (each row of the file is a line, its
left end the top). What is read is PNG, TIFF and BigTIFF, 8 or 16 bit grey; a file is told by its first bytes.

Lines that the recorder says it lost are put back as copies of the line before, so that line n was always
taken at n / line rate; `column_of` leads back to the file's own lines.
"""

from __future__ import annotations

import json
import math
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, Protocol

import cv2
import numpy as np

from backend.errors import BadInput
from backend.media import strips_png, strips_tiff
from backend.media.sniff import why_not_video
from backend.media.strips_sheet import Pixels, Sheet, unpacked

TimeAxis = Literal["width", "height"]
CHUNK_BYTES = 4 << 20
LEAST_ROWS = 8
MOST_ROWS = 16_384
MOST_LINES = 1_000_000_000
_SIDECAR_BYTES = 10_000_000
_CHOOSE = "give a PNG or TIFF of the line-scan camera"


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


class Strip(Protocol):
    """One camera's lines. `name` is what people call it; `chunks` may be called again. Close it after use."""

    @property
    def name(self) -> str: ...
    @property
    def lines(self) -> int: ...
    @property
    def rows(self) -> int: ...
    @property
    def dtype(self) -> np.dtype[Any]: ...
    @property
    def notes(self) -> StripNotes: ...

    def chunks(self, lines: int | None = None) -> Iterator[Pixels]:
        """All lines in order, (n, rows) each with n = `lines` (default: 4 MB) but for the last.

        Raises BadInput where the file is damaged or cut off.
        """

    def close(self) -> None: ...


def open_strip(
    path: Path, time_axis: TimeAxis = "width", *, name: str | None = None, work_dir: Path | None = None
) -> Strip:
    """Open a strip; its header is checked, no pixel is read. `work_dir` is for the temporary file that some
    packed files with time along their width need (as large as the pixels).

    Raises BadInput with one sentence for whatever is no grey picture of 8 to 16,384 pixels a line.
    """
    name = name or path.name
    sheet, said = _sheet(path, name)
    try:
        return strip_of(sheet, time_axis, _notes(name, said, path), work_dir)
    except BaseException:
        sheet.close()
        raise


def strip_of(sheet: Sheet, time_axis: TimeAxis, notes: StripNotes, work_dir: Path | None = None) -> Strip:
    """The strip that a picture is; it owns the picture from now on. Raises BadInput as `open_strip` does."""
    lines, rows = _shape(sheet, time_axis)
    _check_shape(sheet.name, lines, rows, time_axis)
    _check_gaps(sheet.name, lines, notes.dropped)
    return _SheetStrip(sheet, time_axis, notes, work_dir)


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


def chunk_lines(rows: int, item_bytes: int) -> int:
    """How many lines make a chunk of about 4 MB."""
    return max(16, CHUNK_BYTES // (rows * item_bytes))


def _sheet(path: Path, name: str) -> tuple[Sheet, str]:
    if not path.is_file():
        raise BadInput(f"{name} is not a file; {_CHOOSE}.")
    try:
        with path.open("rb") as file:
            head = file.read(16)
    except OSError as error:
        raise BadInput(f"{name} cannot be read ({error.strerror}); {_CHOOSE}.") from None
    if head.startswith(strips_png.MAGIC):
        return strips_png.PngSheet(path, name), ""
    if head[:4] in strips_tiff.MAGICS:
        return strips_tiff.tiff_sheet(path, name)
    if head.startswith(b"\xff\xd8\xff"):
        raise BadInput(f"{name} is a JPEG, which changes the pixels; save it as PNG or TIFF in the recorder.")
    what = (why_not_video(path) or "is not a picture that is read here").removesuffix(", not a video")
    raise BadInput(f"{name} {what}; {_CHOOSE}.")


def _check_shape(name: str, lines: int, rows: int, time_axis: TimeAxis) -> None:
    if rows > MOST_ROWS:
        other = "height" if time_axis == "width" else "width"
        hint = f"if time runs along its {other}, say so" if lines <= MOST_ROWS else "give one camera's strip"
        raise BadInput(
            f"{name} would have {rows} pixels a line with time along its {time_axis}, more than "
            f"{MOST_ROWS}; {hint}."
        )
    if rows < LEAST_ROWS or lines < 2:
        raise BadInput(
            f"{name} has {lines} lines of {rows} pixels with time along its {time_axis}, which shows no "
            f"vehicle; {_CHOOSE}."
        )
    if lines > MOST_LINES:
        raise BadInput(
            f"{name} has more than {MOST_LINES // 10**9} thousand million lines; cut it into parts."
        )


def _check_gaps(name: str, lines: int, dropped: Sequence[Dropped]) -> None:
    lost = sum(gap.count for gap in dropped)
    if lost > lines // 2:
        raise BadInput(
            f"{name}: its notes say that {lost} lines were lost of {lines + lost}; record it again."
        )
    if dropped and dropped[-1].line >= lines:
        raise BadInput(
            f"{name}: its notes name lost lines at {dropped[-1].line}, but it ends at {lines}; correct them."
        )


def _shape(sheet: Sheet, time_axis: TimeAxis) -> tuple[int, int]:
    """(lines, rows) of a picture."""
    upright = (sheet.height_px, sheet.width_px)
    return upright if time_axis == "height" else (upright[1], upright[0])


def _notes(name: str, said: str, path: Path) -> StripNotes:
    """From a JSON file beside the picture (its name and ".json"), else from the TIFF's description."""
    beside = path.with_name(path.name + ".json")
    what = f"The notes in {beside.name}"
    if beside.is_file():
        if beside.stat().st_size > _SIDECAR_BYTES:
            raise BadInput(
                f"{what} are larger than {_SIDECAR_BYTES // 10**6} MB; correct or remove that file."
            )
        try:
            document = json.loads(beside.read_bytes())
        except (ValueError, RecursionError):
            raise BadInput(f"{what} are not readable JSON; correct or remove that file.") from None
    else:
        what = f"The description inside {name}"
        try:
            document = json.loads(said)
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
        raise BadInput(f"{what} are no JSON object; correct them.")
    rate = document.get("line_rate_hz")
    if rate is not None and not _is_number(rate, 0.0):
        raise BadInput(f"{what} give a line_rate_hz that is no positive number; correct it.")
    dropped = document.get("dropped_lines") or []
    pairs = isinstance(dropped, list) and all(
        isinstance(one, list) and len(one) == 2 and all(type(n) is int and n >= 0 for n in one)
        for one in dropped
    )
    if not pairs or dropped != sorted(dropped):
        raise BadInput(f"{what} give dropped_lines that are no list of [line, count] in order; correct them.")
    found = tuple(Dropped(line, count) for line, count in dropped if count)
    return StripNotes(float(rate) if rate is not None else None, found)


def _is_number(value: object, above: float) -> bool:
    return type(value) in (int, float) and math.isfinite(value) and value > above  # type: ignore[arg-type, operator]


class _SheetStrip:
    """A strip out of a picture."""

    def __init__(self, sheet: Sheet, time_axis: TimeAxis, notes: StripNotes, work_dir: Path | None) -> None:
        self.name, self.dtype, self.notes = sheet.name, sheet.dtype, notes
        self.lines, self.rows = _shape(sheet, time_axis)
        self.lines += sum(gap.count for gap in notes.dropped)
        self._sheet, self._axis, self._work_dir = sheet, time_axis, work_dir

    def chunks(self, lines: int | None = None) -> Iterator[Pixels]:
        lines = lines or chunk_lines(self.rows, self.dtype.itemsize)
        pieces = with_gaps(self._pieces(lines), self.notes.dropped, lines)
        return rebatched(pieces, lines)

    def close(self) -> None:
        self._sheet.close()

    def _pieces(self, lines: int) -> Iterator[Pixels]:
        if self._axis == "height":
            yield from self._sheet.bands()
            return
        slabs = self._sheet.slabs(lines)
        if slabs is not None:
            yield from (_turned(slab) for slab in slabs)
            return
        turned = unpacked(self._sheet, self._work_dir)
        try:
            slabs = turned.slabs(lines)
            assert slabs is not None
            yield from (_turned(slab) for slab in slabs)
        finally:
            turned.close()


def _turned(slab: Pixels) -> Pixels:
    return np.asarray(cv2.transpose(slab), slab.dtype)


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


def rebatched(pieces: Iterator[Pixels], lines: int) -> Iterator[Pixels]:
    """The same lines in blocks of `lines`, the last one shorter; copied only where blocks straddle pieces."""
    held: list[Pixels] = []
    count = 0
    for piece in pieces:
        while count + len(piece) >= lines:
            held.append(piece[: lines - count])
            piece = piece[lines - count :]
            yield held[0] if len(held) == 1 else np.concatenate(held)
            held, count = [], 0
        if len(piece):
            held.append(piece)
            count += len(piece)
    if held:
        yield held[0] if len(held) == 1 else np.concatenate(held)
