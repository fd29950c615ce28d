"""What was counted against a limit: shared by every process of the app, so a limit is one limit."""

from sqlalchemy import Column, Index, Integer, String

from sightline.infra.database.types import UtcDateTime, numbered_table

# `key` is a hash of what is counted (an address, an account): no list of who tried to sign in from where.
counted = numbered_table(
    "counted",
    Column("key", String(64), nullable=False),
    Column("at", UtcDateTime, nullable=False),
    Column("amount", Integer, nullable=False),
    Index(None, "key", "at"),
    Index(None, "at"),
)
