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

from sightline.enums import CameraPlace, Hand
from sightline.infra.database.types import CanonicalJson, UtcDateTime, enum_check, identity, metadata

surveys = Table(
    "surveys",
    metadata,
    identity(),
    Column("name", String(200), nullable=False),
    Column("site", String(200), nullable=False),
    Column("description", Text, nullable=False),
    Column("is_demo", Boolean, nullable=False),
    # how traffic goes here and where the camera stands; empty while nobody has said
    Column("traffic_side", String(20)),
    Column("steering_side", String(20)),
    Column("camera_place", String(20)),
    # the targets asked for by lighting
    Column("asked", CanonicalJson, nullable=False),
    # by class of vehicle its set and what the EU and FHWA call it
    Column("classes", CanonicalJson, nullable=False),
    # which passes are to be measured, and how many
    Column("sampling", CanonicalJson, nullable=False),
    Column("insets", CanonicalJson, nullable=False),
    Column("version", Integer, nullable=False),
    Column("created_at", UtcDateTime, nullable=False),
    Column("created_by", ForeignKey("people.id")),
    Column("updated_at", UtcDateTime, nullable=False),
    Column("updated_by", ForeignKey("people.id")),
    enum_check("traffic_side", Hand),
    enum_check("steering_side", Hand),
    enum_check("camera_place", CameraPlace),
    CheckConstraint("version >= 1", name="version_counts"),
)
