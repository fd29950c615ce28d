"""The queue that carries job ids to the workers: huey on SQLite or PostgreSQL.

It only wakes somebody up. The job table owns the truth, so a queue that loses an id costs a second, not a
job: the sweeper of every worker looks for jobs that wait or whose lease ran out.
"""

import time
from collections.abc import Callable
from pathlib import Path
from threading import Lock
from typing import Any

from sqlalchemy import URL, event, make_url
from sqlalchemy.orm import Session

from sightline.infra.database.engine import SessionFactory
from sightline.settings import Settings

NAME = "sightline"
INFO_KEY = "job_queue"


class JobQueue:
    """Job ids in, job ids out; made once per process by `open_queue`, opened when it is first needed."""

    def __init__(self, make: Callable[[], Any]) -> None:
        self._make = make
        self._opening = Lock()
        self._opened: Any = None
        self._task: Any = None
        self._run: Callable[[int], None] | None = None

    @property
    def huey(self) -> Any:
        """The queue itself."""
        with self._opening:
            if self._opened is None:
                opened = _twice(self._make)
                self._task = opened.task(name="run_job")(self._carry)
                self._opened = opened
            return self._opened

    def push(self, job_id: int) -> None:
        """Tell the workers about a job; a queue that is away is no error (the sweeper finds the job)."""
        try:
            self.huey.enqueue(self._task.s(job_id))
        except Exception:  # whatever the driver raises: the job table has the job
            self.close()

    def waiting(self) -> int:
        """How many ids wait to be carried."""
        return int(self.huey.pending_count())

    def run_with(self, run: Callable[[int], None]) -> None:
        """What a worker does with an id."""
        self._run = run

    def close(self) -> None:
        """Let go of the connection of this thread."""
        if self._opened is not None:
            self._opened.storage.close()

    def _carry(self, job_id: int) -> None:
        if self._run is None:
            raise RuntimeError("this process carries jobs but does not run them")
        self._run(job_id)


def open_queue(settings: Settings) -> JobQueue:
    """SqliteHuey in the data folder, or PostgresHuey in the PostgreSQL database where that is the store."""
    url = make_url(settings.database_url)
    if url.get_backend_name() == "postgresql":
        return JobQueue(lambda: _postgres_huey(url))
    return JobQueue(lambda: _sqlite_huey(settings.data_dir))


# huey (and the psycopg that it brings) is imported when a queue is opened: a starting server needs none.


def _postgres_huey(url: URL) -> Any:
    from huey import PostgresHuey

    dsn = url.set(drivername="postgresql").render_as_string(hide_password=False)
    return PostgresHuey(NAME, dsn=dsn, results=False, utc=True)


def _sqlite_huey(folder: Path) -> Any:
    from huey import SqliteHuey

    folder.mkdir(parents=True, exist_ok=True)
    return SqliteHuey(NAME, filename=str(folder / "queue.db"), results=False, utc=True, timeout=10)


def attach(factory: SessionFactory, queue: JobQueue) -> None:
    """Let every session of this factory push the jobs that it enqueues, once they are committed."""
    factory.configure(info={**(factory.kw.get("info") or {}), INFO_KEY: queue})


def push_after_commit(session: Session, job_id: int) -> None:
    """Push when the session commits; without an attached queue the sweeper finds the job within a second."""
    queue = session.info.get(INFO_KEY)
    if queue is not None:
        event.listen(session, "after_commit", lambda _session: queue.push(job_id), once=True)


def _twice(make: Callable[[], Any]) -> Any:
    """Two processes that make the queue's tables at one moment trip over each other; the second try works."""
    try:
        return make()
    except Exception:
        time.sleep(0.3)
        return make()
