"""GigE Vision cameras: Aravis's own fake cameras, one of them losing packets; skipped where Aravis is not."""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
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


class Given:
    """Stands for Aravis: each camera gives frames of these numbers, every line of which is its number."""

    PIXEL_FORMAT_MONO_8, BufferStatus = 1, SimpleNamespace(SUCCESS=0)

    def __init__(self, **numbers: list[int]) -> None:
        self._numbers = numbers
        self.Camera = SimpleNamespace(new=self._camera)
        self.Buffer = SimpleNamespace(new_allocate=lambda payload: None)

    def _camera(self, name: str) -> Any:
        left = deque(self._numbers[name])

        def pop(_us: int = 0) -> Any:
            if not left:
                return None
            number = left.popleft()
            lines = np.full(ROWS * FRAME, abs(number) % 256, np.uint8).tobytes()
            return SimpleNamespace(
                get_frame_id=lambda: abs(number), get_status=lambda: int(number < 0), get_data=lambda: lines
            )

        stream = SimpleNamespace(push_buffer=lambda one: None, timeout_pop_buffer=pop, try_pop_buffer=pop)
        nothing = dict.fromkeys(
            ("set_region", "set_pixel_format", "start_acquisition", "stop_acquisition"), lambda *_: None
        )
        return SimpleNamespace(
            **nothing,
            is_frame_rate_available=lambda: False,
            get_region=lambda: (0, 0, ROWS, FRAME),
            create_stream=lambda *_: stream,
            get_payload=lambda: ROWS * FRAME,
            get_device=lambda: SimpleNamespace(connect=lambda *_: None),
        )


def given(monkeypatch: pytest.MonkeyPatch, ending: Ending, one: list[int], two: list[int]) -> GigeLines:
    monkeypatch.setattr("sightline.media.lines.gige.require_aravis", lambda: Given(one=one, two=two))
    monkeypatch.setattr("sightline.media.lines.gige._GONE_S", 0.2)
    return GigeLines("one", "two", ROWS, 1600.0, ending, FRAME)


@pytest.mark.parametrize(("begin", "lost"), [([2, 3], 1), ([-1, 2, 3], 1), ([-1, 3], 2), ([1, 2, 3], 0)])
def test_a_first_frame_that_is_lost_shifts_nothing(
    monkeypatch: pytest.MonkeyPatch, ending: Ending, begin: list[int], lost: int
) -> None:
    """It never came, or spoilt (here below 0): all lines of camera 1 were a frame too early."""
    pieces = taken(given(monkeypatch, ending, [*begin, 4, 5], [1, 2, 3, 4, 5]), ending, 5 * FRAME)
    first, second = (np.concatenate([getattr(one, name) for one in pieces]) for name in ("first", "second"))
    assert first.shape == second.shape == (5 * FRAME, ROWS)
    assert (first[lost * FRAME :] == second[lost * FRAME :]).all() and (
        first[: lost * FRAME] == 1 + lost
    ).all()
    gaps = [(gap.camera, gap.line, gap.count) for piece in pieces for gap in piece.lost]
    assert gaps == [(1, n * FRAME, FRAME) for n in range(lost)]


def test_a_camera_whose_numbers_do_not_tell_what_was_lost_ends_the_stream(
    monkeypatch: pytest.MonkeyPatch, ending: Ending
) -> None:
    source = given(monkeypatch, ending, [1, 2, 3], [4000, 4001])
    assert taken(source, ending, 3 * FRAME) == [] and source.broken
    (note,) = source.notes
    assert "The first frame of camera 2 (two) has number 4000" in note
    # those that would stand in the place of 3,999 frames would take gigabytes
    assert source._cameras[1].held_lines == 0


def test_a_camera_that_is_not_there_is_named(aravis: Any, ending: Ending) -> None:
    with pytest.raises(BadInput, match="Camera nobody cannot be opened"):
        GigeLines("nobody", "Fake_1", ROWS, 1600.0, ending, FRAME)
