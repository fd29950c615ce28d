"""The Caddyfile with a real Caddy, where there is one, before two apps that can say they cannot work."""

import os
import shutil
import socket
import subprocess
import threading
from collections.abc import Iterator
from contextlib import ExitStack
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import httpx2
import pytest

from tests.support.waiting import until

CADDY = shutil.which("caddy")
pytestmark = [pytest.mark.once, pytest.mark.skipif(not CADDY, reason="there is no Caddy here")]
FILE = Path(__file__).resolve().parents[2] / "Caddyfile"


class App(ThreadingHTTPServer):
    """Answers who it is and what it was sent; 503 while it is away."""

    daemon_threads = True

    def __init__(self, name: str) -> None:
        app = self
        self.name, self.away = name, False

        class Answer(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                self.send_response(503 if app.away else 200)
                self.end_headers()
                self.wfile.write(f"{app.name}: {'the database is away' if app.away else 'works'}".encode())

            do_POST = do_GET

            def log_message(self, *_words: object) -> None:
                pass

        super().__init__(("127.0.0.1", 0), Answer)
        threading.Thread(target=self.serve_forever, daemon=True).start()


@pytest.fixture
def apps() -> Iterator[list[App]]:
    both = [App("one"), App("other")]
    yield both
    for app in both:
        app.shutdown()
        app.server_close()


@pytest.fixture
def site(apps: list[App], tmp_path: Path) -> Iterator[str]:
    with socket.create_server(("127.0.0.1", 0)) as free:
        address = f"http://127.0.0.1:{free.getsockname()[1]}"
    # its own administration listens on a port that all Caddys of a machine would want
    (tmp_path / "Caddyfile").write_text("{\n\tadmin off\n}\n" + FILE.read_text())
    given = {"SIGHTLINE_SITE": address, "XDG_DATA_HOME": str(tmp_path), "XDG_CONFIG_HOME": str(tmp_path)}
    given["SIGHTLINE_APPS"] = " ".join(f"127.0.0.1:{app.server_port}" for app in apps)
    command = [str(CADDY), "run", "--adapter", "caddyfile", "--config", str(tmp_path / "Caddyfile")]
    with ExitStack() as stack, (tmp_path / "log").open("w") as log:
        caddy = subprocess.Popen(command, env={**os.environ, **given}, stdout=log, stderr=log)
        stack.callback(caddy.wait)
        stack.callback(caddy.terminate)
        until(lambda: said(address), lambda: (tmp_path / "log").read_text())
        yield address


def said(site: str, method: str = "GET") -> str:
    try:
        return httpx2.request(method, f"{site}/api/surveys").text
    except httpx2.TransportError:
        return ""


def test_people_come_to_an_app_that_works_and_stay_there(site: str, apps: list[App]) -> None:
    until(lambda: {said(site) for _ in range(8)} == {"one: works", "other: works"})
    with httpx2.Client(base_url=site) as person:
        assert len({person.get("/").text for _ in range(8)}) == 1
    apps[0].away = True
    until(lambda: {said(site) for _ in range(8)} == {"other: works"})
    apps[1].away = True
    # none of them works: they say themselves what is away, to what asks and to what writes
    until(lambda: said(site).endswith("the database is away"))
    assert said(site, "POST").endswith("the database is away")
    apps[0].away = False
    until(lambda: {said(site) for _ in range(8)} == {"one: works"})
    apps[1].shutdown()
    apps[1].server_close()  # gone without a word
    assert {said(site) for _ in range(8)} == {"one: works"}
