"""Handlers of the tests, and workers that know them: `python -m tests.infra.jobs.handlers PARENT_PID`."""

import os
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sqlalchemy.orm import Session

from sightline.errors import BadInput, Stopped
from sightline.infra.database.engine import DatabaseAway
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import request_job_cancel
from sightline.infra.jobs.workers import run_workers
from sightline.media.store.s3 import StorageAway
from sightline.messages.said import Said
from sightline.settings import load_settings
from sightline.surveys.store import create_survey


@registry.handler("test_make_survey")
def make_survey(context: registry.JobContext) -> registry.Outcome:
    """Takes as long as asked on its first attempt, then makes one survey together with the job's end."""
    (Path(context.payload["folder"]) / f"attempt-{context.job.attempts}").write_text(str(os.getpid()))
    until = time.monotonic() + (context.payload["first_s"] if context.job.attempts == 1 else 0.2)
    while time.monotonic() < until:
        context.progress(0.5, Said("said", sentence="Half way."))
        time.sleep(0.02)

    def finish(session: Session) -> Mapping[str, Any]:
        made = create_survey(session, name=context.payload["name"], actor=context.actor)
        return {"survey_id": made.id}

    return finish


@registry.handler("test_away")
def meet_an_outage(context: registry.JobContext) -> registry.Outcome:
    """Finds the storage or the database away, maybe after it was asked to stop."""
    if context.payload.get("cancel"):
        with context.services.writing() as session:
            request_job_cancel(session, context.job.id, actor=None)
    if context.payload["what"] == "storage":
        raise StorageAway("store-no-answer", key="k", name="Timeout")
    raise DatabaseAway("database-no-answer")


def _mark(session: Session, job: Job, error: Said) -> None:
    create_survey(session, name=f"{job.kind}: {error}", actor=None)


@registry.handler("test_fail", failed=_mark)
def fail(context: registry.JobContext) -> registry.Outcome:
    """Ends as the payload says."""
    match context.payload["how"]:
        case "input":
            raise BadInput("said", sentence="The video has no picture; upload another.")
        case "program":
            raise ZeroDivisionError
        case "in_finish":
            return _broken_finish
        case _:
            os._exit(9)


def _break(session: Session, job: Job, error: Said) -> None:
    _mark(session, job, error)
    raise ZeroDivisionError


@registry.handler("test_unclean", failed=_break)
def fail_uncleanly(context: registry.JobContext) -> registry.Outcome:
    """The same as `test_fail`, of a kind whose `failed` is broken."""
    return fail(context)


def _broken_finish(session: Session) -> Mapping[str, Any]:
    create_survey(session, name="half there", actor=None)
    raise BadInput("said", sentence="The result cannot be stored; try again.")


@registry.handler("test_wait", failed=_mark)
def wait(context: registry.JobContext) -> registry.Outcome:
    """Goes on until it is told to stop."""
    while not context.is_cancelled():
        context.progress(0.25, Said("said", sentence="Waiting."))
        time.sleep(0.02)
    raise Stopped("said", sentence="Cancelled.")


@registry.handler("test_long", long=True)
def go_on(context: registry.JobContext) -> registry.Outcome:
    """The same as `test_wait`, of a kind that keeps others waiting."""
    return wait(context)


if __name__ == "__main__":
    run_workers(load_settings(), parent=int(sys.argv[1]), load_handlers=lambda: None)
