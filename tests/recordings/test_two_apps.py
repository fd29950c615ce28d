"""Two app processes on one database: uploads go on at either, and what one deletes the other forgets."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from sightline.app import create_app
from sightline.infra.jobs.records import Job
from sightline.infra.services import BELIEVED_S, Services, open_services
from sightline.recordings.frames import stills
from sightline.recordings.ingest_job import remove_recording
from tests.support.app import TUS, Client, announce, send, upload

pytestmark = pytest.mark.dialect


@pytest.fixture
def elsewhere(services: Services, tmp_path: Path) -> Iterator[Services]:
    """Another machine's: of the data folder it shares the place of uploads and that of videos, no more."""
    ours = services.settings
    shared = {"uploads_dir": ours.uploads_dir, "media_url": ours.media_url}
    opened = open_services(ours.model_copy(update={"data_dir": tmp_path / "elsewhere", **shared}))
    yield opened
    opened.close()


def signed_in(app: FastAPI, like: Client) -> Client:
    return Client(TestClient(app, headers={"X-Sightline": "1"}, cookies=like.http.cookies))


def test_an_upload_goes_on_at_either(
    operator: Client, elsewhere: Services, survey_id: int, clip: Path
) -> None:
    both = [operator, signed_in(create_app(services=elsewhere), operator)]
    content = clip.read_bytes()
    location = announce(operator, survey_id, "a.mp4", len(content)).headers["Location"]
    step = len(content) // 5 + 1
    for n in range(5):
        at = both[n % 2].http.head(location, headers=TUS).headers["Upload-Offset"]
        assert int(at) == n * step
        answer = send(both[1 - n % 2], location, n * step, content[n * step : (n + 1) * step])
        assert answer.status_code == 204
    recording = int(answer.headers["Sightline-Recording"])
    for one in both:
        assert one.seen(f"/recordings/{recording}")["size_bytes"] == len(content)


def test_frames_of_what_another_deleted_go_within_two_seconds(
    operator: Client,
    services: Services,
    elsewhere: Services,
    survey_id: int,
    clip: Path,
    work: Callable[[], list[Job]],
) -> None:
    recording = upload(operator, survey_id, clip)
    work()
    now_s = [0.0]
    theirs = stills.Stills(elsewhere.sessions, elsewhere.media, elsewhere.frames, lambda: now_s[0])
    assert theirs.still(recording, 3).n == 3
    remove_recording(services, recording, actor=1)
    now_s[0] = BELIEVED_S - 0.01
    assert theirs.still(recording, 3).n == 3
    now_s[0] = BELIEVED_S
    with pytest.raises(stills.NotFound):
        theirs.still(recording, 3)
