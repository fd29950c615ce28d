"""The tables of calibrations and of their pictures."""

from sqlalchemy import CheckConstraint, Column, ForeignKey, Integer, String

from sightline.cameras.calibrations.records import Detection, NewCalibration
from sightline.infra.audit.vouched import table_written_once
from sightline.infra.database.types import NEEDS_MEDIA, columns_for, made_columns, numbered_table

calibration_images = numbered_table(
    "calibration_images",
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("media_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("width_px", Integer, nullable=False),
    Column("height_px", Integer, nullable=False),
    *columns_for(Detection, {"dictionary": 40}),
    *made_columns(),
    CheckConstraint("found OR reason IS NOT NULL", name="missed_has_reason"),
    # events and calibrations name an image by number after it was taken out
    sqlite_autoincrement=True,
)


calibrations = table_written_once(
    "calibrations",
    "calibration",
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    *columns_for(NewCalibration, keys={"recording_id": "recordings.id"}),
)
