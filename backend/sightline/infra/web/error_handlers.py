"""One error handler: whatever goes wrong is answered with a status and one sentence, never a traceback."""

import errno
import logging
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from pydantic_core import to_jsonable_python
from sqlalchemy.exc import DataError, OperationalError
from starlette.exceptions import HTTPException

from sightline.errors import NoRoom, SightlineError
from sightline.infra.database.engine import explanation

log = logging.getLogger(__name__)

FULL = NoRoom("The disk is full, so nothing was saved; make room and try again.")


def answer(
    status: int, code: str, message: str, headers: dict[str, str] | None = None, **more: Any
) -> JSONResponse:
    """The one shape of an error."""
    body = {"error": {"code": code, "message": message}, **more}
    return JSONResponse(body, status_code=status, headers=headers)


def known(_request: Request, error: Exception) -> JSONResponse:
    assert isinstance(error, SightlineError)
    current = getattr(error, "current", None)
    more = {} if current is None else {"current": to_jsonable_python(current)}
    return answer(error.status, error.code, error.message, **more)


def malformed(_request: Request, error: Exception) -> JSONResponse:
    assert isinstance(error, RequestValidationError)
    return answer(422, "bad_input", sentence_of(error))


def sentence_of(error: RequestValidationError) -> str:
    """The first complaint about a request, in words: which value, and what is wrong with it."""
    first = error.errors()[0] if error.errors() else {"loc": (), "msg": "the request cannot be read"}
    if first.get("type") == "json_invalid":
        return "The request's body is not valid JSON; send a JSON object."
    place, *names = [str(part) for part in first["loc"]] or ["request"]
    said = str(first["msg"]).removeprefix("Value error, ").rstrip(".")
    what = f'The value "{".".join(names)}" of the {place}' if names else f"The {place} of the request"
    return f"{what} cannot be used: {said[:1].lower()}{said[1:]}; correct it and send it again."


def plain_http(request: Request, error: Exception) -> JSONResponse:
    """Starlette's own refusals: unknown routes, wrong methods, bodies that cannot be read."""
    assert isinstance(error, HTTPException)
    sentences = {
        404: ("not_found", f"There is nothing at {request.url.path}; check the address."),
        405: (
            "bad_method",
            f"{request.method} is not possible at {request.url.path}; see /docs for what is.",
        ),
    }
    code, message = sentences.get(
        error.status_code, ("bad_request", f"{error.detail}; correct it and try again.")
    )
    return answer(error.status_code, code, message, dict(error.headers or {}))


def unexpected(request: Request, error: Exception) -> JSONResponse:
    """Anything else: logged whole for us, one sentence for the person in front."""
    if isinstance(error, OperationalError):
        said = explanation(error)
        return answer(said.status, said.code, said.message)
    if isinstance(error, DataError):
        # Out of a query string, a file name or an imported table: the bodies are checked before.
        return answer(
            422, "bad_input", "A value in the request cannot be stored; correct it and send it again."
        )
    if isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT):
        return answer(FULL.status, FULL.code, FULL.message)
    log.error("%s %s failed", request.method, request.url.path, exc_info=error)
    return answer(
        500, "error", "Something went wrong on the server and nothing was saved; the server's log says what."
    )


def install(app: FastAPI) -> None:
    """Register the handlers; one for each kind of failure, one shape for all."""
    app.add_exception_handler(SightlineError, known)
    app.add_exception_handler(RequestValidationError, malformed)
    app.add_exception_handler(HTTPException, plain_http)
    app.add_exception_handler(OperationalError, unexpected)
    app.add_exception_handler(DataError, unexpected)
    app.add_exception_handler(OSError, unexpected)
    app.add_exception_handler(Exception, unexpected)
