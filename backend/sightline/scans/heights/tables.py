"""The table of the poses of line cameras from rod marks; heights are in `measurements`."""

from sqlalchemy import CheckConstraint, Column, Float, ForeignKey, Integer, String, Table, UniqueConstraint

from sightline.infra.audit.vouched import WrittenOnce, vouched
from sightline.infra.database.types import CanonicalJson, identity, made_columns, metadata

# One row a calibration of a scan's camera 1 with the rod; the newest of a scan counts. Written once.
line_poses = Table(
    "line_poses",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    # {distance_m, height_m, row_px, line} each
    Column("marks", CanonicalJson, nullable=False),
    Column("sigma_px", Float),
    Column("u_distance_m", Float, nullable=False),
    Column("u_lean_rad", Float, nullable=False),
    # {parameters, covariance, row_span}
    Column("pose", CanonicalJson, nullable=False),
    Column("camera_height_m", Float, nullable=False),
    Column("u_camera_height_m", Float, nullable=False),
    Column("rms_px", Float, nullable=False),
    Column("code_version", String(60), nullable=False),
    *made_columns(),
    UniqueConstraint("scan_id", "revision"),
    CheckConstraint("revision >= 1", name="revision_counts"),
    info=vouched(WrittenOnce("line_pose")),
)
