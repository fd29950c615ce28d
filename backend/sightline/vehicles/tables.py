"""The table of vehicles."""

from sqlalchemy import Boolean, CheckConstraint, Column, ForeignKey, Integer, String, UniqueConstraint, false

from sightline.enums import VehicleOrigin
from sightline.infra.audit.vouched import table_changed_by_events
from sightline.infra.database.types import GOES_ALONG, columns_for, enum_check
from sightline.vehicles.records import VehicleFields

_LENGTHS = {"make": 100, "model": 200, "model_sizes": 100}
vehicles = table_changed_by_events(
    "vehicles",
    "vehicle",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False, index=True, info=GOES_ALONG),
    Column("number", Integer, nullable=False),
    *columns_for(VehicleFields, _LENGTHS, left_out=("check_target", "origin")),
    # driven by to check the measuring: no vehicle of the traffic
    Column("check_target", Boolean, nullable=False, server_default=false()),
    # found by the job that looks for passes, or marked by a person
    Column("origin", String(20), nullable=False, server_default="person"),
    UniqueConstraint("survey_id", "number"),
    enum_check("origin", VehicleOrigin),
    CheckConstraint("first_frame >= 0 AND last_frame >= first_frame", name="span_forward"),
)
