"""The table of vehicles."""

from typing import get_args

from sqlalchemy import (
    Boolean,
    CheckConstraint,
    Column,
    Float,
    ForeignKey,
    Integer,
    String,
    Table,
    Text,
    UniqueConstraint,
    false,
)

from sightline.enums import (
    Category,
    Direction,
    Discarded,
    DriverSide,
    KnownTarget,
    Lighting,
    ModelChosenBy,
    NotVisible,
    VehicleOrigin,
)
from sightline.infra.audit.vouched import ChangedByEvents, vouched
from sightline.infra.database.types import (
    CanonicalJson,
    UtcDateTime,
    changed_columns,
    enum_check,
    identity,
    metadata,
)
from sightline.vehicles.records import KNOWN, NOT_VISIBLE

vehicles = Table(
    "vehicles",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False, index=True),
    Column("number", Integer, nullable=False),
    Column("first_frame", Integer, nullable=False),
    Column("last_frame", Integer, nullable=False),
    Column("best_frame", Integer),
    Column("make", String(100)),
    Column("model", String(200)),
    Column("year", Integer),
    # chosen because it fits what was measured, by which sizes; then it is no reference
    Column("model_chosen_by", String(20)),
    Column("model_sizes", String(100)),
    Column("category", String(20)),
    Column("manufacturer_height_m", Float),
    Column("u_manufacturer_height_m", Float),
    Column("height_source", Text),
    *(
        column
        for names in (KNOWN[target] for target in get_args(KnownTarget))
        for column in (Column(names.height, Float), Column(names.u, Float), Column(names.source, Text))
    ),
    # driven by to check the measuring: no vehicle of the traffic
    Column("check_target", Boolean, nullable=False, server_default=false()),
    Column("lighting", String(20)),
    Column("notes", Text, nullable=False),
    # found by the job that looks for passes, or marked by a person; where it goes in the picture
    Column("origin", String(20), nullable=False, server_default="person"),
    Column("direction", String(20)),
    # where the driver sits, as the camera sees it; empty: as direction and the survey's traffic say
    Column("driver_side", String(20)),
    # why a target cannot be measured of this vehicle
    *(Column(name, String(20)) for name in NOT_VISIBLE.values()),
    # why it is no pass of a vehicle to be measured
    Column("discarded", String(20)),
    Column("detection", CanonicalJson),
    *changed_columns(),
    Column("deleted_at", UtcDateTime),
    UniqueConstraint("survey_id", "number"),
    enum_check("category", Category),
    enum_check("model_chosen_by", ModelChosenBy),
    enum_check("lighting", Lighting),
    enum_check("origin", VehicleOrigin),
    enum_check("direction", Direction),
    enum_check("driver_side", DriverSide),
    enum_check("discarded", Discarded),
    *(enum_check(name, NotVisible) for name in NOT_VISIBLE.values()),
    CheckConstraint("first_frame >= 0 AND last_frame >= first_frame", name="span_forward"),
    info=vouched(ChangedByEvents("vehicle")),
)
