"""Whether the pages of a SQLite file still hold a database, and which tables they do not."""

from sqlalchemy import Connection
from sqlalchemy.exc import DatabaseError

from sightline.errors import Damaged
from sightline.infra.database.engine import damage_in


def require_whole_pages(connection: Connection, *, quick: bool = False) -> None:
    """Raises Damaged, naming the tables of a SQLite database that cannot be read whole (none: the list of
    tables, or pages of no table); PostgreSQL looks itself.

    `quick`: every page and row, but not whether every index holds what its table does.
    Raises DatabaseError for anything else, such as a disk that does not answer.
    """
    depth = "quick_check" if quick else "integrity_check"
    if connection.dialect.name != "sqlite" or _is_whole(connection, f"PRAGMA {depth}(1)"):
        return
    try:
        query = (
            "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite%' ORDER BY name"
        )
        names = list(connection.exec_driver_sql(query).scalars())
    except DatabaseError as error:
        if damage_in(str(error.orig)) is None:
            raise
        raise Damaged("database-damaged") from error
    quoted = {name: str(name).replace("'", "''").replace("%", "%%") for name in names}
    bad = [name for name in names if not _is_whole(connection, f"PRAGMA {depth}('{quoted[name]}')")]
    if not bad:
        raise Damaged("database-damaged")
    raise Damaged("database-damaged-tables", tables=", ".join(bad), whole=len(names) - len(bad))


def _is_whole(connection: Connection, asking: str) -> bool:
    try:
        return list(connection.exec_driver_sql(asking).scalars()) == ["ok"]
    except DatabaseError as error:
        if damage_in(str(error.orig)) is None:
            raise
        return False
