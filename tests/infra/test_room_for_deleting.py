"""With a full disk a deletion has the room that was kept for it, and /api/ready tells of the disk."""

import errno
import os
from pathlib import Path

import pytest

from sightline.errors import NoRoom
from sightline.infra.services import Services
from sightline.infra.web import ballast
from sightline.infra.web.ballast import Ballast, try_to_write
from tests.support.app import Client


@pytest.fixture
def held(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Ballast:
    monkeypatch.setattr(ballast, "HELD_BYTES", 1 << 16)
    made = Ballast(tmp_path)
    monkeypatch.setattr(made, "_free", lambda: 1 << 30)
    made.take()
    return made


def test_room_is_kept_given_up_when_the_disk_is_full_and_taken_again(
    held: Ballast, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert held.path.stat().st_blocks * 512 >= 1 << 16 and held.path.stat().st_mode & 0o077 == 0
    held.give_if_full()
    assert held.path.exists()
    monkeypatch.setattr(held, "_free", lambda: 0)
    held.give_if_full()
    assert not held.path.exists()
    held.take()
    assert not held.path.exists()
    monkeypatch.setattr(held, "_free", lambda: 1 << 30)
    held.take()
    assert held.path.stat().st_size == 1 << 16


def test_a_deletion_gives_the_room_up_before_it_writes(
    operator: Client, survey_id: int, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ballast, "HELD_BYTES", 1 << 16)
    kept = Ballast(services.settings.data_dir)
    kept.take()
    assert kept.path.exists()
    monkeypatch.setattr(Ballast, "_free", lambda _self: 0)
    assert operator.get(f"/surveys/{survey_id}").status_code == 200 and kept.path.exists()
    assert operator.delete("/recordings/999").status_code == 404
    assert not kept.path.exists()


def test_ready_tries_to_write(nobody: Client, services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    before = set(services.settings.data_dir.iterdir())
    assert nobody.get("/ready").json()["disk"] is None
    assert set(services.settings.data_dir.iterdir()) == before

    def full(_handle: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    answer = nobody.get("/ready")
    assert answer.status_code == 503 and answer.json()["ok"] is False
    assert answer.json()["disk"] == NoRoom("database-disk-full").message
    assert set(services.settings.data_dir.iterdir()) == before
    with pytest.raises(OSError, match="No such file"):
        try_to_write(services.settings.data_dir / "not there")
