"""Reads a SQLite file with ADBC in a process of its own and writes what it finds to standard output.

Never import ADBC's SQLite driver beside Python's `sqlite3`: it brings its own copy of SQLite, and a copy that
closes a file drops the locks of the other one in the same process (sqlite.org/howtocorrupt.html, 2.2.1), so
that two writers could be at work. See DECISIONS 20.
"""

import json
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import BinaryIO

import adbc_driver_sqlite
import pyarrow as pa
from adbc_driver_manager import AdbcConnection, AdbcStatement

OTHER_STATE = 3
_BATCH_ROWS = str(2**16)


def send(uri: str, state: str, expected: object, queries: Sequence[str], out: BinaryIO) -> int:
    """Each query's answer as one Arrow stream, all from one state of the database; 0, or OTHER_STATE and
    nothing sent where the query `state` does not give the value `expected`.
    """
    with adbc_driver_sqlite.connect(uri) as database, AdbcConnection(database) as connection:
        connection.set_autocommit(False)
        with answered(connection, state) as answer:
            if answer.read_all().column(0).to_pylist() != [expected]:
                return OTHER_STATE
        for query in queries:
            with answered(connection, query) as answer, pa.ipc.new_stream(out, answer.schema) as stream:
                for batch in answer:
                    stream.write_batch(batch)
        out.flush()
    return 0


@contextmanager
def answered(connection: AdbcConnection, query: str) -> Iterator[pa.RecordBatchReader]:
    """The answer of a query, to be read before the end."""
    with AdbcStatement(connection) as statement:
        statement.set_options(**{"adbc.sqlite.query.batch_rows": _BATCH_ROWS})
        statement.set_sql_query(query)
        with pa.RecordBatchReader.from_stream(statement.execute_query()[0]) as answer:
            yield answer


if __name__ == "__main__":
    sys.exit(send(**json.load(sys.stdin), out=sys.stdout.buffer))
