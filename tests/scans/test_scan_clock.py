"""The start of a line scan is confirmed by a person; each vehicle then has a time of day with its u."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from math import hypot, sqrt

import pytest

from sightline.infra.services import Services
from sightline.linescan.clock import u_passing_s
from sightline.linescan.parts import CUT
from sightline.scans.records import StripSource
from sightline.scans.store import create_scan, note_scan_read
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.store import create_scan_vehicle
from tests.support import scans_samples
from tests.support.app import Client

pytestmark = pytest.mark.dialect
SOURCE = (StripSource("a.tif", "aa/a.tif", "aa" * 32), StripSource("b.tif", "bb/b.tif", "bb" * 32))
START = {"local": "2026-05-03T08:10:00.250", "time_zone": "Europe/Paris", "u_s": 0.5}


@pytest.fixture
def scan_id(services: Services, survey_id: int) -> int:
    """A line scan with a vehicle that crossed camera 1 at line 1000.25, and one without a motion."""
    later = {
        "front_line_1": 4882.8e4,
        "rear_line_1": 4.883e7,
        "front_line_2": 4.883e7,
        "rear_line_2": 4.884e7,
    }
    nothing = dict.fromkeys(("speed_mps", "u_speed_mps", "length_m", "u_length_m"))
    with services.writing() as session:
        made = create_scan(
            session,
            survey_id,
            name="Gate",
            source=SOURCE,
            time_axis="width",
            rig=scans_samples.RIG,
            actor=None,
        )
        note_scan_read(session, made.id, scans_samples.facts(), actor=None)
        for values in (
            scans_samples.values(),
            scans_samples.values(**later, status="not_measurable", reason=CUT, **nothing),
        ):
            one = create_scan_vehicle(session, made.id, origin="found", actor=None)
            append_scan_measurement(session, one.id, values, actor=None)
    return made.id


def test_the_page_is_told_which_line_scans_overlap(
    operator: Client, viewer: Client, survey_id: int, scan_id: int, services: Services
) -> None:
    """`sightline flow` said so, of the same survey's package; Motion did not."""
    rig = replace(scans_samples.RIG, baseline_m=scans_samples.RIG.baseline_m + 1.0)
    with services.writing() as session:
        for name, of in (("Gate again", scans_samples.RIG), ("Bridge", rig)):
            made = create_scan(
                session, survey_id, name=name, source=SOURCE, time_axis="width", rig=of, actor=None
            )
            facts = replace(scans_samples.facts(), first_sha256=name)
            note_scan_read(session, made.id, facts, actor=None)
            car = create_scan_vehicle(session, made.id, origin="found", actor=None)
            append_scan_measurement(session, car.id, scans_samples.values(), actor=None)

    def notes(query: str = "") -> list[str]:
        told = viewer.seen(f"/surveys/{survey_id}/scan-traffic?minutes=60&{query}")["notes"]
        assert {one["code"] for one in told} <= {"scans-traffic-overlap"}
        return [one["message"] for one in told]

    assert notes() == []
    for scan in viewer.seen(f"/surveys/{survey_id}/scans"):
        local = "2026-05-03T08:10:01.250" if scan["name"] == "Gate again" else START["local"]
        body = {"version": scan["version"], "start": {**START, "local": local}}
        assert operator.http.patch(f"/api/scans/{scan['id']}", json=body).status_code == 200
    whole_s = scans_samples.facts().lines / scans_samples.RIG.line_rate_hz
    said = "Gate and Gate again overlap for {} s: a vehicle that both contain counts in each."
    assert notes() == [said.format(f"{round(whole_s - 1):,}".replace(",", "\u202f"))]
    assert notes("hour_from=8&hour_to=10") == [said.format(6599)]
    assert notes("hour_from=10&hour_to=11") == []  # nobody counts in it
    assert notes("hour_to=8") == notes("filmed_from=2026-05-04") == []


def test_a_confirmed_start_gives_each_vehicle_its_time(
    operator: Client, viewer: Client, scan_id: int
) -> None:
    address = f"/scans/{scan_id}"
    before = viewer.seen(address)
    assert (before["started_at"], before["time_zone"], before["u_start_s"]) == (None, None, None)
    assert all(one["filmed_at"] is None for one in viewer.seen(f"{address}/vehicles"))
    body = {"version": before["version"], "start": START}
    assert viewer.http.patch(f"/api{address}", json=body).status_code == 403
    stored = operator.http.patch(f"/api{address}", json=body)
    assert stored.status_code == 200, stored.text
    assert stored.json()["started_local"] == "2026-05-03T08:10:00.250+02:00"
    first, second = viewer.seen(f"{address}/vehicles")
    since_s = 1000.25 / 4882.8
    at = datetime(2026, 5, 3, 6, 10, 0, 250000, UTC) + timedelta(seconds=since_s)
    assert abs(datetime.fromisoformat(first["filmed_at"]) - at) <= timedelta(microseconds=500)
    assert first["filmed_at"].endswith("+02:00")
    u_s = hypot(0.5, 0.008 / 19.31415, 0.001 / sqrt(12))
    assert first["u_filmed_at_s"] == pytest.approx(u_s, rel=1e-12)
    assert first["U95_filmed_at_s"] == pytest.approx(1.96 * u_s, rel=1e-3)
    # ten thousand seconds later, without a motion: a time, and no uncertainty that nobody knows
    assert second["filmed_at"] == "2026-05-03T10:56:40.250+02:00"
    assert (second["u_filmed_at_s"], second["U95_filmed_at_s"]) == (None, None)
    taken_back = operator.http.patch(
        f"/api{address}", json={"version": stored.json()["version"], "start": None}
    )
    assert taken_back.json()["started_local"] is None
    assert all(one["filmed_at"] is None for one in viewer.seen(f"{address}/vehicles"))


def test_days_and_hours_of_filming_hold_for_scanned_vehicles(
    operator: Client, viewer: Client, survey_id: int, scan_id: int
) -> None:
    """One vehicle of 08:10 and one of 10:56; without a start both are left out, and counted."""
    address = f"/surveys/{survey_id}"

    def counted(query: str) -> tuple[int, int]:
        told = viewer.seen(f"{address}/scan-statistics?accepted_only=false&{query}")["counted"]
        return told["vehicles"], told["without_time"]

    def begins(query: str) -> list[tuple[str, int]]:
        (told,) = viewer.seen(f"{address}/scan-traffic?minutes=60&{query}")["scans"]
        return [(one["begins_at"][:16], one["vehicles"]) for one in told["intervals"]]

    assert (counted(""), counted("hour_from=8"), counted("filmed_to=2026-05-03")) == ((2, 0), (0, 2), (0, 2))
    body = {"version": viewer.seen(f"/scans/{scan_id}")["version"], "start": START}
    assert operator.http.patch(f"/api/scans/{scan_id}", json=body).status_code == 200
    asked = ("hour_from=8&hour_to=9", "hour_from=9", "hour_from=20&hour_to=9", "filmed_from=2026-05-04")
    assert [counted(one) for one in asked] == [(1, 0), (1, 0), (1, 0), (0, 0)]
    every = [("2026-05-03T08:10", 1), ("2026-05-03T09:00", 0), ("2026-05-03T10:00", 1)]
    every.append(("2026-05-03T11:00", 0))
    assert [begins(one) for one in ("", *asked)] == [every, every[:1], every[1:], every[:1], []]
    assert viewer.get(f"{address}/scan-traffic?hour_from=9&hour_to=9").status_code == 422


@pytest.mark.once
@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"u_s": 0}, "above 0"),
        ({"u_s": 4000}, "up to 3600 s"),
        ({"local": "2999-01-01T08:10:00"}, "is in the future"),
        ({"local": "2025-03-30T02:30:00"}, "does not exist"),
        ({"local": "2025-10-26T02:30:00"}, "occurs twice"),
        ({"time_zone": "Europe/Atlantis"}, "Europe/Atlantis"),
    ],
)
def test_what_cannot_be_a_start_is_refused(
    operator: Client, scan_id: int, changed: dict[str, object], words: str
) -> None:
    answer = operator.http.patch(f"/api/scans/{scan_id}", json={"version": 1, "start": {**START, **changed}})
    assert answer.status_code == 422 and words in answer.text


def test_two_people_at_once_are_told(operator: Client, scan_id: int) -> None:
    address = f"/api/scans/{scan_id}"
    assert operator.http.patch(address, json={"version": 1, "start": START}).status_code == 200
    assert operator.http.patch(address, json={"version": 1, "start": None}).status_code == 409


@pytest.mark.once
def test_an_uncertain_line_rate_adds_up() -> None:
    early, late = (u_passing_s(since, 0.001, 1e-4, 20.0, 0.01) for since in (0.0, 36000.0))
    assert early is not None and early < 0.0012 and late == pytest.approx(3.6, rel=1e-3)
    assert u_passing_s(1.0, 0.001, 0.0, None, None) is None
