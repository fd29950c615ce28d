"""How a queued job becomes known to the workers, in the transaction that queues it.

On SQLite there is one machine: its supervisor finds the job in the table, and nothing is to be done. On
PostgreSQL a Procrastinate job with its id is deferred; it ends with each delivery and is deleted then.
"""

from __future__ import annotations

from datetime import datetime
from functools import cache
from typing import TYPE_CHECKING

from sqlalchemy import text
from sqlalchemy.orm import Session

if TYPE_CHECKING:
    from procrastinate import App

TASK = QUEUE = "sightline"
#: deliveries of long jobs; one process of each supervisor never looks here
LONG_QUEUE = "sightline-long"
#: what a process that looks at both queues takes first
_SHORT_FIRST = 10
DELIVERED = "SELECT id FROM procrastinate_jobs WHERE task_name = :task AND status = 'doing'"
_OF_JOB = text(f"{DELIVERED} AND (args ->> 'job_id')::bigint = :job_id")
_FORGET = text("SELECT procrastinate_finish_job_v1(:id, 'failed', true)")


@cache
def _deferring() -> App:
    """An app without a connection of its own: it defers over the caller's."""
    # imported only where it is used: a laptop's start needs none of it
    from procrastinate import App, PsycopgConnector

    return App(connector=PsycopgConnector())


def deliver(session: Session, job_id: int, *, long: bool, not_before: datetime | None = None) -> None:
    """Defer over the session's connection: whoever listens is told at the commit."""
    if session.get_bind().dialect.name != "postgresql":
        return
    queue, priority = (LONG_QUEUE, 0) if long else (QUEUE, _SHORT_FIRST)
    connection = session.connection().connection.driver_connection
    _deferring().configure_task(
        TASK, queue=queue, priority=priority, schedule_at=not_before, connection=connection
    ).defer(job_id=job_id)


def withdraw(session: Session, job_id: int) -> None:
    """Forget the delivery to the worker that had the job."""
    if session.get_bind().dialect.name != "postgresql":
        return
    for delivery in session.execute(_OF_JOB, {"task": TASK, "job_id": job_id}).scalars().all():
        forget(session, delivery)


def forget(session: Session, delivery: int | None) -> None:
    """Let no worker be at this delivery any more."""
    session.execute(_FORGET, {"id": delivery})
