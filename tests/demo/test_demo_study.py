"""The demonstration study, cut to a few vehicles of one site: said to be simulated, true, made once."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from sightline.demo import invented
from sightline.demo.request import STUDY_KIND, ensure_requested, request_both
from sightline.infra.audit.verification import verify_records
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import list_jobs
from sightline.infra.services import Services
from sightline.measurements.store import list_measurements
from sightline.recordings.store import list_recordings
from sightline.studies.store import list_studies, newest_result
from sightline.vehicles.store import list_vehicles_of_recording
from tests.support.app import Client


@pytest.mark.once
def test_a_site_is_measured_reviewed_and_said_to_be_simulated(
    services: Services, admin: Client, work: Callable[[], list[Job]], monkeypatch: pytest.MonkeyPatch
) -> None:
    site = replace(invented.SITES[0], daytime=30, low_light=10)
    monkeypatch.setattr(invented, "SITES", (site,))
    monkeypatch.setattr(invented, "FLEET_CSV", "")  # so few vehicles lack some of its classes
    with monkeypatch.context() as broken:  # a first try comes as far as the study
        broken.delattr(invented, "result_of")
        with services.writing() as session:
            registry.enqueue(session, STUDY_KIND, {}, survey_id=None, actor=None)
        assert [job.state for job in work()] == ["failed"]
    with services.writing() as session:
        registry.enqueue(session, STUDY_KIND, {}, survey_id=None, actor=None)
    assert [job.error for job in work()] == [None]
    with services.reading() as session:
        (study,) = list_studies(session)
        computed = newest_result(session, study.id)
    assert computed is not None
    (survey,) = admin.seen("/surveys")
    assert survey["name"].startswith("Simulated study") and "not filmed" in survey["description"]
    with services.reading() as session:
        assert verify_records(session).ok
        found = list_measurements(session, survey["id"])
    by_target = {
        target: [one for one in found if one.values.target == target]
        for target in ("roof", "driver_eye", "taillight")
    }
    assert [len(rows) for rows in by_target.values()] == [40, 30, 10]
    assert {one.review.verdict for one in found} == {"accepted", "to_review"}
    statistics = admin.seen(f"/statistics?survey_id={survey['id']}")
    assert statistics["counted"]["measurements"] == len(found) - sum(
        one.review.verdict == "to_review" for one in found
    )
    # what was found lies about the truth as its uncertainty says
    with services.reading() as session:
        cars = [
            one
            for r in list_recordings(session, survey["id"])
            for one in list_vehicles_of_recording(session, r.id)
        ]
    heights = {one.id: one.manufacturer_height_m for one in cars}
    z = [
        (one.values.height_m - heights[one.vehicle_id]) / np.hypot(one.values.u_height_m, 0.012)
        for one in by_target["roof"]
    ]
    assert 0.5 < float(np.sqrt(np.mean(np.square(z)))) < 1.6
    with services.writing() as session:
        registry.enqueue(session, STUDY_KIND, {}, survey_id=None, actor=None)
    work()
    assert len(admin.seen("/surveys")) == 1
    with services.reading() as session:
        assert newest_result(session, study.id) == computed


def test_four_sites_have_650_vehicles() -> None:
    counts = [(one.daytime, one.low_light) for one in invented.SITES]
    assert np.sum(counts, axis=0).tolist() == [400, 250]
    assert all(sum(one.fleet.values()) == pytest.approx(1.0) for one in invented.SITES)


def test_the_study_is_asked_for_on_the_first_start_alone(services: Services) -> None:
    with services.writing() as session:
        ensure_requested(session)  # as tests do that want no study
        request_both(session)
        assert STUDY_KIND not in {job.kind for job in list_jobs(session, state="queued")}
