"""What other people's recorders write: clocks that wrap, covers, several pictures, slow motion, cut files."""

from __future__ import annotations

import json
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest

from sightline.cli import main
from sightline.errors import BadInput
from sightline.media.strips.video import cut_strips
from sightline.media.video.decode import frames_of
from sightline.media.video.frames import FrameServer
from sightline.media.video.ingest import Ingested
from sightline.media.video.passing import frames_between
from sightline.media.video.report import clock_doubt_of, times_of_filming
from sightline.media.video.stated import Stated
from sightline.recordings.ingest_job import facts_of
from tests.media.clips import QVGA, SMALL, X264_B, X264_OPEN, Spec, painted, read_number, tagged, write
from tests.media.conftest import Clip, Ingest, media_of
from tests.support.proofs import every

CLOCK_S = 2**33 / 90_000


def moved(source: Path, target: Path, by_s: float, container: str) -> Path:
    """The same packets, `by_s` later, on a clock of 33 bits that begins again at its end."""
    with closing(av.open(str(source))) as read, closing(av.open(str(target), "w", format=container)) as out:
        stream = read.streams.video[0]
        copy = out.add_stream_from_template(stream)
        for packet in read.demux(stream):
            if packet.dts is None:
                continue
            shift = round(by_s / packet.time_base)
            packet.pts, packet.dts, packet.stream = packet.pts + shift, packet.dts + shift, copy
            out.mux(packet)
    return target


def numbers(result: Ingested, server: FrameServer) -> list[int]:
    media = media_of(result)
    return [read_number(server.gray(media, n)) for n in range(len(media))]


@pytest.mark.parametrize("container", ["mpegts", "mpeg"])
@pytest.mark.parametrize(("rate", "before_s"), [(25, 2.0), (25, 4.4), (1, 80.0)])
def test_a_clock_that_begins_again_loses_no_frame(
    rate: int, before_s: float, container: str, tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    """The clock of an MPEG stream ends every 26.5 hours; FFmpeg counts down to 0 what begins within a minute
    of its end.
    """
    codec = {} if container == "mpegts" else {"codec": "mpeg2video", "options": ()}
    spec = Spec("x", rate=Fraction(rate), gop=25, b_frames=2, **codec)  # type: ignore[arg-type]
    if container == "mpeg" and rate == 1:
        pytest.skip("MPEG-2 has no rate of one picture a second")
    source = write(tmp_path / ("plain.ts" if container == "mpegts" else "plain.mkv"), spec, 120)
    wraps = moved(source, tmp_path / "wraps.ts", CLOCK_S - before_s, container)
    result = take_in(wraps)
    assert result.frames.time_s == pytest.approx(np.arange(120) / rate, abs=2e-3)
    assert numbers(result, server) == list(range(120))
    assert result.report.rate_hz == pytest.approx(rate, rel=1e-4)
    assert result.facts.container == container  # of the file, whatever it is served from


def two_pictures(
    path: Path, counts: tuple[int, int], on: tuple[bool, bool] | None = None, cover: bool = False
) -> Path:
    """A file of two pictures, of 192x144 and 320x240: the second shows its numbers from 1000 on."""
    with closing(av.open(str(path), "w")) as out:
        streams = []
        for k, (width, height) in enumerate((SMALL, QVGA)):
            still = cover and k == 0
            stream = out.add_stream("mjpeg" if still else "libx264", rate=25)
            stream.width, stream.height = width, height
            stream.pix_fmt = "yuvj420p" if still else "yuv420p"
            if on is not None:
                stream.disposition = av.stream.Disposition.default if on[k] else av.stream.Disposition(0)
            if not still:
                stream.options = {"preset": "superfast"}
            streams.append(stream)
        for k, stream in enumerate(streams):
            for n in range(counts[k]):
                picture = painted(n + 1000 * k, stream.width, stream.height)
                frame = av.VideoFrame.from_ndarray(picture, format="bgr24")
                frame.pts, frame.time_base = n, Fraction(1, 25)
                out.mux(stream.encode(frame))
            out.mux(stream.encode(None))
    return path


@pytest.mark.parametrize("on", [None, (False, True)])
@pytest.mark.parametrize("ending", ["mp4", "mkv"])
def test_a_cover_before_the_video_is_no_video(
    ending: str, on: tuple[bool, bool] | None, tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    """A cover as an ordinary first stream, marked as nothing; FFmpeg switches the second off by default."""
    result = take_in(two_pictures(tmp_path / f"cover_first.{ending}", (1, 40), on, cover=True))
    assert numbers(result, server) == list(range(1000, 1040))
    assert (result.facts.width_px, result.facts.stream) == (320, 2)
    assert any("1 (mjpeg, 192x144, a still image)" in note and "2 (h264" in note
               for note in map(str, result.report.notes))  # fmt: skip


def test_of_two_moving_pictures_the_first_is_read_and_said(
    tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    result = take_in(two_pictures(tmp_path / "two.mp4", (30, 30), (True, True)))
    assert numbers(result, server) == list(range(30))
    note = next(note for note in map(str, result.report.notes) if "another video track" in note)
    assert "2 (h264, 320x240)" in note and "track 1 (h264, 192x144) was imported" in note


def test_one_that_is_switched_off_is_left_alone(tmp_path: Path, take_in: Ingest, server: FrameServer) -> None:
    result = take_in(two_pictures(tmp_path / "off.mp4", (30, 30), (False, True)))
    assert numbers(result, server) == list(range(1000, 1030))
    assert any("1 (h264, 192x144, disabled)" in note for note in map(str, result.report.notes))


def test_a_single_picture_says_nothing_of_others(clip: Clip, take_in: Ingest) -> None:
    result = take_in(clip(Spec("cfr.mp4")))
    assert result.facts.pictures == ()
    assert not any(note.code == "video-other-tracks" for note in result.report.notes)


def test_the_command_line_lets_one_choose(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = two_pictures(tmp_path / "two.mp4", (30, 30), (True, True))
    chosen = [read_number(gray) for _, _, gray in frames_of(path, number=2)]
    assert chosen == list(range(1000, 1030))
    assert main(["passes", str(path), "--stream", "2", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["passes"] == []
    assert main(["passes", str(path), "--stream", "3"]) == 2
    assert "has no video track 3; it has 2" in capsys.readouterr().err
    cover = two_pictures(tmp_path / "cover.mp4", (1, 30), cover=True)
    assert main(["passes", str(cover), "--stream", "1"]) == 2
    assert "is a still image" in capsys.readouterr().err


def test_another_picture_is_read_where_it_is_chosen(
    tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    path = two_pictures(tmp_path / "two.mp4", (30, 30), (True, True))
    result = take_in(path, stream_number=2)
    media = replace(media_of(result), stream_number=2)
    assert [read_number(server.gray(media, n)) for n in range(30)] == list(range(1000, 1030))
    assert (result.facts.stream, result.facts.width_px) == (2, 320)
    assert [str(one.said(n)) for n, one in enumerate(result.facts.pictures, 1)] == [
        "1 (h264, 192x144)",
        "2 (h264, 320x240)",
    ]
    first, _ = cut_strips(path, (1, 2), np.arange(30) / 25, stream_number=2)
    with closing(first):
        assert first.rows == 240


def test_another_picture_of_a_stream_without_an_index(
    tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    """Its working copy holds the one picture that was chosen."""
    path = two_pictures(tmp_path / "two.ts", (30, 30))
    assert numbers(take_in(path), server) == list(range(30))
    result = take_in(path, stream_number=2)
    assert numbers(result, server) == list(range(1000, 1030))
    assert (result.facts.stream, len(result.facts.pictures)) == (2, 2)


def test_one_that_is_switched_off_cannot_be_chosen(
    tmp_path: Path, take_in: Ingest, capsys: pytest.CaptureFixture[str]
) -> None:
    path = two_pictures(tmp_path / "off.mp4", (30, 30), (False, True))
    with pytest.raises(BadInput, match=r"Video track 1 of off.mp4 is disabled"):
        take_in(path, stream_number=1)
    assert main(["passes", str(path), "--stream", "1"]) == 2
    assert "is disabled" in capsys.readouterr().err


def packs(data: bytes) -> list[int]:
    """Where the packs of an MPEG program stream begin."""
    found, at = [], data.find(b"\x00\x00\x01\xba")
    while at >= 0:
        found.append(at)
        at = data.find(b"\x00\x00\x01\xba", at + 4)
    return found


@pytest.mark.parametrize("share", every(2, [0.2, 0.5]))
@pytest.mark.parametrize(
    "spec",
    [
        Spec("x", codec="mpeg2video", options=(), b_frames=2, gop=12, container="mpeg"),
        Spec("x", codec="mpeg2video", options=(), b_frames=2, gop=12, container="vob", rate=Fraction(30)),
        Spec("x", codec="mpeg1video", options=(), b_frames=2, gop=15, container="mpeg"),
        Spec("x", options=X264_OPEN, b_frames=3, container="mpeg"),
        Spec("x", options=X264_B, b_frames=3, container="mpeg"),
    ],
)
def test_a_trimmed_program_stream_keeps_its_times(
    spec: Spec, share: float, tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    """The pictures that led the first whole one refer to one that was cut away: two of them shifted it by 67
    to 80 ms.
    """
    data = write(tmp_path / "whole.mpg", spec, 100).read_bytes()
    begins = packs(data)
    path = tmp_path / "trimmed.mpg"
    path.write_bytes(data[begins[int(share * len(begins))] :])
    result = take_in(path)
    shown = np.array(numbers(result, server))
    assert len(shown) >= 25
    assert result.frames.time_s == pytest.approx((shown - shown[0]) / float(spec.rate), abs=2e-3)


FRAGMENTS = (("movflags", "frag_keyframe+empty_moov"),)


@pytest.mark.parametrize(
    ("name", "muxer"), [("fragments.mp4", FRAGMENTS), ("front.mp4", (("movflags", "+faststart"),)),
                        ("a.mkv", ()), ("a.avi", ())],
)  # fmt: skip
def test_a_file_cut_short_says_so_and_how_much_is_there(
    name: str, muxer: tuple[tuple[str, str], ...], clip: Clip, tmp_path: Path, take_in: Ingest
) -> None:
    whole = clip(Spec(name, muxer=muxer), 80)
    assert not take_in(whole).report.damaged
    assert not any("truncated" in note for note in map(str, take_in(whole).report.notes))
    path = tmp_path / f"cut_{name}"
    path.write_bytes(whole.read_bytes()[: whole.stat().st_size * 7 // 10])
    result = take_in(path)
    count, end_s = len(result.frames), float(result.frames.time_s.max())
    assert 30 <= count < 80 and result.report.damaged
    note = next(note for note in map(str, result.report.notes) if "truncated" in note)
    assert f"{count} frames ({end_s:.2f} s) were imported" in note


def test_a_live_recording_without_a_length_is_not_called_cut(
    clip: Clip, tmp_path: Path, take_in: Ingest
) -> None:
    live = clip(Spec("live.mkv", muxer=(("live", "1"),)), 30)
    assert not any("truncated" in note for note in map(str, take_in(live).report.notes))


SONY = (
    b'<?xml version="1.0"?><NonRealTimeMeta><VideoFormat><VideoFrame videoCodec="AVC" captureFps="119.88p"'
    b' formatFps="29.97p"/></VideoFormat></NonRealTimeMeta>'
)


@pytest.mark.parametrize(
    ("tags", "said"),
    [
        ({"com.android.capture.fps": "120.000000"}, "filmed at 120 frames per second"),
        ({"com.android.capture.fps": "1.000000"}, "filmed at 1 frames per second"),
        ({"com.maker.CaptureFrameRate": "240 fps"}, "filmed at 240 frames per second"),
        ({"com.apple.quicktime.full-frame-rate-playback-intent": "0"}, "marked as slow motion"),
        ({"com.android.capture.fps": "30.000000"}, None),
        ({"com.android.capture.fps": "24.0"}, None),
        ({"com.android.capture.fps": "fast"}, None),
        ({"com.apple.quicktime.full-frame-rate-playback-intent": "1"}, None),
    ],
)
def test_slow_motion_is_said_and_no_motion_is_measured(
    tags: dict[str, str], said: str | None, tmp_path: Path, take_in: Ingest
) -> None:
    path = tagged(tmp_path / "a.mp4", tags)
    result = take_in(path)
    assert result.frames.time_s == pytest.approx(np.arange(40) / 30, abs=1e-4)  # as played: never guessed
    assert result.report.clock_doubt == ("slow_motion" if said else None)
    assert facts_of(result, None).report["clock_doubt"] == result.report.clock_doubt
    notes = [str(note) for note in result.report.notes]
    assert [said in note for note in notes] == [True] if said else notes == []
    if said is None:
        assert len(frames_between(path, 5, 20, (320, 240), path.name)) == 16
        return
    with pytest.raises(BadInput, match="not the times of filming"):
        frames_between(path, 5, 20, (320, 240), path.name)


def test_a_rate_of_filming_that_is_stated_gives_the_times(tmp_path: Path, take_in: Ingest) -> None:
    """40 pictures filmed in a third of a second, played in one and a third."""
    slow = tagged(tmp_path / "slow.mp4", {"com.android.capture.fps": "120.000000"})
    result = take_in(slow, filmed_hz=120.0)
    assert result.frames.time_s == pytest.approx(np.arange(40) / 120, abs=1e-9)
    assert result.report.rate_hz == pytest.approx(120) and result.report.clock_doubt is None
    assert any("Filmed at 120 frames per second, as entered; the file plays 30" in note
               for note in map(str, result.report.notes))  # fmt: skip
    frames = frames_between(slow, 9, 39, (320, 240), "slow.mp4", filmed_hz=120.0)
    assert frames[-1].time_s - frames[0].time_s == pytest.approx(30 / 120)


def test_a_pass_has_the_times_of_the_frame_table_where_packets_are_not_in_order(
    tmp_path: Path, take_in: Ingest
) -> None:
    """H.264 in AVI: pictures were up to three frames, 0.1 s, off their times."""
    path = write(tmp_path / "b.avi", Spec("b.avi", options=X264_B, b_frames=3))
    result = take_in(path)
    assert result.report.unordered > 0
    times_s = [one.time_s for one in frames_between(path, 5, 20, SMALL, path.name)]
    assert np.diff(times_s) == pytest.approx(np.diff(result.frames.time_s[5:21]))


def test_a_recording_slowed_in_part_has_no_one_rate() -> None:
    steps_s = np.repeat([1 / 30, 1 / 240], 30)
    with pytest.raises(BadInput, match=r"Only part of slow.mp4 is in slow motion"):
        times_of_filming(np.cumsum(steps_s), 240.0, "slow.mp4")


@pytest.mark.parametrize("step_s", [1 / 90_000, 0.0])
def test_a_rate_that_is_stated_mends_impossible_times(step_s: float) -> None:
    assert times_of_filming(np.arange(5) * step_s, 50.0) == pytest.approx(np.arange(5) / 50)


def test_slow_motion_of_sony_stands_beside_the_index(tmp_path: Path, take_in: Ingest) -> None:
    path = tagged(tmp_path / "C0001.MP4", {})
    with path.open("ab") as file:
        file.write((8 + len(SONY)).to_bytes(4, "big") + b"meta" + SONY)
    result = take_in(path)
    assert result.stated.filmed_hz == 119.88 and result.report.clock_doubt == "slow_motion"


@pytest.mark.parametrize(
    ("step_s", "filmed_hz", "doubt"),
    [(1 / 30, 48.0, "slow_motion"), (1 / 30, 44.0, None), (1 / 30, 19.0, "slow_motion"), (1 / 30, 21.0, None),
     (1 / 1900, None, None), (1 / 2100, None, "impossible_rate"), (0.0, None, "impossible_rate")],
)  # fmt: skip
def test_where_a_clock_is_doubted(step_s: float, filmed_hz: float | None, doubt: str | None) -> None:
    assert clock_doubt_of(np.arange(30) * step_s, Stated(filmed_hz=filmed_hz)) == doubt


def test_a_start_in_the_future_is_no_start(tmp_path: Path, take_in: Ingest) -> None:
    found = take_in(tagged(tmp_path / "a.mp4", {}))
    past = replace(found, stated=Stated(begun_at=datetime(2020, 5, 3, 6, 10, tzinfo=UTC)))
    assert facts_of(past, None).start_proposed == datetime(2020, 5, 3, 6, 10, tzinfo=UTC)
    assert facts_of(past, None).notes == list(found.report.notes)
    ahead = replace(found, stated=Stated(begun_at=datetime(2240, 2, 6, 6, 28, 15, tzinfo=UTC)))
    facts = facts_of(ahead, None)
    assert facts.start_proposed is None
    assert "2240-02-06 06:28 UTC, which is in the future" in str(facts.notes[-1])
