"""Which heights of a survey's line scans come out as others with the facts that hold now, or were others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields

from sightline.enums import Category, ComputingCause
from sightline.infra.database import Session
from sightline.linescan.line_height import LineHeight
from sightline.linescan.line_pose import LinePose
from sightline.measurements.again.differences import (
    HeightChange,
    causes_of_numbers,
    same_inset,
    verdict_still_holds,
)
from sightline.measurements.again.service import Tell, untold
from sightline.scans.again.query import current_line_poses_of_survey
from sightline.scans.heights.poses import pose_of
from sightline.scans.heights.records import LineHeightValues, StoredLineHeight
from sightline.scans.heights.service import (
    RowClicks,
    answer,
    clicks_to_compute_again,
    filled_in,
    height_values,
    remarks_on_clicks,
)
from sightline.scans.heights.store import (
    LineComputedAgain,
    line_heights_of_computing,
    standing_line_heights,
)
from sightline.surveys.records import Inset
from sightline.surveys.store import get_survey

_LENGTHS = tuple(one.name for one in fields(LineHeightValues) if one.name.endswith("_m"))
_EVERY = 50  # heights between two reports of progress


@dataclass(frozen=True, slots=True, kw_only=True)
class LineChanged(LineComputedAgain):
    """A revision to come, and why it is another height."""

    causes: tuple[ComputingCause, ...] = ()

    @property
    def change(self) -> HeightChange:
        then, now = self.before.values, self.values
        return HeightChange(
            then_m=then.height_m,
            u_then_m=then.u_height_m,
            now_m=now.height_m,
            causes=self.causes,
            verdict_goes_over=self.verdict_of_id is not None,
        )


@dataclass(eq=False)
class LineAnswers:
    """Heights by calibration and clicks: computed outside the transaction, only looked up in it."""

    known: dict[tuple[int, RowClicks], LineHeight] = field(default_factory=dict)

    def of(self, pose_id: int, pose: LinePose, clicks: RowClicks) -> LineHeight:
        """The height of these clicks."""
        if (pose_id, clicks) not in self.known:
            self.known[pose_id, clicks] = answer(pose, clicks)
        return self.known[pose_id, clicks]


def line_changes_to_come(
    session: Session, survey_id: int, answers: LineAnswers, *, tell: Tell = untold
) -> list[LineChanged]:
    """The standing heights of line scans that come out as others with the facts that hold now.

    Raises NotFound.
    """
    standing = standing_line_heights(session, survey_id)
    computed = _computed(session, survey_id, standing, answers)
    found: list[LineChanged] = []
    for at, (one, values) in enumerate(zip(standing, computed, strict=True)):
        if at % _EVERY == 0:
            tell(at / len(standing))
        causes = causes_of_line_height(one.values, values)
        if causes:
            holds = verdict_still_holds(one.review.verdict, one.values, values)
            judged = one.judged_id if holds else None
            found.append(LineChanged(before=one, values=values, causes=causes, verdict_of_id=judged))
    return found


def _computed(
    session: Session, survey_id: int, standing: Sequence[StoredLineHeight], answers: LineAnswers
) -> Iterator[LineHeightValues]:
    """The content of each with the calibration and the inset that hold now; remarks on the clicks stay."""
    insets = get_survey(session, survey_id).insets
    poses = {
        scan_id: (stored.id, pose_of(stored.values))
        for scan_id, stored in current_line_poses_of_survey(session, survey_id).items()
    }
    for one in standing:
        pose_id, pose = poses[one.scan_id]
        clicks = clicks_now(one.values, insets, one.category)
        found = answers.of(pose_id, pose, clicks)
        yield height_values(pose_id, clicks, found, remarks_on_clicks(one.values))


def clicks_now(values: LineHeightValues, insets: Mapping[str, Inset], category: Category | None) -> RowClicks:
    """The clicks of a stored revision with the inset that holds now; one of its own stays."""
    clicks = filled_in(clicks_to_compute_again(values), insets, category)
    if clicks is None:
        raise ValueError("a stored eye has an inset of its own or a side")
    return clicks


def causes_of_line_height(then: LineHeightValues, now: LineHeightValues) -> tuple[ComputingCause, ...]:
    """Why a height computed again is another one; none where it is the same."""
    found: list[ComputingCause] = []
    if then.pose_id != now.pose_id:
        found.append("pose")
    if not same_inset(then, now):
        found.append("inset")
    if found:
        return tuple(found)
    return causes_of_numbers(then, now, _LENGTHS, (then.status, then.warnings) == (now.status, now.warnings))


def line_changes_back(session: Session, computing_id: int) -> tuple[list[LineChanged], int]:
    """The heights as they were before a computing, and how many were changed since and stay as they are.

    What was rejected since stays rejected.
    """
    made = line_heights_of_computing(session, computing_id)
    changed = [_back(before, newest) for before, one, newest in made if one.values == newest.values]
    return changed, len(made) - len(changed)


def _back(before: StoredLineHeight, standing: StoredLineHeight) -> LineChanged:
    rejected = standing.review.verdict == "rejected"
    judged = standing.judged_id if rejected else before.judged_id
    return LineChanged(before=standing, values=before.values, verdict_of_id=judged)
