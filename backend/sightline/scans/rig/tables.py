"""The table of rig calibrations: passes of a staff or board through both planes, and what they give."""

from sqlalchemy import CheckConstraint, Column, ForeignKey, Integer, UniqueConstraint

from sightline.infra.audit.vouched import table_written_once
from sightline.infra.database.types import columns_for
from sightline.scans.rig.records import RigCalibrationValues

# One row a calibration; the scan's rig took its values when it was stored. Written once.
rig_calibrations = table_written_once(
    "rig_calibrations",
    "rig_calibration",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    *columns_for(RigCalibrationValues, {"code_version": 60}),
    UniqueConstraint("scan_id", "revision"),
    CheckConstraint("revision >= 1", name="revision_counts"),
)
