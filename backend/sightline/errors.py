"""The error tree: each class carries the HTTP status the API answers with.

SightlineError
  BadInput (422)            the caller's file or value is wrong; CLI exit status 2
  NotSignedIn (401)
  NotAllowed (403)
  NotFound (404)
  Conflict (409)            somebody else changed it first
  TooMany (429)
  Busy (503)                too many at once; the same request may be sent again
  NoRoom (507)              the disk is full
  Damaged (500)             stored data does not match its checksum or its chain
"""

import re

from sightline.messages import Value, say

#: of a text in a sentence; somebody's cell of a table may hold a megabyte
MOST_SIGNS = 900
# A line has no second line, and no sign turns the order of the others round.
_UNSEEN = re.compile(r"[\x00-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")


class SightlineError(Exception):
    """What is wrong and what to do about it: a key of the catalogue of messages and its sentence's values.

    Values that are neither numbers nor texts are kept as texts.
    """

    status = 500
    kind = "error"
    exit_status = 1

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.code = code
        self.values = {name: _plain(value) for name, value in values.items()}

    @property
    def message(self) -> str:
        """The sentence, in English."""
        return say(self.code, self.values)

    def __str__(self) -> str:
        return self.message


def _plain(value: object) -> Value:
    """What JSON and every language can hold; a truth is a text here, and a text has an end."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        return value
    text = _UNSEEN.sub("\N{REPLACEMENT CHARACTER}", str(value))
    return text if len(text) <= MOST_SIGNS else text[: MOST_SIGNS - 1] + "…"


class BadInput(SightlineError):
    status = 422
    kind = "bad_input"
    exit_status = 2


class NotSignedIn(SightlineError):
    status = 401
    kind = "not_signed_in"


class NotAllowed(SightlineError):
    status = 403
    kind = "not_allowed"


class NotFound(SightlineError):
    status = 404
    kind = "not_found"
    exit_status = 2


class Conflict(SightlineError):
    """`current`: what is there now, where the answer can carry it."""

    status = 409
    kind = "conflict"

    def __init__(self, code: str, *, current: object = None, **values: object) -> None:
        super().__init__(code, **values)
        self.current = current


class TooMany(SightlineError):
    """`retry_after_s`: when the same may be tried again, where that is known."""

    status = 429
    kind = "too_many"

    def __init__(self, code: str, *, retry_after_s: int | None = None, **values: object) -> None:
        super().__init__(code, **values)
        self.retry_after_s = retry_after_s


class Busy(SightlineError):
    status = 503
    kind = "busy"


class Away(SightlineError):
    """What the work rests on, the database or the storage, does not answer just now, and will again."""

    status = 503


class NoRoom(SightlineError):
    status = 507
    kind = "no_room"


class Damaged(SightlineError):
    status = 500
    kind = "damaged"
