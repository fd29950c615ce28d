"""A server killed in the middle of an ingest: after the next start the recording is whole, and only one."""

import signal
import time
from contextlib import closing
from fractions import Fraction
from pathlib import Path

import av

from tests.media.clips import painted
from tests.real.client import Client

from .server import start

ROUND, ROUNDS = 25, 200


def long_clip(path: Path) -> Path:
    """5000 frames, quickly: the packets of one second, 200 times over."""
    rate = Fraction(25)
    with closing(av.open(str(path), "w")) as out:
        stream = out.add_stream("libx264", rate=rate)
        stream.width, stream.height, stream.pix_fmt, stream.gop_size = 640, 480, "yuv420p", ROUND
        stream.time_base = 1 / rate
        stream.options = {"preset": "veryfast", "x264-params": "bframes=0:scenecut=0"}
        pictures = (av.VideoFrame.from_ndarray(painted(n, 640, 480), format="bgr24") for n in range(ROUND))
        encoded = [bytes(packet) for picture in pictures for packet in stream.encode(picture)]
        encoded += [bytes(packet) for packet in stream.encode(None)]
        assert len(encoded) == ROUND
        for n in range(ROUND * ROUNDS):
            packet = av.Packet(encoded[n % ROUND])
            packet.stream, packet.time_base = stream, 1 / rate
            packet.pts = packet.dts = n
            packet.duration = 1
            packet.is_keyframe = n % ROUND == 0
            out.mux(packet)
    return path


def wait_until_halfway(client: Client, recording: int) -> float:
    until = time.monotonic() + 30
    while time.monotonic() < until:
        job = client.get(f"/recordings/{recording}")["job"]
        if job["state"] == "running" and job["progress"] > 0.05:
            return float(job["progress"])
        assert job["state"] in ("queued", "running"), job
        time.sleep(0.02)
    raise AssertionError("the ingest did not begin")


def test_an_ingest_outlives_kill_9(tmp_path: Path) -> None:
    clip = long_clip(tmp_path / "long.mp4")
    data = tmp_path / "data"
    server = start("serve", data)
    client = Client(server.url)
    try:
        server.wait()
        client.sign_in(server.sign_in_link())
        survey = client.post("/surveys", name="Killed", site="", description="")["id"]
        recording = client.upload(survey, clip)
        progress = wait_until_halfway(client, recording)
        server.stop(signal.SIGKILL)
        assert progress < 1

        server = start("serve", data, port=int(server.url.rsplit(":", 1)[1]))
        server.wait()
        before = client.get(f"/recordings/{recording}")
        assert before["state"] == "ingesting" and before["frame_count"] is None, before  # nothing half
        ready = client.ready(recording, seconds=90)
        check_whole(client, survey, ready)
        left = [path for path in (data / "scratch").rglob("*") if path.suffix != ".lock"]
        assert [path for path in left if path.is_file()] == []
        assert client.post("/audit/verify")["ok"]
    finally:
        client.http.close()
        server.stop()


def check_whole(client: Client, survey: int, recording: dict[str, object]) -> None:
    """Every frame is there once, in order, and the last one can be seen."""
    count = ROUND * ROUNDS
    assert recording["frame_count"] == count and recording["error"] is None and recording["notes"] == []
    table: list[int] = []
    while len(table) < count:
        part = client.get(f"/recordings/{recording['id']}/frames?first={len(table)}&count=5000")
        assert part["first"] == len(table) and part["pts"]
        table += part["crc"]
    assert len(table) == count
    assert table[:ROUND] == table[-ROUND:] and len(set(table)) == ROUND
    last = client.http.get(f"/api/recordings/{recording['id']}/frames/{count - 1}.jpg?v={table[-1]}")
    assert last.status_code == 200 and last.headers["Sightline-Frame"] == str(count - 1)
    assert [r["id"] for r in client.get(f"/surveys/{survey}/recordings")] == [recording["id"]]
    assert client.get(f"/surveys/{survey}/uploads") == []
    jobs = client.get(f"/jobs?survey_id={survey}")
    assert [(job["kind"], job["state"]) for job in jobs] == [("ingest", "done")]
