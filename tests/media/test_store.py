"""The media store, the same promises kept by a folder and by a real S3 protocol server."""

from __future__ import annotations

import errno
import os
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from s3transfer.utils import OSUtils

from sightline import messages
from sightline.errors import BadInput, NoRoom, NotFound, SightlineError
from sightline.media.atomic import atomic_file
from sightline.media.store import local, s3
from sightline.media.store.local import (
    LocalStore,
    MediaStore,
    key_of,
    made_key_of,
    made_of,
    sha256_of,
)
from sightline.media.store.opening import open_store
from tests.support.waiting import NEVER_S

DATA = os.urandom(300_000)
THUMBS = made_key_of("ab" * 32, local.THUMBS, None, ".zip")


@pytest.fixture(scope="module")
def s3_endpoint() -> Iterator[str]:
    from moto.server import ThreadedMotoServer

    server = ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    server.start()
    host, port = server.get_host_and_port()
    yield f"http://{host}:{port}"
    server.stop()


OpenS3 = Callable[..., MediaStore]


@pytest.fixture
def open_s3(s3_endpoint: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> OpenS3:
    monkeypatch.setenv("AWS_ACCESS_KEY_ID", "test")
    monkeypatch.setenv("AWS_SECRET_ACCESS_KEY", "test")

    def run(cache: str = "cache", cache_bytes: int = 10_000_000) -> MediaStore:
        url = f"s3://{tmp_path.name.replace('_', '-')[:50].lower()}x/media?endpoint={s3_endpoint}"
        return open_store(url, tmp_path / cache, cache_bytes)

    return run


@pytest.fixture(params=["folder", "s3"])
def store(request: pytest.FixtureRequest, tmp_path: Path) -> MediaStore:
    if request.param == "folder":
        return open_store(str(tmp_path / "media"))
    made: MediaStore = request.getfixturevalue("open_s3")()
    return made


@pytest.fixture
def video(tmp_path: Path) -> Path:
    path = tmp_path / "day.mp4"
    path.write_bytes(DATA)
    return path


def test_what_is_put_is_there_until_deleted(store: MediaStore, video: Path) -> None:
    key = key_of(sha256_of(video), ".mp4")
    assert not store.exists(key)
    store.put_file(key, video)
    store.put_file(key, video)
    assert store.exists(key) and video.exists()
    assert store.local_path(key).read_bytes() == DATA
    assert sha256_of(store.local_path(key)) in key
    with store.open(key) as file:
        assert file.read(1000) == DATA[:1000]
    store.delete(key)
    store.delete(key)
    assert not store.exists(key)


def test_a_key_says_whether_it_tells_its_content() -> None:
    content = "0f" * 32
    assert made_of(made_key_of(content, local.THUMBS, None, ".zip")) == (content, None)
    assert made_of(made_key_of(content, local.COPY, 2, ".mkv")) == (content, 2)
    for suffix in ("", ".mp4", "-strip.tif", ".spool.tif", "-setup.jpg", ".zip"):
        assert made_of(key_of(content, suffix)) is None


@pytest.mark.parametrize("link", [False, True])
def test_what_is_made_anew_is_there_at_once_and_content_stays(
    store: MediaStore, video: Path, tmp_path: Path, link: bool
) -> None:
    other = tmp_path / "other"
    other.write_bytes(b"made anew")
    for key, then in ((THUMBS, b"made anew"), (key_of("ab" * 32, ".zip"), DATA)):
        for _ in range(2):
            store.put_file(key, video, link=link)
            assert store.local_path(key).read_bytes() == DATA
        store.put_file(key, other, link=link)
        assert store.local_path(key).read_bytes() == then


def test_linking_needs_no_room_and_outlives_the_given_file(
    store: MediaStore, video: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if isinstance(store, LocalStore):
        monkeypatch.setattr(local, "copy_whole", lambda *_: pytest.fail("bytes were copied"))
        monkeypatch.setattr(local, "check_room", lambda *_: pytest.fail("room was asked for"))
    store.put_file("a/b", video, link=True)
    store.put_file("a/b", video, link=True)
    video.unlink()
    monkeypatch.undo()
    assert store.exists("a/b")
    with store.open("a/b") as file:
        assert file.read() == DATA


def test_where_links_do_not_work_bytes_are_copied(
    tmp_path: Path, video: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def other_disk(*_: object) -> None:
        raise OSError(errno.EXDEV, "Invalid cross-device link")

    monkeypatch.setattr(local.os, "link", other_disk)
    store = LocalStore(tmp_path / "media")
    store.put_file("a/b", video, link=True)
    assert store.local_path("a/b").read_bytes() == DATA
    assert [p.name for p in (tmp_path / "media").rglob("*") if p.is_file()] == ["b"]


def test_all_files_are_listed_with_their_sizes(store: MediaStore, video: Path) -> None:
    assert list(store.listing()) == []
    for key in ("cd/ef/later.jpg", "ab/cd/first.mp4"):
        store.put_file(key, video)
    size = video.stat().st_size
    assert list(store.listing()) == [("ab/cd/first.mp4", size), ("cd/ef/later.jpg", size)]


def test_missing_files_are_told_in_a_sentence(store: MediaStore) -> None:
    for ask in (store.local_path, store.open):
        with pytest.raises(NotFound, match="missing from the store"):
            ask("no/such")


@pytest.mark.parametrize("key", ["../outside", "/etc/passwd", "a/../../b", "", "a//b", "a\\..\\b"])
def test_keys_do_not_lead_out_of_the_folder(key: str, tmp_path: Path, video: Path) -> None:
    store = LocalStore(tmp_path / "media")
    for ask in (store.local_path, store.open, store.exists, store.delete):
        with pytest.raises(NotFound):
            ask(key)
    with pytest.raises(NotFound):
        store.put_file(key, video)


def test_a_full_disk_is_seen_before_writing(
    tmp_path: Path, video: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    store = LocalStore(tmp_path / "media")
    usage = type("Usage", (), {"free": local.RESERVE_BYTES + 1000})
    monkeypatch.setattr(local.shutil, "disk_usage", lambda _: usage)
    with pytest.raises(NoRoom, match="There is not enough space") as told:
        store.put_file("a/b", video)
    french = messages.say(told.value.said.code, told.value.said.values, "fr")
    assert french.startswith("Il n’y a pas assez de place (0,3 Mo nécessaires, 0 Mo libres)\u202f; supprimez")
    assert not any(p.is_file() for p in (tmp_path / "media").rglob("*"))


def test_a_disk_that_fills_up_while_writing_leaves_nothing(
    tmp_path: Path, video: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    store = LocalStore(tmp_path / "media")
    monkeypatch.setattr(local.os, "fsync", full)
    with pytest.raises(NoRoom, match="disk is full"):
        store.put_file("a/b", video)
    assert not any(p.is_file() for p in (tmp_path / "media").rglob("*"))


def test_s3_cache_is_bounded_and_refilled(open_s3: OpenS3, tmp_path: Path, video: Path) -> None:
    store = open_s3(cache_bytes=700_000)
    for k in range(4):
        store.put_file(f"a/{k}", video)
        assert store.local_path(f"a/{k}").read_bytes() == DATA
    held = [p for p in (tmp_path / "cache").rglob("*") if p.is_file()]
    assert sum(p.stat().st_size for p in held) <= 700_000
    assert store.local_path("a/0").read_bytes() == DATA


def test_s3_cache_leaves_alone_what_is_on_its_way(open_s3: OpenS3, tmp_path: Path, video: Path) -> None:
    store = open_s3(cache_bytes=1)
    store.put_file("a/b", video)
    with atomic_file(tmp_path / "cache" / "a" / "large", lasting=False) as part:
        coming = Path(OSUtils().get_temp_filename(str(part)))
        coming.write_bytes(DATA)
        store.local_path("a/b")
        coming.rename(part)
        left = part.with_name(f"{part.name}.Ab12")
        left.write_bytes(DATA)
        os.utime(left, (0, 0))  # its process was killed long ago
        store.delete("a/b")
        store.put_file("a/b", video)
        store.local_path("a/b")
        assert not left.exists() and part.exists()


def test_s3_fetches_of_two_files_do_not_wait_for_each_other(
    open_s3: OpenS3, video: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One large file on its way stops nobody but those who want the same one, and it is fetched once."""
    store = open_s3()
    for key in ("large", "small"):
        store.put_file(key, video)
    under_way, go_on, fetched = threading.Event(), threading.Event(), []
    fetch = store._fetch

    def slowly(key: str, path: Path) -> None:
        fetched.append(key)
        if key == "large":
            under_way.set()
            assert go_on.wait(NEVER_S)
        fetch(key, path)

    monkeypatch.setattr(store, "_fetch", slowly)
    with ThreadPoolExecutor(3) as pool:
        large = [pool.submit(store.local_path, "large") for _ in range(2)]
        assert under_way.wait(NEVER_S)
        assert pool.submit(store.local_path, "small").result(NEVER_S).read_bytes() == DATA
        go_on.set()
        assert [one.result(NEVER_S).read_bytes() for one in large] == [DATA, DATA]
    assert sorted(fetched) == ["large", "small"]


def test_s3_is_shared_by_machines(open_s3: OpenS3, video: Path) -> None:
    open_s3("one").put_file("a/b", video)
    assert open_s3("two").local_path("a/b").read_bytes() == DATA


def test_what_one_machine_replaces_or_deletes_the_others_see(
    open_s3: OpenS3, video: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(s3, "BELIEVED_S", 0.0)
    one, two = open_s3("one"), open_s3("two")
    other = tmp_path / "other"
    other.write_bytes(DATA[::-1])  # as long as what it replaces
    one.put_file(THUMBS, video)
    then = two.local_path(THUMBS)
    assert then.read_bytes() == DATA and two.local_path(THUMBS) == then
    one.put_file(THUMBS, other)
    now = two.local_path(THUMBS)
    assert now.read_bytes() == DATA[::-1]
    assert now != then and now.suffix == ".zip"  # who has the other one open does not take it for this one
    one.delete(THUMBS)
    with pytest.raises(NotFound):
        two.local_path(THUMBS)


def test_what_is_replaced_while_it_is_fetched_is_not_kept_under_the_former_tag(
    open_s3: OpenS3, video: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(s3, "BELIEVED_S", 0.0)
    one, two = open_s3("one"), open_s3("two")
    other = tmp_path / "other"
    other.write_bytes(b"made anew")
    one.put_file(THUMBS, video)
    fetch, meanwhile = two._fetch, [other]

    def overtaken(key: str, path: Path) -> None:
        if meanwhile:
            one.put_file(key, meanwhile.pop())
        fetch(key, path)

    monkeypatch.setattr(two, "_fetch", overtaken)
    assert two.local_path(THUMBS).read_bytes() == b"made anew"
    one.put_file(THUMBS, video)
    assert two.local_path(THUMBS).read_bytes() == DATA


def test_s3_that_does_not_answer_is_told_in_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("AWS_ACCESS_KEY_ID", "test")
    monkeypatch.setenv("AWS_SECRET_ACCESS_KEY", "test")
    monkeypatch.setenv("AWS_MAX_ATTEMPTS", "1")
    with pytest.raises(SightlineError, match="did not answer"):
        open_store("s3://bucket?endpoint=http://127.0.0.1:9", tmp_path)


@pytest.mark.parametrize("url", ["", "ftp://x/y", "s3://?x=1", "s3:///prefix"])
def test_addresses_that_name_no_store(url: str, tmp_path: Path) -> None:
    with pytest.raises(BadInput):
        open_store(url, tmp_path)


def test_addresses_of_folders(tmp_path: Path, video: Path) -> None:
    open_store(f"file://{tmp_path}/with%20space").put_file("a", video)
    assert (tmp_path / "with space" / "a").read_bytes() == DATA
