"""What a click on a recording needs to become a height, in one query: pose in force, survey's insets."""

from collections.abc import Mapping
from dataclasses import dataclass

from sqlalchemy import select
from sqlalchemy.orm import Session

from backend.storage.records import Inset
from backend.storage.rows import missing
from backend.storage.tables import recordings, road_poses, surveys


@dataclass(frozen=True, slots=True)
class ClickContext:
    """`pose_id` and `calibration_id` are None while the recording has no road pose."""

    recording_id: int
    survey_id: int
    name: str
    pose_id: int | None
    calibration_id: int | None
    size_px: tuple[int | None, int | None]
    insets: Mapping[str, Inset]


def of_recording(session: Session, recording_id: int) -> ClickContext:
    """The context of clicks on a recording. Raises NotFound (also when it was deleted)."""
    query = (
        select(
            recordings.c.survey_id,
            recordings.c.name,
            recordings.c.pose_id,
            road_poses.c.calibration_id,
            recordings.c.width_px,
            recordings.c.height_px,
            surveys.c.insets,
        )
        .join(surveys, surveys.c.id == recordings.c.survey_id)
        .outerjoin(road_poses, road_poses.c.id == recordings.c.pose_id)
        .where(recordings.c.id == recording_id, recordings.c.deleted_at.is_(None))
    )
    row = session.execute(query).one_or_none()
    if row is None:
        raise missing("recording", recording_id)
    insets = {target: Inset(**values) for target, values in row.insets.items()}
    pose, size_px = (row.pose_id, row.calibration_id), (row.width_px, row.height_px)
    return ClickContext(recording_id, row.survey_id, row.name, *pose, size_px, insets)
