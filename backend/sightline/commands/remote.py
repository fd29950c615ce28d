"""A running Sightline, spoken to over HTTP with a token: questions, writes, and files by resumable upload."""

from __future__ import annotations

import base64
import json
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self
from urllib.parse import urlsplit

from sightline.errors import BadInput, Busy, NotAllowed, NotFound, NotSignedIn, SightlineError, TooMany

if TYPE_CHECKING:
    from urllib3 import BaseHTTPResponse

PIECE_BYTES = 8 * 1024**2
#: So long a server may be away, or too busy, before an upload is given up (it goes on with the next command).
PATIENCE_S = 120.0
_RETRY_S = 2.0
_TUS = {"Tus-Resumable": "1.0.0"}
_ERRORS: Mapping[int, type[SightlineError]] = {
    401: NotSignedIn,
    403: NotAllowed,
    404: NotFound,
    422: BadInput,
    429: TooMany,
    503: Busy,
}

Sent = Callable[[int], None]


class Away(SightlineError):
    """No answer."""

    kind = "away"


class Remote:
    """One server, as one token may use it."""

    def __init__(self, url: str, token: str) -> None:
        from urllib3 import PoolManager, Timeout

        parts = urlsplit(url)
        if parts.scheme not in ("http", "https") or not parts.netloc:
            raise BadInput("import-no-address", url=url)
        self.url = url.rstrip("/")
        self._headers = {"Authorization": f"Bearer {token}"}
        # The answer to a video's last byte comes when the whole file was read once more and stored.
        self._pool = PoolManager(timeout=Timeout(connect=10, read=900), retries=False)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self._pool.clear()

    def ask(self, path: str) -> Any:
        """What a GET answers."""
        return self._send("GET", path).json()

    def write(self, path: str, body: Any = None) -> Any:
        """What a POST answers."""
        headers = {"Content-Type": "application/json"}
        return self._send("POST", path, headers, json.dumps(body).encode()).json()

    def upload(self, survey_id: int, video: Path, sent: Sent) -> int:
        """Send a video from where it broke off; the number of its recording. `sent` hears of bytes there.

        Raises Away or Busy where the server does not come back for `PATIENCE_S`.
        """
        path = self._begun(survey_id, video) or self._begin(survey_id, video)
        patient_until = time.monotonic() + PATIENCE_S
        while True:
            try:
                offset = int(self._send("HEAD", path, _TUS).headers["Upload-Offset"])
                while True:
                    sent(offset)
                    answer = self._piece(path, video, offset)
                    offset = int(answer.headers["Upload-Offset"])
                    patient_until = time.monotonic() + PATIENCE_S
                    if "Sightline-Recording" in answer.headers:
                        return int(answer.headers["Sightline-Recording"])
            except (Away, Busy, TooMany):
                if time.monotonic() > patient_until:
                    raise
                time.sleep(_RETRY_S)

    def _begun(self, survey_id: int, video: Path) -> str | None:
        """Where one's own upload of this file can go on."""
        wanted = True, "video", video.name, video.stat().st_size
        for one in self.ask(f"/surveys/{survey_id}/uploads"):
            if (one["mine"], one["purpose"], one["filename"], one["size_bytes"]) == wanted:
                return f"/uploads/{one['id']}"
        return None

    def _begin(self, survey_id: int, video: Path) -> str:
        named = "filename " + base64.b64encode(video.name.encode()).decode()
        sizes = {"Upload-Length": str(video.stat().st_size), "Upload-Metadata": named}
        answer = self._send("POST", f"/surveys/{survey_id}/uploads", {**_TUS, **sizes})
        return str(answer.headers["Location"]).removeprefix("/api")

    def _piece(self, path: str, video: Path, offset: int) -> BaseHTTPResponse:
        with video.open("rb") as file:
            file.seek(offset)
            piece = file.read(PIECE_BYTES)
        headers = {"Upload-Offset": str(offset), "Content-Type": "application/offset+octet-stream"}
        return self._send("PATCH", path, {**_TUS, **headers}, piece)

    def _send(
        self, method: str, path: str, headers: Mapping[str, str] | None = None, body: bytes | None = None
    ) -> BaseHTTPResponse:
        from urllib3.exceptions import HTTPError

        try:
            address, sent = f"{self.url}/api{path}", {**self._headers, **(headers or {})}
            answer = self._pool.request(method, address, body=body, headers=sent)
        except HTTPError as error:
            raise Away("import-no-answer", url=self.url) from error
        if answer.status >= 400:
            raise _error_of(answer, self.url)
        return answer


def _error_of(answer: BaseHTTPResponse, url: str) -> SightlineError:
    """What the server said, as it said it; it may be another version, with other sentences."""
    kind = _ERRORS.get(answer.status, Away if answer.status >= 500 else BadInput)
    try:
        sentence = str(answer.json()["error"]["message"]).rstrip(".")
    except (ValueError, KeyError, TypeError):
        return kind("import-no-sightline", url=url, status=answer.status)
    return kind("import-server-said", sentence=sentence)
