"""A running Sightline, spoken to over HTTP with a token: questions, writes, and files by resumable upload."""

from __future__ import annotations

import base64
import json
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from operator import attrgetter
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self
from urllib.parse import urlsplit

from sightline.enums import UploadPurpose
from sightline.errors import Away, BadInput, Busy, NotAllowed, NotFound, NotSignedIn, SightlineError, TooMany

if TYPE_CHECKING:
    from urllib3 import BaseHTTPResponse

PIECE_BYTES = 8 * 1024**2
_CONNECT_S, _ANSWER_S = 10.0, 60.0
#: The answer to a file's last byte comes when the whole file was read once more and stored.
_STORED_S = 900.0
#: So long a server may be away, or too busy, before an upload is given up (it goes on with the next command).
PATIENCE_S = 120.0
_RETRY_S = 2.0
_TUS = {"Tus-Resumable": "1.0.0"}
_JSON = "application/json"
_ERRORS: Mapping[int, type[SightlineError]] = {
    401: NotSignedIn,
    403: NotAllowed,
    404: NotFound,
    422: BadInput,
    429: TooMany,
    503: Busy,
}

Sent = Callable[[int], None]


class Remote:
    """One server, as one token may use it."""

    def __init__(self, url: str, token: str) -> None:
        from urllib3 import PoolManager

        parts = urlsplit(url)
        if parts.scheme not in ("http", "https") or not parts.netloc:
            raise BadInput("import-no-address", url=url)
        self.url = url.rstrip("/")
        self._headers = {"Authorization": f"Bearer {token}"}
        # a stream's vehicles go beside its strips
        self._pool = PoolManager(retries=False, maxsize=2)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self._pool.clear()

    def ask(self, path: str) -> Any:
        """What a GET answers."""
        return self._send("GET", path).json()

    def write(self, path: str, body: Any = None) -> Any:
        """What a POST answers, None where that is nothing; sayings go in their stored form."""
        headers = {"Content-Type": "application/json"}
        sent = json.dumps(body, default=attrgetter("document")).encode()
        answer = self._send("POST", path, headers, sent)
        return answer.json() if answer.data else None

    def survey_id(self, wanted: str) -> int:
        """The survey of this name, or else number. Raises BadInput."""
        surveys = self.ask("/surveys")
        named = [one for one in surveys if one["name"].casefold() == wanted.strip().casefold()]
        named = named or [one for one in surveys if str(one["id"]) == wanted.strip()]
        if len(named) > 1:
            numbers = ", ".join(str(one["id"]) for one in named)
            raise BadInput("import-survey-name-twice", survey=wanted, numbers=numbers)
        if not named:
            names = ", ".join(one["name"] for one in surveys) or "-"
            raise BadInput("import-no-such-survey", survey=wanted, names=names)
        return int(named[0]["id"])

    def require_upload(self, survey_id: int) -> None:
        """Raises NotAllowed where no file may be sent to a survey."""
        with suppress(BadInput):  # one without a length is announced by nobody
            self._send("POST", f"/surveys/{survey_id}/uploads", _TUS)

    def upload(
        self, survey_id: int, file: Path, sent: Sent | None = None, purpose: UploadPurpose = "video"
    ) -> int | None:
        """Send a file from where it broke off; the number of its recording, None of a strip. `sent` hears of
        bytes there.

        Raises Away or Busy where the server does not come back for `PATIENCE_S`.
        """
        path = self.begun(survey_id, file, purpose) or self._begin(survey_id, file, purpose)
        size, patient_until = file.stat().st_size, time.monotonic() + PATIENCE_S
        while True:
            try:
                there = self._send("HEAD", path, _TUS).headers
                if "Sightline-Finished" in there:
                    recording_id = there.get("Sightline-Recording")
                    return None if recording_id is None else int(recording_id)
                offset, is_first = int(there["Upload-Offset"]), True
                while offset < size or is_first:
                    if sent is not None:
                        sent(offset)
                    offset, is_first = int(self._piece(path, file, offset).headers["Upload-Offset"]), False
                    patient_until = time.monotonic() + PATIENCE_S
            except (Away, Busy, TooMany):
                if time.monotonic() > patient_until:
                    raise
                time.sleep(_RETRY_S)

    def begun(self, survey_id: int, file: Path, purpose: UploadPurpose = "video") -> str | None:
        """Where one's own upload of this file can go on."""
        wanted = True, purpose, file.name, file.stat().st_size
        for one in self.ask(f"/surveys/{survey_id}/uploads"):
            if (one["mine"], one["purpose"], one["filename"], one["size_bytes"]) == wanted:
                return f"/uploads/{one['id']}"
        return None

    def give_up(self, path: str) -> None:
        """Have the server forget an upload that became nothing."""
        self._send("DELETE", path, _TUS)

    def _begin(self, survey_id: int, file: Path, purpose: UploadPurpose) -> str:
        named = {"filename": file.name, "purpose": purpose}
        metadata = ",".join(f"{key} {base64.b64encode(one.encode()).decode()}" for key, one in named.items())
        sizes = {"Upload-Length": str(file.stat().st_size), "Upload-Metadata": metadata}
        answer = self._send("POST", f"/surveys/{survey_id}/uploads", {**_TUS, **sizes})
        return str(answer.headers["Location"]).removeprefix("/api")

    def _piece(self, path: str, file: Path, offset: int) -> BaseHTTPResponse:
        with file.open("rb") as opened:
            opened.seek(offset)
            piece = opened.read(PIECE_BYTES)
        headers = {"Upload-Offset": str(offset), "Content-Type": "application/offset+octet-stream"}
        return self._send("PATCH", path, {**_TUS, **headers}, piece, _STORED_S)

    def _send(
        self,
        method: str,
        path: str,
        headers: Mapping[str, str] | None = None,
        body: bytes | None = None,
        answer_s: float = _ANSWER_S,
    ) -> BaseHTTPResponse:
        from urllib3 import Timeout
        from urllib3.exceptions import HTTPError

        try:
            address, sent = f"{self.url}/api{path}", {**self._headers, **(headers or {})}
            timeout = Timeout(connect=_CONNECT_S, read=answer_s)
            answer = self._pool.request(method, address, body=body, headers=sent, timeout=timeout)
        except HTTPError as error:
            raise Away("import-no-answer", url=self.url) from error
        kind = answer.headers.get("Content-Type", _JSON)
        if answer.status >= 300 or not kind.startswith(_JSON):
            raise _error_of(answer, self.url)
        return answer


def _error_of(answer: BaseHTTPResponse, url: str) -> SightlineError:
    """What the server said, as it said it; it may be another version, with other sentences. What something
    on the way to it says, as a proxy or the page of a network to sign in to, is no word of Sightline's.
    """
    try:
        sentence = str(answer.json()["error"]["message"]).rstrip(".")
    except (ValueError, KeyError, TypeError):
        return Away("import-no-sightline", url=url, status=answer.status)
    kind = _ERRORS.get(answer.status, Away if answer.status >= 500 else BadInput)
    return kind("import-server-said", sentence=sentence)
