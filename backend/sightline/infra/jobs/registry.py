"""Long work: enqueue it, register who does it (`runner`, `workers` and the engines do the rest).

A handler is a function of a `JobContext` and gives back the job's result, or a function of a session that
writes what was made and gives back the result: that one runs in the same transaction as the job's end, so
that a job that was run twice leaves its outcome once.

    @jobs.handler("ingest", failed=mark_recording_failed)
    def ingest(context: JobContext) -> Outcome: ...
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Unpack

from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.errors import Away, BadInput, Conflict, NoRoom
from sightline.infra.database.engine import translate_database_errors
from sightline.infra.jobs.delivery import deliver
from sightline.infra.jobs.records import Job, JobOf
from sightline.infra.jobs.store import create_job, request_job_cancel
from sightline.messages.said import Said

if TYPE_CHECKING:
    from sightline.infra.services import Services

log = logging.getLogger("sightline.jobs")

Finish = Callable[[Session], Mapping[str, Any]]
Outcome = Mapping[str, Any] | Finish
Failed = Callable[[Session, Job, Said], None]
#: The error of a job that was stopped because somebody asked for it.
STOPPED = Said("jobs-cancelled")


@dataclass(frozen=True, eq=False, slots=True)
class JobContext:
    """What a handler works with."""

    job: Job
    services: Services
    report: Callable[[float, Said | None], None]
    #: whether the job is to stop (or was lost); for inner loops that call no progress
    is_cancelled: Callable[[], bool]

    @property
    def payload(self) -> JsonObject:
        """What was asked for."""
        return self.job.payload

    @property
    def actor(self) -> int | None:
        """Who asked for it; pass it on as the actor of every write."""
        return self.job.created_by

    def progress(self, fraction: float, message: Said | None = None) -> None:
        """Say how far the job is (0 to 1). Raises Stopped if it is to stop, JobLost if another has it."""
        self.report(fraction, message)


Handler = Callable[[JobContext], Outcome]


@dataclass(frozen=True, slots=True)
class Registered:
    """A handler, and what to write in the same transaction when its job fails or is cancelled."""

    run: Handler
    failed: Failed | None
    long: bool = False
    cancellable: bool = True


_handlers: dict[str, Registered] = {}


def handler(
    kind: str, *, failed: Failed | None = None, long: bool = False, cancellable: bool = True
) -> Callable[[Handler], Handler]:
    """Register the function that does jobs of this kind.

    `failed(session, job, error)` cleans up after a job that came to nothing, or was stopped before it began.
    `long`: it goes through whole videos or surveys; such jobs wait behind all others, and one place of the
    workers is never theirs. One that is not `cancellable` is the only place that tells of its work.
    """

    def register(function: Handler) -> Handler:
        known = _handlers.get(kind)
        if known is not None and known.run.__qualname__ != function.__qualname__:
            raise ValueError(f"two handlers for jobs of kind {kind}")
        _handlers[kind] = Registered(function, failed, long, cancellable)
        return function

    return register


def handler_of(kind: str) -> Registered | None:
    """Who does jobs of this kind."""
    return _handlers.get(kind)


def kinds() -> list[str]:
    """Every kind of job that somebody here does."""
    return list(_handlers)


def housekeeping() -> list[str]:
    """The kinds that the program asks for itself and nobody cancels: once done, they are no news."""
    return [kind for kind, known in _handlers.items() if not known.cancellable]


def is_long(kind: str) -> bool:
    """Whether jobs of this kind keep others waiting; of a kind that nobody here knows, they may."""
    known = handler_of(kind)
    return known is None or known.long


def clean_up(session: Session, job: Job, error: Said) -> None:
    """Let the kind's `failed` function write what follows from a job that came to nothing.

    One that breaks writes nothing, and the job ends all the same: it would be begun again for ever.
    """
    handler = handler_of(job.kind)
    if handler is None or handler.failed is None:
        return
    try:
        with translate_database_errors(), session.begin_nested():
            handler.failed(session, job, error)
    except (Away, NoRoom):
        raise  # the whole is tried again
    except Exception:
        log.exception("what follows from the end of job %s (%s) is not written", job.id, job.kind)


def cancel(session: Session, job: Job, actor: int) -> Job:
    """Stop a queued job at once, a running one when it next looks.

    Raises Conflict for one that has ended, and for a kind that nobody cancels.
    """
    if job.kind in housekeeping():
        raise Conflict("jobs-not-to-be-cancelled")
    asked = request_job_cancel(session, job.id, actor=actor)
    if asked.state == "cancelled":
        clean_up(session, asked, STOPPED)
    return asked


def enqueue_again(session: Session, job: Job, actor: int) -> Job:
    """The same work once more, for a job that failed or was stopped.

    Raises Conflict for one that is not over or did its work, and BadInput for a kind whose work begins on a
    page of its own (there more than the job has to be put right).
    """
    if job.state not in ("failed", "cancelled"):
        raise Conflict("jobs-only-failed-again", state=job.state)
    kind = handler_of(job.kind)
    if kind is None or kind.failed is not None:
        raise BadInput("jobs-restart-elsewhere", kind=job.kind)
    of: JobOf = {"recording_id": job.recording_id, "scan_id": job.scan_id, "study_id": job.study_id}
    return enqueue(session, job.kind, job.payload, survey_id=job.survey_id, actor=actor, **of)


def enqueue(
    session: Session,
    kind: str,
    payload: Mapping[str, Any],
    *,
    survey_id: int | None,
    actor: int | None,
    **of: Unpack[JobOf],
) -> Job:
    """A job in the caller's transaction; begun once that commits."""
    job = create_job(session, kind, payload, survey_id=survey_id, actor=actor, **of)
    deliver(session, job.id, long=is_long(kind))
    return job
