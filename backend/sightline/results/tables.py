"""The table of exports."""

from sqlalchemy import (
    BigInteger,
    Column,
    ForeignKey,
    Integer,
    String,
)

from sightline.infra.audit.vouched import CarriesHead, vouched_info
from sightline.infra.database.types import (
    NEEDS_MEDIA,
    CanonicalJson,
    made_columns,
    numbered_table,
)

exports = numbered_table(
    "exports",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("media_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("size_bytes", BigInteger, nullable=False),
    Column("sha256", String(64), nullable=False),
    # the chain as it stood when the package was made: proof against a cut tail
    Column("audit_count", Integer, nullable=False),
    Column("audit_head", String(64), nullable=False),
    # the vehicles that its statistics and report are of
    Column("selection", CanonicalJson, nullable=False),
    # that of the figures and the report
    Column("language", String(20), nullable=False),
    *made_columns(),
    info=vouched_info(CarriesHead()),
)
