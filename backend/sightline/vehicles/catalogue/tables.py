"""The table of the catalogue."""

from sqlalchemy import CheckConstraint, Column, Index, Integer, Text

from sightline.infra.database.types import UtcDateTime, columns_for, numbered_table
from sightline.vehicles.catalogue.records import CatalogueRow

catalogue = numbered_table(
    "catalogue",
    *columns_for(CatalogueRow, {"make": 100, "model": 200}),
    Column("search_text", Text, nullable=False),
    Column("version", Integer, nullable=False, server_default="1"),
    Column("retired_at", UtcDateTime),
    CheckConstraint("version >= 1", name="version_counts"),
)


Index("ix_catalogue_make_model_year_from", catalogue.c.make, catalogue.c.model, catalogue.c.year_from)
