"""Heights in line scans as they go out."""

from collections.abc import Sequence

from sightline.coverage import expanded
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.measurements.records import ScanHeight
from sightline.scans.heights.bodies import ScanHeightBody
from sightline.scans.heights.pose_store import current_line_poses
from sightline.scans.heights.service import causes_now_of_scan
from sightline.scans.heights.store import revisions_of_own_clicks
from sightline.surveys.store import get_survey


def scan_height_bodies(session: Session, heights: Sequence[ScanHeight], asker: int) -> list[ScanHeightBody]:
    """Revisions of one survey's heights, and what the asker is told of them."""
    if not heights:
        return []
    poses = ((id_, current_line_poses(session, id_)) for id_ in {height.scan_id for height in heights})
    pose_ids = {id_: None if pose is None else pose.id for id_, pose in poses}
    insets = get_survey(session, heights[0].survey_id).insets
    own = revisions_of_own_clicks(session, [height.revision_id for height in heights], asker)
    return [
        filled_from(
            ScanHeightBody,
            height,
            height.values,
            older=bool(causes_now_of_scan(height.values, pose_ids[height.scan_id], insets, height.category)),
            U95_distance_m=expanded(height.values.u_distance_m),
            mine=height.revision_id in own,
        )
        for height in heights
    ]
