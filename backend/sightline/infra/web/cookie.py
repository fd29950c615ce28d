"""The session cookie: signed, HttpOnly, SameSite=Strict; ended on the server by the person's session key."""

import threading
import time
from collections.abc import Callable
from datetime import UTC, datetime, timedelta

from cachetools import LRUCache, TTLCache
from fastapi import Request, Response
from itsdangerous import BadSignature, URLSafeTimedSerializer

from sightline.infra.services import BELIEVED_S
from sightline.infra.web.person import Person

COOKIE = "sightline_session"
MAX_AGE_S = 14 * 24 * 3600
MOST_PEOPLE = 4096

Lookup = Callable[[int], Person | None]


class SignIn:
    """Reads and writes the cookie. `lookup` finds a person by id, or None; `timer` tells seconds."""

    def __init__(
        self, secret: bytes, secure: bool, lookup: Lookup, timer: Callable[[], float] = time.monotonic
    ) -> None:
        self._signer = URLSafeTimedSerializer(secret, salt="sightline-session-1")
        self._secure = secure
        self._lookup = lookup
        self._known: TTLCache[int, Person] = TTLCache(MOST_PEOPLE, BELIEVED_S, timer)
        self._cookies: LRUCache[str, tuple[tuple[int, int, int], datetime]] = LRUCache(MOST_PEOPLE)
        self._age = 0
        self._lock = threading.Lock()

    def person_of(self, request: Request) -> Person | None:
        """The active person whose cookie came with the request, None if there is none that holds."""
        content = self._content(request)
        if content is None:
            return None
        person = self.person(content[0])
        return person if person is not None and person.session_key == content[1] else None

    def known_person_of(self, request: Request) -> Person | None:
        """`person_of` where the account was read within the last moments; None says nothing."""
        content = self._content(request)
        if content is None:
            return None
        with self._lock:
            person = self._known.get(content[0])
        return person if person is not None and person.active and person.session_key == content[1] else None

    def by_link(self, request: Request) -> bool:
        """Whether the person came by a one-time link, so that no current password is asked for."""
        content = self._content(request)
        return content is not None and bool(content[2])

    def _content(self, request: Request) -> tuple[int, int, int] | None:
        """Person, session key and by-link flag of a cookie that we signed."""
        cookie = request.cookies.get(COOKIE)
        if cookie is None:
            return None
        try:
            content, signed_at = self._signed(cookie)
        except (BadSignature, ValueError, TypeError):
            return None
        # a clock that was set back makes no cookie false: one of the last hour then is of the future
        return content if abs(datetime.now(UTC) - signed_at) <= timedelta(seconds=MAX_AGE_S) else None

    def _signed(self, cookie: str) -> tuple[tuple[int, int, int], datetime]:
        """What we signed, and when. One and the same text is looked at once: what is in it stays so."""
        with self._lock:
            known = self._cookies.get(cookie)
        if known is None:
            (person_id, session_key, by_link), at = self._signer.loads(cookie, return_timestamp=True)
            known = (int(person_id), int(session_key), int(by_link)), at
            with self._lock:
                self._cookies[cookie] = known
        return known

    def person(self, person_id: int) -> Person | None:
        """The person with this number, if the account is in use."""
        person = self._person(person_id)
        return person if person is not None and person.active else None

    def _person(self, person_id: int) -> Person | None:
        with self._lock:
            known, age = self._known.get(person_id), self._age
        if known is not None:
            return known
        person = self._lookup(person_id)
        if person is not None:
            with self._lock:
                # What was read before a change must not be believed after it.
                if age == self._age:
                    self._known[person_id] = person
        return person

    def forget(self) -> None:
        """Read people afresh; called after every change to an account."""
        with self._lock:
            self._known.clear()
            self._age += 1

    def remember(self, response: Response, person: Person, *, by_link: bool) -> None:
        """Put the person's cookie on the answer."""
        value = self._signer.dumps([person.id, person.session_key, int(by_link)])
        response.set_cookie(
            COOKIE,
            str(value),
            max_age=MAX_AGE_S,
            path="/",
            secure=self._secure,
            httponly=True,
            samesite="strict",
        )

    def end(self, response: Response) -> None:
        """Take the cookie away."""
        response.delete_cookie(COOKIE, path="/", secure=self._secure, httponly=True, samesite="strict")
