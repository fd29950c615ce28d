"""The table of photographs of the set-up."""

from sqlalchemy import BigInteger, CheckConstraint, Column, ForeignKey, Integer, String, Table, Text

from sightline.infra.audit.vouched import ChangedByEvents, vouched
from sightline.infra.database.types import NEEDS_MEDIA, UtcDateTime, changed_columns, identity, metadata

# Pictures of the set-up: the rig, the road, the board in place. `position` is their order on the page.
survey_photographs = Table(
    "survey_photographs",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("name", String(400), nullable=False),
    Column("caption", Text, nullable=False),
    Column("position", Integer, nullable=False),
    Column("media_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("sha256", String(64), nullable=False),
    Column("size_bytes", BigInteger, nullable=False),
    Column("width_px", Integer, nullable=False),
    Column("height_px", Integer, nullable=False),
    *changed_columns(),
    Column("deleted_at", UtcDateTime),
    CheckConstraint("width_px > 0 AND height_px > 0 AND size_bytes > 0", name="size_positive"),
    CheckConstraint("position >= 1", name="position_counts"),
    info=vouched(ChangedByEvents("photograph")),
)
