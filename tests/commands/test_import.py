"""`sightline import` against a server in a process of its own, with a token that somebody made."""

import io
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx2
import numpy as np
import pytest

from sightline.cli import main
from sightline.commands import remote
from sightline.commands.remote import Remote
from sightline.errors import Away, BadInput
from sightline.media.video.writer import write_mp4
from tests.commands.running import Server, environment
from tests.media.clips import painted
from tests.support.waiting import NEVER_S, until

LATER = 4e9  # a time stamp that is not in the past yet


def ctrl_c_is_heard() -> None:
    """A shell that starts the tests in the background has their children ignore it."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def run_import(*arguments: str, token: str) -> "subprocess.CompletedProcess[str]":
    """`sightline import` in this process, without any other setting of Sightline's."""
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err), pytest.MonkeyPatch.context() as patch:
        for name in [name for name in os.environ if name.startswith("SIGHTLINE_")]:
            patch.delenv(name)
        patch.setenv("SIGHTLINE_TOKEN", token)
        status = main(["import", *arguments])
    return subprocess.CompletedProcess(arguments, status, out.getvalue(), err.getvalue())


@dataclass
class Running:
    server: Server
    http: httpx2.Client
    token: str
    survey_id: int

    def run(self, *arguments: str, token: str | None = None) -> "subprocess.CompletedProcess[str]":
        place = ("--survey", "Hill road", "--server", self.server.url, "--settle", "0.2")
        return run_import(*arguments, *place, token=self.token if token is None else token)

    def recordings(self) -> list[dict[str, Any]]:
        found = self.http.get(f"/api/surveys/{self.survey_id}/recordings").json()
        return sorted(found, key=lambda one: one["id"])


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    server = Server(tmp_path_factory.mktemp("import") / "data", SIGHTLINE_FIND_PASSES="false")
    try:
        server.wait()
        found = re.search(r"/sign-in\?token=([\w-]+)", server.log.read_text())
        assert found, server.log.read_text()
        http = httpx2.Client(base_url=server.url, headers={"X-Sightline": "1"}, timeout=NEVER_S)
        http.post("/api/session/link", json={"token": found[1]}).raise_for_status()
        body = {"name": "import", "scopes": ["read", "upload"]}
        token = http.post("/api/session/tokens", json=body).json()["text"]
        survey = http.post("/api/surveys", json={"name": "Hill road"}).json()["id"]
        yield Running(server, http, token, survey)
        http.close()
    finally:
        server.stop()


def video(path: Path, seed: int) -> Path:
    write_mp4(path, (painted(n + seed, 160, 120) for n in range(10)), 25)
    return path


def test_videos_are_uploaded_read_and_searched(running: Running, tmp_path: Path) -> None:
    videos = [video(tmp_path / "a.mp4", 0), video(tmp_path / "b day.mp4", 40)]
    done = running.run(*map(str, videos), "--json")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)["recordings"]
    assert [(one["sent"], one["frames"]) for one in found] == [(True, 10)] * 2
    vehicles = running.http.get(f"/api/surveys/{running.survey_id}/vehicles").json()
    assert sum(one["vehicles"] for one in found) == len(vehicles)
    searched = [one for one in running.http.get("/api/jobs").json() if one["kind"] == "passes"]
    assert [one["state"] for one in searched] == ["done", "done"]
    assert "uploading" in done.stderr and "finding passes" in done.stderr
    assert [one["name"] for one in running.recordings()][-2:] == ["a.mp4", "b day.mp4"]
    again = running.run(str(videos[0]))
    assert again.returncode == 0 and "there already" in again.stdout, again.stderr
    assert len(running.recordings()) == 2


def test_what_broke_off_goes_on_where_it_was(
    running: Running, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng(1)
    path = tmp_path / "long.mp4"
    write_mp4(path, (rng.integers(0, 255, (120, 160, 3), dtype=np.uint8) for _ in range(30)), 25, crf=5)
    monkeypatch.setattr(remote, "PIECE_BYTES", path.stat().st_size // 10)
    monkeypatch.setattr(remote, "PATIENCE_S", 0.0)
    sent: list[int] = []

    def broken(offset: int) -> None:
        sent.append(offset)
        if len(sent) == 4:
            raise Away("import-no-answer", url="x")

    with Remote(running.server.url, running.token) as first, pytest.raises(Away):
        first.upload(running.survey_id, path, broken)
    more: list[int] = []
    with Remote(running.server.url, running.token) as second:
        recording_id = second.upload(running.survey_id, path, more.append)
    assert more[0] == sent[-1] > 0, "nothing was sent twice"
    assert running.http.get(f"/api/recordings/{recording_id}").json()["size_bytes"] == path.stat().st_size


def test_the_answer_to_the_last_piece_may_be_lost(
    running: Running, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    film, piece, pieces = video(tmp_path / "lost.mp4", 300), Remote._piece, list[object]()

    def lost(*given: Any) -> Any:
        pieces.append(piece(*given))
        raise Away("import-no-answer", url="x")

    monkeypatch.setattr(remote, "_RETRY_S", 0.0)
    monkeypatch.setattr(Remote, "_piece", lost)
    with Remote(running.server.url, running.token) as server:
        recording_id = server.upload(running.survey_id, film, lambda _: None)
        assert len(pieces) == 1
        assert server.ask(f"/recordings/{recording_id}")["size_bytes"] == film.stat().st_size


def test_only_ones_own_upload_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    film = video(tmp_path / "a.mp4", 0)
    same = {"purpose": "video", "filename": "a.mp4", "size_bytes": film.stat().st_size}
    under_way = [{**same, "id": 1, "mine": False}]
    monkeypatch.setattr(Remote, "ask", lambda *_: under_way)
    with Remote("http://localhost", "t") as server:
        assert server.begun(1, film) is None
        under_way.append({**same, "id": 2, "mine": True})
        assert server.begun(1, film) == "/uploads/2"


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("a.txt", b"words", "not have the ending of a video"),
        ("none.mp4", b"", "empty"),
        ("bad.mp4", b"no video", "cannot be read"),
        ("of a recorder.TS", b"no video", "cannot be read"),
    ],
)
def test_what_cannot_be_used_is_refused_in_words(
    running: Running, tmp_path: Path, name: str, content: bytes, said: str
) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    done = running.run(str(path))
    last = done.stderr.splitlines()[-1]
    assert done.returncode == 2 and said in last and "{" not in last, done.stderr


def test_wrong_token_survey_and_address_are_refused_in_words(running: Running, tmp_path: Path) -> None:
    path = video(tmp_path / "a.mp4", 0)
    assert "token" in running.run(str(path), token="").stderr
    wrong = running.run(str(path), token="sightline_wrong")
    assert wrong.returncode == 1 and "is not valid" in wrong.stderr
    read = running.http.post("/api/session/tokens", json={"name": "r", "scopes": ["read"]}).json()["text"]
    new = video(tmp_path / "new.mp4", 90)
    assert "needs upload" in running.run(str(new), token=read).stderr
    server = ("--server", "http://127.0.0.1:9")
    away = run_import(str(path), "--survey", "x", *server, token="t")
    assert away.returncode == 1 and "does not answer" in away.stderr
    server = ("--server", running.server.url)
    none = run_import(str(path), "--survey", "Valley", *server, token=running.token)
    assert none.returncode == 2 and "Hill road" in none.stderr
    with pytest.raises(BadInput):
        Remote("file:///etc", "t")


def test_a_watched_folder_takes_what_stops_growing(running: Running, tmp_path: Path) -> None:
    folder, ready = tmp_path / "in", video(tmp_path / "ready.mp4", 200).read_bytes()
    folder.mkdir()
    command = [sys.executable, "-m", "sightline.cli", "import", "--watch", str(folder), "--settle", "1"]
    command += ["--survey", "Hill road", "--server", running.server.url]
    env = environment(SIGHTLINE_TOKEN=running.token, PYTHONPATH=os.environ.get("PYTHONPATH", "backend"))
    before = len(running.recordings())
    with (tmp_path / "log").open("w") as log:
        watching = subprocess.Popen(
            command, stdout=log, stderr=subprocess.STDOUT, env=env, preexec_fn=ctrl_c_is_heard
        )
    try:
        with (folder / "growing.mp4").open("wb") as file:
            for start in range(0, len(ready), len(ready) // 6 + 1):
                file.write(ready[start : start + len(ready) // 6 + 1])
                file.flush()
                os.utime(file.fileno(), (LATER, LATER))  # or a pause of ours would be taken for its end
                time.sleep(0.5)
                assert len(running.recordings()) == before, "taken while it grew"
        os.utime(folder / "growing.mp4")
        (folder / "broken.mp4").write_bytes(b"no video either")

        def both_told() -> bool:
            said = (tmp_path / "log").read_text()
            assert watching.poll() is None, said
            return "growing.mp4: imported" in said and "broken.mp4 was uploaded but cannot be read" in said

        until(both_told, (tmp_path / "log").read_text)
        assert len(running.recordings()) == before + 2
    finally:
        watching.send_signal(signal.SIGINT)
        assert watching.wait(NEVER_S) == 1
