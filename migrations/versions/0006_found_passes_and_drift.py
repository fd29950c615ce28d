"""Passes that a job found, and what was found out about a camera that moved."""

from alembic import op

revision = "0006_found_passes_and_drift"
down_revision = "0005_frames_repeats_wheels"
branch_labels = None
depends_on = None

COLUMNS = (
    "ALTER TABLE vehicles ADD COLUMN origin VARCHAR(20) NOT NULL DEFAULT 'person' "
    "CONSTRAINT ck_vehicles_origin_known CHECK (origin IN ('person', 'found'))",
    "ALTER TABLE vehicles ADD COLUMN direction VARCHAR(20) "
    "CONSTRAINT ck_vehicles_direction_known CHECK (direction IN ('right', 'left'))",
    "ALTER TABLE vehicles ADD COLUMN detection TEXT",
    "ALTER TABLE recordings ADD COLUMN drift TEXT",
    "ALTER TABLE recordings ADD COLUMN drift_decision TEXT",
)


def upgrade() -> None:
    for statement in COLUMNS:
        op.execute(statement)
