"""The table of rig calibrations: passes of a staff or board through both planes, and what they give."""

from sqlalchemy import CheckConstraint, Column, Float, ForeignKey, Integer, String, Table, UniqueConstraint

from sightline.infra.audit.vouched import WrittenOnce, vouched
from sightline.infra.database.types import CanonicalJson, identity, made_columns, metadata

# One row a calibration; the scan's rig took its values when it was stored. Written once.
rig_calibrations = Table(
    "rig_calibrations",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    # the fields of a linescan RigPass each
    Column("passes", CanonicalJson, nullable=False),
    Column("line_rate_hz", Float, nullable=False),
    Column("u_line_rate_ratio", Float, nullable=False),
    Column("u_tape_ratio", Float, nullable=False),
    Column("u_speed_ratio", Float, nullable=False),
    Column("baseline_m", Float, nullable=False),
    Column("u_baseline_m", Float, nullable=False),
    Column("divergence_rad", Float, nullable=False),
    Column("u_divergence_rad", Float, nullable=False),
    Column("baseline_correlation", Float, nullable=False),
    Column("chi2", Float, nullable=False),
    Column("degrees_of_freedom", Integer, nullable=False),
    Column("p_value", Float, nullable=False),
    Column("code_version", String(60), nullable=False),
    *made_columns(),
    UniqueConstraint("scan_id", "revision"),
    CheckConstraint("revision >= 1", name="revision_counts"),
    info=vouched(WrittenOnce("rig_calibration")),
)
