"""Heights in line scans: poses of the line camera from rod marks, heights of scanned vehicles."""

import sqlalchemy as sa
from alembic import op

revision = "0009_line_heights"
down_revision = "0008_survey_photographs"
branch_labels = None
depends_on = None

# What is written once, and the columns that are unique in it beside the id.
WRITTEN_ONCE = {
    "line_poses": " OR (scan_id = NEW.scan_id AND revision = NEW.revision)",
    "line_heights": " OR (vehicle_id = NEW.vehicle_id AND target = NEW.target AND revision = NEW.revision)",
}


def upgrade() -> None:
    _line_poses()
    _line_heights()
    for table, also_unique in WRITTEN_ONCE.items():
        _refuse_changes(table, also_unique)


def _line_poses() -> None:
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
        *_foreign("line_poses", survey_id="surveys", scan_id="scans", created_by="people"),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_line_poses")),
        sa.UniqueConstraint("scan_id", "revision", name=op.f("uq_line_poses_scan_id_revision")),
    )
    op.create_index(op.f("ix_line_poses_survey_id"), "line_poses", ["survey_id"], unique=False)


def _line_heights() -> None:
    op.create_table(
        "line_heights",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("scan_id", sa.Integer(), nullable=False),
        sa.Column("vehicle_id", sa.Integer(), nullable=False),
        sa.Column("target", sa.String(length=20), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("pose_id", sa.Integer(), nullable=False),
        *(
            sa.Column(name, sa.Float(), nullable=False)
            for name in ("contact_line", "contact_row_px", "target_line", "target_row_px")
        ),
        *(sa.Column(name, sa.Float(), nullable=False) for name in ("sigma_px", "inset_m", "u_inset_m")),
        *(
            sa.Column(name, sa.Float(), nullable=True)
            for name in ("distance_m", "u_distance_m", "height_m", "u_height_m")
        ),
        sa.Column("status", sa.String(length=20), nullable=False),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("budget", sa.Text(), nullable=False),
        sa.Column("warnings", sa.Text(), nullable=False),
        sa.Column("withdrawn", sa.Boolean(), nullable=False),
        sa.Column("code_version", sa.String(length=60), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint(
            "target IN ('roof', 'driver_eye', 'taillight', 'headlight', 'other')",
            name=op.f("ck_line_heights_target_known"),
        ),
        sa.CheckConstraint("status IN ('ok', 'not_measurable')", name=op.f("ck_line_heights_status_known")),
        sa.CheckConstraint("revision >= 1", name=op.f("ck_line_heights_revision_counts")),
        sa.CheckConstraint(
            "(status = 'ok' AND height_m IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
            name=op.f("ck_line_heights_height_or_reason"),
        ),
        *_foreign(
            "line_heights",
            survey_id="surveys",
            scan_id="scans",
            vehicle_id="scan_vehicles",
            pose_id="line_poses",
            created_by="people",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_line_heights")),
        sa.UniqueConstraint(
            "vehicle_id", "target", "revision", name=op.f("uq_line_heights_vehicle_id_target_revision")
        ),
    )
    op.create_index(op.f("ix_line_heights_scan_id"), "line_heights", ["scan_id"], unique=False)
    op.create_index(op.f("ix_line_heights_survey_id"), "line_heights", ["survey_id"], unique=False)


def _foreign(table: str, **keys: str) -> list[sa.ForeignKeyConstraint]:
    return [
        sa.ForeignKeyConstraint([column], [f"{other}.id"], name=op.f(f"fk_{table}_{column}"))
        for column, other in keys.items()
    ]


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
