"""`Idempotency-Key`: a request sent again with its key stores nothing again, and is answered as before.

A request with a key runs like any other; its key is stored with its first event (`trail`), and its answer
after it was sent. Only what is refused, as a repeat is by the key or by what the first one changed, is looked
for among what was stored before. So the first sending waits for nothing, and a repeat for one question.
"""

import logging
import re
import time
from collections.abc import Sequence
from datetime import timedelta

import anyio
from anyio.to_thread import run_sync
from fastapi import Depends, Response
from sqlalchemy.exc import SQLAlchemyError
from starlette.datastructures import Headers
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sightline.errors import BadInput, SightlineError
from sightline.infra.database.engine import ANSWERS
from sightline.infra.database.types import now
from sightline.infra.idempotency.request import KeyedRequest, keyed_request
from sightline.infra.idempotency.store import (
    Answered,
    Done,
    DoneBefore,
    done_with_key,
    forget_old_keys,
    keep_answers,
)
from sightline.infra.services import Services
from sightline.infra.web.error_handlers import answer
from sightline.infra.web.guard import SAFE_METHODS, UPLOADED

HEADER = "idempotency-key"
REPLAYED = "Idempotency-Replayed"
#: Larger answers are not kept: their repeat is told that it is done.
MOST_ANSWER_BYTES = 200_000
#: For so long an answer that is not there yet may be on its way into the database.
_ON_ITS_WAY = timedelta(seconds=30)
_LOOKS_S = (0.0, 0.05, 0.1, 0.2, 0.4, 0.8)
_FORGET_EVERY_S = 3600.0
_KEY = re.compile(r'"?([A-Za-z0-9_.:~-]{1,100})"?')
log = logging.getLogger(__name__)


async def tells_once() -> None:
    """Declares that an answer holds a secret, which is kept nowhere."""
    request = keyed_request()
    if request is not None:
        request.told_once = True


TOLD_ONCE = Depends(tells_once)


class Idempotency:
    """Around every route that stores something, where the request bears a key."""

    def __init__(self, app: ASGIApp, services: Services, secret: bytes) -> None:
        self.app, self._services, self._secret = app, services, secret
        self._unkept: list[Answered] = []
        self._keeping = False
        self._forgot_at_s = float("-inf")

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        given = _key_of(scope)
        if given is None:
            await self.app(scope, receive, send)
            return
        key = _KEY.fullmatch(given)
        if key is None:
            await answer(BadInput("request-key-malformed"))(scope, receive, send)
            return
        query = scope["query_string"].decode("latin-1")
        request = KeyedRequest(key[1], scope["method"], f"{scope['path']}?{query}", self._secret)
        answered = _Answer(send)
        with request.current():
            await self.app(scope, _taken(request, scope, receive), answered)
        if answered.refused:
            instead = await self._done_before(request, scope["method"], answered.status)
            await (answered.pass_on() if instead is None else instead(scope, receive, send))
        elif request.stored and request.person_id is not None and not request.told_once and answered.whole:
            await self._keep(Answered(request.person_id, request.key, answered.status, answered.json))

    async def _done_before(self, request: KeyedRequest, method: str, status: int) -> Response | None:
        """The answer of the first sending; None where this is it, or where it is not to be told."""
        gone = status == 404 and method == "DELETE"
        if request.person_id is None or (status in (401, 403, 404, 429) and not gone):
            return None
        done = await self._wait_for_answer(request.person_id, request.key)
        if done is None:
            return None
        if done.fingerprint != request.fingerprint:
            return answer(BadInput("request-key-of-another", key=request.key))
        headers = {REPLAYED: "true"}
        if done.status is None:
            return answer(DoneBefore("request-done-before"), headers)
        kind = None if done.answer is None else "application/json"
        return Response(done.answer, done.status, headers, media_type=kind)

    async def _wait_for_answer(self, person_id: int, key: str) -> Done | None:
        """Its answer is waited for where it is just being kept."""
        done = None
        for wait_s in _LOOKS_S:
            await anyio.sleep(wait_s)
            try:
                done = await run_sync(self._look, person_id, key)
            except (SightlineError, SQLAlchemyError) as error:
                log.warning("what was done with a key could not be looked up: %s", error)
                return None
            if done is None or done.status is not None or now() - done.at > _ON_ITS_WAY:
                break
        return done

    def _look(self, person_id: int, key: str) -> Done | None:
        with self._services.reading() as session:
            return done_with_key(session, person_id, key)

    async def _keep(self, one: Answered) -> None:
        """With those that come while others are being kept; the last to come need not wait for it."""
        self._unkept.append(one)
        if self._keeping:
            return
        self._keeping = True
        try:
            while self._unkept:
                some, self._unkept = self._unkept, []
                await run_sync(self._store, some)
        except (SightlineError, SQLAlchemyError) as error:
            # it is stored and answered; a repeat is told so without the answer
            log.warning("answers could not be kept: %s", error)
        finally:
            self._keeping = False

    def _store(self, some: Sequence[Answered]) -> None:
        with self._services.writing(ANSWERS, unsynced=True) as session:
            keep_answers(session, some)
            if time.monotonic() - self._forgot_at_s > _FORGET_EVERY_S:
                forget_old_keys(session)
                self._forgot_at_s = time.monotonic()


class _Answer:
    """An answer on its way: held back where it is a refusal, else seen as it goes out."""

    def __init__(self, send: Send) -> None:
        self._send = send
        self._held: list[Message] = []
        self._body = b""
        self._headers = Headers()
        self.status = 0

    @property
    def refused(self) -> bool:
        return self.status >= 400

    @property
    def whole(self) -> bool:
        """Whether status and JSON are all that there is of it."""
        kind = self._headers.get("content-type", "application/json" if self.status == 204 else "")
        more = {"location", "set-cookie", "content-disposition"}.intersection(self._headers)
        return kind == "application/json" and not more and len(self._body) <= MOST_ANSWER_BYTES

    @property
    def json(self) -> str | None:
        return self._body.decode() or None

    async def __call__(self, message: Message) -> None:
        if message["type"] == "http.response.start":
            self.status, self._headers = message["status"], Headers(raw=message["headers"])
        elif len(self._body) <= MOST_ANSWER_BYTES:
            self._body += message.get("body", b"")
        if self.refused:
            self._held.append(message)
        else:
            await self._send(message)

    async def pass_on(self) -> None:
        for message in self._held:
            await self._send(message)


def _key_of(scope: Scope) -> str | None:
    """The key of a request that may store something; an upload's piece says itself where it goes on."""
    if scope["type"] != "http" or scope["method"] in SAFE_METHODS or not scope["path"].startswith("/api/"):
        return None
    headers = Headers(scope=scope)
    return None if headers.get("content-type", "") == UPLOADED else headers.get(HEADER)


def _taken(request: KeyedRequest, scope: Scope, receive: Receive) -> Receive:
    """The same messages, counted into the request's fingerprint; not forms, whose parts are parted anew."""
    if Headers(scope=scope).get("content-type", "").startswith("multipart/"):
        return receive

    async def take() -> Message:
        message = await receive()
        request.take(message.get("body", b""))
        return message

    return take
