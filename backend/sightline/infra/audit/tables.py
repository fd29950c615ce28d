"""The audit chains and where each ends."""

from sqlalchemy import Column, ForeignKey, Index, Integer, String, Table, Text, UniqueConstraint

from sightline.infra.database.types import metadata, numbered_table

# before and after are canonical JSON text, hashed as they stand. `number` counts within a chain and leaves no
# gap; `id` is the order in which events came and is not hashed.
audit_events = numbered_table(
    "audit_events",
    Column("chain", String(40), nullable=False),
    Column("number", Integer, nullable=False),
    Column("at", String(40), nullable=False),
    Column("actor_id", ForeignKey("people.id")),
    Column("action", String(60), nullable=False),
    Column("entity", String(60), nullable=False),
    Column("entity_id", Integer),
    Column("survey_id", ForeignKey("surveys.id"), index=True),
    Column("before", Text),
    Column("after", Text),
    Column("previous_hash", String(64), nullable=False),
    Column("hash", String(64), nullable=False),
    UniqueConstraint("hash"),
    UniqueConstraint("chain", "number"),
)


Index("ix_audit_events_entity_entity_id", audit_events.c.entity, audit_events.c.entity_id)


# How long each chain is and how it ends, so that a cut tail is seen; who adds to a chain holds its row.
audit_chains = Table(
    "audit_chains",
    metadata,
    Column("name", String(40), primary_key=True),
    Column("count", Integer, nullable=False),
    Column("hash", String(64), nullable=False),
)
