"""GigE Vision cameras: Aravis's own fake cameras, one of them losing packets; skipped where Aravis is not."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.media.lines.gige import GigeLines, require_aravis
from sightline.media.lines.source import Ending, Piece

ROWS, FRAME = 256, 32
SYSTEM = Path("/usr/lib/python3/dist-packages")  # where Debian and Ubuntu keep PyGObject


@pytest.fixture
def aravis(monkeypatch: pytest.MonkeyPatch) -> Any:
    if "gi" not in sys.modules:
        monkeypatch.syspath_prepend(str(SYSTEM))
    try:
        found = require_aravis()
    except BadInput as error:
        pytest.skip(str(error))
    found.enable_interface("Fake")
    return found


@pytest.fixture
def ending() -> Iterator[Ending]:
    made = Ending()
    yield made
    made.close()


def fake(aravis: Any, serial: str, lost_ratio: float) -> Any:
    camera = aravis.GvFakeCamera.new("127.0.0.1", serial)
    if not camera.is_running():
        pytest.skip("The fake camera's port is taken.")
    camera.set_property("gvsp-lost-ratio", lost_ratio)
    return camera


def taken(source: GigeLines, ending: Ending, lines: int) -> list[Piece]:
    pieces: list[Piece] = []
    for piece in source.pieces():
        if piece is not None:
            pieces.append(piece)
        if sum(len(one.first) for one in pieces) >= lines:
            ending.wish()
    return pieces


@pytest.mark.parametrize("lost_ratio", [0.0, 0.05])
def test_lost_packets_are_lost_lines_and_nothing_after_them_is_shifted(
    aravis: Any, ending: Ending, lost_ratio: float
) -> None:
    camera = fake(aravis, "SL1", lost_ratio)
    source = GigeLines("127.0.0.1", "Fake_1", ROWS, 1600.0, ending, FRAME)
    pieces = taken(source, ending, 60 * FRAME)
    del camera
    assert all(one.first.shape == one.second.shape and one.first.shape[1] == ROWS for one in pieces)
    lost = [gap for piece in pieces for gap in piece.lost]
    assert not [gap for gap in lost if gap.camera == 2]
    assert bool(lost) == bool(lost_ratio)
    both = np.concatenate([piece.first for piece in pieces])
    for gap in lost:
        assert gap.line % FRAME == 0 and gap.count == FRAME
        if gap.line and gap.line + gap.count <= len(both):
            assert (both[gap.line : gap.line + gap.count] == both[gap.line - 1]).all()
    assert not source.broken


def test_a_camera_that_goes_silent_is_said_and_ends_the_stream(
    aravis: Any, ending: Ending, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sightline.media.lines.gige._GONE_S", 0.5)
    camera = fake(aravis, "SL2", 0.0)
    source = GigeLines("127.0.0.1", "Fake_1", ROWS, 1600.0, ending, FRAME)
    lines = 0
    for piece in source.pieces():
        lines += 0 if piece is None else len(piece.first)
        if lines >= 10 * FRAME:
            camera.set_property("gvsp-lost-ratio", 1.0)
    assert source.broken and lines >= 10 * FRAME
    assert "Camera 1 (127.0.0.1)" in source.notes[0] and "all lines before were taken" in source.notes[0]
    del camera


def test_a_camera_that_is_not_there_is_named(aravis: Any, ending: Ending) -> None:
    with pytest.raises(BadInput, match="Camera nobody cannot be opened"):
        GigeLines("nobody", "Fake_1", ROWS, 1600.0, ending, FRAME)
