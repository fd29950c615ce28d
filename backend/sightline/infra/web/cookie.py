"""The session cookie: signed, HttpOnly, SameSite=Strict; ended on the server by the person's session key."""

import threading
import time
from collections.abc import Callable

from cachetools import TTLCache
from fastapi import Request, Response
from itsdangerous import BadSignature, URLSafeTimedSerializer

from sightline.infra.web.person import Person

COOKIE = "sightline_session"
MAX_AGE_S = 14 * 24 * 3600
# How long another process may still believe what it read about a person; in this one, changes count at once.
BELIEVED_S = 2.0
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
        self._age = 0
        self._lock = threading.Lock()

    def person_of(self, request: Request) -> Person | None:
        """The active person whose cookie came with the request, None if there is none that holds."""
        content = self._content(request)
        if content is None:
            return None
        person = self._person(content[0])
        if person is None or not person.active or person.session_key != content[1]:
            return None
        return person

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
            person_id, session_key, by_link = self._signer.loads(cookie, max_age=MAX_AGE_S)
            return int(person_id), int(session_key), int(by_link)
        except (BadSignature, ValueError, TypeError):
            return None

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
