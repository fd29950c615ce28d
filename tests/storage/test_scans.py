"""Rules of scanned vehicles: append-only, somebody else reviews, a scan on which people worked stays."""

from dataclasses import replace

import pytest
from sqlalchemy.orm import Session

from backend.errors import BadInput, Conflict, NotAllowed, NotFound
from backend.storage import audit, scans, scans_measurements, scans_reviews, scans_vehicles
from tests.storage import samples, scans_samples
from tests.storage.scans_samples import values


def test_a_measurement_comes_back_to_the_bit(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one)
    assert made.values == values()
    vehicle = scans_vehicles.get(session, made.vehicle_id)
    assert vehicle.measurement == made and vehicle.state == "to_review"
    listed = scans_vehicles.list_for_scan(session, made.scan_id)[0].measurement
    assert listed is not None and listed.values == replace(values(), profile=None)


def test_a_revision_stands_beside_the_one_before_and_waits_for_a_review(session: Session) -> None:
    one = samples.sample(session)
    first = scans_samples.measured(session, one)
    scans_reviews.add(session, first.id, verdict="accepted", actor=one.rene.id)
    assert scans_vehicles.get(session, first.vehicle_id).state == "accepted"
    moved = values(cause="boundaries", placed_by=one.olga.id, front_line_1=1001.0)
    again = scans_measurements.append(session, first.vehicle_id, moved, version=2, actor=one.olga.id)
    assert [m.revision for m in scans_measurements.history(session, first.vehicle_id)] == [1, 2]
    vehicle = scans_vehicles.get(session, first.vehicle_id)
    assert (vehicle.state, vehicle.version, vehicle.measurement) == ("to_review", 3, again)
    with pytest.raises(Conflict, match="measured again meanwhile"):
        scans_reviews.add(session, first.id, verdict="rejected", reason="Shadow.", actor=one.rene.id)
    with pytest.raises(Conflict, match="Olga changed vehicle 1"):
        scans_measurements.append(session, first.vehicle_id, moved, version=2, actor=one.rene.id)


def test_nobody_reviews_boundaries_of_their_own(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one, cause="boundaries", placed_by=one.olga.id)
    with pytest.raises(NotAllowed, match="placed themselves"):
        scans_reviews.add(session, made.id, verdict="accepted", actor=one.olga.id)
    with pytest.raises(BadInput, match="needs a reason"):
        scans_reviews.add(session, made.id, verdict="rejected", reason=" ", actor=one.rene.id)
    judged = scans_reviews.add(session, made.id, verdict="rejected", reason="A shadow.", actor=one.rene.id)
    assert (judged.review.verdict, judged.review.reason) == ("rejected", "A shadow.")
    scans_reviews.add(session, made.id, verdict="reopened", actor=one.rene.id)
    assert scans_vehicles.get(session, made.vehicle_id).state == "to_review"
    told = scans_reviews.of_vehicle(session, made.vehicle_id)
    assert [review.verdict for review in told] == ["rejected", "reopened"]


def test_other_values_of_the_rig_leave_results_and_mark_them(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one)
    assert scans.get(session, made.scan_id).counts.older == 0
    changed = scans.update(session, made.scan_id, {"baseline_m": 0.594}, version=1, actor=one.olga.id)
    assert (changed.counts.older, changed.counts.vehicles, changed.version) == (1, 1, 2)
    assert scans_measurements.get(session, made.id).values.rig["baseline_m"] == 0.593
    with pytest.raises(Conflict, match="Olga changed Gate"):
        scans.update(session, made.scan_id, {"name": "Door"}, version=1, actor=one.rene.id)
    with pytest.raises(BadInput, match="baseline of 0 m"):
        scans.update(session, made.scan_id, {"baseline_m": 0.0}, version=2, actor=one.rene.id)


def test_a_scan_stays_once_people_worked_on_it(session: Session) -> None:
    one = samples.sample(session)
    made = scans_samples.measured(session, one)
    scans_vehicles.change_facts(session, made.vehicle_id, {"make": "Fiat"}, version=2, actor=one.olga.id)
    with pytest.raises(Conflict, match="so it stays"):
        scans.remove(session, made.scan_id, actor=one.olga.id)
    untouched = scans_samples.measured(session, one)
    scans.remove(session, untouched.scan_id, actor=one.olga.id)
    with pytest.raises(NotFound):
        scans_vehicles.get(session, untouched.vehicle_id)
    with pytest.raises(NotFound):
        scans_measurements.append(session, untouched.vehicle_id, values(), actor=one.olga.id)
    assert {v.scan_id for v in scans_vehicles.list_for_survey(session, one.survey.id)} == {made.scan_id}


def test_many_at_once_are_the_same_as_one_by_one(session: Session) -> None:
    one = samples.sample(session)
    known = scans_samples.measured(session, one)
    scan_id, actor = known.scan_id, one.olga.id
    head = audit.head(session).count
    made = scans_vehicles.create_many(session, scan_id, 600, origin="found", actor=actor)
    fronts = [1000.0 + number for number in range(len(made))]
    found = [(vehicle_id, values(front_line_1=front)) for vehicle_id, front in zip(made, fronts, strict=True)]
    again = (known.vehicle_id, values(cause="again", speed_mps=20.0))
    scans_measurements.append_many(session, scan_id, [again, *found], actor=actor)
    vehicles = {vehicle.id: vehicle for vehicle in scans_vehicles.list_for_scan(session, scan_id)}
    assert [vehicles[vehicle_id].number for vehicle_id in made] == list(range(2, 602))
    first_lines = [one.measurement.values.front_line_1 for one in map(vehicles.get, made) if one.measurement]
    assert first_lines == fronts and {vehicles[one].version for one in made} == {2}
    revised = vehicles[known.vehicle_id]
    assert (revised.version, revised.measurement.revision) == (3, 2)
    alone = scans_vehicles.create(session, scan_id, origin="found", actor=actor)
    scans_measurements.append(session, alone.id, values(), actor=actor)
    events = audit.for_export(session)[head:][::-1]
    assert len(events) == 2 * 600 + 1 + 2 and audit.verify(session).ok
    of_last, of_many = [e for e in events if e.entity == "scan_measurement" and e.action == "create"][:2]
    assert of_last.after.keys() == of_many.after.keys()
    told = next(e for e in events if e.action == "revise")
    assert (told.before["speed_mps"], told.after["speed_mps"]) == (19.31415, 20.0)
