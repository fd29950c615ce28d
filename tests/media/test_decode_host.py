"""Stills decoded in a child process: a hostile file may end that process, and nothing else."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from sightline.errors import BadInput, Damaged
from sightline.media.images import png, read_image_bgr
from sightline.media.video import decode_host
from sightline.media.video.decode_crashes import CannotDecode, CrashTracker
from sightline.media.video.decode_host import DecodeHost
from sightline.media.video.decode_wire import Limits
from sightline.media.video.frames import FrameServer
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import NoLongerWanted, is_always_wanted
from tests.media.clips import Spec, read_number
from tests.media.conftest import ROOT, Clip, Ingest, media_of
from tests.media.faulty_child import AT, notes_of
from tests.support.waiting import NEVER_S, alive, until

FAULTS = "tests.media.faulty_child"


@pytest.fixture
def limits() -> Any:
    """As `Limits`, but that a test may change them: a busy machine's child is silent for long."""
    return SimpleNamespace(**asdict(Limits(memory_bytes=300_000_000, silence_s=NEVER_S)))


@pytest.fixture
def host(limits: Any) -> Iterator[DecodeHost]:
    made = DecodeHost(20_000_000, limits, entry=FAULTS)
    yield made
    made.close()


@pytest.fixture
def served(host: DecodeHost, tmp_path: Path) -> Iterator[FrameServer]:
    made = FrameServer(tmp_path / "c", 4_000_000, 4_000_000, pictures=host)
    yield made
    made.close()


@pytest.fixture
def plain(clip: Clip, take_in: Ingest) -> RecordingMedia:
    return media_of(take_in(clip(Spec("plain.mp4"))))


def named(media: RecordingMedia, name: str, folder: Path) -> RecordingMedia:
    """The same recording under a name at which the decoder has its fault."""
    path = folder / f"{name}.mp4"
    shutil.copy(media.path, path)
    return RecordingMedia(path, media.pts, media.crc, media.key)


def is_gone(pid: int) -> bool:
    """Whether the process ended and was waited for."""
    return not Path(f"/proc/{pid}").exists()


def test_the_child_gives_what_a_decoder_here_gives(
    plain: RecordingMedia, served: FrameServer, server: FrameServer
) -> None:
    for n in (33, 5, 34):
        assert served.still(plain, n) == server.still(plain, n)
        assert read_number(served.bgr(plain, n)) == n
        assert np.array_equal(served.gray(plain, n), server.gray(plain, n))
    crop = (20, 100, -6, 41, 31, 2, "bright")
    assert served.crop_png(plain, *crop) == server.crop_png(plain, *crop)
    warm = served._pictures.warm(plain)
    assert 34 in warm and 70 not in warm
    with pytest.raises(BadInput, match="out of bounds"):
        served.crop_png(plain, 0, 0, 0, 90_000, 90_000)


def test_checksums_are_verified_in_the_child(plain: RecordingMedia, served: FrameServer) -> None:
    crc = plain.crc.copy()
    crc[12] ^= 1
    with pytest.raises(Damaged, match="Frame 12 cannot be shown"):
        served.still(RecordingMedia(plain.path, plain.pts, crc, plain.key), 12)
    gone = RecordingMedia(plain.path.with_name("gone.mp4"), plain.pts, plain.crc, plain.key)
    with pytest.raises(Damaged, match="missing"):
        served.still(gone, 12)


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("crash", "crashed"),
        ("killed", "was killed again and again"),
        ("hang", "no progress for 1 s"),
        ("stuck", "no progress for 1 s"),
        ("greedy", "0.3 GB of memory"),
    ],
)
def test_a_fault_costs_the_child_and_one_sentence(
    fault: str,
    words: str,
    plain: RecordingMedia,
    limits: Any,
    host: DecodeHost,
    served: FrameServer,
    tmp_path: Path,
) -> None:
    hostile = named(plain, fault, tmp_path)
    assert read_number(served.bgr(hostile, 3)) == 3
    before = host.process_id
    assert before is not None
    if fault in ("hang", "stuck"):
        limits.silence_s = 1.0
    with pytest.raises(CannotDecode) as refused:
        served.still(hostile, AT)
    limits.silence_s = NEVER_S
    assert f"cannot be decoded at frame {AT}: the decoder" in refused.value.message
    assert words in refused.value.message and refused.value.message.endswith(".")
    assert read_number(read_image_bgr(served.still(plain, 50))) == 50
    assert host.process_id != before and is_gone(before)


def test_a_frame_that_fits_alone_is_given_from_full_memory_and_a_greedy_one_is_not(
    plain: RecordingMedia, host: DecodeHost, served: FrameServer, tmp_path: Path
) -> None:
    """90 MB a frame that stay: what the third asks for is not what it needs. Greedy ones need it alone."""
    heavy = named(plain, "heavy", tmp_path)
    for n in range(AT, AT + 5):
        assert read_number(served.bgr(heavy, n)) == n
    greedy = named(plain, "greedy", tmp_path)
    with pytest.raises(CannotDecode, match=r"alone in a fresh process, there; .* to smaller"):
        served.still(greedy, AT)


def test_whoever_killed_the_child_the_recording_is_not_blamed(
    plain: RecordingMedia, host: DecodeHost, served: FrameServer, tmp_path: Path
) -> None:
    """The system does, where memory runs out."""
    slow = named(plain, "slow", tmp_path)
    served.bgr(slow, 3)
    with ThreadPoolExecutor(1) as pool:
        for n in range(AT, AT + 4):  # more often than a recording may end it
            asked = pool.submit(served.bgr, slow, n)
            until(lambda n=n: any(note.startswith(f"{n} begun") for note in notes_of(slow.path)))
            assert host.process_id is not None
            os.kill(host.process_id, signal.SIGKILL)
            assert read_number(asked.result(NEVER_S)) == n
            host.start()


def test_a_recording_that_does_it_again_and_again_is_set_aside(
    plain: RecordingMedia, host: DecodeHost, served: FrameServer, tmp_path: Path
) -> None:
    hostile = named(plain, "crash", tmp_path)
    for n in range(AT, AT + 3):
        with pytest.raises(CannotDecode, match=f"at frame {n}"):
            served.still(hostile, n)
    served.still(plain, 7)
    before = host.process_id
    for n in (AT, 3):
        with pytest.raises(CannotDecode, match="3 times and is not tried again; convert"):
            served.still(hostile, n)
    assert read_number(served.bgr(plain, 60)) == 60
    assert host.process_id == before, "nobody was asked"


def test_others_are_asked_again_and_not_blamed(
    plain: RecordingMedia, served: FrameServer, tmp_path: Path
) -> None:
    hostile = named(plain, "late", tmp_path)
    slow = named(plain, "slow", tmp_path)
    with ThreadPoolExecutor(2) as pool:
        bad = pool.submit(served.still, hostile, AT)
        good = pool.submit(served.bgr, slow, AT + 1)
        assert read_number(good.result(NEVER_S)) == AT + 1
        with pytest.raises(CannotDecode, match=f"at frame {AT}"):
            bad.result(NEVER_S)


def test_still_pictures_are_decoded_there_too(plain: RecordingMedia, served: FrameServer) -> None:
    picture = np.arange(600, dtype=np.uint8).reshape(20, 30)
    data = png(picture)
    assert np.array_equal(served.image(data, "board.png"), picture)
    assert served.image_bgr(data, "board.png").shape == (20, 30, 3)
    with pytest.raises(BadInput, match=r"^notes.txt is not an image"):
        served.image(b"not an image", "notes.txt")
    with pytest.raises(CannotDecode, match=r"^crash.png cannot be decoded: the decoder crashed; save it"):
        served.image(data, "crash.png")
    assert read_number(served.bgr(plain, 50)) == 50


def test_giving_up_reaches_the_child(plain: RecordingMedia, served: FrameServer, tmp_path: Path) -> None:
    endless = named(plain, "endless", tmp_path)
    served.still(endless, 1)
    with pytest.raises(NoLongerWanted):
        served.still(endless, AT, wanted=lambda: not notes_of(endless.path))
    begun, given_up = notes_of(endless.path)
    assert begun.startswith(f"{AT} begun") and given_up == f"{AT} given up"
    assert read_number(served.bgr(endless, 9)) == 9


def test_signs_of_life_are_no_hang(
    plain: RecordingMedia, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A clock that shows a second more at each message of the child."""
    take, seconds = decode_host._Child._take, [0]

    def taken(self: Any, header: Any, body: bytes) -> None:
        seconds[0] += 1
        take(self, header, body)

    monkeypatch.setattr(decode_host._Child, "_take", taken)
    monkeypatch.setattr(decode_host, "time", SimpleNamespace(monotonic=lambda: float(seconds[0])))
    impatient = DecodeHost(20_000_000, Limits(silence_s=1.5), entry=FAULTS)
    slow = named(plain, "slow", tmp_path)
    impatient.gray(slow, 1, is_always_wanted)
    before = seconds[0]
    assert read_number(impatient.gray(slow, AT, is_always_wanted)) == AT
    assert seconds[0] - before > 4, "longer than it may be silent, with a sign each second"
    impatient.close()


def test_frames_prepared_ahead_are_ready_and_leave_the_window_alone(
    plain: RecordingMedia, served: FrameServer
) -> None:
    served.still(plain, 10)
    size = served.prepare(plain, 60)
    assert 60 not in served._pictures.warm(plain)
    assert (60, 60) in served.ready(plain)
    # who asks for it may find its neighbours read behind it
    assert size == served.prepare(plain, 60) == len(served.still(plain, 60))


def test_it_ends_with_the_server_and_leaves_no_zombie(plain: RecordingMedia) -> None:
    host = DecodeHost(20_000_000)
    host.gray(plain, 1, is_always_wanted)
    child = host.process_id
    assert child is not None
    host.close()
    assert is_gone(child)
    assert read_number(host.gray(plain, 2, is_always_wanted)) == 2, "and starts again when asked"
    host.close()


def test_it_ends_when_the_server_is_killed() -> None:
    code = (
        "import sys; from sightline.media.video.decode_host import DecodeHost; host = DecodeHost(1000000);"
        "host.start(); print(host.process_id, flush=True); sys.stdin.read()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout is not None
        child = int(server.stdout.readline())
        os.kill(server.pid, signal.SIGKILL)
        server.wait()
    until(lambda: not alive(child))


def test_blame_needs_a_recording_alone_or_seen_before() -> None:
    now = [0.0]
    blame = CrashTracker(Limits(kills=2, aside_s=60), lambda: now[0])
    assert blame.died({"a", "b"}) == set()
    with blame.turn("b"):
        pass
    assert blame.died({"a", "c"}) == {"a"}, "a was suspected, c is new"
    assert blame.died({"c"}) == {"c"}
    blame.check("a")
    assert blame.died({"a", "b"}) == {"a"}, "b had answered alone"
    with pytest.raises(CannotDecode, match="is not tried again"):
        blame.check("a")
    now[0] = 61
    blame.check("a")
