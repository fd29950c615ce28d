"""Calibrations of a rig in the app: looked at, put in force, kept in the history, in every speed's u."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from sightline.infra.audit.verification import verify_records
from sightline.infra.services import Services
from sightline.linescan.rig import CALIBRATED, baseline_of
from sightline.scans.records import StripSource
from sightline.scans.rig.calibrating import found_of
from sightline.scans.rig.store import rig_calibration_history
from sightline.scans.store import create_scan, get_scan, note_scan_read
from tests.linescan.test_rig_calibration import STANDS_M, Errors, by_board, by_positions, planes
from tests.support import scans_samples
from tests.support.app import Client, error_of
from tests.support.events import events_of

pytestmark = pytest.mark.dialect
SOURCE = (StripSource("a.tif", "aa/a.tif", "aa" * 32), StripSource("b.tif", "bb/b.tif", "bb" * 32))
HEADER = "pass,distance_m,u_distance_m,position_1_m,position_2_m,u_position_m"


@pytest.fixture
def scan_id(services: Services, survey_id: int) -> int:
    with services.writing() as session:
        rig = replace(scans_samples.RIG, distance_m=5.5, u_distance_m=0.1)
        made = create_scan(
            session, survey_id, name="Gate", source=SOURCE, time_axis="width", rig=rig, actor=None
        )
        note_scan_read(session, made.id, replace(scans_samples.facts(), lines=20_000), actor=None)
    return made.id


def table(opening: float = 0.0021, *more: str) -> dict[str, Any]:
    """Six passes of a staff between simulated planes."""
    errors = Errors(None)
    found = [by_positions(planes(opening=opening), told, errors) for told in STANDS_M]
    rows = [
        f"n{n},{one.distance_m},0.02,{one.position_1_m},{one.position_2_m},0.0015"
        for n, one in enumerate(found)
    ]
    return {"files": {"file": ("passes.csv", "\n".join([HEADER, *rows, *more]).encode(), "text/csv")}}


def rig_of(client: Client, scan_id: int) -> dict[str, Any]:
    scan: dict[str, Any] = client.seen(f"/scans/{scan_id}")
    return scan


def test_passes_are_looked_at_and_change_nothing(operator: Client, scan_id: int) -> None:
    before = rig_of(operator, scan_id)
    look = operator.post(f"/scans/{scan_id}/rig-calibrations/preview", **table(0.0021, "odd,near,,,,")).json()
    figures = look["figures"]
    rig = planes()
    assert look["status"] == "ok"
    assert figures["lane"]["baseline_m"] == pytest.approx(rig.between(5.5), abs=2e-6)
    assert figures["lane"]["U95_percent"] == pytest.approx(
        100 * figures["lane"]["U95_baseline_m"] / figures["lane"]["baseline_m"]
    )
    assert figures["lane"]["u_baseline_m"] < figures["u_baseline_m"]
    (refused,) = look["refused"]
    assert (refused["row"], refused["name"], refused["reason"]["message"]) == (
        8,
        "odd",
        "passes.csv, line 8: distance_m is “near”, which is not a number; correct the cell.",
    )
    assert rig_of(operator, scan_id) == before and operator.seen(f"/scans/{scan_id}/rig-calibrations") == []


@pytest.mark.once
def test_a_table_without_a_calibration_says_why(operator: Client, scan_id: int) -> None:
    lines = "\n".join([HEADER, "a,3,0.02,1,1.6,0.001", "b,3,0.02,1,1.6,0.001", "c,3.1,0.02,1,1.6,0.001"])
    sent = {"files": {"file": ("p.csv", lines.encode(), "text/csv")}}
    look = operator.post(f"/scans/{scan_id}/rig-calibrations/preview", **sent).json()
    assert (look["status"], look["figures"]) == ("not_solvable", None)
    assert "too close" in look["reason"]["message"]
    refused = operator.post(f"/scans/{scan_id}/rig-calibrations", params={"version": 2}, **sent)
    assert refused.status_code == 422 and "too close" in error_of(refused)
    no_table = {"files": {"file": ("p.csv", b"a,b\n1,2\n", "text/csv")}}
    refused = operator.post(f"/scans/{scan_id}/rig-calibrations/preview", **no_table)
    assert refused.status_code == 422 and "lacks columns" in error_of(refused)


def test_a_calibration_is_put_in_force_by_who_saw_the_rig(
    operator: Client, viewer: Client, services: Services, scan_id: int
) -> None:
    version = rig_of(operator, scan_id)["version"]
    place = f"/scans/{scan_id}/rig-calibrations"
    stored = operator.post(place, params={"version": version, "u_tape_ratio": 1e-4}, **table()).json()
    (shown,) = viewer.seen(place)
    assert shown["in_force"] and shown["revision"] == 1
    assert {name: stored["rig"][name] for name in CALIBRATED} == {
        name: shown["figures"][name] for name in CALIBRATED
    }
    late = operator.post(place, params={"version": version}, **table(0.003))
    assert late.status_code == 409
    with services.reading() as session:
        scan = get_scan(session, scan_id)
        (made,) = rig_calibration_history(session, scan_id)
        assert found_of(made.values).p_value == made.values.p_value
        events = [(one.action, one.entity) for one in events_of(session)][-2:]
        assert events == [("update", "scan"), ("calibrate", "rig_calibration")]
        baseline, u = baseline_of(scan.rig)
        assert (baseline, u) == (
            pytest.approx(shown["figures"]["lane"]["baseline_m"]),
            pytest.approx(shown["figures"]["lane"]["u_baseline_m"]),
        )
        assert verify_records(session).ok


@pytest.mark.once
def test_without_the_distance_of_the_vehicles_nothing_is_put_in_force(
    operator: Client, services: Services, scan_id: int
) -> None:
    """Their baseline would be the one at the cameras, where nobody drives."""
    place = f"/scans/{scan_id}/rig-calibrations"
    seen = rig_of(operator, scan_id)
    none = operator.http.patch(
        f"/api/scans/{scan_id}", json={"version": seen["version"], "distance_m": None}
    ).json()
    assert operator.post(f"{place}/preview", **table()).json()["figures"]["lane"] is None
    refused = operator.post(place, params={"version": none["version"]}, **table())
    assert refused.status_code == 422 and "distance from the cameras" in error_of(refused)
    said = {"distance_m": 4.25, "u_distance_m": 0.3}
    look = operator.post(f"{place}/preview", params=said, **table()).json()
    stored = operator.post(place, params={"version": none["version"], **said}, **table()).json()
    assert (stored["rig"]["distance_m"], stored["rig"]["u_distance_m"]) == (4.25, 0.3)
    (shown,) = operator.seen(place)
    lane, looked = shown["figures"]["lane"], look["figures"]["lane"]
    assert lane["distance_m"] == looked["distance_m"] == 4.25
    assert lane["baseline_m"] == pytest.approx(looked["baseline_m"], abs=1e-6)
    assert lane["u_baseline_m"] == pytest.approx(looked["u_baseline_m"], rel=1e-3)


def test_what_is_typed_later_is_in_force_and_the_calibration_can_be_again(
    operator: Client, scan_id: int
) -> None:
    place = f"/scans/{scan_id}/rig-calibrations"
    version = rig_of(operator, scan_id)["version"]
    operator.post(place, params={"version": version}, **table())
    before = rig_of(operator, scan_id)
    operator.post(place, params={"version": before["version"]}, **table(0.003))
    assert [one["in_force"] for one in operator.seen(place)] == [True, False]
    typed = operator.http.patch(
        f"/api/scans/{scan_id}", json={"version": before["version"] + 1, "baseline_m": 0.6}
    ).json()
    assert typed["rig"]["baseline_correlation"] == 0.0
    assert [one["in_force"] for one in operator.seen(place)] == [False, False]
    back = {name: before["rig"][name] for name in CALIBRATED}
    operator.http.patch(f"/api/scans/{scan_id}", json={"version": typed["version"], **back})
    assert [one["in_force"] for one in operator.seen(place)] == [False, True]


def test_a_scan_that_was_calibrated_stays(operator: Client, scan_id: int) -> None:
    version = rig_of(operator, scan_id)["version"]
    operator.post(f"/scans/{scan_id}/rig-calibrations", params={"version": version}, **table())
    assert operator.delete(f"/scans/{scan_id}").status_code == 409


@pytest.mark.once
def test_a_boards_lines_are_those_of_the_strips(operator: Client, scan_id: int) -> None:
    """No line rate is used: the board's own width is the scale."""
    names = ("width_m", "u_width_m", "front_line_1", "rear_line_1", "front_line_2", "rear_line_2")
    rows = [",".join(("distance_m", *names))]
    for told in STANDS_M:
        one = by_board(planes(), told, Errors(None))
        rows.append(",".join([str(told), *(str(getattr(one, name)) for name in names)]))
    sent = {"files": {"file": ("p.csv", "\n".join(rows).encode(), "text/csv")}}
    look = operator.post(f"/scans/{scan_id}/rig-calibrations/preview", **sent).json()
    assert look["figures"]["baseline_m"] == pytest.approx(0.593, abs=2e-6)
    assert [one["name"] for one in look["figures"]["passes"]] == [str(n) for n in range(2, 8)]
