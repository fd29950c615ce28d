"""Files that are no video, or only half of one: one sentence each that names the file, no other file read."""

from __future__ import annotations

import struct
import tracemalloc
from contextlib import closing
from pathlib import Path

import av
import cv2
import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.media.video.decode import frames_of, open_container
from sightline.media.video.frames import FrameServer
from sightline.media.video.passing import frames_between
from sightline.media.video.sniff import played_in_parts
from tests.media.clips import QVGA, SMALL, Spec, edited, read_number, write
from tests.media.conftest import Clip, Ingest, media_of
from tests.media.test_other_recorders import two_pictures
from tests.support.proofs import every


def refusal(path: Path) -> str:
    with pytest.raises(BadInput) as caught:
        next(frames_of(path))
    message = caught.value.message
    assert message.startswith(path.name) and message.endswith(".") and "\n" not in message
    assert str(path.parent) not in message
    return message


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (b"Dear operator,\nplease find attached the video.\n", "is a text file"),
        (b"id,contact_x_px\n1,2\n" * 500, "is a text file"),
        (bytes(range(256)) * 40, "is not a video"),
        (b"\x00" * 5000, "is not a video"),
        (b"PK\x03\x04" + b"\x00" * 100, "is a zip archive"),
        (b"#EXTM3U\n#EXTINF:5,\nsecret.mp4\n", "is a playlist"),
        (b"\xef\xbb\xbf#EXTM3U\nsecret.mp4\n", "is a playlist"),
        (b"ffconcat version 1.0\nfile secret.mp4\n", "is a playlist"),
        (b"<?xml version='1.0'?><MPD><BaseURL>secret.mp4</BaseURL></MPD>", "is a playlist"),
        (b"v=0\r\no=- 0 0 IN IP4 127.0.0.1\r\nm=video 5004 RTP/AVP 96\r\n", "is a playlist"),
    ],
)
@pytest.mark.parametrize("name", ["day one.mp4", "x.avi", "x.m3u8"])
def test_what_is_no_video_is_refused_in_words(name: str, content: bytes, words: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    assert words in refusal(path)


@pytest.mark.parametrize("suffix", [".png", ".jpg", ".webp", ".bmp", ".tiff"])
def test_still_pictures_are_refused(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / "still.mp4"
    path.write_bytes(cv2.imencode(suffix, np.full((48, 64, 3), 90, np.uint8))[1].tobytes())
    assert "image, not a video" in refusal(path)


def test_sound_alone_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "sound.mp4"
    with closing(av.open(str(path), "w")) as out:
        stream = out.add_stream("aac", rate=8000)
        for k in range(10):
            sound = av.AudioFrame.from_ndarray(np.zeros((1, 1024), np.float32), "fltp", "mono")
            sound.sample_rate, sound.pts = 8000, 1024 * k
            out.mux(stream.encode(sound))
        out.mux(stream.encode(None))
    assert "no video" in refusal(path)


def test_sound_with_a_cover_picture_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "song.mp4"
    with closing(av.open(str(path), "w")) as out:
        sound = out.add_stream("aac", rate=8000)
        cover = out.add_stream("mjpeg", rate=1)
        cover.width, cover.height, cover.pix_fmt = 64, 48, "yuvj420p"
        cover.disposition = av.stream.Disposition.attached_pic
        picture = av.VideoFrame.from_ndarray(np.full((48, 64, 3), 90, np.uint8), "bgr24")
        picture.pts = 0
        for packet in [*cover.encode(picture), *cover.encode(None)]:
            out.mux(packet)
        silence = av.AudioFrame.from_ndarray(np.zeros((1, 1024), np.float32), "fltp", "mono")
        silence.sample_rate, silence.pts = 8000, 0
        out.mux(sound.encode(silence))
        out.mux(sound.encode(None))
    assert "no video" in refusal(path)


def test_playlists_are_not_followed_even_where_the_name_invites_it(tmp_path: Path) -> None:
    """The whitelist itself, without the look at the first bytes: FFmpeg must refuse to follow."""
    write(tmp_path / "secret.mp4", Spec("secret.mp4"), 5)
    for name, text in (
        ("list.m3u8", "#EXTM3U\n#EXT-X-TARGETDURATION:5\n#EXTINF:5,\nsecret.mp4\n#EXT-X-ENDLIST\n"),
        ("list.ffconcat", "ffconcat version 1.0\nfile secret.mp4\n"),
    ):
        path = tmp_path / name
        path.write_text(" \n" * 3000 + text)  # far behind the first bytes that are looked at
        with pytest.raises(BadInput):
            open_container(path)
        path.write_text(text)
        with pytest.raises(BadInput):
            open_container(path)


def test_cut_before_the_index(tmp_path: Path) -> None:
    whole = write(tmp_path / "a.mp4", Spec("a.mp4"), 40).read_bytes()
    path = tmp_path / "half.mp4"
    path.write_bytes(whole[: len(whole) // 2])
    assert "cut off before its index" in refusal(path)


@pytest.mark.parametrize("size", [(100_000, 100_000), (16_000, 16_000), (20_000, 10), (-5, 7)])
@pytest.mark.parametrize("codec", ["rawvideo", "cinepak", "ffv1"])
def test_a_header_that_claims_an_absurd_size_is_refused(
    codec: str, size: tuple[int, int], tmp_path: Path
) -> None:
    pix_fmt = "rgb24" if codec == "cinepak" else "yuv420p"
    source = write(tmp_path / "a.avi", Spec("a.avi", codec=codec, pix_fmt=pix_fmt, options=()), 2)
    data, old = source.read_bytes(), struct.pack("<ii", *SMALL)
    assert old in data
    path = tmp_path / "huge.avi"
    path.write_bytes(data.replace(old, struct.pack("<ii", *size)))
    tracemalloc.start()
    message = refusal(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert "pixels" in message or "frame size" in message
    assert peak < 50_000_000


@pytest.mark.parametrize("tenth", every(4, range(1, 10)))
@pytest.mark.parametrize("name", ["front.mp4", "a.mkv", "a.avi", "a.ts", "a.h264"])
def test_truncated_files_give_their_frames_or_a_sentence(
    name: str, tenth: int, clip: Clip, tmp_path: Path, take_in: Ingest
) -> None:
    muxer = (("movflags", "+faststart"),) if name == "front.mp4" else ()
    container = "h264" if name.endswith("h264") else None
    whole = clip(Spec(name, muxer=muxer, container=container), 50).read_bytes()
    path = tmp_path / f"cut_{name}"
    path.write_bytes(whole[: len(whole) * tenth // 10])
    try:
        result = take_in(path)
    except BadInput as error:
        assert error.message.startswith(path.name)
        assert tenth <= 3, "from a third on there are frames to be had"
        return
    media = media_of(result)
    assert 0 < len(media) <= 50
    server = FrameServer(tmp_path / "cache", 4_000_000, 1_000_000)
    sure = [n for n in range(len(media) - 2, -1, -3)]  # the last picture may be torn
    assert [read_number(server.gray(media, n)) for n in sure] == sure


def test_a_cut_file_is_reported_in_words(tmp_path: Path, take_in: Ingest) -> None:
    spec = Spec("a.mp4", muxer=(("movflags", "+faststart"),))
    whole = write(tmp_path / "a.mp4", spec, 90).read_bytes()
    path = tmp_path / "cut.mp4"
    path.write_bytes(whole[: len(whole) * 6 // 10])
    report = take_in(path).report
    assert report.damaged
    assert any("90 frames" in note for note in map(str, report.notes)), report.notes


def test_a_cut_matroska_file_is_told_by_its_duration(tmp_path: Path, take_in: Ingest) -> None:
    whole = write(tmp_path / "a.mkv", Spec("a.mkv"), 90)
    assert not take_in(whole).report.damaged
    path = tmp_path / "cut.mkv"
    content = whole.read_bytes()
    path.write_bytes(content[: len(content) * 5 // 10])
    report = take_in(path).report
    assert report.damaged
    assert any("3.6 s" in note and "truncated" in note for note in map(str, report.notes)), report.notes


@pytest.mark.parametrize(
    ("edits", "parts"),
    [
        ([(0.4, 0.0), (1.2, None), (0.4, 0.4)], True),  # a hole: its times ran on without it
        ([(0.4, 0.0), (0.4, 1.6)], True),  # 1.6 s were told as 0.4 s
        ([(0.5, 0.4), (0.4, 0.0)], True),
        ([(0.4, 0.0), (0.4, 0.4)], False),
        ([(0.8, None), (0.4, 0.8), (0.3, None)], False),
        ([(2.0, 0.0)], False),
    ],
)
def test_a_file_that_an_edit_list_puts_together_has_no_times_of_filming(
    edits: list[tuple[float, float | None]], parts: bool, tmp_path: Path, take_in: Ingest
) -> None:
    whole = write(tmp_path / "whole.mp4", Spec("whole.mp4"), 50)
    path = edited(whole, tmp_path / "edited.mp4", edits)
    if parts:
        with pytest.raises(BadInput, match="is put together of several parts by an edit list"):
            take_in(path)
        with pytest.raises(BadInput, match="several parts"):
            frames_between(path, 0, 9, SMALL, "edited.mp4")
    else:
        steps_s = np.diff(take_in(path).frames.time_s)
        assert steps_s == pytest.approx(0.04, abs=1e-4)


@pytest.mark.parametrize("header", [b"mdhd", b"mvhd"])
def test_an_edit_list_without_the_header_of_its_times_tells_nothing(header: bytes, tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.mp4", Spec("whole.mp4"), 50)
    path = edited(whole, tmp_path / "edited.mp4", [(0.4, 0.0), (0.4, 1.6)])
    assert played_in_parts(path)
    path.write_bytes(path.read_bytes().replace(header, b"free"))
    assert not played_in_parts(path)


@pytest.mark.parametrize("header", [b"tkhd", b"mdhd"])
def test_a_broken_header_of_another_track_hides_no_edit_list(header: bytes, tmp_path: Path) -> None:
    file = two_pictures(tmp_path / "two.mp4", (30, 30), (True, True))
    path = edited(file, tmp_path / "edited.mp4", [(0.4, 0.0), (0.4, 0.8)])
    content = path.read_bytes()
    at = content.rindex(header)
    path.write_bytes(content[:at] + b"free" + content[at + 4 :])
    assert played_in_parts(path) == {1}


def test_only_the_edit_list_of_the_picture_that_is_read_counts(tmp_path: Path, take_in: Ingest) -> None:
    file = two_pictures(tmp_path / "two.mp4", (30, 30), (True, True))
    path = edited(file, tmp_path / "edited.mp4", [(0.4, 0.0), (0.4, 0.8)], track=2)
    assert (played_in_parts(path), take_in(path).facts.stream) == ({2}, 1)
    with pytest.raises(BadInput, match="several parts"):
        frames_between(path, 0, 9, QVGA, "edited.mp4", stream_number=2)


def test_an_edit_list_in_a_part_with_a_long_size_is_found(tmp_path: Path) -> None:
    whole = write(tmp_path / "whole.mp4", Spec("whole.mp4"), 50)
    path = edited(whole, tmp_path / "edited.mp4", [(0.4, 0.0), (0.4, 1.6)])
    content = path.read_bytes()
    at = content.rindex(b"moov") - 4
    rest = content[at + 8 :]
    path.write_bytes(content[:at] + struct.pack(">I4sQ", 1, b"moov", 16 + len(rest)) + rest)
    assert played_in_parts(path)


def test_a_late_first_stamp_is_no_cut(tmp_path: Path, take_in: Ingest) -> None:
    """Matroska's duration counts from 0, wherever the first picture stands."""
    spec = Spec("late.mkv", pts_of=lambda n: 900_000 + 3600 * n)
    report = take_in(write(tmp_path / "late.mkv", spec, 60)).report
    assert not report.damaged and not any("cut off" in note for note in map(str, report.notes))


def test_flipped_bytes_are_skipped_and_the_rest_is_served(tmp_path: Path, take_in: Ingest) -> None:
    data = bytearray(write(tmp_path / "a.mp4", Spec("a.mp4", gop=12), 96).read_bytes())
    start = data.find(b"mdat") + 4
    rng = np.random.default_rng(3)
    for at in rng.integers(start + 2000, start + (len(data) - start) // 2, 150):
        data[at] ^= int(rng.integers(1, 256))
    path = tmp_path / "flipped.mp4"
    path.write_bytes(data)
    result = take_in(path)
    media = media_of(result)
    assert len(media) >= 48
    assert result.report.damaged and any("damaged" in note for note in map(str, result.report.notes))
    server = FrameServer(tmp_path / "cache", 4_000_000, 1_000_000)
    last = len(media) - 1
    assert [read_number(server.gray(media, n)) for n in range(last, last - 20, -1)] == list(range(95, 75, -1))
