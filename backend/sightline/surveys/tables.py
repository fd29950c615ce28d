"""The table of surveys."""

from sqlalchemy import Boolean, Column, String, Text

from sightline.geometry.sides import TrafficFacts
from sightline.infra.database.types import CanonicalJson, changed_columns, columns_for, numbered_table
from sightline.surveys.place import Place

_CHARACTERS = {"road_class": 100, "lane": 100, "travel_direction": 100, "time_zone": 60}

surveys = numbered_table(
    "surveys",
    Column("name", String(200), nullable=False),
    Column("site", String(200), nullable=False),
    Column("description", Text, nullable=False),
    Column("is_demo", Boolean, nullable=False),
    # No figure of it says anything of real roads; said of each study that takes it.
    Column("simulated", Boolean, nullable=False),
    # everybody who signs in acts here with the role of the account; else members alone
    Column("open_to_all", Boolean, nullable=False),
    # how traffic goes here and where the camera stands; empty while nobody has said
    *columns_for(TrafficFacts),
    # where it lies, what road it is, whose clocks are told; empty while nobody has said
    *columns_for(Place, _CHARACTERS),
    # the targets asked for by lighting
    Column("asked", CanonicalJson, nullable=False),
    # by class of vehicle its set and what the EU and FHWA call it
    Column("classes", CanonicalJson, nullable=False),
    # which passes are to be measured, and how many
    Column("sampling", CanonicalJson, nullable=False),
    Column("insets", CanonicalJson, nullable=False),
    *changed_columns(),
)
