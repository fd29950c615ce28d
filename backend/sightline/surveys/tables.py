"""The table of surveys."""

from sqlalchemy import (
    Boolean,
    CheckConstraint,
    Column,
    ForeignKey,
    Integer,
    String,
    Table,
    Text,
)

from sightline.infra.database.types import CanonicalJson, UtcDateTime, identity, metadata

surveys = Table(
    "surveys",
    metadata,
    identity(),
    Column("name", String(200), nullable=False),
    Column("site", String(200), nullable=False),
    Column("description", Text, nullable=False),
    Column("is_demo", Boolean, nullable=False),
    Column("insets", CanonicalJson, nullable=False),
    Column("version", Integer, nullable=False),
    Column("created_at", UtcDateTime, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("updated_at", UtcDateTime, nullable=False),
    Column("updated_by", ForeignKey("people.id")),
    CheckConstraint("version >= 1", name="version_counts"),
)
