"""So many at once: whoever comes later waits on the event loop, where waiting takes no thread and no
connection, and is asked to come again where that takes too long.
"""

import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import anyio

from sightline.errors import Busy

#: Longer waits are no use: the browser has given up by then, or asks again.
WAIT_S = 10.0
#: Requests that read the database at the same moment; fewer than its pool holds connections.
READERS = 16


class Turns:
    """`at_once` may be inside; the others follow in the order in which they came."""

    def __init__(self, at_once: int, wait_s: float = WAIT_S) -> None:
        self._free = anyio.CapacityLimiter(at_once)
        self._wait_s = wait_s
        self._begun: dict[object, float] = {}

    @property
    def waiting(self) -> int:
        """How many wait just now."""
        return self._free.statistics().tasks_waiting

    @property
    def longest_s(self) -> float:
        """How long the one who has been inside for longest has been there; 0 where nobody is."""
        return time.monotonic() - min(self._begun.values()) if self._begun else 0.0

    @asynccontextmanager
    async def turn(self) -> AsyncIterator[None]:
        """Raises Busy where the turn does not come in time."""
        me = object()
        try:
            with anyio.fail_after(self._wait_s):
                await self._free.acquire_on_behalf_of(me)
        except TimeoutError:
            raise Busy("web-server-busy") from None
        self._begun[me] = time.monotonic()
        try:
            yield
        finally:
            del self._begun[me]
            self._free.release_on_behalf_of(me)
