"""The columns for statistics say of every measurement what its record says."""

from datetime import UTC, datetime

import numpy as np

from backend.storage import database, measured_columns, measurements, recordings, reviews, surveys, vehicles
from backend.storage.measured_columns import CATEGORIES, LIGHTING, TARGETS, VERDICTS
from tests.storage import samples


def test_columns_are_the_records(factory: database.SessionFactory) -> None:
    one = samples.fill(factory, 30)
    with database.writing(factory) as session:
        other = surveys.create(session, name="Other", actor=None)
        changes = {"category": "suv", "lighting": "low_light", "manufacturer_height_m": 1.624}
        vehicles.update(session, 3, changes, version=1, actor=None)  # type: ignore[arg-type]
        recordings.update(session, one.recording.id, {"lighting": "daytime"}, actor=None)
        first, second, third, fourth = measurements.list_for_survey(session, one.survey.id)[3:7]
        measurements.withdraw(session, first.id, seen_revision=first.revision, actor=None)
        nothing = samples.values(one, height_m=None, status="not_measurable", reason="Sky.")
        measurements.revise(session, second.id, seen_revision=second.revision, values=nothing, actor=None)
        content = samples.values(one, target=third.target, height_m=1.5)
        vehicle_id, key = third.vehicle_id, samples.KEY.format(77)
        measurements.add(
            session, vehicle_id, client_key=key, values=content, repeat_of=third.id, actor=one.olga.id
        )
        vehicles.remove(session, 9, actor=None)
        for verdict, reason in (("rejected", "Blurred."), ("accepted", None)):
            reviews.add(
                session,
                fourth.id,
                seen_revision=fourth.revision,
                verdict=verdict,  # type: ignore[arg-type]
                reason=reason,
                actor=one.rene.id,
            )
    with database.reading(factory) as session:
        found = measured_columns.load(session, [one.survey.id])
        records = [m for m in measurements.list_for_survey(session, one.survey.id) if m.height_m is not None]
        cars = {vehicle.id: vehicle for vehicle in vehicles.list_for_survey(session, one.survey.id)}
        everything = measured_columns.load(session)
        assert len(measured_columns.load(session, [other.id])) == 0
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
