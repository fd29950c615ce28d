"""The record of heights computed again in one go, and its revisions; rows are only added."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from sightline.enums import ComputingCause, ComputingKind
from sightline.infra.audit import trail
from sightline.infra.database.rows import add_row, stored_hash
from sightline.infra.database.types import now
from sightline.infra.version import code_version
from sightline.measurements.again.differences import goes_to_review, largest_change_m
from sightline.measurements.again.query import get_computing
from sightline.measurements.again.records import Computing
from sightline.measurements.store import ComputedAgain, append_computed_again
from sightline.measurements.tables import computings


@dataclass(frozen=True, slots=True, kw_only=True)
class Changed(ComputedAgain):
    """A revision to come, and why it is another height."""

    causes: tuple[ComputingCause, ...] = ()


def add_computing(
    session: Session,
    survey_id: int,
    changed: Sequence[Changed],
    *,
    kind: ComputingKind,
    undoes: int | None = None,
    kept: int = 0,
    actor: int | None,
) -> Computing:
    """Store the revisions and the record that holds them together."""
    pairs = [(one.before.values, one.values) for one in changed]
    sent = [
        one
        for one in changed
        if kind != "undo"
        and one.verdict_of_revision is None
        and goes_to_review(one.before.values, one.values)
    ]
    moment = now()
    content: dict[str, Any] = {
        "survey_id": survey_id,
        "kind": kind,
        "undoes": undoes,
        "heights": len(changed),
        "to_review": len(sent),
        "kept": kept,
        "largest_m": largest_change_m(pairs),
        "causes": dict(Counter(cause for one in changed for cause in one.causes)),
        "code_version": code_version(),
        "created_at": moment,
    }
    computing_id = add_row(session, computings, {**content, "created_by": actor})
    after = {**content, "content_sha256": stored_hash(session, computings, computing_id)}
    trail.record(session, actor, "create", "computing", computing_id, survey_id, None, after)
    action = "undo" if kind == "undo" else "compute_again"
    append_computed_again(session, survey_id, computing_id, changed, action=action, actor=actor)
    return get_computing(session, computing_id)
