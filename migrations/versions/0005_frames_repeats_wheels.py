"""Further frames of a measurement, repeats, both tyre contacts, operators' click sigmas, turned poses."""

import sqlalchemy as sa
from alembic import op

revision = "0005_frames_repeats_wheels"
down_revision = "0004_refuse_replacing"
branch_labels = None
depends_on = None

WRITTEN_ONCE = ("wheel_pairs", "click_sigmas")
# Plain statements: what SQLite can add to a table without making it anew, which would lose its triggers.
COLUMNS = (
    "ALTER TABLE measurements ADD COLUMN more_frames TEXT NOT NULL DEFAULT '[]'",
    "ALTER TABLE measurements ADD COLUMN solved_inset_m FLOAT",
    "ALTER TABLE measurements ADD COLUMN u_solved_inset_m FLOAT",
    "ALTER TABLE measurement_series ADD COLUMN repeat_of INTEGER "
    "CONSTRAINT fk_measurement_series_repeat_of REFERENCES measurement_series (id)",
    "ALTER TABLE road_poses ADD COLUMN turned_from INTEGER "
    "CONSTRAINT fk_road_poses_turned_from REFERENCES road_poses (id)",
    "ALTER TABLE road_poses ADD COLUMN turned_by_rad FLOAT",
)


def upgrade() -> None:
    for statement in COLUMNS:
        op.execute(statement)
    op.create_index(
        op.f("ix_measurement_series_repeat_of"), "measurement_series", ["repeat_of"], unique=False
    )
    _wheel_pairs()
    _click_sigmas()
    for table in WRITTEN_ONCE:
        _refuse_changes(table)


def _wheel_pairs() -> None:
    name = "wheel_pairs"
    points = [
        sa.Column(f"{which}_{axis}_px", sa.Float(), nullable=False)
        for which in ("first", "second")
        for axis in "xy"
    ]
    keys = {"survey_id": "surveys", "recording_id": "recordings", "vehicle_id": "vehicles"}
    op.create_table(
        name,
        sa.Column("id", sa.Integer(), nullable=False),
        *(sa.Column(key, sa.Integer(), nullable=False) for key in keys),
        sa.Column("frame", sa.Integer(), nullable=False),
        sa.Column("pts", sa.BigInteger(), nullable=False),
        sa.Column("time_s", sa.Float(), nullable=False),
        sa.Column("frame_crc", sa.BigInteger(), nullable=False),
        *points,
        sa.Column("withdrawn", sa.Boolean(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        *_foreign(name, {**keys, "created_by": "people"}),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{name}")),
    )
    for key in ("survey_id", "vehicle_id"):
        op.create_index(op.f(f"ix_{name}_{key}"), name, [key], unique=False)


def _click_sigmas() -> None:
    name = "click_sigmas"
    op.create_table(
        name,
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("survey_id", sa.Integer(), nullable=False),
        sa.Column("person_id", sa.Integer(), nullable=False),
        sa.Column("sigma_px", sa.Float(), nullable=True),
        sa.Column("pairs", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("created_by", sa.Integer(), nullable=True),
        sa.CheckConstraint("sigma_px > 0", name=op.f(f"ck_{name}_sigma_positive")),
        *_foreign(name, {"survey_id": "surveys", "person_id": "people", "created_by": "people"}),
        sa.PrimaryKeyConstraint("id", name=op.f(f"pk_{name}")),
    )
    op.create_index(op.f(f"ix_{name}_survey_id"), name, ["survey_id"], unique=False)


def _foreign(name: str, keys: dict[str, str]) -> list[sa.ForeignKeyConstraint]:
    return [
        sa.ForeignKeyConstraint([key], [f"{table}.id"], name=op.f(f"fk_{name}_{key}"))
        for key, table in keys.items()
    ]


def _refuse_changes(table: str) -> None:
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
        f"WHEN EXISTS (SELECT 1 FROM {table} WHERE id = NEW.id) "
        f"BEGIN SELECT RAISE(ABORT, '{table} is written once: REPLACE is refused'); END"
    )
