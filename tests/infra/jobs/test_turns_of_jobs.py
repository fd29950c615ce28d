"""Which waiting job a free process gets: the short ones first, and one place that long ones never take."""

import socket
from collections.abc import Iterator

import pytest
from sqlalchemy import text

from sightline import job_handlers
from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.infra.jobs import registry
from sightline.infra.jobs.one_machine import OneMachine
from sightline.infra.jobs.process import WorkerProcess
from sightline.infra.jobs.store import claim_job
from tests.infra.jobs import handlers

LONG, SHORT = "test_long", "test_make_survey"


def queue(factory: SessionFactory, *kinds: str) -> list[int]:
    assert handlers
    with writing(factory) as session:
        return [registry.enqueue(session, kind, {}, survey_id=None, actor=None).id for kind in kinds]


@pytest.fixture
def processes() -> Iterator[list[WorkerProcess]]:
    """Three idle ones, the last for short jobs alone."""
    pairs = [socket.socketpair() for _ in range(3)]
    made = [WorkerProcess(0, "nobody", ours, short_only=n == 2) for n, (ours, _) in enumerate(pairs)]
    for one in made:
        one.is_idle = True
    yield made
    for pair in pairs:
        for end in pair:
            end.close()


def test_short_jobs_first_and_a_place_of_their_own(
    factory: SessionFactory, processes: list[WorkerProcess]
) -> None:
    long, short, second, third = queue(factory, LONG, SHORT, SHORT, SHORT)
    OneMachine().hand_out(factory, processes)
    assert [one.job_id for one in processes] == [second, third, short]
    with writing(factory) as session:
        for job_id in (short, second):
            assert claim_job(session, job_id, worker="somebody")
    for done in (processes[0], processes[2]):
        done.job_id, done.is_idle = None, True
    OneMachine().hand_out(factory, processes)
    assert [one.job_id for one in processes] == [long, third, None]


def test_long_jobs_take_all_places_but_one(factory: SessionFactory, processes: list[WorkerProcess]) -> None:
    first, second, _third = queue(factory, LONG, LONG, LONG)
    OneMachine().hand_out(factory, processes)
    assert [one.job_id for one in processes] == [first, second, None]


@pytest.mark.dialect
def test_deliveries_on_postgres(factory: SessionFactory) -> None:
    queue(factory, LONG, SHORT)
    with reading(factory) as session:
        if session.get_bind().dialect.name != "postgresql":
            return  # nothing is delivered
        found = session.execute(text("SELECT queue_name, priority FROM procrastinate_jobs ORDER BY id")).all()
    assert [tuple(one) for one in found] == [("sightline-long", 0), ("sightline", 10)]


def test_what_goes_through_whole_videos_is_long() -> None:
    assert job_handlers.MODULES
    short = ("ingest", "pose", "scan_read", "tidy")
    long = ("passes", "proposals", "drift", "calibrate", "export", "scan_find")
    assert {kind for kind in (*short, *long) if registry.is_long(kind)} == set(long)
