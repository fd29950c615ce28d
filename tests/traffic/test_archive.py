"""The archive's files: a recording comes whole or not at all, once, at one time, and goes whole."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pyarrow.dataset as ds
import pytest

from sightline.errors import BadInput, Busy
from sightline.infra.file_lock import take_lock
from sightline.infra.local_time import day_start, instant_of
from sightline.linescan.parts import CUT, STOOD, STOPPED
from sightline.traffic import archive
from sightline.traffic.archive import add_recorded, remove_recorded, require_archive, sites_of, watched_rows
from sightline.traffic.query import ArchiveTables
from sightline.traffic.records import Asked, Recorded, Stood
from sightline.traffic.results import results_in, traffic_of
from tests.traffic.samples import recorded

PARIS = "Europe/Paris"


def stood(start: str, site: str = "Hill", lane: str = "", zone: str = PARIS) -> Stood:
    return Stood(site, lane, zone, instant_of(start, zone), 0.5)


def files(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*.parquet"))


def test_a_recording_over_midnight_is_parted_by_the_sites_days(tmp_path: Path) -> None:
    one = recorded(1, 300, 7200.0)
    assert add_recorded(tmp_path, one, stood("2026-05-04T23:00")) == 2
    mark = one.sha256[:16]
    assert files(tmp_path) == [
        f"{table}/site=Hill/day={day}/{mark}.parquet"
        for table in ("vehicles", "watched")
        for day in ("2026-05-04", "2026-05-05")
    ]
    rows = list(watched_rows(tmp_path, "Hill"))
    assert [(row["from_s"], row["to_s"]) for row in rows] == [(82800.0, 86400.0), (0.0, 3600.0)]
    assert not list(tmp_path.glob(".aside-*")) and not (tmp_path / ".journal.json").exists()


@pytest.mark.parametrize("at_end", [False, True])
def test_a_recording_that_ends_at_midnight_is_of_one_day(tmp_path: Path, at_end: bool) -> None:
    """It was of two; who comes at its very end is of its last interval."""
    one = recorded(1, 30, 3600.0)
    if at_end:
        last = replace(one.passings[-1], front_s=3600.0, rear_s=3600.0)
        one = replace(one, passings=(*one.passings[:-1], last))
    assert add_recorded(tmp_path, one, stood("2026-05-04T23:00")) == 1
    assert [(row["day"].day, row["to_s"]) for row in watched_rows(tmp_path, "Hill")] == [(4, 86400.0)]
    with ArchiveTables(tmp_path) as tables:
        (site,), rows = tables.sites(), list(tables.intervals(Asked(minutes=60)))
    assert (site.days, site.last_day.day, site.vehicles) == (1, 4, 30)
    assert [row["vehicles"] for row in rows] == [30]


def test_lanes_of_one_rig_are_lanes_of_the_archive(tmp_path: Path) -> None:
    """Each lane was watched, also one that nobody drove in; a vehicle of unknown lane is of none."""
    one = recorded(3, 30, 3600.0)
    lanes = ["near", "far", None]
    passings = tuple(replace(car, lane=lanes[at % 3]) for at, car in enumerate(one.passings))
    one = replace(one, passings=passings, lanes=("near", "far", "bus"))
    with pytest.raises(BadInput, match="lanes of their own"):
        add_recorded(tmp_path, one, stood("2026-05-04T06:00", lane="near"))
    add_recorded(tmp_path, one, stood("2026-05-04T06:00"))
    assert [row["lane"] for row in watched_rows(tmp_path, "Hill")] == ["near", "far", "bus", ""]
    with ArchiveTables(tmp_path) as tables:
        found = {each.lane: (each.vehicles, each.watched_s) for each in tables.sites()}
    assert found == {"near": (10, 3600.0), "far": (10, 3600.0), "bus": (0, 3600.0), "": (10, 3600.0)}
    other = replace(recorded(4, 5, 60.0), lanes=("far",))
    with pytest.raises(BadInput):
        add_recorded(tmp_path, other, stood("2026-05-04T06:30"))


def test_other_engines_read_every_vehicle_with_its_trace(tmp_path: Path) -> None:
    one = recorded(2, 50, 3600.0)
    add_recorded(tmp_path, one, stood("2026-05-04T06:00", site="Côte 1"))
    read = ds.dataset(tmp_path / "vehicles", partitioning="hive", exclude_invalid_files=False).to_table()
    assert read.num_rows == 50 and set(read["site"].to_pylist()) == {"Côte 1"}
    start = datetime(2026, 5, 4, 4, tzinfo=UTC)
    of_number = {row["number"]: row for row in read.to_pylist()}
    for passing in one.passings:
        row = of_number[passing.number]
        assert row["recording"] == one.name and row["recording_sha256"] == one.sha256
        assert row["front_line_1"] == passing.front_line_1 and row["speed_mps"] == passing.speed_mps
        assert abs(row["passed_at"] - start - timedelta(seconds=passing.front_s)) < timedelta(microseconds=2)
        assert row["since_midnight_s"] == pytest.approx(6 * 3600 + passing.front_s, abs=1e-9)


@pytest.mark.parametrize(
    ("day", "hours"),
    [("2026-03-29", 23), ("2026-10-25", 25), ("2026-05-04", 24)],
    ids=["spring", "autumn", "may"],
)
def test_days_are_as_long_as_clocks_make_them(tmp_path: Path, day: str, hours: int) -> None:
    add_recorded(tmp_path, recorded(3, 400, hours * 3600.0), stood(f"{day}T00:00"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked()))
    assert len(rows) == hours and all(row["watched_s"] == 3600.0 for row in rows)
    assert sum(row["vehicles"] for row in rows) == 400
    assert len({row["from"] for row in rows}) == hours  # an hour that comes twice has two offsets


def test_a_date_begins_where_clocks_skip_its_midnight() -> None:
    # Beirut's clocks went from 2022-03-26 23:59:59 to 2022-03-27 01:00
    begins = day_start(datetime(2022, 3, 27).date(), "Asia/Beirut")
    assert begins == datetime(2022, 3, 26, 22, tzinfo=UTC)


def test_what_is_there_already_is_refused(tmp_path: Path) -> None:
    one, other = recorded(4, 20, 3600.0), recorded(5, 20, 3600.0)
    add_recorded(tmp_path, one, stood("2026-05-04T06:00"))
    before = files(tmp_path)
    with pytest.raises(BadInput, match="is already in the archive"):
        add_recorded(tmp_path, one, stood("2026-06-04T06:00"))
    with pytest.raises(
        BadInput, match=r"both observed this lane of Hill from 2026-05-04 04:30:00 UTC to 2026-05-04 05:00"
    ):
        add_recorded(tmp_path, other, stood("2026-05-04T06:30"))
    with pytest.raises(BadInput, match="uses the time zone Europe/Paris, not Europe/London"):
        add_recorded(tmp_path, other, stood("2026-05-05T06:30", zone="Europe/London"))
    assert files(tmp_path) == before
    add_recorded(tmp_path, other, stood("2026-05-04T06:30", lane="left"))
    assert len(files(tmp_path)) == len(before) + 2


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1)])
def test_segments_of_one_stream_count_every_vehicle_once(tmp_path: Path, order: tuple[int, ...]) -> None:
    """Each begins 40 ms before the one before it ends; one stands from the first to the last."""
    cars = recorded(10, 6, 600.0).passings
    stands = replace(cars[-1], front_s=500.0, front_line_1=2.5e6, rear_s=None, rear_line_1=None)
    refused = {"speed_mps": None, "length_m": None, "status": "not_measurable"}
    stands = replace(stands, reason=str(STOOD), **refused)
    in_view = replace(stands, number=1, front_s=0.0, front_line_1=0.0, rear_s=599.999, reason=str(STOPPED))
    left = replace(in_view, rear_s=300.0, rear_line_1=1.5e6)
    last = replace(cars[0], number=2, front_s=400.0, rear_s=400.5)
    segments = [
        Recorded("1", "ab" * 32, 600.0, (*cars[:-1], stands)),
        Recorded("2", "cd" * 32, 600.0, (in_view,)),
        Recorded("3", "ef" * 32, 600.0, (left, last)),
    ]
    starts = ["2026-05-04T12:00:00", "2026-05-04T12:09:59.960", "2026-05-04T12:19:59.920"]
    for at in order:
        add_recorded(tmp_path, segments[at], stood(starts[at]))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=10)))
    assert [row["vehicles"] for row in rows] == [6, 0, 1]
    assert [row["watched_s"] for row in rows] == pytest.approx([600.0, 600.0, 599.92])
    assert [row["occupancy_ratio"] for row in rows] == [None, None, None]
    by_flow = [one for scan in traffic_of(results_in(tmp_path)[0], 60) for one in scan.intervals]
    assert sum(one.vehicles for one in by_flow) == 7
    longer = replace(segments[1], sha256="01" * 32, duration_s=700.0)
    with pytest.raises(BadInput, match="both observed this lane"):
        add_recorded(tmp_path, longer, stood("2026-05-04T12:29:59.700"))


@pytest.mark.parametrize("lane", [None, "near"])
def test_who_is_cut_by_the_end_of_a_pair_and_whole_in_the_next_is_counted_there(
    tmp_path: Path, lane: str | None
) -> None:
    """Of a stream that was killed, the second of two nearer together than the baseline: it was the one that
    was cut. A vehicle that is cut has no lane; of the first, the next pair sees the rear.
    """
    first, second = (replace(one, lane=lane) for one in recorded(1, 2, 60.0, unmeasured=0.0).passings)
    first = replace(first, front_s=59.0, rear_s=59.92, front_line_1=295_000.0)
    cut = replace(second, front_s=59.95, rear_s=60.0, front_line_1=299_750.0, lane=None)
    cut = replace(cut, speed_mps=None, length_m=None, status="not_measurable", reason=str(CUT))
    rest = replace(cut, number=1, front_s=0.0, rear_s=0.01, front_line_1=0.0)
    whole = replace(second, front_s=0.04, rear_s=0.3, front_line_1=200.0)
    lanes = () if lane is None else (lane,)
    one = Recorded("1", "ab" * 32, 60.0, (first, cut), lanes)
    two = Recorded("2", "cd" * 32, 60.0, (rest, whole), lanes)
    add_recorded(tmp_path, one, stood("2026-05-04T12:00:00"))
    add_recorded(tmp_path, two, stood("2026-05-04T12:00:59.910"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=60)))
    assert sum(row["vehicles"] for row in rows) == sum(row["measured"] for row in rows) == 2
    by_flow = [one for scan in traffic_of(results_in(tmp_path)[0], 60) for one in scan.intervals]
    assert sum(one.vehicles for one in by_flow) == sum(one.measured for one in by_flow) == 2


@pytest.mark.parametrize("name", ["", " Hill", ".Hill", "a/b", "a=b", "a%20", "x" * 81, "a\nb"])
def test_a_name_that_is_no_folders_is_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(BadInput, match="cannot name a site"):
        add_recorded(tmp_path, recorded(1, 2, 60.0), stood("2026-05-04T06:00", site=name))
    assert not files(tmp_path)


def test_a_recording_goes_whole(tmp_path: Path) -> None:
    one, other = recorded(6, 20, 7200.0), recorded(7, 20, 3600.0)
    add_recorded(tmp_path, one, stood("2026-05-04T23:00"))
    add_recorded(tmp_path, other, stood("2026-05-04T20:00"))
    assert remove_recorded(tmp_path, one.name) == 2
    assert {Path(name).stem for name in files(tmp_path)} == {other.sha256[:16]}
    with pytest.raises(BadInput, match="has no recording"):
        remove_recorded(tmp_path, one.name)
    remove_recorded(tmp_path, other.sha256[:12])
    assert sites_of(tmp_path) == []
    require_archive(tmp_path)


@pytest.mark.parametrize("after", range(5))
def test_what_was_cut_off_is_brought_to_its_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int
) -> None:
    """Killed after so many of the four moves: the next who opens the archive finds the recording whole."""
    real, left = os.replace, [after]

    def replace(here: Path, there: Path) -> None:
        if "site=" in str(there) and ".aside" not in str(there):
            if left[0] == 0:
                raise KeyboardInterrupt
            left[0] -= 1
        real(here, there)

    one = recorded(8, 30, 7200.0)
    monkeypatch.setattr(archive.os, "replace", replace)
    monkeypatch.setattr(archive.shutil, "rmtree", lambda *_a, **_k: None)  # a killed process tidies nothing
    if after < 4:
        with pytest.raises(KeyboardInterrupt):
            add_recorded(tmp_path, one, stood("2026-05-04T23:00"))
        assert json.loads((tmp_path / ".journal.json").read_text())["come"]
    monkeypatch.undo()
    if after == 4:
        add_recorded(tmp_path, one, stood("2026-05-04T23:00"))
    require_archive(tmp_path)
    with ArchiveTables(tmp_path) as tables:
        (site,) = tables.sites()
    assert (site.vehicles, site.days, site.watched_s) == (30, 2, 7200.0)


def test_one_at_a_time_changes_it(tmp_path: Path) -> None:
    held = take_lock(tmp_path / ".lock")
    assert held is not None
    with held, pytest.raises(Busy, match="being changed"):
        add_recorded(tmp_path, recorded(9, 2, 60.0), stood("2026-05-04T06:00"))


def test_an_empty_folder_is_no_archive(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="is not a traffic archive"):
        require_archive(tmp_path)
