"""The keys that requests bore which stored something, and what they were answered."""

from sqlalchemy import Column, ForeignKey, Index, Integer, String, Table, Text

from sightline.infra.database.types import UtcDateTime, metadata

# Written with the event, so that a write without its key, or a key without its write, cannot be; the answer
# comes after it. `fingerprint`: of method, address and body. Gone after some days.
idempotency_keys = Table(
    "idempotency_keys",
    metadata,
    Column("person_id", ForeignKey("people.id"), primary_key=True),
    Column("key", String(100), primary_key=True),
    Column("fingerprint", String(64), nullable=False),
    Column("at", UtcDateTime, nullable=False),
    Column("event_id", ForeignKey("audit_events.id"), nullable=False),
    Column("status", Integer),
    Column("answer", Text),
    Index(None, "at"),
)
