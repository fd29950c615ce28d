"""A live stream into the survey of a running Sightline: what is other than with its own database."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import asdict, replace
from datetime import UTC, datetime, timedelta, timezone
from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pytest
from urllib3 import HTTPResponse

from sightline.cli import main
from sightline.commands.remote import Remote
from sightline.commands.remote_sink import RemoteSink
from sightline.errors import Away, BadInput
from sightline.infra.audit.verification import verify_records
from sightline.infra.services import Services
from sightline.linescan.parts import Crossings, Lane, Motion, Profile
from sightline.messages.said import Said
from sightline.people.token_store import list_api_tokens, revoke_api_token
from sightline.recordings.uploads.store import strips_waiting, unfinished_uploads
from sightline.scans.live import keeping
from sightline.scans.live.keeping import SurveyKeeper
from sightline.scans.live.records import LiveVehicle, SegmentFacts
from sightline.scans.live.service import live_streams
from sightline.scans.records import ScanVehicle
from sightline.scans.store import list_scans
from sightline.scans.vehicles.motion import measured_of, values_of
from sightline.scans.vehicles.store import get_scan_vehicle, list_scan_vehicles
from tests.support.app import Client
from tests.support.events import events_of
from tests.support.relay import Relay
from tests.support.scanning_ground import upload_strip
from tests.support.served import served
from tests.support.streaming import CAMERAS, HEALTH, STREAM, Place, stored, token_of
from tests.support.working import run_jobs

SEGMENT = SegmentFacts(1, "sign", "lines.raw", datetime(2026, 5, 3, 12, 0, 0, 250_001, tzinfo=UTC))
SCOPES = ("read", "upload", "measure")


@pytest.fixture
def followed(lines: bytes, tmp_path: Path) -> tuple[str, ...]:
    path = tmp_path / "lines.raw"
    path.write_bytes(lines)
    return "--follow", str(path), "--until-idle", "0.3"


def vehicles_of(services: Services) -> list[list[ScanVehicle]]:
    """Of each recording, whole."""
    with services.reading() as session:
        assert verify_records(session).ok
        each = [list_scan_vehicles(session, one.id) for one in list_scans(session, 1)]
        return [[get_scan_vehicle(session, one.id) for one in some] for some in each]


def after(count: int, then: Callable[[], None], patch: pytest.MonkeyPatch) -> None:
    """Have something happen when so many vehicles have been told."""
    add, added = SurveyKeeper.add, list[LiveVehicle]()

    def told(keeper: SurveyKeeper, vehicle: LiveVehicle) -> None:
        add(keeper, vehicle)
        added.append(vehicle)
        if keeper.storing is not None:
            keeper.storing.result()
        if len(added) == count:
            then()

    patch.setattr(SurveyKeeper, "add", told)


def test_a_stream_to_a_server_is_stored_as_one_to_its_database(
    hill: Services, followed: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SIGHTLINE_TOKEN", token_of(hill, *SCOPES))
    assert main([*STREAM, "--survey", "Hill", "--data-dir", str(tmp_path / "data"), *followed]) == 0
    with served(hill) as port:
        there = ("--server", f"http://127.0.0.1:{port}", "--spool", str(tmp_path / "spool"))
        assert main([*STREAM, "--survey", "Hill", *there, *followed]) == 0
    assert {job.state for job in run_jobs(hill)} == {"done"}
    here, over = vehicles_of(hill)
    assert len(here) == 3 and all(one.measurement and one.measurement.values.profile for one in here)
    assert [one.measurement and one.measurement.values for one in over] == [
        one.measurement and one.measurement.values for one in here
    ]
    with hill.reading() as session:
        one, two = list_scans(session, 1)
        by = {one.actor and one.actor.name for one in events_of(session, 1) if one.entity.startswith("scan")}
    assert one.run is not None and two.run is not None
    for name in ("rig", "found", "measured", "summary", "warnings", "method"):
        assert getattr(one.run, name) == getattr(two.run, name)
    same = ("name", "state", "rig", "first_name", "second_name", "lines", "first_sha256", "second_sha256")
    assert [getattr(one, name) for name in same] == [getattr(two, name) for name in same]
    assert (one.created_by, two.created_by and two.created_by.name) == (None, "Olga")
    assert by == {None, "Olga"}
    assert not list((tmp_path / "spool").glob("*.tif"))


def test_every_vehicle_arrives_as_it_was_measured(hill: Services) -> None:
    """Numbers of all sizes, one that cannot be measured, one of a lane, sayings within sayings."""
    crossings = Crossings(-3.25, 100.1 + 0.2, 1 / 3, 1e9 + 0.7)
    why = Said("scan-motion-no-wheelbase", reason=Said("scan-motion-cut"), digits=0.1 + 0.2, count=2**52)
    motions = [
        Motion("direct", crossings, "not_measurable", why, warnings=(why, why)),
        Motion("paper", replace(crossings, front_line_1=1e-300), "not_measurable", why, tyres_px=5e-324),
    ]
    with served(hill) as port, Remote(f"http://127.0.0.1:{port}", token_of(hill, *SCOPES)) as remote:
        sink = RemoteSink(remote, 1, CAMERAS, "direct")
        scan_id = sink.begin(SEGMENT, [])
        health = replace(HEALTH, words=(why,))
        for _ in range(2):
            sink.add(scan_id, motions, health)
        assert sink.begin(SEGMENT, []) == scan_id
    (stored,) = vehicles_of(hill)
    kept = {one.measurement.values.method: one.measurement.values for one in stored if one.measurement}
    assert kept == {one.method: values_of(one, CAMERAS, "found") for one in motions}


def test_a_token_that_may_not_write_is_refused_before_any_line_is_read(
    hill: Services, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with served(hill) as port:
        server = ("--server", f"http://127.0.0.1:{port}", "--spool", str(tmp_path / "spool"))
        command = [*STREAM, "--survey", "Hill", *server, "--follow", str(tmp_path / "none.raw")]
        for scopes, said in ((("read",), "measure"), (("read", "measure"), "upload"), ((), "token")):
            token = token_of(hill, *scopes) if scopes else "sightline_wrong"  # type: ignore[arg-type]
            monkeypatch.setenv("SIGHTLINE_TOKEN", token)
            assert main(command) == 1
            assert said in capsys.readouterr().err
        monkeypatch.setenv("SIGHTLINE_TOKEN", token_of(hill, *SCOPES))
        assert main([*command, "--data-dir", str(tmp_path)]) == 2
        assert "--data-dir" in capsys.readouterr().err
        assert main([*STREAM, "--survey", "Hill", *server[:2]]) == 2
        assert "--spool" in capsys.readouterr().err
        monkeypatch.delenv("SIGHTLINE_TOKEN")
        assert main(command) == 2 and "token" in capsys.readouterr().err
    assert not (tmp_path / "spool").exists()


def test_a_token_that_is_revoked_is_said_once_and_the_lines_stay_for_the_next_stream(
    hill: Services,
    followed: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def revoke() -> None:
        with hill.writing() as session:
            for token in list_api_tokens(session, 1):
                revoke_api_token(session, 1, token.id, actor=1)

    monkeypatch.setenv("SIGHTLINE_TOKEN", token_of(hill, *SCOPES))
    monkeypatch.setattr("sightline.infra.web.bearer.BELIEVED_S", 0.0)
    with served(hill) as port:
        there = (
            "--survey",
            "Hill",
            "--server",
            f"http://127.0.0.1:{port}",
            "--spool",
            str(tmp_path / "spool"),
        )
        with monkeypatch.context() as patched:
            after(1, revoke, patched)
            assert main([*STREAM, *there, *followed]) == 0
        told = capsys.readouterr()
        assert len(told.out.splitlines()) == 3
        assert told.err.count("Nothing more is stored in the survey") == 1 and "not valid" in told.err
        assert len(list((tmp_path / "spool").glob("*.tif"))) == 2
        (before,) = vehicles_of(hill)
        assert len(before) == 1
        monkeypatch.setenv("SIGHTLINE_TOKEN", token_of(hill, *SCOPES))
        empty = tmp_path / "empty.raw"
        empty.write_bytes(b"")
        assert main([*STREAM, *there, "--follow", str(empty), "--until-idle", "0.1"]) == 2
    for _ in range(3):
        assert {job.state for job in run_jobs(hill)} <= {"done"}
    (found,) = vehicles_of(hill)
    assert len(found) == 3 and found[0] == before[0]  # those that waited are found in the strips
    assert not list((tmp_path / "spool").glob("*.tif"))


def test_each_answer_may_be_lost_once(
    hill: Services, followed: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The server did what it was asked, and nobody heard of it."""
    send, lost = Remote._send, set[str]()

    def lose(remote: Remote, method: str, path: str, *given: Any) -> Any:
        answer = send(remote, method, path, *given)
        what = re.sub(r"\d+", "N", f"{method} {path.partition('?')[0]}")
        if what not in lost and (lost or method == "POST"):  # not before it has begun
            lost.add(what)
            raise Away("import-no-answer", url="x")
        return answer

    monkeypatch.setenv("SIGHTLINE_TOKEN", token_of(hill, *SCOPES))
    monkeypatch.setattr(keeping, "AGAIN_S", 0.0)
    monkeypatch.setattr("sightline.commands.remote._RETRY_S", 0.0)
    monkeypatch.setattr(Remote, "_send", lose)
    with served(hill) as port:
        there = ("--server", f"http://127.0.0.1:{port}", "--spool", str(tmp_path / "spool"))
        assert main([*STREAM, "--survey", "Hill", *there, *followed]) == 0
    assert {
        "POST /surveys/N/live",
        "POST /scans/N/live",
        "POST /surveys/N/uploads",
        "HEAD /uploads/N",
        "PATCH /uploads/N",
        "POST /scans/N/live/end",
    } <= lost
    assert {job.state for job in run_jobs(hill)} == {"done"}
    assert [len(some) for some in vehicles_of(hill)] == [3]
    with hill.reading() as session:
        assert [one.state for one in list_scans(session, 1)] == ["ready"]
        assert not strips_waiting(session, 1) and not unfinished_uploads(session, 1)


def test_a_server_that_is_away_for_a_while_delays_nothing_but_the_storing(
    hill: Services,
    followed: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("SIGHTLINE_TOKEN", token_of(hill, *SCOPES))
    monkeypatch.setattr(keeping, "AGAIN_S", 0.05)
    said, say = Event(), SurveyKeeper._say_waiting

    def say_waiting(keeper: SurveyKeeper, *given: Any) -> None:
        say(keeper, *given)
        said.set()

    def back() -> None:
        assert said.wait(60)
        relay.shut = False

    with served(hill) as port, Relay("127.0.0.1", port) as relay:
        monkeypatch.setattr(SurveyKeeper, "_say_waiting", say_waiting)
        after(1, relay.close_all, monkeypatch)
        after(3, back, monkeypatch)
        there = ("--server", f"http://127.0.0.1:{relay.port}", "--spool", str(tmp_path / "spool"))
        assert main([*STREAM, "--survey", "Hill", *there, *followed]) == 0
    told = capsys.readouterr()
    assert "does not answer" in told.err and "wait to be stored" in told.err
    assert [len(some) for some in vehicles_of(hill)] == [3] == [len(told.out.splitlines())]
    assert not list((tmp_path / "spool").glob("*.tif"))


def test_what_a_survey_that_stays_away_did_not_take_is_found_by_the_next_stream(
    place: Place,
    hill: Services,
    followed: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(keeping, "PATIENCE_S", 0.0)
    with monkeypatch.context() as patched:

        def away() -> None:
            def refuse(*_given: Any, **_named: Any) -> None:
                raise Away("database-no-answer")

            patched.setattr(Services, "writing", refuse)

        after(1, away, patched)
        assert main([*STREAM, *place.where, *followed]) == 0
    told = capsys.readouterr()
    assert len(told.out.splitlines()) == 3 and "the next stream with this folder" in told.err
    (before,) = vehicles_of(hill)
    assert len(before) == 1 and len(list(place.folder.rglob("*.tif"))) == 2
    empty = tmp_path / "empty.raw"
    empty.write_bytes(b"")
    assert main([*STREAM, *place.where, "--follow", str(empty), "--until-idle", "0.1"]) == 2
    for _ in range(3):
        assert {job.state for job in run_jobs(hill)} <= {"done"}
    (found,) = vehicles_of(hill)
    assert len(found) == 3 and found[0] == before[0]
    assert not list(place.folder.rglob("*.tif"))


def test_a_server_that_does_not_answer_holds_up_no_stream(hill: Services) -> None:
    """It took the request and says nothing: vehicles are taken meanwhile, and stored once it goes on."""
    token = token_of(hill, *SCOPES)
    with (
        served(hill) as port,
        Relay("127.0.0.1", port) as relay,
        Remote(f"http://127.0.0.1:{relay.port}", token) as remote,
    ):
        keeper = SurveyKeeper(RemoteSink(remote, 1, CAMERAS, "direct"), lambda _: None)
        relay.held = True
        keeper.begin(SEGMENT, lambda _: None)
        for count in range(50):
            keeper.hear(replace(HEALTH, lines=count))
        assert keeper.storing is not None and not keeper.storing.done()
        relay.held = False
        stored(keeper)
        keeper.end(None, [], lambda: None)
        keeper.close()
    with hill.reading() as session:
        assert [one.state for one in list_scans(session, 1)] == ["failed"]  # no lines were kept


def nested(deep: int) -> dict[str, Any]:
    """A sentence that nobody could be answered with."""
    said: dict[str, Any] = {"code": "scan-motion-cut", "values": {}}
    for _ in range(deep):
        said = {"code": "scan-motion-no-wheelbase", "values": {"reason": said}}
    return said


@pytest.mark.parametrize("status", [200, 302, 403, 404])
def test_what_something_on_the_way_says_is_no_word_of_the_servers(
    hill: Services, monkeypatch: pytest.MonkeyPatch, status: int
) -> None:
    """A network to sign in to, a proxy whose server restarts: the stream goes on, and is stored."""
    said = list[str]()
    with served(hill) as port, Remote(f"http://127.0.0.1:{port}", token_of(hill, *SCOPES)) as remote:
        keeper = SurveyKeeper(RemoteSink(remote, 1, CAMERAS, "direct"), lambda one: said.append(str(one)))
        keeper.begin(SEGMENT, lambda _: None)
        stored(keeper)
        with monkeypatch.context() as patched:
            page = HTTPResponse(b"<html>", {"Content-Type": "text/html"}, status)
            patched.setattr(remote._pool, "request", lambda *_given, **_named: page)
            keeper.hear(HEALTH)
            stored(keeper)
        keeper.hear(replace(HEALTH, lines=7))
        stored(keeper)
        keeper.end(None, [], lambda: None)
        keeper.close()
    assert len(said) == 1 and "not as Sightline does" in said[0]
    with hill.reading() as session:
        (stream,) = live_streams(session, 1)
    assert stream.state == "ended" and stream.health is not None and stream.health.lines == 7


ENOUGH: dict[str, Any] = {"speed_mps": 20.0, "u_speed_mps": 0.1, "acceleration_mps2": 0.0}
ENOUGH |= {"u_acceleration_mps2": 0.1, "length_m": 4.0, "u_length_m": 0.02}


WRONG: list[dict[str, Any]] = [
    {"speed_mps": float("nan")},
    {"speed_mps": None},
    {"speed_mps": -20.0},
    {"length_m": 0.0},
    {"u_speed_mps": 0.0},
    {"u_length_m": -0.1},
    {"length_m": float("inf")},
    {"reason": {"code": "scan-motion-cut", "values": {}}},
    {"status": "not_measurable"},
    {"status": "not_measurable", "reason": {"code": "scan-motion-cut", "values": {}}},
    {"status": "not_measurable", "reason": {"code": "a\x00", "values": {}}},
    {"warnings": [{"code": "scan-motion-cut", "values": {"a": 10**400}}]},
    {"warnings": [3]},
    {"warnings": [nested(100)]},
    {"warnings": [nested(150)]},
    {"rear_line_1": 1.0},
    {"correlation": 1.5},
    {"lane": "left", "lane_by": "machine"},
    {"lane": "near", "lane_by": "person"},
    {"lane": "near"},
    {"lane_by": "machine"},
    {"profile": {"line_1": [1.0], "speed_mps": [], "fitted_mps": [1.0], "used": [True]}},
    {"budget": [{"source": "x", "u_speed_mps": 0.1, "u_acceleration_mps2": 0.1}]},
    {"cause": "added"},
    {"method": "guess"},
]


def test_a_wrong_number_is_not_stored(hill: Services) -> None:
    right = Motion("direct", Crossings(10.0, 200.0, 50.0, 240.0), "ok", **ENOUGH)
    with served(hill) as port, Remote(f"http://127.0.0.1:{port}", token_of(hill, *SCOPES)) as remote:
        sink = RemoteSink(remote, 1, CAMERAS, "direct")
        scan_id = sink.begin(SEGMENT, [])
        rig = asdict(replace(CAMERAS, lanes=(Lane("near", 3.0),)))
        for wrong in WRONG:
            body = {"rig": rig, "vehicles": [{**measured_of(right), **wrong}], "health": None}
            with pytest.raises(BadInput):
                remote.write(f"/scans/{scan_id}/live", body)
            assert vehicles_of(hill) == [[]], wrong
        for wrong in ({"saturated": (0.0, 1.1)}, {"light_dn": (float("nan"), None)}, {"lines": 2**53}):
            with pytest.raises(BadInput):
                sink.add(scan_id, [], replace(HEALTH, **wrong))
        for year in (1, 9999):
            with pytest.raises(BadInput):
                sink.begin(replace(SEGMENT, began_at=SEGMENT.began_at.replace(year=year)), [])
        sink.add(scan_id, [right, right], None)
        sink.end(scan_id, [], [], 1)
        sink.end(scan_id, [], [], 1)
        with pytest.raises(BadInput, match="No stream is recording"):
            sink.add(scan_id, [right], None)
    assert [len(some) for some in vehicles_of(hill)] == [1]


def test_the_longest_vehicles_that_waited_fit_into_a_request(hill: Services) -> None:
    column, many = np.full(10_000, 1e5 / 3), keeping._AT_ONCE
    profile = Profile(column, column, column, np.zeros(len(column), bool))
    motions = [
        Motion(
            "paper",
            Crossings(front, front + 200.0, front + 40.0, front + 240.0),
            "ok",
            profile=profile,
            **ENOUGH,
        )
        for front in range(many)
    ]
    with served(hill) as port, Remote(f"http://127.0.0.1:{port}", token_of(hill, *SCOPES)) as remote:
        sink = RemoteSink(remote, 1, CAMERAS, "paper")
        sink.add(sink.begin(SEGMENT, []), motions, HEALTH)
    assert [len(some) for some in vehicles_of(hill)] == [many]


@pytest.mark.dialect
def test_a_recording_is_begun_added_to_and_ended_once(
    services: Services, operator: Client, survey_id: int
) -> None:
    began_at = SEGMENT.began_at.astimezone(timezone(timedelta(hours=2))).isoformat()
    new = {"rig": asdict(CAMERAS), "number": 1, "stream": "sign", "source": "pipe", "began_at": began_at}
    right = measured_of(Motion("direct", Crossings(10.0, 200.0, 50.0, 240.0), "ok", **ENOUGH))
    more = {"rig": asdict(CAMERAS), "vehicles": [right], "health": asdict(replace(HEALTH, lines=9))}
    end = {"rig": asdict(CAMERAS), "method": "direct", "notes": [], "told": 1}
    for _ in range(2):
        scan_id = operator.post(f"/surveys/{survey_id}/live", {**new, "others": []}).json()["id"]
        assert operator.post(f"/scans/{scan_id}/live", more).status_code == 204
    another = operator.post(f"/surveys/{survey_id}/live", {**new, "others": [scan_id]}).json()["id"]
    alone = upload_strip(operator, survey_id, b"II*\0", "first.tif")
    assert operator.post(f"/scans/{scan_id}/live/end", {**end, "first_upload": alone}).status_code == 422
    for _ in range(2):
        assert operator.post(f"/scans/{scan_id}/live/end", end).status_code == 204
    of = {"stream": "sign", "began_at": began_at}
    assert operator.get(f"/surveys/{survey_id}/live/segments", params=of).json() == [
        {"scan_id": another, "ended": False, "deleted": False},
        {"scan_id": scan_id, "ended": True, "deleted": False},
    ]
    with services.reading() as session:
        assert [one.id for one in list_scans(session, survey_id)] == [scan_id, another]
        (vehicle,) = list_scan_vehicles(session, scan_id)
        assert vehicle.measurement is not None and vehicle.measurement.created_by is not None
        events = [one for one in events_of(session, survey_id) if one.entity.startswith("scan")]
        assert verify_records(session).ok
    assert all(one.actor is not None for one in events)
    assert [one.action for one in events].count("run") == 1
