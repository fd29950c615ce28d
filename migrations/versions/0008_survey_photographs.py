"""Photographs of a survey's set-up."""

import sqlalchemy as sa
from alembic import op

revision = "0008_survey_photographs"
down_revision = "0007_line_scans"
branch_labels = None
depends_on = None


def upgrade() -> None:
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
        sa.CheckConstraint(
            "width_px > 0 AND height_px > 0 AND size_bytes > 0",
            name=op.f("ck_survey_photographs_size_positive"),
        ),
        sa.CheckConstraint("position >= 1", name=op.f("ck_survey_photographs_position_counts")),
        sa.CheckConstraint("version >= 1", name=op.f("ck_survey_photographs_version_counts")),
        sa.ForeignKeyConstraint(["created_by"], ["people.id"], name=op.f("fk_survey_photographs_created_by")),
        sa.ForeignKeyConstraint(["survey_id"], ["surveys.id"], name=op.f("fk_survey_photographs_survey_id")),
        sa.ForeignKeyConstraint(["updated_by"], ["people.id"], name=op.f("fk_survey_photographs_updated_by")),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_survey_photographs")),
    )
    op.create_index(
        op.f("ix_survey_photographs_survey_id"), "survey_photographs", ["survey_id"], unique=False
    )
