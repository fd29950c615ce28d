"""The processes of docker-compose.yml run by hand: app without a worker, PostgreSQL, S3, a worker beside."""

import os
import socket
from collections.abc import Iterator
from pathlib import Path

import httpx2
import pytest

from sightline.media.images import read_image_bgr
from sightline.media.video.writer import write_mp4
from tests.browser.server import Server, start
from tests.media.clips import painted, read_number
from tests.real.client import Client

SERVER = os.environ.get("SIGHTLINE_TEST_DATABASE_URL", "")
pytestmark = [
    pytest.mark.dialect,
    pytest.mark.skipif(not SERVER, reason="SIGHTLINE_TEST_DATABASE_URL names no PostgreSQL"),
]


@pytest.fixture
def environment() -> Iterator[dict[str, str]]:
    """What the compose file sets, with a bucket on a local server of the S3 protocol."""
    import boto3
    from moto.server import ThreadedMotoServer

    storage = ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    storage.start()
    host, port = storage.get_host_and_port()
    endpoint = f"http://{host}:{port}"
    keys = {"AWS_ACCESS_KEY_ID": "key", "AWS_SECRET_ACCESS_KEY": "secret", "AWS_DEFAULT_REGION": "us-east-1"}
    session = boto3.Session("key", "secret", region_name="us-east-1")
    client = session.client("s3", endpoint_url=endpoint)
    client.create_bucket(Bucket="sightline")
    client.close()
    yield keys | {
        "SIGHTLINE_MEDIA_URL": f"s3://sightline?endpoint={endpoint}",
        "SIGHTLINE_SECRET": "thirty-two characters at the least",
        "SIGHTLINE_SIGNING_KEY": "5e" * 32,
        "SIGHTLINE_ADDRESS": "https://heights.example.org",
        "SIGHTLINE_WORKERS": "0",
    }
    storage.stop()


def test_app_and_worker_share_postgresql_and_storage(
    database_url: str, environment: dict[str, str], tmp_path: Path
) -> None:
    clip = tmp_path / "clip.mp4"
    write_mp4(clip, (painted(n) for n in range(40)), 25)
    shared = environment | {"SIGHTLINE_DATABASE_URL": database_url}
    running: list[Server] = []
    try:
        app = start("serve", tmp_path / "app", extra=shared)
        running.append(app)
        app.wait()
        client = Client(app.url)
        client.sign_in(app.sign_in_link())
        assert f"link): {environment['SIGHTLINE_ADDRESS']}/sign-in?token=" in app.log.read_text()
        survey = client.post("/surveys", name="Agency", site="", description="")
        recording = client.upload(survey["id"], clip)
        assert client.get(f"/recordings/{recording}")["state"] == "ingesting"
        # With one worker's folder empty and apart, all that lasts must pass through database and storage.
        running.append(start("worker", tmp_path / "worker", extra=shared | {"SIGHTLINE_WORKERS": "1"}))
        assert client.ready(recording)["frame_count"] == 40
        still: httpx2.Response = client.http.get(f"/api/recordings/{recording}/frames/17.jpg")
        assert still.status_code == 200, still.text
        assert read_number(read_image_bgr(still.content, "17.jpg")) == 17
        client.http.close()
        # what the compose file's health check of a worker looks at, from its start to its end
        alive = tmp_path / "worker" / f"worker-{socket.gethostname()}.alive"
        assert alive.is_file()
    finally:
        for one in reversed(running):
            one.stop()
    assert not alive.exists()
