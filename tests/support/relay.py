"""A relay between a program and a server, for networks and machines that stop without a word."""

import selectors
import socket
import threading
import time
from contextlib import suppress
from typing import Self

from tests.support.waiting import until


class Relay:
    """Passes bytes between who connects to `port` and a server, until its connections are frozen.

    Frozen ones pass nothing and are never closed, as of a machine that lost its power; new ones pass. While
    `held` nothing passes, as of a server that stands still; while `shut` all are closed, as of one that is
    gone. A `host` that is a folder has PostgreSQL's socket of that port.
    """

    def __init__(self, host: str, port: int) -> None:
        self._server = host, port
        self._listening = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listening.getsockname()[1]
        self._pairs: list[tuple[socket.socket, socket.socket]] = []
        self._frozen: set[socket.socket] = set()
        self._selector = selectors.DefaultSelector()
        self._lock = threading.Lock()
        self._ended = False
        self.held = self.shut = False
        self._threads = [threading.Thread(target=self._accept, daemon=True)]
        self._threads.append(threading.Thread(target=self._pump, daemon=True))

    def __enter__(self) -> Self:
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._ended = True
        self._listening.close()
        self._threads[1].join()
        for pair in self._pairs:
            for end in pair:
                end.close()

    def freeze(self) -> int:
        """Let none of the connections that are there pass anything again; returns how many there are."""
        with self._lock:
            fresh = [end for pair in self._pairs for end in pair if end not in self._frozen]
            for end in fresh:
                self._selector.unregister(end)
            self._frozen.update(fresh)
        return len(fresh) // 2

    def close_all(self) -> None:
        """Be shut; returns when no connection is left."""
        self.shut = True
        until(lambda: not self._selector.get_map())

    def _accept(self) -> None:
        while not self._ended:
            try:
                caller, _ = self._listening.accept()
                if self.shut:
                    caller.close()
                    continue
                server = self._reach()
            except OSError:
                if self._ended:
                    return
                caller.close()
                continue
            with self._lock:
                self._pairs.append((caller, server))
                self._selector.register(caller, selectors.EVENT_READ, server)
                self._selector.register(server, selectors.EVENT_READ, caller)

    def _reach(self) -> socket.socket:
        host, port = self._server
        if not host.startswith("/"):
            return socket.create_connection(self._server)
        reached = socket.socket(socket.AF_UNIX)
        reached.connect(f"{host}/.s.PGSQL.{port}")
        return reached

    def _pump(self) -> None:
        while not self._ended:
            if self.held:
                time.sleep(0.05)
                continue
            if self.shut:
                with self._lock:
                    for key in list(self._selector.get_map().values()):
                        self._close(key)
            for key, _ in self._selector.select(timeout=0.05):
                with self._lock:
                    self._pass_on(key)

    def _pass_on(self, key: selectors.SelectorKey) -> None:
        end, other = key.fileobj, key.data
        assert isinstance(end, socket.socket)
        if end in self._frozen:
            return
        try:
            content = end.recv(1 << 16)
            if content:
                other.sendall(content)
                return
        except OSError:
            pass
        self._close(key)

    def _close(self, key: selectors.SelectorKey) -> None:
        end, other = key.fileobj, key.data
        assert isinstance(end, socket.socket)
        if end in self._frozen:
            return
        for side in (end, other):
            self._selector.unregister(side)
            with suppress(OSError):
                side.shutdown(socket.SHUT_RDWR)
            self._frozen.add(side)
