"""A running SQLite database copied as one moment had it, by SQLite's own backup interface."""

import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

from sightline.errors import Damaged
from sightline.infra.database.engine import DatabaseAway, damage_in, read_only_address

_PAGES = 2048  # a step; between steps progress is told and Ctrl-C is heard


def copy_sqlite(source: Path, target: Path, tell: Callable[[float], None]) -> None:
    """Copy the database at `source` to the new file `target`; `tell` gets the share that is done.

    The reading transaction is held from before the first step: a step would begin the copy anew wherever
    somebody wrote between two. Writers do not wait (write-ahead log). Raises DatabaseAway, Damaged.
    """

    def step(_status: int, left: int, pages: int) -> None:
        tell(1 - left / max(pages, 1))

    try:
        with (
            closing(_open_read_only(source)) as read,
            closing(sqlite3.connect(target, isolation_level=None)) as write,
        ):
            read.execute("BEGIN")
            read.execute("SELECT count(*) FROM sqlite_master").fetchone()
            read.backup(write, pages=_PAGES, progress=step)
            read.execute("ROLLBACK")
    except sqlite3.Error as error:
        if damage_in(str(error)) is not None:
            raise Damaged("database-damaged") from error
        raise DatabaseAway("backup-database-not-copied", path=source, said=str(error)) from error


def _open_read_only(path: Path) -> sqlite3.Connection:
    address = read_only_address(path)
    return sqlite3.connect(address or path, uri=address is not None, timeout=10, isolation_level=None)


def settle(path: Path) -> None:
    """Put all of a database that nobody uses into its one file, without a log beside it."""
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        connection.execute("PRAGMA journal_mode=DELETE").fetchone()
