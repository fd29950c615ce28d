"""The tables of measurements, their revisions, and people's own click sigmas."""

from sqlalchemy import (
    BigInteger,
    Boolean,
    CheckConstraint,
    Column,
    Float,
    ForeignKey,
    Integer,
    String,
    Table,
    Text,
    UniqueConstraint,
)

from sightline.enums import MeasurementStatus, Target
from sightline.infra.database.types import Document, Moment, identity, metadata, one_of

# What stays the same over all revisions of one measurement; append-only like them.
measurement_series = Table(
    "measurement_series",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False, index=True),
    Column("vehicle_id", ForeignKey("vehicles.id"), nullable=False, index=True),
    Column("client_key", String(36), nullable=False),
    # the measurement that this one repeats: shown and counted with the repeats only
    Column("repeat_of", ForeignKey("measurement_series.id"), index=True),
    UniqueConstraint("client_key"),
)


# One row a revision; the one with the highest number is the current one.
measurements = Table(
    "measurements",
    metadata,
    identity(),
    Column("series_id", ForeignKey("measurement_series.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    Column("target", String(20), nullable=False),
    Column("frame", Integer, nullable=False),
    Column("pts", BigInteger, nullable=False),
    Column("time_s", Float, nullable=False),
    Column("crc32", BigInteger, nullable=False),
    Column("contact_x_px", Float, nullable=False),
    Column("contact_y_px", Float, nullable=False),
    Column("target_x_px", Float, nullable=False),
    Column("target_y_px", Float, nullable=False),
    Column("sigma_px", Float, nullable=False),
    Column("pose_id", ForeignKey("road_poses.id"), nullable=False),
    Column("calibration_id", ForeignKey("calibrations.id"), nullable=False),
    Column("inset_m", Float, nullable=False),
    Column("u_inset_m", Float, nullable=False),
    Column("height_m", Float),
    Column("uncorrected_height_m", Float),
    Column("u_height_m", Float),
    Column("U95_height_m", Float),
    Column("distance_m", Float),
    Column("status", String(20), nullable=False),
    Column("reason", Text),
    Column("flags", Document, nullable=False),
    Column("budget", Document, nullable=False),
    Column("code_version", String(60), nullable=False),
    # the same two points in further frames: then the inset is solved for
    Column("more_frames", Document, nullable=False, server_default="[]"),
    Column("solved_inset_m", Float),
    Column("u_solved_inset_m", Float),
    Column("withdrawn", Boolean, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    UniqueConstraint("series_id", "revision"),
    one_of("target", Target),
    one_of("status", MeasurementStatus),
    CheckConstraint("revision >= 1", name="revision_counts"),
    CheckConstraint("sigma_px > 0", name="sigma_positive"),
    CheckConstraint(
        "(status = 'ok' AND height_m IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
        name="height_or_reason",
    ),
)


# A person's own click sigma in a survey, from repeats; the newest row counts, without a figure the usual one.
click_sigmas = Table(
    "click_sigmas",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("person_id", ForeignKey("people.id"), nullable=False),
    Column("sigma_px", Float),
    Column("pairs", Integer, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    CheckConstraint("sigma_px > 0", name="sigma_positive"),
)
