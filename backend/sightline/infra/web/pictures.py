"""Pictures that never change: sent once, and answered by their ETag afterwards.

A browser may keep them but asks each time: who signed out, or was taken out of the survey, is not shown what
the browser holds. What else is of a survey (packages, reports, photographs) it does not keep at all: the
guard's no-store.
"""

from collections.abc import Callable, Mapping
from typing import Any

from fastapi import Request, Response

CACHING = "private, no-cache"
_SAME = {"description": "The picture that the browser has is the right one."}
PHOTOGRAPH: dict[int | str, dict[str, Any]] = {200: {"content": {"image/jpeg": {}}}}
JPEG = {**PHOTOGRAPH, 304: _SAME}
PNG: dict[int | str, dict[str, Any]] = {200: {"content": {"image/png": {}}}, 304: _SAME}


def is_held(request: Request, etag: str) -> bool:
    """Whether the browser has this very picture already."""
    held = request.headers.get("if-none-match", "")
    return etag in (tag.strip().removeprefix("W/") for tag in held.split(","))


def answer_not_modified(etag: str) -> Response:
    """304: the picture that the browser has is the right one."""
    return Response(status_code=304, headers={"ETag": etag, "Cache-Control": CACHING})


def picture_response(
    content: bytes, media_type: str, etag: str, identity: Mapping[str, str] | None = None
) -> Response:
    """The picture, to be kept and asked for again; `identity` are headers that say which one it is."""
    headers = {"ETag": etag, "Cache-Control": CACHING, **(identity or {})}
    return Response(content, media_type=media_type, headers=headers)


def jpeg_once(request: Request, etag: str, make: Callable[[], bytes]) -> Response:
    """The JPEG, which is made only if the browser does not have it already."""
    return (
        answer_not_modified(etag) if is_held(request, etag) else picture_response(make(), "image/jpeg", etag)
    )
