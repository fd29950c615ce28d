"""The engine of one machine: the supervisor hands queued jobs to its worker processes over socket pairs."""

import fcntl
import socket
from collections.abc import Sequence
from pathlib import Path
from queue import SimpleQueue
from typing import IO

from sightline.infra.database.engine import SessionFactory, reading
from sightline.infra.jobs.process import WorkerProcess, on_stop, watch_supervisor
from sightline.infra.jobs.recovery import take_back
from sightline.infra.jobs.registry import is_long
from sightline.infra.jobs.runner import Runner
from sightline.infra.jobs.store import queued_jobs
from sightline.settings import Settings

LOCK_NAME = "workers.lock"
IDLE = b"\n"


class OneMachine:
    """Needs no queue: the job table is on this disk, and there is one supervisor."""

    def __init__(self) -> None:
        self._lock: IO[bytes] | None = None

    def start(self, settings: Settings, sessions: SessionFactory) -> bool:
        """Whether this supervisor is the only one; what was running before it has no worker any more."""
        self._lock = self._lock or _locked(settings.data_dir / LOCK_NAME)
        if self._lock is None:
            return False
        take_back(sessions)
        return True

    def hand_out(self, sessions: SessionFactory, processes: Sequence[WorkerProcess]) -> None:
        """One waiting job to each idle process that may have it: the short ones first, then the oldest."""
        # whoever takes only short ones chooses first, so that the others are left for the long ones
        idle = sorted(
            (process for process in processes if process.is_idle), key=lambda one: not one.short_only
        )
        if not idle:
            return
        with reading(sessions) as session:
            waiting = queued_jobs(session)
        handed_out = {process.job_id for process in processes}
        short, long = (
            [job_id for job_id, kind in waiting.items() if job_id not in handed_out and is_long(kind) is one]
            for one in (False, True)
        )
        for process in idle:
            if short:
                process.give(short.pop(0))
            elif long and not process.short_only:
                process.give(long.pop(0))

    def work(self, runner: Runner, orders: socket.socket, *, short_only: bool) -> None:
        """Do the jobs whose ids come in lines; say when done."""
        job_ids: SimpleQueue[int | None] = SimpleQueue()

        def stop() -> None:
            runner.stop()
            job_ids.put(None)

        watch_supervisor(orders, lambda line: job_ids.put(int(line)))
        on_stop(stop)
        orders.sendall(IDLE)
        while (job_id := job_ids.get()) is not None and runner.run(job_id):
            orders.sendall(IDLE)


def _locked(path: Path) -> IO[bytes] | None:
    """The file, locked by this process alone (forks have no part in it) until that ends, however it does."""
    path.parent.mkdir(parents=True, exist_ok=True)
    file = path.open("ab")
    try:
        fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        file.close()
        return None
    return file
