"""Doing one job in a worker process, and writing its end."""

import logging
import threading
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Self

from sqlalchemy.orm import Session

from sightline.errors import Away, SightlineError, Stopped
from sightline.infra.database.engine import DatabaseAway, SessionFactory, reading, writing
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.recovery import put_back
from sightline.infra.jobs.registry import STOPPED, JobContext, Outcome, clean_up, handler_of
from sightline.infra.jobs.store import (
    Hold,
    JobLost,
    check_hold,
    claim_job,
    fail_job,
    finish_job,
    get_job,
    job_cancelled,
    note_progress,
)
from sightline.infra.services import Services
from sightline.messages.said import Said

log = logging.getLogger("sightline.jobs")

PROGRESS_S = 1.0


class Runner:
    """Does jobs one after the other under the name of its worker process."""

    def __init__(self, services: Services, name: str) -> None:
        self.services = services
        self.name = name
        self._stopping = threading.Event()

    def stop(self) -> None:
        """Let the job in hand end as if it were cancelled; whoever asked for the stop puts it back."""
        self._stopping.set()

    def run(self, job_id: int) -> bool:
        """Do a job if nobody else has it. False if its end could not be written: end the process then."""
        try:
            with self.services.writing() as session:
                job = claim_job(session, job_id, worker=self.name)
            return job is None or self._do_job(job)
        except JobLost:
            log.warning("job %s went to another worker", job_id)
        except DatabaseAway as away:
            log.warning("job %s: %s", job_id, away.message)
        except Exception:
            log.exception("neither begun nor ended: job %s", job_id)
        return False

    def _do_job(self, job: Job) -> bool:
        """Whether the worker may take another. Raises JobLost, DatabaseAway where no end can be written."""
        try:
            with Watch(self.services.sessions, job, self._stopping) as watch:
                outcome = self._handle(job, watch)
            # what was made and the job's end, in one transaction: both or neither, and once
            with self.services.writing() as session:
                finish_job(session, job, outcome(session) if callable(outcome) else outcome)
        except JobLost:
            raise
        except Away as away:
            return self._postpone(job, away)
        except Stopped:
            if self._stopping.is_set():
                return False
            self._end(job, STOPPED, lambda session: job_cancelled(session, job))
        except SightlineError as error:
            self._fail(job, error)
        except Exception as error:
            log.exception("job %s (%s) broke", job.id, job.kind)
            self._fail(job, SightlineError("jobs-broke", name=type(error).__name__))
        return True

    def _postpone(self, job: Job, away: Away) -> bool:
        """Put the job back for later, as soon as the database takes it; False where the worker is to end."""
        log.warning("job %s (%s) waits: %s", job.id, job.kind, away.message)
        while True:
            try:
                with self.services.writing() as session:
                    asked = get_job(session, job.id).cancel_requested
                    put_back(session, replace(job, cancel_requested=asked), postponed=True)
                return True
            except DatabaseAway:
                if self._stopping.wait(PROGRESS_S):
                    return False

    def _handle(self, job: Job, watch: "Watch") -> Outcome:
        handler = handler_of(job.kind)
        if handler is None:
            raise SightlineError("jobs-kind-unknown", kind_name=job.kind)
        return handler.run(JobContext(job, self.services, watch.report, watch.is_over))

    def _fail(self, job: Job, error: SightlineError) -> None:
        self._end(job, error.said, lambda session: fail_job(session, job, error))

    def _end(self, job: Job, error: Said, write: Callable[[Session], Any]) -> None:
        with self.services.writing() as session:
            write(session)
            clean_up(session, job, error)


class Watch:
    """Beside a running job: stores its progress and looks whether it is to stop, once a second."""

    def __init__(self, sessions: SessionFactory, job: Job, stopping: threading.Event) -> None:
        self._sessions, self._job, self._stopping = sessions, job, stopping
        self._progress: tuple[float, Said | None] = (0.0, None)
        self._stored: tuple[float, Said | None] = self._progress
        self._hold = Hold(True, False)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._keep, name=f"watch-{job.id}", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._ended.set()
        self._thread.join()

    def report(self, fraction: float, message: Said | None) -> None:
        """Note the progress; the thread stores it. Raises Stopped or JobLost."""
        self._progress = (min(max(fraction, 0.0), 1.0), message or self._progress[1])
        if not self._hold.held:
            raise JobLost("jobs-other-worker", id=self._job.id)
        if self.is_over():
            raise Stopped("jobs-cancelled")

    def is_over(self) -> bool:
        """Whether going on is of no use."""
        return self._hold.cancel_requested or not self._hold.held or self._stopping.is_set()

    def _keep(self) -> None:
        missed = 0
        while self._hold.held and not self._ended.wait(PROGRESS_S):
            try:
                self._hold = self._look()
                missed = 0
            except DatabaseAway as away:
                # nothing is lost: what was reported last is stored with the next look, a second from now
                missed += 1
                level = logging.INFO if missed == 1 else logging.WARNING
                log.log(level, "progress of job %s waits for the next look: %s", self._job.id, away.message)
            except Exception as error:  # whoever does not look any more hears of no cancelling
                log.warning("progress of job %s not stored: %s", self._job.id, error)

    def _look(self) -> Hold:
        progress = self._progress
        if progress == self._stored:
            with reading(self._sessions) as session:
                return check_hold(session, self._job)
        with writing(self._sessions) as session:
            hold = note_progress(session, self._job, *progress)
        self._stored = progress
        return hold
