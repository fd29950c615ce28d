"""The table of camera poses."""

from sqlalchemy import CheckConstraint, Column, ForeignKey

from sightline.infra.audit.vouched import table_written_once
from sightline.infra.database.types import columns_for
from sightline.poses.records import NewPose

# A pose turned about the road's normal after the traffic's own direction is of another one, and so is a pose
# adjusted by its traffic's known lengths; the account of the latter is in its document.
_KEYS = {
    "calibration_id": "calibrations.id",
    "turned_from": "road_poses.id",
    "adjusted_from": "road_poses.id",
}

road_poses = table_written_once(
    "road_poses",
    "pose",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False),
    *columns_for(NewPose, keys=_KEYS),
    CheckConstraint("first_frame >= 0 AND last_frame >= first_frame", name="span_forward"),
)
