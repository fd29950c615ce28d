"""A real server, an upload cut in the middle, a kill -9: the rest is sent to the next server."""

import base64
import signal
import socket
import time
from pathlib import Path
from urllib.parse import urlsplit

import httpx2
import pytest

from tests.browser.server import start
from tests.support.app import TUS

pytestmark = pytest.mark.once

BYTES = {**TUS, "Content-Type": "application/offset+octet-stream"}


def sent_in_part(client: httpx2.Client, location: str, content: bytes, much: int) -> None:
    """A PATCH that announces everything, sends `much` bytes, and hangs up."""
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
        time.sleep(0.5)


def offset_of(client: httpx2.Client, location: str, least: int) -> int:
    """How far the upload is, once `least` bytes are there."""
    for _ in range(100):
        offset = int(client.head(location, headers=TUS).headers["Upload-Offset"])
        if offset >= least:
            return offset
        time.sleep(0.1)
    raise AssertionError(f"{offset} bytes arrived, {least} were sent")


def test_cut_killed_and_resumed(tmp_path: Path, clip: Path) -> None:
    content = clip.read_bytes()
    server = start("serve", tmp_path)
    try:
        server.wait()
        client = httpx2.Client(base_url=server.url, headers={"X-Sightline": "1"}, timeout=30)
        token = server.sign_in_link().partition("token=")[2]
        assert client.post("/api/session/link", json={"token": token}).status_code == 200
        survey_id = client.post("/api/surveys", json={"name": "Road"}).json()["id"]
        name = base64.b64encode(clip.name.encode()).decode()
        headers = {**TUS, "Upload-Length": str(len(content)), "Upload-Metadata": f"filename {name}"}
        location = client.post(f"/api/surveys/{survey_id}/uploads", headers=headers).headers["Location"]
        sent_in_part(client, location, content, 6000)
        assert offset_of(client, location, 6000) == 6000
        client.close()
        server.stop(signal.SIGKILL)

        server = start("serve", tmp_path)
        server.wait()
        again = httpx2.Client(
            base_url=server.url, headers={"X-Sightline": "1"}, cookies=client.cookies, timeout=30
        )
        assert offset_of(again, location, 6000) == 6000
        rest = again.patch(location, content=content[6000:], headers={**BYTES, "Upload-Offset": "6000"})
        assert rest.status_code == 204
        recording_id = rest.headers["Sightline-Recording"]
        for _ in range(600):
            recording = again.get(f"/api/recordings/{recording_id}").json()
            if recording["state"] != "ingesting":
                break
            time.sleep(0.1)
        again.close()
        assert recording["state"] == "ready" and recording["frame_count"] == 12
    finally:
        server.stop()
