"""The frame server: bounded caches, lossless crops, spoilt caches, threads, and being told to give up."""

from __future__ import annotations

import os
import random
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

import cv2
import numpy as np
import pytest

from sightline.errors import BadInput, Damaged, NotFound
from sightline.media.images import read_image_bgr
from sightline.media.video.caches import DiskCache, MemoryCache
from sightline.media.video.frames import FrameServer
from sightline.media.video.seeker import RecordingMedia, Seeker
from sightline.media.video.window import FRAMES_OF_DECODER, NoLongerWanted, Window, is_always_wanted
from tests.media.clips import QVGA, SMALL, Spec, read_number
from tests.media.conftest import Clip, Ingest, media_of

LONG = Spec("one_key.mp4", gop=250, size=QVGA)


@pytest.fixture
def media(clip: Clip, take_in: Ingest) -> RecordingMedia:
    return media_of(take_in(clip(LONG)))


@pytest.mark.parametrize(
    ("spec", "sampling"),
    [
        (LONG, 0x22),
        (Spec("chroma.mp4", pix_fmt="yuv444p"), 0x11),
        (Spec("wide.mp4", aspect=Fraction(4, 3)), 0x11),
    ],
    ids=["half colour", "full colour", "stretched"],
)
def test_still_is_the_frame_as_jpeg_with_the_colour_that_it_has(
    spec: Spec, sampling: int, clip: Clip, take_in: Ingest, server: FrameServer
) -> None:
    media = media_of(take_in(clip(spec)))
    data = server.still(media, 33)
    assert data[data.index(b"\xff\xc0") + 11] == sampling, "luma's sampling against that of colour"
    image = read_image_bgr(data)
    assert read_number(image) == 33
    there = server.bgr(media, 33)
    assert np.abs(image.astype(int) - there.astype(int)).mean() < 2
    luma, expected = (cv2.cvtColor(one, cv2.COLOR_BGR2GRAY).astype(int) for one in (image, there))
    assert np.abs(luma - expected).mean() < 1


def test_crop_is_lossless_and_always_of_the_size_asked_for(
    media: RecordingMedia, server: FrameServer
) -> None:
    whole = server.bgr(media, 20)
    inside = read_image_bgr(server.crop_png(media, 20, 100, 60, 41, 31))
    assert np.array_equal(inside, whole[60:91, 100:141])
    enlarged = read_image_bgr(server.crop_png(media, 20, 100, 60, 8, 6, scale=4))
    assert np.array_equal(enlarged, np.kron(whole[60:66, 100:108], np.ones((4, 4, 1), np.uint8)))
    edge = read_image_bgr(server.crop_png(media, 20, -5, 235, 20, 20))
    assert edge.shape == (20, 20, 3)
    assert np.array_equal(edge[:5, 5:], whole[235:240, 0:15])
    assert not edge[5:].any() and not edge[:, :5].any()


@pytest.mark.parametrize(
    ("w", "h", "scale"), [(0, 5, 1), (5, -1, 1), (10, 10, 17), (10, 10, 0), (90_000, 90_000, 1)]
)
def test_crops_out_of_bounds_are_refused(
    w: int, h: int, scale: int, media: RecordingMedia, server: FrameServer
) -> None:
    with pytest.raises(BadInput, match="crop"):
        server.crop_png(media, 0, 0, 0, w, h, scale)


@pytest.mark.parametrize("n", [-1, 80, 10**9])
def test_frames_outside_the_table_are_not_there(n: int, media: RecordingMedia, server: FrameServer) -> None:
    with pytest.raises(NotFound, match="frames 0 to 79"):
        server.still(media, n)


def test_a_step_back_in_the_window_decodes_nothing(
    media: RecordingMedia, server: FrameServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    server.bgr(media, 70)
    monkeypatch.setattr(Seeker, "find", lambda *_, **__: pytest.fail("a decoder was asked"))
    assert [read_number(server.bgr(media, n)) for n in range(69, 30, -1)] == list(range(69, 30, -1))
    assert 69 in server._pictures.warm(media)


def test_stills_survive_a_restart_on_disk(
    media: RecordingMedia, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = FrameServer(tmp_path / "c", 8_000_000, 8_000_000).still(media, 5)
    monkeypatch.setattr(Seeker, "find", lambda *_, **__: pytest.fail("a decoder was asked"))
    assert FrameServer(tmp_path / "c", 8_000_000, 8_000_000).still(media, 5) == first


def test_a_spoilt_still_on_disk_is_made_again(media: RecordingMedia, tmp_path: Path) -> None:
    first = FrameServer(tmp_path / "c", 8_000_000, 8_000_000).still(media, 5)
    (kept,) = (tmp_path / "c").rglob("*.jpg")
    kept.write_bytes(kept.read_bytes()[:-1] + b"x")
    assert FrameServer(tmp_path / "c", 8_000_000, 8_000_000).still(media, 5) == first


def test_another_frame_table_never_gets_the_cached_still(media: RecordingMedia, server: FrameServer) -> None:
    server.still(media, 5)
    crc = media.crc.copy()
    crc[5] ^= 0xFF
    with pytest.raises(Damaged):
        server.still(RecordingMedia(media.path, media.pts, crc, media.key), 5)


def test_a_missing_file_is_told_as_damage(media: RecordingMedia, tmp_path: Path, server: FrameServer) -> None:
    for path in (tmp_path / "gone.mp4", tmp_path / "empty.mp4"):
        if path.name == "empty.mp4":
            path.touch()
        with pytest.raises(Damaged, match="missing or can no longer be opened"):
            server.still(RecordingMedia(path, media.pts, media.crc, media.key), 0)


def test_memory_is_bounded(media: RecordingMedia, tmp_path: Path) -> None:
    server = FrameServer(tmp_path / "c", 1_000_000, 300_000)
    for n in range(80):
        server.still(media, n)
    assert server.memory_bytes <= 1_000_000
    held = sum(p.stat().st_size for p in (tmp_path / "c").rglob("*.jpg"))
    assert 0 < held <= 300_000


def test_open_decoders_are_bounded(clip: Clip, tmp_path: Path, take_in: Ingest) -> None:
    server = FrameServer(tmp_path / "c", 2_000_000, 1_000_000, max_open=2)
    medias = [media_of(take_in(clip(Spec(f"{k}.mp4", gop=10 + k), 20))) for k in range(4)]
    for _ in range(2):
        for media in medias:
            server.bgr(media, random.Random(1).randrange(20))
    before = len(os.listdir("/proc/self/fd"))
    for n in range(20):
        assert read_number(server.bgr(medias[n % 4], n)) == n
    assert len(os.listdir("/proc/self/fd")) <= before + 2
    server.close()
    assert read_number(server.bgr(medias[0], 3)) == 3, "a closed server opens again"


def test_large_pictures_leave_room_for_fewer_decoders(clip: Clip, take_in: Ingest) -> None:
    medias = [media_of(take_in(clip(Spec(f"{k}.mp4", gop=10 + k), 20))) for k in range(3)]
    frame = SMALL[0] * SMALL[1] * 3 // 2
    window = Window(2_000_000, max_open=3, open_bytes=2 * FRAMES_OF_DECODER * frame + frame)
    before = len(os.listdir("/proc/self/fd"))
    for n in range(12):
        assert read_number(window.gray(medias[n % 3], n, is_always_wanted)) == n
    window.gray(medias[0], 0, is_always_wanted)
    assert len(os.listdir("/proc/self/fd")) <= before + 2
    window.close()


def test_many_threads_get_their_own_frames(clip: Clip, tmp_path: Path, take_in: Ingest) -> None:
    medias = [media_of(take_in(clip(spec))) for spec in (LONG, Spec("cfr.mp4"), Spec("mjpeg.avi"))]
    server = FrameServer(tmp_path / "c", 3_000_000, 500_000, max_open=2)
    rng = random.Random(5)
    jobs = [(rng.randrange(3), rng.randrange(80)) for _ in range(150)]
    with ThreadPoolExecutor(12) as pool:
        numbers = pool.map(lambda job: read_number(server.gray(medias[job[0]], job[1])), jobs)
        assert list(numbers) == [n for _, n in jobs]
        same = pool.map(lambda _: server.still(medias[0], 40), range(24))
        assert len(set(same)) == 1


def test_giving_up_on_the_way(media: RecordingMedia, server: FrameServer) -> None:
    answers = iter([True] * 10 + [False] * 1000)
    with pytest.raises(NoLongerWanted):
        server.still(media, 79, wanted=lambda: next(answers))
    assert read_number(server.bgr(media, 79)) == 79


def test_memory_cache_forgets_the_least_recently_used() -> None:
    cache: MemoryCache[str] = MemoryCache(10, len)
    cache.put("a", "AAAA")
    cache.put("b", "BBBB")
    assert cache.get("a") == "AAAA"
    cache.put("c", "CCCC")
    assert (cache.get("a"), cache.get("b"), cache.get("c")) == ("AAAA", None, "CCCC")
    cache.put("huge", "H" * 11)
    assert cache.get("huge") is None and cache.held_bytes == 8
    cache.put("a", "A2")
    assert cache.held_bytes == 6


def test_disk_cache_lives_with_a_folder_that_is_deleted(tmp_path: Path) -> None:
    cache = DiskCache(tmp_path / "c", 1000)
    cache.put("x/1", b"one")
    for path in sorted((tmp_path / "c").rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()
    assert cache.get("x/1") is None
    cache.put("x/1", b"one")
    assert cache.get("x/1") == b"one"


def test_odd_pictures_turn_as_opencv_turns_them(server: FrameServer, clip: Clip, take_in: Ingest) -> None:
    plain = media_of(take_in(clip(Spec("plain.mp4"), 6)))
    turned = media_of(take_in(clip(Spec("turned.mp4", rotation=90), 6)))
    back = cv2.rotate(server.bgr(turned, 4), cv2.ROTATE_90_CLOCKWISE)
    assert np.array_equal(back, server.bgr(plain, 4))
