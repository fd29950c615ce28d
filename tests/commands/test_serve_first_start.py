"""`sightline serve`: the first start's link and its end, a port and a folder that are taken, settings that
cannot be used; in `make proofs` a kill, the second start without a link, and a connection that rests.
"""

import http.client
import json
import os
import signal
import socket
import time
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sightline.cli import main
from sightline.commands.serve import listen
from tests.commands.running import Server, sightline
from tests.support.waiting import NEVER_S, alive, until

pytestmark = pytest.mark.once


@pytest.fixture
def started(tmp_path: Path) -> Iterator[list[Server]]:
    servers: list[Server] = []
    yield servers
    for server in servers:
        server.stop(signal.SIGKILL)


def sign_in(server: Server, link: str) -> int:
    body = json.dumps({"token": link.split("token=")[1]}).encode()
    headers = {"Content-Type": "application/json", "X-Sightline": "1"}
    request = urllib.request.Request(f"{server.url}/api/session/link", body, headers)
    with urllib.request.urlopen(request, timeout=NEVER_S) as answer:
        me = json.loads(answer.read())
    assert me["person"]["role"] == "admin"
    return int(answer.status)


def children(process_id: int) -> list[int]:
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            parent = int(stat.read_text().rpartition(")")[2].split()[1])
        except (OSError, ValueError):
            continue
        if parent == process_id:
            found += [int(stat.parent.name), *children(int(stat.parent.name))]
    return found


def answered(kept: http.client.HTTPConnection) -> bool:
    kept.request("GET", "/api/health")
    answer = kept.getresponse()
    answer.read()
    return answer.status == 200


Said = Callable[..., tuple[int, str, str]]


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Said:
    """Runs a command that ends by itself, in this process: its status, and what it says."""
    for name in [name for name in os.environ if name.startswith("SIGHTLINE_")]:
        monkeypatch.delenv(name)
    monkeypatch.setattr("sightline.commands.serve.answer", lambda *_: pytest.fail("the server starts"))

    def run(*arguments: str, **setting: str) -> tuple[int, str, str]:
        capsys.readouterr()
        with monkeypatch.context() as patch:
            for name, value in setting.items():
                patch.setenv(name, value)
            status = main(arguments)
        return status, *capsys.readouterr()

    return run


def require_first_link(server: Server) -> None:
    """It is printed beside the address, signs in once, and not again."""
    assert f"http://localhost:{server.port}" in server.log.read_text()
    link = server.link()
    assert link is not None
    assert sign_in(server, link) == 200
    with pytest.raises(urllib.error.HTTPError):
        sign_in(server, link)


def require_alone(server: Server, said: Said) -> None:
    """Who wants its port, or its folder, is told so."""
    elsewhere = str(server.data_dir.with_name("other"))
    status, out, err = said("serve", "--data-dir", elsewhere, "--port", str(server.port))
    assert status == 2 and f"Port {server.port}" in err and not out
    assert err.count("\n") == 1
    status, _, err = said("serve", "--data-dir", str(server.data_dir), "--port", "0")
    assert status == 2 and "Another server is using the folder" in err


def test_a_first_start_prints_a_link_for_once_and_has_port_and_folder_for_itself(
    tmp_path: Path, started: list[Server], said: Said
) -> None:
    started.append(server := Server(tmp_path / "data", "--workers", "0"))
    server.wait()
    require_first_link(server)
    require_alone(server, said)
    assert server.stop(signal.SIGTERM) == 0


@pytest.mark.proof
def test_a_first_start_a_second_and_what_is_left_behind(
    tmp_path: Path, started: list[Server], said: Said
) -> None:
    started.append(first := Server(tmp_path / "data"))
    first.wait()
    kept, asked_at = http.client.HTTPConnection("127.0.0.1", first.port), time.monotonic()
    assert answered(kept)
    line = kept.sock
    require_first_link(first)
    require_alone(first, said)

    time.sleep(max(0.0, asked_at + 6 - time.monotonic()))  # longer than uvicorn keeps it by itself
    assert answered(kept) and kept.sock is line, "a proxy asks again on a connection that rested"

    family = until(lambda: children(first.process.pid), lambda: "the server has a worker beside it")
    first.stop(signal.SIGKILL)
    kept.close()
    until(lambda: not any(map(alive, family)), lambda: "a killed server leaves nothing running")

    started.append(second := Server(tmp_path / "data"))
    second.wait()
    assert second.link() is None, "whoever signed in once needs no link"
    assert second.stop(signal.SIGTERM) == 0
    status, out, err = said("verify", str(tmp_path / "data"), "--json")
    assert status == 0, err
    assert json.loads(out)["kind"] == "database" and json.loads(out)["count"] >= 3


def test_settings_that_cannot_be_used_are_named(tmp_path: Path, said: Said) -> None:
    """The first in a process of its own, as a user meets it."""
    serve = ("serve", "--data-dir", str(tmp_path / "data"))
    done = sightline(*serve, SIGHTLINE_HEARTBEAT_LIMIT_S="soon")
    assert done.returncode == 2 and "SIGHTLINE_HEARTBEAT_LIMIT_S" in done.stderr
    assert "Traceback" not in done.stderr
    status, _, err = said(*serve, SIGHTLINE_PORT="70000")
    assert status == 2 and "SIGHTLINE_PORT" in err and "Traceback" not in err
    status, _, err = said(*serve, "--port", "0", SIGHTLINE_DATABASE_URL="mysql://x/y")
    assert status == 2 and "mysql" in err
    status, _, err = said(*serve, "--port", "0", SIGHTLINE_SECRET="too short")
    assert status == 2 and "can be guessed" in err and not (tmp_path / "data" / "sightline.db").exists()


def test_the_port_of_a_server_that_was_killed_is_taken_at_once() -> None:
    """Its connections may linger for minutes; then who may have the port again must have said so."""
    with listen("127.0.0.1", 0) as listener:
        assert listener.getsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR)
