"""Vehicles, append-only measurements and reviews, exports, jobs and the audit chain."""

import sqlalchemy as sa
from alembic import op

revision = "0002_measurements"
down_revision = "0001_surveys"
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "audit_anchor",
        sa.Column("id", sa.Integer(), autoincrement=False, nullable=False),
        sa.Column("count", sa.Integer(), nullable=False),
        sa.Column("hash", sa.String(length=64), nullable=False),
        sa.CheckConstraint("id = 1", name=op.f("ck_audit_anchor_single")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_audit_anchor")),
    )
    op.create_table(
        "audit_events",
        sa.Column("id", sa.Integer(), autoincrement=False, nullable=False),
        sa.Column("at", sa.String(length=40), nullable=False),
        sa.Column("actor_id", sa.Integer(), nullable=True),
        sa.Column("action", sa.String(length=60), nullable=False),
        sa.Column("entity", sa.String(length=60), nullable=False),
        sa.Column("entity_id", sa.Integer(), nullable=True),
        sa.Column("survey_id", sa.Integer(), nullable=True),
        sa.Column("before", sa.Text(), nullable=True),
        sa.Column("after", sa.Text(), nullable=True),
        sa.Column("previous_hash", sa.String(length=64), nullable=False),
        sa.Column("hash", sa.String(length=64), nullable=False),
        sa.ForeignKeyConstraint(["actor_id"], ["people.id"], name=op.f("fk_audit_events_actor_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_audit_events_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_audit_events")),
        sa.UniqueConstraint("hash", name=op.f("uq_audit_events_hash")),
    )
    op.create_index("ix_audit_events_entity_entity_id", "audit_events", ["entity", "entity_id"], unique=False)
    op.create_index(op.f("ix_audit_events_survey_id"), "audit_events", ["survey_id"], unique=False)
    op.create_table(
        "exports",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("media_key", sa.String(length=400), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("sha256", sa.String(length=64), nullable=False),
        sa.Column("audit_count", sa.Integer(), nullable=False),
        sa.Column("audit_head", sa.String(length=64), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_exports_created_by")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_exports_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_exports")),
    )
    op.create_index(op.f("ix_exports_survey_id"), "exports", ["survey_id"], unique=False)
    op.create_table(
        "jobs",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("kind", sa.String(length=60), nullable=False),
        sa.Column("state", sa.String(length=20), nullable=False),
        sa.Column("payload", sa.Text(), nullable=False),
        sa.Column("progress", sa.Float(), nullable=False),
        sa.Column("message", sa.Text(), nullable=False),
        sa.Column("error", sa.Text(), nullable=True),
        sa.Column("result", sa.Text(), nullable=True),
        sa.Column("survey_id", sa.Integer(), nullable=True),
        sa.Column("recording_id", sa.Integer(), nullable=True),
        sa.Column("attempts", sa.Integer(), nullable=False),
        sa.Column("worker", sa.String(length=200), nullable=True),
        sa.Column("lease_until", sa.DateTime(timezone=True), nullable=True),
        sa.Column("cancel_requested", sa.Boolean(), server_default=sa.false(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("started_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("finished_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("state <> 'failed' OR error IS NOT NULL", name=op.f("ck_jobs_failed_has_error")),
        sa.CheckConstraint(
            "state <> 'running' OR lease_until IS NOT NULL", name=op.f("ck_jobs_running_has_lease")
        ),
        sa.CheckConstraint(
            "state IN ('queued', 'running', 'done', 'failed', 'cancelled')", name=op.f("ck_jobs_state_known")
        ),
        sa.CheckConstraint("progress >= 0 AND progress <= 1", name=op.f("ck_jobs_progress_fraction")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_jobs_created_by")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_jobs_recording_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_jobs_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_jobs")),
    )
    op.create_index(op.f("ix_jobs_recording_id"), "jobs", ["recording_id"], unique=False)
    op.create_index("ix_jobs_state_lease_until", "jobs", ["state", "lease_until"], unique=False)
    op.create_index(op.f("ix_jobs_survey_id"), "jobs", ["survey_id"], unique=False)
    op.create_table(
        "vehicles",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("first_frame", sa.Integer(), nullable=False),
        sa.Column("last_frame", sa.Integer(), nullable=False),
        sa.Column("best_frame", sa.Integer(), nullable=True),
        sa.Column("make", sa.String(length=100), nullable=True),
        sa.Column("model", sa.String(length=200), nullable=True),
        sa.Column("year", sa.Integer(), nullable=True),
        sa.Column("category", sa.String(length=20), nullable=True),
        sa.Column("manufacturer_height_m", sa.Float(), nullable=True),
        sa.Column("u_manufacturer_height_m", sa.Float(), nullable=True),
        sa.Column("height_source", sa.Text(), nullable=True),
        sa.Column("lighting", sa.String(length=20), nullable=True),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "category IN ('hatchback', 'saloon', 'estate', 'suv', 'van', 'lorry', 'other')",
            name=op.f("ck_vehicles_category_known"),
        ),
        sa.CheckConstraint("lighting IN ('daytime', 'low_light')", name=op.f("ck_vehicles_lighting_known")),
        sa.CheckConstraint(
            "first_frame >= 0 AND last_frame >= first_frame", name=op.f("ck_vehicles_span_forward")
        ),
        sa.CheckConstraint("version >= 1", name=op.f("ck_vehicles_version_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_vehicles_created_by")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_vehicles_recording_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_vehicles_survey_id")),
        sa.ForeignKeyConstraint(["updated_by"], ["people.id"], name=op.f("fk_vehicles_updated_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_vehicles")),
        sa.UniqueConstraint("survey_id", "number", name=op.f("uq_vehicles_survey_id_number")),
    )
    op.create_index(op.f("ix_vehicles_recording_id"), "vehicles", ["recording_id"], unique=False)
    op.create_table(
        "measurement_series",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=False),
        sa.Column("vehicle_id", sa.Integer(), nullable=False),
        sa.Column("client_key", sa.String(length=36), nullable=False),
        sa.ForeignKeyConstraint(
            ["recording_id"], ["recordings.id"], name=op.f("fk_measurement_series_recording_id")
        ),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_measurement_series_survey_id")),
        sa.ForeignKeyConstraint(
            ["vehicle_id"], ["vehicles.id"], name=op.f("fk_measurement_series_vehicle_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_measurement_series")),
        sa.UniqueConstraint("client_key", name=op.f("uq_measurement_series_client_key")),
    )
    op.create_index(
        op.f("ix_measurement_series_recording_id"), "measurement_series", ["recording_id"], unique=False
    )
    op.create_index(
        op.f("ix_measurement_series_survey_id"), "measurement_series", ["survey_id"], unique=False
    )
    op.create_index(
        op.f("ix_measurement_series_vehicle_id"), "measurement_series", ["vehicle_id"], unique=False
    )
    op.create_table(
        "measurements",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("series_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("target", sa.String(length=20), nullable=False),
        sa.Column("frame", sa.Integer(), nullable=False),
        sa.Column("pts", sa.BigInteger(), nullable=False),
        sa.Column("time_s", sa.Float(), nullable=False),
        sa.Column("frame_crc", sa.BigInteger(), nullable=False),
        sa.Column("contact_x_px", sa.Float(), nullable=False),
        sa.Column("contact_y_px", sa.Float(), nullable=False),
        sa.Column("point_x_px", sa.Float(), nullable=False),
        sa.Column("point_y_px", sa.Float(), nullable=False),
        sa.Column("sigma_px", sa.Float(), nullable=False),
        sa.Column("pose_id", sa.Integer(), nullable=False),
        sa.Column("calibration_id", sa.Integer(), nullable=False),
        sa.Column("inset_m", sa.Float(), nullable=False),
        sa.Column("u_inset_m", sa.Float(), nullable=False),
        sa.Column("height_m", sa.Float(), nullable=True),
        sa.Column("uncorrected_height_m", sa.Float(), nullable=True),
        sa.Column("u_height_m", sa.Float(), nullable=True),
        sa.Column("U95_height_m", sa.Float(), nullable=True),
        sa.Column("distance_m", sa.Float(), nullable=True),
        sa.Column("status", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("flags", sa.Text(), nullable=False),
        sa.Column("budget", sa.Text(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("withdrawn", sa.Boolean(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "(status = 'ok' AND height_m IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
            name=op.f("ck_measurements_height_or_reason"),
        ),
        sa.CheckConstraint("status IN ('ok', 'not_measurable')", name=op.f("ck_measurements_status_known")),
        sa.CheckConstraint(
            "target IN ('roof', 'driver_eye', 'taillight', 'headlight', 'other')",
            name=op.f("ck_measurements_target_known"),
        ),
        sa.CheckConstraint("revision >= 1", name=op.f("ck_measurements_revision_counts")),
        sa.CheckConstraint("sigma_px > 0", name=op.f("ck_measurements_sigma_positive")),
        sa.ForeignKeyConstraint(
            ["calibration_id"], ["calibrations.id"], name=op.f("fk_measurements_calibration_id")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_measurements_created_by")),
        sa.ForeignKeyConstraint(["pose_id"], ["road_poses.id"], name=op.f("fk_measurements_pose_id")),
        sa.ForeignKeyConstraint(
            ["series_id"], ["measurement_series.id"], name=op.f("fk_measurements_series_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_measurements")),
        sa.UniqueConstraint("series_id", "revision", name=op.f("uq_measurements_series_id_revision")),
    )
    op.create_table(
        "reviews",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("series_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("result_revision", sa.Integer(), nullable=False),
        sa.Column("verdict", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "verdict <> 'rejected' OR reason IS NOT NULL", name=op.f("ck_reviews_rejected_has_reason")
        ),
        sa.CheckConstraint(
            "verdict IN ('accepted', 'fixed', 'rejected', 'reopened')", name=op.f("ck_reviews_verdict_known")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_reviews_created_by")),
        sa.ForeignKeyConstraint(["series_id"], ["measurement_series.id"], name=op.f("fk_reviews_series_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews")),
    )
    op.create_index(
        "ix_reviews_series_id_result_revision", "reviews", ["series_id", "result_revision"], unique=False
    )
