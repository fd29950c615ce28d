"""Line-scan recordings: scans, runs, vehicles, measurements, reviews; their uploads and jobs."""

import sqlalchemy as sa
from alembic import op

revision = "0007_line_scans"
down_revision = "0006_found_passes_and_drift"
branch_labels = None
depends_on = None

# What is written once, and the columns that are unique in it beside the id.
WRITTEN_ONCE = {
    "scan_runs": "",
    "scan_measurements": " OR (vehicle_id = NEW.vehicle_id AND revision = NEW.revision)",
    "scan_reviews": "",
}
# Plain statements: SQLite adds these columns without making the tables anew.
COLUMNS = (
    "ALTER TABLE jobs ADD COLUMN scan_id INTEGER CONSTRAINT fk_jobs_scan_id REFERENCES scans (id)",
    "ALTER TABLE uploads ADD COLUMN purpose VARCHAR(20) NOT NULL DEFAULT 'video' "
    "CONSTRAINT ck_uploads_purpose_known CHECK (purpose IN ('video', 'strip'))",
    "ALTER TABLE uploads ADD COLUMN sha256 VARCHAR(64)",
    "ALTER TABLE uploads ADD COLUMN scan_id INTEGER CONSTRAINT fk_uploads_scan_id REFERENCES scans (id)",
)


def upgrade() -> None:
    _scans()
    _scan_runs()
    _scan_vehicles()
    _scan_measurements()
    _scan_reviews()
    for statement in COLUMNS:
        op.execute(statement)
    op.create_index(op.f("ix_jobs_scan_id"), "jobs", ["scan_id"], unique=False)
    for table, also_unique in WRITTEN_ONCE.items():
        _refuse_changes(table, also_unique)


def _scans() -> None:
    op.create_table(
        "scans",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=400), nullable=False),
        sa.Column("state", sa.String(length=20), nullable=False),
        sa.Column("error", sa.Text(), nullable=True),
        sa.Column("source", sa.String(length=20), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=True),
        sa.Column("column_1_px", sa.Integer(), nullable=True),
        sa.Column("column_2_px", sa.Integer(), nullable=True),
        sa.Column("first_name", sa.String(length=400), nullable=True),
        sa.Column("second_name", sa.String(length=400), nullable=True),
        sa.Column("first_source_key", sa.String(length=400), nullable=True),
        sa.Column("second_source_key", sa.String(length=400), nullable=True),
        sa.Column("first_source_sha256", sa.String(length=64), nullable=True),
        sa.Column("second_source_sha256", sa.String(length=64), nullable=True),
        sa.Column("time_axis", sa.String(length=20), nullable=False),
        sa.Column("first_key", sa.String(length=400), nullable=True),
        sa.Column("second_key", sa.String(length=400), nullable=True),
        sa.Column("first_sha256", sa.String(length=64), nullable=True),
        sa.Column("second_sha256", sa.String(length=64), nullable=True),
        sa.Column("rows_px", sa.Integer(), nullable=True),
        sa.Column("lines", sa.BigInteger(), nullable=True),
        sa.Column("bits", sa.Integer(), nullable=True),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("baseline_m", sa.Float(), nullable=False),
        sa.Column("u_baseline_m", sa.Float(), nullable=False),
        sa.Column("line_rate_hz", sa.Float(), nullable=False),
        sa.Column("u_line_rate_ratio", sa.Float(), nullable=False),
        sa.Column("divergence_rad", sa.Float(), nullable=False),
        sa.Column("u_divergence_rad", sa.Float(), nullable=False),
        sa.Column("distance_m", sa.Float(), nullable=True),
        sa.Column("misalignment_px", sa.Float(), nullable=True),
        sa.Column("u_misalignment_px", sa.Float(), nullable=False),
        sa.Column("lighting", sa.String(length=20), nullable=True),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("lighting IN ('daytime', 'low_light')", name=op.f("ck_scans_lighting_known")),
        sa.CheckConstraint("source IN ('strips', 'video')", name=op.f("ck_scans_source_known")),
        sa.CheckConstraint("state <> 'failed' OR error IS NOT NULL", name=op.f("ck_scans_failed_has_error")),
        sa.CheckConstraint(
            "state <> 'ready' OR (lines IS NOT NULL AND first_key IS NOT NULL)",
            name=op.f("ck_scans_ready_has_lines"),
        ),
        sa.CheckConstraint("state IN ('reading', 'ready', 'failed')", name=op.f("ck_scans_state_known")),
        sa.CheckConstraint("time_axis IN ('width', 'height')", name=op.f("ck_scans_time_axis_known")),
        sa.CheckConstraint("baseline_m > 0 AND line_rate_hz > 0", name=op.f("ck_scans_rig_positive")),
        sa.CheckConstraint("version >= 1", name=op.f("ck_scans_version_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_scans_created_by")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_scans_recording_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_scans_survey_id")),
        sa.ForeignKeyConstraint(["updated_by"], ["people.id"], name=op.f("fk_scans_updated_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scans")),
    )
    op.create_index(op.f("ix_scans_recording_id"), "scans", ["recording_id"], unique=False)
    op.create_index(op.f("ix_scans_survey_id"), "scans", ["survey_id"], unique=False)


def _scan_runs() -> None:
    op.create_table(
        "scan_runs",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("job_id", sa.Integer(), nullable=True),
        sa.Column("method", sa.String(length=20), nullable=False),
        sa.Column("rig", sa.Text(), nullable=False),
        sa.Column("found", sa.Integer(), nullable=False),
        sa.Column("measured", sa.Integer(), nullable=False),
        sa.Column("summary", sa.Text(), nullable=False),
        sa.Column("warnings", sa.Text(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint("method IN ('direct', 'paper')", name=op.f("ck_scan_runs_method_known")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_scan_runs_created_by")),
        sa.ForeignKeyConstraint(["job_id"], ["jobs.id"], name=op.f("fk_scan_runs_job_id")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_scan_runs_scan_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_scan_runs_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scan_runs")),
    )
    op.create_index(op.f("ix_scan_runs_scan_id"), "scan_runs", ["scan_id"], unique=False)
    op.create_index(op.f("ix_scan_runs_survey_id"), "scan_runs", ["survey_id"], unique=False)


def _scan_vehicles() -> None:
    op.create_table(
        "scan_vehicles",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("origin", sa.String(length=20), nullable=False),
        sa.Column("make", sa.String(length=100), nullable=True),
        sa.Column("model", sa.String(length=200), nullable=True),
        sa.Column("year", sa.Integer(), nullable=True),
        sa.Column("category", sa.String(length=20), nullable=True),
        sa.Column("true_length_m", sa.Float(), nullable=True),
        sa.Column("u_true_length_m", sa.Float(), nullable=True),
        sa.Column("true_wheelbase_m", sa.Float(), nullable=True),
        sa.Column("u_true_wheelbase_m", sa.Float(), nullable=True),
        sa.Column("facts_source", sa.Text(), nullable=True),
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
            name=op.f("ck_scan_vehicles_category_known"),
        ),
        sa.CheckConstraint(
            "lighting IN ('daytime', 'low_light')", name=op.f("ck_scan_vehicles_lighting_known")
        ),
        sa.CheckConstraint("origin IN ('person', 'found')", name=op.f("ck_scan_vehicles_origin_known")),
        sa.CheckConstraint("version >= 1", name=op.f("ck_scan_vehicles_version_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_scan_vehicles_created_by")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_scan_vehicles_scan_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_scan_vehicles_survey_id")),
        sa.ForeignKeyConstraint(["updated_by"], ["people.id"], name=op.f("fk_scan_vehicles_updated_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scan_vehicles")),
        sa.UniqueConstraint("scan_id", "number", name=op.f("uq_scan_vehicles_scan_id_number")),
    )
    op.create_index(op.f("ix_scan_vehicles_survey_id"), "scan_vehicles", ["survey_id"], unique=False)


def _scan_measurements() -> None:
    op.create_table(
        "scan_measurements",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("vehicle_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("run_id", sa.Integer(), nullable=True),
        sa.Column("cause", sa.String(length=20), nullable=False),
        sa.Column("placed_by", sa.Integer(), nullable=True),
        sa.Column("method", sa.String(length=20), nullable=False),
        sa.Column("rig", sa.Text(), nullable=False),
        sa.Column("front_line_1", sa.Float(), nullable=False),
        sa.Column("rear_line_1", sa.Float(), nullable=False),
        sa.Column("front_line_2", sa.Float(), nullable=False),
        sa.Column("rear_line_2", sa.Float(), nullable=False),
        sa.Column("speed_mps", sa.Float(), nullable=True),
        sa.Column("u_speed_mps", sa.Float(), nullable=True),
        sa.Column("acceleration_mps2", sa.Float(), nullable=True),
        sa.Column("u_acceleration_mps2", sa.Float(), nullable=True),
        sa.Column("length_m", sa.Float(), nullable=True),
        sa.Column("u_length_m", sa.Float(), nullable=True),
        sa.Column("fit_error_percent", sa.Float(), nullable=True),
        sa.Column("misalignment_px", sa.Float(), nullable=True),
        sa.Column("u_misalignment_px", sa.Float(), nullable=True),
        sa.Column("gain", sa.Float(), nullable=True),
        sa.Column("correlation", sa.Float(), nullable=True),
        sa.Column("front_wheel_line", sa.Float(), nullable=True),
        sa.Column("rear_wheel_line", sa.Float(), nullable=True),
        sa.Column("wheelbase_m", sa.Float(), nullable=True),
        sa.Column("u_wheelbase_m", sa.Float(), nullable=True),
        sa.Column("status", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("budget", sa.Text(), nullable=False),
        sa.Column("profile", sa.Text(), nullable=True),
        sa.Column("warnings", sa.Text(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "(status = 'ok' AND speed_mps IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
            name=op.f("ck_scan_measurements_speed_or_reason"),
        ),
        sa.CheckConstraint(
            "cause IN ('found', 'added', 'boundaries', 'wheels', 'again')",
            name=op.f("ck_scan_measurements_cause_known"),
        ),
        sa.CheckConstraint("method IN ('direct', 'paper')", name=op.f("ck_scan_measurements_method_known")),
        sa.CheckConstraint(
            "status IN ('ok', 'not_measurable')", name=op.f("ck_scan_measurements_status_known")
        ),
        sa.CheckConstraint(
            "(front_wheel_line IS NULL) = (rear_wheel_line IS NULL)",
            name=op.f("ck_scan_measurements_two_wheels"),
        ),
        sa.CheckConstraint("revision >= 1", name=op.f("ck_scan_measurements_revision_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_scan_measurements_created_by")),
        sa.ForeignKeyConstraint(["placed_by"], ["people.id"], name=op.f("fk_scan_measurements_placed_by")),
        sa.ForeignKeyConstraint(["run_id"], ["scan_runs.id"], name=op.f("fk_scan_measurements_run_id")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_scan_measurements_scan_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_scan_measurements_survey_id")),
        sa.ForeignKeyConstraint(
            ["vehicle_id"], ["scan_vehicles.id"], name=op.f("fk_scan_measurements_vehicle_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scan_measurements")),
        sa.UniqueConstraint("vehicle_id", "revision", name=op.f("uq_scan_measurements_vehicle_id_revision")),
    )
    op.create_index(op.f("ix_scan_measurements_scan_id"), "scan_measurements", ["scan_id"], unique=False)
    op.create_index(op.f("ix_scan_measurements_survey_id"), "scan_measurements", ["survey_id"], unique=False)


def _scan_reviews() -> None:
    op.create_table(
        "scan_reviews",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("measurement_id", sa.Integer(), nullable=False),
        sa.Column("verdict", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "verdict <> 'rejected' OR reason IS NOT NULL", name=op.f("ck_scan_reviews_rejected_has_reason")
        ),
        sa.CheckConstraint(
            "verdict IN ('accepted', 'rejected', 'reopened')", name=op.f("ck_scan_reviews_verdict_known")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_scan_reviews_created_by")),
        sa.ForeignKeyConstraint(
            ["measurement_id"], ["scan_measurements.id"], name=op.f("fk_scan_reviews_measurement_id")
        ),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_scan_reviews_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scan_reviews")),
    )
    op.create_index("ix_scan_reviews_measurement_id", "scan_reviews", ["measurement_id"], unique=False)
    op.create_index(op.f("ix_scan_reviews_survey_id"), "scan_reviews", ["survey_id"], unique=False)


def _refuse_changes(table: str, also_unique: str) -> None:
    """As 0003 and 0004 do for the tables before."""
    if op.get_bind().dialect.name == "postgresql":
        for event, level in (("UPDATE OR DELETE", "ROW"), ("TRUNCATE", "STATEMENT")):
            op.execute(
                f"CREATE TRIGGER {table}_refuse_{level.lower()} BEFORE {event} ON {table} "
                f"FOR EACH {level} EXECUTE FUNCTION sightline_refuse_change()"
            )
        return
    for event in ("UPDATE", "DELETE"):
        op.execute(
            f"CREATE TRIGGER {table}_refuse_{event.lower()} BEFORE {event} ON {table} "
            f"BEGIN SELECT RAISE(ABORT, '{table} is written once: {event} is refused'); END"
        )
    op.execute(
        f"CREATE TRIGGER {table}_refuse_replace BEFORE INSERT ON {table} "
        f"WHEN EXISTS (SELECT 1 FROM {table} WHERE id = NEW.id{also_unique}) "
        f"BEGIN SELECT RAISE(ABORT, '{table} is written once: REPLACE is refused'); END"
    )
