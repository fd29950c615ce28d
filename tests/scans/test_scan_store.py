"""Rules of scanned vehicles: append-only, somebody else reviews, a scan on which people worked stays."""

from dataclasses import replace
from typing import Any, cast

import pytest
from sqlalchemy import event
from sqlalchemy.orm import Session

from sightline.errors import BadInput, Conflict, NotAllowed, NotFound
from sightline.infra.audit import trail
from sightline.infra.audit.verification import verify_records
from sightline.linescan.gaps import OTHER_RATE
from sightline.linescan.parts import STOOD, Crossings, Motion
from sightline.scans.store import get_scan, remove_scan, update_scan
from sightline.scans.vehicles.find_job import Search, plan
from sightline.scans.vehicles.listing import shown_vehicles, vehicles_of
from sightline.scans.vehicles.measure import Readers
from sightline.scans.vehicles.measurement_store import (
    append_scan_measurement,
    append_scan_measurements,
    get_scan_measurement,
    scan_measurement_history,
)
from sightline.scans.vehicles.motion import motion_of
from sightline.scans.vehicles.review_store import add_scan_review, scan_reviews_of_vehicle
from sightline.scans.vehicles.store import (
    change_scan_vehicle,
    create_scan_vehicle,
    create_scan_vehicles,
    get_scan_vehicle,
    last_scan_vehicles,
    list_scan_vehicles,
)
from tests.support import samples, scans_samples
from tests.support.events import events_of
from tests.support.scans_samples import values

pytestmark = pytest.mark.dialect


def test_a_measurement_comes_back_to_the_bit(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one)
    assert made.values == values()
    vehicle = get_scan_vehicle(session, made.vehicle_id)
    assert vehicle.measurement == made and vehicle.state == "to_review"
    listed = list_scan_vehicles(session, made.scan_id)[0].measurement
    assert listed is not None and listed.values == replace(values(), profile=None)


def test_a_revision_stands_beside_the_one_before_and_waits_for_a_review(session: Session) -> None:
    one = samples.sample(session)
    first = scans_samples.measured(session, one)
    add_scan_review(session, first.id, verdict="accepted", actor=one.rene.id)
    assert get_scan_vehicle(session, first.vehicle_id).state == "accepted"
    moved = values(cause="boundaries", placed_by=one.olga.id, front_line_1=1001.0)
    again = append_scan_measurement(session, first.vehicle_id, moved, version=2, actor=one.olga.id)
    assert [m.revision for m in scan_measurement_history(session, first.vehicle_id)] == [1, 2]
    vehicle = get_scan_vehicle(session, first.vehicle_id)
    assert (vehicle.state, vehicle.version, vehicle.measurement) == ("to_review", 3, again)
    with pytest.raises(Conflict, match="measured again meanwhile"):
        add_scan_review(session, first.id, verdict="rejected", reason="Shadow.", actor=one.rene.id)
    with pytest.raises(Conflict, match="Olga changed vehicle 1"):
        append_scan_measurement(session, first.vehicle_id, moved, version=2, actor=one.rene.id)


def test_nobody_reviews_boundaries_of_their_own(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one, cause="boundaries", placed_by=one.olga.id)
    with pytest.raises(NotAllowed, match="you placed"):
        add_scan_review(session, made.id, verdict="accepted", actor=one.olga.id)
    with pytest.raises(BadInput, match="needs a reason"):
        add_scan_review(session, made.id, verdict="rejected", reason=" ", actor=one.rene.id)
    judged = add_scan_review(session, made.id, verdict="rejected", reason="A shadow.", actor=one.rene.id)
    assert (judged.review.verdict, judged.review.reason) == ("rejected", "A shadow.")
    add_scan_review(session, made.id, verdict="reopened", actor=one.rene.id)
    assert get_scan_vehicle(session, made.vehicle_id).state == "to_review"
    told = scan_reviews_of_vehicle(session, made.vehicle_id)
    assert [review.verdict for review in told] == ["rejected", "reopened"]


def test_other_values_of_the_rig_leave_results_and_mark_them(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one)
    assert get_scan(session, made.scan_id).counts.older == 0
    changed = update_scan(session, made.scan_id, {"baseline_m": 0.594}, version=1, actor=one.olga.id)
    assert (changed.counts.older, changed.counts.vehicles, changed.version) == (1, 1, 2)
    assert get_scan_measurement(session, made.id).values.rig["baseline_m"] == 0.593
    with pytest.raises(Conflict, match="Olga changed Gate"):
        update_scan(session, made.scan_id, {"name": "Door"}, version=1, actor=one.rene.id)
    with pytest.raises(BadInput, match="baseline of 0 m"):
        update_scan(session, made.scan_id, {"baseline_m": 0.0}, version=2, actor=one.rene.id)


def test_another_line_rate_leaves_the_gaps_of_those_measured_before_it(session: Session) -> None:
    """They followed the rate of now: a time gap of 2 s beside speeds, times of day and heights of then."""
    one = samples.sample(session)
    scan_id, actor = scans_samples.ready(session, one).id, one.olga.id
    rig, now = values().rig, {**values().rig, "line_rate_hz": 2441.4}
    for number, with_rig in enumerate((rig, rig, now, now)):
        made = create_scan_vehicle(session, scan_id, origin="found", actor=actor)
        ends = {"front_line_1": 9765.6 * number, "rear_line_1": 9765.6 * number + 4882.8}
        append_scan_measurement(session, made.id, values(rig=with_rig, **ends), actor=actor)
    update_scan(
        session, scan_id, {"line_rate_hz": 2441.4}, version=get_scan(session, scan_id).version, actor=actor
    )
    gaps = [one.gap for one in vehicles_of(session, scan_id)]
    assert [gap and gap.time_gap_s for gap in gaps] == [None, pytest.approx(1.0), None, pytest.approx(2.0)]
    assert gaps[2] is not None and gaps[2].reason == OTHER_RATE


def test_a_scan_stays_once_people_worked_on_it(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one)
    change_scan_vehicle(session, made.vehicle_id, {"make": "Fiat"}, version=2, actor=one.olga.id)
    with pytest.raises(Conflict, match="cannot be deleted"):
        remove_scan(session, made.scan_id, actor=one.olga.id)
    untouched = scans_samples.measured(session, one)
    remove_scan(session, untouched.scan_id, actor=one.olga.id)
    with pytest.raises(NotFound):
        get_scan_vehicle(session, untouched.vehicle_id)
    with pytest.raises(NotFound):
        append_scan_measurement(session, untouched.vehicle_id, values(), actor=one.olga.id)
    assert not list_scan_vehicles(session, untouched.scan_id) and list_scan_vehicles(session, made.scan_id)


def test_who_stood_until_the_last_ones_came_is_beside_them(session: Session) -> None:
    """By the last three alone, the last one's gap was from the rear of the one before it."""
    one = samples.sample(session)
    scan_id, actor = scans_samples.ready(session, one).id, one.olga.id
    spans = [(1000.0, 9000.0), *((2000.0 + 1000.0 * n, 2300.0 + 1000.0 * n) for n in range(6))]
    made = create_scan_vehicles(session, scan_id, 7, origin="found", actor=actor)
    for vehicle_id, span in zip(made, spans, strict=True):
        seen = values(front_line_1=span[0], rear_line_1=span[1])
        append_scan_measurement(session, vehicle_id, seen, actor=actor)
    # one more than are shown, for the first one's headway
    last = last_scan_vehicles(session, scan_id, 4)
    assert [vehicle.number for vehicle in last] == [1, 4, 5, 6, 7]
    every = list_scan_vehicles(session, scan_id)
    told = [
        [one.gap for one in shown_vehicles(get_scan(session, scan_id), found, {})] for found in (last, every)
    ]
    assert told[0][-3:] == told[1][-3:]


def test_where_nobody_stood_the_last_ones_are_read_once(session: Session) -> None:
    one = samples.sample(session)
    scan_id, actor = scans_samples.ready(session, one).id, one.olga.id
    for number, vehicle_id in enumerate(
        create_scan_vehicles(session, scan_id, 4, origin="found", actor=actor)
    ):
        seen = values(front_line_1=1000.0 * number, rear_line_1=1000.0 * number + 300.0)
        append_scan_measurement(session, vehicle_id, seen, actor=actor)
    read: list[str] = []

    def note(*told: Any) -> None:
        read.append(told[2])

    event.listen(session.get_bind(), "before_cursor_execute", note)
    last = last_scan_vehicles(session, scan_id, 2)
    event.remove(session.get_bind(), "before_cursor_execute", note)
    assert [vehicle.number for vehicle in last] == [3, 4]
    assert sum("scan_reviews" in statement for statement in read) == 1


def test_who_passed_beside_one_that_stands_is_not_taken_for_it(session: Session) -> None:
    """Found anew, who stood took the place of who passed, whose motion was lost."""
    one = samples.sample(session)
    passed = scans_samples.measured(session, one)
    stood = Motion("direct", Crossings(100.0, 60_000.0, 110.0, 60_010.0), "not_measurable", STOOD)
    found = Search((stood, motion_of(values())))
    known = list_scan_vehicles(session, passed.scan_id)
    readers = cast(Readers, None)
    plans, _ = plan(lambda *_: None, found, known, frozenset(), scans_samples.RIG, "direct", readers)
    assert [made.vehicle and made.vehicle.id for made in plans] == [None, passed.vehicle_id]


def test_many_at_once_are_the_same_as_one_by_one(session: Session) -> None:
    one = samples.sample(session)
    known = scans_samples.measured(session, one)
    scan_id, actor = known.scan_id, one.olga.id
    head = trail.head(session).count
    made = create_scan_vehicles(session, scan_id, 600, origin="found", actor=actor)
    fronts = [1000.0 + number for number in range(len(made))]
    found = [(vehicle_id, values(front_line_1=front)) for vehicle_id, front in zip(made, fronts, strict=True)]
    again = (known.vehicle_id, values(cause="again", speed_mps=20.0))
    append_scan_measurements(session, scan_id, [again, *found], actor=actor)
    vehicles = {vehicle.id: vehicle for vehicle in list_scan_vehicles(session, scan_id)}
    assert [vehicles[vehicle_id].number for vehicle_id in made] == list(range(2, 602))
    first_lines = [one.measurement.values.front_line_1 for one in map(vehicles.get, made) if one.measurement]
    assert first_lines == fronts and {vehicles[one].version for one in made} == {2}
    revised = vehicles[known.vehicle_id]
    assert (revised.version, revised.measurement.revision) == (3, 2)
    alone = create_scan_vehicle(session, scan_id, origin="found", actor=actor)
    append_scan_measurement(session, alone.id, values(), actor=actor)
    events = events_of(session)[head:][::-1]
    assert len(events) == 2 * 600 + 1 + 2 and verify_records(session).ok
    of_last, of_many = [e for e in events if e.entity == "scan_measurement" and e.action == "create"][:2]
    assert of_last.after.keys() == of_many.after.keys()
    told = next(e for e in events if e.action == "revise")
    assert (told.before["speed_mps"], told.after["speed_mps"]) == (19.31415, 20.0)
