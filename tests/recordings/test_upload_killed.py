"""A real server, an upload cut in the middle, a kill -9: the rest is sent to the next server."""

import asyncio
import base64
import hashlib
import signal
import socket
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

import httpx2
import pytest
from starlette.requests import ClientDisconnect, Request

from sightline.recordings.uploads.routes import PIECE_BYTES, _pieces
from tests.browser.server import Server, start
from tests.support.app import TUS
from tests.support.waiting import NEVER_S, until

pytestmark = pytest.mark.once

BYTES = {**TUS, "Content-Type": "application/offset+octet-stream"}


def longer(clip: Path) -> bytes:
    """A clip with an empty box behind it, so that a piece of it is stored while the line holds."""
    return clip.read_bytes() + struct.pack(">I4s", 2 * PIECE_BYTES, b"free") + bytes(2 * PIECE_BYTES - 8)


def signed_in(server: Server) -> httpx2.Client:
    """Who signed in by the first link."""
    server.wait()
    client = httpx2.Client(base_url=server.url, headers={"X-Sightline": "1"}, timeout=NEVER_S)
    token = server.sign_in_link().partition("token=")[2]
    assert client.post("/api/session/link", json={"token": token}).status_code == 200
    return client


def announced(client: httpx2.Client, name: str, size_bytes: int) -> str:
    """Where the upload that was announced is sent."""
    survey_id = client.post("/api/surveys", json={"name": "Road"}).json()["id"]
    coded = base64.b64encode(name.encode()).decode()
    headers = {**TUS, "Upload-Length": str(size_bytes), "Upload-Metadata": f"filename {coded}"}
    return client.post(f"/api/surveys/{survey_id}/uploads", headers=headers).headers["Location"]


@contextmanager
def sent_in_part(client: httpx2.Client, location: str, content: bytes, much: int) -> Iterator[None]:
    """A PATCH that announces everything, sends `much` bytes, and hangs up at the end of the block."""
    place = urlsplit(str(client.base_url))
    cookies = "; ".join(f"{name}={value}" for name, value in client.cookies.items())
    head = [
        f"PATCH {location} HTTP/1.1",
        f"Host: {place.netloc}",
        f"Cookie: {cookies}",
        f"Content-Length: {len(content)}",
        "X-Sightline: 1",
        "Upload-Offset: 0",
        *(f"{name}: {value}" for name, value in BYTES.items()),
    ]
    with socket.create_connection((place.hostname or "", place.port or 0)) as line:
        line.sendall("\r\n".join([*head, "", ""]).encode() + content[:much])
        yield


def taken_over(client: httpx2.Client, location: str, content: bytes) -> None:
    """The line of the first PATCH stays open and says nothing more; the next one goes on at once."""
    with sent_in_part(client, location, content, PIECE_BYTES + 6000):
        at = offset_of(client, location, PIECE_BYTES)
        rest = {**BYTES, "Upload-Offset": str(at)}
        answer = client.patch(location, content=content[at:], headers=rest)
        assert answer.status_code == 204, answer.text
        recording = client.get(f"/api/recordings/{answer.headers['Sightline-Recording']}").json()
    assert recording["size_bytes"] == len(content)
    assert recording["sha256"] == hashlib.sha256(content).hexdigest()


def offset_of(client: httpx2.Client, location: str, least: int) -> int:
    """How far the upload is, once `least` bytes are there."""

    def offset() -> int:
        return int(client.head(location, headers=TUS).headers["Upload-Offset"])

    until(lambda: offset() >= least, lambda: f"{offset()} bytes arrived, {least} were sent")
    return offset()


def test_a_silent_line_is_taken_over_and_what_is_cut_and_killed_is_resumed(
    tmp_path: Path, clip: Path
) -> None:
    content = longer(clip)
    server = start("serve --workers 0", tmp_path)  # what is sent is read by the next one's
    try:
        client = signed_in(server)
        taken_over(client, announced(client, clip.name, len(content)), content)
        location = announced(client, clip.name, len(content))
        with sent_in_part(client, location, content, sent := PIECE_BYTES + 6000):
            assert offset_of(client, location, PIECE_BYTES) <= sent
        client.close()
        server.stop(signal.SIGKILL)

        server = start("serve --workers 1", tmp_path)
        server.wait()
        again = httpx2.Client(
            base_url=server.url, headers={"X-Sightline": "1"}, cookies=client.cookies, timeout=NEVER_S
        )
        arrived = offset_of(again, location, PIECE_BYTES)
        assert arrived <= sent
        headers = {**BYTES, "Upload-Offset": str(arrived)}
        rest = again.patch(location, content=content[arrived:], headers=headers)
        assert rest.status_code == 204
        recording_id = rest.headers["Sightline-Recording"]

        def read() -> dict[str, object] | None:
            found: dict[str, object] = again.get(f"/api/recordings/{recording_id}").json()
            return found if found["state"] != "ingesting" else None

        recording = until(read)
        again.close()
        assert recording["state"] == "ready" and recording["frame_count"] == 12
    finally:
        server.stop()


def test_what_came_just_before_the_line_broke_is_kept() -> None:
    part = {"type": "http.request", "body": bytes(6000), "more_body": True}
    messages = iter([part, {"type": "http.disconnect"}])

    async def receive() -> dict[str, object]:
        return next(messages)

    async def taken() -> list[bytes]:
        pieces: list[bytes] = []
        with pytest.raises(ClientDisconnect):
            async for piece in _pieces(Request({"type": "http", "headers": []}, receive)):
                pieces.append(piece)
        return pieces

    assert asyncio.run(taken()) == [bytes(6000)]
