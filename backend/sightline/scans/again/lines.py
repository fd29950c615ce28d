"""Which heights of a survey's line scans come out as others with the facts that hold now, or were others."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from sightline.infra.database import Session
from sightline.linescan.line_height import LineHeight
from sightline.linescan.line_pose import LinePose
from sightline.measurements.again.service import Tell, changed_by, untold
from sightline.measurements.again.store import Changed
from sightline.measurements.height_of_clicks import filled_in
from sightline.measurements.records import Clicks, ScanHeight, ScanHeightValues
from sightline.scans.again.query import current_line_poses_of_survey
from sightline.scans.heights.poses import pose_of
from sightline.scans.heights.service import answer, clicks_to_compute_again, height_values, remarks_on_clicks
from sightline.scans.heights.store import standing_scan_heights
from sightline.surveys.store import get_survey

_EVERY = 50  # heights between two reports of progress


@dataclass(eq=False)
class LineAnswers:
    """Heights by calibration and clicks: computed outside the transaction, only looked up in it."""

    known: dict[tuple[int, Clicks], LineHeight] = field(default_factory=dict)

    def of(self, pose_id: int, pose: LinePose, clicks: Clicks) -> LineHeight:
        """The height of these clicks."""
        if (pose_id, clicks) not in self.known:
            self.known[pose_id, clicks] = answer(pose, clicks)
        return self.known[pose_id, clicks]


def line_changes_to_come(
    session: Session, survey_id: int, answers: LineAnswers, *, tell: Tell = untold
) -> list[Changed]:
    """The standing heights of line scans that come out as others with the facts that hold now.

    Raises NotFound.
    """
    standing = standing_scan_heights(session, survey_id)
    computed = _computed(session, survey_id, standing, answers)
    found: list[Changed] = []
    for at, (one, values) in enumerate(zip(standing, computed, strict=True)):
        if at % _EVERY == 0:
            tell(at / len(standing))
        changed = changed_by(one, values)
        if changed is not None:
            found.append(changed)
    return found


def _computed(
    session: Session, survey_id: int, standing: Sequence[ScanHeight], answers: LineAnswers
) -> Iterator[ScanHeightValues]:
    """The content of each with the calibration and the inset that hold now; remarks on the clicks stay."""
    insets = get_survey(session, survey_id).insets
    poses = {
        scan_id: (stored.id, pose_of(stored.values))
        for scan_id, stored in current_line_poses_of_survey(session, survey_id).items()
    }
    for one in standing:
        pose_id, pose = poses[one.scan_id]
        clicks = filled_in(clicks_to_compute_again(one.values), insets, one.category)
        found = answers.of(pose_id, pose, clicks)
        yield height_values(pose_id, clicks, found, remarks_on_clicks(one.values))
