"""SQLite refuses to replace what is written once: INSERT OR REPLACE goes past the DELETE triggers."""

from alembic import op

revision = "0004_refuse_replacing"
down_revision = "0003_refuse_changes"
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
# Columns that are unique beside the id: a row with the same ones would be replaced as well.
ALSO_UNIQUE = {
    "audit_events": ("hash = NEW.hash",),
    "measurement_series": ("client_key = NEW.client_key",),
    "measurements": ("(series_id = NEW.series_id AND revision = NEW.revision)",),
}


def upgrade() -> None:
    if op.get_bind().dialect.name != "sqlite":
        return  # PostgreSQL has no such statement; its upsert is an UPDATE and is refused as one
    for table in WRITTEN_ONCE:
        same = " OR ".join(("id = NEW.id", *ALSO_UNIQUE.get(table, ())))
        op.execute(
            f"CREATE TRIGGER {table}_refuse_replace BEFORE INSERT ON {table} "
            f"WHEN EXISTS (SELECT 1 FROM {table} WHERE {same}) "
            f"BEGIN SELECT RAISE(ABORT, '{table} is written once: REPLACE is refused'); END"
        )
