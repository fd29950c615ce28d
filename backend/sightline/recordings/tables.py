"""The table of recordings."""

from sqlalchemy import BigInteger, CheckConstraint, Column, ForeignKey, String

from sightline.infra.database.types import (
    NEEDS_MEDIA,
    UtcDateTime,
    columns_for,
    made_columns,
    numbered_table,
)
from sightline.recordings.records import Recording

recordings = numbered_table(
    "recordings",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    *columns_for(Recording, {"name": 400}, only="name state error"),
    Column("media_key", String(400), nullable=False, index=True, info=NEEDS_MEDIA),
    *columns_for(Recording, {"sha256": 64}, only="sha256"),
    Column("size_bytes", BigInteger, nullable=False),
    *columns_for(Recording, only="width_px height_px frame_count duration_s"),
    *columns_for(Recording, {"codec": 60, "container": 60}, only="codec container vfr notes report thumbs"),
    Column("camera_id", ForeignKey("cameras.id")),
    # a pose is made from a recording and serves recordings: this one is added last
    Column("pose_id", ForeignKey("road_poses.id", use_alter=True)),
    *columns_for(
        Recording,
        {"time_zone": 60, "weather": 100},
        only="lighting lighting_proposed stream_number filmed_hz start_proposed started_at time_zone "
        "weather street_lighting drift drift_decision",
    ),
    *made_columns(),
    Column("deleted_at", UtcDateTime),
    CheckConstraint("(started_at IS NULL) = (time_zone IS NULL)", name="start_has_zone"),
    CheckConstraint("state <> 'ready' OR frame_count IS NOT NULL", name="ready_has_frames"),
    CheckConstraint("state <> 'failed' OR error IS NOT NULL", name="failed_has_error"),
)
