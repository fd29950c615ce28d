"""The table of surveys."""

from sqlalchemy import (
    Boolean,
    Column,
    Float,
    String,
    Table,
    Text,
)

from sightline.enums import CameraPlace, Hand, StreetLamps
from sightline.infra.database.types import CanonicalJson, changed_columns, enum_check, identity, metadata

surveys = Table(
    "surveys",
    metadata,
    identity(),
    Column("name", String(200), nullable=False),
    Column("site", String(200), nullable=False),
    Column("description", Text, nullable=False),
    Column("is_demo", Boolean, nullable=False),
    # No figure of it says anything of real roads; said of each study that takes it.
    Column("simulated", Boolean, nullable=False),
    # everybody who signs in acts here with the role of the account; else members alone
    Column("open_to_all", Boolean, nullable=False),
    # how traffic goes here and where the camera stands; empty while nobody has said
    Column("traffic_side", String(20)),
    Column("steering_side", String(20)),
    Column("camera_place", String(20)),
    # where it lies, what road it is, whose clocks are told; empty while nobody has said
    Column("latitude_deg", Float),
    Column("longitude_deg", Float),
    Column("road_class", String(100)),
    Column("lane", String(100)),
    Column("travel_direction", String(100)),
    Column("speed_limit_mps", Float),
    Column("street_lamps", String(20)),
    Column("time_zone", String(60)),
    # the targets asked for by lighting
    Column("asked", CanonicalJson, nullable=False),
    # by class of vehicle its set and what the EU and FHWA call it
    Column("classes", CanonicalJson, nullable=False),
    # which passes are to be measured, and how many
    Column("sampling", CanonicalJson, nullable=False),
    Column("insets", CanonicalJson, nullable=False),
    *changed_columns(),
    enum_check("traffic_side", Hand),
    enum_check("steering_side", Hand),
    enum_check("camera_place", CameraPlace),
    enum_check("street_lamps", StreetLamps),
)
