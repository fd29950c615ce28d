"""A server killed in the middle of an ingest: after the next start the recording is whole, and only one."""

import signal
from contextlib import closing
from fractions import Fraction
from pathlib import Path

import av

from tests.media.clips import painted
from tests.real.client import Client
from tests.support.waiting import until

from .server import start

ROUND, ROUNDS = 25, 40

#: Run by Python itself at its start: workers stay halfway through a file until they may go on.
STAYS_HALFWAY = """
import os, sys, time
if "worker" in sys.orig_argv:
    from sightline.media.cancelling import Watch
    look = Watch.look
    def look_and_stay(self, position):
        if position is None or position < self.size / 2:
            return look(self, position)
        self.next_s = 0.0
        look(self, position)
        while not os.path.exists(os.environ["MAY_GO_ON"]):
            time.sleep(0.05)
    Watch.look = look_and_stay
"""


def long_clip(path: Path) -> Path:
    """1000 frames, quickly: the packets of one second, 40 times over."""
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


def is_halfway(client: Client, recording: int) -> bool:
    job = client.get(f"/recordings/{recording}")["job"]
    assert job["state"] in ("queued", "running"), job
    return job["state"] == "running" and 0.4 < job["progress"] < 1


def test_an_ingest_outlives_kill_9(tmp_path: Path) -> None:
    clip = long_clip(tmp_path / "long.mp4")
    data, hook, may_go_on = tmp_path / "data", tmp_path / "hook", tmp_path / "may-go-on"
    hook.mkdir()
    (hook / "sitecustomize.py").write_text(STAYS_HALFWAY)
    extra = {"PYTHONPATH": str(hook), "MAY_GO_ON": str(may_go_on)}
    server = start("serve", data, extra=extra)
    client = Client(server.url)
    try:
        server.wait()
        client.sign_in(server.sign_in_link())
        survey = client.post("/surveys", name="Killed", site="", description="")["id"]
        recording = client.upload(survey, clip)
        until(lambda: is_halfway(client, recording), lambda: "the ingest did not begin")
        server.stop(signal.SIGKILL)

        server = start("serve", data, extra=extra)
        client.http.base_url = server.url
        server.wait()
        before = client.get(f"/recordings/{recording}")
        assert before["state"] == "ingesting" and before["frame_count"] is None, before  # nothing half
        may_go_on.touch()
        ready = client.ready(recording)
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
