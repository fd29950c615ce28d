"""What is wrong with the database or the storage at a start is told in one sentence, and soon."""

import socket
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer

import pytest

from sightline.cli import main
from sightline.infra.database import postgres

pytestmark = pytest.mark.once


def told(capsys: pytest.CaptureFixture[str]) -> str:
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    return said


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: object, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SIGHTLINE_DATA_DIR", str(tmp_path))
    monkeypatch.setenv("SIGHTLINE_PORT", "0")


@pytest.mark.parametrize("command", ["serve", "migrate"])
def test_a_database_address_that_answers_nothing(
    command: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(postgres, "CONNECT_S", 2)
    monkeypatch.setenv("SIGHTLINE_SIGNING_KEY", "ab" * 32)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"postgresql://sightline@127.0.0.1:{silent.getsockname()[1]}/sightline"
        monkeypatch.setenv("SIGHTLINE_DATABASE_URL", address)
        assert main([command]) == 1
    assert told(capsys).startswith("The database does not answer; check that it is running")


@pytest.fixture
def storage() -> Iterator[str]:
    """It has no bucket and makes none."""

    class Refuses(BaseHTTPRequestHandler):
        def do_HEAD(self) -> None:
            self.answer(404, b"")

        def do_PUT(self) -> None:
            self.answer(403, b"<Error><Code>AccessDenied</Code></Error>")

        def answer(self, status: int, body: bytes) -> None:
            self.send_response(status)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_words: object) -> None:
            pass

    with HTTPServer(("127.0.0.1", 0), Refuses) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


def test_a_bucket_that_is_missing(
    storage: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY"):
        monkeypatch.setenv(name, "key")
    monkeypatch.setenv("SIGHTLINE_MEDIA_URL", f"s3://videos?endpoint={storage}")
    assert main(["serve"]) == 2
    assert "no bucket videos, and it cannot be created (AccessDenied)" in told(capsys)
