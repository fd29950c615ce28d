"""What holds for every request: cross-site protection, headers, one shape of errors, bounds, pages."""

import asyncio
import json
from pathlib import Path

import httpx2
import pytest
from fastapi import FastAPI
from starlette.types import Message

from sightline import messages
from sightline.errors import NoRoom
from sightline.infra.services import Services
from sightline.infra.web.cookie import COOKIE
from sightline.infra.web.write_gate import WriteGate
from sightline.surveys.store import list_surveys
from tests.support.app import Client, error_of
from tests.support.waiting import NEVER_S

pytestmark = pytest.mark.once
FROM_ELSEWHERE = (
    {"X-Sightline": ""},
    {"X-Sightline": "0"},
    {"Origin": "https://evil.example"},
    {"Origin": "null"},
    {"Sec-Fetch-Site": "cross-site"},
    {"Sec-Fetch-Site": "same-site"},
)
MALFORMED = (
    b"",
    b"{",
    b"[]",
    b"null",
    b'"x"',
    b'{"name": 1}',
    b'{"name": "x", "nmae": "y"}',
    b"\xff\xfe",
    b'{"name": ""}',
)


def test_writes_from_elsewhere_are_refused(operator: Client) -> None:
    for headers in FROM_ELSEWHERE:
        answer = operator.post("/surveys", {"name": "no"}, headers=headers)
        assert answer.status_code == 403
        error_of(answer)
        assert operator.seen("/surveys") == []


def test_our_own_pages_may_write(operator: Client) -> None:
    headers = {"Origin": "http://testserver", "Sec-Fetch-Site": "same-origin"}
    assert operator.post("/surveys", {"name": "yes"}, headers=headers).status_code == 201


def test_answers_carry_the_security_headers(nobody: Client) -> None:
    for path in ("/api/health", "/api/nothing", "/", "/docs", "/openapi.json"):
        headers = nobody.http.get(path).headers
        assert "script-src 'self'" in headers["content-security-policy"]
        assert "unsafe-eval" not in headers["content-security-policy"]
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["x-frame-options"] == "DENY"
    assert "access-control-allow-origin" not in nobody.http.get("/api/health").headers


def test_unknown_addresses_and_methods_have_the_one_shape(operator: Client) -> None:
    assert operator.get("/nothing/here").status_code == 404
    assert "/api/nothing/here" in error_of(operator.get("/nothing/here"))
    wrong = operator.delete("/surveys")
    assert wrong.status_code == 405
    error_of(wrong)
    for path in ("/surveys/0", "/surveys/x", "/surveys/2147483648", "/surveys/-1"):
        answer = operator.get(path)
        assert answer.status_code == 422, path
        error_of(answer)
    assert operator.get("/surveys/2147483647").status_code == 404


def test_malformed_bodies_have_the_one_shape(operator: Client) -> None:
    for body in MALFORMED:
        answer = operator.http.post(
            "/api/surveys", content=body, headers={"Content-Type": "application/json"}
        )
        assert answer.status_code in (400, 422), body
        error_of(answer)


def test_numbers_that_are_none_are_refused(operator: Client, survey_id: int) -> None:
    body = b'{"name": "x", "version": 1, "insets": {"roof": {"inset_m": NaN, "u_inset_m": 0.1}}}'
    headers = {"Content-Type": "application/json"}
    answer = operator.http.put(f"/api/surveys/{survey_id}", content=body, headers=headers)
    assert answer.status_code == 422
    assert "inset_m" in error_of(answer)


def test_huge_bodies_are_refused(operator: Client) -> None:
    answer = operator.post("/surveys", {"name": "x", "description": "y" * 3_000_000})
    assert answer.status_code == 413
    error_of(answer)


def test_a_huge_body_that_says_it_is_of_an_upload_is_refused_where_none_goes_on(nobody: Client) -> None:
    headers = {"Content-Type": "application/offset+octet-stream"}
    answer = nobody.http.post("/api/session", content=b"y" * 3_000_000, headers=headers)
    assert answer.status_code == 413
    error_of(answer)


def test_a_huge_form_is_refused_where_no_file_is_taken(nobody: Client) -> None:
    files = {"file": ("road.jpg", b"x" * 3_000_000, "image/jpeg")}
    for method, path in (("POST", "/session"), ("POST", "/surveys"), ("PUT", "/surveys/1/photographs")):
        answer = nobody.http.request(method, f"/api{path}", files=files, headers={"X-Sightline": "1"})
        assert answer.status_code in (405, 413), path
        assert (answer.status_code == 405) == (method == "PUT")
        error_of(answer)
    taken = nobody.http.post("/api/surveys/1/photographs", files=files, headers={"X-Sightline": "1"})
    assert taken.status_code == 401


@pytest.mark.parametrize("stranger", [(), ((b"authorization", b"Bearer sightline_wrong"),)])
def test_the_form_of_a_stranger_is_not_read(app: FastAPI, stranger: tuple[tuple[bytes, bytes], ...]) -> None:
    told = list[Message]()

    async def receive() -> Message:
        pytest.fail("the body was asked for")

    async def send(message: Message) -> None:
        told.append(message)

    french = (b"accept-language", b"fr")
    headers = [
        (b"x-sightline", b"1"),
        (b"content-type", b"multipart/form-data; boundary=x"),
        french,
        *stranger,
    ]
    scope = {"type": "http", "method": "POST", "path": "/api/surveys/1/photographs", "headers": headers}
    scope |= {"query_string": b"", "client": ("127.0.0.1", 1), "server": ("testserver", 80), "scheme": "http"}
    scope |= {"asgi": {"version": "3.0"}, "http_version": "1.1", "root_path": ""}
    asyncio.run(app(scope, receive, send))
    assert told[0]["status"] == 401
    code = "web-token-invalid" if stranger else "web-not-signed-in"
    assert json.loads(told[1]["body"])["error"]["message"] == messages.say(code, {}, "fr")


def test_an_unexpected_failure_is_a_sentence(app: FastAPI, nobody: Client) -> None:
    @app.get("/api/broken-for-the-test")
    def broken() -> None:
        raise RuntimeError("secret detail")

    @app.get("/api/full-for-the-test")
    def full() -> None:
        raise OSError(28, "No space left on device")

    app.router.routes.insert(0, app.router.routes.pop())
    app.router.routes.insert(0, app.router.routes.pop())
    answer = nobody.get("/broken-for-the-test")
    assert answer.status_code == 500
    assert "secret detail" not in error_of(answer)
    answer = nobody.get("/full-for-the-test")
    assert answer.status_code == 507
    assert "disk is full" in error_of(answer)


def test_a_form_that_finds_no_room_while_it_arrives_is_not_blamed(
    operator: Client, survey_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("starlette.datastructures.UploadFile.write", full)
    answer = operator.http.post(
        f"/api/surveys/{survey_id}/photographs",
        files={"file": ("road.jpg", b"x" * 2000, "image/jpeg")},
        headers={"X-Sightline": "1"},
    )
    assert answer.status_code == 507
    assert "disk is full" in error_of(answer)


def test_a_commit_that_fails_is_not_answered_with_success(
    operator: Client, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise NoRoom(
            "said", sentence="The disk is full, so nothing was saved; free some space and try again."
        )

    with monkeypatch.context() as patched:
        patched.setattr("sqlalchemy.orm.Session.commit", full)
        answer = operator.post("/surveys", {"name": "lost"})
    assert answer.status_code == 507
    error_of(answer)
    assert operator.seen("/surveys") == []
    # The write lock was given back.
    assert operator.post("/surveys", {"name": "kept"}).status_code == 201


def test_more_writers_than_threads_all_get_their_turn(
    app: FastAPI, operator: Client, services: Services
) -> None:
    """With the wait for the lock in the thread pool (forty threads), this would stand still for ever."""
    cookies = {COOKIE: operator.http.cookies[COOKIE]}
    app.state.write_gate = WriteGate(wait_s=NEVER_S)

    async def storm() -> list[int]:
        transport = httpx2.ASGITransport(app)
        address = "http://testserver"
        async with httpx2.AsyncClient(
            transport=transport,
            base_url=address,
            headers={"X-Sightline": "1"},
            cookies=cookies,
            timeout=NEVER_S,
        ) as client:
            posts = [client.post("/api/surveys", json={"name": f"S{n}"}) for n in range(80)]
            return [answer.status_code for answer in await asyncio.gather(*posts)]

    assert asyncio.run(asyncio.wait_for(storm(), NEVER_S)) == [201] * 80
    with services.reading() as session:
        assert len(list_surveys(session)) == 80


def build(folder: Path) -> None:
    (folder / "assets").mkdir(parents=True)
    (folder / "index.html").write_text("<!doctype html><title>Sightline</title>")
    (folder / "assets" / "main-BxY12_ab.js").write_text("let a = 1;" * 400)
    (folder / "assets" / "icon.svg").write_text("<svg/>")
    (folder.parent / "outside.txt").write_text("secret")


def test_pages_before_the_build_say_what_to_do(nobody: Client) -> None:
    for path in ("/", "/docs", "/surveys/1"):
        answer = nobody.http.get(path)
        assert answer.status_code == 503
        assert "make setup" in answer.text


def test_pages(nobody: Client, tmp_path: Path) -> None:
    build(tmp_path / "pages")
    for path in ("/", "/sign-in?token=x", "/surveys/12", "/surveys/12/measure?frame=3", "/audit", "/account"):
        answer = nobody.http.get(path)
        assert answer.status_code == 200 and "<title>Sightline" in answer.text
        assert answer.headers["cache-control"] == "no-cache"
    hashed = nobody.http.get("/assets/main-BxY12_ab.js")
    assert hashed.headers["cache-control"] == "public, max-age=31536000, immutable"
    assert hashed.headers["content-encoding"] == "gzip"
    assert nobody.http.get("/assets/icon.svg").headers["cache-control"] == "no-cache"
    (tmp_path / "pages" / "assets" / "main-BxY12_ab.js.br").write_bytes(b"packed")
    for taken, sent in (("gzip, deflate, br;q=0.9", "br"), ("gzip, brotli", "gzip"), ("identity", None)):
        with nobody.http.stream(
            "GET", "/assets/main-BxY12_ab.js", headers={"Accept-Encoding": taken}
        ) as answer:
            assert answer.headers.get("content-encoding") == sent, taken
            assert answer.headers["content-type"].startswith("text/javascript"), taken
            assert answer.headers["cache-control"] == "public, max-age=31536000, immutable"
            assert answer.headers["vary"] == "Accept-Encoding" or sent is None
            assert (b"".join(answer.iter_raw()) == b"packed") is (sent == "br"), taken
    for path in (
        "/surveys/x",
        "/nothing",
        "/assets/none.js",
        "/%2e%2e/outside.txt",
        "/..%2foutside.txt",
        "/assets",
    ):
        answer = nobody.http.get(path)
        assert answer.status_code == 404, path
        error_of(answer)


def test_a_browser_at_an_unknown_address_gets_our_pages_with_404(nobody: Client, tmp_path: Path) -> None:
    build(tmp_path / "pages")
    headers = {"Accept": "text/html,application/xhtml+xml,*/*;q=0.8"}
    for path in ("/nothing", "/surveys/x", "/surveys/1/nowhere", "/%2e%2e/outside.txt"):
        answer = nobody.http.get(path, headers=headers)
        assert answer.status_code == 404, path
        assert "<title>Sightline" in answer.text
        assert answer.headers["cache-control"] == "no-cache"
    for path in ("/api/nothing", "/api"):
        error_of(nobody.http.get(path, headers=headers))
    error_of(nobody.http.get("/nothing", headers={"Accept": "application/json"}))


def test_the_icon_that_browsers_ask_for_beside_a_document_is_there(nobody: Client, tmp_path: Path) -> None:
    """Beside a PDF, a video or JSON in a tab of its own, which name none, a browser asks for /favicon.ico."""
    build(tmp_path / "pages")
    (tmp_path / "pages" / "mark.svg").write_text("<svg/>")
    icon = nobody.http.get("/favicon.ico")
    assert (icon.status_code, icon.headers["content-type"], icon.text) == (200, "image/svg+xml", "<svg/>")
    head = nobody.http.head("/favicon.ico")
    assert (head.status_code, head.headers["content-length"], head.text) == (200, "6", "")


def test_docs_need_no_foreign_address(nobody: Client, tmp_path: Path) -> None:
    build(tmp_path / "pages")
    (tmp_path / "pages" / "swagger").mkdir()
    for name in ("swagger-ui-bundle.js", "swagger-ui.css"):
        (tmp_path / "pages" / "swagger" / name).write_text("/* */")
    page = nobody.http.get("/docs").text
    assert "http" not in page.replace("<!doctype html>", "")
    assert "/openapi.json" in nobody.http.get("/docs/start.js").text
    assert nobody.http.get("/openapi.json").json()["info"]["title"] == "Sightline"
