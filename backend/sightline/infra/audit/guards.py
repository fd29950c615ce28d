"""The triggers by which the database itself refuses to change what is written once: whether they stand."""

from sqlalchemy import Connection, text

from sightline.errors import Damaged
from sightline.infra.audit.tables import audit_events
from sightline.infra.audit.vouched import WrittenOnce, WrittenOnceApart, marked_tables

# The names that migrations give them: of changing, removing and replacing a row.
_SQLITE = ("update", "delete", "replace")
_POSTGRESQL = ("row", "statement")
_IN_SQLITE = text("SELECT name FROM sqlite_master WHERE type = 'trigger'")
# O: as ever; A: for replicas too. D and R do not act here.
_IN_POSTGRESQL = text("""
    SELECT t.tgname FROM pg_trigger t JOIN pg_class c ON c.oid = t.tgrelid
    WHERE NOT t.tgisinternal AND t.tgenabled IN ('O', 'A')
      AND c.relnamespace = (SELECT oid FROM pg_namespace WHERE nspname = current_schema())
""")


def require_guards(connection: Connection) -> None:
    """Raises Damaged, naming the table, where a trigger is missing or switched off."""
    on_postgresql = connection.dialect.name == "postgresql"
    standing = set(connection.execute(_IN_POSTGRESQL if on_postgresql else _IN_SQLITE).scalars())
    once = [table.name for mark, table in marked_tables() if isinstance(mark, WrittenOnce | WrittenOnceApart)]
    for table in (audit_events.name, *once):
        for what in _POSTGRESQL if on_postgresql else _SQLITE:
            if f"{table}_refuse_{what}" not in standing:
                raise Damaged("audit-guard-missing", table=table)
