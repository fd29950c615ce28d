"""Queries of many rows as Arrow tables, read by ADBC: exact doubles and ids, no Python object a value.

ADBC opens a connection of its own, and what it reads must be the session's state of the database. PostgreSQL
lends the session's snapshot; SQLite has none to lend, so the state is compared, and where a write came
between (or ADBC cannot be had) the rows are fetched through the session, several times slower. On SQLite ADBC
runs in another process; `arrow_child` says why.
"""

import json
import logging
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO, Any

import adbc_driver_manager
import pyarrow as pa
from adbc_driver_manager import AdbcConnection, AdbcStatement
from sqlalchemy import Float, Integer, Select, SelectBase, func, literal, select, union_all
from sqlalchemy.orm import Session
from sqlalchemy.types import TypeEngine

from sightline.infra.database.types import UtcDateTime

log = logging.getLogger(__name__)

_CHILD = "sightline.infra.database.arrow_child"
_OTHER_STATE = 3  # the child's


class _NotThisState(Exception):
    """Another connection does not see what the session sees."""


def arrow_tables(session: Session, state: Select[Any], queries: Sequence[Select[Any]]) -> list[pa.Table]:
    """The answers of queries, columns named as there, rows in no order, all from the session's state.

    state: gives one value, which is another one after every write that the queries could see. Columns are
    int64 (or int32), float64, string or timestamp, with nulls; queries must not be ordered.
    """
    try:
        return _by_adbc(session, state, queries)
    except _NotThisState:
        log.info("a write came between; the columns are read row by row")
    except (OSError, pa.ArrowException, adbc_driver_manager.Error) as error:
        log.warning("ADBC cannot read the database, so the columns are read row by row: %s", error)
    return [arrow_rows(session, query) for query in queries]


def arrow_rows(session: Session, query: Select[Any]) -> pa.Table:
    """The answer of a query of few rows, without ADBC, whose beginning costs as much as 20,000 rows."""
    columns = query.selected_columns.items()
    rows = session.execute(query).all()
    values = zip(*rows, strict=True) if rows else [()] * len(columns)
    return pa.table(
        {name: pa.array(of, _kind(column.type)) for (name, column), of in zip(columns, values, strict=True)}
    )


def _by_adbc(session: Session, state: Select[Any], queries: Sequence[Select[Any]]) -> list[pa.Table]:
    expected = session.execute(state).scalar_one()
    if session.get_bind().dialect.name == "sqlite":
        return _sqlite_tables(session, _sql(session, state), expected, queries)
    return _postgresql_tables(session, _sql(session, state), expected, queries)


def _sqlite_tables(
    session: Session, state: str, expected: object, queries: Sequence[Select[Any]]
) -> list[pa.Table]:
    path = next(row[2] for row in session.connection().exec_driver_sql("PRAGMA database_list"))
    asked = {
        "uri": f"{Path(path).as_uri()}?mode=ro",
        "state": state,
        "expected": expected,
        "queries": [_sql(session, union_all(_zeros(query), query)) for query in queries],
    }
    with subprocess.Popen(
        [sys.executable, "-m", _CHILD], stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=_environment()
    ) as child:
        assert child.stdin is not None and child.stdout is not None
        child.stdin.write(json.dumps(asked).encode())
        child.stdin.close()
        try:
            return [_received(child.stdout) for _ in queries]
        except pa.ArrowException:
            if child.wait() == _OTHER_STATE:
                raise _NotThisState from None
            raise


def _received(stream: IO[bytes]) -> pa.Table:
    """One answer without its row of zeros. Raises pa.ArrowException where it is not whole."""
    with pa.ipc.open_stream(stream) as answer:
        return answer.read_all().slice(1)


def _postgresql_tables(
    session: Session, state: str, expected: object, queries: Sequence[Select[Any]]
) -> list[pa.Table]:
    import adbc_driver_postgresql

    url = session.connection().engine.url.set(drivername="postgresql").render_as_string(hide_password=False)
    snapshot = session.execute(select(func.pg_export_snapshot())).scalar_one()
    with adbc_driver_postgresql.connect(url) as database, AdbcConnection(database) as connection:
        connection.set_autocommit(False)
        _read(connection, "SET TRANSACTION ISOLATION LEVEL REPEATABLE READ")
        _read(connection, f"SET TRANSACTION SNAPSHOT '{snapshot}'")
        if _read(connection, state).column(0).to_pylist() != [expected]:
            raise _NotThisState  # the session wrote, and has not committed
        return [_read(connection, _sql(session, query)) for query in queries]


def _read(connection: AdbcConnection, query: str) -> pa.Table:
    with AdbcStatement(connection) as statement:
        statement.set_sql_query(query)
        return pa.RecordBatchReader.from_stream(statement.execute_query()[0]).read_all()


def _sql(session: Session, query: SelectBase) -> str:
    """The query with its values written out; all are this program's own."""
    return str(query.compile(session.get_bind(), compile_kwargs={"literal_binds": True}))


def _zeros(query: Select[Any]) -> SelectBase:
    """A row of the columns' types: on SQLite, where values have types and columns none, ADBC takes a column's
    type from the first rows, which may all be NULL.
    """
    zeros = query.selected_columns.items()
    return select(*(literal(_ZERO[str(_kind(column.type))]).label(name) for name, column in zeros))


def _kind(of: TypeEngine[Any]) -> pa.DataType:
    if isinstance(of, UtcDateTime):
        return pa.timestamp("us", tz="UTC")
    if isinstance(of, Float):
        return pa.float64()
    return pa.int64() if isinstance(of, Integer) else pa.string()


_ZERO: dict[str, float | int | str] = {"double": 0.0, "int64": 0, "string": "", "timestamp[us, tz=UTC]": ""}


def _environment() -> dict[str, str]:
    """Ours, so that the child finds this very package."""
    package = str(Path(__file__).resolve().parents[3])
    paths = os.pathsep.join(path for path in (package, os.environ.get("PYTHONPATH", "")) if path)
    return {**os.environ, "PYTHONPATH": paths}
