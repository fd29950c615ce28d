"""A small HTTP client of the API for tests that drive a real server: sign-in, tus upload, jobs."""

import base64
import time
from pathlib import Path
from typing import Any

import httpx2

CHUNK_BYTES = 1 << 20


class Client:
    """Speaks to `base_url/api` as the browser does: session cookie and the X-Sightline header."""

    def __init__(self, base_url: str) -> None:
        self.http = httpx2.Client(base_url=base_url, headers={"X-Sightline": "1"}, timeout=60)

    def sign_in(self, link: str) -> None:
        self.post("/session/link", token=link.split("token=")[1])

    def get(self, path: str) -> Any:
        return self._checked(self.http.get("/api" + path))

    def post(self, path: str, **body: Any) -> Any:
        return self._checked(self.http.post("/api" + path, json=body))

    def put(self, path: str, **body: Any) -> Any:
        return self._checked(self.http.put("/api" + path, json=body))

    def upload(self, survey_id: int, file: Path) -> int:
        """The id of the recording made from `file`, sent in pieces by tus."""
        name = base64.b64encode(file.name.encode()).decode()
        head = {
            "Tus-Resumable": "1.0.0",
            "Upload-Length": str(file.stat().st_size),
            "Upload-Metadata": "filename " + name,
        }
        created = self.http.post(f"/api/surveys/{survey_id}/uploads", headers=head)
        assert created.status_code == 201, created.text
        location = created.headers["Location"]
        offset = 0
        with file.open("rb") as stream:
            while piece := stream.read(CHUNK_BYTES):
                answer = self.http.patch(
                    location,
                    content=piece,
                    headers={
                        "Tus-Resumable": "1.0.0",
                        "Upload-Offset": str(offset),
                        "Content-Type": "application/offset+octet-stream",
                    },
                )
                assert answer.status_code == 204, answer.text
                offset += len(piece)
                assert int(answer.headers["Upload-Offset"]) == offset
        return int(answer.headers["Sightline-Recording"])

    def finished(self, job_id: int, seconds: float = 120) -> dict[str, Any]:
        """The job once it is over; fails the test when it failed."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            job: dict[str, Any] = self.get(f"/jobs/{job_id}")
            if job["state"] == "done":
                return job
            assert job["state"] in ("queued", "running"), job
            time.sleep(0.1)
        raise AssertionError(f"job {job_id} did not finish: {job}")

    def ready(self, recording_id: int, seconds: float = 120) -> dict[str, Any]:
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            recording: dict[str, Any] = self.get(f"/recordings/{recording_id}")
            if recording["state"] == "ready":
                return recording
            assert recording["state"] == "ingesting", recording
            time.sleep(0.1)
        raise AssertionError("the recording was not ready in time")

    @staticmethod
    def _checked(answer: httpx2.Response) -> Any:
        assert answer.status_code < 300, f"{answer.request.method} {answer.url}: {answer.text}"
        return answer.json() if answer.content else None
