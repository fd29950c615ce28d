"""Ground of the API's tests: the app, people of every role signed in, a tiny recording."""

import base64
import copy
import shutil
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass
from functools import cache
from http.cookiejar import CookieJar
from pathlib import Path
from typing import Any

import httpx2
import numpy as np
import pytest
from anyio.from_thread import start_blocking_portal
from argon2 import PasswordHasher
from fastapi import FastAPI
from fastapi.testclient import TestClient
from pydantic import SecretStr
from starlette import testclient

from sightline.app import create_app
from sightline.enums import Role
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services, open_services
from sightline.infra.web.openapi import Api
from sightline.media.video.writer import write_mp4
from sightline.people import service
from sightline.people.store import create_person, create_sign_in_link
from sightline.settings import Settings
from tests.media.clips import painted
from tests.support.boards import board_clip
from tests.support.kept import PutBack, Shelf
from tests.support.working import run_jobs

ROLES: tuple[Role, ...] = ("viewer", "operator", "reviewer", "admin")
FRAMES, FRAME_WIDTH, FRAME_HEIGHT = 12, 320, 240
TUS = {"Tus-Resumable": "1.0.0"}


@cache
def _settings() -> Settings:
    """What all have alike: reading the environment for each takes as long as a request."""
    return Settings(secret=SecretStr("a secret for tests only"), find_passes=False)


def settings_of(home: Path, database_url: str) -> Settings:
    """Settings of a data folder and a database for tests alone."""
    data_dir = home / "data"
    data_dir.mkdir()
    own: dict[str, Any] = {"media_url": str(data_dir / "media"), "uploads_dir": data_dir / "uploads"}
    own |= {"data_dir": data_dir, "database_url": database_url, "frontend_dir": home / "pages"}
    return _settings().model_copy(update=own)


@pytest.fixture
def settings(tmp_path: Path, database_url: str) -> Settings:
    """Settings of a data folder and a database of this test alone."""
    return settings_of(tmp_path, database_url)


@pytest.fixture(scope="session", autouse=True)
def quick_passwords() -> Iterator[PasswordHasher]:
    """Passwords are hashed with as little work as there is, which else is half of what people's tests take.
    Gives what the product hashes them with.
    """
    own = service._hasher
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(service, "_hasher", PasswordHasher(time_cost=1, memory_cost=8, parallelism=1))
        yield own


@pytest.fixture(scope="session", autouse=True)
def described_once() -> Iterator[Callable[[Api], dict[str, Any]]]:
    """Every app of the tests with the same routes takes its description from the first that was asked for it.
    Gives what makes one.
    """
    own = Api.openapi
    kept: dict[int, dict[str, Any]] = {}

    def openapi(app: Api) -> dict[str, Any]:
        if len(app.routes) not in kept:
            kept[len(app.routes)] = own(app)
        return kept[len(app.routes)]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Api, "openapi", openapi)
        yield own


@pytest.fixture
def services(settings: Settings, laid: "Laid", monkeypatch: pytest.MonkeyPatch) -> Iterator[Services]:
    """The services, stills decoded here: a child each test would cost more than the tests do."""
    monkeypatch.setattr("sightline.infra.services.DecodeHost", lambda _limit_bytes: None)
    opened = open_services(settings)
    yield opened
    opened.close()


class _Whole(testclient._TestClientTransport):
    """Each answer comes whole, by one call into the loop: in pieces, as a client has it, it takes eight."""

    def handle_request(self, request: httpx2.Request) -> httpx2.Response:
        request.read()
        to_app = httpx2.ASGITransport(
            self.app, self.raise_server_exceptions, root_path=self.root_path, client=self.client
        )

        async def answer() -> httpx2.Response:
            given = await to_app.handle_async_request(request)
            content = httpx2.ByteStream(b"".join([part async for part in given.aiter_raw()]))
            return httpx2.Response(given.status_code, headers=given.headers, stream=content)

        with self.portal_factory() as portal:
            return portal.call(answer)


@pytest.fixture(scope="session")
def one_loop() -> Iterator[None]:
    """One event loop for all requests of the tests; a client on its own starts a loop for each."""
    with start_blocking_portal() as portal, pytest.MonkeyPatch.context() as patch:
        patch.setattr(testclient, "_TestClientTransport", _Whole)
        TestClient.portal = portal
        yield
        TestClient.portal = None


@pytest.fixture
def app(services: Services, one_loop: None) -> FastAPI:
    return create_app(services=services)


@dataclass
class Client:
    """One person's browser: speaks to /api, with the header that changes need."""

    http: TestClient

    def get(self, path: str, **options: Any) -> httpx2.Response:
        return self.http.get(f"/api{path}", **options)

    def post(self, path: str, json: Any = None, **options: Any) -> httpx2.Response:
        return self.http.post(f"/api{path}", json=json, **options)

    def put(self, path: str, json: Any = None, **options: Any) -> httpx2.Response:
        return self.http.put(f"/api{path}", json=json, **options)

    def delete(self, path: str, **options: Any) -> httpx2.Response:
        return self.http.delete(f"/api{path}", **options)

    def made(self, path: str, json: Any = None) -> Any:
        """The answer of a POST that must succeed."""
        answer = self.post(path, json)
        assert answer.status_code in (200, 201, 202), answer.text
        return answer.json()

    def seen(self, path: str) -> Any:
        """The answer of a GET that must succeed."""
        answer = self.get(path)
        assert answer.status_code == 200, answer.text
        return answer.json()


def error_of(answer: httpx2.Response) -> str:
    """The sentence of an error; fails if the answer is not in the one shape of errors."""
    body = answer.json()
    assert set(body["error"]) == {"kind", "code", "values", "message"}, body
    sentence: str = body["error"]["message"]
    assert sentence[:1].strip() and sentence.endswith("."), sentence
    assert "Traceback" not in sentence
    return sentence


def browser(app: FastAPI, cookies: CookieJar | None = None) -> Client:
    """A browser, with the cookies that it has already."""
    http = TestClient(app, headers={"X-Sightline": "1"}, raise_server_exceptions=False)
    for cookie in cookies or ():
        http.cookies.jar.set_cookie(copy.copy(cookie))
    return Client(http)


@pytest.fixture
def nobody(app: FastAPI) -> Client:
    """A browser in which nobody is signed in."""
    return browser(app)


def sign_in_everybody(app: FastAPI, services: Services) -> dict[str, Client]:
    """A person of each role, each signed in in a browser of their own."""
    tokens: dict[str, str] = {}
    with services.writing() as session:
        for role in ROLES:
            person = create_person(
                session, name=role.title(), email=f"{role}@example.org", role=role, actor=None
            )
            tokens[role] = create_sign_in_link(session, person.id, actor=None)
    clients = {role: browser(app) for role in ROLES}
    for role, client in clients.items():
        client.made("/session/link", {"token": tokens[role]})
    return clients


@pytest.fixture
def clients(app: FastAPI, services: Services, laid: "Laid") -> dict[str, Client]:
    """A signed-in browser for each role."""
    if not laid.cookies:
        return sign_in_everybody(app, services)
    return {role: browser(app, cookies) for role, cookies in laid.cookies.items()}


@pytest.fixture
def viewer(clients: dict[str, Client]) -> Client:
    return clients["viewer"]


@pytest.fixture
def operator(clients: dict[str, Client]) -> Client:
    return clients["operator"]


@pytest.fixture
def reviewer(clients: dict[str, Client]) -> Client:
    return clients["reviewer"]


@pytest.fixture
def admin(clients: dict[str, Client]) -> Client:
    return clients["admin"]


@pytest.fixture
def work(services: Services) -> Callable[[], list[Job]]:
    """Do all queued jobs, here and now; they are given back as they ended."""
    return lambda: run_jobs(services)


def add_survey(admin: Client) -> int:
    """A survey in which everybody acts by the role of the account; who belongs to one: `test_members`."""
    return int(admin.made("/surveys", {"name": "Test road", "open_to_all": True})["id"])


@pytest.fixture
def survey_id(admin: Client, laid: "Laid") -> int:
    return laid.survey_id or add_survey(admin)


def announce(client: Client, survey_id: int, name: str, size: int) -> httpx2.Response:
    """Begin a tus upload."""
    metadata = "filename " + base64.b64encode(name.encode()).decode()
    headers = {**TUS, "Upload-Length": str(size), "Upload-Metadata": metadata}
    return client.http.post(f"/api/surveys/{survey_id}/uploads", headers=headers)


def send(client: Client, location: str, offset: int, content: bytes) -> httpx2.Response:
    """Continue a tus upload."""
    headers = {**TUS, "Upload-Offset": str(offset), "Content-Type": "application/offset+octet-stream"}
    return client.http.patch(location, content=content, headers=headers)


def upload(client: Client, survey_id: int, path: Path, name: str | None = None) -> int:
    """Upload a file whole; the id of its recording."""
    content = path.read_bytes()
    location = announce(client, survey_id, name or path.name, len(content)).headers["Location"]
    answer = send(client, location, 0, content)
    assert answer.status_code == 204, answer.text
    return int(answer.headers["Sightline-Recording"])


@pytest.fixture(scope="session")
def numbered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Twelve small frames that carry their number."""
    path = tmp_path_factory.mktemp("clip") / "road.mp4"
    write_mp4(path, (painted(n, FRAME_WIDTH, FRAME_HEIGHT) for n in range(FRAMES)), 25, crf=14, gop=6)
    return path


@pytest.fixture(scope="session")
def clip(numbered: Path) -> Path:
    """What `recording_id` is a recording of; the media tests have clips of their own by this name."""
    return numbered


@pytest.fixture(scope="session")
def boards(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Twenty frames of a checkerboard in ten poses."""
    return board_clip(tmp_path_factory.mktemp("boards") / "boards.mp4")


def add_recording(operator: Client, services: Services, survey_id: int, clip: Path) -> int:
    """A small recording, ingested."""
    made = upload(operator, survey_id, clip)
    assert [job.state for job in run_jobs(services)] == ["done"]
    return made


@pytest.fixture
def recording_id(operator: Client, services: Services, survey_id: int, clip: Path, laid: "Laid") -> int:
    """A small recording, ingested."""
    return laid.recording_id or add_recording(operator, services, survey_id, clip)


@pytest.fixture
def gate_scan_id(laid: "Laid") -> int:
    """A line scan of the survey, Gate, with three measured vehicles."""
    assert laid.gate_scan_id
    return laid.gate_scan_id


@dataclass(frozen=True)
class Laid:
    """What a test finds when its services are opened: nothing, or people, or a survey too, and in it a
    recording or a measured line scan.
    """

    cookies: dict[str, CookieJar] | None = None
    survey_id: int | None = None
    recording_id: int | None = None
    gate_scan_id: int | None = None


class Laying:
    """Lays people, survey and recording or scan once by way of the API, and puts them back for each test."""

    def __init__(self, shelf: Shelf, folder: Path, clip: Path) -> None:
        self._shelf, self._folder, self._clip = shelf, folder, clip
        self._kept: dict[str, tuple[Laid, PutBack]] = {}

    def lay(self, last: str, settings: Settings) -> Laid:
        """Put all back up to the `last` of `clients`, `survey_id`, and `recording_id` or `gate_scan_id`."""
        home = self._folder / last
        if last not in self._kept:
            home.mkdir()
            self._kept[last] = self._shelf.keep(lambda url: self._lay(last, settings_of(home, url)))
        laid, put_back = self._kept[last]
        put_back(settings.database_url)
        shutil.copytree(home / "data", settings.data_dir, dirs_exist_ok=True)
        return laid

    def _lay(self, last: str, settings: Settings) -> Laid:
        with closing(open_services(settings, decode_in_child=False)) as services:
            app = create_app(services=services)
            clients = sign_in_everybody(app, services)
            cookies = {role: client.http.cookies.jar for role, client in clients.items()}
            if last == "clients":
                return Laid(cookies)
            survey_id = add_survey(clients["admin"])
            if last == "survey_id":
                return Laid(cookies, survey_id)
            if last == "gate_scan_id":
                from tests.support.scanning_ground import add_scan

                scan_id = add_scan(clients["operator"], services, survey_id, self._folder)
                return Laid(cookies, survey_id, gate_scan_id=scan_id)
            made = add_recording(clients["operator"], services, survey_id, self._clip)
            return Laid(cookies, survey_id, made)


@pytest.fixture(scope="session")
def laying(shelf: Shelf, tmp_path_factory: pytest.TempPathFactory, numbered: Path, one_loop: None) -> Laying:
    return Laying(shelf, tmp_path_factory.mktemp("laid"), numbered)


@pytest.fixture
def laid(request: pytest.FixtureRequest, settings: Settings) -> Laid:
    """What the test asks for is put back before its services are opened."""
    for last in ("gate_scan_id", "recording_id", "survey_id", "clients"):
        if last in request.fixturenames:
            laying: Laying = request.getfixturevalue("laying")
            return laying.lay(last, settings)
    return Laid()


def number_of(content: bytes) -> int:
    """The number painted into an encoded frame."""
    import cv2

    from tests.media.clips import read_number

    return read_number(np.asarray(cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR), np.uint8))
