"""Programs speaking for a person: `Authorization: Bearer` and a token with scopes, in place of the cookie."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, Protocol

from cachetools import TTLCache
from pydantic import Field
from starlette.datastructures import Headers

from sightline.enums import Scope
from sightline.errors import TooMany
from sightline.infra.database.types import now
from sightline.infra.limits.store import Limit
from sightline.infra.services import BELIEVED_S

#: What each token begins with, so that a search for secrets in files finds it.
BEGINS = "sightline_"
PER_TOKEN = Limit("requests with a token", 1200, 60)
# Counted in the database a block at a time: not each request writes, and the limit holds all the same.
BLOCK = 20
MOST_TOKENS = 4096


@dataclass(frozen=True, slots=True)
class ApiTokenFacts:
    """A token of a person's own: what it may do, and until when."""

    id: int
    name: str
    scopes: tuple[Scope, ...]
    created_at: datetime
    expires_at: datetime
    last_used_at: Annotated[
        datetime | None, Field(description="To the minute or so: not each request is noted.")
    ]


@dataclass(frozen=True, slots=True)
class ApiToken(ApiTokenFacts):
    """One with whose it is."""

    person_id: int


class TokenStore(Protocol):
    """The three questions, as the room of people answers them."""

    def token_by_text(self, text: str) -> ApiToken | None: ...

    def spend(self, token: ApiToken, requests: int) -> bool: ...

    def count_wrong(self, address: str) -> None: ...


def bearer_of(headers: Headers) -> str | None:
    """The token in a request's header; None where there is none (an empty one is one)."""
    kind, _, text = headers.get("authorization", "").partition(" ")
    return text.strip() if kind.lower() == "bearer" else None


class Bearers:
    """Whose token it is; believes for a moment what it read."""

    def __init__(self, store: TokenStore, timer: Callable[[], float] = time.monotonic) -> None:
        self._store = store
        self._known: TTLCache[str, ApiToken] = TTLCache(MOST_TOKENS, BELIEVED_S, timer)
        self._left: TTLCache[int, int] = TTLCache(MOST_TOKENS, PER_TOKEN.seconds, timer)
        self._age = 0
        self._lock = threading.Lock()

    def token_of(self, text: str, address: str, *, spending: bool = True) -> ApiToken | None:
        """The token that holds; not `spending` where the same request has asked before.

        Raises:
            TooMany: its requests within the minute are used up, or too many wrong ones came from the address.
        """
        with self._lock:
            token, age = self._known.get(text), self._age
        if token is None:
            token = self._store.token_by_text(text)
            if token is None:
                self._store.count_wrong(address)
                return None
            with self._lock:
                # What was read before a change must not be believed after it.
                if age == self._age:
                    self._known[text] = token
        if token.expires_at <= now():
            return None
        if spending:
            self._spend(token)
        return token

    def _spend(self, token: ApiToken) -> None:
        with self._lock:
            left = self._left.pop(token.id, 0)
            if left > 1:
                self._left[token.id] = left - 1
            if left:
                return
        if not self._store.spend(token, BLOCK):
            raise TooMany("web-token-requests-many", most=PER_TOKEN.most)
        with self._lock:
            self._left[token.id] = self._left.get(token.id, 0) + BLOCK - 1

    def forget(self) -> None:
        """Read tokens afresh; called after every change to one."""
        with self._lock:
            self._known.clear()
            self._age += 1
