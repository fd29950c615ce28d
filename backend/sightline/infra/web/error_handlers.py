"""One error handler: whatever goes wrong is answered with a status and one sentence, never a traceback."""

import errno
import logging
from collections.abc import Mapping
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from pydantic import TypeAdapter
from sqlalchemy.exc import DatabaseError, DataError
from sqlalchemy.exc import TimeoutError as PoolTimeout
from starlette.exceptions import HTTPException

from sightline.errors import BadInput, Busy, Conflict, NoRoom, NotFound, SightlineError, TooMany
from sightline.infra.database.engine import explanation
from sightline.messages.said import Said

log = logging.getLogger(__name__)

RETRY_AFTER_S = 2
#: What is said of each kind of complaint of Pydantic; its values are those of the complaint.
_COMPLAINTS = {
    "extra_forbidden": "request-extra",
    "missing": "request-missing",
    "literal_error": "request-one-of",
    "finite_number": "request-finite",
    **dict.fromkeys(("bool_type", "bool_parsing"), "request-boolean"),
    **dict.fromkeys(
        ("date_type", "date_parsing", "date_from_datetime_parsing", "date_from_datetime_inexact"),
        "request-date",
    ),
    **dict.fromkeys(("datetime_type", "datetime_parsing", "datetime_from_date_parsing"), "request-datetime"),
    "timezone_aware": "request-time-zone",
    **dict.fromkeys(("int_type", "int_parsing", "int_from_float"), "request-integer"),
    **dict.fromkeys(("float_type", "float_parsing"), "request-number"),
    "string_type": "request-text",
    "list_type": "request-list",
    "dict_type": "request-object",
    "greater_than": "request-above",
    "greater_than_equal": "request-least",
    "less_than": "request-below",
    "less_than_equal": "request-most",
    "too_short": "request-list-short",
    "too_long": "request-list-long",
    "string_too_short": "request-text-short",
    "string_too_long": "request-text-long",
    "string_pattern_mismatch": "request-pattern",
    "nul": "request-nul",
    "said": "request-said",
}
FULL = NoRoom("database-disk-full")


class BadMethod(SightlineError):
    status = 405
    kind = "bad_method"


class BadRequest(SightlineError):
    """Any other refusal of the framework; its status is set by hand."""

    status = 400
    kind = "bad_request"


def answer(error: SightlineError, headers: dict[str, str] | None = None, **more: Any) -> JSONResponse:
    """The one shape of an error: its kind, its sentence's code and values, and the sentence in English."""
    body = {"kind": error.kind, **error.said.body}
    return JSONResponse({"error": body, **more}, status_code=error.status, headers=headers)


def answer_known_error(_request: Request, error: Exception) -> JSONResponse:
    assert isinstance(error, SightlineError)
    more = {}
    if isinstance(error, Conflict) and error.current is not None:
        # it goes out as an answer would: what no answer shows, no refusal shows
        kind = TypeAdapter[Any](type(error.current))
        more["current"] = kind.dump_python(error.current, mode="json")
    # whatever is away or busy may be asked again, and a program should know when
    after_s = RETRY_AFTER_S if error.status == 503 else None
    if isinstance(error, TooMany):
        after_s = error.retry_after_s
    headers = None if after_s is None else {"Retry-After": str(after_s)}
    return answer(error, headers, **more)


def answer_malformed_request(_request: Request, error: Exception) -> JSONResponse:
    assert isinstance(error, RequestValidationError)
    return answer(complaint_of(error))


def complaint_of(error: RequestValidationError) -> BadInput:
    """The first complaint about a request: which value, and what is wrong with it."""
    first = error.errors()[0] if error.errors() else {"loc": (), "msg": "the request cannot be read"}
    if first.get("type") == "json_invalid":
        return BadInput("request-no-json")
    place, *names = [str(part) for part in first["loc"]] or ["request"]
    said = _complaint(first)
    if not names:
        return BadInput("request-cannot-be-used", place=place, said=said)
    return BadInput("request-value-unusable", name=".".join(names), place=place, said=said)


def _complaint(error: Mapping[str, Any]) -> Said | str:
    """What Pydantic says of a value, by its kind; else in its own words."""
    if error.get("type") in _COMPLAINTS:
        values = dict(error.get("ctx", {}))
        if "expected" in values:
            values["expected"] = str(values["expected"]).replace(" or ", ", ")
        return Said(_COMPLAINTS[error["type"]], **values)
    said = str(error["msg"]).removeprefix("Value error, ").rstrip(".")
    return f"{said[:1].lower()}{said[1:]}"


def plain_http(request: Request, error: Exception) -> JSONResponse:
    """Starlette's own refusals: unknown routes, wrong methods, bodies that cannot be read."""
    assert isinstance(error, HTTPException)
    if _is_full(error.__cause__):
        return answer(FULL)  # a form is put on disk as it arrives; the body itself has no fault
    refused = {
        404: NotFound("request-nothing-there", path=request.url.path),
        405: BadMethod("request-bad-method", method=request.method, path=request.url.path),
    }.get(error.status_code)
    if refused is None:
        refused = BadRequest("request-refused", detail=error.detail)
        refused.status = error.status_code
    return answer(refused, dict(error.headers or {}))


def answer_unexpected_error(request: Request, error: Exception) -> JSONResponse:
    """Anything else: logged whole for us, one sentence for the person in front."""
    if isinstance(error, PoolTimeout):
        return answer_known_error(request, Busy("web-server-busy"))
    if isinstance(error, DatabaseError) and (said := explanation(error)) is not None:
        return answer_known_error(request, said)
    if isinstance(error, DataError):
        # Out of a query string, a file name or an imported table: the bodies are checked before.
        return answer(BadInput("request-value-not-storable"))
    if _is_full(error):
        return answer(FULL)
    log.error("%s %s failed", request.method, request.url.path, exc_info=error)
    return answer(SightlineError("server-something-went-wrong"))


def _is_full(error: BaseException | None) -> bool:
    return isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT)


def install(app: FastAPI) -> None:
    """Register the handlers; one for each kind of failure, one shape for all."""
    app.add_exception_handler(SightlineError, answer_known_error)
    app.add_exception_handler(RequestValidationError, answer_malformed_request)
    app.add_exception_handler(HTTPException, plain_http)
    app.add_exception_handler(DatabaseError, answer_unexpected_error)
    app.add_exception_handler(PoolTimeout, answer_unexpected_error)
    app.add_exception_handler(DataError, answer_unexpected_error)
    app.add_exception_handler(OSError, answer_unexpected_error)
    app.add_exception_handler(Exception, answer_unexpected_error)
