"""What Sightline proposes to click of found passes: replaced as a whole, and never a measurement."""

from sqlalchemy import CheckConstraint, Column, Float, ForeignKey, String, UniqueConstraint

from sightline.infra.database.types import UtcDateTime, columns_for, numbered_table
from sightline.vehicles.proposing.records import PointProposal

# One row a vehicle and point: a place on a frame with its predicted error, or why there is none. Nothing in a
# package, statistic or review reads it; a measurement that was confirmed holds its points itself.
proposals = numbered_table(
    "proposals",
    Column("recording_id", ForeignKey("recordings.id"), nullable=False, index=True),
    Column("pose_id", ForeignKey("road_poses.id"), nullable=False),
    *columns_for(PointProposal, {"reason": 60}, {"vehicle_id": "vehicles.id"}, left_out=("point_px",)),
    Column("x_px", Float),
    Column("y_px", Float),
    Column("code_version", String(60), nullable=False),
    Column("created_at", UtcDateTime, nullable=False),
    UniqueConstraint("vehicle_id", "point"),
    CheckConstraint(
        "(reason IS NULL AND frame IS NOT NULL AND x_px IS NOT NULL AND y_px IS NOT NULL "
        "AND expected_px > 0) OR "
        "(reason IS NOT NULL AND x_px IS NULL AND y_px IS NULL AND expected_px IS NULL)",
        name="place_or_reason",
    ),
)
