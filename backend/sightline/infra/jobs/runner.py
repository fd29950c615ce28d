"""Running one job under its lease, and sweeping up after workers that died."""

import logging
import os
import socket
import threading
import time
from collections.abc import Callable, Mapping
from typing import Any
from uuid import uuid4

from sqlalchemy.orm import Session

from sightline.errors import SightlineError
from sightline.infra.database.engine import DatabaseAway, SessionFactory, reading, writing
from sightline.infra.jobs.queue import JobQueue
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Cancelled, JobContext, Outcome, registered
from sightline.infra.jobs.store import (
    MAX_ATTEMPTS,
    LeaseLost,
    claim_job,
    expired_jobs,
    fail_job,
    finish_job,
    job_cancelled,
    queued_jobs,
    release_job,
    renew_lease,
    requeue_job,
)
from sightline.settings import Settings

log = logging.getLogger("sightline.jobs")

STOPPED = "Cancelled."
GAVE_UP = "The worker died {attempts} times in the middle of this; look at the input and at the memory."
BROKE = "An error in the program stopped this ({name}); try again, and report it if it comes back."


def worker_name() -> str:
    """A name that no other worker process ever has."""
    return f"{socket.gethostname()}:{os.getpid()}:{uuid4().hex[:8]}"


class Runner:
    """One worker process: claims a job by its id, does it, writes its end."""

    def __init__(self, settings: Settings, factory: SessionFactory) -> None:
        self.settings = settings
        self.factory = factory
        self.name = worker_name()

    def run(self, job_id: int) -> None:
        """Do the job if nobody else has it. Only a KeyboardInterrupt (the worker shuts down) comes out."""
        try:
            with writing(self.factory) as session:
                job = claim_job(session, job_id, worker=self.name, lease_s=self.settings.lease_s)
        except DatabaseAway as away:
            log.warning("job %s: %s", job_id, away.message)
            return
        if job is not None:
            self._do(job)

    def _do(self, job: Job) -> None:
        lease = Lease(self.factory, job, self.settings.lease_s)
        try:
            with lease:
                outcome = self._handle(job, lease)
            self._write(lambda session: _finish(session, job, outcome))
        except LeaseLost:
            log.warning("job %s went to another worker", job.id)
        except DatabaseAway as away:
            # the lease runs out by itself and the job is done again
            log.warning("job %s: %s", job.id, away.message)
        except Cancelled as stopped:
            self._end(job, lambda session: job_cancelled(session, job), stopped.message)
        except SightlineError as error:
            self._fail(job, error.message)
        except KeyboardInterrupt:
            self._end(job, lambda session: release_job(session, job), None)
            raise
        except Exception as error:
            log.exception("job %s (%s) broke", job.id, job.kind)
            self._fail(job, BROKE.format(name=type(error).__name__))

    def _handle(self, job: Job, lease: "Lease") -> Outcome:
        known = registered(job.kind)
        if known is None:
            raise SightlineError(f"This worker knows no job of kind {job.kind}; start one of this version.")
        return known.run(JobContext(job, self.settings, self.factory, lease.report, lease.is_over))

    def _fail(self, job: Job, sentence: str) -> None:
        self._end(job, lambda session: fail_job(session, job, sentence), sentence)

    def _end(self, job: Job, write: Callable[[Session], Any], sentence: str | None) -> None:
        def whole(session: Session) -> None:
            write(session)
            if sentence is not None:
                clean_up(session, job, sentence)

        try:
            self._write(whole)
        except (LeaseLost, DatabaseAway) as error:
            log.warning("job %s: %s", job.id, error.message)

    def _write(self, write: Callable[[Session], Any]) -> None:
        with writing(self.factory) as session:
            write(session)


def _finish(session: Session, job: Job, outcome: Outcome) -> None:
    """What was made and the job's end, in one transaction: both or neither, and once."""
    result: Mapping[str, Any] = outcome(session) if callable(outcome) else outcome
    finish_job(session, job, result)


def clean_up(session: Session, job: Job, sentence: str) -> None:
    """Let the kind's `failed` function write what follows from a job that came to nothing."""
    known = registered(job.kind)
    if known is not None and known.failed is not None:
        known.failed(session, job, sentence)


class Lease:
    """Keeps a job's lease alive from a thread of its own, and carries progress and the wish to cancel."""

    def __init__(self, factory: SessionFactory, job: Job, lease_s: float) -> None:
        self._factory, self._job, self._lease_s = factory, job, lease_s
        self._progress, self._message = 0.0, ""
        self._until = time.monotonic() + lease_s
        self._stop = threading.Event()
        self._cancel = self._lost = False
        self._thread = threading.Thread(target=self._keep, name=f"lease-{job.id}", daemon=True)

    def __enter__(self) -> "Lease":
        self._thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._stop.set()
        self._thread.join()

    def report(self, fraction: float, message: str) -> None:
        """Note the progress; the thread writes it. Raises Cancelled or LeaseLost."""
        self._progress = min(max(fraction, 0.0), 1.0)
        self._message = message or self._message
        if self._lost or time.monotonic() > self._until:
            raise LeaseLost(f"Job {self._job.id} went to another worker; this one stops.")
        if self._cancel:
            raise Cancelled(STOPPED)

    def is_over(self) -> bool:
        """Whether going on is of no use."""
        return self._cancel or self._lost or time.monotonic() > self._until

    def _keep(self) -> None:
        pause = min(1.0, self._lease_s / 4)
        while not self._stop.wait(pause):
            asked = time.monotonic()
            try:
                with writing(self._factory) as session:
                    beat = renew_lease(
                        session,
                        self._job,
                        lease_s=self._lease_s,
                        progress=self._progress,
                        message=self._message,
                    )
            except SightlineError as error:
                log.warning("lease of job %s not renewed: %s", self._job.id, error.message)
                continue
            self._cancel, self._lost = beat.cancel_requested, not beat.held
            if self._lost:
                return
            self._until = asked + self._lease_s


def sweep(factory: SessionFactory, queue: JobQueue) -> None:
    """Give the jobs of dead workers to others (up, after three times); push those that the queue lost."""
    with reading(factory) as session:
        expired, waiting = expired_jobs(session), queued_jobs(session)
    for job in expired:
        try:
            with writing(factory) as session:
                again = _take_back(session, job)
        except LeaseLost:
            continue
        if again:
            queue.push(job.id)
    if waiting and queue.waiting() == 0:
        for job_id in waiting:
            queue.push(job_id)


def _take_back(session: Session, job: Job) -> bool:
    """End or requeue one expired job; whether it is to run again."""
    if job.cancel_requested:
        job_cancelled(session, job)
        clean_up(session, job, STOPPED)
    elif job.attempts >= MAX_ATTEMPTS:
        message = GAVE_UP.format(attempts=job.attempts)
        fail_job(session, job, message)
        clean_up(session, job, message)
    else:
        requeue_job(session, job)
        return True
    return False
