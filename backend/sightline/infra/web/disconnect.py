"""Work that is given up when the browser that asked for it has gone away."""

import asyncio
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import TypeVar

from fastapi import Request
from starlette.concurrency import run_in_threadpool

LOOK_S = 0.05
Result = TypeVar("Result")
CancelCheck = Callable[[], bool]


async def run_unless_cancelled(request: Request, work: Callable[[CancelCheck], Result]) -> Result:
    """Do `work` in a thread; the function that it is given says whether the browser still waits."""
    gone = threading.Event()

    async def look() -> None:
        await asyncio.sleep(LOOK_S)  # most pictures are there by then
        while not await request.is_disconnected():
            await asyncio.sleep(LOOK_S)
        gone.set()

    looking = asyncio.create_task(look())
    try:
        return await run_in_threadpool(work, lambda: not gone.is_set())
    finally:
        looking.cancel()
        with suppress(asyncio.CancelledError):
            await looking
