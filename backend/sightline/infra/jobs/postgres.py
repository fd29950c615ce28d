"""The engine of several machines: Procrastinate carries job ids to the worker processes of all of them.

Deliveries are made in `delivery`; progress, result and history are in the job table. A worker process that is
not heard of for `heartbeat_limit_s` has its jobs delivered again by any other.
"""

import asyncio
import logging
import os
import signal
import socket
import time
from collections.abc import Sequence
from typing import Any

from procrastinate import App, PsycopgConnector
from procrastinate.exceptions import ConnectorException
from procrastinate.jobs import Job as Delivery
from sqlalchemy import make_url, text

from sightline.errors import SightlineError
from sightline.infra.database.engine import DatabaseAway, SessionFactory, writing
from sightline.infra.database.postgres import LimitedAsyncConnection, connection_arguments
from sightline.infra.jobs.delivery import DELIVERED, LONG_QUEUE, QUEUE, TASK, deliver, forget
from sightline.infra.jobs.process import WorkerProcess, watch_supervisor
from sightline.infra.jobs.recovery import put_back
from sightline.infra.jobs.registry import is_long
from sightline.infra.jobs.runner import Runner
from sightline.infra.jobs.store import get_job
from sightline.settings import Settings

log = logging.getLogger("sightline.worker")

BEATS = 5
_STILL_STALLED = text(f"{DELIVERED} AND id = :id AND worker_id IS NOT DISTINCT FROM :worker_id")


class OnPostgres:
    """Procrastinate's fetching and heartbeats."""

    def start(self, settings: Settings, sessions: SessionFactory) -> bool:
        """Any number of supervisors may start workers."""
        return True

    def hand_out(self, sessions: SessionFactory, processes: Sequence[WorkerProcess]) -> None:
        """The processes fetch their jobs themselves."""

    def work(self, runner: Runner, orders: socket.socket, *, short_only: bool) -> None:
        """Fetch and do jobs, one at a time."""
        watch_supervisor(orders, lambda _line: None)
        asyncio.run(_work(runner, [QUEUE] if short_only else [QUEUE, LONG_QUEUE]))


async def _work(runner: Runner, queues: list[str]) -> None:
    settings = runner.services.settings
    url = make_url(settings.database_url).set(drivername="postgresql")
    limits = connection_arguments(url)
    conninfo = url.render_as_string(hide_password=False)
    pool: dict[str, Any] = {"connection_class": LimitedAsyncConnection, "min_size": 1, "max_size": 4}
    app = App(connector=PsycopgConnector(conninfo=conninfo, kwargs=limits, **pool))

    @app.task(name=TASK, queue=QUEUE)
    def run_job(job_id: int) -> None:
        if not runner.run(job_id):
            os._exit(1)  # the delivery stays: the job is put back, and delivered anew with it

    def stop() -> None:
        runner.stop()
        working.cancel()

    async with app.open_async():
        limit_s = settings.heartbeat_limit_s
        working = asyncio.create_task(
            app.run_worker_async(
                queues=queues,
                concurrency=1,
                delete_jobs="always",
                install_signal_handlers=False,
                update_heartbeat_interval=limit_s / BEATS,
            )
        )
        asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, stop)
        looking = asyncio.create_task(_look_for_stalled(app, runner.services.sessions, limit_s))
        try:
            await working
        except asyncio.CancelledError:
            pass
        except ConnectorException as error:
            raise DatabaseAway("database-no-answer") from error
        finally:
            looking.cancel()


async def _look_for_stalled(app: App, sessions: SessionFactory, limit_s: float) -> None:
    silent = set[int | None]()
    while True:
        await asyncio.sleep(limit_s / BEATS)
        begun = time.monotonic()
        try:
            stalled_jobs = list(
                await app.job_manager.get_stalled_jobs(task_name=TASK, seconds_since_heartbeat=limit_s)
            )
        except ConnectorException as error:
            log.warning("the database does not answer: %s", error)
            stalled_jobs = []
            await asyncio.sleep(limit_s)
        # while the database itself was away nobody could be heard: whoever is silent twice is
        before, silent = silent, {stalled.id for stalled in stalled_jobs}
        if time.monotonic() - begun > limit_s / BEATS:
            silent.clear()
        for stalled in (stalled for stalled in stalled_jobs if stalled.id in before & silent):
            try:
                await asyncio.to_thread(take_up_stalled, sessions, stalled)
            except SightlineError as error:
                log.warning("delivery %s: %s", stalled.id, error.message)
            except Exception:  # nobody would look after the others any more
                log.exception("delivery %s", stalled.id)


def take_up_stalled(sessions: SessionFactory, stalled: Delivery) -> None:
    """Put back what a silent worker process was at, unless another has done so."""
    at = {"task": TASK, "id": stalled.id, "worker_id": stalled.worker_id}
    with writing(sessions) as session:
        if session.execute(_STILL_STALLED, at).first() is None:
            return
        job = get_job(session, int(str(stalled.task_kwargs["job_id"])))
        if job.state == "running":
            log.warning("the worker of job %s (%s) is silent", job.id, job.kind)
            put_back(session, job)
            return
        forget(session, stalled.id)
        if job.state == "queued":
            deliver(session, job.id, long=is_long(job.kind))
