"""One writer at a time, queued on the event loop instead of in the thread pool."""

import asyncio
from collections import deque
from collections.abc import AsyncIterator, Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, asynccontextmanager
from contextvars import Context, copy_context
from dataclasses import dataclass, field
from typing import Any, TypeVar, cast

import anyio
from sqlalchemy.orm import Session

from sightline.infra.database.engine import InSurvey
from sightline.infra.services import Services
from sightline.infra.web.turns import WAIT_S, Turns

Result = TypeVar("Result")
#: Transactions that share one wait for the disk; others get their turn after so many.
MOST_TOGETHER = 16


@dataclass(slots=True, eq=False)
class _Write:
    """A transaction that waits to be done: for which request, of which survey, what it does.

    `asked_in`: what is known of the request, on whichever thread it is done.
    """

    services: Services
    survey: InSurvey
    work: Callable[[Session], Any]
    answer: "asyncio.Future[Any]"
    asked_in: Context = field(default_factory=copy_context)
    result: Any = None
    error: Exception | None = None

    def tell(self) -> None:
        """Answer the request, if it still waits."""
        if self.answer.done():
            return
        if self.error is not None:
            self.answer.set_exception(self.error)
        else:
            self.answer.set_result(self.result)


class WriteGate:
    """Opens and closes write transactions for routes that run in any thread of the pool.

    Waiting on the event loop takes no thread: with the wait in the pool, forty waiting writers would leave
    none for the one that holds the lock, and nothing would move again. Beginning and ending happen on one
    thread of their own, because the store's lock must be given back by the thread that took it; another waits
    for the disk, so that the next are written meanwhile.
    """

    def __init__(self, wait_s: float = WAIT_S) -> None:
        self.turns = Turns(1, wait_s)
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="writer")
        self._disk_thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="disk")
        self._short: deque[_Write] = deque()
        self._leading: asyncio.Task[None] | None = None
        self._committed: list[_Write] = []
        self._syncing: asyncio.Task[None] | None = None

    @property
    def waiting(self) -> int:
        """How many requests wait to write; the first of the short ones waits for the turn of them all."""
        return self.turns.waiting + max(0, len(self._short) - 1)

    @asynccontextmanager
    async def unit(self, opened: AbstractContextManager[Session]) -> AsyncIterator[Session]:
        """One write transaction, rolled back on any error. Raises Busy where its turn does not come."""
        async with self.turns.turn():
            session = await self._run(self._thread, opened.__enter__)
            try:
                yield session
            except BaseException as error:
                await self._run(self._thread, opened.__exit__, type(error), error, error.__traceback__)
                raise
            await self._run(self._thread, opened.__exit__, None, None, None)

    async def write(self, services: Services, survey: InSurvey, work: Callable[[Session], Result]) -> Result:
        """What `work` returns of a transaction of its own in a survey, when it is on the disk.

        It is done on the writers' thread, with those that came meanwhile: one after the other, each committed
        or rolled back by itself, and one wait for the disk for all that were committed since the last one
        began. Raises what `work` raises, and Busy where its turn does not come in time.
        """
        pending = _Write(services, survey, work, asyncio.get_running_loop().create_future())
        self._short.append(pending)
        if self._leading is None:
            self._leading = asyncio.create_task(self._lead())
        return cast(Result, await pending.answer)

    async def _lead(self) -> None:
        """Until nobody waits: take those that do, let them be written, answer them or let them be synced."""
        try:
            while self._short:
                some: list[_Write] = []
                try:
                    async with self.turns.turn():
                        some = self._next()
                        unsynced = len(some) > 1 or self._syncing is not None
                        await self._run(self._thread, _write_each, some, unsynced)
                except Exception as error:  # their turn did not come
                    some, unsynced = some or self._next(), False
                    for one in some:
                        one.error = error
                self._answer(some, unsynced)
        finally:
            self._leading = None

    def _answer(self, some: Sequence[_Write], unsynced: bool) -> None:
        """Tell who is on the disk, or failed; the others when the disk has them."""
        for pending in some:
            if unsynced and pending.error is None:
                self._committed.append(pending)
            else:
                pending.tell()
        if self._committed and self._syncing is None:
            self._syncing = asyncio.create_task(self._sync())

    async def _sync(self) -> None:
        """Until all that was committed is on the disk."""
        try:
            while self._committed:
                some, self._committed = self._committed, []
                await self._run(self._disk_thread, _sync_all, some)
                for one in some:
                    one.tell()
        finally:
            self._syncing = None

    def _next(self) -> list[_Write]:
        return [self._short.popleft() for _ in range(min(MOST_TOGETHER, len(self._short)))]

    async def _run(
        self, thread: ThreadPoolExecutor, function: Callable[..., Result], *arguments: Any
    ) -> Result:
        # Shielded: a request that goes away must not leave a transaction open behind it.
        with anyio.CancelScope(shield=True):
            loop = asyncio.get_running_loop()
            result = await loop.run_in_executor(thread, function, *arguments)
        return result


def _write_each(some: Sequence[_Write], unsynced: bool) -> None:
    """Each transaction by itself; of unsynced ones nobody is told before `_sync_all`."""
    for pending in some:
        try:
            with pending.services.writing(pending.survey, unsynced=unsynced) as session:
                pending.result = pending.asked_in.run(pending.work, session)
        except Exception as error:
            pending.error = error


def _sync_all(some: Sequence[_Write]) -> None:
    """The disk is waited for once, and whoever is not on it is not stored."""
    for services in {one.services for one in some}:
        try:
            services.sync()
        except Exception as error:
            for one in some:
                one.error = error
