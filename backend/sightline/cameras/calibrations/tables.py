"""The tables of calibrations and of their pictures."""

from sqlalchemy import (
    Boolean,
    CheckConstraint,
    Column,
    Float,
    ForeignKey,
    Integer,
    String,
    Table,
)

from sightline.enums import CalibrationSource
from sightline.infra.audit.vouched import WrittenOnce, vouched
from sightline.infra.database.types import (
    NEEDS_MEDIA,
    CanonicalJson,
    Saying,
    enum_check,
    identity,
    made_columns,
    metadata,
)

calibration_images = Table(
    "calibration_images",
    metadata,
    identity(),
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("media_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("width_px", Integer, nullable=False),
    Column("height_px", Integer, nullable=False),
    Column("found", Boolean, nullable=False),
    Column("reason", Saying),
    Column("corners_px", CanonicalJson, nullable=False),
    Column("columns", Integer, nullable=False),
    Column("rows", Integer, nullable=False),
    Column("sharpness", Float),
    Column("ids", CanonicalJson),
    Column("dictionary", String(40)),
    Column("marker_share", Float),
    *made_columns(),
    CheckConstraint("found OR reason IS NOT NULL", name="missed_has_reason"),
)


calibrations = Table(
    "calibrations",
    metadata,
    identity(),
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    Column("source", String(20), nullable=False),
    Column("recording_id", ForeignKey("recordings.id")),
    Column("document", CanonicalJson, nullable=False),
    Column("trusted", Boolean, nullable=False),
    Column("warnings", Saying, nullable=False),
    Column("coverage", CanonicalJson, nullable=False),
    Column("views", CanonicalJson, nullable=False),
    Column("summary", Saying, nullable=False),
    *made_columns(),
    enum_check("source", CalibrationSource),
    info=vouched(WrittenOnce("calibration")),
)
