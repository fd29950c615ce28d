"""Which heights of a survey's line scans come out as others with the facts that hold now, or were others."""

from collections.abc import Iterator, Sequence

from sightline.infra.database import Session
from sightline.linescan.line_height import LineHeight
from sightline.measurements.again.service import Tell, changes_among, ignore_progress
from sightline.measurements.again.store import Changed
from sightline.measurements.height_of_clicks import filled_in
from sightline.measurements.records import Clicks, ScanHeight, ScanHeightValues
from sightline.scans.again.query import current_line_poses_of_survey
from sightline.scans.heights.poses import pose_of
from sightline.scans.heights.service import answer, clicks_to_compute_again, height_values, remarks_on_clicks
from sightline.scans.heights.store import standing_scan_heights
from sightline.surveys.store import get_survey

_EVERY = 50  # heights between two reports of progress


#: Heights by calibration and clicks: computed outside the transaction, only looked up in it.
LineAnswers = dict[tuple[int, Clicks], LineHeight]


def line_changes_to_come(
    session: Session, survey_id: int, answers: LineAnswers, *, tell: Tell = ignore_progress
) -> list[Changed]:
    """The standing heights of line scans that come out otherwise with the facts of now. Raises NotFound."""
    standing = standing_scan_heights(session, survey_id)
    computed = _computed(session, survey_id, standing, answers)
    return list(changes_among(standing, computed, _EVERY, tell))


def _computed(
    session: Session, survey_id: int, standing: Sequence[ScanHeight], answers: LineAnswers
) -> Iterator[ScanHeightValues]:
    """The content of each with the calibration and the inset that hold now; remarks on the clicks stay."""
    insets = get_survey(session, survey_id).insets
    poses = {
        scan_id: (stored.id, pose_of(stored.values))
        for scan_id, stored in current_line_poses_of_survey(session, survey_id).items()
    }
    for height in standing:
        pose_id, pose = poses[height.scan_id]
        clicks = filled_in(clicks_to_compute_again(height.values), insets, height.category)
        key = pose_id, clicks
        found = answers[key] = answers[key] if key in answers else answer(pose, clicks)
        yield height_values(pose_id, clicks, found, remarks_on_clicks(height.values))
