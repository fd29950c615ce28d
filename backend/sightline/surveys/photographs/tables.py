"""The table of photographs of the set-up."""

from sqlalchemy import BigInteger, CheckConstraint, Column, ForeignKey, String

from sightline.infra.audit.vouched import table_changed_by_events
from sightline.infra.database.types import NEEDS_MEDIA, columns_for
from sightline.surveys.photographs.records import Photograph

# Pictures of the set-up: the rig, the road, the board in place. `position` is their order on the page.
survey_photographs = table_changed_by_events(
    "survey_photographs",
    "photograph",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    *columns_for(Photograph, {"name": 400}, only="name caption position"),
    Column("media_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("sha256", String(64), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    *columns_for(Photograph, only="width_px height_px"),
    CheckConstraint("width_px > 0 AND height_px > 0 AND size_bytes > 0", name="size_positive"),
    CheckConstraint("position >= 1", name="position_counts"),
)
