"""What Sightline proposes to click of found passes: replaced as a whole, and never a measurement."""

from sqlalchemy import (
    Boolean,
    CheckConstraint,
    Column,
    Float,
    ForeignKey,
    Integer,
    String,
    Table,
    UniqueConstraint,
)

from sightline.enums import ProposedPoint
from sightline.infra.database.types import UtcDateTime, enum_check, identity, metadata

# One row a vehicle and point: a place on a frame with its predicted error, or why there is none. Nothing in a
# package, statistic or review reads it; a measurement that was confirmed holds its points itself.
proposals = Table(
    "proposals",
    metadata,
    identity(),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False, index=True),
    Column("vehicle_id", ForeignKey("vehicles.id"), nullable=False),
    Column("pose_id", ForeignKey("road_poses.id"), nullable=False),
    Column("point", String(20), nullable=False),
    Column("frame", Integer),
    Column("x_px", Float),
    Column("y_px", Float),
    Column("expected_px", Float),
    # a key of the catalogue of messages
    Column("reason", String(60)),
    Column("code_version", String(60), nullable=False),
    # drawn to be measured free: kept, and shown to nobody
    Column("withheld", Boolean, nullable=False),
    Column("created_at", UtcDateTime, nullable=False),
    UniqueConstraint("vehicle_id", "point"),
    enum_check("point", ProposedPoint),
    CheckConstraint(
        "(reason IS NULL AND frame IS NOT NULL AND x_px IS NOT NULL AND y_px IS NOT NULL "
        "AND expected_px > 0) OR "
        "(reason IS NOT NULL AND x_px IS NULL AND y_px IS NULL AND expected_px IS NULL)",
        name="place_or_reason",
    ),
)
