"""Which migrations there are, and which of them a database is at."""

import os
import re
from pathlib import Path

from sqlalchemy import Connection, text

from sightline.errors import BadInput

_REVISION = re.compile(r'^revision\b[^=\n]*= *"([^"]+)"', re.MULTILINE)
_FOLLOWS = re.compile(r'^down_revision\b[^=\n]*= *"([^"]+)"', re.MULTILINE)


def migrations_folder() -> Path:
    """Where the migrations are: SIGHTLINE_MIGRATIONS, else what a wheel holds, else the checkout's."""
    named = os.environ.get("SIGHTLINE_MIGRATIONS")
    if named:
        return Path(named)
    package = Path(__file__).resolve().parents[2]
    held = package / "_migrations"
    return held if held.is_dir() else package.parents[1] / "migrations"


def newest_revision() -> str | None:
    """The revision that no migration follows, read off the files; None unless there is just one.

    A start with nothing to migrate needs no more than this: Alembic's import alone takes half as long as
    the rest of the start.
    """
    files = [path.read_text() for path in sorted((migrations_folder() / "versions").glob("*.py"))]
    made = {name for text_ in files for name in _REVISION.findall(text_)}
    heads = made - {name for text_ in files for name in _FOLLOWS.findall(text_)}
    return heads.pop() if len(heads) == 1 else None


def stored_revision(connection: Connection) -> str | None:
    """The revision that a database is at; None for an empty one."""
    if not connection.dialect.has_table(connection, "alembic_version"):
        return None
    return connection.execute(text("SELECT version_num FROM alembic_version")).scalar_one_or_none()


def require_this_version(connection: Connection) -> str:
    """The revision of the schema. Raises BadInput for one that this program would have to migrate."""
    revision = stored_revision(connection)
    if revision is None or revision != newest_revision():
        raise BadInput("audit-other-version")
    return revision
