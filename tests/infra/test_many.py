"""A large survey: frames come back as they went in, lists take no query per row (times: `make bench`)."""

import numpy as np
import pytest
from sqlalchemy import event
from sqlalchemy.orm import Session

from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.measurements.sheets.query import list_sheets
from sightline.recordings.frames.store import get_frame_table
from sightline.recordings.store import note_ingested
from sightline.results.overview.query import survey_overview, survey_overviews
from sightline.reviews.store import review_queue
from sightline.surveys.store import create_survey
from tests.support import samples
from tests.support.samples import Sample

pytestmark = pytest.mark.dialect


def test_twenty_thousand_frames_come_back(factory: SessionFactory) -> None:
    table = samples.frame_table(20_000)
    with writing(factory) as session:
        one = samples.sample(session)
        note_ingested(session, one.recording.id, samples.facts(), table, actor=None)
    with reading(factory) as session:
        back = get_frame_table(session, one.recording.id)
    for name in ("pts", "time_s", "key", "crc32"):
        assert np.array_equal(getattr(back, name), getattr(table, name))
        assert getattr(back, name).dtype == getattr(table, name).dtype
        assert not getattr(back, name).flags.writeable


@pytest.fixture
def large(factory: SessionFactory) -> tuple[SessionFactory, Sample]:
    """500 vehicles with three measurements each, a third of them reviewed."""
    return factory, samples.fill(factory, 500)


def _statements(session: Session) -> list[str]:
    ran: list[str] = []
    connection = session.connection()
    event.listen(connection, "before_cursor_execute", lambda *given: ran.append(given[2]))
    return ran


def test_vehicles_list_in_three_queries(large: tuple[SessionFactory, Sample]) -> None:
    factory, one = large
    with reading(factory) as session:
        ran = _statements(session)
        found = list_sheets(session, one.survey.id)
        assert len(ran) == 3
        survey = survey_overview(session, one.survey.id)
        assert len(ran) == 3 + 9
        queue = review_queue(session, one.survey.id, actor=one.olga.id)
    assert len(found) == 500 and sum(len(vehicle.measurements) for vehicle in found) == 1498
    assert {vehicle.state for vehicle in found} == {"partial", "measured"}
    counts = survey.counts
    assert (counts.vehicles, counts.vehicles_measured, counts.measurements) == (500, 499, 1498)
    assert counts.to_review + counts.accepted == 1498 and counts.to_review == len(queue)


def test_many_surveys_take_as_many_queries_as_one(factory: SessionFactory) -> None:
    with writing(factory) as session:
        for n in range(40):
            create_survey(session, name=f"S{n}", actor=None)
    with reading(factory) as session:
        ran = _statements(session)
        assert len(survey_overviews(session)) == 40
        assert len(ran) == 9
