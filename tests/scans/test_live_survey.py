"""A live stream into a survey: a recording that grows, read and verified once it has ended."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import select, text, update

from sightline.cli import main
from sightline.errors import Away, BadInput, SightlineError
from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import DatabaseAway
from sightline.infra.database.types import now
from sightline.infra.services import Services
from sightline.scans.live import keeping, recording
from sightline.scans.live.keeping import SurveyKeeper
from sightline.scans.live.records import LiveStream, LiveVehicle, SegmentFacts
from sightline.scans.live.service import flow_of, live_streams
from sightline.scans.live.state import live_state
from sightline.scans.live.tables import scan_live
from sightline.scans.presenters import scan_body
from sightline.scans.service import request_find
from sightline.scans.store import list_scans, remove_scan, update_scan
from sightline.scans.vehicles.store import list_scan_vehicles
from tests.support.events import events_of
from tests.support.streaming import HEALTH, SITE, STREAM, Place, stored
from tests.support.waiting import until
from tests.support.working import run_jobs


@pytest.fixture
def services(hill: Services) -> Services:
    return hill


def streams_of(services: Services) -> list[LiveStream]:
    with services.reading() as session:
        return live_streams(session, 1)


def test_a_stream_from_a_pipe_has_no_source(
    services: Services, lines: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "lines.raw"
    path.write_bytes(lines[: 2 * SITE.rows * 100])
    with path.open("rb") as piped:
        monkeypatch.setattr("sys.stdin", piped)
        assert main([*STREAM, "--survey", "Hill", "--data-dir", str(tmp_path / "data")]) == 0
    assert [one.source for one in streams_of(services)] == [None]
    with services.reading() as session:
        assert session.execute(select(scan_live.c.source)).scalars().all() == [None]


def test_a_stream_becomes_a_recording_whose_vehicles_are_those_of_the_search(
    place: Place, services: Services, lines: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "lines.raw"
    path.write_bytes(lines)
    assert main([*STREAM, *place.where, "--follow", str(path), "--until-idle", "0.3"]) == 0
    told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]

    (stream,) = streams_of(services)
    assert stream.state == "ended" and not stream.ready and stream.source == str(path)
    assert stream.health is not None
    assert stream.health.lines == len(lines) // (2 * SITE.rows)
    assert [one.number for one in stream.vehicles] == [3, 2, 1]
    assert sum(minute.vehicles for minute in stream.flow) == 3
    first = stream.vehicles[-1]
    assert first.front_at == datetime.fromisoformat(told[0]["front_at"])
    assert first.speed_mps == told[0]["speed_mps"]

    assert [job.state for job in run_jobs(services)] == ["done"]
    run_jobs(services)  # the strips it was read from go
    with services.reading() as session:
        (scan,) = list_scans(session, 1)
        before = list_scan_vehicles(session, scan.id)
        kinds = [event.action for event in events_of(session, 1)]
    assert scan.state == "ready" and scan.source == "live" and scan.lines == len(lines) // (2 * SITE.rows)
    assert scan.run is not None and (scan.run.found, scan.run.measured) == (3, 3)
    assert {"recorded", "read", "run"} <= set(kinds)
    assert not list(place.folder.rglob("*.tif"))

    # the search over the stored strips says the same to the last bit, so nothing is revised
    with services.writing() as session:
        request_find(session, scan.id, "direct", True, actor=None)
    (job,) = run_jobs(services)
    assert job.result is not None and (job.result["added"], job.result["measured_again"]) == (0, 0)
    with services.reading() as session:
        assert list_scan_vehicles(session, scan.id) == before
        assert verify_records(session).ok

    with services.writing() as session:
        twice = {"line_rate_hz": 2 * SITE.line_rate_hz}
        update_scan(session, scan.id, twice, version=scan.version, actor=None)
    (later,) = streams_of(services)
    # a rate that is corrected later changes no time at which lines came
    assert (later.vehicles, later.until, later.flow) == (stream.vehicles, stream.until, stream.flow)
    assert later.line_rate_hz == SITE.line_rate_hz


@pytest.mark.parametrize(("at_begin", "at_end"), [(2, 2), (9, 1)])
def test_what_a_busy_database_does_not_take_is_stored_with_the_next_second(
    place: Place,
    services: Services,
    lines: bytes,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    at_begin: int,
    at_end: int,
) -> None:
    def busy(name: str, times: int) -> None:
        work, left = getattr(recording, name), [times]

        def tried(*given: Any, **named: Any) -> Any:
            left[0] -= 1
            if left[0] >= 0:
                raise DatabaseAway("database-busy")
            return work(*given, **named)

        monkeypatch.setattr(recording, name, tried)

    monkeypatch.setattr(keeping, "AGAIN_S", 0.0)
    busy("create_scan", at_begin)
    busy("add_scan_run", at_end)
    path = tmp_path / "lines.raw"
    path.write_bytes(lines)
    assert main([*STREAM, *place.where, "--follow", str(path), "--until-idle", "0.3"]) == 0
    assert "vehicles wait to be stored" in capsys.readouterr().err
    run_jobs(services)
    with services.reading() as session:
        (scan,) = list_scans(session, 1)
        assert len(list_scan_vehicles(session, scan.id)) == 3
        assert verify_records(session).ok
    assert scan.state == "ready" and scan.run is not None and scan.run.found == 3


def test_what_was_stored_though_its_answer_was_lost_is_not_stored_again(
    place: Place, services: Services, lines: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first commit of a recording, of a vehicle and of the end goes through, and nobody hears of it."""
    begun, lost = Services.writing, set[str]()

    @contextmanager
    def writing(self: Services, *given: Any, **named: Any) -> Iterator[Any]:
        with begun(self, *given, **named) as session:
            yield session
            scans = "SELECT action, entity FROM audit_events WHERE entity LIKE 'scan%' ORDER BY id DESC"
            what = " ".join(session.execute(text(scans)).first() or ())
        if what and what not in lost:
            lost.add(what)
            raise DatabaseAway("database-no-answer")

    monkeypatch.setattr(keeping, "AGAIN_S", 0.0)
    path = tmp_path / "lines.raw"
    path.write_bytes(lines)
    with monkeypatch.context() as patched:
        patched.setattr(Services, "writing", writing)
        assert main([*STREAM, *place.where, "--follow", str(path), "--until-idle", "0.3"]) == 0
    assert len(lost) >= 3
    run_jobs(services)
    with services.reading() as session:
        (scan,) = list_scans(session, 1)
        assert len(list_scan_vehicles(session, scan.id)) == 3
        kinds = [event.action for event in events_of(session, 1)]
        assert verify_records(session).ok
    assert scan.state == "ready" and scan.run is not None and scan.run.found == 3
    assert kinds.count("recorded") == kinds.count("run") == 1


def test_a_stream_taken_up_at_its_very_beginning_has_a_recording_of_its_own(place: Place) -> None:
    """Both segments have the stream's sign and the same moment; each is stored once."""
    at, ids = datetime(2026, 5, 3, 12, 0, tzinfo=UTC), list[int | None]()
    keeper = SurveyKeeper(place.sink(), lambda _: None)
    for number in (1, 2):
        keeper.begin(SegmentFacts(number, "sign", "lines.raw", at), ids.append)
        stored(keeper)
        keeper.hear(HEALTH)
        stored(keeper)
    assert ids == [None, 1, None, 2]
    again = SurveyKeeper(place.sink(), lambda _: None)
    # killed before its journal had the number
    again.take_up(SegmentFacts(2, "sign", "lines.raw", at), None, 0)
    again.hear(HEALTH)
    stored(again)
    assert again._recording is not None and again._recording.scan_id == 2


def test_a_killed_stream_of_a_survey_is_taken_up(
    place: Place, services: Services, lines: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "lines.raw"
    path.write_bytes(lines[: len(lines) * 2 // 3])
    command = [sys.executable, "-m", "sightline.cli", *STREAM, *place.where, "--follow", str(path)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as live:
        assert live.stdout is not None
        live.stdout.readline()

        def running() -> bool:
            found = [one for one in streams_of(services) if one.vehicles and one.health is not None]
            return [one.state for one in found] == ["running"]

        until(running)
        assert main([*STREAM, *place.where, "--follow", str(path)]) == 2
        assert "Another stream writes into" in capsys.readouterr().err
        live.kill()

    def stopped() -> bool:
        with services.writing() as session:  # what it had sent before may be heard after that
            session.execute(update(scan_live).values(heard_at=now() - timedelta(minutes=3)))
        with services.reading() as session:
            (left,) = list_scans(session, 1)
        states = streams_of(services)[0].state, left.state, scan_body(left).stream_state
        return states == ("stopped", "live", "stopped")

    until(stopped)
    path.write_bytes(lines)
    assert main([*STREAM, *place.where, "--follow", str(path), "--until-idle", "0.3"]) == 0
    assert "and nothing is missing" in capsys.readouterr().err
    run_jobs(services)
    with services.reading() as session:
        scans = list_scans(session, 1)
        numbers = [len(list_scan_vehicles(session, one.id)) for one in scans]
        assert verify_records(session).ok
    assert [one.state for one in scans] == ["ready", "ready"] and sum(numbers) == 3
    assert [one.run and one.run.found for one in scans] == numbers  # before the kill and after it
    assert [scan_body(one).stream_state for one in scans] == [None, None]
    (stream,) = streams_of(services)
    assert [one.scan_id for one in stream.earlier] == [scans[0].id]


@pytest.mark.parametrize("after", [1, 3])
def test_a_recording_that_is_deleted_while_it_is_streamed_is_said_and_leaves_nothing(
    place: Place,
    services: Services,
    lines: bytes,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    after: int,
) -> None:
    """After its first vehicle, or after its last."""
    keepers, add = list[SurveyKeeper](), SurveyKeeper.add

    def added(keeper: SurveyKeeper, vehicle: LiveVehicle) -> None:
        add(keeper, vehicle)
        stored(keeper)
        keepers.append(keeper)
        if len(keepers) == after:
            with services.writing() as session:
                (scan,) = list_scans(session, 1)
                remove_scan(session, scan.id, actor=None)
        elif len(keepers) > after:
            assert keeper._recording is not None
            assert not keeper._recording.waiting

    monkeypatch.setattr(SurveyKeeper, "add", added)
    path = tmp_path / "lines.raw"
    path.write_bytes(lines)
    assert main([*STREAM, *place.where, "--follow", str(path), "--until-idle", "0.3"]) == 0
    told = capsys.readouterr()
    assert len(told.out.splitlines()) == 3
    assert told.err.count("was deleted while it was streamed") == 1 and "wait to be stored" not in told.err
    assert not list(place.folder.rglob("*.tif"))
    assert '"ended"' in next(place.folder.rglob("*.jsonl")).read_text()
    with services.reading() as session:
        assert not list_scans(session, 1)
        assert verify_records(session).ok


@pytest.mark.parametrize("after_end", [False, True])
def test_strips_of_a_stream_that_was_killed_while_its_end_waited_are_moved_by_the_next(
    place: Place,
    services: Services,
    lines: bytes,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    after_end: bool,
) -> None:
    """Killed before, or after, the recording's end was stored: the journal had said that it was whole."""

    def killed(keeper: SurveyKeeper, recording: Any, paths: Any, notes: Any, _moved: Any) -> None:
        if after_end:
            keeper._try_end(recording, paths, notes)

    path, empty = tmp_path / "lines.raw", tmp_path / "empty.raw"
    path.write_bytes(lines)
    empty.write_bytes(b"")
    command = (*STREAM, *place.where, "--until-idle", "0.3")
    with monkeypatch.context() as patched:
        patched.setattr(SurveyKeeper, "_end", killed)
        assert main([*command, "--follow", str(path)]) == 0
    assert len(list(place.folder.rglob("*.tif"))) == 2
    assert main([*command, "--follow", str(empty)]) == 2  # no lines come
    assert not list(place.folder.rglob("*.tif"))
    assert [job.state for job in run_jobs(services)] == ["done"]
    with services.reading() as session:
        (scan,) = list_scans(session, 1)
        assert len(list_scan_vehicles(session, scan.id)) == 3
        assert [event.action for event in events_of(session, 1)].count("recorded") == 1
        assert verify_records(session).ok
    assert scan.state == "ready"


def test_an_end_that_is_refused_is_said_at_once_and_one_that_is_left_holds_up_no_other(
    place: Place, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As the server refuses it; then while it is away, so that all strips are left to the next stream."""
    sink, said, asked = place.sink(), list[str](), list[int]()
    keeper, why = SurveyKeeper(sink, lambda one: said.append(str(one))), list[SightlineError]()

    def end(scan_id: int, *_given: Any) -> None:
        asked.append(scan_id)
        raise why[0]

    monkeypatch.setattr(sink, "end", end)
    monkeypatch.setattr(keeping, "PATIENCE_S", 0.0)
    monkeypatch.setattr(keeping, "AGAIN_S", 0.05)
    why.append(BadInput("stream-strip-changed", name="0001-camera-1.tif"))
    with closing(keeper):
        for number in range(1, 4):
            paths = tmp_path / f"{number}-camera-1.tif", tmp_path / f"{number}-camera-2.tif"
            for path in paths:
                path.write_bytes(path.name.encode())
            at = datetime(2026, 5, 3, 12, number, tzinfo=UTC)
            keeper.begin(SegmentFacts(number, "sign", "lines.raw", at), lambda _: None)
            stored(keeper)
            keeper.end(paths, [], lambda: None)
            if number == 1:
                until(lambda: len(said) == 2)
                assert "does not arrive" in said[0] and str(paths[0]) in said[1]
                why[:] = [Away("database-no-answer")]
    assert [one for one in asked if one != 2] == [1] and len(list(tmp_path.glob("*-camera-*.tif"))) == 6
    assert sum("the next stream with this folder" in one for one in said) == 3


@pytest.mark.parametrize("there", ["nothing", "another", "deleted", "deleted unheard of"])
def test_strips_are_deleted_only_where_a_person_deleted_their_recording(
    place: Place, services: Services, tmp_path: Path, there: str
) -> None:
    """A database restored from before the recording, another database, and one where it was deleted; that
    also where a kill, or a lost answer, kept its number from the journal.
    """
    at, said = datetime(2026, 5, 3, 12, 0, tzinfo=UTC), list[str]()
    segment = SegmentFacts(1, "sign", "lines.raw", at)

    def keeper() -> SurveyKeeper:
        return SurveyKeeper(place.sink(), lambda one: said.append(one.sentence()))

    if there != "nothing":
        other, before = replace(segment, stream="other") if there == "another" else segment, keeper()
        before.begin(other, lambda _: None)
        stored(before)
    deleted = there.startswith("deleted")
    if deleted:
        with services.writing() as session:
            remove_scan(session, 1, actor=None)
    paths = (tmp_path / "0001-camera-1.tif", tmp_path / "0001-camera-2.tif")
    for path in paths:
        path.write_bytes(path.name.encode())
    ended, again = list[bool](), keeper()
    again.take_up(segment, None if there == "deleted unheard of" else 1, 0)
    again.end(paths, [], lambda: ended.append(True))
    again.close()
    assert [path.is_file() for path in paths] == [not deleted] * 2 and bool(ended) == deleted
    assert any("was deleted while" in one for one in said) == deleted
    assert any(str(paths[0]) in one and str(paths[1]) in one for one in said) != deleted
    assert not list(services.media.listing())
    with services.reading() as session:
        assert [one.state for one in list_scans(session, 1)] == (["live"] if there == "another" else [])


def test_a_recording_deleted_while_its_strips_are_stored_leaves_none_in_the_store(
    place: Place, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    put, puts = type(services.media).put_file, list[str]()

    def put_file(store: Any, key: str, *given: Any, **named: Any) -> Any:
        done = put(store, key, *given, **named)
        puts.append(key)
        if len(puts) == 2:
            with services.writing() as session:
                remove_scan(session, 1, actor=None)
        return done

    monkeypatch.setattr(type(services.media), "put_file", put_file)
    keeper = SurveyKeeper(place.sink(), lambda _: None)
    keeper.begin(SegmentFacts(1, "sign", "lines.raw", datetime(2026, 5, 3, tzinfo=UTC)), lambda _: None)
    paths = (tmp_path / "0001-camera-1.tif", tmp_path / "0001-camera-2.tif")
    for path in paths:
        path.write_bytes(path.name.encode())
    ended = list[bool]()
    keeper.end(paths, [], lambda: ended.append(True))
    keeper.close()
    assert len(puts) == 2 and ended == [True]
    assert {job.state for job in run_jobs(services)} == {"done"}
    assert not any(path.is_file() for path in paths) and not list(services.media.listing())


@pytest.mark.parametrize(
    ("quiet_s", "ended", "state"),
    [(1, False, "running"), (30, False, "silent"), (121, False, "stopped"), (9999, True, "ended")],
)
def test_a_stream_that_is_no_longer_heard_does_not_stay_live(quiet_s: float, ended: bool, state: str) -> None:
    at = datetime(2026, 5, 3, 12, 0, tzinfo=UTC)
    assert live_state(at - timedelta(seconds=quiet_s), at if ended else None, at) == state


def test_a_survey_that_is_not_there_is_named(
    services: Services, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*STREAM, "--survey", "Dale", "--data-dir", str(tmp_path / "data")]) == 2
    assert "Dale" in capsys.readouterr().err


def test_flow_counts_by_minutes_of_the_clock_and_says_which_were_watched_whole() -> None:
    begun = datetime(2026, 5, 4, 6, 0, 30, tzinfo=UTC)
    fronts = [begun + timedelta(seconds=s) for s in (5, 29, 30, 31, 95)]
    flow = flow_of(fronts, [(begun, begun + timedelta(seconds=100))])
    assert [(one.begin.minute, one.vehicles, one.whole) for one in flow] == [
        (0, 2, False),
        (1, 2, True),
        (2, 1, False),
    ]
    assert len(flow_of(fronts, [(begun, begun + timedelta(hours=5))])) == 60


def test_minutes_of_an_outage_were_not_watched() -> None:
    begun = datetime(2026, 5, 4, 6, 0, tzinfo=UTC)
    at = [begun + timedelta(seconds=s) for s in (0, 150, 149, 180, 290, 600)]
    flow = flow_of([], [(at[4], at[5]), (at[0], at[1]), (at[2], at[3])])
    assert [one.begin.minute for one in flow if not one.whole] == [3, 4, 10]
