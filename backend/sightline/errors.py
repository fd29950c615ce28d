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
  Stopped                   long work that somebody asked to stop; no answer carries it
"""

from collections.abc import Mapping

from sightline.messages.said import Said


class SightlineError(Exception):
    """What is wrong and what to do about it: a key of the catalogue of messages and its sentence's values.

    Values that are neither numbers nor texts are kept as texts.
    """

    status = 500
    kind = "error"
    exit_status = 1

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.said = Said(code, **values)

    @property
    def code(self) -> str:
        return self.said.code

    @property
    def values(self) -> Mapping[str, object]:
        return self.said.document["values"]

    @property
    def message(self) -> str:
        """The sentence, in English."""
        return str(self.said)

    def __str__(self) -> str:
        return self.message


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


class Stopped(SightlineError):
    """Nobody wants the work any more: it ended before it was done, and nothing of it is kept."""

    kind = "cancelled"
