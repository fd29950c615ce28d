"""What a database says of itself for its backup: schema, ends of the audit chains, media that it needs."""

from collections.abc import Mapping

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.audit.tables import audit_events
from sightline.infra.database.types import metadata
from sightline.infra.slices import load_tables

Heads = Mapping[str, tuple[int, str]]


def heads_of(session: Session) -> dict[str, tuple[int, str]]:
    """The end of every audit chain."""
    return {name: (end.count, end.hash) for name, end in trail.heads(session).items()}


def continues(session: Session, heads: Heads) -> bool:
    """Whether every chain still goes through the end that an earlier backup noted."""
    e = audit_events.c
    for name, (count, hash_) in heads.items():
        query = select(e.hash).where(e.chain == name, e.number == count)
        if count and session.execute(query).scalar_one_or_none() != hash_:
            return False
    return True


def needed_media(session: Session, key: str | None = None) -> set[str]:
    """The keys of the media store without which a row would show nothing, or `key` alone if it is one."""
    load_tables()
    keys: set[str] = set()
    for table in metadata.sorted_tables:
        for column in table.columns:
            if "needs_media" in column.info:
                query = select(column).where(column.is_not(None), column.info["needs_media"](table.c))
                if "deleted_at" in table.c:
                    query = query.where(table.c.deleted_at.is_(None))
                if key is not None:
                    query = query.where(column == key).limit(1)
                keys |= set(session.execute(query).scalars())
    return keys
