"""With a full disk a deletion has the room that was kept for it, and /api/ready tells of the disk."""

import errno
import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from sqlalchemy import update
from sqlalchemy.orm import Session

from sightline.errors import NoRoom
from sightline.infra.backup.state import needed_media
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.tables import jobs
from sightline.infra.services import Services
from sightline.infra.web import ballast
from sightline.infra.web.ballast import Ballast, try_to_write
from sightline.media.store.local import LocalStore
from sightline.media.store.s3 import StorageAway
from sightline.messages.said import Said
from sightline.recordings import tidy_job
from tests.support.app import TUS, Client, upload
from tests.support.boards import picture_bytes
from tests.support.scanning_ground import RIG, upload_strip, uploads

Work = Callable[[], list[Job]]


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


def test_what_is_deleted_while_the_store_is_away_loses_its_files_when_it_is_back(
    operator: Client,
    survey_id: int,
    recording_id: int,
    services: Services,
    work: Work,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    camera_id = operator.made(f"/surveys/{survey_id}/cameras", {"name": "Left"})["id"]
    picture = {"file": ("board.png", picture_bytes(np.full((480, 640, 3), 128, np.uint8)))}
    image = operator.post(f"/cameras/{camera_id}/images?columns=9&rows=6", files=picture).json()["id"]
    strip = upload_strip(operator, survey_id, b"lines", "left.tif")
    scan = operator.made(f"/surveys/{survey_id}/scans", {**RIG, **uploads(operator, survey_id, tmp_path)})[
        "id"
    ]
    operator.post(f"/jobs/{operator.seen(f'/scans/{scan}')['job']['id']}/cancel")
    paths = (
        f"/recordings/{recording_id}",
        f"/calibration-images/{image}",
        f"/uploads/{strip}",
        f"/scans/{scan}",
    )

    def away(_store: LocalStore, key: str) -> bool:
        raise StorageAway("store-no-answer", key=key, name="Timeout")

    stored, asked = sorted(services.media.listing()), list[Session]()

    def noted(session: Session, key: str) -> set[str]:
        asked.append(session)
        return needed_media(session, key)

    with monkeypatch.context() as outage:
        outage.setattr(LocalStore, "exists", away)
        outage.setattr(LocalStore, "delete", away)
        assert [operator.delete(path, headers=TUS).status_code for path in paths] == [204] * 4
        assert [job.state for job in work()] == ["queued"] * 4
    assert sorted(services.media.listing()) == stored
    with services.writing() as session:  # its pause is over
        session.execute(update(jobs).values(not_before=None))
    monkeypatch.setattr(tidy_job, "needed_media", noted)
    assert [job.state for job in work()] == ["done"] * 4
    assert not list(services.media.listing())
    assert len({id(one) for one in asked}) == len(asked) == 5  # nobody waits for more than one to be deleted


def test_nobody_cancels_the_deletion_of_files(admin: Client, recording_id: int) -> None:
    """What they are would be known by nobody else."""
    assert admin.delete(f"/recordings/{recording_id}").status_code == 204
    (waiting,) = admin.seen("/jobs?state=queued")
    assert waiting["cancellable"] is False
    answer = admin.post(f"/jobs/{waiting['id']}/cancel")
    assert (answer.status_code, answer.json()["error"]["code"]) == (409, "jobs-not-to-be-cancelled")
    assert admin.seen(f"/jobs/{waiting['id']}")["state"] == "queued"


def test_deletions_of_files_are_listed_until_they_are_done(
    operator: Client, survey_id: int, clip: Path, services: Services, work: Work
) -> None:
    """Many of them would push off the list what people asked for."""
    asked = [upload(operator, survey_id, clip, name) for name in ("a.mp4", "b.mp4")]
    assert [one["cancellable"] for one in operator.seen("/jobs")] == [True, True]
    work()
    assert [one["cancellable"] for one in operator.seen("/jobs")] == [False, False]
    for recording_id in asked:
        assert operator.delete(f"/recordings/{recording_id}").status_code == 204
    assert [one["kind"] for one in operator.seen("/jobs")] == ["tidy", "tidy", "ingest", "ingest"]
    (done, failed) = work()
    with services.writing() as session:
        change = {"state": "failed", "error": Said("database-disk-full"), "result": None}
        session.execute(update(jobs).where(jobs.c.id == failed.id).values(change))
    assert [one["kind"] for one in operator.seen("/jobs")] == ["tidy", "ingest", "ingest"]
    assert [one["id"] for one in operator.seen("/jobs?state=failed")] == [failed.id]
    assert operator.seen(f"/jobs/{done.id}")["state"] == "done"


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
