"""The two sides of one worker process: the supervisor's, and what the process itself keeps an eye on."""

import os
import signal
import socket
import threading
import time
from collections.abc import Callable
from contextlib import suppress


class WorkerProcess:
    """The supervisor's side of one worker process."""

    def __init__(self, pid: int, name: str, orders: socket.socket, *, short_only: bool) -> None:
        self.pid, self.name, self.orders, self.short_only = pid, name, orders, short_only
        self.job_id: int | None = None
        self.is_idle = False
        self.started = time.monotonic()

    def fileno(self) -> int:
        """For select."""
        return self.orders.fileno()

    def give(self, job_id: int) -> None:
        """Have it do a job."""
        self.job_id, self.is_idle = job_id, False
        with suppress(OSError):  # it has just ended, which is noticed next
            self.orders.sendall(f"{job_id}\n".encode())

    def is_alive(self) -> bool:
        """Take what it says: it is idle, or (its end of the pair closed) it ended."""
        try:
            word = self.orders.recv(64)
        except OSError:
            word = b""
        if word:
            self.job_id, self.is_idle = None, True
        return bool(word)

    def bury(self) -> None:
        """Make sure that it has ended, and leave no zombie."""
        self.orders.close()
        with suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        with suppress(ChildProcessError):
            os.waitpid(self.pid, 0)


def watch_supervisor(orders: socket.socket, take: Callable[[bytes], None]) -> None:
    """In a worker process: `take` each line, from a thread; end the process when the supervisor is gone."""

    def read() -> None:
        with orders.makefile("rb") as lines:
            for line in lines:
                take(line)
        os._exit(1)

    threading.Thread(target=read, name="supervisor-watch", daemon=True).start()


def on_stop(stop: Callable[[], None]) -> None:
    """Call this at SIGTERM, in the main thread."""
    signal.signal(signal.SIGTERM, lambda *_signal: stop())
