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

from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import get_job, request_job_cancel
from sightline.infra.jobs.workers import start_child_workers
from sightline.settings import Settings
from sightline.surveys.store import list_surveys

pytestmark = pytest.mark.dialect

ROOT = Path(__file__).resolve().parents[3]
HEARTBEAT_LIMIT_S = 2.0


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
        process = subprocess.Popen(command, cwd=ROOT, env=environment, start_new_session=True)
        started.append(process)
        return process

    yield begin
    for process in started:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def enqueue(factory: SessionFactory, tmp_path: Path, first_s: float) -> Job:
    payload = {"folder": str(tmp_path), "first_s": first_s, "name": "made once"}
    with writing(factory) as session:
        return registry.enqueue(session, "test_make_survey", payload, survey_id=None, actor=None)


def wait_for(path: Path, seconds: float = 30) -> int:
    """The process id that a handler wrote when it began."""
    end = time.monotonic() + seconds
    while not (path.exists() and path.read_text()):
        assert time.monotonic() < end, f"{path.name} did not come"
        time.sleep(0.02)
    return int(path.read_text())


def wait_for_end(factory: SessionFactory, job: Job, seconds: float = 30) -> Job:
    end = time.monotonic() + seconds
    while True:
        with reading(factory) as session:
            found = get_job(session, job.id)
        if found.state not in ("queued", "running"):
            return found
        assert time.monotonic() < end, f"the job is still {found.state}"
        time.sleep(0.05)


def alive(pid: int) -> bool:
    try:
        status = Path(f"/proc/{pid}/stat").read_text()
    except FileNotFoundError:
        return False
    return status.rsplit(")", 1)[1].split()[0] != "Z"


def made(factory: SessionFactory) -> list[str]:
    with reading(factory) as session:
        assert verify_records(session).ok
        return [one.name for one in list_surveys(session)]


def test_a_killed_worker_process_loses_nothing(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    job = enqueue(factory, tmp_path, first_s=60)
    worker = start()
    os.kill(wait_for(tmp_path / "attempt-1"), signal.SIGKILL)
    killed = time.monotonic()
    wait_for(tmp_path / "attempt-2")
    took_s = time.monotonic() - killed
    done = wait_for_end(factory, job)
    assert (done.state, done.attempts, done.result) == ("done", 2, {"survey_id": 1})
    assert made(factory) == ["made once"] and worker.poll() is None
    print(f"running again {took_s:.2f} s after the kill")


def test_a_killed_supervisor_loses_nothing(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    """Another takes over: one that waited for its turn, or on PostgreSQL worked beside it."""
    job = enqueue(factory, tmp_path, first_s=60)
    first = start()
    wait_for(tmp_path / "attempt-1")
    start()
    time.sleep(0.5)
    with reading(factory) as session:
        assert get_job(session, job.id).attempts == 1, "nobody takes the job of a living worker"
    os.kill(first.pid, signal.SIGKILL)
    killed = time.monotonic()
    wait_for(tmp_path / "attempt-2")
    took_s = time.monotonic() - killed
    done = wait_for_end(factory, job)
    assert (done.state, done.attempts, done.result) == ("done", 2, {"survey_id": 1})
    assert made(factory) == ["made once"]
    print(f"running again {took_s:.2f} s after the kill, heartbeat limit {HEARTBEAT_LIMIT_S} s")


def test_jobs_of_a_killed_server_are_taken_up_by_the_next_one(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    job = enqueue(factory, tmp_path, first_s=60)
    first = start()
    wait_for(tmp_path / "attempt-1")
    first.kill()
    first.wait()
    start()
    done = wait_for_end(factory, job)
    assert (done.state, done.attempts, done.result) == ("done", 2, {"survey_id": 1})


def test_a_running_job_is_cancelled(
    factory: SessionFactory, tmp_path: Path, start: Callable[[], "subprocess.Popen[bytes]"]
) -> None:
    job = enqueue(factory, tmp_path, first_s=60)
    start()
    wait_for(tmp_path / "attempt-1")
    with writing(factory) as session:
        request_job_cancel(session, job.id, actor=None)
    assert wait_for_end(factory, job).state == "cancelled"
    again = enqueue(factory, tmp_path, first_s=0)
    assert wait_for_end(factory, again).state == "done", "the worker goes on"


def test_the_orphans_of_a_killed_worker_end_by_themselves(
    settings: Settings,
    factory: SessionFactory,
    tmp_path: Path,
    start: Callable[[], "subprocess.Popen[bytes]"],
) -> None:
    enqueue(factory, tmp_path, first_s=60)
    worker = start()
    at_work = wait_for(tmp_path / "attempt-1")
    os.kill(worker.pid, signal.SIGKILL)
    worker.wait()
    end = time.monotonic() + 5
    while alive(at_work):
        assert time.monotonic() < end, "the orphan goes on"
        time.sleep(0.05)


def test_a_stopped_worker_gives_its_job_back(
    settings: Settings,
    factory: SessionFactory,
    tmp_path: Path,
    start: Callable[[], "subprocess.Popen[bytes]"],
) -> None:
    job = enqueue(factory, tmp_path, first_s=60)
    worker = start()
    wait_for(tmp_path / "attempt-1")
    worker.terminate()
    assert worker.wait(10) == 0
    with reading(factory) as session:
        waiting = get_job(session, job.id)
    assert (waiting.state, waiting.attempts, waiting.worker) == ("queued", 0, None)


SERVER = """
import os, sys, time
from sightline.settings import load_settings
from sightline.infra.jobs.workers import start_child_workers
child = start_child_workers(load_settings())
print(child.process.pid, flush=True)
time.sleep(60)
"""


def test_the_servers_worker_dies_with_a_killed_server(settings: Settings, engine: object) -> None:
    environment = {
        **os.environ,
        "SIGHTLINE_DATA_DIR": str(settings.data_dir),
        "SIGHTLINE_DATABASE_URL": settings.database_url,
        "SIGHTLINE_WORKERS": "1",
    }
    command = [sys.executable, "-c", SERVER]
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE) as server:
        assert server.stdout is not None
        child = int(server.stdout.readline())
        time.sleep(1)
        assert alive(child)
        server.kill()
    end = time.monotonic() + 20
    while alive(child):
        assert time.monotonic() < end, "the worker outlived its server"
        time.sleep(0.05)


def test_the_servers_worker_is_started_again_and_stops_with_it(settings: Settings, engine: object) -> None:
    child = start_child_workers(settings)
    assert child is not None
    first = child.process.pid
    child.process.kill()
    end = time.monotonic() + 10
    while child.process.pid == first:
        assert time.monotonic() < end, "it was not started again"
        time.sleep(0.05)
    second = child.process.pid
    child.stop()
    assert not alive(second)


def test_no_worker_where_none_is_asked_for(settings: Settings) -> None:
    assert start_child_workers(settings.model_copy(update={"workers": 0})) is None
