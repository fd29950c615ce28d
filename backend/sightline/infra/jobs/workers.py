"""Worker processes: their supervisor (`sightline worker`), and the one that `sightline serve` has as a child.

The supervisor imports the handlers once and forks worker processes, each of which does one job at a time. A
video that crashes the decoder costs one process: its job is put back at once and another is forked. A worker
process holds one end of a socket pair and ends when the other closes, so a `kill -9` leaves nothing running.
"""

import gc
import logging
import os
import select
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from uuid import uuid4

from sightline.children import child_environment, kept_for_good
from sightline.errors import SightlineError
from sightline.infra.database.engine import make_engine, migrate, session_factory, translate_database_errors
from sightline.infra.database.pages import require_whole_pages
from sightline.infra.installation import require_alike, show_settings
from sightline.infra.jobs.engine import engine_of
from sightline.infra.jobs.process import WorkerProcess
from sightline.infra.jobs.recovery import take_back
from sightline.infra.jobs.runner import Runner
from sightline.infra.private import keep_private
from sightline.infra.services import open_services
from sightline.settings import Settings

log = logging.getLogger("sightline.worker")

TICK_S = 0.2
STOP_S = 2.0
#: a process that ended sooner than this, without a job, is not replaced at once
SHORT_LIFE_S = 1.0
#: how often a supervisor shows that it lives
ALIVE_EVERY_S = 5.0


def run_workers(settings: Settings, *, parent: int | None = None, load_handlers: Callable[[], None]) -> None:
    """Supervise worker processes until told to stop (SIGTERM, SIGINT) or until `parent` is gone. Blocks."""
    with ending_with(parent):
        keep_private(settings)
        engine = make_engine(settings.database_url)
        if parent is None:  # a server has looked before it starts its own
            with translate_database_errors(), engine.connect() as connection:
                require_whole_pages(connection, quick=True)
        migrate(engine)
        require_alike(engine, settings, app=False)
        engine.dispose()
        with kept_for_good():
            load_handlers()
    gc.freeze()  # what is never looked at again stays shared with the forked processes
    Supervisor(settings, parent).run()


@contextmanager
def ending_with(parent: int | None) -> Iterator[None]:
    """While this lasts, end the process soon after `parent` does; a timer, since a thread forbids to fork."""

    def look(*_signal: object) -> None:
        if os.getppid() != parent:
            os._exit(1)

    if parent is None:
        yield
        return
    signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, TICK_S, TICK_S)
    yield
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.signal(signal.SIGALRM, signal.SIG_DFL)


def alive_file(settings: Settings) -> Path:
    """Touched every few seconds by the supervisor of this machine that `sightline worker` is."""
    return settings.data_dir / f"worker-{socket.gethostname()}.alive"


def worker_name() -> str:
    """A name that no other worker process ever has."""
    return f"{socket.gethostname()}:{uuid4().hex[:12]}"


class Supervisor:
    """Keeps the settings' worker processes, and one that takes no long job. Single-threaded, for it forks."""

    def __init__(self, settings: Settings, parent: int | None = None) -> None:
        self.settings = settings
        self.parent = parent
        self._database = make_engine(settings.database_url)
        self._sessions = session_factory(self._database)
        self._engine = engine_of(self._database.dialect.name)
        self._processes: list[WorkerProcess] = []
        self._ended: list[WorkerProcess] = []
        self._fork_after = 0.0
        self._show_after = 0.0
        self._stopping = False

    def run(self) -> None:
        """Until told to stop."""
        signal.signal(signal.SIGTERM, self._stop)
        # Ctrl+C in a terminal reaches the server's child as well; the server then says when to stop.
        signal.signal(signal.SIGINT, self._stop if self.parent is None else signal.SIG_IGN)
        if not self._may_start():
            log.warning("waiting for the turn to do jobs: another process does those of this data folder")
            while not self._is_over() and not self._may_start():
                time.sleep(TICK_S)
        while not self._is_over():
            self._show_life()
            self._fill()
            self._trying(lambda: self._engine.hand_out(self._sessions, self._processes))
            self._listen(TICK_S)
            self._trying(self._take_back_ended)
        self._end()

    def _stop(self, *_signal: object) -> None:
        self._stopping = True

    def _is_over(self) -> bool:
        return self._stopping or (self.parent is not None and os.getppid() != self.parent)

    def _may_start(self) -> bool:
        try:
            return self._engine.start(self.settings, self._sessions)
        except SightlineError as error:
            log.warning("%s", error.message)
            return False

    def _show_life(self) -> None:
        """For who looks from outside whether it still goes round: the time of a file."""
        if self.parent is None and time.monotonic() >= self._show_after:
            self._show_after = time.monotonic() + ALIVE_EVERY_S
            with suppress(OSError):  # a full disk
                alive_file(self.settings).touch()

    def _fill(self) -> None:
        for short_only, places in ((False, max(1, self.settings.workers)), (True, 1)):
            while (
                sum(process.short_only is short_only for process in self._processes) < places
                and time.monotonic() >= self._fork_after
            ):
                self._processes.append(self._fork(short_only))

    def _fork(self, short_only: bool) -> WorkerProcess:
        self._database.dispose()  # no connection may be known on both sides
        ours, theirs = socket.socketpair()
        name = worker_name()
        pid = os.fork()
        if pid == 0:
            for other in [ours, *(process.orders for process in self._processes)]:
                other.close()
            be_worker(self.settings, name, theirs, short_only=short_only)
        theirs.close()
        return WorkerProcess(pid, name, ours, short_only=short_only)

    def _listen(self, seconds: float) -> None:
        """Wait for a process to say something; those that ended are buried."""
        if not self._processes:
            time.sleep(seconds)
            return
        for process in select.select(self._processes, [], [], seconds)[0]:
            if process.is_alive():
                continue
            process.bury()
            self._processes.remove(process)
            self._ended.append(process)

    def _take_back_ended(self) -> None:
        while self._ended:
            process = self._ended[0]
            jobs = take_back(self._sessions, worker=process.name, counted=not self._stopping)
            if not jobs and time.monotonic() - process.started < SHORT_LIFE_S:
                self._fork_after = time.monotonic() + SHORT_LIFE_S
            del self._ended[0]

    def _trying(self, step: Callable[[], None]) -> None:
        """A step that a database which is away or full puts off."""
        try:
            step()
        except SightlineError as error:
            log.warning("%s", error.message)
            time.sleep(TICK_S)

    def _end(self) -> None:
        """Stop the processes, the slow ones after two seconds; their jobs wait for the next worker."""
        self._stopping = True
        if self.parent is None:
            alive_file(self.settings).unlink(missing_ok=True)
        for process in self._processes:
            with suppress(ProcessLookupError):
                os.kill(process.pid, signal.SIGTERM)
        end = time.monotonic() + STOP_S
        while self._processes and (left := end - time.monotonic()) > 0:
            self._listen(left)
        for process in self._processes:
            process.bury()
            self._ended.append(process)
        self._trying(self._take_back_ended)


def be_worker(settings: Settings, name: str, orders: socket.socket, *, short_only: bool) -> None:
    """In a forked process: do jobs under this name. Never returns."""
    status = 1
    try:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        # This process is itself the one that a hostile file may end.
        services = open_services(settings, decode_in_child=False)
        show_settings(services.engine, settings, app=False)
        engine_of(services.engine.dialect.name).work(Runner(services, name), orders, short_only=short_only)
        status = 0
    except SightlineError as error:
        log.warning("a worker process ends: %s", error.message)
    except BrokenPipeError:
        pass  # the supervisor is gone
    except BaseException:
        log.exception("a worker process broke")
    finally:
        os._exit(status)


class ChildSupervisor:
    """The supervisor that the server starts, restarts when it dies, and takes along when it ends."""

    def __init__(self, settings: Settings) -> None:
        self._environment = child_environment(**_environment_of(settings))
        self._stopping = threading.Event()
        self.process = self._start()
        self._guard = threading.Thread(target=self._watch, name="worker-guard", daemon=True)
        self._guard.start()

    def stop(self) -> None:
        """End the workers; a job in the middle goes back to the queue."""
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


def start_child_workers(settings: Settings) -> ChildSupervisor | None:
    """Start the server's own workers, None where none are asked for; call `stop()` when the server ends."""
    return ChildSupervisor(settings) if settings.workers > 0 else None


def _environment_of(settings: Settings) -> dict[str, str]:
    given = {
        "DATA_DIR": settings.data_dir.absolute(),
        "DATABASE_URL": settings.database_url,
        "MEDIA_URL": settings.media_url,
        "WORKERS": settings.workers,
        "HEARTBEAT_LIMIT_S": settings.heartbeat_limit_s,
        "LOG_FORMAT": settings.log_format,
    }
    return {f"SIGHTLINE_{name}": str(value) for name, value in given.items()}
