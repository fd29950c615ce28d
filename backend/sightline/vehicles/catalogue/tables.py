"""The table of the catalogue."""

from sqlalchemy import (
    Column,
    Float,
    Index,
    Integer,
    String,
    Table,
    Text,
)

from sightline.enums import Category
from sightline.infra.database.types import enum_check, identity, metadata

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
    enum_check("category", Category),
)


Index("ix_catalogue_make_model_year_from", catalogue.c.make, catalogue.c.model, catalogue.c.year_from)
