"""The record of heights computed again in one go; rows are only added. Its revisions name it."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from sightline.enums import ComputingCause, ComputingKind
from sightline.infra.audit.written import written_once
from sightline.infra.version import code_version
from sightline.measurements.again.differences import HeightChange
from sightline.measurements.again.query import get_computing
from sightline.measurements.again.records import Computing
from sightline.measurements.store import ComputedAgain
from sightline.measurements.tables import computings


@dataclass(frozen=True, slots=True, kw_only=True)
class Changed(ComputedAgain):
    """A revision to come, and why it is another height."""

    causes: tuple[ComputingCause, ...] = ()

    @property
    def change(self) -> HeightChange:
        then, now_ = self.before.values, self.values
        return HeightChange(
            then_m=then.height_m,
            u_then_m=then.u_height_m,
            now_m=now_.height_m,
            causes=self.causes,
            verdict_goes_over=self.verdict_of_revision is not None,
        )


def add_computing(
    session: Session,
    survey_id: int,
    changes: Sequence[HeightChange],
    *,
    kind: ComputingKind,
    undoes: int | None = None,
    kept: int = 0,
    actor: int | None,
) -> Computing:
    """Store the record that holds revisions together; these are written after it, in the same transaction."""
    content: dict[str, Any] = {
        "survey_id": survey_id,
        "kind": kind,
        "undoes": undoes,
        "heights": len(changes),
        "to_review": 0 if kind == "undo" else sum(one.to_review for one in changes),
        "kept": kept,
        "largest_m": max((one.size_m for one in changes if one.size_m is not None), default=None),
        "causes": dict(Counter(cause for one in changes for cause in one.causes)),
        "code_version": code_version(),
    }
    return get_computing(session, written_once(session, computings, content, "create", actor=actor))
