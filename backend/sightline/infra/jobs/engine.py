"""How queued jobs get to worker processes: one interface, two engines.

SQLite is one machine: the supervisor of the worker processes hands jobs out itself (`one_machine`). On
PostgreSQL several machines share the work: Procrastinate carries the ids (`postgres`). Either way the job
table says what is to be done and what became of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

from sqlalchemy.orm import Session

if TYPE_CHECKING:
    import socket
    from datetime import datetime

    from sightline.infra.database.engine import SessionFactory
    from sightline.infra.jobs.runner import Runner
    from sightline.infra.jobs.workers import WorkerProcess
    from sightline.settings import Settings


class JobEngine(Protocol):
    """What differs between one machine and several."""

    def deliver(self, session: Session, job_id: int, not_before: datetime | None = None) -> None:
        """In the transaction that queues a job: let a worker have it once that commits, or later."""

    def withdraw(self, session: Session, job_id: int) -> None:
        """In the transaction that takes a job from its worker: forget that it was delivered there."""

    def start(self, settings: Settings, sessions: SessionFactory) -> bool:
        """Called by a supervisor until it says that worker processes may be started."""

    def hand_out(self, sessions: SessionFactory, processes: Sequence[WorkerProcess]) -> None:
        """Give waiting jobs to idle worker processes, where those do not fetch them themselves."""

    def work(self, runner: Runner, orders: socket.socket, *, short_only: bool) -> None:
        """In a worker process: do jobs until told to stop, `short_only`: none that are long."""


def engine_of_session(session: Session) -> JobEngine:
    """The engine of the database that a session is on."""
    return engine_of(session.get_bind().dialect.name)


def engine_of(dialect: str) -> JobEngine:
    """The engine for "sqlite" or "postgresql"."""
    # Procrastinate is imported only where it is used: a laptop's start needs none of it.
    if dialect == "postgresql":
        from sightline.infra.jobs.postgres import OnPostgres

        return OnPostgres()
    from sightline.infra.jobs.one_machine import OneMachine

    return OneMachine()
