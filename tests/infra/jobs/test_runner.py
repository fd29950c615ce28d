"""One job in this process: every way to end, each with its event, none half there."""

import asyncio
import json
import threading
from collections.abc import Iterator
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from sqlalchemy import select, text, update
from sqlalchemy.orm import Session

from sightline.errors import Conflict, SightlineError
from sightline.infra.audit.tables import audit_events
from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import DatabaseAway, SessionFactory, reading, writing
from sightline.infra.database.types import now
from sightline.infra.jobs import postgres, recovery, registry
from sightline.infra.jobs import runner as runner_module
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.recovery import take_back
from sightline.infra.jobs.runner import Runner, Watch
from sightline.infra.jobs.store import (
    MAX_ATTEMPTS,
    JobLost,
    check_hold,
    claim_job,
    fail_job,
    finish_job,
    get_job,
    queued_jobs,
    request_job_cancel,
)
from sightline.infra.jobs.tables import jobs
from sightline.infra.services import Services, open_services
from sightline.messages.said import Said
from sightline.settings import Settings
from sightline.surveys.store import create_survey, list_surveys
from tests.infra.jobs import handlers
from tests.support.waiting import NEVER_S, until

pytestmark = pytest.mark.dialect

assert handlers.make_survey


@pytest.fixture
def services(tmp_path: Path, database_url: str) -> Iterator[Services]:
    opened = open_services(Settings(data_dir=tmp_path, database_url=database_url), decode_in_child=False)
    yield opened
    opened.close()


@pytest.fixture
def runner(services: Services) -> Runner:
    return Runner(services, "this process")


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


def test_a_job_is_done_with_its_result(runner: Runner, factory: SessionFactory, tmp_path: Path) -> None:
    job = queued(factory, "test_make_survey", folder=str(tmp_path), first_s=0, name="made")
    assert (job.state, job.attempts) == ("queued", 0)
    runner.run(job.id)
    done = job_now(factory, job)
    assert (done.state, done.attempts, done.progress, done.error) == ("done", 1, 1.0, None)
    assert survey_names(factory) == ["made"] and done.result == {"survey_id": 1}
    assert done.started_at is not None and done.finished_at is not None
    assert runner.run(job.id)  # delivered twice
    assert survey_names(factory) == ["made"]


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ("input", "The video has no picture; upload another."),
        ("program", "An error in Sightline stopped this (ZeroDivisionError)"),
        ("in_finish", "The result cannot be stored; try again."),
    ],
)
def test_a_failed_job_says_why_and_leaves_nothing_half_there(
    runner: Runner, factory: SessionFactory, how: str, words: str
) -> None:
    job = queued(factory, "test_fail", how=how)
    runner.run(job.id)
    failed = job_now(factory, job)
    assert failed.state == "failed" and failed.error is not None and str(failed.error).startswith(words)
    assert survey_names(factory) == [f"test_fail: {failed.error}"]


def test_an_unknown_kind_fails_with_a_sentence(runner: Runner, factory: SessionFactory) -> None:
    job = queued(factory, "test_nobody")
    runner.run(job.id)
    assert str(job_now(factory, job).error) == (
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
    assert (running.state, str(running.message)) == ("running", "Waiting.")
    with writing(factory) as session:
        assert request_job_cancel(session, job.id, actor=None).cancel_requested
    thread.join(NEVER_S)
    assert job_now(factory, job).state == "cancelled"
    assert survey_names(factory) == ["test_wait: Cancelled."]


def test_a_stopped_runner_leaves_the_job_to_whoever_stopped_it(
    runner: Runner, factory: SessionFactory
) -> None:
    job = queued(factory, "test_wait")
    sound: list[bool] = []
    thread = threading.Thread(target=lambda: sound.append(runner.run(job.id)))
    thread.start()
    until(lambda: job_now(factory, job).state == "running")
    runner.stop()
    thread.join(NEVER_S)
    assert sound == [False] and job_now(factory, job).state == "running"
    assert take_back(factory, worker=runner.name, counted=False) == 1
    waiting = job_now(factory, job)
    assert (waiting.state, waiting.attempts, waiting.worker) == ("queued", 0, None)
    assert survey_names(factory) == []


def test_a_worker_that_comes_back_from_the_dead_changes_nothing(
    runner: Runner, factory: SessionFactory, tmp_path: Path
) -> None:
    job = queued(factory, "test_make_survey", folder=str(tmp_path), first_s=0, name="once")
    with writing(factory) as session:
        old = claim_job(session, job.id, worker="old")
    assert old is not None
    assert take_back(factory, worker="old") == 1
    again = job_now(factory, job)
    assert (again.state, again.attempts) == ("queued", 1)
    assert runner.run(job.id)
    with reading(factory) as session:
        assert not check_hold(session, old).held
    for end in (
        lambda s: finish_job(s, old, {}),
        lambda s: fail_job(s, old, SightlineError("said", sentence="x")),
    ):
        with pytest.raises(JobLost), writing(factory) as session:
            create_survey(session, name="ghost", actor=None)
            end(session)
    assert survey_names(factory) == ["once"]
    assert job_now(factory, job).attempts == 2


def test_a_job_that_is_lost_in_the_middle_stops_without_a_trace(
    services: Services, runner: Runner, factory: SessionFactory, caplog: pytest.LogCaptureFixture
) -> None:
    job = queued(factory, "test_wait")
    sound: list[bool] = []
    thread = threading.Thread(target=lambda: sound.append(runner.run(job.id)))
    thread.start()
    until(lambda: job_now(factory, job).state == "running")
    take_back(factory, worker=runner.name)
    with writing(factory) as session:
        claim_job(session, job.id, worker="another")
    thread.join(NEVER_S)
    running = job_now(factory, job)
    assert sound == [False] and (running.state, running.worker) == ("running", "another")
    assert survey_names(factory) == []
    assert [record.levelname for record in caplog.records if record.exc_info] == []


def test_three_deaths_are_enough(factory: SessionFactory) -> None:
    job = queued(factory, "test_fail", how="input")
    for attempt in (1, 2, 3):
        with writing(factory) as session:
            claimed = claim_job(session, job.id, worker=f"w{attempt}")
        assert claimed is not None and claimed.attempts == attempt
        take_back(factory, worker=f"w{attempt}")
    ended = job_now(factory, job)
    assert ended.state == "failed" and ended.error is not None and "3 times" in str(ended.error)
    assert survey_names(factory) == [f"test_fail: {ended.error}"]


def test_a_dead_workers_job_that_was_to_stop_is_cancelled(factory: SessionFactory) -> None:
    job = queued(factory, "test_wait")
    with writing(factory) as session:
        claim_job(session, job.id, worker="w")
        request_job_cancel(session, job.id, actor=None)
    take_back(factory, worker="w")
    assert job_now(factory, job).state == "cancelled"
    assert survey_names(factory) == ["test_wait: Cancelled."]


def deliveries(factory: SessionFactory) -> list[int]:
    """The jobs that Procrastinate carries."""
    query = "SELECT (args ->> 'job_id')::int FROM procrastinate_jobs ORDER BY id"
    with reading(factory) as session:
        return list(session.execute(text(query)).scalars())


def test_only_a_committed_job_is_delivered(factory: SessionFactory) -> None:
    with pytest.raises(ZeroDivisionError), writing(factory) as session:
        if session.get_bind().dialect.name != "postgresql":
            pytest.skip("on one machine the table is the queue")
        registry.enqueue(session, "test_wait", {}, survey_id=None, actor=None)
        raise ZeroDivisionError
    assert deliveries(factory) == []
    job = queued(factory, "test_wait")
    assert deliveries(factory) == [job.id]
    with writing(factory) as session:
        session.execute(text("UPDATE procrastinate_jobs SET status = 'doing'"))
        claim_job(session, job.id, worker="w")
    take_back(factory, worker="w")
    assert deliveries(factory) == [job.id], "the dead worker's is gone, a new one is there"


def test_two_claims_of_one_job_give_it_to_one(factory: SessionFactory) -> None:
    job = queued(factory, "test_wait")
    got: list[Job | None] = []

    def claim(name: str) -> None:
        with writing(factory) as session:
            got.append(claim_job(session, job.id, worker=name))

    threads = [threading.Thread(target=claim, args=(f"w{n}",)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sum(one is not None for one in got) == 1 and len(got) == 4


def test_progress_that_found_the_database_busy_is_stored_with_the_next_look(
    services: Services, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    job = queued(services.sessions, "make_survey", name="A")
    with writing(services.sessions) as session:
        claimed = claim_job(session, job.id, worker="this process")
    assert claimed is not None
    busy, store = (
        [DatabaseAway("database-busy")],
        runner_module.note_progress,
    )

    def note(*given: Any) -> Any:
        if busy:
            raise busy.pop()
        return store(*given)

    monkeypatch.setattr(runner_module, "note_progress", note)
    monkeypatch.setattr(runner_module, "PROGRESS_S", 0.01)
    with Watch(services.sessions, claimed, threading.Event()) as watch:
        watch.report(0.5, Said("said", sentence="Half."))
        until(lambda: job_now(services.sessions, job).progress == 0.5)
    assert not busy
    assert [one for one in caplog.records if one.levelname == "WARNING"] == []


def test_who_cannot_store_the_progress_still_hears_that_the_job_is_cancelled(
    services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    job = queued(services.sessions, "test_make_survey")
    with writing(services.sessions) as session:
        claimed = claim_job(session, job.id, worker="w")
    assert claimed is not None
    store, defects = runner_module.note_progress, [RuntimeError("a defect")]

    def note(*given: Any) -> Any:
        if defects:
            raise defects.pop()
        return store(*given)

    monkeypatch.setattr(runner_module, "note_progress", note)
    monkeypatch.setattr(runner_module, "PROGRESS_S", 0.01)
    with Watch(services.sessions, claimed, threading.Event()) as watch:
        watch.report(0.5, None)
        with writing(services.sessions) as session:
            request_job_cancel(session, job.id, actor=None)
        until(watch.is_over)
    assert not defects


@pytest.mark.parametrize("what", ["storage", "database"])
def test_what_is_away_puts_a_job_back_for_later_and_uses_up_no_attempt(
    runner: Runner, factory: SessionFactory, what: str
) -> None:
    job = queued(factory, "test_away", what=what)
    pauses = list[timedelta]()
    for _ in range(MAX_ATTEMPTS + 5):
        with writing(factory) as session:  # its pause is over
            session.execute(update(jobs).values(not_before=None))
        begun = now()
        assert runner.run(job.id)  # the worker goes on with others
        waits = job_now(factory, job)
        assert (waits.state, waits.attempts, waits.worker) == ("queued", 0, None)
        assert waits.not_before is not None and waits.message == Said("job-tried-again")
        pauses.append(waits.not_before - begun)
        with reading(factory) as session:
            assert queued_jobs(session) == {}
    assert job_now(factory, job).outages == MAX_ATTEMPTS + 5
    seconds = [round(pause.total_seconds()) for pause in pauses]
    assert seconds == [5, 10, 20, 40, 80, 160, 300, 300]
    with reading(factory) as session:
        assert verify_records(session).ok


@pytest.mark.parametrize(("what", "state"), [("claim_job", "queued"), ("fail_job", "running")])
def test_a_job_that_can_be_neither_begun_nor_ended_ends_the_process_and_stays(
    runner: Runner, factory: SessionFactory, monkeypatch: pytest.MonkeyPatch, what: str, state: str
) -> None:
    job = queued(factory, "test_fail", how="input")

    def breaks(*_given: Any, **_named: Any) -> None:
        raise RuntimeError("a defect")

    with monkeypatch.context() as broken:
        broken.setattr(runner_module, what, breaks)
        assert not runner.run(job.id)
    assert job_now(factory, job).state == state
    take_back(factory, worker=runner.name)
    assert runner.run(job.id)
    assert job_now(factory, job).state == "failed"


def test_what_cannot_be_cleaned_up_after_keeps_no_other_job(runner: Runner, factory: SessionFactory) -> None:
    """A kind's own `failed` breaks, in the worker and where the jobs of dead ones are taken back."""
    bad, dead, good = [
        queued(factory, kind, how="input") for kind in ("test_unclean", "test_unclean", "test_fail")
    ]
    assert runner.run(bad.id)
    assert str(job_now(factory, bad).error) == "The video has no picture; upload another."
    with writing(factory) as session:
        change = {"state": "running", "worker": "w", "attempts": MAX_ATTEMPTS}
        session.execute(update(jobs).where(jobs.c.id.in_([dead.id, good.id])).values(change))
    assert take_back(factory, worker="w") == 2
    assert [job_now(factory, one).state for one in (dead, good)] == ["failed", "failed"]
    assert survey_names(factory) == [f"test_fail: {job_now(factory, good).error}"]


def test_a_job_that_cannot_be_put_back_keeps_no_other(
    factory: SessionFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    bad, good = [queued(factory, "test_fail", how="input") for _ in range(2)]
    with writing(factory) as session:
        for job in (bad, good):
            claim_job(session, job.id, worker="w")
    put_back = recovery.put_back

    def breaks(session: Session, job: Job, **how: bool) -> None:
        if job.id == bad.id:
            raise RuntimeError("a defect")
        put_back(session, job, **how)

    monkeypatch.setattr(recovery, "put_back", breaks)
    take_back(factory)
    assert [job_now(factory, job).state for job in (bad, good)] == ["running", "queued"]


@pytest.mark.once
def test_a_silent_worker_that_cannot_be_taken_back_keeps_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    taken, both = list[int](), [SimpleNamespace(id=1), SimpleNamespace(id=2)]

    async def stalled(**_given: object) -> list[SimpleNamespace]:
        return both

    def take_up(_sessions: object, delivery: SimpleNamespace) -> None:
        taken.append(delivery.id)
        if delivery.id == 1:
            raise RuntimeError("a defect")
        raise asyncio.CancelledError

    monkeypatch.setattr(postgres, "take_up_stalled", take_up)
    app: Any = SimpleNamespace(job_manager=SimpleNamespace(get_stalled_jobs=stalled))
    sessions: Any = None
    with pytest.raises(asyncio.CancelledError):
        asyncio.run(postgres._look_for_stalled(app, sessions, 0.5))
    assert taken == [1, 2]


def test_what_is_away_while_it_is_cleaned_up_ends_no_job(
    runner: Runner, factory: SessionFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    def away(*_given: Any) -> None:
        raise DatabaseAway("database-busy")

    job = queued(factory, "test_fail", how="input")
    with monkeypatch.context() as broken:
        broken.setitem(registry._handlers, job.kind, replace(registry._handlers[job.kind], failed=away))
        assert not runner.run(job.id)
    assert job_now(factory, job).state == "running"


@pytest.mark.parametrize(("counted", "attempts"), [(True, 1), (False, 0)])
def test_the_event_of_a_job_put_back_says_its_attempts(
    factory: SessionFactory, counted: bool, attempts: int
) -> None:
    job = queued(factory, "test_fail", how="input")
    with writing(factory) as session:
        claim_job(session, job.id, worker="w")
    take_back(factory, worker="w", counted=counted)
    assert job_now(factory, job).attempts == attempts
    with reading(factory) as session:
        newest = select(audit_events.c.after).order_by(audit_events.c.id.desc()).limit(1)
        assert json.loads(session.execute(newest).scalar_one()) == {"state": "queued", "attempts": attempts}


def test_a_job_that_was_to_be_cancelled_does_not_wait_for_what_is_away(
    runner: Runner, factory: SessionFactory
) -> None:
    job = queued(factory, "test_away", what="storage", cancel=True)
    runner.run(job.id)
    assert job_now(factory, job).state == "cancelled"


def test_a_job_waits_until_the_database_takes_its_end(
    runner: Runner, factory: SessionFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    job = queued(factory, "test_away", what="storage")
    monkeypatch.setattr(runner_module, "PROGRESS_S", 0.01)
    refused, back = list[str](), runner_module.put_back

    def away(*given: Any, **named: Any) -> None:
        if len(refused) < 3:
            refused.append("away")
            raise DatabaseAway("database-no-answer")
        back(*given, **named)

    monkeypatch.setattr(runner_module, "put_back", away)
    assert runner.run(job.id) and len(refused) == 3
    assert job_now(factory, job).outages == 1
