"""The database refuses to change or remove what is written once, and the audit chain gets its anchor."""

import sqlalchemy as sa
from alembic import op

revision = "0003_refuse_changes"
down_revision = "0002_measurements"
branch_labels = None
depends_on = None

WRITTEN_ONCE = (
    "audit_events",
    "measurement_series",
    "measurements",
    "reviews",
    "calibrations",
    "road_poses",
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
    op.execute(
        sa.text("INSERT INTO audit_anchor (id, count, hash) VALUES (1, 0, :hash)").bindparams(hash="0" * 64)
    )
    if op.get_bind().dialect.name == "postgresql":
        op.execute(FUNCTION)
        for table in WRITTEN_ONCE:
            for event, level in (("UPDATE OR DELETE", "ROW"), ("TRUNCATE", "STATEMENT")):
                op.execute(
                    f"CREATE TRIGGER {table}_refuse_{level.lower()} BEFORE {event} ON {table} "
                    f"FOR EACH {level} EXECUTE FUNCTION sightline_refuse_change()"
                )
        return
    for table in WRITTEN_ONCE:
        for event in ("UPDATE", "DELETE"):
            op.execute(
                f"CREATE TRIGGER {table}_refuse_{event.lower()} BEFORE {event} ON {table} "
                f"BEGIN SELECT RAISE(ABORT, '{table} is written once: {event} is refused'); END"
            )
