"""Resumable uploads: what has arrived stays, whatever breaks, and nothing else is taken for it."""

from __future__ import annotations

import errno
import hashlib
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from sightline.errors import BadInput, Conflict, NoRoom, NotFound
from sightline.media.store import local, upload_parts
from tests.media.conftest import ROOT
from tests.support.waiting import until

DATA = os.urandom(200_000)


def pieces(data: bytes, size: int = 7_000) -> Iterator[bytes]:
    return (data[k : k + size] for k in range(0, len(data), size))


def test_an_upload_in_three_goes(tmp_path: Path) -> None:
    upload_parts.create(tmp_path, "u1", len(DATA))
    assert upload_parts.offset(tmp_path, "u1") == 0
    assert upload_parts.append(tmp_path, "u1", len(DATA), 0, pieces(DATA[:50_000])) == 50_000
    assert upload_parts.append(tmp_path, "u1", len(DATA), 50_000, []) == 50_000
    with pytest.raises(Conflict, match="not complete: 50\u202f000 of 200\u202f000"):
        upload_parts.finish(tmp_path, "u1", len(DATA))
    assert upload_parts.append(tmp_path, "u1", len(DATA), 50_000, pieces(DATA[50_000:])) == len(DATA)
    done = upload_parts.finish(tmp_path, "u1", len(DATA))
    assert done.path.read_bytes() == DATA and done.size == len(DATA)
    assert (
        done.sha256
        == hashlib.sha256(DATA).hexdigest()
        == upload_parts.finish(tmp_path, "u1", len(DATA)).sha256
    )
    upload_parts.discard(tmp_path, "u1")
    upload_parts.discard(tmp_path, "u1")
    assert list(tmp_path.iterdir()) == []


def test_wrong_offsets_are_refused(tmp_path: Path) -> None:
    upload_parts.create(tmp_path, "u1", len(DATA))
    upload_parts.append(tmp_path, "u1", len(DATA), 0, [DATA[:1000]])
    for wrong in (0, 999, 1001, -1):
        with pytest.raises(Conflict, match="is at byte 1000"):
            upload_parts.append(tmp_path, "u1", len(DATA), wrong, [b"x"])
    assert upload_parts.offset(tmp_path, "u1") == 1000


def test_more_than_announced_is_refused_and_the_rest_kept(tmp_path: Path) -> None:
    upload_parts.create(tmp_path, "u1", 1000)
    with pytest.raises(BadInput, match="1000 announced"):
        upload_parts.append(tmp_path, "u1", 1000, 0, [DATA[:900], DATA[900:1001]])
    assert upload_parts.offset(tmp_path, "u1") == 900
    assert upload_parts.append(tmp_path, "u1", 1000, 900, [DATA[900:1000]]) == 1000
    assert upload_parts.finish(tmp_path, "u1", 1000).path.read_bytes() == DATA[:1000]


def test_a_broken_connection_keeps_what_arrived(tmp_path: Path) -> None:
    def broken() -> Iterator[bytes]:
        yield DATA[:5000]
        raise ConnectionResetError

    upload_parts.create(tmp_path, "u1", len(DATA))
    with pytest.raises(ConnectionResetError):
        upload_parts.append(tmp_path, "u1", len(DATA), 0, broken())
    assert upload_parts.offset(tmp_path, "u1") == 5000


def silent(upload_dir: Path, said: list[str], first: bytes) -> threading.Thread:
    """A connection that sends something, then holds its lock and gives empty chunks only; in a thread."""

    def nothing_more() -> Iterator[bytes]:
        yield first
        said.append("wrote")
        while True:
            time.sleep(0.01)
            yield b""

    def hold() -> None:
        with pytest.raises(Conflict, match="newer connection"):
            upload_parts.append(upload_dir, "u1", len(DATA), 0, nothing_more())
        said.append("let go")

    thread = threading.Thread(target=hold)
    thread.start()
    until(lambda: said)
    return thread


def test_a_newer_connection_takes_over_from_a_silent_one(tmp_path: Path) -> None:
    upload_parts.create(tmp_path, "u1", len(DATA))
    said: list[str] = []
    older = silent(tmp_path, said, DATA[:5000])
    assert upload_parts.append(tmp_path, "u1", len(DATA), 5000, pieces(DATA[5000:])) == len(DATA)
    older.join()
    assert said == ["wrote", "let go"]
    whole = upload_parts.finish(tmp_path, "u1", len(DATA))
    assert whole.path.read_bytes() == DATA
    upload_parts.discard(tmp_path, "u1")
    assert not list(tmp_path.iterdir())


def test_a_stray_request_takes_nothing_over(tmp_path: Path) -> None:
    upload_parts.create(tmp_path, "u1", len(DATA))

    def meddled() -> Iterator[bytes]:
        yield DATA[:100]
        with pytest.raises(Conflict, match="at byte 100, not 50"):
            upload_parts.append(tmp_path, "u1", len(DATA), 50, [b"x"])
        yield DATA[100:200]

    assert upload_parts.append(tmp_path, "u1", len(DATA), 0, meddled()) == 200


def test_another_process_takes_over(tmp_path: Path) -> None:
    upload_parts.create(tmp_path, "u1", len(DATA))
    (tmp_path / "rest").write_bytes(DATA[5000:])
    script = (
        "import sys, pathlib\n"
        "from sightline.media.store import upload_parts\n"
        "folder = pathlib.Path(sys.argv[1])\n"
        "rest = (folder / 'rest').read_bytes()\n"
        "print(upload_parts.append(folder, 'u1', 5000 + len(rest), 5000, [rest]))\n"
    )
    said: list[str] = []
    older = silent(tmp_path, said, DATA[:5000])
    done = subprocess.run(
        [sys.executable, "-c", script, tmp_path], capture_output=True, text=True, check=True
    )
    older.join()
    assert int(done.stdout) == len(DATA) and said == ["wrote", "let go"]
    assert upload_parts.finish(tmp_path, "u1", len(DATA)).path.read_bytes() == DATA


def test_who_does_not_let_go_is_waited_for_no_longer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(upload_parts, "TAKE_OVER_S", 0.1)
    upload_parts.create(tmp_path, "u1", len(DATA))

    def stuck() -> Iterator[bytes]:
        with pytest.raises(Conflict, match="Another connection"):
            upload_parts.append(tmp_path, "u1", len(DATA), 0, [b"x"])
        yield DATA[:100]

    with pytest.raises(Conflict, match="newer connection"):
        upload_parts.append(tmp_path, "u1", len(DATA), 0, stuck())
    assert upload_parts.offset(tmp_path, "u1") == 0


def test_a_full_disk_keeps_what_was_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    upload_parts.create(tmp_path, "u1", len(DATA))
    upload_parts.append(tmp_path, "u1", len(DATA), 0, [DATA[:5000]])
    write, room = os.write, [8000]

    def small_disk(handle: int, data: memoryview) -> int:
        if room[0] == 0:
            raise OSError(errno.ENOSPC, "No space left on device")
        written = write(handle, data[: room[0]])
        room[0] -= written
        return written

    monkeypatch.setattr(upload_parts.os, "write", small_disk)
    with pytest.raises(NoRoom, match="disk is full"):
        upload_parts.append(tmp_path, "u1", len(DATA), 5000, pieces(DATA[5000:]))
    monkeypatch.undo()
    assert upload_parts.offset(tmp_path, "u1") == 13_000
    upload_parts.append(tmp_path, "u1", len(DATA), 13_000, pieces(DATA[13_000:]))
    assert upload_parts.finish(tmp_path, "u1", len(DATA)).sha256 == hashlib.sha256(DATA).hexdigest()


def test_no_room_is_told_before_a_byte_is_sent(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(local.shutil, "disk_usage", lambda _: type("Usage", (), {"free": 10**6}))
    with pytest.raises(NoRoom, match="There is not enough space"):
        upload_parts.create(tmp_path, "u1", 10**9)
    assert list(tmp_path.iterdir()) == []


def test_empty_files_and_strange_names_are_refused(tmp_path: Path) -> None:
    for size in (0, -1):
        with pytest.raises(BadInput, match="empty"):
            upload_parts.create(tmp_path, "u1", size)
    for name in ("../u", "a/b", "", ".", "x" * 65, "u.1"):
        for ask in (upload_parts.offset, upload_parts.discard):
            with pytest.raises(NotFound):
                ask(tmp_path, name)
        with pytest.raises(NotFound):
            upload_parts.finish(tmp_path, name, 5)
        with pytest.raises(NotFound):
            upload_parts.create(tmp_path, name, 5)
    upload_parts.create(tmp_path, "u1", 5)
    with pytest.raises(Conflict):
        upload_parts.create(tmp_path, "u1", 5)


def test_unknown_uploads_are_not_there(tmp_path: Path) -> None:
    with pytest.raises(NotFound, match="no such upload"):
        upload_parts.offset(tmp_path, "gone")
    with pytest.raises(NotFound):
        upload_parts.append(tmp_path, "gone", 10, 0, [b"x"])


def test_sweeping_takes_only_what_is_old(tmp_path: Path) -> None:
    for name in ("old", "new"):
        upload_parts.create(tmp_path, name, 10)
    os.utime(tmp_path / "old.part", (1, 1))
    assert upload_parts.sweep(tmp_path, 3600) == ["old"]
    assert upload_parts.offset(tmp_path, "new") == 0
    assert upload_parts.sweep(tmp_path / "none", 3600) == []


@pytest.mark.parametrize("after", [20, 300])
def test_a_killed_server_leaves_an_upload_that_goes_on(after: int, tmp_path: Path) -> None:
    source = tmp_path / "source"
    source.write_bytes(DATA)
    program = (
        "import os, signal\nfrom pathlib import Path\n"
        "from sightline.media.store import upload_parts as uploads\n"
        f"folder, data = Path({str(tmp_path / 'u')!r}), Path({str(source)!r}).read_bytes()\n"
        "uploads.create(folder, 'u1', len(data))\n"
        "def broken_off():\n"
        f"    for k in range(0, {500 * after}, 500):\n"
        "        yield data[k:k + 500]\n"
        "    os.kill(os.getpid(), signal.SIGKILL)\n"
        "uploads.append(folder, 'u1', len(data), 0, broken_off())\n"
    )
    child = subprocess.run([sys.executable, "-c", program], cwd=ROOT, check=False)
    assert child.returncode == -signal.SIGKILL
    have = upload_parts.offset(tmp_path / "u", "u1")
    assert have == 500 * after < len(DATA)
    upload_parts.append(tmp_path / "u", "u1", len(DATA), have, pieces(DATA[have:]))
    assert upload_parts.finish(tmp_path / "u", "u1", len(DATA)).path.read_bytes() == DATA
