"""Line-scan recordings through the API: two strips come in, vehicles with their motion come out."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from sqlalchemy import update

from sightline.coverage import COVERAGE_95
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.tables import jobs
from sightline.infra.services import Services
from sightline.scans import read_job
from sightline.scans.vehicles.measurement_store import scan_measurement_history
from tests.support.app import Client, error_of
from tests.support.scanning_ground import RIG, pictures, uploads

pytestmark = pytest.mark.dialect

Work = Callable[[], list[Job]]


@pytest.fixture
def scan(operator: Client, gate_scan_id: int) -> dict[str, Any]:
    """A scan that was read, its vehicles found."""
    read: dict[str, Any] = operator.seen(f"/scans/{gate_scan_id}")
    return read


def test_two_strips_become_measured_vehicles(
    operator: Client, viewer: Client, reviewer: Client, scan: dict[str, Any], services: Services, work: Work
) -> None:
    first, _, truth = pictures()
    assert (scan["state"], scan["lines"], scan["rows_px"], scan["bits"]) == ("ready", *first.shape, 8)
    assert scan["job"]["kind"] == "scan_find" and scan["counts"]["to_review"] == len(truth)
    found = viewer.seen(f"/scans/{scan['id']}/vehicles")
    assert len(found) == len(truth)
    for one, true in zip(found, truth, strict=True):
        motion = one["measurement"]
        assert motion["status"] == "ok", motion["reason"]
        assert abs(motion["speed_mps"] / true.vehicle.speed_mps - 1) < 0.003
        assert abs(motion["length_m"] - true.vehicle.length_m) < 0.05
        assert motion["U95_speed_mps"] == pytest.approx(COVERAGE_95 * motion["u_speed_mps"])
    assert found[0]["gap"] is None
    gap = found[1]["gap"]
    assert gap["time_gap_s"] == pytest.approx(truth[1].time_gap_s, abs=0.003)
    for name in ("time_gap_s", "distance_gap_m"):
        assert gap[f"U95_{name}"] == pytest.approx(COVERAGE_95 * gap[f"u_{name}"])
    tile_of_strip_and_cache(viewer, scan, first)
    sources_are_gone(services, scan)
    marked_by_hand(operator, scan, truth[0])
    everything_of_one(operator, viewer, reviewer, found[1], truth[1])
    found_again(operator, scan, work)


@pytest.mark.once
def test_strips_given_the_wrong_way_round_are_told_and_swapped(
    operator: Client, survey_id: int, tmp_path: Path, work: Work
) -> None:
    given = uploads(operator, survey_id, tmp_path)
    turned = {"first_upload": given["second_upload"], "second_upload": given["first_upload"]}
    lane = {"name": "only", "distance_m": 5.0, "direction": "camera_2_first"}
    made = operator.made(f"/surveys/{survey_id}/scans", {**RIG, **turned, "name": "Turned", "lanes": [lane]})
    for _ in range(2):
        work()
    address = f"/scans/{made['id']}"
    wrong = operator.seen(address)
    assert (wrong["counts"]["not_measurable"], wrong["counts"]["vehicles"]) == (0, 3)
    assert operator.seen(f"{address}/rig-of-traffic")["order"]["code"] == "scan-run-swapped"
    swapped = operator.post(f"{address}/swap", {"version": wrong["version"]})
    assert swapped.status_code == 202 and swapped.json()["first_name"] == wrong["second_name"]
    assert {job.state for job in work()} == {"done"}
    right = operator.seen(address)
    assert right["rig"]["lanes"][0]["direction"] == "camera_1_first"
    _, _, truth = pictures()
    assert right["counts"]["to_review"] == right["counts"]["vehicles"] == len(truth)
    assert operator.seen(f"{address}/rig-of-traffic")["order"] is None
    for one, true in zip(operator.seen(f"{address}/vehicles"), truth, strict=True):
        assert abs(one["measurement"]["speed_mps"] / true.vehicle.speed_mps - 1) < 0.003


@pytest.mark.once
def test_boundaries_that_are_brought_back_are_what_they_were(
    operator: Client, reviewer: Client, scan: dict[str, Any], services: Services, work: Work
) -> None:
    """Dragged and undone, a boundary is the machine's again: its u, who placed it, and all numbers."""
    found = operator.seen(f"/scans/{scan['id']}/vehicles")[1]
    then, address = found["measurement"], f"/scan-vehicles/{found['id']}"
    lines = {name: then[name] for name in ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2")}
    dragged = {**lines, "front_line_1": lines["front_line_1"] - 7.5}

    def put(what: dict[str, float], version: int) -> dict[str, Any]:
        answer = operator.put(f"{address}/boundaries", {**what, "version": version})
        assert answer.status_code == 200, answer.text
        return dict(answer.json())

    judged = reviewer.made(f"/scan-measurements/{then['id']}/review", {"verdict": "accepted"})
    by_hand = put(dragged, found["version"])
    assert by_hand["measurement"]["placed_by_person"] and by_hand["measurement"]["mine"]
    assert by_hand["measurement"]["review"]["verdict"] == "to_review"
    undone = put(lines, by_hand["version"])
    now = undone["measurement"]
    assert now["review"] == judged["measurement"]["review"]
    changed = {"id", "revision", "cause", "created_by", "created_at", "review"}
    assert {name for name in now if now[name] != then[name]} <= changed
    assert (now["cause"], now["placed_by_person"], now["mine"]) == ("back", False, False)
    with services.reading() as session:
        history = scan_measurement_history(session, found["id"])
    doubts = [one.values.u_boundaries_m for one in history]
    assert doubts[0] == doubts[2] > 0 == doubts[1]
    redone = put(dragged, undone["version"])
    assert redone["measurement"]["placed_by_person"] and redone["measurement"]["mine"]
    assert redone["measurement"]["U95_length_m"] == by_hand["measurement"]["U95_length_m"]
    undone = put(lines, redone["version"])
    # a search may move boundaries that nobody placed; measured again with another rig they keep their doubt
    change = {"baseline_m": RIG["baseline_m"] * 1.01, "version": scan["version"]}
    assert operator.http.patch(f"/api/scans/{scan['id']}", json=change).status_code == 200
    operator.made(f"/scans/{scan['id']}/find", {"method": "direct", "search": False})
    work()
    with services.reading() as session:
        last = scan_measurement_history(session, found["id"])[-1].values
    assert (last.cause, last.placed_by, last.u_boundaries_m) == ("again", None, doubts[0])
    assert reviewer.seen(address)["vehicle"]["measurement"]["review"]["verdict"] == "to_review"
    assert last.u_length_m == pytest.approx(1.01 * then["u_length_m"], rel=0.03)


@pytest.mark.once
def test_a_rig_with_lanes_measures_every_vehicle_in_its_own(
    operator: Client, viewer: Client, scan: dict[str, Any], work: Work
) -> None:
    """All drive in the near lane; a person puts one into the far one, and back; gaps follow.

    Lanes differ by 2.4 %; what is matched again on other samples differs by 0.03 %.
    """
    near = {"name": "near", "distance_m": 5.0, "u_distance_m": 0.1, "tyres_from_px": 50, "tyres_to_px": 64}
    far = {"name": "far", "distance_m": 8.0, "u_distance_m": 0.2, "tyres_from_px": 30, "tyres_to_px": 50}
    rig = {"divergence_rad": 0.005, "u_divergence_rad": 0.0001, "lanes": [near, far]}
    address = f"/scans/{scan['id']}"
    twice = {**rig, "lanes": [near, near], "version": scan["version"]}
    assert "a name of its own" in error_of(operator.http.patch(f"/api{address}", json=twice))
    answer = operator.http.patch(f"/api{address}", json={**rig, "version": scan["version"]})
    assert answer.status_code == 200, answer.text
    assert answer.json()["counts"]["older"] == 3 and answer.json()["rig"]["lanes"][1]["name"] == "far"
    before = viewer.seen(f"{address}/vehicles")
    operator.made(f"{address}/find", {"method": "direct"})
    assert [job.state for job in work()] == ["done"]
    after = viewer.seen(f"{address}/vehicles")
    at_5_m = 1 + 0.005 * 5.0 / RIG["baseline_m"]
    for then, now in zip(before, after, strict=True):
        motion = now["measurement"]
        assert (motion["lane"], motion["lane_by"], motion["older"]) == ("near", "machine", False)
        assert motion["tyres_px"] == pytest.approx(59, abs=3)
        assert motion["speed_mps"] / then["measurement"]["speed_mps"] == pytest.approx(at_5_m, abs=1e-3)
    one = after[1]
    put = {"lane": "far", "version": one["version"]}
    moved = operator.put(f"/scan-vehicles/{one['id']}/lane", put).json()
    motion = moved["measurement"]
    assert (motion["lane"], motion["lane_by"], motion["cause"]) == ("far", "person", "lane")
    at_8_m = 1 + 0.005 * 8.0 / RIG["baseline_m"]
    assert motion["speed_mps"] / one["measurement"]["speed_mps"] == pytest.approx(at_8_m / at_5_m, abs=1e-3)
    assert motion["older"] is False and moved["gap"] is None
    assert viewer.seen(address)["counts"]["older"] == 0
    third = viewer.seen(f"{address}/vehicles")[2]["gap"]["headway_s"]
    assert third == pytest.approx(after[2]["gap"]["headway_s"] + after[1]["gap"]["headway_s"])
    # what a person said of the lane stays when vehicles are looked for again
    operator.made(f"{address}/find", {"method": "direct"})
    work()
    kept = viewer.seen(f"{address}/vehicles")[1]
    assert (kept["measurement"]["lane"], kept["measurement"]["lane_by"]) == ("far", "person")
    back = operator.put(f"/scan-vehicles/{one['id']}/lane", {"lane": None, "version": kept["version"]}).json()
    assert (back["measurement"]["lane"], back["measurement"]["lane_by"]) == ("near", "machine")
    unknown = operator.put(f"/scan-vehicles/{one['id']}/lane", {"lane": "x", "version": back["version"]})
    assert unknown.status_code == 422 and "no lane x" in error_of(unknown)


def tile_of_strip_and_cache(viewer: Client, scan: dict[str, Any], first: np.ndarray[Any, Any]) -> None:
    answer = viewer.get(f"/scans/{scan['id']}/tiles/1/0/1")
    assert answer.status_code == 200 and answer.headers["Cache-Control"] == "private, no-cache"
    picture = cv2.imdecode(np.frombuffer(answer.content, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert picture is not None and picture.shape == (64, 1024)
    assert np.abs(picture.astype(int) - first[1024:2048].T).mean() < 3
    known = {"If-None-Match": answer.headers["ETag"]}
    assert viewer.get(f"/scans/{scan['id']}/tiles/1/0/1", headers=known).status_code == 304
    assert "no tile 9999" in error_of(viewer.get(f"/scans/{scan['id']}/tiles/2/0/9999"))
    assert scan["levels"][0]["tiles"] == -(-len(first) // 1024) and scan["levels"][-1]["tiles"] == 1


def sources_are_gone(services: Services, scan: dict[str, Any]) -> None:
    """The stored form holds every pixel: the uploads are not kept beside it."""
    held = [path for path in (services.settings.data_dir / "media").rglob("*") if path.is_file()]
    assert len(held) == 2 and all(path.name.endswith(".strip.tif") for path in held)


def marked_by_hand(operator: Client, scan: dict[str, Any], truth: Any) -> None:
    """A vehicle told by its span in strip 1 alone is found in strip 2 and measured; taken out again."""
    span = {"front_line_1": round(truth.front_line_1, 1), "rear_line_1": round(truth.rear_line_1, 1)}
    made = operator.made(f"/scans/{scan['id']}/vehicles", span)
    motion = made["measurement"]
    assert (made["origin"], motion["cause"], motion["status"]) == ("person", "added", "ok"), motion["reason"]
    assert abs(motion["speed_mps"] / truth.vehicle.speed_mps - 1) < 0.003
    assert abs(motion["front_line_2"] - truth.front_line_2) < 6
    assert operator.made(f"/scans/{scan['id']}/vehicles", span)["id"] == made["id"]  # a lost answer's repeat
    assert operator.delete(f"/scan-vehicles/{made['id']}").status_code == 204
    empty = {"front_line_1": 10.0, "rear_line_1": 200.0}
    nothing = operator.post(f"/scans/{scan['id']}/vehicles", empty)
    assert nothing.status_code == 422 and "place its front and rear there by hand" in error_of(nothing)
    outside = {"front_line_1": 10.0, "rear_line_1": 1e9}
    assert "outside the strip" in error_of(operator.post(f"/scans/{scan['id']}/vehicles", outside))


def everything_of_one(
    operator: Client, viewer: Client, reviewer: Client, vehicle: dict[str, Any], truth: Any
) -> None:
    address = f"/scan-vehicles/{vehicle['id']}"
    detail = viewer.seen(address)
    assert len(detail["profile"]["line_1"]) > 3 and detail["budget"]
    total = sum(entry["u_speed_mps"] ** 2 for entry in detail["budget"]) ** 0.5
    assert total == pytest.approx(vehicle["measurement"]["u_speed_mps"], rel=1e-6)
    for word in ("first", "second", "difference"):
        answer = viewer.get(detail["match"][f"{word}_url"].removeprefix("/api"))
        assert answer.status_code == 200 and answer.headers["Content-Type"] == "image/jpeg"
    difference = cv2.imdecode(np.frombuffer(answer.content, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert difference is not None and np.median(np.abs(difference.astype(int) - 128)) < 12

    wheels = dict(zip(("front_wheel_line", "rear_wheel_line"), truth.wheel_lines_1, strict=True))
    with_wheels = operator.put(f"{address}/wheels", {**wheels, "version": vehicle["version"]}).json()
    motion = with_wheels["measurement"]
    assert abs(motion["wheelbase_m"] - truth.vehicle.wheelbase_m) < 0.02
    assert (motion["axles_by"], len(motion["axle_lines"])) == ("machine", 2)
    assert motion["axle_lines"] == pytest.approx(truth.wheel_lines_1, abs=4)
    with_wheels = corrected_axles(operator, address, motion, with_wheels["version"])
    facts = {"make": "Fiat", "true_length_m": truth.vehicle.length_m, "version": with_wheels["version"]}
    told = operator.put(f"{address}/facts", facts).json()
    assert told["length_error_m"] == pytest.approx(motion["length_m"] - truth.vehicle.length_m)
    named = {"true_wheelbase_m": 2.5, "facts_source": "a maker", "version": told["version"]}
    told = operator.put(f"{address}/facts", named).json()
    assert told["facts_source"] == "a maker"
    typed = {"true_wheelbase_m": truth.vehicle.wheelbase_m, "version": told["version"]}
    told = operator.put(f"{address}/facts", typed).json()
    assert told["facts_source"] is None  # of the size before, not of this one

    lines = {name: motion[name] for name in motion if name.endswith(("line_1", "line_2"))}
    lines = {name: lines[name] for name in ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2")}
    moved = {**lines, "rear_line_1": lines["rear_line_1"] + 5, "version": told["version"]}
    placed = operator.put(f"{address}/boundaries", moved).json()
    assert placed["measurement"]["rear_line_1"] == moved["rear_line_1"]
    assert (placed["measurement"]["cause"], placed["measurement"]["mine"]) == ("boundaries", True)
    assert placed["measurement"]["wheelbase_m"] == pytest.approx(motion["wheelbase_m"], abs=0.03)
    assert (placed["measurement"]["axles_by"], len(placed["measurement"]["axle_lines"])) == ("person", 3)
    stale = operator.put(f"{address}/boundaries", moved)
    assert stale.status_code == 409 and "changed vehicle" in error_of(stale)
    upside_down = {**moved, "rear_line_1": 0.0, "version": placed["version"]}
    assert "must come before the rear" in error_of(operator.put(f"{address}/boundaries", upside_down))
    measured = placed["measurement"]["id"]
    bare = reviewer.post(f"/scan-measurements/{measured}/review", {"verdict": "rejected"})
    assert "needs a reason" in error_of(bare)
    verdict = {"verdict": "accepted", "seen": "to_review"}
    judged = reviewer.made(f"/scan-measurements/{measured}/review", verdict)
    again = reviewer.post(f"/scan-measurements/{measured}/review", verdict)
    assert again.status_code == 409 and "“accepted” meanwhile" in error_of(again)
    assert judged["state"] == "accepted"
    reopened = {"verdict": "reopened", "seen": "accepted"}
    review = f"/scan-measurements/{measured}/review"
    others = reviewer.post(review, {**reopened, "seen_at": "2026-01-02T03:04:05Z"})
    assert others.status_code == 409 and "“accepted” meanwhile" in error_of(others)
    unzoned = {**reopened, "seen_at": judged["measurement"]["review"]["at"].removesuffix("Z")}
    refused = reviewer.post(review, unzoned)
    assert refused.status_code == 422 and "should have its time zone" in error_of(refused)
    reviewer.made(review, {**reopened, "seen_at": judged["measurement"]["review"]["at"]})
    assert reviewer.made(review, {"verdict": "accepted"})["state"] == "accepted"
    detail = viewer.seen(address)
    assert [one["cause"] for one in detail["history"]] == ["found", *["wheels"] * 4, "boundaries"]
    assert [one["verdict"] for one in detail["reviews"]] == ["accepted", "reopened", "accepted"]


def corrected_axles(operator: Client, address: str, motion: dict[str, Any], version: int) -> dict[str, Any]:
    """A person adds an axle, has them found again, and adds it once more; what cannot be is refused."""
    found = motion["axle_lines"]
    three = [*found, (found[0] + found[1]) / 2]
    one = operator.put(f"{address}/axles", {"axle_lines": three, "version": version}).json()
    assert one["measurement"]["axle_lines"] == sorted(three) and one["measurement"]["axles_by"] == "person"
    assert one["measurement"]["wheelbase_m"] == motion["wheelbase_m"]
    outside = {"axle_lines": [0.0], "version": one["version"]}
    assert "outside the vehicle" in error_of(operator.put(f"{address}/axles", outside))
    again = operator.put(f"{address}/axles", {"axle_lines": None, "version": one["version"]}).json()
    assert again["measurement"]["axles_by"] == "machine"
    assert again["measurement"]["axle_lines"] == pytest.approx(found)
    told = operator.put(f"{address}/axles", {"axle_lines": three, "version": again["version"]})
    return dict(told.json())


def found_again(operator: Client, scan: dict[str, Any], work: Work) -> None:
    """What people took out stays out, what they placed stays, an unchanged result gets no revision."""
    before = operator.seen(f"/scans/{scan['id']}/vehicles")
    assert operator.delete(f"/scan-vehicles/{before[2]['id']}").status_code == 204
    operator.made(f"/scans/{scan['id']}/find", {"method": "direct"})
    busy = operator.post(f"/scans/{scan['id']}/find", {})
    assert busy.status_code == 409 and "already" in error_of(busy)
    (job,) = work()
    assert job.state == "done" and job.result is not None, job.error
    assert {name: job.result[name] for name in ("added", "discarded", "measured_again")} == {
        "added": 0,
        "discarded": 1,
        "measured_again": 0,
    }
    after = operator.seen(f"/scans/{scan['id']}/vehicles")
    assert [one["measurement"]["id"] for one in after] == [one["measurement"]["id"] for one in before[:2]]
    operator.made(f"/scan-vehicles/{before[2]['id']}/restore")
    another_baseline(operator, scan, work)


def another_baseline(operator: Client, scan: dict[str, Any], work: Work) -> None:
    """Results stay with the rig that they were made with, marked, until they are measured again."""
    change = {"baseline_m": RIG["baseline_m"] * 1.01, "version": scan["version"]}
    answer = operator.http.patch(f"/api/scans/{scan['id']}", json=change)
    assert answer.status_code == 200 and answer.json()["counts"]["older"] == 3
    before = operator.seen(f"/scans/{scan['id']}/vehicles")
    assert all(one["measurement"]["older"] for one in before)
    operator.made(f"/scans/{scan['id']}/find", {"method": "direct", "search": False})
    assert [job.state for job in work()] == ["done"]
    after = operator.seen(f"/scans/{scan['id']}/vehicles")
    for one, other in zip(before, after, strict=True):
        ratio = other["measurement"]["speed_mps"] / one["measurement"]["speed_mps"]
        assert ratio == pytest.approx(1.01, abs=0.002) and not other["measurement"]["older"]
    refused = operator.delete(f"/scans/{scan['id']}")
    assert refused.status_code == 409 and "cannot be deleted" in error_of(refused)


def test_strips_that_a_twin_takes_along_while_they_are_read_are_read_again(
    operator: Client,
    survey_id: int,
    services: Services,
    work: Work,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = operator.made(f"/surveys/{survey_id}/scans", {**RIG, **uploads(operator, survey_id, tmp_path)})
    stored, taken = read_job._store_strips, list[str]()

    def and_gone(*given: Any) -> Any:
        facts = stored(*given)
        if not taken:
            taken.append(facts.first_key)
            services.media.delete(facts.first_key)
        return facts

    monkeypatch.setattr(read_job, "_store_strips", and_gone)
    assert [job.state for job in work()] == ["queued"]
    assert operator.seen(f"/scans/{made['id']}")["state"] == "reading"
    with services.writing() as session:  # its pause is over
        session.execute(update(jobs).values(not_before=None))
    assert [job.state for job in work()] == ["done"]
    assert operator.seen(f"/scans/{made['id']}")["state"] == "ready"
    assert services.media.exists(taken[0])
