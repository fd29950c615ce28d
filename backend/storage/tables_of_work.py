"""The tables of vehicles, measurements, reviews, exports, jobs and the audit chain."""

from sqlalchemy import (
    BigInteger,
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
    false,
)

from backend.storage.columns import Document, Moment, identity, metadata, one_of
from backend.storage.tables import LIGHTING

vehicles = Table(
    "vehicles",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False, index=True),
    Column("number", Integer, nullable=False),
    Column("first_frame", Integer, nullable=False),
    Column("last_frame", Integer, nullable=False),
    Column("best_frame", Integer),
    Column("make", String(100)),
    Column("model", String(200)),
    Column("year", Integer),
    Column("category", String(20)),
    Column("manufacturer_height_m", Float),
    Column("u_manufacturer_height_m", Float),
    Column("height_source", Text),
    Column("lighting", String(20)),
    Column("notes", Text, nullable=False),
    # found by the job that looks for passes, or marked by a person; where it goes in the picture
    Column("origin", String(20), nullable=False, server_default="person"),
    Column("direction", String(20)),
    Column("detection", Document),
    Column("version", Integer, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("updated_at", Moment, nullable=False),
    Column("updated_by", ForeignKey("people.id")),
    Column("deleted_at", Moment),
    UniqueConstraint("survey_id", "number"),
    one_of("category", ("hatchback", "saloon", "estate", "suv", "van", "lorry", "other")),
    one_of("lighting", LIGHTING),
    one_of("origin", ("person", "found")),
    one_of("direction", ("right", "left")),
    CheckConstraint("first_frame >= 0 AND last_frame >= first_frame", name="span_forward"),
    CheckConstraint("version >= 1", name="version_counts"),
)

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
    Column("frame_crc", BigInteger, nullable=False),
    Column("contact_x_px", Float, nullable=False),
    Column("contact_y_px", Float, nullable=False),
    Column("point_x_px", Float, nullable=False),
    Column("point_y_px", Float, nullable=False),
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
    one_of("target", ("roof", "driver_eye", "taillight", "headlight", "other")),
    one_of("status", ("ok", "not_measurable")),
    CheckConstraint("revision >= 1", name="revision_counts"),
    CheckConstraint("sigma_px > 0", name="sigma_positive"),
    CheckConstraint(
        "(status = 'ok' AND height_m IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
        name="height_or_reason",
    ),
)

# Both tyre contacts of a vehicle on one frame: its direction of travel. The newest row of a vehicle counts.
wheel_pairs = Table(
    "wheel_pairs",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False),
    Column("vehicle_id", ForeignKey("vehicles.id"), nullable=False, index=True),
    Column("frame", Integer, nullable=False),
    Column("pts", BigInteger, nullable=False),
    Column("time_s", Float, nullable=False),
    Column("frame_crc", BigInteger, nullable=False),
    Column("first_x_px", Float, nullable=False),
    Column("first_y_px", Float, nullable=False),
    Column("second_x_px", Float, nullable=False),
    Column("second_y_px", Float, nullable=False),
    Column("withdrawn", Boolean, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
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

# `revision` is what the reviewer saw, `result_revision` what the verdict holds for (a fix makes a new one).
reviews = Table(
    "reviews",
    metadata,
    identity(),
    Column("series_id", ForeignKey("measurement_series.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    Column("result_revision", Integer, nullable=False),
    Column("verdict", String(20), nullable=False),
    Column("reason", Text),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    one_of("verdict", ("accepted", "fixed", "rejected", "reopened")),
    CheckConstraint("verdict <> 'rejected' OR reason IS NOT NULL", name="rejected_has_reason"),
)
Index("ix_reviews_series_id_result_revision", reviews.c.series_id, reviews.c.result_revision)

exports = Table(
    "exports",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("media_key", String(400), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    Column("sha256", String(64), nullable=False),
    # the chain as it stood when the package was made: proof against a cut tail
    Column("audit_count", Integer, nullable=False),
    Column("audit_head", String(64), nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
)

jobs = Table(
    "jobs",
    metadata,
    identity(),
    Column("kind", String(60), nullable=False),
    Column("state", String(20), nullable=False),
    Column("payload", Document, nullable=False),
    Column("progress", Float, nullable=False),
    Column("message", Text, nullable=False),
    Column("error", Text),
    Column("result", Document),
    Column("survey_id", ForeignKey("surveys.id"), index=True),
    Column("recording_id", ForeignKey("recordings.id"), index=True),
    Column("scan_id", Integer, ForeignKey("scans.id", use_alter=True), index=True),
    Column("attempts", Integer, nullable=False),
    Column("worker", String(200)),
    Column("lease_until", Moment),
    Column("cancel_requested", Boolean, nullable=False, server_default=false()),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("started_at", Moment),
    Column("finished_at", Moment),
    one_of("state", ("queued", "running", "done", "failed", "cancelled")),
    CheckConstraint("progress >= 0 AND progress <= 1", name="progress_fraction"),
    CheckConstraint("state <> 'failed' OR error IS NOT NULL", name="failed_has_error"),
    CheckConstraint("state <> 'running' OR lease_until IS NOT NULL", name="running_has_lease"),
)
Index("ix_jobs_state_lease_until", jobs.c.state, jobs.c.lease_until)

# before and after are canonical JSON text, hashed as they stand; ids leave no gap.
audit_events = Table(
    "audit_events",
    metadata,
    Column("id", Integer, primary_key=True, autoincrement=False),
    Column("at", String(40), nullable=False),
    Column("actor_id", ForeignKey("people.id")),
    Column("action", String(60), nullable=False),
    Column("entity", String(60), nullable=False),
    Column("entity_id", Integer),
    Column("survey_id", ForeignKey("surveys.id"), index=True),
    Column("before", Text),
    Column("after", Text),
    Column("previous_hash", String(64), nullable=False),
    Column("hash", String(64), nullable=False),
    UniqueConstraint("hash"),
)
Index("ix_audit_events_entity_entity_id", audit_events.c.entity, audit_events.c.entity_id)

# One row: how long the chain is and how it ends, so that a cut tail is seen.
audit_anchor = Table(
    "audit_anchor",
    metadata,
    Column("id", Integer, primary_key=True, autoincrement=False),
    Column("count", Integer, nullable=False),
    Column("hash", String(64), nullable=False),
    CheckConstraint("id = 1", name="single"),
)
