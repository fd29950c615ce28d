"""Room that is given up when the disk is full, so that deleting, which writes too, can make more."""

import errno
import os
from contextlib import suppress
from pathlib import Path

import anyio.to_thread
from starlette.types import ASGIApp, Receive, Scope, Send

#: what a large deletion writes into the log before any room is free
HELD_BYTES = 16 << 20
#: with less left a deletion may fail
ENOUGH_BYTES = 4 << 20
NAME = "ballast"


class Ballast:
    """A file of a fixed size in the data folder that holds nothing."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.path = folder / NAME

    def take(self) -> None:
        """Hold the room again, where there is plenty."""
        with suppress(OSError):
            if self._held_bytes() == HELD_BYTES or self._free() < 4 * HELD_BYTES:
                return
            handle = os.open(self.path, os.O_WRONLY | os.O_CREAT, 0o600)
            try:
                os.posix_fallocate(handle, 0, HELD_BYTES)
            except OSError:
                os.ftruncate(handle, 0)
            finally:
                os.close(handle)

    def give_if_full(self) -> None:
        """Give the room up, where hardly any other is left."""
        with suppress(OSError):
            if self._free() < ENOUGH_BYTES:
                self.path.unlink(missing_ok=True)

    def _held_bytes(self) -> int:
        return self.path.stat().st_size if self.path.is_file() else 0

    def _free(self) -> int:
        found = os.statvfs(self._folder)
        return found.f_bavail * found.f_frsize


class RoomForDeleting:
    """Around every request that deletes."""

    def __init__(self, app: ASGIApp, ballast: Ballast) -> None:
        self.app, self.ballast = app, ballast

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http" or scope["method"] != "DELETE":
            await self.app(scope, receive, send)
            return
        await anyio.to_thread.run_sync(self.ballast.give_if_full)
        try:
            await self.app(scope, receive, send)
        finally:
            await anyio.to_thread.run_sync(self.ballast.take)


def try_to_write(folder: Path) -> bool:
    """Whether a few bytes can be stored in the folder. Raises OSError for what is not a full disk."""
    path = folder / f".room-{os.getpid()}"
    try:
        with path.open("wb") as file:
            file.write(bytes(1 << 16))
            os.fsync(file.fileno())
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT):
            raise
        return False
    finally:
        with suppress(OSError):
            path.unlink(missing_ok=True)
    return True
