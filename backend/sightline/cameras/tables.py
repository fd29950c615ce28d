"""The table of cameras."""

from sqlalchemy import Column, ForeignKey, String

from sightline.cameras.records import CameraWords
from sightline.infra.database.types import columns_for, made_columns, numbered_table

cameras = numbered_table(
    "cameras",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    # its name, and what calibration holds for: lens, and its zoom and focus, in words
    *columns_for(CameraWords, {"name": 200, "lens": 200, "zoom": 100, "focus": 100}),
    # the survey and camera that it was taken from with its calibration; empty for one of this survey's own
    Column("taken_from", String(500), nullable=False),
    # cameras and calibrations point at each other: this one is added last
    Column("current_calibration_id", ForeignKey("calibrations.id", use_alter=True)),
    *made_columns(),
)
