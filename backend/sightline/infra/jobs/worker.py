"""Worker processes: `sightline worker`, and the one that `sightline serve` starts as its child.

Jobs run in huey's process workers, so a video that crashes the decoder costs one process, which is started
anew. Every process watches its parent and ends when that is gone, so a `kill -9` of the server leaves nothing
running.
"""

import logging
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from huey.constants import WORKER_PROCESS
from huey.consumer import Consumer, ConsumerStopped, Scheduler

from sightline.infra.database.engine import make_engine, migrate, session_factory
from sightline.infra.jobs.queue import JobQueue, attach, open_queue
from sightline.infra.jobs.runner import Runner, sweep
from sightline.settings import Settings

log = logging.getLogger("sightline.worker")

STOP_S = 2.0


def run_worker(settings: Settings, *, parent: int | None = None, handlers: Callable[[], None]) -> None:
    """Do jobs until told to stop (SIGTERM, SIGINT) or until the `parent` process is gone. Blocks."""
    engine = make_engine(settings.database_url)
    migrate(engine)
    engine.dispose()
    handlers()
    queue = open_queue(settings)
    _Consumer.of(settings, queue, parent or os.getppid()).run()


def _prepare(settings: Settings, queue: JobQueue) -> None:
    """In each worker process after its start: open the database there and take jobs."""
    factory = session_factory(make_engine(settings.database_url))
    attach(factory, queue)
    queue.run_with(Runner(settings, factory).run)


class _Sweeper(Scheduler):  # type: ignore[misc]
    """Huey's scheduler process has nothing to schedule here; once a second it sweeps instead."""

    settings: Settings
    queue: JobQueue

    def initialize(self) -> None:
        _end_with_parent()
        self.factory = session_factory(make_engine(self.settings.database_url))

    def loop(self, now: Any = None) -> None:
        started = time.monotonic()
        try:
            sweep(self.factory, self.queue)
        except Exception as error:  # a database that is away comes back
            log.warning("sweep: %s", error)
        self.stop_flag.wait(max(0.0, 1.0 - (time.monotonic() - started)))


class _Consumer(Consumer):  # type: ignore[misc]
    """Huey's consumer, which stops when its own parent is gone."""

    scheduler_class = _Sweeper

    @classmethod
    def of(cls, settings: Settings, queue: JobQueue, parent: int) -> "_Consumer":
        """A consumer of this queue with as many processes as the settings say."""
        queue.huey.on_startup(name="end_with_parent")(_end_with_parent)
        queue.huey.on_startup(name="prepare")(lambda: _prepare(settings, queue))
        _Sweeper.settings, _Sweeper.queue = settings, queue
        made = cls(
            queue.huey,
            workers=max(1, settings.workers),
            worker_type=WORKER_PROCESS,
            periodic=False,
            initial_delay=0.05,
            max_delay=0.5,
            health_check_interval=1,
            graceful_signal="TERM",
            shutdown_timeout=STOP_S,
        )
        made.parent = parent
        return made

    def loop(self, health_check_ts: float | None = None) -> Any:
        if os.getppid() != self.parent:
            log.warning("the server is gone, so its worker stops")
            self.stop()
            raise ConsumerStopped
        return super().loop(health_check_ts)


def _end_with_parent() -> None:
    """End this process within half a second when its parent does, even when that was killed."""
    parent = os.getppid()

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(0.5)
        os._exit(1)

    threading.Thread(target=watch, name="parent-watch", daemon=True).start()


class ChildWorker:
    """The worker that the server starts, restarts when it dies, and takes along when it ends."""

    def __init__(self, settings: Settings) -> None:
        self._environment = {**os.environ, **_environment_of(settings)}
        self._stopping = threading.Event()
        self.process = self._start()
        self._guard = threading.Thread(target=self._watch, name="worker-guard", daemon=True)
        self._guard.start()

    def stop(self) -> None:
        """End the worker; a job in the middle goes back to the queue."""
        self._stopping.set()
        self.process.terminate()
        try:
            self.process.wait(STOP_S + 3)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self._guard.join(2)

    def _start(self) -> "subprocess.Popen[bytes]":
        command = [sys.executable, "-m", "sightline.cli", "worker", "--parent", str(os.getpid())]
        return subprocess.Popen(command, env=self._environment, stdin=subprocess.DEVNULL)

    def _watch(self) -> None:
        pause = 0.5
        while not self._stopping.wait(pause):
            if self.process.poll() is not None and not self._stopping.is_set():
                log.warning("the worker ended with status %s and is started anew", self.process.returncode)
                self.process = self._start()
                pause = min(pause * 2, 30.0)


def start_child_worker(settings: Settings) -> ChildWorker | None:
    """Start the server's own worker, None where none is asked for; call `stop()` when the server ends."""
    return ChildWorker(settings) if settings.workers > 0 else None


def _environment_of(settings: Settings) -> dict[str, str]:
    given = {
        "DATA_DIR": settings.data_dir.absolute(),
        "DATABASE_URL": settings.database_url,
        "MEDIA_URL": settings.media_url,
        "WORKERS": settings.workers,
        "LEASE_S": settings.lease_s,
    }
    package = str(Path(__file__).resolve().parents[3])
    paths = [package, os.environ.get("PYTHONPATH", "")]
    return {f"SIGHTLINE_{name}": str(value) for name, value in given.items()} | {
        "PYTHONPATH": os.pathsep.join(path for path in paths if path)
    }
