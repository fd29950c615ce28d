"""A large survey: frames come back as they went in, lists take no query per row (times: `make bench`)."""

import numpy as np
import pytest
from sqlalchemy import event
from sqlalchemy.orm import Session

from backend.storage import database, frames, recordings, reviews, surveys, vehicles
from tests.storage import samples
from tests.storage.samples import Sample


def test_twenty_thousand_frames_come_back(factory: database.SessionFactory) -> None:
    table = samples.frame_table(20_000)
    with database.writing(factory) as session:
        one = samples.sample(session)
        recordings.ingested(session, one.recording.id, samples.facts(), table, actor=None)
    with database.reading(factory) as session:
        back = frames.table(session, one.recording.id)
        part = frames.table(session, one.recording.id, first=19_990, count=50)
    for name in ("pts", "time_s", "key", "crc32"):
        assert np.array_equal(getattr(back, name), getattr(table, name))
        assert getattr(back, name).dtype == getattr(table, name).dtype
        assert not getattr(back, name).flags.writeable
    assert (part.first, len(part)) == (19_990, 10) and part.pts[0] == table.pts[19_990]


@pytest.fixture
def large(factory: database.SessionFactory) -> tuple[database.SessionFactory, Sample]:
    """500 vehicles with three measurements each, a third of them reviewed."""
    return factory, samples.fill(factory, 500)


def _statements(session: Session) -> list[str]:
    ran: list[str] = []
    connection = session.connection()
    event.listen(connection, "before_cursor_execute", lambda *given: ran.append(given[2]))
    return ran


def test_vehicles_list_in_three_queries(large: tuple[database.SessionFactory, Sample]) -> None:
    factory, one = large
    with database.reading(factory) as session:
        ran = _statements(session)
        found = vehicles.list_for_survey(session, one.survey.id)
        assert len(ran) == 3
        survey = surveys.get(session, one.survey.id)
        assert len(ran) == 3 + 9
        queue = reviews.queue(session, one.survey.id, actor=one.olga.id)
    assert len(found) == 500 and sum(len(vehicle.measurements) for vehicle in found) == 1498
    assert {vehicle.state for vehicle in found} == {"partial", "measured"}
    counts = survey.counts
    assert (counts.vehicles, counts.vehicles_measured, counts.measurements) == (500, 499, 1498)
    assert counts.to_review + counts.accepted == 1498 and counts.to_review == len(queue)


def test_many_surveys_take_as_many_queries_as_one(factory: database.SessionFactory) -> None:
    with database.writing(factory) as session:
        for n in range(40):
            surveys.create(session, name=f"S{n}", actor=None)
    with database.reading(factory) as session:
        ran = _statements(session)
        assert len(surveys.list_all(session)) == 40
        assert len(ran) == 9
