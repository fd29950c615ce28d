"""`sightline serve`: the first start's link, the second start without one, ends, and a port that is taken."""

import json
import os
import signal
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.commands.running import Server, sightline

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
    with urllib.request.urlopen(request, timeout=30) as answer:
        me = json.loads(answer.read())
    assert me["person"]["role"] == "admin"
    return int(answer.status)


def running(process_id: int) -> bool:
    try:
        os.kill(process_id, 0)
    except ProcessLookupError:
        return False
    stat = Path(f"/proc/{process_id}/stat")
    return not stat.exists() or stat.read_text().rpartition(")")[2].split()[0] != "Z"


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


def test_a_first_start_a_second_and_what_is_left_behind(tmp_path: Path, started: list[Server]) -> None:
    started.append(first := Server(tmp_path / "data"))
    first.wait()
    assert f"http://localhost:{first.port}" in first.log.read_text()
    link = first.link()
    assert link is not None
    assert sign_in(first, link) == 200
    with pytest.raises(urllib.error.HTTPError):
        sign_in(first, link)
    taken = sightline("serve", "--data-dir", str(tmp_path / "other"), "--port", str(first.port))
    assert taken.returncode == 2 and f"Port {first.port}" in taken.stderr and not taken.stdout
    assert taken.stderr.count("\n") == 1
    second_here = sightline("serve", "--data-dir", str(tmp_path / "data"), "--port", "0")
    assert second_here.returncode == 2 and "Another server is using the folder" in second_here.stderr

    family = children(first.process.pid)
    assert family, "the server has a worker beside it"
    first.stop(signal.SIGKILL)
    until = time.monotonic() + 15
    while any(running(one) for one in family) and time.monotonic() < until:
        time.sleep(0.1)
    assert not any(running(one) for one in family), "a killed server leaves nothing running"

    started.append(second := Server(tmp_path / "data", port=first.port))
    second.wait()
    assert second.link() is None, "whoever signed in once needs no link"
    assert second.stop(signal.SIGTERM) == 0
    found = sightline("verify", str(tmp_path / "data"), "--json")
    assert found.returncode == 0, found.stderr
    assert json.loads(found.stdout)["kind"] == "database" and json.loads(found.stdout)["checked"] >= 3


def test_settings_that_cannot_be_used_are_named(tmp_path: Path) -> None:
    for name, value in (("SIGHTLINE_HEARTBEAT_LIMIT_S", "soon"), ("SIGHTLINE_PORT", "70000")):
        done = sightline("serve", "--data-dir", str(tmp_path / "data"), **{name: value})
        assert done.returncode == 2 and name in done.stderr and "Traceback" not in done.stderr
    done = sightline(
        "serve",
        "--data-dir",
        str(tmp_path / "data"),
        "--port",
        "0",
        SIGHTLINE_DATABASE_URL="mysql://x/y",
    )
    assert done.returncode == 2 and "mysql" in done.stderr
