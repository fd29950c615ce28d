"""Every table of the first release; the database refuses to change or remove what is written once."""

import sqlalchemy as sa
from alembic import op

revision = "0001_first"
down_revision = None
branch_labels = None
depends_on = None

# What is written once, and the columns that are unique beside the id: a row with the same ones would be
# replaced as well, for INSERT OR REPLACE goes past SQLite's DELETE triggers.
WRITTEN_ONCE: dict[str, tuple[str, ...]] = {
    "audit_events": ("hash",),
    "measurement_series": ("client_key",),
    "computings": (),
    "measurements": ("series_id", "revision"),
    "lots": ("survey_id", "number"),
    "lot_items": ("lot_id", "place"),
    "lot_decisions": (),
    "reviews": (),
    "calibrations": (),
    "road_poses": (),
    "wheel_pairs": (),
    "click_sigmas": (),
    "scan_runs": (),
    "scan_measurements": ("vehicle_id", "revision"),
    "scan_reviews": (),
    "scan_references": ("vehicle_id", "quantity", "source", "revision"),
    "line_poses": ("scan_id", "revision"),
    "rig_calibrations": ("scan_id", "revision"),
    "study_results": (),
}
# Keys between tables that name each other; SQLite takes them with the table itself.
CIRCULAR = (
    ("cameras", "current_calibration_id", "calibrations"),
    ("recordings", "pose_id", "road_poses"),
    ("jobs", "scan_id", "scans"),
    ("jobs", "study_id", "studies"),
    ("uploads", "scan_id", "scans"),
)
FUNCTION = """
CREATE FUNCTION sightline_refuse_change() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  RAISE EXCEPTION '% is written once: % is refused', TG_TABLE_NAME, TG_OP
    USING ERRCODE = 'restrict_violation';
END
$$
"""


def upgrade() -> None:
    create_tables()
    if op.get_bind().dialect.name == "postgresql":
        op.execute(FUNCTION)
        create_procrastinate()
        for table, column, other in CIRCULAR:
            op.create_foreign_key(f"fk_{table}_{column}", table, other, [column], ["id"])
    for table, also_unique in WRITTEN_ONCE.items():
        refuse_changes(table, also_unique)


def create_procrastinate() -> None:
    """The tables and functions of the job engine, as its installed version brings them."""
    from procrastinate.schema import SchemaManager

    connection = op.get_bind().connection.driver_connection
    connection.execute(SchemaManager.get_schema())


def refuse_changes(table: str, also_unique: tuple[str, ...]) -> None:
    """Triggers that refuse to update, delete, truncate or replace the rows of a table."""
    if op.get_bind().dialect.name == "postgresql":
        # PostgreSQL has no REPLACE; its upsert is an UPDATE and is refused as one.
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
    same = "id = NEW.id"
    if also_unique:
        same += " OR (" + " AND ".join(f"{column} = NEW.{column}" for column in also_unique) + ")"
    op.execute(
        f"CREATE TRIGGER {table}_refuse_replace BEFORE INSERT ON {table} "
        f"WHEN EXISTS (SELECT 1 FROM {table} WHERE {same}) "
        f"BEGIN SELECT RAISE(ABORT, '{table} is written once: REPLACE is refused'); END"
    )


def create_tables() -> None:
    """In an order in which every foreign key finds its table."""
    op.create_table(
        "audit_chains",
        sa.Column("name", sa.String(length=40), nullable=False),
        sa.Column("count", sa.Integer(), nullable=False),
        sa.Column("hash", sa.String(length=64), nullable=False),
        sa.PrimaryKeyConstraint("name", name=op.f("pk_audit_chains")),
    )
    op.create_table(
        "catalogue",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("make", sa.String(length=100), nullable=False),
        sa.Column("model", sa.String(length=200), nullable=False),
        sa.Column("year_from", sa.Integer(), nullable=True),
        sa.Column("year_to", sa.Integer(), nullable=True),
        sa.Column("category", sa.String(length=20), nullable=True),
        sa.Column("height_m", sa.Float(), nullable=True),
        sa.Column("length_m", sa.Float(), nullable=True),
        sa.Column("width_m", sa.Float(), nullable=True),
        sa.Column("wheelbase_m", sa.Float(), nullable=True),
        sa.Column("taillight_m", sa.Float(), nullable=True),
        sa.Column("headlight_m", sa.Float(), nullable=True),
        sa.Column("u_height_m", sa.Float(), nullable=True),
        sa.Column("u_length_m", sa.Float(), nullable=True),
        sa.Column("u_width_m", sa.Float(), nullable=True),
        sa.Column("u_wheelbase_m", sa.Float(), nullable=True),
        sa.Column("u_taillight_m", sa.Float(), nullable=True),
        sa.Column("u_headlight_m", sa.Float(), nullable=True),
        sa.Column("height_source", sa.Text(), nullable=True),
        sa.Column("length_source", sa.Text(), nullable=True),
        sa.Column("width_source", sa.Text(), nullable=True),
        sa.Column("wheelbase_source", sa.Text(), nullable=True),
        sa.Column("taillight_source", sa.Text(), nullable=True),
        sa.Column("headlight_source", sa.Text(), nullable=True),
        sa.Column("source", sa.Text(), nullable=False),
        sa.Column("search_text", sa.Text(), nullable=False),
        sa.Column("version", sa.Integer(), server_default="1", nullable=False),
        sa.Column("retired_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "category IN ('hatchback', 'saloon', 'estate', 'suv', 'multi_purpose', 'pickup', 'van', 'lorry', "
            "'tractor_unit', 'bus', 'recreational_vehicle', 'trailer', 'motorcycle', 'other')",
            name=op.f("ck_catalogue_category_known"),
        ),
        sa.CheckConstraint("version >= 1", name=op.f("ck_catalogue_version_counts")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_catalogue")),
    )
    op.create_index(
        "ix_catalogue_make_model_year_from", "catalogue", ["make", "model", "year_from"], unique=False
    )
    op.create_table(
        "people",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=200), nullable=False),
        sa.Column("email", sa.String(length=320), nullable=False),
        sa.Column("role", sa.String(length=20), nullable=False),
        sa.Column("active", sa.Boolean(), server_default=sa.true(), nullable=False),
        sa.Column("password_hash", sa.Text(), nullable=True),
        sa.Column("session_key", sa.Integer(), server_default="1", nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("last_seen_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "role IN ('admin', 'operator', 'reviewer', 'viewer')", name=op.f("ck_people_role_known")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_people")),
        sa.UniqueConstraint("email", name=op.f("uq_people_email")),
    )
    op.create_table(
        "sign_in_links",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("token_hash", sa.String(length=64), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("used_at", sa.DateTime(timezone=True), nullable=True),
        sa.ForeignKeyConstraint(["person_id"], ["people.id"], name=op.f("fk_sign_in_links_person_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_sign_in_links")),
        sa.UniqueConstraint("token_hash", name=op.f("uq_sign_in_links_token_hash")),
    )
    op.create_index(op.f("ix_sign_in_links_person_id"), "sign_in_links", ["person_id"], unique=False)
    op.create_table(
        "api_tokens",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=200), nullable=False),
        sa.Column("token_hash", sa.String(length=64), nullable=False),
        sa.Column("scopes", sa.Text(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("revoked_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("last_used_at", sa.DateTime(timezone=True), nullable=True),
        sa.ForeignKeyConstraint(["person_id"], ["people.id"], name=op.f("fk_api_tokens_person_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_api_tokens")),
        sa.UniqueConstraint("token_hash", name=op.f("uq_api_tokens_token_hash")),
    )
    op.create_index(op.f("ix_api_tokens_person_id"), "api_tokens", ["person_id"], unique=False)
    op.create_table(
        "counted",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("key", sa.String(length=64), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("amount", sa.Integer(), nullable=False),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_counted")),
    )
    op.create_index(op.f("ix_counted_at"), "counted", ["at"], unique=False)
    op.create_index(op.f("ix_counted_key_at"), "counted", ["key", "at"], unique=False)
    op.create_table(
        "surveys",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=200), nullable=False),
        sa.Column("site", sa.String(length=200), nullable=False),
        sa.Column("description", sa.Text(), nullable=False),
        sa.Column("is_demo", sa.Boolean(), nullable=False),
        sa.Column("simulated", sa.Boolean(), nullable=False),
        sa.Column("open_to_all", sa.Boolean(), nullable=False),
        sa.Column("traffic_side", sa.String(length=20), nullable=True),
        sa.Column("steering_side", sa.String(length=20), nullable=True),
        sa.Column("camera_place", sa.String(length=20), nullable=True),
        sa.Column("latitude_deg", sa.Float(), nullable=True),
        sa.Column("longitude_deg", sa.Float(), nullable=True),
        sa.Column("road_class", sa.String(length=100), nullable=True),
        sa.Column("lane", sa.String(length=100), nullable=True),
        sa.Column("travel_direction", sa.String(length=100), nullable=True),
        sa.Column("speed_limit_mps", sa.Float(), nullable=True),
        sa.Column("street_lamps", sa.String(length=20), nullable=True),
        sa.Column("time_zone", sa.String(length=60), nullable=True),
        sa.Column("asked", sa.Text(), nullable=False),
        sa.Column("classes", sa.Text(), nullable=False),
        sa.Column("sampling", sa.Text(), nullable=False),
        sa.Column("insets", sa.Text(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.CheckConstraint("camera_place IN ('verge', 'median')", name=op.f("ck_surveys_camera_place_known")),
        sa.CheckConstraint("street_lamps IN ('present', 'none')", name=op.f("ck_surveys_street_lamps_known")),
        sa.CheckConstraint("steering_side IN ('right', 'left')", name=op.f("ck_surveys_steering_side_known")),
        sa.CheckConstraint("traffic_side IN ('right', 'left')", name=op.f("ck_surveys_traffic_side_known")),
        sa.CheckConstraint("version >= 1", name=op.f("ck_surveys_version_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_surveys_created_by")),
        sa.ForeignKeyConstraint(["updated_by"], ["people.id"], name=op.f("fk_surveys_updated_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_surveys")),
    )
    op.create_table(
        "survey_members",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("role", sa.String(length=20), nullable=False),
        sa.CheckConstraint(
            "role IN ('manager', 'operator', 'reviewer', 'viewer')", name=op.f("ck_survey_members_role_known")
        ),
        sa.ForeignKeyConstraint(["person_id"], ["people.id"], name=op.f("fk_survey_members_person_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_survey_members_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_survey_members")),
        sa.UniqueConstraint("survey_id", "person_id", name=op.f("uq_survey_members_survey_id_person_id")),
    )
    op.create_index(op.f("ix_survey_members_person_id"), "survey_members", ["person_id"], unique=False)
    op.create_table(
        "audit_events",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("chain", sa.String(length=40), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
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
        sa.UniqueConstraint("chain", "number", name=op.f("uq_audit_events_chain_number")),
    )
    op.create_index("ix_audit_events_entity_entity_id", "audit_events", ["entity", "entity_id"], unique=False)
    op.create_index(op.f("ix_audit_events_survey_id"), "audit_events", ["survey_id"], unique=False)
    op.create_table(
        "idempotency_keys",
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("key", sa.String(length=100), nullable=False),
        sa.Column("fingerprint", sa.String(length=64), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("event_id", sa.Integer(), nullable=False),
        sa.Column("status", sa.Integer(), nullable=True),
        sa.Column("answer", sa.Text(), nullable=True),
        sa.ForeignKeyConstraint(["event_id"], ["audit_events.id"], name=op.f("fk_idempotency_keys_event_id")),
        sa.ForeignKeyConstraint(["person_id"], ["people.id"], name=op.f("fk_idempotency_keys_person_id")),
        sa.PrimaryKeyConstraint("person_id", "key", name=op.f("pk_idempotency_keys")),
    )
    op.create_index(op.f("ix_idempotency_keys_at"), "idempotency_keys", ["at"], unique=False)
    op.create_table(
        "cameras",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=200), nullable=False),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("lens", sa.String(length=200), nullable=False),
        sa.Column("zoom", sa.String(length=100), nullable=False),
        sa.Column("focus", sa.String(length=100), nullable=False),
        sa.Column("taken_from", sa.String(length=500), nullable=False),
        sa.Column("current_calibration_id", sa.Integer(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_cameras_created_by")),
        sa.ForeignKeyConstraint(
            ["current_calibration_id"],
            ["calibrations.id"],
            name=op.f("fk_cameras_current_calibration_id"),
            use_alter=True,
        ),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_cameras_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_cameras")),
    )
    op.create_index(op.f("ix_cameras_survey_id"), "cameras", ["survey_id"], unique=False)
    op.create_table(
        "click_sigmas",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("sigma_px", sa.Float(), nullable=True),
        sa.Column("pairs", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint("sigma_px > 0", name=op.f("ck_click_sigmas_sigma_positive")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_click_sigmas_created_by")),
        sa.ForeignKeyConstraint(["person_id"], ["people.id"], name=op.f("fk_click_sigmas_person_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_click_sigmas_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_click_sigmas")),
    )
    op.create_index(op.f("ix_click_sigmas_survey_id"), "click_sigmas", ["survey_id"], unique=False)
    op.create_table(
        "exports",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("media_key", sa.String(length=400), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("sha256", sa.String(length=64), nullable=False),
        sa.Column("audit_count", sa.Integer(), nullable=False),
        sa.Column("audit_head", sa.String(length=64), nullable=False),
        sa.Column("selection", sa.Text(), nullable=False),
        sa.Column("language", sa.String(length=20), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_exports_created_by")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_exports_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_exports")),
    )
    op.create_index(op.f("ix_exports_survey_id"), "exports", ["survey_id"], unique=False)
    op.create_table(
        "survey_photographs",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=400), nullable=False),
        sa.Column("caption", sa.Text(), nullable=False),
        sa.Column("position", sa.Integer(), nullable=False),
        sa.Column("media_key", sa.String(length=400), nullable=False),
        sa.Column("sha256", sa.String(length=64), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("width_px", sa.Integer(), nullable=False),
        sa.Column("height_px", sa.Integer(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("position >= 1", name=op.f("ck_survey_photographs_position_counts")),
        sa.CheckConstraint("version >= 1", name=op.f("ck_survey_photographs_version_counts")),
        sa.CheckConstraint(
            "width_px > 0 AND height_px > 0 AND size_bytes > 0",
            name=op.f("ck_survey_photographs_size_positive"),
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_survey_photographs_created_by")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_survey_photographs_survey_id")),
        sa.ForeignKeyConstraint(["updated_by"], ["people.id"], name=op.f("fk_survey_photographs_updated_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_survey_photographs")),
    )
    op.create_index(
        op.f("ix_survey_photographs_survey_id"), "survey_photographs", ["survey_id"], unique=False
    )
    op.create_table(
        "calibration_images",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("camera_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=400), nullable=False),
        sa.Column("media_key", sa.String(length=400), nullable=False),
        sa.Column("width_px", sa.Integer(), nullable=False),
        sa.Column("height_px", sa.Integer(), nullable=False),
        sa.Column("found", sa.Boolean(), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("corners_px", sa.Text(), nullable=False),
        sa.Column("columns", sa.Integer(), nullable=False),
        sa.Column("rows", sa.Integer(), nullable=False),
        sa.Column("sharpness", sa.Float(), nullable=True),
        sa.Column("ids", sa.Text(), nullable=True),
        sa.Column("dictionary", sa.String(length=40), nullable=True),
        sa.Column("marker_share", sa.Float(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "found OR reason IS NOT NULL", name=op.f("ck_calibration_images_missed_has_reason")
        ),
        sa.ForeignKeyConstraint(["camera_id"], ["cameras.id"], name=op.f("fk_calibration_images_camera_id")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_calibration_images_created_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_calibration_images")),
        sqlite_autoincrement=True,
    )
    op.create_index(
        op.f("ix_calibration_images_camera_id"), "calibration_images", ["camera_id"], unique=False
    )
    op.create_table(
        "recordings",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=400), nullable=False),
        sa.Column("state", sa.String(length=20), nullable=False),
        sa.Column("error", sa.Text(), nullable=True),
        sa.Column("media_key", sa.String(length=400), nullable=False),
        sa.Column("sha256", sa.String(length=64), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("width_px", sa.Integer(), nullable=True),
        sa.Column("height_px", sa.Integer(), nullable=True),
        sa.Column("frame_count", sa.Integer(), nullable=True),
        sa.Column("duration_s", sa.Float(), nullable=True),
        sa.Column("codec", sa.String(length=60), nullable=True),
        sa.Column("container", sa.String(length=60), nullable=True),
        sa.Column("vfr", sa.Boolean(), nullable=False),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("report", sa.Text(), nullable=False),
        sa.Column("thumbs", sa.Text(), nullable=False),
        sa.Column("camera_id", sa.Integer(), nullable=True),
        sa.Column("pose_id", sa.Integer(), nullable=True),
        sa.Column("lighting", sa.String(length=20), nullable=True),
        sa.Column("lighting_proposed", sa.String(length=20), nullable=True),
        sa.Column("stream_number", sa.Integer(), nullable=True),
        sa.Column("filmed_hz", sa.Float(), nullable=True),
        sa.Column("start_proposed", sa.DateTime(timezone=True), nullable=True),
        sa.Column("started_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("time_zone", sa.String(length=60), nullable=True),
        sa.Column("weather", sa.String(length=100), nullable=True),
        sa.Column("street_lighting", sa.String(length=20), nullable=True),
        sa.Column("drift", sa.Text(), nullable=True),
        sa.Column("drift_decision", sa.Text(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("lighting IN ('daytime', 'low_light')", name=op.f("ck_recordings_lighting_known")),
        sa.CheckConstraint(
            "lighting_proposed IN ('daytime', 'low_light')",
            name=op.f("ck_recordings_lighting_proposed_known"),
        ),
        sa.CheckConstraint(
            "(started_at IS NULL) = (time_zone IS NULL)", name=op.f("ck_recordings_start_has_zone")
        ),
        sa.CheckConstraint(
            "street_lighting IN ('on', 'off')", name=op.f("ck_recordings_street_lighting_known")
        ),
        sa.CheckConstraint(
            "state <> 'failed' OR error IS NOT NULL", name=op.f("ck_recordings_failed_has_error")
        ),
        sa.CheckConstraint(
            "state <> 'ready' OR frame_count IS NOT NULL", name=op.f("ck_recordings_ready_has_frames")
        ),
        sa.CheckConstraint(
            "state IN ('ingesting', 'ready', 'failed')", name=op.f("ck_recordings_state_known")
        ),
        sa.ForeignKeyConstraint(["camera_id"], ["cameras.id"], name=op.f("fk_recordings_camera_id")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_recordings_created_by")),
        sa.ForeignKeyConstraint(
            ["pose_id"], ["road_poses.id"], name=op.f("fk_recordings_pose_id"), use_alter=True
        ),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_recordings_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_recordings")),
    )
    op.create_index(op.f("ix_recordings_media_key"), "recordings", ["media_key"], unique=False)
    op.create_index(op.f("ix_recordings_survey_id"), "recordings", ["survey_id"], unique=False)
    op.create_table(
        "calibrations",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("camera_id", sa.Integer(), nullable=False),
        sa.Column("source", sa.String(length=20), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=True),
        sa.Column("document", sa.Text(), nullable=False),
        sa.Column("trusted", sa.Boolean(), nullable=False),
        sa.Column("warnings", sa.Text(), nullable=False),
        sa.Column("coverage", sa.Text(), nullable=False),
        sa.Column("views", sa.Text(), nullable=False),
        sa.Column("summary", sa.Text(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "source IN ('images', 'clip', 'import')", name=op.f("ck_calibrations_source_known")
        ),
        sa.ForeignKeyConstraint(["camera_id"], ["cameras.id"], name=op.f("fk_calibrations_camera_id")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_calibrations_created_by")),
        sa.ForeignKeyConstraint(
            ["recording_id"], ["recordings.id"], name=op.f("fk_calibrations_recording_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_calibrations")),
    )
    op.create_index(op.f("ix_calibrations_camera_id"), "calibrations", ["camera_id"], unique=False)
    op.create_table(
        "frames",
        sa.Column("recording_id", sa.Integer(), nullable=False),
        sa.Column("n", sa.Integer(), autoincrement=False, nullable=False),
        sa.Column("pts", sa.BigInteger(), nullable=False),
        sa.Column("time_s", sa.Float(), nullable=False),
        sa.Column("key", sa.Boolean(), nullable=False),
        sa.Column("crc32", sa.BigInteger(), nullable=False),
        sa.CheckConstraint("n >= 0", name=op.f("ck_frames_n_counts")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_frames_recording_id")),
        sa.PrimaryKeyConstraint("recording_id", "n", name=op.f("pk_frames")),
        sqlite_with_rowid=False,
    )
    op.create_table(
        "jobs",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("kind", sa.String(length=60), nullable=False),
        sa.Column("state", sa.String(length=20), nullable=False),
        sa.Column("payload", sa.Text(), nullable=False),
        sa.Column("progress", sa.Float(), nullable=False),
        sa.Column("message", sa.Text(), nullable=True),
        sa.Column("error", sa.Text(), nullable=True),
        sa.Column("result", sa.Text(), nullable=True),
        sa.Column("survey_id", sa.Integer(), nullable=True),
        sa.Column("recording_id", sa.Integer(), nullable=True),
        sa.Column("scan_id", sa.Integer(), nullable=True),
        sa.Column("study_id", sa.Integer(), nullable=True),
        sa.Column("attempts", sa.Integer(), nullable=False),
        sa.Column("outages", sa.Integer(), server_default="0", nullable=False),
        sa.Column("not_before", sa.DateTime(timezone=True), nullable=True),
        sa.Column("worker", sa.String(length=200), nullable=True),
        sa.Column("cancel_requested", sa.Boolean(), server_default=sa.false(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("started_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("finished_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("state <> 'failed' OR error IS NOT NULL", name=op.f("ck_jobs_failed_has_error")),
        sa.CheckConstraint(
            "state <> 'running' OR worker IS NOT NULL", name=op.f("ck_jobs_running_has_worker")
        ),
        sa.CheckConstraint(
            "state IN ('queued', 'running', 'done', 'failed', 'cancelled')", name=op.f("ck_jobs_state_known")
        ),
        sa.CheckConstraint("progress >= 0 AND progress <= 1", name=op.f("ck_jobs_progress_fraction")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_jobs_created_by")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_jobs_recording_id")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_jobs_scan_id"), use_alter=True),
        sa.ForeignKeyConstraint(["study_id"], ["studies.id"], name=op.f("fk_jobs_study_id"), use_alter=True),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_jobs_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_jobs")),
    )
    op.create_index(op.f("ix_jobs_recording_id"), "jobs", ["recording_id"], unique=False)
    op.create_index(op.f("ix_jobs_scan_id"), "jobs", ["scan_id"], unique=False)
    op.create_index("ix_jobs_state", "jobs", ["state"], unique=False)
    op.create_index(op.f("ix_jobs_study_id"), "jobs", ["study_id"], unique=False)
    op.create_index(op.f("ix_jobs_survey_id"), "jobs", ["survey_id"], unique=False)
    op.create_table(
        "scans",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=400), nullable=False),
        sa.Column("state", sa.String(length=20), nullable=False),
        sa.Column("error", sa.Text(), nullable=True),
        sa.Column("source", sa.String(length=20), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=True),
        sa.Column("cut_along", sa.String(length=20), nullable=True),
        sa.Column("cut_1_px", sa.Integer(), nullable=True),
        sa.Column("cut_2_px", sa.Integer(), nullable=True),
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
        sa.Column("shadow_share", sa.Float(), nullable=False),
        sa.Column("baseline_correlation", sa.Float(), nullable=False),
        sa.Column("u_distance_m", sa.Float(), nullable=False),
        sa.Column("lanes", sa.Text(), nullable=False),
        sa.Column("lighting", sa.String(length=20), nullable=True),
        sa.Column("started_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("time_zone", sa.String(length=60), nullable=True),
        sa.Column("u_start_s", sa.Float(), nullable=True),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("lighting IN ('daytime', 'low_light')", name=op.f("ck_scans_lighting_known")),
        sa.CheckConstraint(
            "(started_at IS NULL) = (time_zone IS NULL) AND (started_at IS NULL) = (u_start_s IS NULL)",
            name=op.f("ck_scans_start_whole"),
        ),
        sa.CheckConstraint("source IN ('strips', 'video', 'live')", name=op.f("ck_scans_source_known")),
        sa.CheckConstraint("state <> 'failed' OR error IS NOT NULL", name=op.f("ck_scans_failed_has_error")),
        sa.CheckConstraint(
            "state <> 'ready' OR (lines IS NOT NULL AND first_key IS NOT NULL)",
            name=op.f("ck_scans_ready_has_lines"),
        ),
        sa.CheckConstraint(
            "state IN ('live', 'reading', 'ready', 'failed')", name=op.f("ck_scans_state_known")
        ),
        sa.CheckConstraint("time_axis IN ('width', 'height')", name=op.f("ck_scans_time_axis_known")),
        sa.CheckConstraint(
            "cut_along IN ('columns', 'rows_left_up', 'rows_right_up')", name=op.f("ck_scans_cut_along_known")
        ),
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
    op.create_table(
        "scan_live",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("stream", sa.String(length=40), nullable=False),
        sa.Column("source", sa.Text(), nullable=True),
        sa.Column("line_rate_hz", sa.Float(), nullable=False),
        sa.Column("began_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("heard_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("ended_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("health", sa.Text(), nullable=True),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_scan_live_scan_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_scan_live_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scan_live")),
        sa.UniqueConstraint("scan_id", name=op.f("uq_scan_live_scan_id")),
    )
    op.create_index(op.f("ix_scan_live_survey_id"), "scan_live", ["survey_id"], unique=False)
    op.create_table(
        "uploads",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("filename", sa.String(length=400), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("media_key", sa.String(length=400), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("finished_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("purpose", sa.String(length=20), server_default="video", nullable=False),
        sa.Column("sha256", sa.String(length=64), nullable=True),
        sa.Column("scan_id", sa.Integer(), nullable=True),
        sa.CheckConstraint("purpose IN ('video', 'strip')", name=op.f("ck_uploads_purpose_known")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_uploads_created_by")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_uploads_recording_id")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_uploads_scan_id"), use_alter=True),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_uploads_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_uploads")),
        sqlite_autoincrement=True,
    )
    op.create_index(op.f("ix_uploads_survey_id"), "uploads", ["survey_id"], unique=False)
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
        sa.Column("model_chosen_by", sa.String(length=20), nullable=True),
        sa.Column("model_sizes", sa.String(length=100), nullable=True),
        sa.Column("category", sa.String(length=20), nullable=True),
        sa.Column("manufacturer_height_m", sa.Float(), nullable=True),
        sa.Column("u_manufacturer_height_m", sa.Float(), nullable=True),
        sa.Column("height_source", sa.Text(), nullable=True),
        sa.Column("known_driver_eye_m", sa.Float(), nullable=True),
        sa.Column("u_known_driver_eye_m", sa.Float(), nullable=True),
        sa.Column("known_driver_eye_source", sa.Text(), nullable=True),
        sa.Column("known_taillight_m", sa.Float(), nullable=True),
        sa.Column("u_known_taillight_m", sa.Float(), nullable=True),
        sa.Column("known_taillight_source", sa.Text(), nullable=True),
        sa.Column("known_headlight_m", sa.Float(), nullable=True),
        sa.Column("u_known_headlight_m", sa.Float(), nullable=True),
        sa.Column("known_headlight_source", sa.Text(), nullable=True),
        sa.Column("known_other_m", sa.Float(), nullable=True),
        sa.Column("u_known_other_m", sa.Float(), nullable=True),
        sa.Column("known_other_source", sa.Text(), nullable=True),
        sa.Column("check_target", sa.Boolean(), server_default=sa.false(), nullable=False),
        sa.Column("lighting", sa.String(length=20), nullable=True),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("origin", sa.String(length=20), server_default="person", nullable=False),
        sa.Column("direction", sa.String(length=20), nullable=True),
        sa.Column("driver_side", sa.String(length=20), nullable=True),
        sa.Column("roof_not_visible", sa.String(length=20), nullable=True),
        sa.Column("driver_eye_not_visible", sa.String(length=20), nullable=True),
        sa.Column("taillight_not_visible", sa.String(length=20), nullable=True),
        sa.Column("headlight_not_visible", sa.String(length=20), nullable=True),
        sa.Column("discarded", sa.String(length=20), nullable=True),
        sa.Column("detection", sa.Text(), nullable=True),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "category IN ('hatchback', 'saloon', 'estate', 'suv', 'multi_purpose', 'pickup', 'van', 'lorry', "
            "'tractor_unit', 'bus', 'recreational_vehicle', 'trailer', 'motorcycle', 'other')",
            name=op.f("ck_vehicles_category_known"),
        ),
        sa.CheckConstraint(
            "model_chosen_by IN ('size', 'seen')", name=op.f("ck_vehicles_model_chosen_by_known")
        ),
        sa.CheckConstraint("direction IN ('right', 'left')", name=op.f("ck_vehicles_direction_known")),
        sa.CheckConstraint(
            "discarded IN ('no_vehicle', 'twice', 'cut_off', 'stopped', 'other')",
            name=op.f("ck_vehicles_discarded_known"),
        ),
        sa.CheckConstraint("driver_side IN ('near', 'far')", name=op.f("ck_vehicles_driver_side_known")),
        sa.CheckConstraint(
            "roof_not_visible IN ('hidden', 'glare', 'too_dark', 'outside', 'own_body', 'no_driver')",
            name=op.f("ck_vehicles_roof_not_visible_known"),
        ),
        sa.CheckConstraint(
            "driver_eye_not_visible IN ('hidden', 'glare', 'too_dark', 'outside', 'own_body', 'no_driver')",
            name=op.f("ck_vehicles_driver_eye_not_visible_known"),
        ),
        sa.CheckConstraint(
            "taillight_not_visible IN ('hidden', 'glare', 'too_dark', 'outside', 'own_body', 'no_driver')",
            name=op.f("ck_vehicles_taillight_not_visible_known"),
        ),
        sa.CheckConstraint(
            "headlight_not_visible IN ('hidden', 'glare', 'too_dark', 'outside', 'own_body', 'no_driver')",
            name=op.f("ck_vehicles_headlight_not_visible_known"),
        ),
        sa.CheckConstraint("lighting IN ('daytime', 'low_light')", name=op.f("ck_vehicles_lighting_known")),
        sa.CheckConstraint("origin IN ('person', 'found')", name=op.f("ck_vehicles_origin_known")),
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
        "line_poses",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("marks", sa.Text(), nullable=False),
        sa.Column("sigma_px", sa.Float(), nullable=True),
        sa.Column("u_distance_m", sa.Float(), nullable=False),
        sa.Column("u_lean_rad", sa.Float(), nullable=False),
        sa.Column("pose", sa.Text(), nullable=False),
        sa.Column("camera_height_m", sa.Float(), nullable=False),
        sa.Column("u_camera_height_m", sa.Float(), nullable=False),
        sa.Column("rms_px", sa.Float(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint("revision >= 1", name=op.f("ck_line_poses_revision_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_line_poses_created_by")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_line_poses_scan_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_line_poses_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_line_poses")),
        sa.UniqueConstraint("scan_id", "revision", name=op.f("uq_line_poses_scan_id_revision")),
    )
    op.create_index(op.f("ix_line_poses_survey_id"), "line_poses", ["survey_id"], unique=False)
    op.create_table(
        "rig_calibrations",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("passes", sa.Text(), nullable=False),
        sa.Column("line_rate_hz", sa.Float(), nullable=False),
        sa.Column("u_line_rate_ratio", sa.Float(), nullable=False),
        sa.Column("u_tape_ratio", sa.Float(), nullable=False),
        sa.Column("u_speed_ratio", sa.Float(), nullable=False),
        sa.Column("baseline_m", sa.Float(), nullable=False),
        sa.Column("u_baseline_m", sa.Float(), nullable=False),
        sa.Column("divergence_rad", sa.Float(), nullable=False),
        sa.Column("u_divergence_rad", sa.Float(), nullable=False),
        sa.Column("baseline_correlation", sa.Float(), nullable=False),
        sa.Column("chi2", sa.Float(), nullable=False),
        sa.Column("degrees_of_freedom", sa.Integer(), nullable=False),
        sa.Column("p_value", sa.Float(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint("revision >= 1", name=op.f("ck_rig_calibrations_revision_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_rig_calibrations_created_by")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_rig_calibrations_scan_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_rig_calibrations_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_rig_calibrations")),
        sa.UniqueConstraint("scan_id", "revision", name=op.f("uq_rig_calibrations_scan_id_revision")),
    )
    op.create_index(op.f("ix_rig_calibrations_survey_id"), "rig_calibrations", ["survey_id"], unique=False)
    op.create_table(
        "road_poses",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=False),
        sa.Column("calibration_id", sa.Integer(), nullable=False),
        sa.Column("first_frame", sa.Integer(), nullable=False),
        sa.Column("last_frame", sa.Integer(), nullable=False),
        sa.Column("rms_px", sa.Float(), nullable=True),
        sa.Column("distance_m", sa.Float(), nullable=True),
        sa.Column("summary", sa.Text(), nullable=False),
        sa.Column("document", sa.Text(), nullable=False),
        sa.Column("warnings", sa.Text(), nullable=False),
        sa.Column("expected", sa.Text(), nullable=False),
        sa.Column("overlay", sa.Text(), nullable=False),
        sa.Column("turned_from", sa.Integer(), nullable=True),
        sa.Column("turned_by_rad", sa.Float(), nullable=True),
        sa.Column("adjusted_from", sa.Integer(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "first_frame >= 0 AND last_frame >= first_frame", name=op.f("ck_road_poses_span_forward")
        ),
        sa.ForeignKeyConstraint(
            ["calibration_id"], ["calibrations.id"], name=op.f("fk_road_poses_calibration_id")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_road_poses_created_by")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_road_poses_recording_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_road_poses_survey_id")),
        sa.ForeignKeyConstraint(
            ["adjusted_from"], ["road_poses.id"], name=op.f("fk_road_poses_adjusted_from")
        ),
        sa.ForeignKeyConstraint(["turned_from"], ["road_poses.id"], name=op.f("fk_road_poses_turned_from")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_road_poses")),
    )
    op.create_index(op.f("ix_road_poses_survey_id"), "road_poses", ["survey_id"], unique=False)
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
        sa.Column("run_of", sa.String(length=100), nullable=True),
        sa.Column("lighting", sa.String(length=20), nullable=True),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint(
            "category IN ('hatchback', 'saloon', 'estate', 'suv', 'multi_purpose', 'pickup', 'van', 'lorry', "
            "'tractor_unit', 'bus', 'recreational_vehicle', 'trailer', 'motorcycle', 'other')",
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
    op.create_table(
        "measurement_series",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=True),
        sa.Column("vehicle_id", sa.Integer(), nullable=True),
        sa.Column("scan_id", sa.Integer(), nullable=True),
        sa.Column("scan_vehicle_id", sa.Integer(), nullable=True),
        sa.Column("client_key", sa.String(length=36), nullable=False),
        sa.Column("repeat_of", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "(recording_id IS NULL) = (vehicle_id IS NULL) AND (scan_id IS NULL) = (scan_vehicle_id IS NULL) "
            "AND (vehicle_id IS NULL) <> (scan_vehicle_id IS NULL)",
            name=op.f("ck_measurement_series_of_one_vehicle"),
        ),
        sa.ForeignKeyConstraint(
            ["recording_id"], ["recordings.id"], name=op.f("fk_measurement_series_recording_id")
        ),
        sa.ForeignKeyConstraint(
            ["repeat_of"], ["measurement_series.id"], name=op.f("fk_measurement_series_repeat_of")
        ),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_measurement_series_scan_id")),
        sa.ForeignKeyConstraint(
            ["scan_vehicle_id"], ["scan_vehicles.id"], name=op.f("fk_measurement_series_scan_vehicle_id")
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
        op.f("ix_measurement_series_repeat_of"), "measurement_series", ["repeat_of"], unique=False
    )
    op.create_index(op.f("ix_measurement_series_scan_id"), "measurement_series", ["scan_id"], unique=False)
    op.create_index(
        op.f("ix_measurement_series_scan_vehicle_id"), "measurement_series", ["scan_vehicle_id"], unique=False
    )
    op.create_index(
        op.f("ix_measurement_series_survey_id"), "measurement_series", ["survey_id"], unique=False
    )
    op.create_index(
        op.f("ix_measurement_series_vehicle_id"), "measurement_series", ["vehicle_id"], unique=False
    )
    op.create_table(
        "wheel_pairs",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=False),
        sa.Column("vehicle_id", sa.Integer(), nullable=False),
        sa.Column("frame", sa.Integer(), nullable=False),
        sa.Column("pts", sa.BigInteger(), nullable=False),
        sa.Column("time_s", sa.Float(), nullable=False),
        sa.Column("frame_crc32", sa.BigInteger(), nullable=False),
        sa.Column("first_x_px", sa.Float(), nullable=False),
        sa.Column("first_y_px", sa.Float(), nullable=False),
        sa.Column("second_x_px", sa.Float(), nullable=False),
        sa.Column("second_y_px", sa.Float(), nullable=False),
        sa.Column("withdrawn", sa.Boolean(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_wheel_pairs_created_by")),
        sa.ForeignKeyConstraint(
            ["recording_id"], ["recordings.id"], name=op.f("fk_wheel_pairs_recording_id")
        ),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_wheel_pairs_survey_id")),
        sa.ForeignKeyConstraint(["vehicle_id"], ["vehicles.id"], name=op.f("fk_wheel_pairs_vehicle_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_wheel_pairs")),
    )
    op.create_index(op.f("ix_wheel_pairs_survey_id"), "wheel_pairs", ["survey_id"], unique=False)
    op.create_index(op.f("ix_wheel_pairs_vehicle_id"), "wheel_pairs", ["vehicle_id"], unique=False)
    op.create_table(
        "proposals",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("recording_id", sa.Integer(), nullable=False),
        sa.Column("vehicle_id", sa.Integer(), nullable=False),
        sa.Column("pose_id", sa.Integer(), nullable=False),
        sa.Column("point", sa.String(length=20), nullable=False),
        sa.Column("frame", sa.Integer(), nullable=True),
        sa.Column("x_px", sa.Float(), nullable=True),
        sa.Column("y_px", sa.Float(), nullable=True),
        sa.Column("expected_px", sa.Float(), nullable=True),
        sa.Column("reason", sa.String(length=60), nullable=True),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("withheld", sa.Boolean(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.CheckConstraint(
            "(reason IS NULL AND frame IS NOT NULL AND x_px IS NOT NULL AND y_px IS NOT NULL "
            "AND expected_px > 0) OR "
            "(reason IS NOT NULL AND x_px IS NULL AND y_px IS NULL AND expected_px IS NULL)",
            name=op.f("ck_proposals_place_or_reason"),
        ),
        sa.CheckConstraint(
            "point IN ('contact_rear', 'contact_front', 'roof', 'taillight', 'headlight', 'driver_eye')",
            name=op.f("ck_proposals_point_known"),
        ),
        sa.ForeignKeyConstraint(["pose_id"], ["road_poses.id"], name=op.f("fk_proposals_pose_id")),
        sa.ForeignKeyConstraint(["recording_id"], ["recordings.id"], name=op.f("fk_proposals_recording_id")),
        sa.ForeignKeyConstraint(["vehicle_id"], ["vehicles.id"], name=op.f("fk_proposals_vehicle_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_proposals")),
        sa.UniqueConstraint("vehicle_id", "point", name=op.f("uq_proposals_vehicle_id_point")),
    )
    op.create_index(op.f("ix_proposals_recording_id"), "proposals", ["recording_id"], unique=False)
    op.create_table(
        "computings",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("kind", sa.String(length=20), nullable=False),
        sa.Column("undoes", sa.Integer(), nullable=True),
        sa.Column("heights", sa.Integer(), nullable=False),
        sa.Column("to_review", sa.Integer(), nullable=False),
        sa.Column("kept", sa.Integer(), nullable=False),
        sa.Column("largest_m", sa.Float(), nullable=True),
        sa.Column("causes", sa.Text(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "kind IN ('asked', 'sides', 'adjustment', 'undo')", name=op.f("ck_computings_kind_known")
        ),
        sa.CheckConstraint(
            "(kind = 'undo') = (undoes IS NOT NULL)", name=op.f("ck_computings_undo_names_another")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_computings_created_by")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_computings_survey_id")),
        sa.ForeignKeyConstraint(["undoes"], ["computings.id"], name=op.f("fk_computings_undoes")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_computings")),
    )
    op.create_index(op.f("ix_computings_survey_id"), "computings", ["survey_id"], unique=False)
    op.create_table(
        "measurements",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("series_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("target", sa.String(length=20), nullable=False),
        sa.Column("frame", sa.Integer(), nullable=True),
        sa.Column("pts", sa.BigInteger(), nullable=True),
        sa.Column("time_s", sa.Float(), nullable=True),
        sa.Column("frame_crc32", sa.BigInteger(), nullable=True),
        sa.Column("contact_x_px", sa.Float(), nullable=False),
        sa.Column("contact_y_px", sa.Float(), nullable=False),
        sa.Column("target_x_px", sa.Float(), nullable=False),
        sa.Column("target_y_px", sa.Float(), nullable=False),
        sa.Column("sigma_px", sa.Float(), nullable=False),
        sa.Column("made", sa.String(length=20), nullable=False),
        sa.Column("snapped_from_x_px", sa.Float(), nullable=True),
        sa.Column("snapped_from_y_px", sa.Float(), nullable=True),
        sa.Column("proposal", sa.String(length=20), nullable=True),
        sa.Column("proposed_contact_x_px", sa.Float(), nullable=True),
        sa.Column("proposed_contact_y_px", sa.Float(), nullable=True),
        sa.Column("proposed_target_x_px", sa.Float(), nullable=True),
        sa.Column("proposed_target_y_px", sa.Float(), nullable=True),
        sa.Column("pose_id", sa.Integer(), nullable=True),
        sa.Column("calibration_id", sa.Integer(), nullable=True),
        sa.Column("line_pose_id", sa.Integer(), nullable=True),
        sa.Column("inset_m", sa.Float(), nullable=True),
        sa.Column("u_inset_m", sa.Float(), nullable=True),
        sa.Column("inset_from", sa.String(length=20), nullable=False),
        sa.Column("side", sa.String(length=20), nullable=True),
        sa.Column("side_from", sa.String(length=20), nullable=True),
        sa.Column("height_m", sa.Float(), nullable=True),
        sa.Column("uncorrected_height_m", sa.Float(), nullable=True),
        sa.Column("u_height_m", sa.Float(), nullable=True),
        sa.Column("U95_height_m", sa.Float(), nullable=True),
        sa.Column("x_m", sa.Float(), nullable=True),
        sa.Column("y_m", sa.Float(), nullable=True),
        sa.Column("distance_m", sa.Float(), nullable=True),
        sa.Column("u_distance_m", sa.Float(), nullable=True),
        sa.Column("status", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("flags", sa.Text(), nullable=False),
        sa.Column("budget", sa.Text(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("more_frames", sa.Text(), server_default="[]", nullable=False),
        sa.Column("followed", sa.Text(), nullable=True),
        sa.Column("solved_inset_m", sa.Float(), nullable=True),
        sa.Column("u_solved_inset_m", sa.Float(), nullable=True),
        sa.Column("u_clicks_m", sa.Float(), nullable=True),
        sa.Column("u_by_inset_m", sa.Float(), nullable=True),
        sa.Column("withdrawn", sa.Boolean(), nullable=False),
        sa.Column("computing_id", sa.Integer(), nullable=True),
        sa.Column("verdict_of_revision", sa.Integer(), nullable=True),
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
        sa.CheckConstraint("inset_from IN ('usual', 'own')", name=op.f("ck_measurements_inset_from_known")),
        sa.CheckConstraint(
            "made IN ('clicked', 'confirmed', 'moved', 'snapped')", name=op.f("ck_measurements_made_known")
        ),
        sa.CheckConstraint(
            "inset_m IS NOT NULL OR target = 'driver_eye'",
            name=op.f("ck_measurements_inset_of_all_but_eyes"),
        ),
        sa.CheckConstraint(
            "line_pose_id IS NULL OR target <> 'driver_eye' OR side IS NOT NULL OR inset_from = 'own'",
            name=op.f("ck_measurements_eye_of_a_line_has_side"),
        ),
        sa.CheckConstraint(
            "(pose_id IS NULL) <> (line_pose_id IS NULL) AND (pose_id IS NULL) = (calibration_id IS NULL) "
            "AND (pose_id IS NULL) = (frame IS NULL) AND (pose_id IS NULL) = (pts IS NULL) "
            "AND (pose_id IS NULL) = (time_s IS NULL) AND (pose_id IS NULL) = (frame_crc32 IS NULL)",
            name=op.f("ck_measurements_of_a_frame_or_a_line"),
        ),
        sa.CheckConstraint("revision >= 1", name=op.f("ck_measurements_revision_counts")),
        sa.CheckConstraint("side IN ('near', 'far')", name=op.f("ck_measurements_side_known")),
        sa.CheckConstraint(
            "side_from IN ('said', 'direction', 'place')", name=op.f("ck_measurements_side_from_known")
        ),
        sa.CheckConstraint("sigma_px > 0", name=op.f("ck_measurements_sigma_positive")),
        sa.CheckConstraint("proposal IN ('shown', 'withheld')", name=op.f("ck_measurements_proposal_known")),
        sa.CheckConstraint(
            "(proposal IS NULL AND proposed_contact_x_px IS NULL AND proposed_contact_y_px IS NULL "
            "AND proposed_target_x_px IS NULL AND proposed_target_y_px IS NULL) OR "
            "(proposal IS NOT NULL AND proposed_contact_x_px IS NOT NULL "
            "AND proposed_contact_y_px IS NOT NULL "
            "AND proposed_target_x_px IS NOT NULL AND proposed_target_y_px IS NOT NULL)",
            name=op.f("ck_measurements_proposal_has_its_points"),
        ),
        sa.CheckConstraint(
            "(snapped_from_x_px IS NULL) = (snapped_from_y_px IS NULL) "
            "AND (made <> 'snapped' OR snapped_from_x_px IS NOT NULL)",
            name=op.f("ck_measurements_snapped_from_a_click"),
        ),
        sa.CheckConstraint(
            "verdict_of_revision < revision", name=op.f("ck_measurements_verdict_of_an_earlier_one")
        ),
        sa.ForeignKeyConstraint(
            ["calibration_id"], ["calibrations.id"], name=op.f("fk_measurements_calibration_id")
        ),
        sa.ForeignKeyConstraint(
            ["computing_id"], ["computings.id"], name=op.f("fk_measurements_computing_id")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_measurements_created_by")),
        sa.ForeignKeyConstraint(
            ["line_pose_id"], ["line_poses.id"], name=op.f("fk_measurements_line_pose_id")
        ),
        sa.ForeignKeyConstraint(["pose_id"], ["road_poses.id"], name=op.f("fk_measurements_pose_id")),
        sa.ForeignKeyConstraint(
            ["series_id"], ["measurement_series.id"], name=op.f("fk_measurements_series_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_measurements")),
        sa.UniqueConstraint("series_id", "revision", name=op.f("uq_measurements_series_id_revision")),
    )
    op.create_index(op.f("ix_measurements_computing_id"), "measurements", ["computing_id"], unique=False)
    op.create_table(
        "lots",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False),
        sa.Column("common", sa.Text(), nullable=False),
        sa.Column("size", sa.Integer(), nullable=False),
        sa.Column("sample_size", sa.Integer(), nullable=False),
        sa.Column("acceptance_number", sa.Integer(), nullable=False),
        sa.Column("producer_quality", sa.Float(), nullable=False),
        sa.Column("producer_risk", sa.Float(), nullable=False),
        sa.Column("consumer_quality", sa.Float(), nullable=False),
        sa.Column("consumer_risk", sa.Float(), nullable=False),
        sa.Column("seed", sa.String(length=64), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "acceptance_number < sample_size AND sample_size <= size", name=op.f("ck_lots_plan_fits")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_lots_created_by")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_lots_survey_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_lots")),
        sa.UniqueConstraint("survey_id", "number", name=op.f("uq_lots_survey_id_number")),
    )
    op.create_index(op.f("ix_lots_survey_id"), "lots", ["survey_id"], unique=False)
    op.create_table(
        "lot_items",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("lot_id", sa.Integer(), nullable=False),
        sa.Column("series_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("place", sa.Integer(), nullable=False),
        sa.ForeignKeyConstraint(["lot_id"], ["lots.id"], name=op.f("fk_lot_items_lot_id")),
        sa.ForeignKeyConstraint(
            ["series_id"], ["measurement_series.id"], name=op.f("fk_lot_items_series_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_lot_items")),
        sa.UniqueConstraint("lot_id", "place", name=op.f("uq_lot_items_lot_id_place")),
        sa.UniqueConstraint("lot_id", "series_id", name=op.f("uq_lot_items_lot_id_series_id")),
    )
    op.create_index(op.f("ix_lot_items_series_id"), "lot_items", ["series_id"], unique=False)
    op.create_table(
        "lot_decisions",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("lot_id", sa.Integer(), nullable=False),
        sa.Column("choice", sa.String(length=20), nullable=False),
        sa.Column("judged", sa.Integer(), nullable=False),
        sa.Column("nonconforming", sa.Integer(), nullable=False),
        sa.Column("rest", sa.Integer(), nullable=False),
        sa.Column("sample", sa.Text(), nullable=False),
        sa.Column("left_out", sa.Text(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "choice IN ('accepted', 'full_inspection', 'dissolved', 'taken_back')",
            name=op.f("ck_lot_decisions_choice_known"),
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_lot_decisions_created_by")),
        sa.ForeignKeyConstraint(["lot_id"], ["lots.id"], name=op.f("fk_lot_decisions_lot_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_lot_decisions")),
    )
    op.create_index(op.f("ix_lot_decisions_lot_id"), "lot_decisions", ["lot_id"], unique=False)
    op.create_table(
        "reviews",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("series_id", sa.Integer(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("result_revision", sa.Integer(), nullable=False),
        sa.Column("verdict", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("lot_id", sa.Integer(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "verdict <> 'rejected' OR reason IS NOT NULL", name=op.f("ck_reviews_rejected_has_reason")
        ),
        sa.CheckConstraint(
            "lot_id IS NULL OR verdict IN ('accepted', 'reopened')",
            name=op.f("ck_reviews_lot_accepts_or_reopens"),
        ),
        sa.CheckConstraint(
            "verdict IN ('accepted', 'fixed', 'rejected', 'reopened')", name=op.f("ck_reviews_verdict_known")
        ),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_reviews_created_by")),
        sa.ForeignKeyConstraint(["lot_id"], ["lots.id"], name=op.f("fk_reviews_lot_id")),
        sa.ForeignKeyConstraint(["series_id"], ["measurement_series.id"], name=op.f("fk_reviews_series_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_reviews")),
    )
    op.create_index(op.f("ix_reviews_lot_id"), "reviews", ["lot_id"], unique=False)
    op.create_index(
        "ix_reviews_series_id_result_revision", "reviews", ["series_id", "result_revision"], unique=False
    )
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
        sa.Column("direction", sa.String(length=20), nullable=False),
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
        sa.Column("axle_lines", sa.Text(), nullable=True),
        sa.Column("axles_by", sa.String(length=20), nullable=True),
        sa.Column("lane", sa.String(length=40), nullable=True),
        sa.Column("lane_by", sa.String(length=20), nullable=True),
        sa.Column("tyres_px", sa.Float(), nullable=True),
        sa.Column("u_boundaries_m", sa.Float(), nullable=False),
        sa.Column("status", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("budget", sa.Text(), nullable=False),
        sa.Column("profile", sa.Text(), nullable=True),
        sa.Column("warnings", sa.Text(), nullable=False),
        sa.Column("verdict_of_id", sa.Integer(), nullable=True),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "(status = 'ok' AND speed_mps IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
            name=op.f("ck_scan_measurements_speed_or_reason"),
        ),
        sa.CheckConstraint(
            "cause IN ('found', 'added', 'boundaries', 'wheels', 'lane', 'back', 'again')",
            name=op.f("ck_scan_measurements_cause_known"),
        ),
        sa.CheckConstraint("method IN ('direct', 'paper')", name=op.f("ck_scan_measurements_method_known")),
        sa.CheckConstraint(
            "direction IN ('camera_1_first', 'camera_2_first')",
            name=op.f("ck_scan_measurements_direction_known"),
        ),
        sa.CheckConstraint(
            "axles_by IN ('machine', 'person')", name=op.f("ck_scan_measurements_axles_by_known")
        ),
        sa.CheckConstraint(
            "lane_by IN ('machine', 'person')", name=op.f("ck_scan_measurements_lane_by_known")
        ),
        sa.CheckConstraint(
            "(lane IS NULL) = (lane_by IS NULL)", name=op.f("ck_scan_measurements_lane_by_whom")
        ),
        sa.CheckConstraint(
            "(axle_lines IS NULL) = (axles_by IS NULL)", name=op.f("ck_scan_measurements_axles_by_whom")
        ),
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
        sa.ForeignKeyConstraint(
            ["verdict_of_id"], ["scan_measurements.id"], name=op.f("fk_scan_measurements_verdict_of_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scan_measurements")),
        sa.UniqueConstraint("vehicle_id", "revision", name=op.f("uq_scan_measurements_vehicle_id_revision")),
    )
    op.create_index(op.f("ix_scan_measurements_scan_id"), "scan_measurements", ["scan_id"], unique=False)
    op.create_index(op.f("ix_scan_measurements_survey_id"), "scan_measurements", ["survey_id"], unique=False)
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
    op.create_table(
        "scan_references",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("vehicle_id", sa.Integer(), nullable=False),
        sa.Column("quantity", sa.String(length=20), nullable=False),
        sa.Column("source", sa.String(length=20), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("value", sa.Float(), nullable=False),
        sa.Column("u", sa.Float(), nullable=False),
        sa.Column("device", sa.String(length=200), nullable=True),
        sa.Column("withdrawn", sa.Boolean(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "quantity IN ('speed', 'length', 'wheelbase')", name=op.f("ck_scan_references_quantity_known")
        ),
        sa.CheckConstraint("revision >= 1", name=op.f("ck_scan_references_revision_counts")),
        sa.CheckConstraint(
            "source IN ('counter', 'radar', 'laser', 'gps', 'loop', 'tape', 'other')",
            name=op.f("ck_scan_references_source_known"),
        ),
        sa.CheckConstraint("value > 0 AND u > 0", name=op.f("ck_scan_references_value_with_u")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_scan_references_created_by")),
        sa.ForeignKeyConstraint(["scan_id"], ["scans.id"], name=op.f("fk_scan_references_scan_id")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_scan_references_survey_id")),
        sa.ForeignKeyConstraint(
            ["vehicle_id"], ["scan_vehicles.id"], name=op.f("fk_scan_references_vehicle_id")
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_scan_references")),
        sa.UniqueConstraint(
            "vehicle_id",
            "quantity",
            "source",
            "revision",
            name=op.f("uq_scan_references_vehicle_id_quantity_source_revision"),
        ),
    )
    op.create_index(op.f("ix_scan_references_scan_id"), "scan_references", ["scan_id"], unique=False)
    op.create_index(op.f("ix_scan_references_survey_id"), "scan_references", ["survey_id"], unique=False)
    create_studies()


def create_studies() -> None:
    """Surveys joined, and what was computed of them."""
    op.create_table(
        "studies",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("name", sa.String(length=200), nullable=False),
        sa.Column("description", sa.Text(), nullable=False),
        sa.Column("surveys", sa.Text(), nullable=False),
        sa.Column("fleet_csv", sa.Text(), nullable=False),
        sa.Column("sites_csv", sa.Text(), nullable=False),
        sa.Column("goal_m", sa.Float(), nullable=False),
        sa.Column("simulated", sa.Boolean(), nullable=False),
        sa.Column("open_to_all", sa.Boolean(), nullable=False),
        sa.Column("job_id", sa.Integer(), nullable=True),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_by", sa.Integer(), nullable=True),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("goal_m > 0 AND goal_m < 1", name=op.f("ck_studies_goal_is_a_length")),
        sa.CheckConstraint("version >= 1", name=op.f("ck_studies_version_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_studies_created_by")),
        sa.ForeignKeyConstraint(["job_id"], ["jobs.id"], name=op.f("fk_studies_job_id")),
        sa.ForeignKeyConstraint(["updated_by"], ["people.id"], name=op.f("fk_studies_updated_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_studies")),
    )
    op.create_table(
        "study_members",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("study_id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.ForeignKeyConstraint(["person_id"], ["people.id"], name=op.f("fk_study_members_person_id")),
        sa.ForeignKeyConstraint(["study_id"], ["studies.id"], name=op.f("fk_study_members_study_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_study_members")),
        sa.UniqueConstraint("study_id", "person_id", name=op.f("uq_study_members_study_id_person_id")),
    )
    op.create_index(op.f("ix_study_members_person_id"), "study_members", ["person_id"], unique=False)
    op.create_index(op.f("ix_study_members_study_id"), "study_members", ["study_id"], unique=False)
    op.create_table(
        "study_results",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("study_id", sa.Integer(), nullable=False),
        sa.Column("study_version", sa.Integer(), nullable=False),
        sa.Column("heads", sa.Text(), nullable=False),
        sa.Column("document", sa.Text(), nullable=False),
        sa.Column("media_key", sa.String(length=400), nullable=False),
        sa.Column("size_bytes", sa.BigInteger(), nullable=False),
        sa.Column("sha256", sa.String(length=64), nullable=False),
        sa.Column("report_key", sa.String(length=400), nullable=False),
        sa.Column("report_sha256", sa.String(length=64), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_study_results_created_by")),
        sa.ForeignKeyConstraint(["study_id"], ["studies.id"], name=op.f("fk_study_results_study_id")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_study_results")),
    )
    op.create_index(op.f("ix_study_results_study_id"), "study_results", ["study_id"], unique=False)
