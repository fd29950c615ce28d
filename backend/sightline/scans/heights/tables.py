"""The table of the poses of line cameras from rod marks; heights are in `measurements`."""

from sqlalchemy import CheckConstraint, Column, ForeignKey, Integer, UniqueConstraint

from sightline.infra.audit.vouched import table_written_once
from sightline.infra.database.types import columns_for
from sightline.scans.heights.records import LinePoseValues

# One row a calibration of a scan's camera 1 with the rod; the newest of a scan counts. Written once.
line_poses = table_written_once(
    "line_poses",
    "line_pose",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    *columns_for(LinePoseValues, {"code_version": 60}),
    UniqueConstraint("scan_id", "revision"),
    CheckConstraint("revision >= 1", name="revision_counts"),
)
