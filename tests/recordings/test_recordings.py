"""Ingest, the frame table and its pictures, and what goes wrong with videos."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from sqlalchemy import text

from sightline.errors import NoRoom
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.recovery import take_back
from sightline.infra.jobs.store import claim_job
from sightline.infra.services import Services
from sightline.media.video.writer import write_mp4
from sightline.recordings import ingest_job
from sightline.recordings import store as recordings_store
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.store import get_recording
from tests.media.clips import painted
from tests.support.app import FRAME_HEIGHT, FRAME_WIDTH, FRAMES, Client, error_of, number_of, upload

Work = Callable[[], list[Job]]


def test_facts_and_table(viewer: Client, recording_id: int) -> None:
    recording = viewer.seen(f"/recordings/{recording_id}")
    assert recording["state"] == "ready"
    assert (recording["width_px"], recording["height_px"]) == (FRAME_WIDTH, FRAME_HEIGHT)
    assert recording["frame_count"] == FRAMES
    assert recording["duration_s"] == pytest.approx(FRAMES / 25)
    assert recording["codec"] == "h264" and not recording["vfr"]
    assert recording["lighting"] is None and recording["lighting_proposed"] == "daytime"
    table = viewer.seen(f"/recordings/{recording_id}/frames")
    assert table["first"] == 0
    assert np.allclose(table["time_s"], np.arange(FRAMES) / 25)
    assert len(set(table["crc"])) == len(table["key"]) == len(table["pts"]) == FRAMES
    assert table["key"][0] is True
    piece = viewer.seen(f"/recordings/{recording_id}/frames?first=10&count=5")
    assert piece["pts"] == table["pts"][10:]
    assert viewer.seen(f"/recordings/{recording_id}/frames?first=500")["pts"] == []


def test_every_still_is_its_frame(viewer: Client, recording_id: int) -> None:
    table = viewer.seen(f"/recordings/{recording_id}/frames")
    for n in (7, 0, 11, 3, 4, 3):
        answer = viewer.get(f"/recordings/{recording_id}/frames/{n}.jpg?v={table['crc'][n]}")
        assert answer.status_code == 200
        assert number_of(answer.content) == n
        assert answer.headers["etag"] == f'"{table["crc"][n]:08x}"'
        assert answer.headers["cache-control"] == "private, no-cache"
        assert answer.headers["sightline-frame"] == str(n)
        assert answer.headers["sightline-pts"] == str(table["pts"][n])
        assert "content-encoding" not in answer.headers


def test_a_picture_that_the_browser_has_is_not_sent_again(viewer: Client, recording_id: int) -> None:
    path = f"/recordings/{recording_id}/frames/3.jpg"
    etag = viewer.get(path).headers["etag"]
    again = viewer.get(path, headers={"If-None-Match": f'"other", W/{etag}'})
    assert again.status_code == 304 and not again.content
    assert viewer.get(path, headers={"If-None-Match": '"other"'}).status_code == 200


def test_crops_are_lossless_and_of_the_size_asked_for(
    viewer: Client, recording_id: int, services: Services
) -> None:
    import cv2

    frame = services.frames.bgr(stills_of(services).open(recording_id).media, 5)
    path = f"/recordings/{recording_id}/frames/5/crop.png?x=300&y=-10&w=40&h=30"
    answer = viewer.get(path)
    crop = cv2.imdecode(np.frombuffer(answer.content, np.uint8), cv2.IMREAD_COLOR)
    assert crop.shape == (30, 40, 3)
    assert np.array_equal(crop[10:, :20], frame[0:20, 300:320])
    assert not crop[:10].any() and not crop[:, 20:].any()
    assert viewer.get(path, headers={"If-None-Match": answer.headers["etag"]}).status_code == 304
    for bad in ("x=0&y=0&w=0&h=5", "x=0&y=0&w=5", "x=a&y=0&w=5&h=5", "x=0&y=0&w=99999&h=5"):
        answer = viewer.get(f"/recordings/{recording_id}/frames/5/crop.png?{bad}")
        assert answer.status_code == 422
        error_of(answer)


def test_thumbnails(viewer: Client, recording_id: int) -> None:
    thumbs = viewer.seen(f"/recordings/{recording_id}")["thumbs"]
    assert thumbs[0]["frame"] == 0
    for thumb in thumbs[:3]:
        answer = viewer.http.get(thumb["url"])
        assert answer.status_code == 200 and answer.content[:2] == b"\xff\xd8"
        assert answer.headers["cache-control"] == "private, no-cache"
    assert viewer.get(f"/recordings/{recording_id}/thumbs/500.jpg").status_code == 404


def test_frames_that_are_not_there(viewer: Client, recording_id: int) -> None:
    for path in (f"/recordings/{recording_id}/frames/12.jpg", "/recordings/999/frames/0.jpg"):
        answer = viewer.get(path)
        assert answer.status_code == 404
        error_of(answer)
    assert "0 to 11" in error_of(viewer.get(f"/recordings/{recording_id}/frames/12.jpg"))
    assert viewer.get(f"/recordings/{recording_id}/frames/-1.jpg").status_code == 422


def test_a_file_that_changed_is_never_shown(
    viewer: Client, recording_id: int, services: Services, tmp_path: Path
) -> None:
    other = tmp_path / "other.mp4"
    pictures = (painted(n + 50, FRAME_WIDTH, FRAME_HEIGHT) for n in range(FRAMES))
    write_mp4(other, pictures, 25, crf=14, gop=6)
    opened = stills_of(services).open(recording_id)
    opened.media.path.write_bytes(other.read_bytes())
    answer = viewer.get(f"/recordings/{recording_id}/frames/4.jpg")
    assert answer.status_code == 500
    assert answer.json()["error"]["kind"] == "damaged"
    error_of(answer)


def test_a_still_costs_no_query(viewer: Client, recording_id: int, services: Services) -> None:
    from sqlalchemy import event

    viewer.get(f"/recordings/{recording_id}/frames/1.jpg")
    seen: list[str] = []

    def note(_connection: object, _cursor: object, statement: str, *_: object) -> None:
        seen.append(statement)

    event.listen(services.engine, "before_cursor_execute", note)
    assert viewer.get(f"/recordings/{recording_id}/frames/2.jpg").status_code == 200
    event.remove(services.engine, "before_cursor_execute", note)
    assert [one for one in seen if "SELECT" in one] == []


def test_changes(operator: Client, survey_id: int, recording_id: int) -> None:
    camera = operator.made(f"/surveys/{survey_id}/cameras", {"name": "Left"})
    path = f"/recordings/{recording_id}"
    changed = operator.put(path, {"camera_id": camera["id"], "lighting": "low_light"}).json()
    assert (changed["camera_id"], changed["lighting"], changed["name"]) == (
        camera["id"],
        "low_light",
        "road.mp4",
    )
    assert operator.put(path, {"lighting": None}).json()["lighting"] is None
    assert operator.put(path, {"name": " "}).status_code == 422
    assert operator.put(path, {"name": None}).status_code == 422
    assert operator.put(path, {"lighting": "dusk"}).status_code == 422
    other = operator.made("/surveys", {"name": "Elsewhere"})
    foreign = operator.made(f"/surveys/{other['id']}/cameras", {"name": "Right"})
    answer = operator.put(path, {"camera_id": foreign["id"]})
    assert answer.status_code == 422
    assert "another survey" in error_of(answer)


@pytest.mark.parametrize(
    "content", [b"this is no video\n" * 50, b"\x00" * 5000, b"#EXTM3U\nfile:///etc/passwd\n"]
)
def test_what_is_no_video_fails_with_a_sentence(
    operator: Client, survey_id: int, tmp_path: Path, work: Work, content: bytes
) -> None:
    path = tmp_path / "road.mp4"
    path.write_bytes(content)
    recording_id = upload(operator, survey_id, path)
    assert [job.state for job in work()] == ["failed"]
    recording = operator.seen(f"/recordings/{recording_id}")
    assert recording["state"] == "failed" and recording["frame_count"] is None
    assert (
        recording["error"]["message"].startswith("road.mp4")
        and recording["error"] == recording["job"]["error"]
    )
    answer = operator.get(f"/recordings/{recording_id}/frames/0.jpg")
    assert answer.status_code == 422
    error_of(answer)
    assert operator.delete(f"/recordings/{recording_id}").status_code == 204


def test_cancelling_a_waiting_ingest_and_trying_again(
    operator: Client, survey_id: int, clip: Path, work: Work
) -> None:
    recording_id = upload(operator, survey_id, clip)
    job = operator.seen(f"/recordings/{recording_id}")["job"]
    assert operator.post(f"/recordings/{recording_id}/ingest").status_code == 409
    assert operator.delete(f"/recordings/{recording_id}").status_code == 409
    assert operator.made(f"/jobs/{job['id']}/cancel")["state"] == "cancelled"
    recording = operator.seen(f"/recordings/{recording_id}")
    assert recording["state"] == "failed" and "cancelled" in recording["error"]["message"]
    assert operator.post(f"/jobs/{job['id']}/cancel").status_code == 409
    assert work() == []
    again = operator.made(f"/recordings/{recording_id}/ingest")
    assert again["state"] == "queued"
    assert [one.state for one in work()] == ["done"]
    assert operator.seen(f"/recordings/{recording_id}")["state"] == "ready"


def test_cancelling_in_the_middle_leaves_no_half_table(
    operator: Client,
    survey_id: int,
    clip: Path,
    services: Services,
    work: Work,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    recording_id = upload(operator, survey_id, clip)
    monkeypatch.setattr("sightline.infra.jobs.runner.Watch.is_over", lambda _watch: True)
    assert [job.state for job in work()] == ["cancelled"]
    with services.reading() as session:
        assert session.execute(text("SELECT count(*) FROM frames")).scalar_one() == 0
    recording = operator.seen(f"/recordings/{recording_id}")
    assert recording["state"] == "failed" and recording["error"] == ingest_job.STOPPED.body
    assert not list(services.scratch.iterdir())


def test_a_worker_killed_in_the_middle(
    operator: Client, survey_id: int, clip: Path, services: Services, work: Work
) -> None:
    """Its job is put back, the next worker does it all again, and the outcome is there once."""
    recording_id = upload(operator, survey_id, clip)
    job_id = operator.seen(f"/recordings/{recording_id}")["job"]["id"]
    with services.writing() as session:
        assert claim_job(session, job_id, worker="dead") is not None
    assert take_back(services.sessions, worker="dead") == 1
    assert [job.state for job in work()] == ["done"]
    with services.reading() as session:
        assert session.execute(text("SELECT count(*) FROM frames")).scalar_one() == FRAMES


def test_deleting_takes_files_along(
    operator: Client, recording_id: int, services: Services, work: Work
) -> None:
    media = services.settings.data_dir / "media"
    assert [path.suffix for path in media.rglob("*") if path.is_file()]
    assert operator.delete(f"/recordings/{recording_id}").status_code == 204
    assert [job.state for job in work()] == ["done"]
    assert [path for path in media.rglob("*") if path.is_file()] == []
    assert operator.get(f"/recordings/{recording_id}").status_code == 404


def test_a_stream_without_an_index_is_served_from_a_working_copy(
    operator: Client, survey_id: int, tmp_path: Path, work: Work, services: Services
) -> None:
    from tests.media.clips import Spec, write

    path = write(tmp_path / "road.ts", Spec("road.ts", container="mpegts", count=20))
    recording_id = upload(operator, survey_id, path)
    assert [job.state for job in work()] == ["done"]
    for n in (15, 2, 19):
        answer = operator.get(f"/recordings/{recording_id}/frames/{n}.jpg")
        assert number_of(answer.content) == n
    assert operator.delete(f"/recordings/{recording_id}").status_code == 204
    assert [job.state for job in work()] == ["done"] and not list(services.media.listing())


def test_a_reading_that_failed_behind_its_working_copy_leaves_none(
    operator: Client,
    survey_id: int,
    tmp_path: Path,
    work: Work,
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from tests.media.clips import Spec, write

    def full(*_: object) -> None:
        raise NoRoom("database-disk-full")

    monkeypatch.setattr(ingest_job, "_keep_thumbnails", full)
    recording_id = upload(operator, survey_id, write(tmp_path / "a.ts", Spec("a.ts", container="mpegts")))
    assert [job.state for job in work()] == ["failed"]
    assert any(".work" in key for key, _ in services.media.listing())
    assert operator.delete(f"/recordings/{recording_id}").status_code == 204
    assert [job.state for job in work()] == ["done"] and not list(services.media.listing())


def test_a_working_copy_on_which_was_clicked_stays_where_it_would_be_another(
    operator: Client,
    survey_id: int,
    tmp_path: Path,
    work: Work,
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Another version reads the same file otherwise: for the recording itself, or for its twin."""
    from tests.media.clips import Spec, write

    path = write(tmp_path / "road.ts", Spec("road.ts", container="mpegts", count=20))
    other = write(tmp_path / "other.ts", Spec("other.ts", container="mpegts", count=12))
    recording_id = upload(operator, survey_id, path)
    work()
    with services.reading() as session:
        key = get_recording(session, recording_id).report["working_copy"]
    before, read = services.media.local_path(key).read_bytes(), ingest_job.ingest
    monkeypatch.setattr(
        recordings_store, "is_held", lambda _session, _table, id_, *_ways: id_ == recording_id
    )
    monkeypatch.setattr(ingest_job, "ingest", lambda _path, *given, **named: read(other, *given, **named))
    assert operator.post(f"/recordings/{recording_id}/ingest").status_code == 202
    upload(operator, survey_id, path, "twin.ts")
    assert [job.state for job in work()] == ["failed", "failed"]
    assert services.media.local_path(key).read_bytes() == before


def test_the_video_is_handed_out_as_it_came(
    operator: Client, viewer: Client, nobody: Client, services: Services, recording_id: int, clip: Path
) -> None:
    operator.put(f"/recordings/{recording_id}", {"name": "Côte/nord, matin"})
    answer = viewer.get(f"/recordings/{recording_id}/video")
    assert (answer.status_code, answer.content) == (200, clip.read_bytes())
    assert answer.headers["content-disposition"].startswith("attachment; filename")
    assert "C%C3%B4te-nord%2C%20matin.mp4" in answer.headers["content-disposition"]
    some = viewer.get(f"/recordings/{recording_id}/video", headers={"Range": "bytes=4-7"})
    assert (some.status_code, some.content) == (206, clip.read_bytes()[4:8])
    assert nobody.get(f"/recordings/{recording_id}/video").status_code == 401
    with services.reading() as session:
        key = get_recording(session, recording_id).media_key
    services.media.delete(key)
    gone = viewer.get(f"/recordings/{recording_id}/video")
    assert gone.status_code == 404 and "backup" in error_of(gone)
