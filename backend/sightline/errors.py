"""The error tree: each class carries the HTTP status the API answers with.

SightlineError
  BadInput (422)            the caller's file or value is wrong; CLI exit status 2
  NotSignedIn (401)
  NotAllowed (403)
  NotFound (404)
  Conflict (409)            somebody else changed it first
  TooMany (429)
  NoRoom (507)              the disk is full
  Damaged (500)             stored data does not match its checksum or its chain
"""


class SightlineError(Exception):
    """One sentence that says what is wrong and what to do about it."""

    status = 500
    code = "error"
    exit_status = 1

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.message = message


class BadInput(SightlineError):
    status = 422
    code = "bad_input"
    exit_status = 2


class NotSignedIn(SightlineError):
    status = 401
    code = "not_signed_in"


class NotAllowed(SightlineError):
    status = 403
    code = "not_allowed"


class NotFound(SightlineError):
    status = 404
    code = "not_found"
    exit_status = 2


class Conflict(SightlineError):
    status = 409
    code = "conflict"


class TooMany(SightlineError):
    status = 429
    code = "too_many"


class NoRoom(SightlineError):
    status = 507
    code = "no_room"


class Damaged(SightlineError):
    status = 500
    code = "damaged"
