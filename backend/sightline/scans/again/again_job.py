"""The job that computes a survey's heights again, or puts the old ones back: all of them, or none."""

from collections.abc import Mapping
from typing import Any

from sightline.infra.database import Session
from sightline.infra.jobs.registry import JobContext, Outcome, handler
from sightline.measurements.again.records import Computing
from sightline.measurements.again.service import KIND
from sightline.messages.said import Said
from sightline.scans.again.service import AllAnswers, changes_to_come, compute_again, undo_computing

_WRITING = 0.9  # of the progress; writing is one transaction that tells none


@handler(KIND, long=True)
def run_compute_again(context: JobContext) -> Outcome:
    """Compute outside the transaction; in it only what changed meanwhile is computed once more."""
    asked, survey_id = context.payload, context.job.survey_id
    if survey_id is None:
        raise ValueError("heights are computed again for a survey")
    if asked.get("undo"):
        context.progress(0.1, Said("job-heights-restoring"))
        return lambda session: _result(undo_computing(session, int(asked["undo"]), actor=context.actor))
    answers = AllAnswers()
    only_waiting = bool(asked.get("only_waiting"))

    def tell(fraction: float) -> None:
        context.progress(_WRITING * fraction, Said("job-heights-computing"))

    with context.services.reading() as session:
        changes_to_come(session, survey_id, answers, only_waiting=only_waiting, tell=tell)
    context.progress(_WRITING, Said("job-heights-saving"))

    def store(session: Session) -> Mapping[str, Any]:
        return _result(
            compute_again(
                session,
                survey_id,
                kind=asked.get("kind", "asked"),
                only_waiting=only_waiting,
                answers=answers,
                actor=context.actor,
            )
        )

    return store


def _result(made: Computing | None) -> dict[str, Any]:
    if made is None:
        return {"computing_id": None, "heights": 0}
    return {"computing_id": made.id, "heights": made.heights, "to_review": made.to_review, "kept": made.kept}
