"""The table of photographs of the set-up."""

from sqlalchemy import BigInteger, CheckConstraint, Column, ForeignKey, Integer, String, Text

from sightline.infra.audit.vouched import table_changed_by_events
from sightline.infra.database.types import NEEDS_MEDIA

# Pictures of the set-up: the rig, the road, the board in place. `position` is their order on the page.
survey_photographs = table_changed_by_events(
    "survey_photographs",
    "photograph",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("caption", Text, nullable=False),
    Column("position", Integer, nullable=False),
    Column("media_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("sha256", String(64), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    Column("width_px", Integer, nullable=False),
    Column("height_px", Integer, nullable=False),
    CheckConstraint("width_px > 0 AND height_px > 0 AND size_bytes > 0", name="size_positive"),
    CheckConstraint("position >= 1", name="position_counts"),
)
