"""The table of camera poses."""

from sqlalchemy import (
    CheckConstraint,
    Column,
    Float,
    ForeignKey,
    Integer,
    Table,
)

from sightline.infra.audit.vouched import WrittenOnce, vouched
from sightline.infra.database.types import CanonicalJson, Saying, identity, made_columns, metadata

road_poses = Table(
    "road_poses",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False),
    Column("calibration_id", ForeignKey("calibrations.id"), nullable=False),
    Column("first_frame", Integer, nullable=False),
    Column("last_frame", Integer, nullable=False),
    Column("rms_px", Float),
    Column("distance_m", Float),
    Column("summary", Saying, nullable=False),
    Column("document", CanonicalJson, nullable=False),
    Column("warnings", Saying, nullable=False),
    Column("expected", CanonicalJson, nullable=False),
    Column("overlay", CanonicalJson, nullable=False),
    # a pose turned about the road's normal after the traffic's own direction
    Column("turned_from", ForeignKey("road_poses.id")),
    Column("turned_by_rad", Float),
    # a pose adjusted by its traffic's known lengths; the account is in its document
    Column("adjusted_from", ForeignKey("road_poses.id")),
    *made_columns(),
    CheckConstraint("first_frame >= 0 AND last_frame >= first_frame", name="span_forward"),
    info=vouched(WrittenOnce("pose")),
)
