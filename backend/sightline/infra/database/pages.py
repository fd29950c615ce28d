"""Whether the pages of a SQLite file still hold a database, and which tables they do not."""

from dataclasses import dataclass

from sqlalchemy import Connection
from sqlalchemy.exc import DatabaseError

from sightline.errors import Damaged
from sightline.infra.database.engine import damage_in


@dataclass(frozen=True)
class PageDamage:
    """Tables that cannot be read whole (none: the list of tables, or pages of no table), and how many can."""

    tables: tuple[str, ...]
    whole: int

    @property
    def sentence(self) -> Damaged:
        """What is damaged and what to do."""
        if not self.tables:
            return Damaged("database-damaged")
        return Damaged("database-damaged-tables", tables=", ".join(self.tables), whole=self.whole)


def page_damage(connection: Connection, *, quick: bool = False) -> PageDamage | None:
    """What is damaged of a SQLite database; None where nothing is, and on PostgreSQL, which looks itself.

    `quick`: every page and row, but not whether every index holds what its table does.
    Raises DatabaseError for anything else, such as a disk that does not answer.
    """
    depth = "quick_check" if quick else "integrity_check"
    if connection.dialect.name != "sqlite" or _is_whole(connection, f"PRAGMA {depth}(1)"):
        return None
    try:
        query = (
            "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite%' ORDER BY name"
        )
        names = list(connection.exec_driver_sql(query).scalars())
    except DatabaseError as error:
        if damage_in(str(error.orig)) is None:
            raise
        return PageDamage((), 0)
    quoted = {name: str(name).replace("'", "''").replace("%", "%%") for name in names}
    bad = [name for name in names if not _is_whole(connection, f"PRAGMA {depth}('{quoted[name]}')")]
    return PageDamage(tuple(bad), len(names) - len(bad))


def require_whole_pages(connection: Connection, *, quick: bool = False) -> None:
    """Raises Damaged, naming the tables."""
    if (damage := page_damage(connection, quick=quick)) is not None:
        raise damage.sentence


def _is_whole(connection: Connection, asking: str) -> bool:
    try:
        return list(connection.exec_driver_sql(asking).scalars()) == ["ok"]
    except DatabaseError as error:
        if damage_in(str(error.orig)) is None:
            raise
        return False
