"""The columns for statistics say of every measurement what its record says."""

from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pytest
from sqlalchemy import select, update

from sightline.cameras.store import create_camera
from sightline.infra.database import bulk_columns
from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.measurements.store import (
    add_measurement,
    list_measurements,
    revise_measurement,
    withdraw_measurement,
)
from sightline.recordings.store import update_recording
from sightline.results.measured_columns_query import (
    CATEGORIES,
    LIGHTING,
    TARGETS,
    VERDICTS,
    load_measured_columns,
)
from sightline.reviews.store import add_review
from sightline.surveys.store import create_survey
from sightline.vehicles.store import create_vehicle, list_vehicles, remove_vehicle, update_vehicle
from sightline.vehicles.tables import vehicles as vehicles_table
from tests.support import samples

pytestmark = pytest.mark.dialect


def test_columns_are_the_records(factory: SessionFactory) -> None:
    one = samples.fill(factory, 30)
    with writing(factory) as session:
        other = create_survey(session, name="Other", actor=None)
        changes = {"category": "suv", "lighting": "low_light", "manufacturer_height_m": 1.624}
        update_vehicle(session, 3, changes, version=1, actor=None)  # type: ignore[arg-type]
        update_recording(session, one.recording.id, {"lighting": "daytime"}, actor=None)
        first, second, third, fourth = list_measurements(session, one.survey.id)[3:7]
        withdraw_measurement(session, first.id, seen_revision=first.revision, actor=None)
        nothing = samples.values(one, height_m=None, status="not_measurable", reason="Sky.")
        revise_measurement(session, second.id, seen_revision=second.revision, values=nothing, actor=None)
        content = samples.values(one, target=third.target, height_m=1.5)
        vehicle_id, key = third.vehicle_id, samples.KEY.format(77)
        add_measurement(
            session, vehicle_id, client_key=key, values=content, repeat_of=third.id, actor=one.olga.id
        )
        remove_vehicle(session, 9, actor=None)
        for verdict, reason in (("rejected", "Blurred."), ("accepted", None)):
            add_review(
                session,
                fourth.id,
                seen_revision=fourth.revision,
                verdict=verdict,  # type: ignore[arg-type]
                reason=reason,
                actor=one.rene.id,
            )
    with reading(factory) as session:
        found = load_measured_columns(session, [one.survey.id], days=True)
        records = [m for m in list_measurements(session, one.survey.id) if m.height_m is not None]
        cars = {vehicle.id: vehicle for vehicle in list_vehicles(session, one.survey.id)}
        everything = load_measured_columns(session)
        assert not everything.day.any()  # not asked for
        assert len(load_measured_columns(session, [other.id])) == 0
    assert list(found.measurement_id) == [m.id for m in records]
    assert list(everything.measurement_id) == [m.id for m in records]
    assert first.id not in found.measurement_id and second.id not in found.measurement_id
    today = (datetime.now(UTC) - datetime(1970, 1, 1, tzinfo=UTC)).days
    for row, m in enumerate(records):
        vehicle = cars[m.vehicle_id]
        assert (found.vehicle_id[row], found.survey_id[row]) == (m.vehicle_id, m.survey_id)
        assert found.operator_id[row] == (m.created_by.id if m.created_by else -1)
        assert TARGETS[found.target[row]] == m.target and VERDICTS[found.verdict[row]] == m.review.verdict
        assert LIGHTING[found.lighting[row]] == (vehicle.lighting or "daytime")
        assert (
            (found.category[row] == -1)
            if vehicle.category is None
            else (CATEGORIES[found.category[row]] == vehicle.category)
        )
        lengths = (found.height_m[row], found.uncorrected_height_m[row])
        assert lengths == (m.height_m, m.uncorrected_height_m)
        assert np.isnan(found.manufacturer_height_m[row]) == (vehicle.manufacturer_height_m is None)
        assert today - 1 <= found.day[row] <= today
    assert "accepted" in {VERDICTS[v] for v in found.verdict}
    chosen = found.where(found.target == TARGETS.index("roof"))
    assert 0 < len(chosen) < len(found)


@pytest.mark.parametrize("far_m", [None, 63.999, 1e6])
def test_bulk_columns_lose_no_digit(
    factory: SessionFactory, monkeypatch: pytest.MonkeyPatch, far_m: float | None
) -> None:
    """Batches smaller than the table, NULL, and lengths that need the slow way."""
    monkeypatch.setattr(bulk_columns, "_AT_ONCE", 4)
    one = samples.fill(factory, 30)
    v = vehicles_table.c
    known = [0.0625, 1.0 / 3.0, 1.2345678901234567, -2.2, 0.1 + 0.2, np.nextafter(1.5, 2.0), far_m]
    with writing(factory) as session:
        for id_, value in enumerate(known, start=1):
            row = update(vehicles_table).where(v.id == id_)
            session.execute(row.values(manufacturer_height_m=None if value is None else float(value)))
    with reading(factory) as session:
        ids, heights = bulk_columns.columns(session, select(v.id, v.manufacturer_height_m), v.id)
        there = session.execute(select(v.id, v.manufacturer_height_m).order_by(v.id)).all()
        nothing = bulk_columns.columns(session, select(v.id, v.manufacturer_height_m).where(v.id < 0), v.id)
        narrowed = load_measured_columns(session, [one.survey.id])
    assert list(ids) == [row[0] for row in there] and len(ids) > 7
    assert np.array_equal(heights, np.array([row[1] for row in there], float), equal_nan=True)
    assert [(len(one), one.dtype.kind) for one in nothing] == [(0, "i"), (0, "f")]
    assert len(narrowed) > 8


def test_a_small_survey_among_others_is_the_same(factory: SessionFactory) -> None:
    """Where a survey holds little of all, the database joins; else everything is read and matched here."""
    with writing(factory) as session:
        one = samples.sample(session)
        for key in range(1, 10):
            samples.measure(session, one, key=key)
        survey = create_survey(session, name="Other", actor=None)
        camera = create_camera(session, survey.id, name="Right", actor=None)
        calibration = samples.calibration(session, camera.id, None)
        recording = samples.add_recording(session, survey.id, None)
        pose = samples.road_pose(session, recording.id, calibration.id, None)
        car = create_vehicle(session, recording.id, {"first_frame": 10, "last_frame": 40}, actor=None)
        other = replace(one, survey=survey, recording=recording, pose=pose, vehicle=car)
        samples.measure(session, other, key=9000)
    with reading(factory) as session:
        both = [load_measured_columns(session, [each.survey.id]) for each in (one, other)]
        everything = load_measured_columns(session)
    assert len(both[1]) == 1 and len(both[0]) + 1 == len(everything)
    assert set(both[1].survey_id) == {other.survey.id}
    at = everything.survey_id == other.survey.id
    assert list(everything.height_m[at]) == list(both[1].height_m)
