"""The table of the catalogue."""

from sqlalchemy import (
    CheckConstraint,
    Column,
    Float,
    Index,
    Integer,
    String,
    Table,
    Text,
)

from sightline.enums import Category
from sightline.infra.database.types import UtcDateTime, enum_check, identity, metadata
from sightline.vehicles.catalogue.records import SIZES

catalogue = Table(
    "catalogue",
    metadata,
    identity(),
    Column("make", String(100), nullable=False),
    Column("model", String(200), nullable=False),
    Column("year_from", Integer),
    Column("year_to", Integer),
    Column("category", String(20)),
    *(Column(f"{name}_m", Float) for name in SIZES),
    *(Column(f"u_{name}_m", Float) for name in SIZES),
    *(Column(f"{name}_source", Text) for name in SIZES),
    Column("source", Text, nullable=False),
    Column("search_text", Text, nullable=False),
    Column("version", Integer, nullable=False, server_default="1"),
    Column("retired_at", UtcDateTime),
    enum_check("category", Category),
    CheckConstraint("version >= 1", name="version_counts"),
)


Index("ix_catalogue_make_model_year_from", catalogue.c.make, catalogue.c.model, catalogue.c.year_from)
