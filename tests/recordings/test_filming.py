"""When a recording was filmed: proposed from its file, confirmed by a person; and whether its camera fits."""

from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from sightline.errors import NoRoom
from sightline.infra.services import Services
from sightline.media.video.ingest import ingest
from sightline.media.video.stated import Stated
from sightline.recordings import ingest_job
from sightline.recordings.filming import FilmedWithin, misfits
from sightline.recordings.store import get_recording, recordings_of_content
from tests.media.clips import edited, short_clip
from tests.media.test_other_recorders import two_pictures
from tests.support.app import Client, run_jobs, upload

LENS = {"width_px": 1920, "height_px": 1080, "fx_px": 1400.0, "fy_px": 1400.0}
START = {"local": "2026-05-03T08:10:00", "time_zone": "Europe/Paris"}


def stated(path: Path, tmp_path: Path) -> Stated:
    return ingest(path, lambda _: None, lambda: False, tmp_path / "thumbs").stated


@pytest.mark.parametrize(
    ("name", "of_file", "begun"),
    [
        ("a.mp4", {"creation_time": "2026-05-03T06:10:00Z"}, datetime(2026, 5, 3, 6, 10, tzinfo=UTC)),
        (
            "b.mov",
            {"com.apple.quicktime.creationdate": "2026-05-03T08:10:05+0200"},
            datetime(2026, 5, 3, 6, 10, 5, tzinfo=UTC),
        ),
        ("c.mkv", {"creation_time": "2026-05-03T06:10:00Z"}, datetime(2026, 5, 3, 6, 10, tzinfo=UTC)),
        ("d.mp4", {}, None),
        ("e.mp4", {"creation_time": "1970-01-01T00:00:00Z"}, None),
        ("f.mkv", {"creation_time": "a Sunday"}, None),
    ],
)
def test_a_file_states_when_it_was_begun(
    tmp_path: Path, name: str, of_file: dict[str, str], begun: datetime | None
) -> None:
    assert stated(short_clip(tmp_path / name, of_file, {}), tmp_path).begun_at == begun


@pytest.mark.parametrize(("text", "focal"), [("26.00mm", 26.0), ("50", 50.0), ("0mm", None), ("wide", None)])
def test_a_file_states_its_focal_length(tmp_path: Path, text: str, focal: float | None) -> None:
    told = {"com.apple.quicktime.camera.focal_length.35mm_equivalent": text}
    assert stated(short_clip(tmp_path / "a.mov", told, {}), tmp_path).focal_35mm_mm == focal


def test_a_person_confirms_the_start(operator: Client, viewer: Client, recording_id: int) -> None:
    path = f"/recordings/{recording_id}"
    before = viewer.seen(path)
    assert (before["started_at"], before["time_zone"], before["started_local"]) == (None, None, None)
    assert viewer.put(path, json={"start": START}).status_code == 403
    made = operator.put(path, json={"start": START, "weather": " light rain ", "street_lighting": "off"})
    assert made.status_code == 200, made.text
    assert made.json()["started_local"] == "2026-05-03T08:10:00.000+02:00"
    assert made.json()["started_at"].startswith("2026-05-03T06:10:00")
    assert (made.json()["weather"], made.json()["street_lighting"]) == ("light rain", "off")
    fine = {"local": "2026-05-03T08:09:59.9996", "time_zone": START["time_zone"]}
    assert operator.put(path, json={"start": fine}).json()["started_local"] == made.json()["started_local"]
    taken_back = operator.put(path, json={"start": None, "weather": ""}).json()
    assert (taken_back["started_at"], taken_back["time_zone"], taken_back["weather"]) == (None, None, None)
    assert taken_back["street_lighting"] == "off"


def test_what_cannot_be_a_start_is_refused_in_one_sentence(operator: Client, recording_id: int) -> None:
    tomorrow = (datetime.now(UTC) + timedelta(days=1)).isoformat(timespec="seconds")[:19]
    for local, code in (
        (tomorrow, "recordings-start-in-future"),
        ("1896-01-25T10:00:00", "recordings-start-too-early"),
        ("2026-03-29T02:30:00", "local-time-skipped"),
        ("2025-10-26T02:30:00", "local-time-twice"),
    ):
        answer = operator.put(f"/recordings/{recording_id}", json={"start": {**START, "local": local}})
        assert answer.status_code == 422
        assert answer.json()["error"]["code"] == code, answer.text
    assert operator.seen(f"/recordings/{recording_id}")["started_at"] is None


def test_hours_past_midnight_are_of_the_night_that_begins_on_the_day() -> None:
    """22:00 to 06:00 of the 4th was its early morning and its late evening, halves of two nights."""
    night = FilmedWithin(date(2026, 5, 4), date(2026, 5, 4), 22, 6)
    hours = [f"2026-05-{day:02}T{hour:02}:30:00+02:00" for day in (3, 4, 5) for hour in range(24)]
    held = [one[8:13] for one in hours if night.holds(one)]
    assert held == ["04T22", "04T23", *(f"05T{hour:02}" for hour in range(6))]
    evening = FilmedWithin(date(2026, 5, 4), date(2026, 5, 4), 22)
    assert [one[8:13] for one in hours if evening.holds(one)] == ["04T22", "04T23"]
    any_night = FilmedWithin(hour_from=22, hour_to=6)
    assert sum(map(any_night.holds, hours)) == 24 and not any_night.holds("")


def test_a_pass_and_its_heights_have_their_time(operator: Client, recording_id: int) -> None:
    span = {"first_frame": 5, "last_frame": 9}
    made = operator.post(f"/recordings/{recording_id}/vehicles", json=span).json()
    assert made["filmed_at"] is None
    operator.put(f"/recordings/{recording_id}", json={"start": START})
    assert operator.seen(f"/vehicles/{made['id']}")["filmed_at"] == "2026-05-03T08:10:00.200+02:00"


@pytest.mark.parametrize(
    ("size", "focal", "lens", "said"),
    [
        ((1920, 1080), None, LENS, None),
        ((1280, 720), None, LENS, "1280 x 720"),
        ((1920, 1080), 27.5, LENS, None),
        ((1920, 1080), 52.0, LENS, "52 mm"),
        ((1920, 1080), 13.0, LENS, "13 mm"),
        ((None, None), 13.0, LENS, None),
        ((1920, 1080), 13.0, {"fx_px": 1400.0}, None),
    ],
)
def test_a_calibration_that_does_not_fit_is_warned_of(
    size: tuple[int | None, int | None], focal: float | None, lens: dict[str, Any], said: str | None
) -> None:
    found = misfits(size, focal, lens)
    assert (found == []) if said is None else (len(found) == 1 and said in str(found[0]))


def test_lamps_lit_along_a_road_without_any_are_questioned(
    operator: Client, survey_id: int, recording_id: int
) -> None:
    def said(lamps: str | None, lit: str | None) -> list[dict[str, Any]]:
        version = operator.seen(f"/surveys/{survey_id}")["version"]
        body = {"name": "Rouen", "version": version, "place": {"street_lamps": lamps}}
        assert operator.put(f"/surveys/{survey_id}", json=body).status_code == 200
        operator.put(f"/recordings/{recording_id}", json={"street_lighting": lit})
        (listed,) = operator.seen(f"/surveys/{survey_id}/recordings")
        assert listed["misfits"] == operator.seen(f"/recordings/{recording_id}")["misfits"]
        found: list[dict[str, Any]] = listed["misfits"]
        return found

    (sentence,) = said("none", "on")
    assert "states that the road has none" in sentence["message"]
    assert [said("present", "on"), said("none", "off"), said(None, "on")] == [[], [], []]


def read(operator: Client, services: Services, path: str) -> Any:
    """A recording once its file was read."""
    assert "done" in [job.state for job in run_jobs(services)]
    recording = operator.seen(path)
    assert recording["state"] == "ready", recording["error"]
    return recording


SLOW = {"com.android.capture.fps": "100"}


def test_a_filming_rate_is_asked_for_and_gives_the_times(
    operator: Client, viewer: Client, survey_id: int, services: Services, tmp_path: Path
) -> None:
    """Four pictures played at 25 a second, filmed at 100: 1/100 s apart once somebody has said so."""
    path = f"/recordings/{upload(operator, survey_id, short_clip(tmp_path / 'slow.mp4', SLOW, {}))}"
    before = read(operator, services, path)
    assert (before["clock_doubt"], before["filmed_hz"]) == ("slow_motion", None)
    assert before["duration_s"] == pytest.approx(4 / 25)
    assert viewer.put(f"{path}/filming-rate", json={"filmed_hz": 100}).status_code == 403
    assert operator.put(f"{path}/filming-rate", json={"filmed_hz": 0.5}).status_code == 422
    assert operator.put(f"{path}/filming-rate", json={"filmed_hz": 100}).status_code == 202
    after = read(operator, services, path)
    assert (after["clock_doubt"], after["filmed_hz"]) == (None, 100)
    assert after["duration_s"] == pytest.approx(4 / 100)
    assert "Filmed at 100 frames per second" in " ".join(note["message"] for note in after["notes"])
    table = operator.seen(f"{path}/frames?first=0&count=4")
    assert table["time_s"] == pytest.approx([0, 0.01, 0.02, 0.03], abs=1e-6)


def test_a_recording_of_several_edits_stays_as_it_was_when_a_rate_is_stated(
    operator: Client, survey_id: int, services: Services, tmp_path: Path
) -> None:
    """An earlier version read it, with times that ran on over the jump."""
    file = short_clip(tmp_path / "slow.mp4", SLOW, {})
    path = f"/recordings/{upload(operator, survey_id, file)}"
    before = read(operator, services, path)
    with services.reading() as session:
        stored = services.media.local_path(get_recording(session, before["id"]).media_key)
    stored.chmod(0o644)
    edited(file, stored, [(0.04, 0.0), (0.04, 0.12)])
    refused = operator.put(f"{path}/filming-rate", json={"filmed_hz": 100})
    assert refused.json()["error"]["code"] == "video-in-parts"
    after = operator.seen(path)
    assert (after["state"], after["filmed_hz"]) == ("ready", None)


def test_a_rate_that_nobody_has_to_state_is_refused(
    operator: Client, recording_id: int, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Before its video is fetched, which may lie far away."""
    fetched: list[str] = []
    monkeypatch.setattr(services.media, "local_path", fetched.append)
    answer = operator.put(f"/recordings/{recording_id}/filming-rate", json={"filmed_hz": 100})
    assert answer.json()["error"]["code"] == "recordings-times-are-filming" and not fetched


def test_another_picture_of_a_file_becomes_a_recording(
    operator: Client, survey_id: int, services: Services, tmp_path: Path
) -> None:
    file = two_pictures(tmp_path / "two.mp4", (5, 6), (True, True))
    path = f"/recordings/{upload(operator, survey_id, file)}"
    first = read(operator, services, path)
    assert (first["stream_number"], first["frame_count"], first["width_px"]) == (1, 5, 192)
    assert [(one["width_px"], one["off"]) for one in first["pictures"]] == [(192, False), (320, False)]
    made = operator.post(f"{path}/pictures/2")
    assert made.status_code == 201, made.text
    second = read(operator, services, f"/recordings/{made.json()['id']}")
    assert (second["stream_number"], second["frame_count"], second["width_px"]) == (2, 6, 320)
    assert second["name"] == f"{first['name']} (2)"
    still = operator.get(f"/recordings/{second['id']}/frames/5.jpg")
    assert still.status_code == 200
    assert cv2.imdecode(np.frombuffer(still.content, np.uint8), cv2.IMREAD_GRAYSCALE).shape == (240, 320)
    assert operator.get(second["thumbs"][0]["url"].removeprefix("/api")).status_code == 200
    assert operator.post(f"{path}/pictures/2").json()["error"]["code"] == "recordings-picture-is-there"
    with services.reading() as session:
        told = get_recording(session, first["id"])
        assert not recordings_of_content(session, told.sha256, 3)
    twin = upload(operator, survey_id, file, "twin.mp4")
    with services.reading() as session:  # not read yet: it may turn out to be any of the pictures
        assert recordings_of_content(session, told.sha256, 3)
    waiting = operator.seen(f"/recordings/{twin}")["job"]["id"]
    assert operator.post(f"/jobs/{waiting}/cancel").status_code == 200
    assert operator.delete(f"/recordings/{twin}").status_code == 204
    assert operator.post(f"{path}/pictures/3").json()["error"]["code"] == "video-no-such-stream"
    assert operator.delete(path).status_code == 204  # the file stays for the other
    run_jobs(services)
    assert operator.get(f"/recordings/{second['id']}/frames/0.jpg").status_code == 200


def test_what_a_failed_reading_of_one_of_several_pictures_left_goes_with_the_recording(
    operator: Client, survey_id: int, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object) -> None:
        raise NoRoom("database-disk-full")

    file = two_pictures(tmp_path / "two.mp4", (5, 6), (False, True))
    recording_id = upload(operator, survey_id, file)
    monkeypatch.setattr(ingest_job, "facts_of", broken)
    assert [job.state for job in run_jobs(services)] == ["failed"]
    assert any("thumbs-2" in key for key, _ in services.media.listing())
    assert operator.delete(f"/recordings/{recording_id}").status_code == 204
    assert [job.state for job in run_jobs(services)] == ["done"] and not list(services.media.listing())


def test_one_that_is_switched_off_is_not_to_be_had(
    operator: Client, survey_id: int, services: Services, tmp_path: Path
) -> None:
    file = two_pictures(tmp_path / "off.mp4", (5, 6), (False, True))
    path = f"/recordings/{upload(operator, survey_id, file)}"
    assert read(operator, services, path)["stream_number"] == 2
    assert operator.post(f"{path}/pictures/1").json()["error"]["code"] == "video-stream-is-off"
