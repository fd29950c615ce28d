"""Ingest: the frame table, its report in words, thumbnails, progress, cancel, being killed."""

from __future__ import annotations

import errno
import signal
import subprocess
import sys
import zlib
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from sightline.errors import NoRoom, Stopped
from sightline.media import atomic
from sightline.media.images import read_image
from sightline.media.store import local
from sightline.media.video.ingest import ingest
from sightline.media.video.thumbnails import MOST
from tests.media.clips import Spec, painted, uneven, write
from tests.media.conftest import ROOT, Clip, Ingest


def test_the_table_is_what_the_file_holds(clip: Clip, take_in: Ingest) -> None:
    result = take_in(clip(Spec("lossless.mkv", codec="ffv1", pix_fmt="gray", options=(), gop=1), 12))
    frames = result.frames
    assert len(frames) == 12
    assert list(frames.pts) == [40 * n for n in range(12)]
    assert np.allclose(frames.time_s, np.arange(12) / 25)
    assert frames.key.all()
    assert (frames.pts.dtype, frames.crc32.dtype) == (np.int64, np.uint32)
    assert not frames.pts.flags.writeable
    assert len(set(frames.crc32.tolist())) == 12


def test_the_checksum_is_that_of_the_luma_without_padding(
    clip: Clip, tmp_path: Path, take_in: Ingest
) -> None:
    import av

    path = write(tmp_path / "odd.mkv", Spec("odd.mkv", codec="ffv1", size=(326, 246), options=()), 3)
    with av.open(str(path)) as container:
        lumas = [frame.to_ndarray()[:246] for frame in container.decode(video=0)]
    assert [zlib.crc32(luma.tobytes()) for luma in lumas] == take_in(path).frames.crc32.tolist()


def test_variable_rate_is_seen_and_constant_rate_is_not(clip: Clip, take_in: Ingest) -> None:
    assert take_in(clip(Spec("vfr.mp4", pts_of=uneven))).report.vfr
    for spec in (
        Spec("cfr.mp4"),
        Spec("ntsc.mkv", rate=Fraction(30_000, 1001)),
        Spec("sixty.mkv", rate=Fraction(60)),
    ):
        report = take_in(clip(spec)).report
        assert not report.vfr and report.notes == (), report
        assert report.rate_hz == pytest.approx(float(spec.rate), rel=1e-3)


def test_times_come_from_the_time_stamps(clip: Clip, take_in: Ingest) -> None:
    frames = take_in(clip(Spec("vfr.mp4", pts_of=uneven))).frames
    assert np.allclose(frames.time_s, [uneven(n) / 90_000 for n in range(80)], atol=1e-4)


def test_a_recorder_that_repeats_pictures_is_reported(tmp_path: Path, take_in: Ingest) -> None:
    from sightline.media.video.writer import write_mp4

    numbers = [0, 1, 1, 1, 2, 3]
    path = tmp_path / "stuck.mp4"
    write_mp4(path, (painted(n) for n in numbers), 25, crf=0)
    report = take_in(path).report
    assert report.duplicates == 2
    assert any("same image" in note for note in map(str, report.notes))


def test_raw_streams_say_that_the_rate_is_assumed(clip: Clip, take_in: Ingest) -> None:
    result = take_in(clip(Spec("plain.h264", container="h264")))
    assert result.is_working_copy and result.media_path.is_file()
    assert any("25 frames per second are assumed" in note for note in map(str, result.report.notes))


@pytest.mark.parametrize(("rate", "count"), [(25, 80), (2, 40), (1, 12), (25, 3)])
def test_thumbnails_suit_the_length(
    rate: int, count: int, clip: Clip, tmp_path: Path, take_in: Ingest
) -> None:
    result = take_in(clip(Spec(f"r{rate}.mp4", rate=Fraction(rate)), count))
    thumbs = result.thumbnails
    assert min(count, 20) <= len(thumbs) <= max(21, count / rate + 1)
    assert thumbs[0].n == 0 and [t.n for t in thumbs] == sorted({t.n for t in thumbs})
    for thumb in thumbs:
        image = read_image(tmp_path / "thumbs" / thumb.name)
        assert image.shape == (120, 160)
        assert abs(float(image.mean()) - thumb.luminance) < 3
    assert {p.name for p in (tmp_path / "thumbs").iterdir()} == {t.name for t in thumbs}


def test_thumbnails_of_long_recordings_are_thinned(tmp_path: Path, take_in: Ingest) -> None:
    spec = Spec("long.mp4", rate=Fraction(1), size=(96, 64), options=(("preset", "ultrafast"),))
    thumbs = take_in(write(tmp_path / "long.mp4", spec, 900)).thumbnails
    assert MOST // 2 <= len(thumbs) <= MOST
    steps = np.diff([t.n for t in thumbs])
    assert steps.max() <= 2 * steps.min()
    assert thumbs[-1].n > 890


def test_progress_rises_to_one(clip: Clip, tmp_path: Path) -> None:
    seen: list[float] = []
    ingest(clip(Spec("cfr.mp4")), seen.append, lambda: False, tmp_path / "t")
    assert seen == sorted(seen) and seen[-1] == 1.0 and 0 <= seen[0] < 1


@pytest.mark.parametrize(
    "spec", [Spec("cfr.mp4"), Spec("plain.h264", container="h264"), Spec("a.ts")], ids=str
)
def test_cancelling_stops_at_once(spec: Spec, clip: Clip, tmp_path: Path) -> None:
    asked = iter([False] * 5 + [True] * 1000)
    with pytest.raises(Stopped, match="was cancelled"):
        ingest(clip(spec), lambda _: None, lambda: next(asked), tmp_path / "t", work_dir=tmp_path / "w")
    left = list((tmp_path / "w").iterdir()) if (tmp_path / "w").exists() else []
    assert left == []


def test_a_killed_ingest_can_be_done_again(tmp_path: Path, clip: Clip) -> None:
    path = clip(Spec("a.ts", gop=10), 80)
    program = (
        "import os, signal, sys\nfrom pathlib import Path\nfrom sightline.media.video.ingest import ingest\n"
        "left = int(sys.argv[1])\n"
        "def look():\n"
        "    global left\n"
        "    left -= 1\n"
        "    if not left:\n"
        "        os.kill(os.getpid(), signal.SIGKILL)\n"
        "    return False\n"
        f"ingest(Path({str(path)!r}), lambda _: None, look, Path({str(tmp_path / 't')!r}), "
        f"work_dir=Path({str(tmp_path / 'w')!r}))\n"
    )
    for frame in ("40", "130"):  # while it is copied, while it is decoded
        child = subprocess.run([sys.executable, "-c", program, frame], cwd=ROOT, check=False)
        assert child.returncode == -signal.SIGKILL
    result = ingest(path, lambda _: None, lambda: False, tmp_path / "t", work_dir=tmp_path / "w")
    assert len(result.frames) == 80
    assert {p.name for p in (tmp_path / "t").glob("*.jpg")} == {t.name for t in result.thumbnails}


def test_a_full_disk_is_told_and_leaves_no_working_copy(
    clip: Clip, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(atomic.os, "replace", full)
    with pytest.raises(NoRoom, match="disk is full"):
        ingest(clip(Spec("cfr.mp4")), lambda _: None, lambda: False, tmp_path / "t")
    monkeypatch.undo()
    monkeypatch.setattr(local.shutil, "disk_usage", lambda _: type("Usage", (), {"free": 10}))
    with pytest.raises(NoRoom, match="not enough space"):
        ingest(clip(Spec("a.ts")), lambda _: None, lambda: False, tmp_path / "t", work_dir=tmp_path / "w")
    assert list((tmp_path / "w").iterdir()) == []
    with pytest.raises(NoRoom, match="not enough space"):
        ingest(clip(Spec("cfr.mp4")), lambda _: None, lambda: False, tmp_path / "t")
