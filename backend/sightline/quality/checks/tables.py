"""The table of pairs of tyre contacts."""

from sqlalchemy import (
    BigInteger,
    Boolean,
    Column,
    Float,
    ForeignKey,
    Integer,
    Table,
)

from sightline.infra.database.types import Moment, identity, metadata

# Both tyre contacts of a vehicle on one frame: its direction of travel. The newest row of a vehicle counts.
wheel_pairs = Table(
    "wheel_pairs",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False),
    Column("vehicle_id", ForeignKey("vehicles.id"), nullable=False, index=True),
    Column("frame", Integer, nullable=False),
    Column("pts", BigInteger, nullable=False),
    Column("time_s", Float, nullable=False),
    Column("crc32", BigInteger, nullable=False),
    Column("first_x_px", Float, nullable=False),
    Column("first_y_px", Float, nullable=False),
    Column("second_x_px", Float, nullable=False),
    Column("second_y_px", Float, nullable=False),
    Column("withdrawn", Boolean, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
)
