"""`sightline stream`: the same vehicles as from the files, whatever the pieces, and nothing lost."""

from __future__ import annotations

import io
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from pathlib import Path
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
import tifffile

from sightline.cli import main
from sightline.media.lines.piped import PipedLines
from sightline.media.lines.source import Ending
from sightline.media.strips.sheet import Pixels
from sightline.media.strips.spool import SpooledLines
from sightline.messages import write_count
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, traffic
from tests.support.waiting import until

pytestmark = pytest.mark.once

SITE = ScanSite(rows=64, misalignment_px=0.3)
KNOWN = ("--u-baseline", "0.0005", "--u-line-rate", "1e-6")
RIG = ("--baseline", str(SITE.baseline_m), "--line-rate", str(SITE.line_rate_hz), *KNOWN)
STREAM = ("stream", "--rows", str(SITE.rows), *RIG)


@contextmanager
def standard_input(data: bytes, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Standard input that gives its bytes in pieces of odd sizes."""
    out, into = os.pipe()

    def write() -> None:
        drawn, left = np.random.default_rng(3), data
        with os.fdopen(into, "wb", buffering=0) as pipe:
            while left:
                size = int(drawn.integers(1, 300_000))
                pipe.write(left[:size])
                left = left[size:]

    writer = threading.Thread(target=write)
    with os.fdopen(out, "rb") as source, monkeypatch.context() as patched:
        patched.setattr(sys, "stdin", source)
        writer.start()
        yield
        writer.join()


@pytest.fixture(scope="module")
def pixels() -> tuple[Pixels, Pixels]:
    return strips(SITE, traffic(5, 3, speeds_mps=(14.0, 24.0), gaps_s=(0.5, 0.8), start_s=0.8))


def mixed(pixels: tuple[Pixels, Pixels]) -> bytes:
    return np.stack(pixels, axis=1).astype(np.uint8).tobytes()


def said_by(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    data: bytes,
    *more: str,
    status: int = 0,
) -> tuple[list[dict[str, object]], str]:
    with standard_input(data, monkeypatch):
        assert main([*STREAM, *more]) == status
    printed = capsys.readouterr()
    assert "Traceback" not in printed.err
    return [measured_of(line) for line in printed.out.splitlines()], printed.err


@pytest.fixture(scope="module")
def streamed(pixels: tuple[Pixels, Pixels]) -> list[dict[str, object]]:
    """What is told of the whole stream where nothing happens to it."""
    out = io.StringIO()
    with (
        pytest.MonkeyPatch.context() as patch,
        standard_input(mixed(pixels), patch),
        redirect_stdout(out),
    ):
        assert main([*STREAM]) == 0
    return [measured_of(line) for line in out.getvalue().splitlines()]


def measured_of(line: str | bytes) -> dict[str, object]:
    """What a batch says of a vehicle too; a stream adds where its lines are, and the time of day."""
    said: dict[str, object] = json.loads(line)
    assert said.pop("segment") and said.pop("front_at")
    return said


def test_vehicles_are_those_of_the_files_and_the_lines_are_kept(
    pixels: tuple[Pixels, Pixels],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    files = [str(tmp_path / f"{k}.png") for k in (1, 2)]
    for path, strip in zip(files, pixels, strict=True):
        cv2.imwrite(path, strip.T)
    assert main(["linescan", *files, *RIG, "--json"]) == 0
    batch = json.loads(capsys.readouterr().out)["vehicles"]
    assert [one["status"] for one in batch] == ["ok"] * 3

    live, said = said_by(monkeypatch, capsys, mixed(pixels), "--spool", str(tmp_path / "spool"))
    assert live == batch
    kept = sorted((tmp_path / "spool").glob("0*"))
    assert [path.name for path in kept] == ["0001-camera-1.tif", "0001-camera-2.tif", "0001.jsonl"]
    assert f"{write_count(len(pixels[0]))} lines are stored in {kept[0]}." in said
    kept = kept[:2]
    for path, strip in zip(kept, pixels, strict=True):
        assert np.array_equal(tifffile.imread(path), strip)
    assert main(["linescan", *map(str, kept), *RIG, "--time-axis", "height", "--json"]) == 0
    again = json.loads(capsys.readouterr().out)
    assert again["vehicles"] == batch and again["notes"] == []

    # a second run writes over nothing; what a killed one left can be read as far as it came
    half = mixed(pixels)[: len(mixed(pixels)) // 2]
    live, said = said_by(monkeypatch, capsys, half + b"odd", "--spool", str(tmp_path / "spool"))
    assert "its last 3 bytes are left out" in said or "bytes are left out" in said
    assert len(list((tmp_path / "spool").glob("*.tif"))) == 4
    assert [one["speed_mps"] for one in live if one["status"] == "ok"] == [
        one["speed_mps"] for one in batch[: sum(one["status"] == "ok" for one in live)]
    ]


def test_each_vehicle_is_told_while_the_stream_goes_on(pixels: tuple[Pixels, Pixels], tmp_path: Path) -> None:
    command = [sys.executable, "-m", "sightline.cli", *STREAM, "--spool", str(tmp_path / "spool")]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=os.environ
    ) as live:
        assert live.stdin is not None and live.stdout is not None and live.stderr is not None
        live.stdin.write(mixed(pixels))
        live.stdin.flush()
        first = json.loads(live.stdout.readline())
        assert first["id"] == 1 and first["status"] == "ok"
        live.send_signal(signal.SIGTERM)  # as a service is stopped: what is complete is measured still
        rest = [json.loads(line) for line in live.stdout.read().splitlines()]
        said = live.stderr.read().decode()
    assert live.returncode == 0, said
    assert [one["id"] for one in rest] == [2, 3]
    assert f"{write_count(len(pixels[0]))} lines are stored in" in said, "those that lay in the pipe too"


def lines_at_the_end(source: int) -> int:
    """How many are taken of what lies there when the end is wished."""
    ending = Ending()
    ending.wish()
    taken = sum(len(piece.first) for piece in PipedLines(source, SITE.rows, ending).pieces() if piece)
    ending.close()
    os.close(source)
    return taken


def test_what_was_sent_before_the_end_was_wished_is_taken() -> None:
    source, into = os.pipe()
    os.write(into, bytes(2 * SITE.rows * 100))
    assert lines_at_the_end(source) == 100
    os.close(into)
    without_end = os.open("/dev/zero", os.O_RDONLY)
    assert lines_at_the_end(without_end) == (1 << 20) // (2 * SITE.rows)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (("--baseline", "-1"), "--baseline"),
        (("--rows", "3"), "--rows"),
        ((), "ended before one pair of lines (128 bytes)"),
    ],
)
def test_what_cannot_be_is_refused(
    more: tuple[str, ...], said: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out, error = said_by(monkeypatch, capsys, b"" if not more else b"0" * 1000, *more, status=2)
    assert out == [] and said in error


def test_a_full_disk_ends_the_keeping_only(
    pixels: tuple[Pixels, Pixels],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, os.strerror(28))

    monkeypatch.setattr("sightline.media.strips.spool.Spool.write", full)
    live, said = said_by(monkeypatch, capsys, mixed(pixels), "--spool", str(tmp_path / "spool"))
    assert [one["status"] for one in live] == ["ok"] * 3
    assert "could not be stored (No space left on device)" in said


def test_a_growing_file_is_followed_until_it_rests(
    pixels: tuple[Pixels, Pixels],
    streamed: list[dict[str, object]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    whole = mixed(pixels)
    path = tmp_path / "lines.raw"
    path.write_bytes(b"")

    def grow() -> None:
        with path.open("ab", buffering=0) as file:
            for start in range(0, len(whole), 700_001):
                file.write(whole[start : start + 700_001])

    writer, at_rest = threading.Thread(target=grow), list[float]()

    def clock() -> float:
        """Stands still while the file grows."""
        if writer.is_alive():
            return 0.0
        at_rest.append(time.monotonic())
        return at_rest[-1] - at_rest[0]

    monkeypatch.setattr("sightline.media.lines.followed.time", SimpleNamespace(monotonic=clock))
    writer.start()
    assert main([*STREAM, "--follow", str(path), "--until-idle", "1"]) == 0
    writer.join()
    assert [measured_of(line) for line in capsys.readouterr().out.splitlines()] == streamed

    assert main([*STREAM, "--until-idle", "1"]) == 2
    assert "--until-idle needs --follow" in capsys.readouterr().err
    assert main([*STREAM, "--follow", str(tmp_path / "none")]) == 2
    assert "give the file that the cameras’ program is writing" in capsys.readouterr().err


@pytest.mark.parametrize("follow", [True, False])
def test_a_killed_stream_is_taken_up_and_says_what_is_missing(
    follow: bool,
    pixels: tuple[Pixels, Pixels],
    streamed: list[dict[str, object]],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    whole, batch = mixed(pixels), streamed
    # killed while the second vehicle is in view, after the first was told
    in_view = int(batch[1]["front_line_2"]) + 50  # type: ignore[call-overload]
    part = whole[: in_view * 2 * SITE.rows]
    path, spool = tmp_path / "lines.raw", tmp_path / "spool"
    path.write_bytes(part)
    command = [sys.executable, "-m", "sightline.cli", *STREAM, "--spool", str(spool)]
    command += ["--follow", str(path)] if follow else []
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as live:
        assert live.stdin is not None and live.stdout is not None
        if not follow:
            live.stdin.write(part)
            live.stdin.flush()
        first = measured_of(live.stdout.readline())
        until_kept(spool, in_view)
        until_journalled(spool)
        live.kill()
    assert first == batch[0]

    if follow:
        path.write_bytes(whole)
        assert main([*STREAM, "--spool", str(spool), "--follow", str(path), "--until-idle", "0.5"]) == 0
        printed = capsys.readouterr()
        rest, said = [measured_of(line) for line in printed.out.splitlines()], printed.err
        assert "and nothing is missing" in said
        assert [one["id"] for one in rest] == [2, 3]
        shared = ("speed_mps", "length_m", "time_gap_s")
        for one, same in zip(rest, batch[1:], strict=True):
            for name in shared:
                assert one[name] == pytest.approx(same[name], rel=1e-3), name
    else:
        rest, said = said_by(monkeypatch, capsys, whole[in_view * 2 * SITE.rows :], "--spool", str(spool))
        assert "and the vehicle that was in view" in said and "lines) since then" in said
        assert rest[0]["id"] == 2 and rest[0]["status"] == "not_measurable"
        assert "cut off" in str(rest[0]["reason"])
        assert rest[-1]["speed_mps"] == pytest.approx(batch[2]["speed_mps"], rel=1e-3)
    # answered for: the next run takes up nothing
    _, said = said_by(monkeypatch, capsys, whole, "--spool", str(spool))
    assert "previous run was stopped" not in said


def test_another_rig_does_not_take_up_what_was_killed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    command = [sys.executable, "-m", "sightline.cli", *STREAM, "--spool", str(tmp_path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE) as live:
        assert live.stdin is not None
        live.stdin.write(bytes(2 * SITE.rows * 100))
        live.stdin.flush()
        until_kept(tmp_path, 100)
        live.kill()
    _, said = said_by(monkeypatch, capsys, b"", "--spool", str(tmp_path), "--baseline", "0.7", status=2)
    assert "start it with the same options to resume it" in said


def until_journalled(spool: Path) -> None:
    """A vehicle that was told and not yet journalled would be told again rather than not at all."""
    until(lambda: '"rear_line"' in (spool / "0001.jsonl").read_text())


def until_kept(spool: Path, lines: int) -> None:
    def kept() -> bool:
        paths = sorted(spool.glob("*.tif"))
        return len(paths) == 2 and all(SpooledLines(path).lines >= lines for path in paths)

    until(kept, lambda: "the lines were not kept")
