"""Resumable uploads: whole, broken, killed, twice, too large, not a video."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from fastapi.testclient import TestClient

from sightline.app import create_app
from sightline.errors import NoRoom
from sightline.infra.backup.state import needed_media
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services, open_services
from sightline.infra.stored_bytes import suffix_of
from sightline.infra.web.uploaded import clean_name
from sightline.media.store import local, upload_parts
from sightline.media.store.s3 import StorageAway
from sightline.media.video.ingest import Ingested
from sightline.recordings import ingest_job
from sightline.recordings.ingest_job import remove_recording
from sightline.recordings.uploads import service
from sightline.recordings.uploads.store import get_upload
from sightline.settings import Settings
from tests.support.app import TUS, Client, announce, error_of, send, upload
from tests.support.boards import picture_bytes
from tests.support.scanning_ground import upload_strip

pytestmark = pytest.mark.dialect

Work = Callable[[], list[Job]]


def offset_of(client: Client, location: str) -> int:
    answer = client.http.head(location, headers=TUS)
    assert answer.status_code == 200
    assert answer.headers["cache-control"] == "no-store"
    return int(answer.headers["Upload-Offset"])


@pytest.mark.once
def test_what_the_server_can(nobody: Client) -> None:
    answer = nobody.http.options("/api/uploads")
    assert answer.headers["Tus-Version"] == "1.0.0"
    assert set(answer.headers["Tus-Extension"].split(",")) == {"creation", "termination"}


def test_in_pieces_and_after_a_break(operator: Client, survey_id: int, clip: Path, work: Work) -> None:
    content = clip.read_bytes()
    created = announce(operator, survey_id, "day one.mp4", len(content))
    assert created.status_code == 201
    location = created.headers["Location"]
    assert offset_of(operator, location) == 0
    assert send(operator, location, 0, content[:4000]).headers["Upload-Offset"] == "4000"
    waiting = operator.seen(f"/surveys/{survey_id}/uploads")
    assert [(one["filename"], one["offset"]) for one in waiting] == [("day one.mp4", 4000)]
    wrong = send(operator, location, 3000, content[3000:])
    assert wrong.status_code == 409
    assert "4000" in error_of(wrong)
    last = send(operator, location, 4000, content[4000:])
    assert last.status_code == 204
    recording_id = int(last.headers["Sightline-Recording"])
    assert operator.seen(f"/surveys/{survey_id}/uploads") == []
    recording = operator.seen(f"/recordings/{recording_id}")
    assert recording["state"] == "ingesting" and recording["job"]["state"] == "queued"
    assert recording["name"] == "day one.mp4" and recording["size_bytes"] == len(content)
    # A client that did not hear the last answer asks again and is told.
    again = operator.http.head(location, headers=TUS)
    assert again.headers["Upload-Offset"] == str(len(content))
    assert again.headers["Sightline-Recording"] == str(recording_id)
    assert send(operator, location, len(content), b"").status_code == 409
    assert [job.state for job in work()] == ["done"]
    assert operator.seen(f"/recordings/{recording_id}")["state"] == "ready"


def test_the_connection_breaks_in_the_middle(
    operator: Client, survey_id: int, clip: Path, services: Services
) -> None:
    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]

    class Broken(Exception):
        pass

    def pieces() -> Iterator[bytes]:
        yield content[:5000]
        raise Broken

    upload_id = int(location.rpartition("/")[2])
    with services.reading() as session:
        found = get_upload(session, upload_id)
    with pytest.raises(Broken):
        service.take_bytes(services, found, 0, pieces())
    assert offset_of(operator, location) == 5000
    assert operator.seen(f"/surveys/{survey_id}/uploads")[0]["offset"] == 5000
    assert send(operator, location, 5000, content[5000:]).headers["Sightline-Recording"]


def test_a_part_left_behind_stands_in_no_ones_way(
    operator: Client, survey_id: int, clip: Path, services: Services
) -> None:
    """What a commit that failed leaves, or a database put back to what it was."""
    folder = service.upload_folder(services)
    for number in range(1, 4):
        upload_parts.create(folder, service.part_name(number), 9)
        upload_parts.append(folder, service.part_name(number), 9, 0, [b"another's"])
    assert upload(operator, survey_id, clip)


def test_a_recording_is_of_who_sent_its_last_byte(
    operator: Client, admin: Client, survey_id: int, clip: Path, work: Work
) -> None:
    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]
    assert send(operator, location, 0, content[:4000]).status_code == 204
    mine = [one.seen(f"/surveys/{survey_id}/uploads")[0]["mine"] for one in (operator, admin)]
    assert mine == [True, False]
    assert send(admin, location, 4000, content[4000:]).status_code == 204
    assert [job.created_by for job in work()] == [admin.seen("/session")["person"]["id"]]


def test_the_number_of_an_upload_given_up_is_no_others(operator: Client, survey_id: int) -> None:
    gone = announce(operator, survey_id, "a.mp4", 9).headers["Location"]
    assert operator.http.delete(gone, headers=TUS).status_code == 204
    assert announce(operator, survey_id, "b.mp4", 9).headers["Location"] != gone
    assert operator.http.head(gone, headers=TUS).status_code == 404


def test_a_server_killed_behind_the_last_byte(
    operator: Client, survey_id: int, clip: Path, services: Services, settings: Settings
) -> None:
    """The bytes are all there, nothing else is: a new server makes the recording without being asked."""
    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]
    part = f"upload-{location.rpartition('/')[2]}"
    upload_parts.append(service.upload_folder(services), part, len(content), 0, [content])
    assert operator.seen(f"/surveys/{survey_id}/recordings") == []
    reborn = open_services(settings)
    with TestClient(create_app(services=reborn)):
        pass
    reborn.close()
    (recording,) = operator.seen(f"/surveys/{survey_id}/recordings")
    assert recording["state"] == "ingesting" and recording["job"]["state"] == "queued"
    assert not list(service.upload_folder(services).iterdir())


def test_an_empty_patch_finishes_what_the_kill_left(
    operator: Client, survey_id: int, clip: Path, services: Services
) -> None:
    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]
    part = f"upload-{location.rpartition('/')[2]}"
    upload_parts.append(service.upload_folder(services), part, len(content), 0, [content])
    asked = operator.http.head(location, headers=TUS)
    assert asked.headers["Upload-Offset"] == str(len(content))
    assert not {"Sightline-Recording", "Sightline-Finished"} & set(asked.headers)
    assert operator.seen(f"/surveys/{survey_id}/recordings") == []
    assert send(operator, location, len(content), b"").headers["Sightline-Recording"]
    assert operator.http.head(location, headers=TUS).headers["Sightline-Finished"] == "1"
    assert len(operator.seen(f"/surveys/{survey_id}/recordings")) == 1


def test_the_same_video_twice_is_stored_once(
    operator: Client, survey_id: int, clip: Path, work: Work, services: Services
) -> None:
    first, second = upload(operator, survey_id, clip), upload(operator, survey_id, clip, "copy.mp4")
    assert first != second
    assert [job.state for job in work()] == ["done", "done"]
    stored = [path for path in (services.settings.data_dir / "media").rglob("*.mp4")]
    assert len(stored) == 1
    assert operator.delete(f"/recordings/{first}").status_code == 204
    assert [job.state for job in work()] == ["done"]
    assert stored[0].exists()
    assert operator.get(f"/recordings/{second}/frames/3.jpg").status_code == 200
    assert operator.delete(f"/recordings/{second}").status_code == 204
    assert [job.state for job in work()] == ["done"]
    assert not stored[0].exists()
    assert operator.get(f"/recordings/{second}/frames/3.jpg").status_code == 404


def test_a_twin_deleted_while_an_upload_ends_does_not_take_its_file_along(
    operator: Client,
    survey_id: int,
    clip: Path,
    services: Services,
    work: Work,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first = upload(operator, survey_id, clip)
    work()
    put_file, deleted = local.LocalStore.put_file, list[int]()

    def then_deleted(store: local.LocalStore, key: str, path: Path, **how: bool) -> None:
        put_file(store, key, path, **how)
        if not deleted:
            deleted.append(first)
            remove_recording(services, first, None)
            work()

    monkeypatch.setattr(local.LocalStore, "put_file", then_deleted)
    second = upload(operator, survey_id, clip)
    assert deleted == [first]
    assert [job.state for job in work()] == ["done"]
    assert operator.get(f"/recordings/{second}/frames/3.jpg").status_code == 200


def test_a_store_that_is_away_behind_the_last_byte_leaves_the_upload_to_be_finished(
    operator: Client,
    survey_id: int,
    clip: Path,
    services: Services,
    work: Work,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A twin's deletion took the file along, and just then the store does not tell whether it is there."""
    content, twin = clip.read_bytes(), upload(operator, survey_id, clip)
    work()
    location = announce(operator, survey_id, "b.mp4", len(content)).headers["Location"]
    put_file = local.LocalStore.put_file

    def away(_store: local.LocalStore, key: str) -> bool:
        raise StorageAway("store-no-answer", key=key, name="Timeout")

    with monkeypatch.context() as outage:

        def then_away(store: local.LocalStore, key: str, path: Path, **how: bool) -> None:
            put_file(store, key, path, **how)
            remove_recording(services, twin, None)
            work()
            outage.setattr(local.LocalStore, "exists", away)

        outage.setattr(local.LocalStore, "put_file", then_away)
        assert send(operator, location, 0, content).status_code == 503
    assert operator.seen(f"/surveys/{survey_id}/recordings") == []
    taken = int(send(operator, location, len(content), b"").headers["Sightline-Recording"])
    assert {(job.kind, job.state) for job in work()} == {("ingest", "done"), ("tidy", "done")}
    assert operator.get(f"/recordings/{taken}/frames/3.jpg").status_code == 200
    assert not list(service.upload_folder(services).glob("upload-*"))


def test_a_strip_that_is_given_up_takes_its_file_along_unless_another_has_it(
    operator: Client, survey_id: int, services: Services, work: Work
) -> None:
    first, second = (upload_strip(operator, survey_id, b"lines", "left.tif") for _ in range(2))
    with services.reading() as session:
        key = get_upload(session, first).media_key
        assert key in needed_media(session)  # a backup without it would not be whole
    for upload_id, left in ((first, True), (second, False)):
        assert operator.http.delete(f"/api/uploads/{upload_id}", headers=TUS).status_code == 204
        assert [job.state for job in work()] == ["done"]
        assert services.media.exists(key) is left


def test_what_is_no_video_goes_without_the_file_of_what_is_one(
    operator: Client, survey_id: int, work: Work, tmp_path: Path, services: Services
) -> None:
    """A board's picture and a strip that were uploaded as videos too: they fail, and are taken out."""
    file = tmp_path / "board.png"
    file.write_bytes(picture_bytes(np.full((480, 640, 3), 128, np.uint8)))
    camera_id = operator.made(f"/surveys/{survey_id}/cameras", {"name": "Left"})["id"]
    path = f"/cameras/{camera_id}/images?columns=9&rows=6"
    image = operator.post(path, files={"file": ("board.png", file.read_bytes())}).json()
    strip = upload_strip(operator, survey_id, file.read_bytes(), "board.png")
    taken = upload(operator, survey_id, file)
    assert [job.state for job in work()] == ["failed"]
    assert operator.delete(f"/recordings/{taken}").status_code == 204
    work()
    assert operator.http.get(image["url"]).status_code == 200
    assert operator.delete(f"/calibration-images/{image['id']}").status_code == 204
    work()
    with services.reading() as session:
        assert services.media.exists(get_upload(session, strip).media_key)
    (left,) = (services.settings.data_dir / "media").rglob("*.png")
    assert left.name.endswith("-strip.png")


def test_what_two_names_of_one_video_share_stays_until_both_are_deleted(
    operator: Client, survey_id: int, clip: Path, work: Work
) -> None:
    one, other = (upload(operator, survey_id, clip, name) for name in ("a.mp4", "a.mov"))
    work()
    assert operator.delete(f"/recordings/{one}").status_code == 204
    work()
    assert operator.get(f"/recordings/{other}/frames/3.jpg").status_code == 200
    thumb = operator.seen(f"/recordings/{other}")["thumbs"][0]["url"]
    assert operator.http.get(thumb).status_code == 200


def test_a_twin_that_cannot_be_read_takes_nothing_from_what_was(
    operator: Client, survey_id: int, clip: Path, work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The disk is full where its thumbnails are stored."""
    one = upload(operator, survey_id, clip)
    work()
    put_file = local.LocalStore.put_file

    def full(store: local.LocalStore, key: str, path: Path, **how: bool) -> None:
        if ".thumbs" in key:
            raise NoRoom("database-disk-full")
        put_file(store, key, path, **how)

    monkeypatch.setattr(local.LocalStore, "put_file", full)
    upload(operator, survey_id, clip, "copy.mp4")
    assert [job.state for job in work()] == ["failed"]
    thumb = operator.seen(f"/recordings/{one}")["thumbs"][0]["url"]
    assert operator.http.get(thumb).status_code == 200


@pytest.mark.once
def test_a_thumbnail_that_a_twins_reading_left_out_is_said_to_be_missing(
    operator: Client, survey_id: int, clip: Path, work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    one, pack = upload(operator, survey_id, clip), ingest_job.pack_thumbnails
    work()
    first, *_, last = (thumb["url"] for thumb in operator.seen(f"/recordings/{one}")["thumbs"])

    def pack_first(folder: Path, found: Ingested) -> Path:
        return pack(folder, replace(found, thumbnails=found.thumbnails[:1]))

    monkeypatch.setattr(ingest_job, "pack_thumbnails", pack_first)
    upload(operator, survey_id, clip, "copy.mp4")
    work()
    assert operator.http.get(first).status_code == 200
    answer = operator.http.get(last)
    assert answer.status_code == 404 and "has no thumbnail" in error_of(answer)


@pytest.mark.once
def test_a_recording_that_is_not_noted_leaves_no_file_when_its_upload_is_given_up(
    operator: Client,
    survey_id: int,
    clip: Path,
    services: Services,
    work: Work,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def full(*_given: object, **_more: object) -> None:
        raise NoRoom("database-disk-full")

    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]
    monkeypatch.setattr(service, "create_recording", full)
    assert send(operator, location, 0, content).status_code == 507
    assert len(list(services.media.listing())) == 1
    assert operator.http.delete(location, headers=TUS).status_code == 204
    assert [job.kind for job in work()] == ["tidy"] and not list(services.media.listing())


@pytest.mark.once
def test_a_full_disk_is_told_before_a_byte_is_sent(
    operator: Client, survey_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Usage:
        free = 1_000_000

    monkeypatch.setattr(local.shutil, "disk_usage", lambda _path: Usage)
    answer = announce(operator, survey_id, "a.mp4", 5_000_000_000)
    assert answer.status_code == 507
    assert "not enough space" in error_of(answer)
    assert operator.seen(f"/surveys/{survey_id}/uploads") == []


@pytest.mark.once
def test_what_one_person_announced_must_fit_together(
    operator: Client, admin: Client, survey_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Usage:
        free = local.RESERVE_BYTES + 12_000_000

    monkeypatch.setattr(local.shutil, "disk_usage", lambda _path: Usage)
    first = announce(operator, survey_id, "a.mp4", 8_000_000).headers["Location"]
    refused = announce(operator, survey_id, "b.mp4", 5_000_000)
    assert refused.status_code == 507
    assert "(5 MB) beside" in error_of(refused) and "(8 MB still to come, 12 MB free)" in error_of(refused)
    assert announce(operator, survey_id, "c.mp4", 4_000_000).status_code == 201
    assert announce(admin, survey_id, "d.mp4", 12_000_000).status_code == 201
    # what has arrived is on the disk already
    assert send(operator, first, 0, b"x" * 1_000_000).status_code == 204
    assert announce(operator, survey_id, "e.mp4", 1_000_000).status_code == 201
    assert announce(operator, survey_id, "f.mp4", 1).status_code == 507
    # of what never came, or was given up, no room is kept
    assert operator.http.delete(first, headers=TUS).status_code == 204
    assert announce(operator, survey_id, "f.mp4", 7_000_000).status_code == 201
    monkeypatch.setattr(service, "NEVER_CAME_S", 0.0)
    assert announce(operator, survey_id, "g.mp4", 12_000_000).status_code == 201


@pytest.mark.once
def test_a_disk_that_fills_up_keeps_what_arrived(
    operator: Client, survey_id: int, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]
    send(operator, location, 0, content[:2000])

    def full(*_: object) -> int:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(upload_parts.os, "write", full)
        answer = send(operator, location, 2000, content[2000:])
    assert answer.status_code == 507
    assert "disk is full" in error_of(answer)
    assert offset_of(operator, location) == 2000
    assert send(operator, location, 2000, content[2000:]).status_code == 204


def test_giving_up(operator: Client, survey_id: int, services: Services) -> None:
    location = announce(operator, survey_id, "a.mp4", 100).headers["Location"]
    send(operator, location, 0, b"x" * 50)
    assert operator.http.delete(location, headers=TUS).status_code == 204
    assert operator.http.head(location, headers=TUS).status_code == 404
    assert send(operator, location, 50, b"x").status_code == 404
    assert not list(service.upload_folder(services).iterdir())


def test_abandoned_uploads_go_after_a_week(operator: Client, survey_id: int, services: Services) -> None:
    import os

    location = announce(operator, survey_id, "a.mp4", 100).headers["Location"]
    service.recover_uploads(services)
    assert offset_of(operator, location) == 0
    for path in service.upload_folder(services).iterdir():
        os.utime(path, (1, 1))
    service.recover_uploads(services)
    assert operator.seen(f"/surveys/{survey_id}/uploads") == []


def test_announced_uploads_have_a_limit_for_each_person(
    operator: Client, admin: Client, survey_id: int, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(service, "MOST_ANNOUNCED", 3)
    locations = [announce(operator, survey_id, "a.mp4", 100).headers["Location"] for _ in range(3)]
    refused = announce(operator, survey_id, "a.mp4", 100)
    assert refused.status_code == 429
    assert error_of(refused) == "You have 3 uploads that are not complete; finish or cancel some first."
    assert announce(admin, survey_id, "a.mp4", 100).status_code == 201
    assert len(operator.seen(f"/surveys/{survey_id}/uploads")) == 4
    assert operator.http.delete(locations[0], headers=TUS).status_code == 204
    assert announce(operator, survey_id, "a.mp4", 100).status_code == 201


def test_who_announced_and_never_sent_is_not_locked_out_for_ever(
    operator: Client, survey_id: int, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(service, "MOST_ANNOUNCED", 2)
    begun = announce(operator, survey_id, "begun.mp4", 100).headers["Location"]
    assert send(operator, begun, 0, b"x" * 50).status_code == 204
    announce(operator, survey_id, "never.mp4", 100)
    assert announce(operator, survey_id, "c.mp4", 100).status_code == 429
    monkeypatch.setattr(service, "NEVER_CAME_S", 0.0)
    assert announce(operator, survey_id, "c.mp4", 100).status_code == 201
    names = [one["filename"] for one in operator.seen(f"/surveys/{survey_id}/uploads")]
    assert names == ["begun.mp4", "c.mp4"]


def test_after_a_restore_announced_uploads_go_without_a_word_at_every_start(
    operator: Client,
    survey_id: int,
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
) -> None:
    announce(operator, survey_id, "a.mp4", 100)
    for path in service.upload_folder(services).iterdir():
        path.unlink()
    service.recover_uploads(services)
    assert len(operator.seen(f"/surveys/{survey_id}/uploads")) == 1 and not caplog.records
    monkeypatch.setattr(service, "NEVER_CAME_S", 0.0)
    service.recover_uploads(services)
    assert operator.seen(f"/surveys/{survey_id}/uploads") == [] and not caplog.records


@pytest.mark.parametrize(("whole", "status"), [(False, 404), (True, 404), (False, 401)])
def test_who_is_taken_out_in_the_middle_of_a_patch_is_refused(
    operator: Client,
    admin: Client,
    survey_id: int,
    clip: Path,
    monkeypatch: pytest.MonkeyPatch,
    whole: bool,
    status: int,
) -> None:
    """Also where all bytes had come: nothing becomes a recording."""
    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]
    people = {one["email"]: one["id"] for one in admin.seen("/people")}
    write, operator_id = upload_parts._write_all, people["operator@example.org"]
    members = f"/surveys/{survey_id}/members"
    assert admin.put(f"{members}/{people['admin@example.org']}", {"role": "manager"}).status_code == 200
    assert admin.put(f"{members}/{operator_id}", {"role": "operator"}).status_code == 200
    assert admin.put(f"/surveys/{survey_id}/open-to-all", {"open_to_all": False}).status_code == 200

    def taken_out(handle: int, chunk: bytes) -> None:
        write(handle, chunk)
        off = {"name": "Operator", "role": "operator", "active": False}
        changed = (
            admin.put(f"/people/{operator_id}", off)
            if status == 401
            else admin.delete(f"{members}/{operator_id}")
        )
        assert changed.status_code == 200, changed.text

    monkeypatch.setattr(upload_parts, "_write_all", taken_out)
    answer = send(operator, location, 0, content if whole else content[:4000])
    assert answer.status_code == status, answer.text
    error_of(answer)
    assert admin.seen(f"/surveys/{survey_id}/recordings") == []


@pytest.mark.once
@pytest.mark.parametrize(
    ("headers", "status"),
    [
        ({"Tus-Resumable": "0.2"}, 412),
        ({"Upload-Length": ""}, 422),
        ({"Upload-Length": "-1"}, 422),
        ({"Upload-Length": "0"}, 422),
        ({"Upload-Length": "many"}, 422),
        ({"Upload-Metadata": ""}, 422),
        ({"Upload-Metadata": "filename %%%"}, 422),
    ],
)
def test_bad_announcements(operator: Client, survey_id: int, headers: dict[str, str], status: int) -> None:
    good = {**TUS, "Upload-Length": "5", "Upload-Metadata": "filename YS5tcDQ="}
    answer = operator.http.post(f"/api/surveys/{survey_id}/uploads", headers={**good, **headers})
    assert answer.status_code == status
    error_of(answer)


@pytest.mark.once
def test_bad_pieces(operator: Client, survey_id: int) -> None:
    location = announce(operator, survey_id, "a.mp4", 10).headers["Location"]
    too_much = send(operator, location, 0, b"x" * 11)
    assert too_much.status_code == 422
    assert "announced" in error_of(too_much)
    headers = {**TUS, "Upload-Offset": "0", "Content-Type": "video/mp4"}
    other = operator.http.patch(location, content=b"x", headers=headers)
    assert other.status_code == 415
    error_of(other)
    assert announce(operator, 999_999, "a.mp4", 10).status_code == 404


@pytest.mark.once
def test_names_are_only_names() -> None:
    assert clean_name("..\\..\\etc\\passwd.mp4") == "passwd.mp4"
    assert clean_name("/a/b/\x00c\n.mp4") == "c.mp4"
    assert clean_name("  ") == "recording"
    assert len(clean_name("x" * 5000 + ".mp4")) == 400
    assert suffix_of("a.MP4") == ".mp4"
    assert suffix_of("a.b/c") == ""
    assert suffix_of("a.waytoolongsuffix") == ""
