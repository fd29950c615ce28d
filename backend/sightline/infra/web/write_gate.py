"""One writer at a time, queued on the event loop instead of in the thread pool."""

import asyncio
from collections.abc import AsyncIterator, Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, asynccontextmanager
from typing import Any, TypeVar

import anyio
from sqlalchemy.orm import Session

from sightline.infra.web.turns import WAIT_S, Turns

Result = TypeVar("Result")


class WriteGate:
    """Opens and closes write transactions for routes that run in any thread of the pool.

    Waiting on the event loop takes no thread: with the wait in the pool, forty waiting writers would leave
    none for the one that holds the lock, and nothing would move again. Beginning and ending happen on one
    thread of their own, because the store's lock must be given back by the thread that took it.
    """

    def __init__(self, wait_s: float = WAIT_S) -> None:
        self.turns = Turns(1, wait_s)
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="writer")

    @asynccontextmanager
    async def unit(self, opened: AbstractContextManager[Session]) -> AsyncIterator[Session]:
        """The session of one write transaction; committed at the end, rolled back on any error.

        Raises Busy where its turn does not come in time.
        """
        async with self.turns.turn():
            session = await self._run(opened.__enter__)
            try:
                yield session
            except BaseException as error:
                await self._run(opened.__exit__, type(error), error, error.__traceback__)
                raise
            await self._run(opened.__exit__, None, None, None)

    async def _run(self, function: Callable[..., Result], *arguments: Any) -> Result:
        # Shielded: a request that goes away must not leave a transaction open behind it.
        with anyio.CancelScope(shield=True):
            loop = asyncio.get_running_loop()
            result = await loop.run_in_executor(self._thread, function, *arguments)
        return result
