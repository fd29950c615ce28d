"""The tables of people, surveys, cameras, recordings and poses; `tables_of_work` holds the others."""

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
    true,
)

from backend.storage.columns import Document, Moment, identity, metadata, one_of

ROLES = ("admin", "operator", "reviewer", "viewer")
LIGHTING = ("daytime", "low_light")

people = Table(
    "people",
    metadata,
    identity(),
    Column("name", String(200), nullable=False),
    Column("email", String(320), nullable=False),
    Column("role", String(20), nullable=False),
    Column("active", Boolean, nullable=False, server_default=true()),
    Column("password_hash", Text),
    Column("session_key", Integer, nullable=False, server_default="1"),
    Column("created_at", Moment, nullable=False),
    Column("last_seen_at", Moment),
    UniqueConstraint("email"),
    one_of("role", ROLES),
)

sign_in_links = Table(
    "sign_in_links",
    metadata,
    identity(),
    Column("person_id", ForeignKey("people.id"), nullable=False, index=True),
    Column("token_hash", String(64), nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("expires_at", Moment, nullable=False),
    Column("used_at", Moment),
    UniqueConstraint("token_hash"),
)

surveys = Table(
    "surveys",
    metadata,
    identity(),
    Column("name", String(200), nullable=False),
    Column("site", String(200), nullable=False),
    Column("description", Text, nullable=False),
    Column("is_demo", Boolean, nullable=False),
    Column("insets", Document, nullable=False),
    Column("version", Integer, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("updated_at", Moment, nullable=False),
    Column("updated_by", ForeignKey("people.id")),
    CheckConstraint("version >= 1", name="version_counts"),
)

# Pictures of the set-up: the rig, the road, the board in place. `position` is their order on the page.
survey_photographs = Table(
    "survey_photographs",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("caption", Text, nullable=False),
    Column("position", Integer, nullable=False),
    Column("media_key", String(400), nullable=False),
    Column("sha256", String(64), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    Column("width_px", Integer, nullable=False),
    Column("height_px", Integer, nullable=False),
    Column("version", Integer, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("updated_at", Moment, nullable=False),
    Column("updated_by", ForeignKey("people.id")),
    Column("deleted_at", Moment),
    CheckConstraint("width_px > 0 AND height_px > 0 AND size_bytes > 0", name="size_positive"),
    CheckConstraint("position >= 1", name="position_counts"),
    CheckConstraint("version >= 1", name="version_counts"),
)

cameras = Table(
    "cameras",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("name", String(200), nullable=False),
    Column("notes", Text, nullable=False),
    # cameras and calibrations point at each other: this one is added last
    Column("current_calibration_id", ForeignKey("calibrations.id", use_alter=True)),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
)

calibration_images = Table(
    "calibration_images",
    metadata,
    identity(),
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("media_key", String(400), nullable=False),
    Column("width_px", Integer, nullable=False),
    Column("height_px", Integer, nullable=False),
    Column("found", Boolean, nullable=False),
    Column("reason", Text),
    Column("corners_px", Document, nullable=False),
    Column("columns", Integer, nullable=False),
    Column("rows", Integer, nullable=False),
    Column("sharpness", Float),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    CheckConstraint("found OR reason IS NOT NULL", name="missed_has_reason"),
)

calibrations = Table(
    "calibrations",
    metadata,
    identity(),
    Column("camera_id", ForeignKey("cameras.id"), nullable=False, index=True),
    Column("source", String(20), nullable=False),
    Column("recording_id", ForeignKey("recordings.id")),
    Column("document", Document, nullable=False),
    Column("trusted", Boolean, nullable=False),
    Column("warnings", Document, nullable=False),
    Column("coverage", Document, nullable=False),
    Column("views", Document, nullable=False),
    Column("summary", Text, nullable=False),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    one_of("source", ("images", "clip", "import")),
)

recordings = Table(
    "recordings",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("state", String(20), nullable=False),
    Column("error", Text),
    Column("media_key", String(400), nullable=False, index=True),
    Column("sha256", String(64), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    Column("width_px", Integer),
    Column("height_px", Integer),
    Column("frame_count", Integer),
    Column("duration_s", Float),
    Column("codec", String(60)),
    Column("container", String(60)),
    Column("vfr", Boolean, nullable=False),
    Column("notes", Document, nullable=False),
    Column("report", Document, nullable=False),
    Column("thumbs", Document, nullable=False),
    Column("camera_id", ForeignKey("cameras.id")),
    # a pose is made from a recording and serves recordings: this one is added last
    Column("pose_id", ForeignKey("road_poses.id", use_alter=True)),
    Column("lighting", String(20)),
    Column("lighting_proposed", String(20)),
    # whether the camera moved since its pose was taken, and what a person decided about it
    Column("drift", Document),
    Column("drift_decision", Document),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("deleted_at", Moment),
    one_of("state", ("ingesting", "ready", "failed")),
    one_of("lighting", LIGHTING),
    one_of("lighting_proposed", LIGHTING),
    CheckConstraint("state <> 'ready' OR frame_count IS NOT NULL", name="ready_has_frames"),
    CheckConstraint("state <> 'failed' OR error IS NOT NULL", name="failed_has_error"),
)

frames = Table(
    "frames",
    metadata,
    Column("recording_id", ForeignKey("recordings.id"), primary_key=True),
    Column("n", Integer, primary_key=True, autoincrement=False),
    Column("pts", BigInteger, nullable=False),
    Column("time_s", Float, nullable=False),
    Column("key", Boolean, nullable=False),
    Column("crc32", BigInteger, nullable=False),
    CheckConstraint("n >= 0", name="n_counts"),
    sqlite_with_rowid=False,
)

uploads = Table(
    "uploads",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("filename", String(400), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    Column("offset", BigInteger, nullable=False),
    Column("media_key", String(400), nullable=False),
    Column("recording_id", ForeignKey("recordings.id")),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("finished_at", Moment),
    # a video becomes a recording; a strip waits, with its content's hash, for the scan that it belongs to
    Column("purpose", String(20), nullable=False, server_default="video"),
    Column("sha256", String(64)),
    Column("scan_id", Integer, ForeignKey("scans.id", use_alter=True)),
    one_of("purpose", ("video", "strip")),
    CheckConstraint('"offset" >= 0 AND "offset" <= size_bytes', name="offset_within"),
)

road_poses = Table(
    "road_poses",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False),
    Column("calibration_id", ForeignKey("calibrations.id"), nullable=False),
    Column("first_frame", Integer, nullable=False),
    Column("last_frame", Integer, nullable=False),
    Column("rms_px", Float),
    Column("distance_m", Float),
    Column("summary", Text, nullable=False),
    Column("document", Document, nullable=False),
    Column("warnings", Document, nullable=False),
    Column("expected", Document, nullable=False),
    Column("overlay", Document, nullable=False),
    # a pose turned about the road's normal after the traffic's own direction
    Column("turned_from", ForeignKey("road_poses.id")),
    Column("turned_by_rad", Float),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    CheckConstraint("first_frame >= 0 AND last_frame >= first_frame", name="span_forward"),
)

catalogue = Table(
    "catalogue",
    metadata,
    identity(),
    Column("make", String(100), nullable=False),
    Column("model", String(200), nullable=False),
    Column("year_from", Integer),
    Column("year_to", Integer),
    Column("category", String(20)),
    Column("height_m", Float),
    Column("length_m", Float),
    Column("width_m", Float),
    Column("wheelbase_m", Float),
    Column("source", Text, nullable=False),
    Column("search_text", Text, nullable=False),
    one_of("category", ("hatchback", "saloon", "estate", "suv", "van", "lorry", "other")),
)
Index("ix_catalogue_make_model_year_from", catalogue.c.make, catalogue.c.model, catalogue.c.year_from)
