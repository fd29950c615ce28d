"""Object storage that answers 500, half, late or not at all: a sentence, nothing half, all is well after."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from sightline.infra.database.engine import SHORT_IDLE_S
from sightline.media.store import s3
from sightline.media.store.opening import open_store
from sightline.media.store.s3 import S3Store, StorageAway
from tests.media.faulty_s3 import Fault, FaultyS3
from tests.support.waiting import NEVER_S

DATA = os.urandom(300_000)


@pytest.fixture(scope="module")
def faulty() -> Iterator[FaultyS3]:
    from moto.server import ThreadedMotoServer

    server = ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    server.start()
    host, port = server.get_host_and_port()
    between = FaultyS3(f"http://{host}:{port}")
    yield between
    between.close()
    server.stop()


@pytest.fixture
def store(faulty: FaultyS3, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> S3Store:
    monkeypatch.setenv("AWS_ACCESS_KEY_ID", "test")
    monkeypatch.setenv("AWS_SECRET_ACCESS_KEY", "test")
    monkeypatch.setattr(s3, "ATTEMPTS", 2)
    faulty.begin("none")
    return opened(faulty, tmp_path)


@pytest.fixture
def hasty(store: S3Store, faulty: FaultyS3, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> S3Store:
    """The same store, asked by one who does not wait for long."""
    monkeypatch.setattr(s3, "READ_S", 0.3)
    monkeypatch.setattr(S3Store, "_make_bucket", lambda _: None)
    return opened(faulty, tmp_path)


def opened(faulty: FaultyS3, tmp_path: Path) -> S3Store:
    name = "".join(sign for sign in tmp_path.name.lower() if sign.isalnum())[-40:]
    made = open_store(f"s3://{name}/media?endpoint={faulty.url}", tmp_path / "cache")
    assert isinstance(made, S3Store)
    return made


@pytest.fixture
def video(tmp_path: Path) -> Path:
    path = tmp_path / "day.mp4"
    path.write_bytes(DATA)
    return path


@pytest.mark.parametrize("fault", ["500", "cut", "slow", "closed"])
def test_a_store_with_a_fault_is_told_and_leaves_nothing_half(
    fault: Fault, faulty: FaultyS3, store: S3Store, hasty: S3Store, video: Path, tmp_path: Path
) -> None:
    store.put_file("a/kept", video)
    faulty.begin(fault)
    with pytest.raises(StorageAway, match="did not answer") as told:
        hasty.local_path("a/kept")
    assert told.value.status == 503
    with pytest.raises(StorageAway), hasty.open("a/kept") as file:
        file.read()
    if fault != "cut":  # an answer to PUT has no body to cut
        with pytest.raises(StorageAway):
            hasty.put_file("a/new", video)
    assert not [path for path in (tmp_path / "cache").rglob("*") if path.is_file()]
    faulty.begin("none")
    store.put_file("a/new", video)
    assert store.local_path("a/kept").read_bytes() == store.local_path("a/new").read_bytes() == DATA


def test_what_others_wait_for_is_not_waited_for_long(
    faulty: FaultyS3, store: S3Store, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Under the lock under which files go: a store that is silent keeps nobody from writing."""
    once_s = s3.AT_ONCE_CONNECT_S + s3.AT_ONCE_READ_S
    assert s3.AT_ONCE_ATTEMPTS * once_s + 1.0 < SHORT_IDLE_S  # with the pause between two tries
    monkeypatch.setattr(S3Store, "_make_bucket", lambda _: None)
    monkeypatch.setattr(s3, "READ_S", NEVER_S)
    monkeypatch.setattr(s3, "AT_ONCE_READ_S", 0.2)
    patient = opened(faulty, tmp_path)
    faulty.begin("slow")
    with pytest.raises(StorageAway):
        patient.delete("a/kept")
    with pytest.raises(StorageAway):
        patient.exists("a/kept")
    assert faulty.asked == 2 * s3.AT_ONCE_ATTEMPTS
    faulty.begin("closed", 1)
    patient.delete("a/kept")


def test_one_bad_answer_is_asked_again_without_a_word(faulty: FaultyS3, store: S3Store, video: Path) -> None:
    for fault in ("500", "closed"):
        faulty.begin(fault, 1)
        store.put_file(f"a/{fault}", video)
        assert faulty.asked > 1 and store.local_path(f"a/{fault}").read_bytes() == DATA
