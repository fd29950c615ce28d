"""The table of recordings."""

from sqlalchemy import BigInteger, Boolean, CheckConstraint, Column, Float, ForeignKey, Integer, String

from sightline.enums import Lighting, RecordingState, StreetLighting
from sightline.infra.database.types import (
    NEEDS_MEDIA,
    CanonicalJson,
    Saying,
    UtcDateTime,
    enum_check,
    made_columns,
    numbered_table,
)

recordings = numbered_table(
    "recordings",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("state", String(20), nullable=False),
    Column("error", Saying),
    Column("media_key", String(400), nullable=False, index=True, info=NEEDS_MEDIA),
    Column("sha256", String(64), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    Column("width_px", Integer),
    Column("height_px", Integer),
    Column("frame_count", Integer),
    Column("duration_s", Float),
    Column("codec", String(60)),
    Column("container", String(60)),
    Column("vfr", Boolean, nullable=False),
    Column("notes", Saying, nullable=False),
    Column("report", CanonicalJson, nullable=False),
    Column("thumbs", CanonicalJson, nullable=False),
    Column("camera_id", ForeignKey("cameras.id")),
    # a pose is made from a recording and serves recordings: this one is added last
    Column("pose_id", ForeignKey("road_poses.id", use_alter=True)),
    Column("lighting", String(20)),
    Column("lighting_proposed", String(20)),
    # of a file with several pictures, the one that is read; frames per second when it was filmed, where a
    # person had to say
    Column("stream_number", Integer),
    Column("filmed_hz", Float),
    # when its first frame was filmed: as the file states, and as a person said, with the zone of the clocks
    Column("start_proposed", UtcDateTime),
    Column("started_at", UtcDateTime),
    Column("time_zone", String(60)),
    Column("weather", String(100)),
    Column("street_lighting", String(20)),
    # whether the camera moved since its pose was taken, and what a person decided about it
    Column("drift", CanonicalJson),
    Column("drift_decision", CanonicalJson),
    *made_columns(),
    Column("deleted_at", UtcDateTime),
    enum_check("state", RecordingState),
    enum_check("lighting", Lighting),
    enum_check("lighting_proposed", Lighting),
    enum_check("street_lighting", StreetLighting),
    CheckConstraint("(started_at IS NULL) = (time_zone IS NULL)", name="start_has_zone"),
    CheckConstraint("state <> 'ready' OR frame_count IS NOT NULL", name="ready_has_frames"),
    CheckConstraint("state <> 'failed' OR error IS NOT NULL", name="failed_has_error"),
)
