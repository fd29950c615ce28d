"""The columns for statistics say of every measurement what its record says."""

from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pytest

from sightline.cameras.store import create_camera
from sightline.errors import Damaged
from sightline.infra.database.engine import (
    SessionFactory,
    reading,
    writing,
)
from sightline.measurements.sheets.query import list_sheets
from sightline.measurements.store import (
    add_measurement,
    list_measurements,
    revise_measurement,
    withdraw_measurement,
)
from sightline.recordings.store import update_recording
from sightline.results import measured_columns_query
from sightline.results.measured_columns_query import (
    CATEGORIES,
    LIGHTING,
    TARGETS,
    VERDICTS,
    load_measured_columns,
)
from sightline.reviews.store import add_review
from sightline.surveys.store import create_survey
from sightline.vehicles.store import create_vehicle, remove_vehicle, update_vehicle
from tests.support import samples

pytestmark = pytest.mark.dialect


@pytest.mark.parametrize("at_once", [measured_columns_query._AT_ONCE, 7])
def test_columns_are_the_records(
    factory: SessionFactory, monkeypatch: pytest.MonkeyPatch, at_once: int
) -> None:
    """In one piece as well as in several."""
    monkeypatch.setattr(measured_columns_query, "_AT_ONCE", at_once)
    one = samples.fill(factory, 30)
    with writing(factory) as session:
        other = create_survey(session, name="Other", actor=None)
        changes = {"category": "suv", "lighting": "low_light", "manufacturer_height_m": 1.624}
        update_vehicle(session, 3, changes, version=1, actor=None)  # type: ignore[arg-type]
        update_recording(session, one.recording.id, {"lighting": "daytime"}, actor=None)
        first, second, third, fourth = list_measurements(session, one.survey.id)[3:7]
        withdraw_measurement(session, first.id, seen_revision=first.revision, actor=None)
        nothing = samples.values(one, height_m=None, status="not_measurable", reason="Sky.")
        revise_measurement(session, second, nothing, actor=None)
        content = samples.values(one, target=third.values.target, height_m=1.5)
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
        records = [m for m in list_measurements(session, one.survey.id) if m.values.height_m is not None]
        cars = {vehicle.id: vehicle for vehicle in list_sheets(session, one.survey.id)}
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
        assert (
            TARGETS[found.target[row]] == m.values.target and VERDICTS[found.verdict[row]] == m.review.verdict
        )
        assert LIGHTING[found.lighting[row]] == (vehicle.lighting or "daytime")
        assert (
            (found.category[row] == -1)
            if vehicle.category is None
            else (CATEGORIES[found.category[row]] == vehicle.category)
        )
        lengths = (found.height_m[row], found.uncorrected_height_m[row])
        given = (m.values.height_m, m.values.uncorrected_height_m)
        assert lengths == tuple(float(f"{one:.6f}") for one in given)  # as a package writes them
        of_roof = vehicle.manufacturer_height_m if m.values.target == "roof" else None
        assert np.isnan(found.known_m[row]) == (of_roof is None)
        assert today - 1 <= found.day[row] <= today
    assert "accepted" in {VERDICTS[v] for v in found.verdict}
    chosen = found.where(found.target == TARGETS.index("roof"))
    assert 0 < len(chosen) < len(found)


def test_columns_are_of_the_sessions_state(factory: SessionFactory) -> None:
    """What was committed before is seen, what another session commits meanwhile is not; what the session
    itself wrote is, before it commits.
    """
    one = samples.fill(factory, 30)
    with reading(factory) as session:
        before = load_measured_columns(session, [one.survey.id])
        chosen = list_measurements(session, one.survey.id)[0]
    with reading(factory) as session:
        list_measurements(session, one.survey.id)
        with writing(factory) as other:
            withdraw_measurement(other, chosen.id, seen_revision=chosen.revision, actor=None)
        assert list(load_measured_columns(session).measurement_id) == list(before.measurement_id)
    with reading(factory) as session:
        after = load_measured_columns(session)
    assert len(after) == len(before) - 1 and chosen.id not in after.measurement_id
    with writing(factory) as session:
        remove_vehicle(session, int(after.vehicle_id[0]), actor=None)
        assert after.vehicle_id[0] not in load_measured_columns(session).vehicle_id


@pytest.mark.once
def test_an_unknown_word_is_refused() -> None:
    with pytest.raises(Damaged, match="“wing”"):
        measured_columns_query._codes("target", ["roof", None, "wing"], TARGETS)
    assert list(measured_columns_query._codes("target", ["roof", None], TARGETS)) == [0, -1]


def test_a_small_survey_among_others_is_the_same(factory: SessionFactory) -> None:
    with writing(factory) as session:
        one = samples.sample(session)
        for key in range(1, 10):
            place = {"first_frame": 10, "last_frame": 40}
            car = create_vehicle(session, one.recording.id, place, actor=None)
            samples.measure(session, replace(one, vehicle=car), key=key)
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
