"""Which of a survey's measurements come out as other heights with the facts that hold now, and which were
others before; and asking a worker to compute again, or to undo.

The work itself is done in `scans/again`, which knows the heights in line scans too.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sightline.enums import ComputingCause, ComputingKind
from sightline.errors import Conflict
from sightline.geometry.road_pose import RoadPose
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import enqueue
from sightline.infra.version import code_version
from sightline.measurements.again.differences import causes_now, causes_of, verdict_still_holds
from sightline.measurements.again.query import (
    Alike,
    Made,
    contexts_of_survey,
    get_computing,
    group_alike,
    list_computings,
)
from sightline.measurements.again.records import Computing, OutOfDate
from sightline.measurements.again.store import Changed
from sightline.measurements.click_context_query import ClickContext
from sightline.measurements.height_of_clicks import Answer
from sightline.measurements.height_of_clicks import answers as all_answers
from sightline.measurements.records import Clicks, Measurement, MeasurementValues, ScanHeight
from sightline.measurements.service import clicks_in_context, clicks_to_compute_again, pose_in_force
from sightline.measurements.store import list_measurements

KIND = "compute_again"
_EVERY = 200  # heights between two reports of progress
Tell = Callable[[float], None]


def ignore_progress(_fraction: float) -> None:
    """Progress that nobody follows."""


@dataclass(eq=False)
class Answers:
    """Heights by pose and clicks: what was computed outside the transaction is only looked up in it."""

    known: dict[tuple[int, Clicks], Answer] = field(default_factory=dict)

    def compute(self, pose_id: int, pose: RoadPose, asked: Sequence[Clicks]) -> None:
        """Make the heights of these clicks known."""
        new = [one for one in dict.fromkeys(asked) if (pose_id, one) not in self.known]
        self.known |= {(pose_id, one): found for one, found in zip(new, all_answers(pose, new), strict=True)}


def measurements_out_of_date(session: Session, survey_id: int) -> OutOfDate:
    """How many standing measurements follow from other facts than hold now; nothing is computed for it.

    Heights in line scans are not among them. Raises NotFound.
    """
    return count_out_of_date(group_alike(session, survey_id))


def count_out_of_date(groups: Iterable[Alike]) -> OutOfDate:
    """How many heights follow from other facts than hold now."""
    causes: Counter[ComputingCause] = Counter()
    heights = in_line_scans = waiting = other_program = 0
    named: dict[int, tuple[ComputingCause, ...]] = {}
    for group in groups:
        reasons = causes_now(
            group.target,
            group.facts,
            pose_id=group.pose_id,
            side=group.side,
            category=group.category,
            insets=group.insets,
        )
        if reasons:
            heights += group.count
            in_line_scans += group.count if group.in_line_scan else 0
            waiting += 0 if group.has_height else group.count
            causes.update(dict.fromkeys(reasons, group.count))
            named |= {int(one): reasons for one in group.named.split(",") if one}
        elif group.code_version != code_version():
            other_program += group.count
    return OutOfDate(
        heights=heights,
        in_line_scans=in_line_scans,
        waiting=waiting,
        other_program=other_program,
        causes=dict(causes),
        measurements=dict(sorted(named.items())),
    )


def _changed_by(before: Measurement | ScanHeight, values: Any) -> Changed | None:
    """A standing height whose content comes out as `values`; None where that is the same."""
    causes = causes_of(before.values, values)
    if not causes:
        return None
    holds = verdict_still_holds(before.review.verdict, before.values, values)
    judged = before.judged_revision if holds else None
    return Changed(before=before, values=values, causes=causes, verdict_of_revision=judged)


def changes_among(
    standing: Sequence[Measurement | ScanHeight], computed: Iterable[Any], every: int, tell: Tell
) -> Iterator[Changed]:
    """The standing heights whose content comes out otherwise; `tell` hears of each `every` of them."""
    for at, (height, values) in enumerate(zip(standing, computed, strict=True)):
        if at % every == 0:
            tell(at / len(standing))
        changed = _changed_by(height, values)
        if changed is not None:
            yield changed


def measurement_changes_to_come(
    session: Session,
    survey_id: int,
    answers: Answers,
    *,
    only_waiting: bool = False,
    tell: Tell = ignore_progress,
) -> list[Changed]:
    """The standing heights and repeats that come out as others with the facts that hold now.

    A recording without a road pose keeps its heights. `only_waiting`: those alone that have no height and get
    one. Raises NotFound, Conflict for a pose of pictures of another size.
    """
    contexts = contexts_of_survey(session, survey_id)
    standing = [
        one
        for one in list_measurements(session, survey_id, include_repeats=True)
        if one.vehicle_id in contexts and contexts[one.vehicle_id].pose_id is not None
    ]
    if only_waiting:
        standing = [one for one in standing if one.values.height_m is None]
    parts = (standing[at : at + _EVERY] for at in range(0, len(standing), _EVERY))
    computed = (values for some in parts for values in _computed(session, some, contexts, answers))
    found = changes_among(standing, computed, _EVERY, tell)
    return [one for one in found if not only_waiting or one.values.height_m is not None]


def _computed(
    session: Session, some: Sequence[Measurement], contexts: Mapping[int, ClickContext], answers: Answers
) -> Iterator[MeasurementValues]:
    """The content of each with the facts that hold now; what is not known is computed a pose at a time."""
    in_force = [pose_in_force(session, contexts[one.vehicle_id]) for one in some]
    clicks = [
        clicks_in_context(clicks_to_compute_again(one.values), contexts[one.vehicle_id]) for one in some
    ]
    for pose_id, pose in {pose_id: pose for pose, pose_id, _ in in_force}.items():
        answers.compute(
            pose_id, pose, [one for one, of in zip(clicks, in_force, strict=True) if of[1] == pose_id]
        )
    for measurement, clicked, (_, pose_id, calibration_id) in zip(some, clicks, in_force, strict=True):
        yield filled_from(
            MeasurementValues,
            answers.known[pose_id, clicked],
            clicked,
            measurement.values,
            more_frames=measurement.values.more_frames,
            pose_id=pose_id,
            calibration_id=calibration_id,
            code_version=code_version(),
        )


def changes_back(remade: Sequence[Made]) -> tuple[list[Changed], int]:
    """The heights as they were before a computing made them, and how many were changed since and stay as
    they are. What was rejected since stays rejected.
    """
    changed = [_undo_change(this) for this in remade if this.standing.values == this.made.values]
    return changed, len(remade) - len(changed)


def _undo_change(remade: Made) -> Changed:
    rejected = remade.standing.review.verdict == "rejected"
    judged = remade.standing.judged_revision if rejected else remade.before.judged_revision
    return Changed(before=remade.standing, values=remade.before.values, verdict_of_revision=judged)


def require_undoable(session: Session, computing_id: int) -> Computing:
    """Raises NotFound, Conflict saying why it cannot be undone."""
    computing = get_computing(session, computing_id)
    if computing.kind == "undo":
        raise Conflict("computing-undo-of-undo")
    if computing.undone_by is not None:
        raise Conflict("computing-undone-already")
    later = [
        other
        for other in list_computings(session, computing.survey_id)
        if other.id > computing.id and other.kind != "undo" and other.undone_by is None
    ]
    if later:
        raise Conflict("computing-undo-later-first", when=f"{later[0].created_at:%Y-%m-%d %H:%M} UTC")
    return computing


def ask_to_compute(
    session: Session, survey_id: int, *, kind: ComputingKind = "asked", only_waiting: bool = False, actor: int
) -> Job:
    """Have a worker compute a survey's heights again."""
    payload = {"kind": kind, "only_waiting": only_waiting}
    return enqueue(session, KIND, payload, survey_id=survey_id, actor=actor)


def ask_for_waiting(session: Session, survey_id: int, *, actor: int) -> Job | None:
    """Have the eyes computed that waited for the driver's side and know it now, no other height."""
    if measurements_out_of_date(session, survey_id).waiting == 0:
        return None
    return ask_to_compute(session, survey_id, kind="sides", only_waiting=True, actor=actor)


def ask_to_undo(session: Session, computing_id: int, *, actor: int) -> Job:
    """Have a worker put the old heights back. Raises NotFound, Conflict where that cannot be."""
    one = require_undoable(session, computing_id)
    return enqueue(session, KIND, {"undo": computing_id}, survey_id=one.survey_id, actor=actor)
