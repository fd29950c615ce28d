"""The request that is being worked on, where it bears an `Idempotency-Key`."""

import hmac
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar

from sightline.infra.database.types import now


class KeyedRequest:
    """One request with its key; `stored` once what it writes is committed."""

    def __init__(self, key: str, method: str, address: str, secret: bytes) -> None:
        self.key = key
        self.at = now()
        #: who asks, as soon as that is known; what nobody asks for is not known again
        self.person_id: int | None = None
        self.stored = False
        #: its answer holds a secret that is told once, and is kept nowhere
        self.told_once = False
        # with the server's secret, so that nobody finds by trying what a body said, a password say
        self._content = hmac.new(secret, f"{method} {address}\n".encode(), "sha256")

    def take(self, body: bytes) -> None:
        """Count the next piece of the body in."""
        self._content.update(body)

    @property
    def fingerprint(self) -> str:
        """What is the same of a repeat, and of nothing else: method, address and body."""
        return self._content.hexdigest()

    @contextmanager
    def current(self) -> Iterator[None]:
        """It is `keyed_request()` of everything that is called meanwhile."""
        with _working_on(self):
            yield


_current: ContextVar[KeyedRequest | None] = ContextVar("keyed_request", default=None)


def keyed_request() -> KeyedRequest | None:
    """The request that is being worked on; None where it bears no key, and outside of requests."""
    return _current.get()


def beside_request() -> AbstractContextManager[None]:
    """What is written meanwhile is not what the request asks for: its key is not stored with it."""
    return _working_on(None)


@contextmanager
def _working_on(request: KeyedRequest | None) -> Iterator[None]:
    token = _current.set(request)
    try:
        yield
    finally:
        _current.reset(token)
