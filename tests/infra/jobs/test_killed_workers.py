"""Real worker processes: killed in the middle, stopped, or left alone by their parent."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from sqlalchemy import text

from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import get_job, request_job_cancel
from sightline.infra.jobs.workers import start_child_workers
from sightline.settings import Settings
from sightline.surveys.store import list_surveys
from tests.infra.jobs import handlers
from tests.support.waiting import NEVER_S, alive, until

pytestmark = pytest.mark.dialect

ROOT = Path(__file__).resolve().parents[3]
#: a living worker of a busy machine is never silent for so long; every fifth of it one looks for dead ones
HEARTBEAT_LIMIT_S = 20.0
# Who queues a job has to know its kind too: how long it takes decides where it waits.
assert handlers.make_survey

LONG_S = 3600.0


@pytest.fixture
def settings(tmp_path: Path, database_url: str) -> Settings:
    return Settings(
        data_dir=tmp_path, database_url=database_url, heartbeat_limit_s=HEARTBEAT_LIMIT_S, workers=1
    )


@pytest.fixture
def start(settings: Settings) -> Iterator[Callable[[], "subprocess.Popen[bytes]"]]:
    """Start worker processes; whatever is left of them is killed in the end."""
    started: list[subprocess.Popen[bytes]] = []
    environment = {
        **os.environ,
        "SIGHTLINE_DATA_DIR": str(settings.data_dir),
        "SIGHTLINE_DATABASE_URL": settings.database_url,
        "SIGHTLINE_HEARTBEAT_LIMIT_S": str(HEARTBEAT_LIMIT_S),
        "SIGHTLINE_WORKERS": "1",
    }

    def begin() -> "subprocess.Popen[bytes]":
        command = [sys.executable, "-m", "tests.infra.jobs.handlers", str(os.getpid())]
        with (settings.data_dir / f"worker-{len(started) + 1}.log").open("w") as log:
            process = subprocess.Popen(command, cwd=ROOT, env=environment, stderr=log, start_new_session=True)
        started.append(process)
        return process

    yield begin
    for process in started:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def enqueue(factory: SessionFactory, tmp_path: Path, first_s: float = LONG_S, name: str = "made once") -> Job:
    payload = {"folder": str(tmp_path), "first_s": first_s, "name": name}
    with writing(factory) as session:
        return registry.enqueue(session, "test_make_survey", payload, survey_id=None, actor=None)


def wait_for(path: Path) -> int:
    """The process id that a handler wrote when it began."""
    until(lambda: path.exists() and path.read_text(), lambda: f"{path.name} did not come")
    return int(path.read_text())


def wait_for_end(factory: SessionFactory, job: Job) -> Job:
    def ended() -> Job | None:
        with reading(factory) as session:
            found = get_job(session, job.id)
        return found if found.state not in ("queued", "running") else None

    return until(ended, lambda: "the job does not end")


def silent_for_long(factory: SessionFactory) -> None:
    """As if an hour had gone since the last heartbeat of the workers with a job (PostgreSQL)."""
    with writing(factory) as session:
        if session.get_bind().dialect.name == "postgresql":
            at_work = "SELECT worker_id FROM procrastinate_jobs WHERE status = 'doing'"
            ago = "last_heartbeat = last_heartbeat - interval '1 hour'"
            session.execute(text(f"UPDATE procrastinate_workers SET {ago} WHERE id IN ({at_work})"))


def is_there(factory: SessionFactory, tmp_path: Path) -> None:
    """Wait until a second supervisor is: on PostgreSQL it works, else it waits for its turn."""
    with reading(factory) as session:
        shared = session.get_bind().dialect.name == "postgresql"
    if shared:
        (tmp_path / "beside").mkdir()
        done = wait_for_end(factory, enqueue(factory, tmp_path / "beside", 0, "made beside"))
        assert done.state == "done"
    else:
        log = tmp_path / "worker-2.log"
        until(lambda: "waiting for the turn" in log.read_text(), log.read_text)


def made(factory: SessionFactory) -> list[str]:
    """The surveys that jobs made, the newest first."""
    with reading(factory) as session:
        assert verify_records(session).ok
        return [one.name for one in list_surveys(session)]


def test_a_killed_process_loses_nothing_a_cancelled_job_ends_and_a_stopped_worker_gives_its_job_back(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    """One after the other in one worker, whose start is what takes long."""
    cancelled, given_back = (tmp_path / name for name in ("cancelled", "given back"))
    cancelled.mkdir()
    given_back.mkdir()
    job = enqueue(factory, tmp_path)
    worker = start()
    os.kill(wait_for(tmp_path / "attempt-1"), signal.SIGKILL)
    wait_for(tmp_path / "attempt-2")
    done = wait_for_end(factory, job)
    assert (done.state, done.attempts, done.result) == ("done", 2, {"survey_id": 1})
    assert made(factory) == ["made once"] and worker.poll() is None

    job = enqueue(factory, cancelled)
    wait_for(cancelled / "attempt-1")
    with writing(factory) as session:
        request_job_cancel(session, job.id, actor=None)
    assert wait_for_end(factory, job).state == "cancelled"
    again = enqueue(factory, cancelled, first_s=0)
    assert wait_for_end(factory, again).state == "done", "the worker goes on"

    job = enqueue(factory, given_back)
    wait_for(given_back / "attempt-1")
    worker.terminate()
    assert worker.wait(NEVER_S) == 0
    with reading(factory) as session:
        waiting = get_job(session, job.id)
    assert (waiting.state, waiting.attempts, waiting.worker) == ("queued", 0, None)


def test_a_killed_supervisor_loses_nothing(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    """Another takes over: one that waited for its turn, or on PostgreSQL worked beside it."""
    job = enqueue(factory, tmp_path)
    first = start()
    at_work = wait_for(tmp_path / "attempt-1")
    start()
    is_there(factory, tmp_path)
    with reading(factory) as session:
        assert get_job(session, job.id).attempts == 1, "nobody takes the job of a living worker"
    before = made(factory)
    os.kill(first.pid, signal.SIGKILL)
    until(lambda: not alive(at_work))
    silent_for_long(factory)
    wait_for(tmp_path / "attempt-2")
    done = wait_for_end(factory, job)
    assert done.state == "done" and done.attempts >= 2
    assert made(factory) == ["made once", *before] and done.result == {"survey_id": len(before) + 1}


@pytest.mark.proof
def test_jobs_of_a_killed_server_are_taken_up_by_the_next_one(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    job = enqueue(factory, tmp_path)
    first = start()
    at_work = wait_for(tmp_path / "attempt-1")
    first.kill()
    first.wait()
    until(lambda: not alive(at_work), lambda: "the orphan goes on")
    silent_for_long(factory)
    start()
    done = wait_for_end(factory, job)
    assert done.state == "done" and done.attempts >= 2
    assert made(factory) == ["made once"] and done.result == {"survey_id": 1}


def test_a_worker_that_puts_its_job_back_goes_on_without_a_word_of_defects(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    """What is away takes nothing but time: the worker's own delivery ends once."""
    with writing(factory) as session:
        away = registry.enqueue(session, "test_away", {"what": "storage"}, survey_id=None, actor=None)
    worker = start()

    def postponed() -> bool:
        with reading(factory) as session:
            return get_job(session, away.id).outages > 0

    until(postponed)
    after = enqueue(factory, tmp_path, first_s=0)
    assert wait_for_end(factory, after).state == "done"
    log = (tmp_path / "worker-1.log").read_text()
    assert f"job {away.id} (test_away) waits" in log
    assert "Traceback" not in log and worker.poll() is None


SERVER = """
import sys
from sightline.settings import load_settings
from sightline.infra.jobs.workers import start_child_workers
child = start_child_workers(load_settings())
print(child.process.pid, flush=True)
sys.stdin.read()
"""


@pytest.mark.once
def test_the_servers_worker_dies_with_a_killed_server(settings: Settings, engine: object) -> None:
    environment = {
        **os.environ,
        "SIGHTLINE_DATA_DIR": str(settings.data_dir),
        "SIGHTLINE_DATABASE_URL": settings.database_url,
        "SIGHTLINE_SIGNING_KEY": "5e" * 32,  # several machines share one
        "SIGHTLINE_WORKERS": "1",
    }
    command = [sys.executable, "-c", SERVER]
    with subprocess.Popen(
        command, cwd=ROOT, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as server:
        assert server.stdout is not None
        child = int(server.stdout.readline())
        time.sleep(1)
        assert alive(child)
        server.kill()
    until(lambda: not alive(child), lambda: "the worker outlived its server")


@pytest.mark.once
def test_the_servers_worker_is_started_again_and_stops_with_it(settings: Settings, engine: object) -> None:
    child = start_child_workers(settings)
    assert child is not None
    first = child.process.pid
    child.process.kill()
    until(lambda: child.process.pid != first, lambda: "it was not started again")
    second = child.process.pid
    child.stop()
    assert not alive(second)


@pytest.mark.once
def test_no_worker_where_none_is_asked_for(settings: Settings) -> None:
    assert start_child_workers(settings.model_copy(update={"workers": 0})) is None


def test_a_short_job_starts_while_long_ones_run_and_wait(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    """One place for everything: a long job has it for ever, two more wait, and the short one is done."""

    def state(job: Job) -> str:
        with reading(factory) as session:
            return get_job(session, job.id).state

    with writing(factory) as session:
        place = {"survey_id": None, "actor": None}
        long = [registry.enqueue(session, "test_long", {}, **place) for _ in range(3)]
    start()
    until(lambda: state(long[0]) == "running")
    short = [enqueue(factory, tmp_path, 0, f"short {n}") for n in range(3)]
    assert [wait_for_end(factory, job).state for job in short] == ["done"] * 3
    assert [state(job) for job in long] == ["running", "queued", "queued"]
    with writing(factory) as session:
        request_job_cancel(session, long[0].id, actor=None)
    until(lambda: state(long[1]) == "running")
    assert state(long[2]) == "queued"
