"""Thousands of heights stored at once are those stored one by one: values, checks, and an event each."""

from dataclasses import replace
from uuid import uuid4

import pytest

from sightline.enums import Point
from sightline.errors import Conflict, NotFound
from sightline.infra.audit import trail
from sightline.infra.audit.verification import verify_records
from sightline.infra.services import Services
from sightline.measurements.bulk_service import NewHeight, store_measurements
from sightline.measurements.records import ClickedFrame, Clicks
from sightline.measurements.service import store_measurement
from sightline.measurements.store import get_measurement
from sightline.vehicles.store import get_vehicle
from tests.support.app import Client
from tests.support.ground import Ground, add_vehicle, pixel


def at(x_m: float, y_m: float, z_m: float) -> Point:
    across, down = pixel(x_m, y_m, z_m)
    return across, down


FOOT = at(0.2, 0.0, 0.0)
AGAIN = ClickedFrame(frame=5, contact=at(0.4, 0.1, 0.0), target_point=at(0.7, 0.3, 0.8))
CLICKS = (
    Clicks(target="roof", frame=2, contact=FOOT, target_point=at(0.6, 0.0, 1.2)),
    Clicks(target="driver_eye", frame=3, contact=FOOT, target_point=at(0.6, 0.4, 1.1)),
    Clicks(target="other", frame=3, contact=(160.0, 3.0), target_point=(160.0, 2.0)),
    Clicks(
        target="taillight",
        frame=1,
        contact=at(-0.5, 0.1, 0.0),
        target_point=at(-0.2, 0.3, 0.8),
        more_frames=(AGAIN,),
    ),
)


def fresh(vehicle_id: int, *clicks: Clicks) -> list[NewHeight]:
    return [NewHeight(vehicle_id=vehicle_id, client_key=str(uuid4()), clicks=one) for one in clicks]


def test_they_are_those_that_are_stored_one_by_one(
    operator: Client, ground: Ground, services: Services
) -> None:
    one, other = (add_vehicle(operator, ground.recording_id)["id"] for _ in range(2))
    actor = operator.seen("/session")["person"]["id"]
    with services.writing() as session:
        alone = [store_measurement(session, one, str(uuid4()), clicks, actor=actor) for clicks in CLICKS]
        before = trail.head(session, ground.survey_id)
        ids = store_measurements(session, ground.survey_id, fresh(other, *CLICKS), actor=actor)
        after = trail.head(session, ground.survey_id)
    assert after.count - before.count == len(CLICKS), "an event each"
    with services.reading() as session:
        together = [get_measurement(session, id_) for id_ in ids]
        assert verify_records(session).ok
    assert {made.values.status for made in alone} == {"ok", "not_measurable"}
    assert any(made.values.solved_inset_m is not None for made in alone)
    for first, second in zip(alone, together, strict=True):
        same = replace(second, id=first.id, revision_id=first.revision_id, created_at=first.created_at)
        assert replace(same, vehicle_id=first.vehicle_id) == first


def test_what_was_not_visible_is_seen_once_it_is_measured(
    operator: Client, ground: Ground, services: Services
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, roof_not_visible="glare")["id"]
    actor = operator.seen("/session")["person"]["id"]
    with services.writing() as session:
        store_measurements(session, ground.survey_id, fresh(vehicle, CLICKS[0]), actor=actor)
    with services.reading() as session:
        assert get_vehicle(session, vehicle).roof_not_visible is None


def test_what_cannot_be_stored_stores_nothing(operator: Client, ground: Ground, services: Services) -> None:
    vehicle = add_vehicle(operator, ground.recording_id)["id"]
    actor = operator.seen("/session")["person"]["id"]

    def store(*heights: NewHeight) -> None:
        with services.writing() as session:
            store_measurements(session, ground.survey_id, heights, actor=actor)

    with pytest.raises(NotFound, match="no frame 999"):
        store(*fresh(vehicle, CLICKS[1], replace(CLICKS[0], frame=999)))
    with pytest.raises(NotFound, match="no vehicle 777"):
        store(*fresh(777, CLICKS[0]))
    with pytest.raises(ValueError, match="two heights"):
        store(*fresh(vehicle, CLICKS[0], CLICKS[0]))
    (kept,) = fresh(vehicle, CLICKS[0])
    store(kept)
    with pytest.raises(Conflict, match="already"):
        store(*fresh(vehicle, CLICKS[0]))
    with pytest.raises(Conflict):
        store(replace(kept, clicks=CLICKS[1]))
    with services.reading() as session:
        assert trail.head(session, ground.survey_id).count > 0 and verify_records(session).ok
