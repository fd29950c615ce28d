"""The command stream (docs/formats.md): vehicles from live lines of both cameras, while they pass."""

from __future__ import annotations

import json
import os
import select
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click
import numpy as np

from sightline.commands.scanned import left_out, measured, object_of, rig_of, rig_options
from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.linescan import faults
from sightline.linescan.finding import Finder
from sightline.linescan.parts import Passage, Pixels
from sightline.media.strips.reader import LEAST_ROWS, MOST_ROWS
from sightline.media.strips.spool import Spool

_READ_BYTES = 1 << 20


@click.command()
@click.option("--rows", type=click.IntRange(LEAST_ROWS, MOST_ROWS), required=True, help="Pixels of a line.")
@rig_options
@click.option(
    "--spool",
    type=click.Path(file_okay=False, path_type=Path),
    help="Folder to keep the lines in, as BigTIFF.",
)
def stream(
    rows: int,
    baseline: float,
    line_rate: float,
    u_baseline: float,
    u_line_rate: float,
    method: ScanMethod,
    spool: Path | None,
) -> None:
    """Vehicles from live lines on standard input, a JSON object each as soon as it is measured.

    Lines come in pairs of 8 bit: --rows bytes of camera 1 (top pixel first), as many of camera 2, and so on
    without headers. The end of the input, or Ctrl+C, measures what is complete. With --spool the lines are
    kept in two files that `sightline linescan --time-axis height` reads.
    """
    rig = rig_of(baseline, line_rate, u_baseline, u_line_rate)
    finder = Finder(rows, rig)
    lines = _Lines(sys.stdin.fileno(), rows)
    found = 0
    with _Kept(spool, rows, line_rate) as kept, lines.until_told():
        for vehicle in measured(_passages(lines, finder, kept), rig, method):
            click.echo(json.dumps(object_of(vehicle), allow_nan=False))
            found += vehicle.motion.status == "ok"
    if not lines.count:
        raise BadInput("commands-stream-empty", pair_bytes=2 * rows)
    for said in (*lines.notes, *kept.notes, *faults.notes_of(finder), *left_out(rig, found)):
        click.echo(said, err=True)


class _Lines:
    """The pairs of lines that come from an open file (a descriptor), as many at a time as have come."""

    def __init__(self, source: int, rows: int) -> None:
        self.count, self.notes = 0, list[str]()
        self._source, self._rows = source, rows
        self._told: int | None = None

    def pieces(self) -> Iterator[tuple[Pixels, Pixels]]:
        """Lines of both cameras, (n, rows) each, until the input ends or a signal says so."""
        pair, rest = 2 * self._rows, b""
        while data := self._next():
            data = rest + data
            whole = len(data) // pair * pair
            rest = data[whole:]
            if whole:
                both = np.frombuffer(data, np.uint8, whole).reshape(-1, 2, self._rows)
                self.count += len(both)
                yield np.ascontiguousarray(both[:, 0]), np.ascontiguousarray(both[:, 1])
        if rest:
            self.notes.append(
                f"The input ended in the middle of a pair of lines: its last {len(rest)} bytes are left out; "
                "check --rows, and the cameras."
            )

    @contextmanager
    def until_told(self) -> Iterator[None]:
        """Ctrl+C and a service's stop end the input, never what is being measured."""
        self._told, tell = os.pipe()
        os.set_blocking(tell, False)
        pipe_before = signal.set_wakeup_fd(tell)
        before = {one: signal.signal(one, lambda *_: None) for one in (signal.SIGINT, signal.SIGTERM)}
        try:
            yield
        finally:
            for one, handler in before.items():
                signal.signal(one, handler)
            signal.set_wakeup_fd(pipe_before)
            os.close(tell)
            os.close(self._told)

    def _next(self) -> bytes:
        assert self._told is not None  # within until_told
        ready, _, _ = select.select([self._source, self._told], [], [])
        return b"" if self._told in ready else os.read(self._source, _READ_BYTES)


class _Kept:
    """The lines in two new files of a folder, numbered after those that an earlier run left; or nowhere."""

    def __init__(self, folder: Path | None, rows: int, line_rate_hz: float) -> None:
        self._spools = _spools(folder, rows, line_rate_hz) if folder else []
        self._full: str | None = None

    @property
    def notes(self) -> list[str]:
        said = [f"{spool.lines} lines are kept in {spool.path}." for spool in self._spools]
        return said + ([self._full] if self._full else [])

    def add(self, pieces: tuple[Pixels, Pixels]) -> None:
        """A full disk ends the keeping, never the measuring."""
        if self._full:
            return
        try:
            for spool, piece in zip(self._spools, pieces, strict=False):
                spool.write(piece)
        except OSError as error:
            self._full = (
                f"Lines after these could not be kept ({error.strerror}); they were measured all the same."
            )

    def __enter__(self) -> _Kept:
        return self

    def __exit__(self, *_error: object) -> None:
        for spool in self._spools:
            spool.close()
            if not spool.lines:
                spool.path.unlink()


def _passages(lines: _Lines, finder: Finder, kept: _Kept) -> Iterator[Passage]:
    for pieces in lines.pieces():
        kept.add(pieces)
        yield from finder.push(*pieces)
    if lines.count:
        yield from finder.finish()


def _spools(folder: Path, rows: int, line_rate_hz: float) -> list[Spool]:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        number = 1 + max(
            (int(path.name[:4]) for path in folder.glob("[0-9]" * 4 + "-camera-*.tif")), default=0
        )
        return [Spool(folder / f"{number:04}-camera-{k}.tif", rows, line_rate_hz) for k in (1, 2)]
    except OSError as error:
        raise BadInput(
            "commands-cannot-written-choose-another-place", path=folder, strerror=error.strerror
        ) from None
