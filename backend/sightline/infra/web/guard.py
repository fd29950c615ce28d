"""In front of every route: requests from other sites and forms of strangers are refused, answers carry
security headers.
"""

import re
from collections.abc import Collection
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sightline.errors import NotAllowed, SightlineError
from sightline.infra.web.bearer import bearer_of
from sightline.infra.web.deps import asking
from sightline.infra.web.error_handlers import answer, answer_known_error

SAFE_METHODS = {"GET", "HEAD", "OPTIONS"}
HEADER = "x-sightline"
UPLOADED = "application/offset+octet-stream"
MOST_JSON_BYTES = 2_000_000
MOST_FORM_BYTES = 72_000_000
TOO_LARGE = "The request is too large"

# 'unsafe-inline' for styles only: Swagger's pages and Preact's style attributes need it, scripts never do.
POLICY = "; ".join(
    (
        "default-src 'self'",
        "script-src 'self'",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' blob: data:",
        "connect-src 'self'",
        "font-src 'self'",
        "worker-src 'self' blob:",
        "object-src 'none'",
        "base-uri 'none'",
        "form-action 'self'",
        "frame-ancestors 'none'",
    )
)
SECURITY_HEADERS = {
    "Content-Security-Policy": POLICY,
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), microphone=(), geolocation=()",
}


class CrossSite(NotAllowed):
    kind = "cross_site"


def cross_site_refusal(headers: Headers) -> CrossSite | None:
    """Why an unsafe request may come from another site; None when it does not.

    A page of another site cannot set our header without a preflight that we never grant; browsers that say
    where the request comes from are believed too (OWASP, cross-site request forgery prevention cheat sheet:
    custom request headers, fetch metadata). A token is sent by no browser of its own accord, and beside one
    the cookie counts for nothing.
    """
    if bearer_of(headers) is not None:
        return None
    if headers.get(HEADER) != "1":
        return CrossSite("request-needs-header", header="X-Sightline: 1")
    if headers.get("sec-fetch-site", "same-origin") not in ("same-origin", "none"):
        return CrossSite("request-from-another-site")
    origin = headers.get("origin")
    if origin is not None and urlsplit(origin).netloc.lower() != headers.get("host", "").lower():
        return CrossSite("request-from-another-site")
    return None


#: A method, and the paths on which it takes a form.
FormRoute = tuple[str, re.Pattern[str]]


def most_bytes(kind: str, method: str, path: str, forms: Collection[FormRoute]) -> int | None:
    """How large a body of this kind may be; None where the route counts by itself (an upload's pieces).

    A form to any other route than those that take one would be read whole into memory, like JSON.
    """
    if kind == UPLOADED and path.startswith("/api/uploads/"):
        return None
    form = kind == "multipart/form-data" and takes_form(method, path, forms)
    return MOST_FORM_BYTES if form else MOST_JSON_BYTES


def takes_form(method: str, path: str, forms: Collection[FormRoute]) -> bool:
    """Whether the route reads a form."""
    return any(method == its and pattern.match(path) for its, pattern in forms)


def limit_received_bytes(receive: Receive, most: int) -> Receive:
    """The same messages, until more than `most` bytes have come: bodies need not say their length."""
    taken = 0

    async def receive_counted() -> Message:
        nonlocal taken
        message = await receive()
        taken += len(message.get("body", b""))
        if taken > most:
            raise HTTPException(413, TOO_LARGE)
        return message

    return receive_counted


class Guard:
    """Refuses cross-site writes and huge bodies before anything reads them; adds security headers."""

    def __init__(self, app: ASGIApp, forms: Collection[FormRoute]) -> None:
        self.app, self._forms = app, forms

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in SECURITY_HEADERS.items():
                    headers.setdefault(name, value)
                if scope["path"].startswith("/api/"):
                    headers.setdefault("Cache-Control", "no-store")
            await send(message)

        if scope["method"] not in SAFE_METHODS and scope["path"].startswith("/api"):
            headers = Headers(scope=scope)
            refusal = cross_site_refusal(headers)
            if refusal is not None:
                await answer(refusal)(scope, receive, send_with_headers)
                return
            kind = headers.get("content-type", "").partition(";")[0].strip().lower()
            most = most_bytes(kind, scope["method"], scope["path"], self._forms)
            if most is not None:
                receive = limit_received_bytes(receive, most)
        await self.app(scope, receive, send_with_headers)


class SignedInFirst:
    """Asks who it is before a form is read: the framework puts it on disk whole and asks only then."""

    def __init__(self, app: ASGIApp, forms: Collection[FormRoute]) -> None:
        self.app, self._forms = app, forms

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "http" and takes_form(scope["method"], scope["path"], self._forms):
            request = Request(scope)
            try:
                await asking(request)
            except SightlineError as error:
                await answer_known_error(request, error)(scope, receive, send)
                return
        await self.app(scope, receive, send)
