"""The table of rig calibrations: passes of a staff or board through both planes, and what they give."""

from sqlalchemy import CheckConstraint, Column, ForeignKey, Integer, Table, UniqueConstraint

from sightline.infra.audit.vouched import WrittenOnce, vouched
from sightline.infra.database.types import columns_for, identity, made_columns, metadata
from sightline.scans.rig.records import RigCalibrationValues

# One row a calibration; the scan's rig took its values when it was stored. Written once.
rig_calibrations = Table(
    "rig_calibrations",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    *columns_for(RigCalibrationValues, {"code_version": 60}),
    *made_columns(),
    UniqueConstraint("scan_id", "revision"),
    CheckConstraint("revision >= 1", name="revision_counts"),
    info=vouched(WrittenOnce("rig_calibration")),
)
