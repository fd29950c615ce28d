"""`sightline traffic`: from two strips to hourly figures, and refusals in sentences."""

from __future__ import annotations

import csv
import io
import json
from datetime import datetime, timedelta
from pathlib import Path
from statistics import harmonic_mean

import cv2
import pytest

from sightline.cli import main
from sightline.traffic.archive import watched_rows
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, traffic, truths

pytestmark = pytest.mark.once

SITE = ScanSite(rows=128)
PLACE = ("--site", "Hill", "--start", "2026-05-04T06:00:00", "--zone", "Europe/Paris")


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What `linescan --json` prints of three vehicles."""
    folder = tmp_path_factory.mktemp("recording")
    cars = traffic(5, 3, speeds_mps=(14.0, 24.0), gaps_s=(0.5, 0.8), start_s=0.8)
    files = [str(folder / name) for name in ("first.png", "second.png")]
    for path, strip in zip(files, strips(SITE, cars), strict=True):
        cv2.imwrite(path, strip.T)
    rig = ("--baseline", str(SITE.baseline_m), "--line-rate", str(SITE.line_rate_hz))
    printed = io.StringIO()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdout", printed)
        assert main(["linescan", *files, *rig, "--json"]) == 0
    out = folder / "recording.json"
    out.write_text(printed.getvalue())
    return out


def said_by(capsys: pytest.CaptureFixture[str], *arguments: str, status: int = 0) -> str:
    assert main(["traffic", *arguments]) == status
    printed = capsys.readouterr()
    assert "Traceback" not in printed.err
    return printed.out if status == 0 else printed.err


def test_from_strips_to_figures(recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = str(tmp_path / "archive")
    said = said_by(capsys, "add", folder, str(recording), *PLACE)
    assert said.startswith("recording.json: 3 vehicles, 3 measured")
    (site,) = json.loads(said_by(capsys, "sites", folder, "--json"))["sites"]
    document = json.loads(recording.read_text())
    assert site["watched_s"] == pytest.approx(document["duration_s"]) and site["vehicles"] == 3
    true = truths(SITE, traffic(5, 3, speeds_mps=(14.0, 24.0), gaps_s=(0.5, 0.8), start_s=0.8))
    (row,) = csv.DictReader(io.StringIO(said_by(capsys, "flows", folder, "--percentile", "50")))
    speeds = sorted(one.vehicle.speed_mps for one in true)
    assert row["p50_speed_mps"] == "" and "P50 needs 6; there are 3" in row["reason"]
    assert float(row["space_mean_speed_mps"]) == pytest.approx(harmonic_mean(speeds), rel=1e-3)
    assert float(row["time_mean_speed_mps"]) == pytest.approx(sum(speeds) / 3, rel=1e-3)
    assert row["flow_per_hour"] == "" and "too little for a flow" in row["reason"]
    out = tmp_path / "flows.csv"
    said_by(capsys, "flows", folder, "--minutes", "1", "--lengths", "4,6", "-o", str(out))
    rows = list(csv.DictReader(io.StringIO(out.read_text())))
    assert [one["class"] for one in rows] == ["all", "to 4 m", "4 to 6 m", "above 6 m", "length unknown"]
    assert said_by(capsys, "remove", folder, "recording.json").startswith("recording.json was removed")
    assert "is empty; add a recording" in said_by(capsys, "sites", folder)


@pytest.mark.parametrize(
    ("given", "u_s"), [((), 0.5), (("--u-start", "0.1"), 0.1), (("--u-start", "0"), 0.0)]
)
def test_u_of_a_start_is_that_of_the_recording_unless_another_is_given(
    recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], given: tuple[str, ...], u_s: float
) -> None:
    """It was 0 where `linescan --u-start` had told it."""
    told = json.loads(recording.read_text()) | {"u_start_s": 0.5}
    path, folder = tmp_path / "told.json", tmp_path / "archive"
    path.write_text(json.dumps(told))
    said_by(capsys, "add", str(folder), str(path), *PLACE, *given)
    assert {row["u_start_s"] for row in watched_rows(folder, None)} == {u_s}


@pytest.mark.parametrize(
    ("start", "u_s", "contradicts"),
    [
        ("2026-05-04T07:00:00.000+02:00", 0.02, True),
        ("2026-05-04T04:00:02.500+00:00", 0.02, True),
        ("2026-05-04T04:00:02.500+00:00", 2.0, False),
        ("2026-05-04T06:00:00.400+02:00", 0.02, False),
        (None, 0.0, False),
    ],
)
def test_a_start_that_contradicts_that_of_the_recording_is_told(
    recording: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    start: str | None,
    u_s: float,
    contradicts: bool,
) -> None:
    path = tmp_path / "told.json"
    path.write_text(json.dumps(json.loads(recording.read_text()) | {"start": start, "u_start_s": u_s}))
    said = said_by(capsys, "add", str(tmp_path / "archive"), str(path), *PLACE)
    assert (f"told.json states the start {start}, but 2026-05-04T0" in said) is contradicts


def test_lines_of_a_stream_tell_their_start_by_their_times(
    recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    vehicles = json.loads(recording.read_text())["vehicles"]
    for hour, told in (("05", True), ("06", False)):
        path, begun = tmp_path / f"{hour}.jsonl", datetime.fromisoformat(f"2026-05-04T{hour}:00:00+02:00")
        rows = [
            one
            | {
                "front_at": (begun + timedelta(milliseconds=round(1000 * one["front_s"]))).isoformat(
                    timespec="milliseconds"
                )
            }
            for one in vehicles
        ]
        path.write_text("\n".join(map(json.dumps, rows)))
        given = (str(tmp_path / hour), str(path), *PLACE, "--duration", "3600", "--json")
        notes = json.loads(said_by(capsys, "add", *given))["notes"]
        assert [f"states the start 2026-05-04T{hour}" in one for one in notes] == [True] * told


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("flows", "--minutes", "7"), "does not divide a day"),
        (("flows", "--percentile", "0"), "above 0 and below 100"),
        (("flows", "--percentile", "15,x"), "something that is not a number"),
        (("flows", "--lengths", "12,6"), "increasing lengths"),
        (("flows", "--lengths", "nan"), "increasing lengths"),
        (("flows", "--from", "May"), "is not a day"),
        (("flows", "--from", "2026-05-05", "--to", "2026-05-04"), "is before --from"),
        (("flows", "--site", "Valley"), "The archive has no site Valley; it has Hill."),
        (("remove", "other.json"), "has no recording other.json"),
    ],
)
def test_what_cannot_be_asked_is_refused(
    recording: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: tuple[str, ...],
    said: str,
) -> None:
    folder = str(tmp_path / "archive")
    said_by(capsys, "add", folder, str(recording), *PLACE)
    command, *rest = arguments
    assert said in said_by(capsys, command, folder, *rest, status=2)


def test_a_folder_that_is_no_archive_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "is not a traffic archive" in said_by(capsys, "flows", str(tmp_path), status=2)
    assert "is not a traffic archive" in said_by(capsys, "sites", str(tmp_path / "none"), status=2)
