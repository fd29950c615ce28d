"""The built front end: its pages, its hashed assets, and the API's pages without any foreign address."""

import mimetypes
import re
from pathlib import Path

from fastapi import APIRouter, FastAPI, Request
from fastapi.responses import FileResponse, HTMLResponse, Response
from starlette.exceptions import HTTPException

# the addresses of frontend/src/core/places.ts
FRONT_END_ROUTE = re.compile(
    r"^(sign-in|account|guide|people|audit|jobs|system|catalogue|statistics|sight-distance|studies|study"
    r"|surveys/\d+"
    r"(/(planning|settings|history|lots|camera|recordings|pose|measure|review|checks|repeats|repeats/click|export"
    r"|scans|scans/results|scan|live))?)?/?$"
)
# named, and not with the weight 0, which refuses it
TAKES_BROTLI = re.compile(r"(?:^|,)\s*br\s*(?:,|$|;(?!\s*q=0(?:\.0*)?\s*(?:,|$)))", re.IGNORECASE)
HASHED = re.compile(r"-[A-Za-z0-9_-]{8}\.\w+$")
IMMUTABLE = "public, max-age=31536000, immutable"
NOT_BUILT = (
    "<!doctype html><html lang=en><meta charset=utf-8><title>Sightline</title>"
    "<p>Sightline's pages are not built yet; run <code>make setup</code> and load this page again."
)
DOCS = (
    "<!doctype html><html lang=en><meta charset=utf-8><title>Sightline API</title>"
    '<link rel=stylesheet href="/swagger/swagger-ui.css"><div id=swagger-ui></div>'
    '<script src="/swagger/swagger-ui-bundle.js"></script><script src="/docs/start.js"></script>'
)
# try-it-out needs the header that every change carries.
START = """SwaggerUIBundle({
  url: "/openapi.json", dom_id: "#swagger-ui", deepLinking: true,
  requestInterceptor: (request) => { request.headers["X-Sightline"] = "1"; return request; },
});
"""


router = APIRouter(include_in_schema=False)


def install(app: FastAPI) -> None:
    """Add the pages, after the API; a path that is none of them is a 404, for a browser with our pages."""
    app.router.routes.extend(router.routes)


def _folder(request: Request) -> Path:
    folder: Path = request.app.state.services.settings.frontend_dir
    return folder


@router.get("/docs")
def docs(request: Request) -> Response:
    if not (_folder(request) / "swagger" / "swagger-ui-bundle.js").is_file():
        return HTMLResponse(NOT_BUILT, status_code=503)
    return HTMLResponse(DOCS)


@router.get("/docs/start.js")
def start() -> Response:
    return Response(START, media_type="text/javascript")


@router.api_route("/favicon.ico", methods=["GET", "HEAD"])
def icon(request: Request) -> Response:
    """What browsers ask for beside a document that names no icon: a PDF, a video, JSON, the API's page."""
    return answer_page(_folder(request), "mark.svg")


@router.api_route("/{path:path}", methods=["GET", "HEAD"])
def page(path: str, request: Request) -> Response:
    folder = _folder(request)
    try:
        return answer_page(folder, path, request.headers.get("accept-encoding", ""))
    except HTTPException:
        # a person who opened this address is told in the front end's own clothes that it is none
        if "text/html" not in request.headers.get("accept", "") or path.split("/")[0] == "api":
            raise
        return _index(folder, 404)


def answer_page(folder: Path, path: str, encodings: str = "") -> Response:
    """A file of the build, or index.html for one of the front end's own routes; as the build compressed it,
    where that is among the `encodings` that are taken.

    Raises:
        HTTPException: 404 for anything else (also for every unknown path under /api).
    """
    if FRONT_END_ROUTE.match(path):
        return _index(folder)
    file = (folder / path).resolve()
    if path.startswith("api/") or not file.is_relative_to(folder.resolve()) or not file.is_file():
        raise HTTPException(404)
    headers = {"Cache-Control": IMMUTABLE if HASHED.search(file.name) else "no-cache"}
    packed = file.with_name(f"{file.name}.br")
    if not packed.is_file() or not TAKES_BROTLI.search(encodings):
        return FileResponse(file, headers=headers)
    headers |= {"Content-Encoding": "br", "Vary": "Accept-Encoding"}
    return FileResponse(packed, headers=headers, media_type=mimetypes.guess_type(file.name)[0])


def _index(folder: Path, status: int = 200) -> Response:
    index = folder / "index.html"
    if not index.is_file():
        return HTMLResponse(NOT_BUILT, status_code=503)
    return FileResponse(index, status, headers={"Cache-Control": "no-cache"})
