"""The table of cameras."""

from sqlalchemy import (
    Column,
    ForeignKey,
    String,
    Table,
    Text,
)

from sightline.infra.database.types import identity, made_columns, metadata

cameras = Table(
    "cameras",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("name", String(200), nullable=False),
    Column("notes", Text, nullable=False),
    # what calibration holds for: lens, and its zoom and focus, in words
    Column("lens", String(200), nullable=False),
    Column("zoom", String(100), nullable=False),
    Column("focus", String(100), nullable=False),
    # the survey and camera that it was taken from with its calibration; empty for one of this survey's own
    Column("taken_from", String(500), nullable=False),
    # cameras and calibrations point at each other: this one is added last
    Column("current_calibration_id", ForeignKey("calibrations.id", use_alter=True)),
    *made_columns(),
)
