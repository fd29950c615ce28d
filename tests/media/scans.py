"""Strips out of the demonstration's traffic, for the command line and the benches; nothing is held whole."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sightline.media.strips.notes import StripNotes
from sightline.media.strips.reader import rebatch_lines
from sightline.media.strips.sheet import Pixels
from sightline.media.strips.stored_writer import StoredStrip, store_strip
from tests.simulation.scan_strips import recording
from tests.simulation.scan_traffic import ScanSite, ScanVehicle

Pairs = Callable[[], Iterator[tuple[Pixels, Pixels]]]


class Fed:
    """A strip of what somebody else makes, `times` over."""

    notes = StripNotes()
    dtype: np.dtype[Any] = np.dtype(np.uint8)

    def __init__(
        self, name: str, lines: int, rows: int, chunks: Callable[[], Iterator[Pixels]], times: int
    ) -> None:
        self.name, self.lines, self.rows = name, lines * times, rows
        self._chunks, self._times = chunks, times

    def chunks(self, lines: int | None = None) -> Iterator[Pixels]:
        return rebatch_lines((one for _ in range(self._times) for one in self._chunks()), lines or 1024)

    def close(self) -> None: ...


def stored_pair(
    folder: Path, site: ScanSite, cars: tuple[ScanVehicle, ...], seconds: float, times: int = 1
) -> tuple[StoredStrip, StoredStrip]:
    """Both stored forms, first.strip.tif and second.strip.tif; the pixels lie on disk in between."""
    folder.mkdir(parents=True, exist_ok=True)
    raw = [folder / "first.raw", folder / "second.raw"]
    with raw[0].open("wb") as one, raw[1].open("wb") as two:
        for first, second in recording(site, cars, seconds):
            one.write(first.tobytes())
            two.write(second.tobytes())
    made = []
    for path in raw:
        lines = path.stat().st_size // site.rows

        def chunks(path: Path = path) -> Iterator[Pixels]:
            with path.open("rb") as file:
                while data := file.read(1024 * site.rows):
                    yield np.frombuffer(data, np.uint8).reshape(-1, site.rows)

        strip = Fed(path.stem, lines, site.rows, chunks, times)
        made.append(store_strip(strip, folder / f"{path.stem}.strip.tif"))
        path.unlink()
    return made[0], made[1]
