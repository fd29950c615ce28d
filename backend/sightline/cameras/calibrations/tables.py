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
    Text,
)

from sightline.enums import CalibrationSource
from sightline.infra.audit.vouched import WrittenOnce, vouched
from sightline.infra.database.types import Document, Moment, identity, metadata, one_of

calibration_images = Table(
    "calibration_images",
    metadata,
    identity(),
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("media_key", String(400), nullable=False),
    Column("width_px", Integer, nullable=False),
    Column("height_px", Integer, nullable=False),
    Column("found", Boolean, nullable=False),
    Column("reason", Text),
    Column("corners_px", Document, nullable=False),
    Column("columns", Integer, nullable=False),
    Column("rows", Integer, nullable=False),
    Column("sharpness", Float),
    Column("ids", Document),
    Column("dictionary", String(40)),
    Column("marker_share", Float),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    CheckConstraint("found OR reason IS NOT NULL", name="missed_has_reason"),
)


calibrations = Table(
    "calibrations",
    metadata,
    identity(),
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    Column("source", String(20), nullable=False),
    Column("recording_id", ForeignKey("recordings.id")),
    Column("document", Document, nullable=False),
    Column("trusted", Boolean, nullable=False),
    Column("warnings", Document, nullable=False),
    Column("coverage", Document, nullable=False),
    Column("views", Document, nullable=False),
    Column("summary", Text, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    one_of("source", CalibrationSource),
    info=vouched(WrittenOnce("calibration", "calibration")),
)
