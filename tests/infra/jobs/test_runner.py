"""One job in this process: every way to end, each with its event, none half there."""

import threading
import time
from collections.abc import Callable
from datetime import timedelta
from pathlib import Path

import pytest
from sqlalchemy import update

from sightline.errors import Conflict
from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.infra.database.types import now
from sightline.infra.jobs import registry
from sightline.infra.jobs.queue import attach, open_queue
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.runner import Runner, sweep
from sightline.infra.jobs.store import (
    LeaseLost,
    claim_job,
    fail_job,
    finish_job,
    get_job,
    renew_lease,
    request_job_cancel,
)
from sightline.infra.jobs.tables import jobs as job_rows
from sightline.settings import Settings
from sightline.surveys.store import create_survey, list_surveys
from tests.infra.jobs import handlers

pytestmark = pytest.mark.dialect

assert handlers.make_survey


@pytest.fixture
def settings(tmp_path: Path, database_url: str) -> Settings:
    """A short lease, so that tests need not wait long."""
    return Settings(data_dir=tmp_path, database_url=database_url, lease_s=0.8)


@pytest.fixture
def runner(settings: Settings, factory: SessionFactory) -> Runner:
    return Runner(settings, factory)


def queued(factory: SessionFactory, kind: str, **payload: object) -> Job:
    with writing(factory) as session:
        return registry.enqueue(session, kind, payload, survey_id=None, actor=None)


def job_now(factory: SessionFactory, job: Job) -> Job:
    with reading(factory) as session:
        return get_job(session, job.id)


def survey_names(factory: SessionFactory) -> list[str]:
    with reading(factory) as session:
        assert verify_records(session).ok
        return [one.name for one in list_surveys(session)]


def until(true: Callable[[], bool], seconds: float = 10) -> None:
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end, "it did not happen in time"
        time.sleep(0.02)


def test_a_job_is_done_with_its_result(runner: Runner, factory: SessionFactory, tmp_path: Path) -> None:
    job = queued(factory, "test_make_survey", folder=str(tmp_path), first_s=0, name="made")
    assert (job.state, job.attempts) == ("queued", 0)
    runner.run(job.id)
    done = job_now(factory, job)
    assert (done.state, done.attempts, done.progress, done.error) == ("done", 1, 1.0, None)
    assert survey_names(factory) == ["made"] and done.result == {"survey_id": 1}
    assert done.started_at is not None and done.finished_at is not None and done.lease_until is None
    runner.run(job.id)  # carried twice by the queue
    assert survey_names(factory) == ["made"]


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ("input", "The video has no picture; upload another."),
        ("program", "An error in the program stopped this (ZeroDivisionError)"),
        ("in_finish", "The result cannot be stored; try again."),
    ],
)
def test_a_failed_job_says_why_and_leaves_nothing_half_there(
    runner: Runner, factory: SessionFactory, how: str, words: str
) -> None:
    job = queued(factory, "test_fail", how=how)
    runner.run(job.id)
    failed = job_now(factory, job)
    assert failed.state == "failed" and failed.error is not None and failed.error.startswith(words)
    assert survey_names(factory) == [f"test_fail: {failed.error}"]


def test_an_unknown_kind_fails_with_a_sentence(runner: Runner, factory: SessionFactory) -> None:
    job = queued(factory, "test_nobody")
    runner.run(job.id)
    assert job_now(factory, job).error == (
        "This worker knows no job of kind test_nobody; start one of this version."
    )


def test_a_queued_job_is_cancelled_at_once(runner: Runner, factory: SessionFactory) -> None:
    job = queued(factory, "test_wait")
    with writing(factory) as session:
        assert request_job_cancel(session, job.id, actor=None).state == "cancelled"
    runner.run(job.id)
    assert job_now(factory, job).attempts == 0
    with pytest.raises(Conflict, match="nothing to cancel"), writing(factory) as session:
        request_job_cancel(session, job.id, actor=None)


def test_a_running_job_reports_and_is_cancelled(runner: Runner, factory: SessionFactory) -> None:
    job = queued(factory, "test_wait")
    thread = threading.Thread(target=runner.run, args=(job.id,))
    thread.start()
    until(lambda: job_now(factory, job).progress == 0.25)
    running = job_now(factory, job)
    assert (running.state, running.message) == ("running", "Waiting.")
    first_lease = running.lease_until
    until(lambda: job_now(factory, job).lease_until != first_lease)
    with writing(factory) as session:
        assert request_job_cancel(session, job.id, actor=None).cancel_requested
    thread.join(10)
    assert job_now(factory, job).state == "cancelled"
    assert survey_names(factory) == ["test_wait: Cancelled."]


def expire(factory: SessionFactory, job: Job) -> None:
    with writing(factory) as session:
        past = now() - timedelta(seconds=60)
        session.execute(update(job_rows).where(job_rows.c.id == job.id).values(lease_until=past))


def test_a_worker_that_comes_back_from_the_dead_changes_nothing(
    settings: Settings, factory: SessionFactory, tmp_path: Path
) -> None:
    job = queued(factory, "test_make_survey", folder=str(tmp_path), first_s=0, name="once")
    with writing(factory) as session:
        old = claim_job(session, job.id, worker="old", lease_s=5)
    assert old is not None
    expire(factory, job)
    queue = open_queue(settings)
    sweep(factory, queue)
    again = job_now(factory, job)
    assert (again.state, again.attempts) == ("queued", 1) and queue.waiting() >= 1
    Runner(settings, factory).run(job.id)
    with writing(factory) as session:
        assert not renew_lease(session, old, lease_s=5).held
    for end in (lambda s: finish_job(s, old, {}), lambda s: fail_job(s, old, "x")):
        with pytest.raises(LeaseLost), writing(factory) as session:
            create_survey(session, name="ghost", actor=None)
            end(session)
    assert survey_names(factory) == ["once"]
    assert job_now(factory, job).attempts == 2


def test_three_deaths_are_enough(settings: Settings, factory: SessionFactory) -> None:
    job, queue = queued(factory, "test_fail", how="input"), open_queue(settings)
    for attempt in (1, 2, 3):
        with writing(factory) as session:
            claimed = claim_job(session, job.id, worker=f"w{attempt}", lease_s=5)
        assert claimed is not None and claimed.attempts == attempt
        expire(factory, job)
        sweep(factory, queue)
    ended = job_now(factory, job)
    assert ended.state == "failed" and ended.error is not None and "3 times" in ended.error
    assert survey_names(factory) == [f"test_fail: {ended.error}"]


def test_an_expired_job_that_was_to_stop_is_cancelled(settings: Settings, factory: SessionFactory) -> None:
    job = queued(factory, "test_wait")
    with writing(factory) as session:
        claim_job(session, job.id, worker="w", lease_s=5)
        request_job_cancel(session, job.id, actor=None)
    expire(factory, job)
    sweep(factory, open_queue(settings))
    assert job_now(factory, job).state == "cancelled"


def test_only_a_committed_job_is_pushed(settings: Settings, factory: SessionFactory) -> None:
    queue = open_queue(settings)
    attach(factory, queue)
    with pytest.raises(ZeroDivisionError), writing(factory) as session:
        registry.enqueue(session, "test_wait", {}, survey_id=None, actor=None)
        raise ZeroDivisionError
    assert queue.waiting() == 0
    queued(factory, "test_wait")
    assert queue.waiting() == 1
    queue.huey.storage.flush_queue()
    sweep(factory, queue)  # a queue that lost its content is filled again
    assert queue.waiting() == 1
    sweep(factory, queue)
    assert queue.waiting() == 1


def test_two_claims_of_one_job_give_it_to_one(factory: SessionFactory) -> None:
    job = queued(factory, "test_wait")
    got: list[Job | None] = []

    def claim(name: str) -> None:
        with writing(factory) as session:
            got.append(claim_job(session, job.id, worker=name, lease_s=5))

    threads = [threading.Thread(target=claim, args=(f"w{n}",)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sum(one is not None for one in got) == 1 and len(got) == 4
