"""Line-scan files: one long grey picture each, read in order as (lines, rows) whatever its length.

A strip is line-major: one line a row of memory, time downwards, row 0 the top of the picture. In files time
runs along the width (the scan line stands upright) or along the height (each row of the file is a line, its
left end the top). What is read is PNG, TIFF and BigTIFF, 8 or 16 bit grey; a file is told by its first bytes.

Lines that the recorder says it lost are put back as copies of the line before, so that line n was always
taken at n / line rate (`strips_notes`).
"""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Protocol

import cv2
import numpy as np

from sightline.enums import TimeAxis
from sightline.errors import BadInput
from sightline.linescan.depth import brightest_of, depth_of
from sightline.media.strips import png, tiff
from sightline.media.strips.notes import Dropped, StripNotes, read_notes, with_gaps
from sightline.media.strips.sheet import Pixels, Sheet, unpack_sheet
from sightline.media.video.sniff import why_not_video
from sightline.messages.said import Said

CHUNK_BYTES = 4 << 20
LEAST_ROWS = 8
MOST_ROWS = 16_384
MOST_LINES = 1_000_000_000


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
        """All lines in order, (n, rows) each with n = `lines` (default 1024 or 4 MB) but for the last.

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
        return strip_of(sheet, time_axis, read_notes(name, said, path), work_dir)
    except BaseException:
        sheet.close()
        raise


def strip_of(sheet: Sheet, time_axis: TimeAxis, notes: StripNotes, work_dir: Path | None = None) -> Strip:
    """The strip that a picture is; it owns the picture from now on. Raises BadInput as `open_strip` does."""
    lines, rows = _shape(sheet, time_axis)
    _check_shape(sheet.name, lines, rows, time_axis)
    _check_gaps(sheet.name, lines, notes.dropped)
    return _SheetStrip(sheet, time_axis, notes, work_dir)


def bits_of(strip: Strip) -> int:
    """How many bits its camera has, as all its pixels tell; a strip of 8 bits is not read for it."""
    if strip.dtype == np.uint8:
        return 8
    return depth_of(max(map(brightest_of, strip.chunks()), default=0))


def check_pair(first: Strip, second: Strip) -> None:
    """Refuse two strips that cannot be of one recording. Raises BadInput."""
    if first.rows != second.rows:
        raise BadInput(
            "strips-heights-differ", name=first.name, rows=first.rows, name_2=second.name, rows_2=second.rows
        )
    if first.dtype != second.dtype:
        raise BadInput(
            "strips-bits-differ",
            name=first.name,
            value=8 * first.dtype.itemsize,
            name_2=second.name,
            value_2=8 * second.dtype.itemsize,
        )
    if first.lines != second.lines:
        raise BadInput(
            "strips-lines-differ",
            name=first.name,
            lines=first.lines,
            name_2=second.name,
            lines_2=second.lines,
        )


def chunk_lines(rows: int, item_bytes: int) -> int:
    """How many lines make a chunk: 1024, as in a tile of the stored form, or fewer to stay within 4 MB."""
    return max(16, min(1024, CHUNK_BYTES // (rows * item_bytes)))


def _sheet(path: Path, name: str) -> tuple[Sheet, str]:
    if not path.is_file():
        raise BadInput("strips-not-a-file", name=name)
    try:
        with path.open("rb") as file:
            head = file.read(16)
    except OSError as error:
        raise BadInput("strips-unreadable", name=name, strerror=error.strerror) from None
    if head.startswith(png.MAGIC):
        return png.PngSheet(path, name), ""
    if head[:4] in tiff.MAGICS:
        return tiff.tiff_sheet(path, name)
    if head.startswith(b"\xff\xd8\xff"):
        raise BadInput("strips-jpeg", name=name)
    raise BadInput("strips-not-an-image", name=name, kind=why_not_video(path) or "other")


def _check_shape(name: str, lines: int, rows: int, time_axis: TimeAxis) -> None:
    if rows > MOST_ROWS:
        other = "height" if time_axis == "width" else "width"
        other_way = Said("strips-say-time-axis", axis=other)
        hint = other_way if lines <= MOST_ROWS else Said("strips-give-one-strip")
        raise BadInput(
            "strips-lines-too-wide", name=name, rows=rows, time_axis=time_axis, most_rows=MOST_ROWS, hint=hint
        )
    if rows < LEAST_ROWS or lines < 2:
        raise BadInput("strips-time-axis-wrong", name=name, lines=lines, rows=rows, time_axis=time_axis)
    if lines > MOST_LINES:
        raise BadInput("strips-too-many-lines", name=name, most_lines=MOST_LINES // 10**9)


def _check_gaps(name: str, lines: int, dropped: Sequence[Dropped]) -> None:
    lost = sum(gap.count for gap in dropped)
    if lost > lines // 2:
        raise BadInput("strips-lost-lines-many", name=name, lost=lost, lines=lines + lost)
    if dropped and dropped[-1].line >= lines:
        raise BadInput("strips-lost-lines-outside", name=name, line=dropped[-1].line, lines=lines)


def _shape(sheet: Sheet, time_axis: TimeAxis) -> tuple[int, int]:
    """(lines, rows) of a picture."""
    upright = (sheet.height_px, sheet.width_px)
    return upright if time_axis == "height" else (upright[1], upright[0])


class _SheetStrip:
    """A strip out of a picture."""

    def __init__(self, sheet: Sheet, time_axis: TimeAxis, notes: StripNotes, work_dir: Path | None) -> None:
        self.name, self.dtype, self.notes = sheet.name, sheet.dtype, notes
        self.lines, self.rows = _shape(sheet, time_axis)
        self.lines += sum(gap.count for gap in notes.dropped)
        self._sheet, self._axis, self._work_dir = sheet, time_axis, work_dir

    def chunks(self, lines: int | None = None) -> Iterator[Pixels]:
        lines = lines or chunk_lines(self.rows, self.dtype.itemsize)
        at_once = max(lines, CHUNK_BYTES // (self.rows * self.dtype.itemsize))
        pieces = with_gaps(self._pieces(at_once), self.notes.dropped, lines)
        return rebatch_lines(pieces, lines)

    def close(self) -> None:
        self._sheet.close()

    def _pieces(self, lines: int) -> Iterator[Pixels]:
        if self._axis == "height":
            yield from self._sheet.bands()
            return
        slabs = self._sheet.slabs(lines)
        if slabs is not None:
            yield from (_transpose(slab) for slab in slabs)
            return
        turned = unpack_sheet(self._sheet, self._work_dir)
        try:
            slabs = turned.slabs(lines)
            assert slabs is not None
            yield from (_transpose(slab) for slab in slabs)
        finally:
            turned.close()


def _transpose(slab: Pixels) -> Pixels:
    return np.asarray(cv2.transpose(slab), slab.dtype)


def rebatch_lines(pieces: Iterator[Pixels], lines: int) -> Iterator[Pixels]:
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
