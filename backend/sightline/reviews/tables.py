"""The table of reviews."""

from sqlalchemy import (
    CheckConstraint,
    Column,
    ForeignKey,
    Index,
    Integer,
    String,
    Table,
    Text,
)

from sightline.enums import ReviewVerdict
from sightline.infra.database.types import Moment, identity, metadata, one_of

# `revision` is what the reviewer saw, `result_revision` what the verdict holds for (a fix makes a new one).
reviews = Table(
    "reviews",
    metadata,
    identity(),
    Column("series_id", ForeignKey("measurement_series.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    Column("result_revision", Integer, nullable=False),
    Column("verdict", String(20), nullable=False),
    Column("reason", Text),
    Column("created_at", Moment, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    one_of("verdict", ReviewVerdict),
    CheckConstraint("verdict <> 'rejected' OR reason IS NOT NULL", name="rejected_has_reason"),
)


Index("ix_reviews_series_id_result_revision", reviews.c.series_id, reviews.c.result_revision)
