"""HTTP/1.1 for load: one connection, one request after the other, nothing parsed that is not needed.

A common client takes as much of a processor as the server that it asks; on two cores it would be measured.
"""

from __future__ import annotations

import asyncio
import gzip
import json
from dataclasses import dataclass
from typing import Any, Self
from urllib.parse import urlsplit


@dataclass(frozen=True, slots=True)
class Answer:
    """What came back; the body is looked at when asked for."""

    status_code: int
    head: bytes
    body: bytes

    @property
    def text(self) -> str:
        packed = b"content-encoding: gzip" in self.head.lower()
        return (gzip.decompress(self.body) if packed else self.body).decode(errors="replace")

    def json(self) -> Any:
        return json.loads(self.text)

    def header(self, name: str, default: str) -> str:
        for line in self.head.decode("latin-1").split("\r\n"):
            key, _, value = line.partition(":")
            if key.lower() == name.lower():
                return value.strip()
        return default


class Light:
    """`async with Light(url, cookies) as http: await http.ask("GET", "/api/health")`."""

    def __init__(self, url: str, cookies: dict[str, str]) -> None:
        at = urlsplit(url)
        self._host, self._port = str(at.hostname), at.port or 80
        said = "; ".join(f"{name}={value}" for name, value in cookies.items())
        self._headers = (
            f"Host: {at.netloc}\r\nX-Sightline: 1\r\nCookie: {said}\r\nAccept: application/json\r\n"
            "Accept-Encoding: gzip\r\nAccept-Language: en\r\nContent-Type: application/json\r\n"
        )

    async def __aenter__(self) -> Self:
        self._in, self._out = await asyncio.open_connection(self._host, self._port)
        return self

    async def __aexit__(self, *_: object) -> None:
        self._out.close()

    async def ask(self, method: str, path: str, body: Any = None) -> Answer:
        content = b"" if body is None else json.dumps(body).encode()
        head = f"{method} {path} HTTP/1.1\r\n{self._headers}Content-Length: {len(content)}\r\n\r\n"
        self._out.write(head.encode() + content)
        got = await self._in.readuntil(b"\r\n\r\n")
        at = got.lower().find(b"content-length:")
        length = 0 if at < 0 else int(got[at + 15 : got.find(b"\r", at)])
        return Answer(int(got[9:12]), got, await self._in.readexactly(length))
