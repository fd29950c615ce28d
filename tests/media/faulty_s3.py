"""An object store that misbehaves as told: between boto3 and a real server of the protocol."""

from __future__ import annotations

import http.client
import threading
from collections.abc import Callable
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Literal
from urllib.parse import urlsplit

from tests.support.waiting import NEVER_S

Fault = Literal["none", "500", "cut", "slow", "closed"]


class FaultyS3:
    """Hands requests on; `fault` says what becomes of the next `count` answers. A slow one waits for the next
    `begin`.
    """

    def __init__(self, endpoint: str) -> None:
        self.fault: Fault = "none"
        self.count = 0
        self.asked = 0
        self.over = threading.Event()
        self._lock = threading.Lock()
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), _handler(self, endpoint))
        self._server.daemon_threads = True
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._thread.start()
        self.url = f"http://127.0.0.1:{self._server.server_port}"

    def begin(self, fault: Fault, count: int = 1_000_000) -> None:
        with self._lock:
            self.over.set()
            self.over = threading.Event()
            self.fault, self.count, self.asked = fault, count, 0

    def next(self) -> Fault:
        with self._lock:
            self.asked += 1
            self.count -= 1
            return self.fault if self.count >= 0 else "none"

    def close(self) -> None:
        self.over.set()
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()


def _handler(faults: FaultyS3, endpoint: str) -> Callable[..., BaseHTTPRequestHandler]:
    place = urlsplit(endpoint)

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def log_message(self, *_words: Any) -> None:
            """Nobody reads it."""

        def _pass(self) -> None:
            body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
            fault = faults.next()
            if fault == "closed":
                self.close_connection = True
                return
            if fault == "500":
                self._answer(500, {}, b"<Error><Code>InternalError</Code></Error>")
                return
            if fault == "slow":
                faults.over.wait(NEVER_S)
            there = http.client.HTTPConnection(place.netloc, timeout=NEVER_S)
            there.request(self.command, self.path, body, dict(self.headers))
            answer = there.getresponse()
            content = answer.read()
            there.close()
            half = content[: len(content) // 2] if fault == "cut" else content
            self._answer(answer.status, dict(answer.getheaders()), half, len(content))

        def _answer(
            self, status: int, headers: dict[str, str], body: bytes, length: int | None = None
        ) -> None:
            self.send_response(status)
            for name, value in _told(headers, self.command, len(body) if length is None else length).items():
                self.send_header(name, value)
            self.end_headers()
            if self.command != "HEAD":
                self.wfile.write(body)
            self.close_connection = length not in (None, len(body))

        do_GET = do_PUT = do_POST = do_HEAD = do_DELETE = _pass

    return Handler


def _told(headers: dict[str, str], command: str, length: int) -> dict[str, str]:
    """What the answer says, but of this connection; HEAD has the length of what it tells of."""
    own = ("transfer-encoding", "connection", "date", "server")
    told = {name.lower(): value for name, value in headers.items() if name.lower() not in own}
    return told if command == "HEAD" else {**told, "content-length": str(length)}
