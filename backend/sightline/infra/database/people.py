"""The accounts: who did what is kept by id everywhere, so these two tables lie below every other."""

from sqlalchemy import Boolean, Column, ForeignKey, Integer, String, Text, UniqueConstraint, true

from sightline.enums import Role
from sightline.infra.database.types import UtcDateTime, enum_check, numbered_table

people = numbered_table(
    "people",
    Column("name", String(200), nullable=False),
    Column("email", String(320), nullable=False),
    Column("role", String(20), nullable=False),
    Column("active", Boolean, nullable=False, server_default=true()),
    Column("password_hash", Text),
    Column("session_key", Integer, nullable=False, server_default="1"),
    Column("created_at", UtcDateTime, nullable=False),
    Column("last_seen_at", UtcDateTime),
    UniqueConstraint("email"),
    enum_check("role", Role),
)


sign_in_links = numbered_table(
    "sign_in_links",
    Column("person_id", ForeignKey("people.id"), nullable=False, index=True),
    Column("token_hash", String(64), nullable=False),
    Column("created_at", UtcDateTime, nullable=False),
    Column("expires_at", UtcDateTime, nullable=False),
    Column("used_at", UtcDateTime),
    UniqueConstraint("token_hash"),
)
