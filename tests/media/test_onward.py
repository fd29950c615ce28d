"""What is made ahead: the right frames in the right order, bounded, and never in anybody's way."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from sightline.enums import Display
from sightline.errors import Damaged
from sightline.media.video import prefetch
from sightline.media.video.frames import FrameServer
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import CancelCheck, NoLongerWanted, Window
from tests.support.waiting import NEVER_S, until

COUNT = 100
MEDIA = RecordingMedia(
    Path("none.mp4"),
    np.arange(COUNT),
    np.arange(COUNT, dtype=np.uint32),
    np.zeros(COUNT, np.bool_),
)


class Pictures(Window):
    """Stands in for a decoder: notes what it was asked for, and may be slow, lost or stopped."""

    def __init__(self) -> None:
        super().__init__(1_000_000)
        self.asked: list[int] = []
        self.decoded: set[int] = set()
        self.lost: set[int] = set()
        self.slow: set[int] = set()
        self.hears = True
        self.dropped: list[int] = []
        self.size = 1000

    def still(
        self, media: RecordingMedia, n: int, wanted: CancelCheck, display: Display, *, ahead: bool = False
    ) -> bytes:
        self.asked.append(n)
        end = time.monotonic() + NEVER_S
        while n in self.slow and time.monotonic() < end:
            if self.hears and not wanted():
                self.dropped.append(n)
                raise NoLongerWanted("no longer")
            time.sleep(0.01)
        if n in self.lost:
            raise Damaged("said", sentence="lost")
        self.decoded.add(n)
        return bytes([n]) * self.size

    def warm(self, media: RecordingMedia) -> list[int]:
        return sorted(self.decoded)


@pytest.fixture
def pictures() -> Pictures:
    return Pictures()


@pytest.fixture
def server(pictures: Pictures, tmp_path: Path) -> Iterator[FrameServer]:
    made = FrameServer(tmp_path / "c", 400_000, 1_000_000, pictures=pictures)
    yield made
    made.close()


def rest(server: FrameServer) -> None:
    """Wait until nothing more is to be made, or being made."""
    ahead = server._prefetcher
    assert ahead is not None

    def nothing_left() -> bool:
        with ahead._change:
            return not ahead._plan and not ahead._coming

    until(nothing_left)


def test_after_a_jump_what_lies_ahead_and_what_is_decoded_behind(
    server: FrameServer, pictures: Pictures
) -> None:
    pictures.decoded = {49}
    server.still(MEDIA, 50)
    rest(server)
    assert sorted(pictures.asked) == [49, 50, *range(51, 57)], "48 would have to be decoded"
    for n in (51, 52, 49):
        assert server.still(MEDIA, n) == bytes([n]) * 1000
    rest(server)
    assert len(pictures.asked) == len(set(pictures.asked)), "each is made once"


def test_steps_back_are_prepared_from_the_window_and_decoded_when_they_go_on(
    server: FrameServer, pictures: Pictures
) -> None:
    pictures.decoded = set(range(46, 51))
    server.still(MEDIA, 50)
    server.still(MEDIA, 49)
    rest(server)
    assert {46, 47, 48} <= set(pictures.asked) and min(pictures.asked) == 46
    for n in (48, 47):
        server.still(MEDIA, n)
    rest(server)
    assert min(pictures.asked) == 41


def test_who_waits_comes_first(server: FrameServer, pictures: Pictures) -> None:
    pictures.slow = set(range(11, 20))
    pictures.hears = False  # so that both are still at it when the new place is known
    server.still(MEDIA, 10)
    until(lambda: {11, 12} <= set(pictures.asked))
    assert server.still(MEDIA, 80) == bytes([80]) * 1000
    pictures.hears = True
    until(lambda: set(pictures.dropped) >= {11, 12})
    rest(server)
    assert max(n for n in pictures.asked if n < 50) <= 12, "the rest of the old place is forgotten"
    assert set(range(81, 87)) <= set(pictures.asked)


def test_what_is_just_being_made_is_waited_for(server: FrameServer, pictures: Pictures) -> None:
    pictures.slow = {11}
    server.still(MEDIA, 10)
    until(lambda: 11 in pictures.asked)
    threading.Timer(0.2, pictures.slow.clear).start()
    assert server.still(MEDIA, 11) == bytes([11]) * 1000
    assert pictures.asked.count(11) == 1
    pictures.slow = {18}
    server.still(MEDIA, 12)
    until(lambda: 18 in pictures.asked)
    give_up = time.monotonic() + 0.1
    with pytest.raises(NoLongerWanted):
        server.still(MEDIA, 18, wanted=lambda: time.monotonic() < give_up)


def test_a_frame_that_cannot_be_made_is_tried_once_and_nothing_behind_it(
    server: FrameServer, pictures: Pictures
) -> None:
    pictures.lost = {12, 13, 14, 15, 16, 17, 18}
    for n in (10, 9, 10, 11):
        server.still(MEDIA, n)
        rest(server)
    assert pictures.asked.count(12) == 1 and 15 not in pictures.asked
    with pytest.raises(Damaged):
        server.still(MEDIA, 12)


def test_large_stills_are_made_ahead_as_far_as_the_cache_goes(
    server: FrameServer, pictures: Pictures
) -> None:
    pictures.size = 12_000
    pictures.decoded = set(range(COUNT))
    server.still(MEDIA, 50)
    rest(server)
    assert sorted(pictures.asked) == [49, 50, 51, 52], "a quarter of 100 kB holds two"
    assert server.memory_bytes <= 100_000


def test_closing_stops_it_and_asking_starts_it_again(server: FrameServer, pictures: Pictures) -> None:
    before = set(threading.enumerate())
    pictures.slow = {11}
    server.still(MEDIA, 10)
    until(lambda: 11 in pictures.asked)
    server.close()
    until(lambda: set(threading.enumerate()) <= before)
    pictures.slow.clear()
    server.still(MEDIA, 20)
    until(lambda: 26 in pictures.asked)


def test_threads_end_without_work(
    server: FrameServer, pictures: Pictures, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(prefetch, "IDLE_S", 0.05)
    before = set(threading.enumerate())
    server.still(MEDIA, 10)
    until(lambda: 16 in pictures.asked)
    until(lambda: set(threading.enumerate()) <= before)
    server.still(MEDIA, 40)
    until(lambda: 46 in pictures.asked)
