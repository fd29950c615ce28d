"""Tokens with which programs speak for a person."""

from sqlalchemy import Column, ForeignKey, String, UniqueConstraint

from sightline.infra.database.types import CanonicalJson, UtcDateTime, numbered_table

api_tokens = numbered_table(
    "api_tokens",
    Column("person_id", ForeignKey("people.id"), nullable=False, index=True),
    Column("name", String(200), nullable=False),
    Column("token_hash", String(64), nullable=False),
    Column("scopes", CanonicalJson, nullable=False),
    Column("created_at", UtcDateTime, nullable=False),
    Column("expires_at", UtcDateTime, nullable=False),
    Column("revoked_at", UtcDateTime),
    Column("last_used_at", UtcDateTime),
    UniqueConstraint("token_hash"),
)
