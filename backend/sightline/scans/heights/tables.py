"""The tables of heights in line scans: poses of the line camera from rod marks, and heights of vehicles."""

from sqlalchemy import (
    Boolean,
    CheckConstraint,
    Column,
    Float,
    ForeignKey,
    Index,
    Integer,
    String,
    Table,
    Text,
    UniqueConstraint,
)

from sightline.enums import DriverSide, InsetSource, MeasurementStatus, ScanVerdict, Target
from sightline.infra.audit.vouched import WrittenOnce, vouched
from sightline.infra.database.types import (
    CanonicalJson,
    enum_check,
    identity,
    made_columns,
    metadata,
)

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
    info=vouched(WrittenOnce("line_pose", "calibration of a line camera")),
)

# One row a revision of a target's height; the newest of a vehicle's target counts. Written once.
line_heights = Table(
    "line_heights",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False, index=True),
    Column("vehicle_id", ForeignKey("scan_vehicles.id"), nullable=False),
    Column("target", String(20), nullable=False),
    Column("revision", Integer, nullable=False),
    Column("pose_id", ForeignKey("line_poses.id"), nullable=False),
    Column("contact_line", Float, nullable=False),
    Column("contact_row_px", Float, nullable=False),
    Column("target_line", Float, nullable=False),
    Column("target_row_px", Float, nullable=False),
    Column("sigma_px", Float, nullable=False),
    Column("inset_m", Float, nullable=False),
    Column("u_inset_m", Float, nullable=False),
    Column("inset_from", String(20), nullable=False),
    # of an eye with a usual inset: the side of the driver that a person said
    Column("side", String(20)),
    Column("distance_m", Float),
    Column("u_distance_m", Float),
    Column("height_m", Float),
    Column("u_height_m", Float),
    Column("status", String(20), nullable=False),
    Column("reason", Text),
    Column("budget", CanonicalJson, nullable=False),
    Column("warnings", CanonicalJson, nullable=False),
    Column("withdrawn", Boolean, nullable=False),
    # what computed it again, the clicks being those of the revision before; `created_by` is who clicked
    Column("computing_id", ForeignKey("computings.id"), index=True),
    # the revision before it whose verdict holds for this one too
    Column("verdict_of_id", ForeignKey("line_heights.id")),
    Column("code_version", String(60), nullable=False),
    *made_columns(),
    UniqueConstraint("vehicle_id", "target", "revision"),
    enum_check("target", Target),
    enum_check("inset_from", InsetSource),
    enum_check("side", DriverSide),
    enum_check("status", MeasurementStatus),
    CheckConstraint("target <> 'driver_eye' OR side IS NOT NULL OR inset_from = 'own'", name="eye_has_side"),
    CheckConstraint("revision >= 1", name="revision_counts"),
    CheckConstraint(
        "(status = 'ok' AND height_m IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
        name="height_or_reason",
    ),
    info=vouched(WrittenOnce("line_height", "scanned vehicle's height")),
)

# Verdicts on a revision of a height; written once, the newest of a revision counts.
line_height_reviews = Table(
    "line_height_reviews",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("height_id", ForeignKey("line_heights.id"), nullable=False),
    Column("verdict", String(20), nullable=False),
    Column("reason", Text),
    *made_columns(),
    enum_check("verdict", ScanVerdict),
    CheckConstraint("verdict <> 'rejected' OR reason IS NOT NULL", name="rejected_has_reason"),
    info=vouched(WrittenOnce("line_height_review", "review of a scanned vehicle's height")),
)
Index("ix_line_height_reviews_height_id", line_height_reviews.c.height_id)
