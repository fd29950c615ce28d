"""What is proposed of found passes: stored as a whole, no measurement, and confirmed by a person alone."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, get_args
from uuid import uuid4

import numpy as np
import pytest

from sightline.enums import Made, Point, ProposedPoint, Target
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.measurements.records import Clicks
from sightline.measurements.service import made_of
from sightline.media.video.writer import write_mp4
from sightline.messages import say
from sightline.statistics.anchoring import shift, verdict
from sightline.vehicles.proposing.plan_store import is_drawn_free
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.store import replace_proposals
from tests.media.street import car, street
from tests.support.app import Client, error_of, upload
from tests.support.ground import (
    Ground,
    add_pose,
    add_vehicle,
    clicks,
    flat_camera,
    lay_ground,
    store_calibration,
)

Work = Callable[[], list[Job]]


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def proposal(vehicle_id: int, point: str, at: list[float] | None, frame: int = 2) -> PointProposal:
    return PointProposal(
        vehicle_id=vehicle_id,
        point=point,  # type: ignore[arg-type]
        frame=frame,
        point_px=None if at is None else (at[0], at[1]),
        expected_px=None if at is None else 0.4,
        reason="proposals-eye-not-seen" if at is None else None,
    )


@pytest.fixture
def proposed(services: Services, operator: Client, ground: Ground) -> tuple[int, dict[str, Any]]:
    """A vehicle with a proposed contact and roof, and the clicks that confirm them."""
    vehicle_id = int(add_vehicle(operator, ground.recording_id)["id"])
    wanted = clicks(1.2, frame=2)
    made = [
        proposal(vehicle_id, "contact_rear", wanted["contact"]),
        proposal(vehicle_id, "roof", wanted["target_point"]),
        proposal(vehicle_id, "driver_eye", None),
    ]
    with services.writing() as session:
        replace_proposals(session, ground.recording_id, ground.pose_id, made, actor=None)
    return vehicle_id, {**wanted, "client_key": str(uuid4())}


def moved(body: dict[str, Any], by_px: float = 3.0) -> dict[str, Any]:
    x, y = body["target_point"]
    return {**body, "target_point": [x, y + by_px], "client_key": str(uuid4())}


@pytest.mark.dialect
def test_what_was_confirmed_says_so_and_what_was_moved_too(
    operator: Client, viewer: Client, ground: Ground, proposed: tuple[int, dict[str, Any]]
) -> None:
    vehicle_id, wanted = proposed
    shown = viewer.seen(f"/recordings/{ground.recording_id}/proposals")
    assert [one["point"] for one in shown] == ["contact_rear", "roof", "driver_eye"]
    assert shown[2]["reason"] == "proposals-eye-not-seen" and say(shown[2]["reason"], {})
    assert viewer.seen(f"/vehicles/{vehicle_id}")["measurements"] == []

    path = f"/vehicles/{vehicle_id}/measurements"
    other = operator.post(path, {**moved(wanted), "made": "confirmed"})
    assert other.status_code == 409 and "confirm them again" in error_of(other)
    stored = operator.made(path, {**wanted, "made": "confirmed"})
    assert stored["made"] == "confirmed" and stored["created_by"] is not None
    again = operator.made(path, {**wanted, "made": "confirmed"})
    assert again["id"] == stored["id"]

    inset = {**wanted, "inset_m": 0.2, "u_inset_m": 0.1, "revision": 1}
    del inset["client_key"]
    revised = operator.put(f"/measurements/{stored['id']}", inset).json()
    assert (revised["made"], revised["revision"]) == ("confirmed", 2)
    shifted = moved({**inset, "revision": 2})
    del shifted["client_key"]
    dragged = operator.put(f"/measurements/{stored['id']}", shifted).json()
    assert dragged["made"] == "moved"
    elsewhere = {**shifted, "frame": 3, "revision": 3}
    assert operator.put(f"/measurements/{stored['id']}", elsewhere).json()["made"] == "clicked"
    events = [
        one for one in operator.seen(f"/audit?survey_id={ground.survey_id}") if one["entity"] == "measurement"
    ]
    assert [one["after"]["made"] for one in reversed(events)] == [
        "confirmed",
        "confirmed",
        "moved",
        "clicked",
    ]


def test_clicks_are_no_proposals_where_none_stands(
    operator: Client, services: Services, ground: Ground, proposed: tuple[int, dict[str, Any]]
) -> None:
    vehicle_id, wanted = proposed
    path = f"/vehicles/{vehicle_id}/measurements"
    eye = moved({**wanted, "target": "driver_eye"}, 20.0)
    # by hand, over the proposed contact: no eye is proposed that it could have been moved from
    assert operator.made(path, eye)["made"] == "clicked"
    assert operator.post(path, {**eye, "client_key": str(uuid4()), "made": "moved"}).status_code == 409
    assert operator.post(path, {**wanted, "frame": 5, "made": "moved"}).status_code == 409
    with services.writing() as session:
        replace_proposals(session, ground.recording_id, ground.pose_id, [], actor=None)
    gone = operator.post(path, {**wanted, "made": "confirmed"})
    assert gone.status_code == 409 and "made again" in error_of(gone)
    assert operator.made(path, wanted)["made"] == "clicked"
    (event, *_) = [
        one for one in operator.seen(f"/audit?survey_id={ground.survey_id}") if one["entity"] == "proposals"
    ]
    assert event["action"] == "propose" and event["after"]["points"] == 0


PLACES: dict[ProposedPoint, Point] = {"contact_rear": (100.0, 200.0), "roof": (110.0, 120.0)}
FREE = (130.0, 140.0)
#: target, contact, target point and what a page says of them; how they were set, None: not those proposed.
SET: list[tuple[Target, Point, Point, Made, Made | None]] = [
    ("roof", PLACES["contact_rear"], PLACES["roof"], "clicked", "confirmed"),
    ("roof", PLACES["contact_rear"], PLACES["roof"], "confirmed", "confirmed"),
    ("roof", PLACES["contact_rear"], FREE, "moved", "moved"),
    ("roof", PLACES["contact_rear"], FREE, "clicked", "moved"),
    ("roof", FREE, PLACES["roof"], "moved", "moved"),
    ("roof", FREE, FREE, "moved", "moved"),
    ("roof", FREE, FREE, "clicked", "clicked"),
    ("roof", FREE, FREE, "snapped", "snapped"),
    ("roof", PLACES["contact_rear"], FREE, "confirmed", None),
    # of an eye nothing is proposed
    ("driver_eye", PLACES["contact_rear"], FREE, "clicked", "clicked"),
    ("driver_eye", PLACES["contact_rear"], FREE, "snapped", "snapped"),
    ("driver_eye", FREE, FREE, "clicked", "clicked"),
    ("driver_eye", PLACES["contact_rear"], FREE, "moved", None),
    ("driver_eye", PLACES["contact_rear"], FREE, "confirmed", None),
]


@pytest.mark.parametrize(("target", "contact", "point", "said", "made"), SET)
def test_how_points_were_set_is_what_was_done_to_them(
    target: Target, contact: Point, point: Point, said: Made, made: Made | None
) -> None:
    clicks = Clicks(target=target, contact=contact, target_point=point, made=said)
    assert made_of(clicks, PLACES) == made


@pytest.mark.parametrize("target", get_args(Target))
@pytest.mark.parametrize("said", ["clicked", "snapped"])
def test_where_nothing_is_proposed_points_are_never_moved(target: Target, said: Made) -> None:
    clicks = Clicks(target=target, contact=FREE, target_point=FREE, made=said)
    assert made_of(clicks, {}) == said


def test_another_pose_or_a_cut_pass_takes_proposals_out_of_sight(
    operator: Client, services: Services, ground: Ground, proposed: tuple[int, dict[str, Any]]
) -> None:
    path = f"/recordings/{ground.recording_id}/proposals"
    vehicle_id, _ = proposed
    cut = {"version": 1, "first_frame": 4, "last_frame": 8}
    assert operator.put(f"/vehicles/{vehicle_id}", cut).status_code == 200
    assert operator.seen(path) == []
    whole = {"version": 2, "first_frame": 0, "last_frame": 8}
    assert operator.put(f"/vehicles/{vehicle_id}", whole).status_code == 200
    assert len(operator.seen(path)) == 3
    add_pose(services, ground.recording_id, ground.calibration_id, flat_camera())
    assert operator.seen(path) == []


def test_the_job_looks_through_the_video_and_keeps_a_reason_for_every_point(
    operator: Client, viewer: Client, services: Services, survey_id: int, work: Work, tmp_path: Path
) -> None:
    clip = tmp_path / "street.mp4"
    pictures = [np.repeat(g[..., None], 3, 2) for g in street(60, [car(15)])]
    write_mp4(clip, iter(pictures), 30, crf=18)
    recording_id = upload(operator, survey_id, clip)
    work()
    path = f"/recordings/{recording_id}/propose"
    assert viewer.post(path).status_code == 403
    assert "no camera pose" in error_of(operator.post(path)).lower()
    camera = flat_camera(pictures[0].shape[1], pictures[0].shape[0])
    _, calibration_id = store_calibration(services, survey_id, camera)
    add_pose(services, recording_id, calibration_id, camera)
    assert "Find the passes first" in error_of(operator.post(path))
    operator.made(f"/recordings/{recording_id}/find-passes")
    work()
    operator.made(path)
    assert "already" in error_of(operator.post(path))
    job = work()[-1]
    assert (job.kind, job.state) == ("proposals", "done"), job
    assert job.result is not None and job.result["passes"] == 1
    shown = operator.seen(f"/recordings/{recording_id}/proposals")
    assert len(shown) == 6
    assert all(one["point_px"] or say(one["reason"], {}) for one in shown)
    operator.made(path)
    work()
    assert len(operator.seen(f"/recordings/{recording_id}/proposals")) == 6

    stopped = operator.made(path)
    assert operator.made(f"/jobs/{stopped['id']}/cancel")["state"] == "cancelled"
    work()
    assert len(operator.seen(f"/recordings/{recording_id}/proposals")) == 6


def of_plan(operator: Client, admin: Client, survey_id: int, one_in: int) -> None:
    address = f"/surveys/{survey_id}/free-plan"
    now = operator.seen(address)
    wanted = {"free_one_in": one_in, "version": now["version"]}
    assert operator.put(address, wanted).status_code == 403
    assert admin.put(address, {**wanted, "free_one_in": 1}).status_code == 422
    assert admin.put(address, wanted).json()["free_one_in"] == one_in
    assert admin.put(address, wanted).status_code == 409  # somebody chose meanwhile


def test_the_server_draws_who_is_measured_free_and_keeps_to_it(
    operator: Client, admin: Client, services: Services, ground: Ground
) -> None:
    of_plan(operator, admin, ground.survey_id, 2)
    at = clicks(1.2, frame=2)["contact"]
    ids = [int(add_vehicle(operator, ground.recording_id)["id"]) for _ in range(40)]

    def drawn() -> set[int]:
        made = [proposal(one, "contact_rear", at) for one in ids]
        with services.writing() as session:
            replace_proposals(session, ground.recording_id, ground.pose_id, made, actor=None)
        shown = operator.seen(f"/recordings/{ground.recording_id}/proposals")
        assert all(one["withheld"] == (one["point_px"] is None) for one in shown)
        assert {one["frame"] for one in shown} == {2} and say("proposals-withheld", {})
        return {one["vehicle_id"] for one in shown if one["reason"] == "proposals-withheld"}

    first = drawn()
    assert 8 <= len(first) <= 32  # 40 draws of a half: outside at a chance of 1 in 20,000
    (event, *_) = [
        one for one in operator.seen(f"/audit?survey_id={ground.survey_id}") if one["entity"] == "proposals"
    ]
    seed = event["after"]["seed"]
    assert set(event["after"]["free"]) == first == {one for one in ids if is_drawn_free(seed, one, 2)}
    assert drawn() == first  # asking again draws nobody anew
    of_plan(operator, admin, ground.survey_id, 0)
    assert drawn() == first


def test_a_vehicle_measured_free_keeps_what_was_proposed_and_tells_nobody(
    operator: Client, admin: Client, services: Services, ground: Ground
) -> None:
    of_plan(operator, admin, ground.survey_id, 2)
    wanted = clicks(1.2, frame=2)
    ids = [int(add_vehicle(operator, ground.recording_id)["id"]) for _ in range(40)]
    made = [
        proposal(one, point, wanted[of])
        for one in ids
        for point, of in (("contact_rear", "contact"), ("roof", "target_point"))
    ]
    with services.writing() as session:
        replace_proposals(session, ground.recording_id, ground.pose_id, made, actor=None)
    shown = operator.seen(f"/recordings/{ground.recording_id}/proposals")
    free = {one["vehicle_id"] for one in shown if one["withheld"]}
    no_height, *confirmed = [one for one in ids if one not in free]
    above_horizon = {**moved(wanted), "contact": [wanted["contact"][0], 1.0]}
    assert operator.made(f"/vehicles/{no_height}/measurements", above_horizon)["height_m"] is None
    for one in (*free, *confirmed):
        by_hand = {**moved(wanted, -2.0), "contact": [wanted["contact"][0] + 0.5, wanted["contact"][1]]}
        body = by_hand if one in free else {**wanted, "client_key": str(uuid4()), "made": "confirmed"}
        stored = operator.made(f"/vehicles/{one}/measurements", body)
        assert stored["made"] == ("clicked" if one in free else "confirmed")
        assert not {"proposal", "proposed_contact_x_px", "proposed_target_y_px"} & set(stored)
    a_free = next(iter(free))
    snap = operator.made(f"/vehicles/{a_free}/frames/2/snap", {"click": wanted["contact"]})
    assert (snap["contact"], snap["reason"]) == (None, "snap-measured-free")
    asked = {"pointer": wanted["contact"], "vehicle_id": a_free}
    contact = operator.made(f"/recordings/{ground.recording_id}/frames/2/contact", asked)
    assert contact["contact"] is None and "without suggestions" in contact["words"]["message"]

    found = operator.seen(f"/surveys/{ground.survey_id}/anchoring")
    # what has no height is compared with nothing, and not counted beside what is
    assert (found["confirmed"], found["moved"], found["afresh"]) == (len(confirmed), 0, 0)
    all_, roof = found["targets"]
    assert (all_["target"], roof["target"], all_["shift"]) == (None, "roof", roof["shift"])
    told = roof["shift"]
    assert (told["shown"], told["free"]) == (len(confirmed), len(free))
    # confirmed as they stand those shown do not differ; free clicks 2 px higher are some millimetres higher
    assert told["shown_m"] == 0 and told["free_m"] > 0.002
    assert told["shift_m"] == -told["free_m"] and told["U95_shift_m"] < 1e-9
    assert found["goal_m"] == 0.002 and found["plan"]["free_one_in"] == 2


def test_a_shift_is_told_with_an_interval_that_holds() -> None:
    rng = np.random.default_rng(7)
    held = []
    for _ in range(1500):
        found = shift(rng.normal(0.001, 0.002, 60), rng.normal(0.004, 0.009, 8))
        assert found.shift_m is not None and found.U95_shift_m is not None
        held.append(abs(found.shift_m + 0.003) <= found.U95_shift_m)
    assert abs(float(np.mean(held)) - 0.95) < 0.02
    near = shift(rng.normal(0.0, 0.002, 200), rng.normal(0.0, 0.002, 60))
    far = shift(rng.normal(0.006, 0.002, 200), rng.normal(0.0, 0.002, 60))
    assert (verdict(near, 0.002), verdict(far, 0.002)) == ("met", "missed")
    wide = shift(rng.normal(0.0, 0.01, 20), rng.normal(0.0, 0.01, 6))
    assert (verdict(wide, 0.002), verdict(shift([], []), 0.002)) == ("undecided", None)
    few = shift([0.001] * 50, [0.002] * 4)
    assert (few.shift_m, few.U95_shift_m, few.free) == (None, None, 4)
    assert few.reason is not None and say(few.reason, {})
    assert shift([], []).shown_m is None
