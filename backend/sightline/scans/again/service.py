"""Computing a survey's heights again with the facts that hold now, and putting the old ones back: those of
recordings and those of line scans, as one computing.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import chain

from sightline.enums import AuditAction, ComputingKind
from sightline.errors import Conflict, NotFound
from sightline.infra.database import Session
from sightline.measurements.again.query import get_computing, group_alike, made_by
from sightline.measurements.again.records import ComputedHeights, Computing, OutOfDate
from sightline.measurements.again.service import (
    Answers,
    Tell,
    changes_back,
    count_out_of_date,
    ignore_progress,
    measurement_changes_to_come,
    require_undoable,
)
from sightline.measurements.again.store import Changed, add_computing
from sightline.measurements.store import append_computed_again
from sightline.scans.again.lines import LineAnswers, line_changes_to_come
from sightline.scans.again.query import alike_lines, computed_heights
from sightline.scans.heights.store import scan_heights_made_by

_MOST_LISTED = 2000


@dataclass(eq=False)
class AllAnswers:
    """What was computed outside the transaction, to be only looked up in it."""

    frames: Answers = field(default_factory=Answers)
    lines: LineAnswers = field(default_factory=dict)


def out_of_date(session: Session, survey_id: int) -> OutOfDate:
    """How many standing heights follow from other facts than now's; nothing is computed. Raises NotFound."""
    groups = chain(group_alike(session, survey_id), alike_lines(session, survey_id))
    return count_out_of_date(groups)


def changes_to_come(
    session: Session,
    survey_id: int,
    answers: AllAnswers,
    *,
    only_waiting: bool = False,
    tell: Tell = ignore_progress,
) -> list[Changed]:
    """The standing heights that come out as others with the facts that hold now.

    A recording without a road pose keeps its heights. `only_waiting`: those alone that have no height and get
    one; in line scans none waits. Raises NotFound, Conflict for a pose of pictures of another size.
    """
    frames = measurement_changes_to_come(
        session, survey_id, answers.frames, only_waiting=only_waiting, tell=lambda part: tell(part / 2)
    )
    if only_waiting:
        return frames
    return frames + line_changes_to_come(
        session, survey_id, answers.lines, tell=lambda part: tell((1 + part) / 2)
    )


def compute_again(
    session: Session,
    survey_id: int,
    *,
    kind: ComputingKind = "asked",
    only_waiting: bool = False,
    answers: AllAnswers | None = None,
    actor: int | None,
) -> Computing | None:
    """Store every height that comes out as another one as a new revision; None where there is none."""
    changes = changes_to_come(session, survey_id, answers or AllAnswers(), only_waiting=only_waiting)
    return _store_computing(session, survey_id, changes, kind=kind, actor=actor) if changes else None


def undo_computing(session: Session, computing_id: int, *, actor: int | None) -> Computing:
    """Put back the height that each had before, as a new revision.

    What was changed since stays as it is and is counted in `kept`; what was rejected since stays rejected.
    Raises Conflict where a later computing stands, or this one cannot be undone.
    """
    computing = require_undoable(session, computing_id)
    made = [*made_by(session, computing_id), *scan_heights_made_by(session, computing_id)]
    changes, kept = changes_back(made)
    return _store_computing(
        session, computing.survey_id, changes, kind="undo", undoes=computing_id, kept=kept, actor=actor
    )


def _store_computing(
    session: Session,
    survey_id: int,
    changes: Sequence[Changed],
    *,
    kind: ComputingKind,
    undoes: int | None = None,
    kept: int = 0,
    actor: int | None,
) -> Computing:
    """The record of the computing, and after it the revisions that it made."""
    counted = [one.change for one in changes]
    made = add_computing(session, survey_id, counted, kind=kind, undoes=undoes, kept=kept, actor=actor)
    action: AuditAction = "undo" if kind == "undo" else "compute_again"
    append_computed_again(session, survey_id, made.id, changes, action=action, actor=actor)
    return made


def heights_of(session: Session, computing_id: int) -> ComputedHeights:
    """A computing with its heights, old beside new. Raises NotFound."""
    computing = get_computing(session, computing_id)
    heights = list(computed_heights(session, computing_id))
    changes = [row.change_m for row in heights if row.change_m is not None and not row.repeat]
    try:
        require_undoable(session, computing_id)
        why_not = None
    except (Conflict, NotFound) as refused:
        why_not = refused.message
    ordered = sorted(heights, key=lambda row: (not row.to_review, -(row.moved_by_u or 0.0)))
    return ComputedHeights(
        computing=computing,
        listed=tuple(ordered[:_MOST_LISTED]),
        mean_change_m=sum(changes) / len(changes) if changes else None,
        undoable=why_not,
    )
