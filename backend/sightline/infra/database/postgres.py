"""Connections to PostgreSQL that wait for nothing without end: a dead network says nothing.

The server has limits of its own (locks, statements, what is idle in a transaction), which free what a dead
process held. They do not help a process whose connection is dead: it waits for an answer, and the kernel may
take two hours to give the connection up. So it stops waiting here, closes the connection, and says so.
"""

import math
import time
from collections.abc import AsyncGenerator, Callable, Sequence
from functools import cached_property, partial
from typing import Any

import psycopg
from psycopg.abc import PQGen
from sqlalchemy import URL, Engine, create_engine, event

#: seconds to connect; for an answer to "are you there"; to a statement that reads, or that writes in a short
#: turn, or in the turn of all
CONNECT_S, PING_S, READ_S, SHORT_WRITE_S, LONG_WRITE_S = 5, 4.0, 125.0, 10.0, 60.0
#: who answered so short a time ago is not asked whether it is there
HEARD_S = 0.25
#: after so long a silence the server is asked, over another connection, whether it is still at the statement;
#: and how long the answer of a statement that has ended may be on its way
SILENT_S, ON_ITS_WAY_S = 4.0, 1.0
#: how long PostgreSQL lets a writer wait for its turn, and a statement run; the wait is shorter than the idle
#: limit of who has the turn (engine.py), else the turn of a dead writer goes to one that died while it waited
LOCK_S, STATEMENT_S = 7, 120

_AT_WORK = "SELECT 1 FROM pg_stat_activity WHERE pid = %s AND state NOT LIKE 'idle%%'"
_KEPT_ALIVE = {"keepalives": 1, "keepalives_idle": 10, "keepalives_interval": 5, "keepalives_count": 3}
#: the same from the server's side: it gives the connection of a machine that fell off the net up
_SERVER = {
    "lock_timeout": LOCK_S * 1000,
    "statement_timeout": STATEMENT_S * 1000,
    "tcp_keepalives_idle": 10,
    "tcp_keepalives_interval": 5,
    "tcp_keepalives_count": 3,
    "tcp_user_timeout": 15_000,
}


class _Columns(Sequence[Any]):
    """The columns of a result, described when they are looked at."""

    def __init__(self, describe: Callable[[], Sequence[Any] | None]) -> None:
        self._describe = describe

    @cached_property
    def _all(self) -> Sequence[Any]:
        return self._describe() or ()

    def __len__(self) -> int:
        return len(self._all)

    def __getitem__(self, at: Any) -> Any:
        return self._all[at]


class LazyCursor(psycopg.Cursor[Any]):
    """SQLAlchemy asks what the columns are after every statement, and looks at them once for each kind: at
    the first. psycopg describes them each time, sixty of them for a click.
    """

    @property
    def description(self) -> Any:
        result = self.pgresult
        if result is None or not (result.nfields or result.status == psycopg.pq.ExecStatus.TUPLES_OK):
            return None
        return _Columns(lambda: super(LazyCursor, self).description)


class LimitedConnection(psycopg.Connection[Any]):
    """Waits `answer_s` seconds for an answer, and is closed then: nothing is known of it any more.

    A statement may run for long. So where long answers are waited for, a silent server is asked whether it
    is still at it; a connection whose statement never came there, or whose answer was lost, is closed too.
    """

    answer_s: float | None = PING_S
    #: when the server last answered, of `time.monotonic`
    heard_at_s = -math.inf
    #: opens one more like this
    another: Callable[[], psycopg.Connection[Any]]

    def wait(self, gen: PQGen[Any], interval: float = 0.1, timeout: float | None = None) -> Any:
        """What the server answers. Raises psycopg.OperationalError where it does not in time."""
        limit_s = self.answer_s if timeout is None else timeout
        until = math.inf if limit_s is None else time.monotonic() + limit_s
        try:
            patient = limit_s is not None and limit_s > SHORT_WRITE_S
            answer = super().wait(self._watch_for_lost_answer(gen) if patient else gen, interval, limit_s)
            self.heard_at_s = time.monotonic()
            return answer
        except psycopg.OperationalError:
            if time.monotonic() >= until:
                self.pgconn.finish()
            raise

    def _watch_for_lost_answer(self, gen: PQGen[Any]) -> PQGen[Any]:
        """The same; raises psycopg.OperationalError where the server has ended what it was asked."""
        ask_at_s, has_ended = time.monotonic() + SILENT_S, False
        try:
            wanted = next(gen)
            while True:
                ready = yield wanted
                wanted = gen.send(ready)
                now_s = time.monotonic()
                if ready:
                    ask_at_s, has_ended = now_s + SILENT_S, False
                elif now_s >= ask_at_s:
                    if has_ended:
                        self.pgconn.finish()
                        raise psycopg.OperationalError(
                            "the server has ended the statement: its answer is lost"
                        )
                    has_ended = self._has_ended()
                    ask_at_s = time.monotonic() + (ON_ITS_WAY_S if has_ended else SILENT_S)
        except StopIteration as end:
            return end.value

    def _has_ended(self) -> bool:
        """Whether the server says that it is at nothing for this connection; False where it says nothing."""
        try:
            with self.another() as other:
                found = other.execute(_AT_WORK, [self.info.backend_pid]).fetchone()
        except psycopg.Error:
            return False
        return found is None


class LimitedAsyncConnection(psycopg.AsyncConnection[Any]):
    """Asks short questions: what is not answered within SHORT_WRITE_S closes it. Notices are waited for."""

    async def wait(self, gen: PQGen[Any], interval: float = 0.1, timeout: float | None = None) -> Any:
        """What the server answers. Raises psycopg.OperationalError where it does not in time."""
        until = time.monotonic() + SHORT_WRITE_S
        try:
            return await super().wait(gen, interval, SHORT_WRITE_S if timeout is None else timeout)
        except psycopg.OperationalError:
            if timeout is None and time.monotonic() >= until:
                self.pgconn.finish()
            raise

    def notifies(
        self, *, timeout: float | None = None, stop_after: int | None = None
    ) -> AsyncGenerator[psycopg.Notify]:
        """As psycopg's, without the limit of an answer."""
        return super().notifies(timeout=math.inf if timeout is None else timeout, stop_after=stop_after)


def connection_arguments(url: URL) -> dict[str, Any]:
    """The limits, as libpq takes them; what the address itself says of one of them holds."""
    limits = " ".join(f"-c {name}={value}" for name, value in _SERVER.items())
    given = url.query.get("options", "")
    ours = {"connect_timeout": CONNECT_S, "tcp_user_timeout": 15_000, "application_name": "sightline"}
    named = {name: value for name, value in {**_KEPT_ALIVE, **ours}.items() if name not in url.query}
    return {**named, "options": f"{limits} {given if isinstance(given, str) else ' '.join(given)}".strip()}


def limited_engine(url: URL, **pool: Any) -> Engine:
    """An engine whose connections have these limits."""
    arguments = connection_arguments(url)
    # The one that was given back last is lent first: the server has prepared its statements.
    engine = create_engine(url, pool_pre_ping=True, pool_use_lifo=True, connect_args=arguments, **pool)
    ping = engine.dialect.do_ping

    def ping_the_silent(dbapi_connection: Any) -> bool:
        return time.monotonic() - dbapi_connection.heard_at_s < HEARD_S or ping(dbapi_connection)

    engine.dialect.do_ping = ping_the_silent  # type: ignore[method-assign]

    @event.listens_for(engine, "do_connect")
    def connect(_dialect: Any, _record: Any, given: Any, named: dict[str, Any]) -> LimitedConnection:
        connect_ = partial(LimitedConnection.connect, *given, **named, cursor_factory=LazyCursor)
        connection = connect_()
        connection.another = connect_
        return connection

    @event.listens_for(engine, "checkout")
    def lend(connection: LimitedConnection, _record: Any, _proxy: Any) -> None:
        connection.answer_s = READ_S

    @event.listens_for(engine, "checkin")
    def take_back(connection: LimitedConnection | None, _record: Any) -> None:
        if connection is not None:
            connection.answer_s = PING_S

    return engine


def limit_answers(connection: Any, seconds: float | None) -> None:
    """How long this connection waits for each answer until it is given back to the pool (None: for ever)."""
    connection.connection.driver_connection.answer_s = seconds
