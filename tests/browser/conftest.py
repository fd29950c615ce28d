"""One demonstration survey, one server and one Chromium for all browser tests.

What a test stores of a vehicle, it stores of one of its own (`vehicles.py`).
"""

import fcntl
import os
import shutil
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import (
    APIRequestContext,
    Browser,
    BrowserContext,
    Page,
    Playwright,
    StorageState,
    expect,
    sync_playwright,
)

from sightline.demo.request import ensure_requested
from sightline.infra.database.engine import migrate
from sightline.infra.services import open_services
from sightline.people.service import first_sign_in_link
from sightline.settings import load_settings
from tests.support.working import run_jobs

from .kept import put_back
from .server import ROOT, Server, start
from .waits import NEVER_MS, wait_until

expect.set_options(timeout=NEVER_MS)

# Files that begin first, in this order, with the processor seconds that each takes alone; the rest follow by
# name. One makes the demonstration, meanwhile two begin with what needs none. The walks read what it is like
# before other files have worked in it.
FIRST_S = {
    "test_walk_links": 30,
    "test_one_figure": 20,
    "test_killed_ingest": 10,
    "test_languages": 38,
    "test_walk": 25,
    "test_guide": 40,
    "test_screens": 30,
    "test_journey": 24,
    "test_scans": 25,
    "test_protocol": 25,
    "test_package_page": 25,
    "test_two_tabs": 25,
    "test_gestures": 22,
    "test_small_traps": 22,
    "test_proposals": 18,
    "test_bad_input": 17,
    "test_statistics": 17,
    "test_second_frame": 14,
    "test_keyboard": 14,
    "test_narrow": 13,
    "test_which_model": 12,
}
OTHERS_S = 6


def groups(files: Iterable[str], number: int) -> dict[str, int]:
    """The browser that each file is run in: of so many the one with least to do so far."""
    ordered = sorted(set(files), key=lambda name: (name not in FIRST_S, [*FIRST_S, name].index(name), name))
    busy, found = [0] * number, {}
    for name in ordered:
        found[name] = busy.index(min(busy))
        busy[found[name]] += FIRST_S.get(name, OTHERS_S)
    return found


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """With `--dist loadgroup` each file is always run after the same files, however long they take."""
    mine = [item for item in items if item.path.parent == Path(__file__).parent]
    group = groups((item.path.stem for item in mine), int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1")))
    places = {name: place for place, name in enumerate(group)}
    for item in mine:
        item.add_marker(pytest.mark.xdist_group(f"browser-{group[item.path.stem]}"))
    items.sort(key=lambda item: places[item.path.stem] if item in mine else -1)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Tests that needed a second try are named here and in .build/flaky.txt, with what the first one said."""
    again: dict[str, str] = {}
    for report in terminalreporter.stats.get("rerun", []):
        again[report.nodeid] = again.get(report.nodeid, "") + report.longreprtext
    place = ROOT / ".build" / "flaky.txt"
    place.parent.mkdir(exist_ok=True)
    place.write_text("".join(f"{name}\n{said}\n\n" for name, said in sorted(again.items())))
    for name, said in sorted(again.items()):
        terminalreporter.write_line(f"WARNING: {name} needed a second try (.build/flaky.txt):", yellow=True)
        terminalreporter.write_line("\n".join(line for line in said.splitlines() if line[:1] in ">E"))


def chromium_path() -> str | None:
    """The browser `make test` found; None lets Playwright take its own."""
    note = ROOT / ".build" / "chromium"
    named = os.environ.get("SIGHTLINE_CHROMIUM") or (note.read_text().strip() if note.exists() else "")
    return named if named and named != "playwright" else None


@pytest.fixture(scope="session")
def playwright() -> Iterator[Playwright]:
    with sync_playwright() as started:
        yield started


@pytest.fixture(scope="session")
def browser(playwright: Playwright) -> Iterator[Browser]:
    launched = playwright.chromium.launch(
        executable_path=chromium_path(),
        args=[
            "--no-sandbox",
            "--disable-gpu",
            "--disable-background-networking",
            "--disable-component-update",
        ],
    )
    opens = launched.new_context

    def patient(**options: Any) -> BrowserContext:
        """A busy machine is slow, not wrong: only what never comes fails."""
        opened = opens(**options)
        opened.set_default_timeout(NEVER_MS)
        return opened

    launched.new_context = patient  # type: ignore[method-assign]
    yield launched
    launched.close()


@pytest.fixture(scope="session")
def demonstration(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """`sightline demo` over a copy of a demonstration survey, which the first of all workers makes."""
    here = tmp_path_factory.getbasetemp()
    shared = here.parent if "PYTEST_XDIST_WORKER" in os.environ else here
    data_dir = here / "demonstration"
    shutil.copytree(made_once(shared / "made-demonstration"), data_dir)
    server = start("demo", data_dir)
    try:
        server.wait()
        yield server
    finally:
        server.stop()


def made_once(folder: Path) -> Path:
    """The data folder of a demonstration survey; who comes while it is made waits."""
    with folder.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            part = folder.with_suffix(".part")
            make_survey(part)
            part.rename(folder)
    return folder


def make_survey(data_dir: Path, **settings: str) -> None:
    """As a worker of `sightline demo` makes it, without the study."""
    services = open_services(load_settings(data_dir=data_dir, find_passes=False, **settings))
    migrate(services.engine)
    assert first_sign_in_link(services)  # whoever makes it comes first; the server then prints their link
    with services.writing() as session:
        ensure_requested(session)
    # and what its poses ask for: else every server over a copy would do that
    while jobs := run_jobs(services):
        assert all(job.state == "done" for job in jobs), jobs
    services.close()


@pytest.fixture(scope="session")
def admin_state(browser: Browser, demonstration: Server) -> StorageState:
    """Cookies of the admin whom the one-time link made, kept for the tests that only need to be signed in."""
    context = browser.new_context(base_url=demonstration.url)
    page = context.new_page()
    page.goto(demonstration.sign_in_link())
    page.wait_for_url(lambda url: "sign-in" not in url)
    wait_for_demonstration(page)
    state = context.storage_state()
    context.close()
    return state


@pytest.fixture(scope="session")
def admin(
    playwright: Playwright, demonstration: Server, admin_state: StorageState
) -> Iterator[APIRequestContext]:
    """Asks the API as the admin does, without a page."""
    asking = playwright.request.new_context(
        base_url=demonstration.url, storage_state=admin_state, timeout=NEVER_MS
    )
    yield asking
    asking.dispose()


@pytest.fixture(scope="session")
def survey_id(admin: APIRequestContext) -> int:
    """The demonstration survey."""
    return int(admin.get("/api/session").json()["demo_survey_id"])


@pytest.fixture
def kept(admin: APIRequestContext, survey_id: int) -> Iterator[None]:
    """What is chosen for the demonstration survey is put back after the test (`kept.py`)."""
    with put_back(admin, survey_id):
        yield


def wait_for_demonstration(page: Page) -> int:
    """The id of the demonstration survey, once it is complete."""

    def made() -> int | None:
        return page.request.get("/api/session").json().get("demo_survey_id")

    return int(wait_until(page, made, lambda: "the demonstration survey was not made"))


@pytest.fixture(scope="session")
def administrators(
    browser: Browser, demonstration: Server, admin_state: StorageState
) -> Iterator[BrowserContext]:
    """One for all tests: what its first page fetched the others have, an eighth of opening a page."""
    opened = browser.new_context(
        base_url=demonstration.url, storage_state=admin_state, viewport={"width": 1440, "height": 900}
    )
    yield opened
    opened.close()


@pytest.fixture(scope="session")
def forgetting(administrators: BrowserContext, demonstration: Server) -> Callable[[], None]:
    """Takes away what pages of that browser have kept; its own page stays empty."""
    stays = administrators.new_cdp_session(administrators.new_page())
    what = {"origin": demonstration.url, "storageTypes": "local_storage,indexeddb,cache_storage"}
    return lambda: stays.send("Storage.clearDataForOrigin", what)


@pytest.fixture
def context(administrators: BrowserContext, forgetting: Callable[[], None]) -> Iterator[BrowserContext]:
    """The administrator's browser, with no page of another test and nothing that one kept."""
    there = set(administrators.pages)
    yield administrators
    for page in set(administrators.pages) - there:
        page.unroute_all(behavior="ignoreErrors")
        page.close()
    administrators.set_offline(False)
    forgetting()


@pytest.fixture
def page(context: BrowserContext) -> Page:
    return context.new_page()


@pytest.fixture(scope="session", autouse=True)
def pictures_when_asked_for() -> Iterator[None]:
    """Pictures for people to look at are taken where SIGHTLINE_PICTURES=1 asks for them."""
    with pytest.MonkeyPatch.context() as patch:
        if os.environ.get("SIGHTLINE_PICTURES") != "1":
            patch.setattr(Page, "screenshot", lambda *words, **options: b"")
        yield


@pytest.fixture(scope="session")
def screenshots() -> Path:
    """Where the tests leave those pictures; made anew each time, never committed."""
    folder = ROOT / ".build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def choose_plan(page: Page, survey_id: int, blind_one_in: int) -> None:
    """How many of a survey's measurements are clicked blind from now on, as its administrator chooses it."""
    address = f"/api/surveys/{survey_id}/review-plan"
    now = page.request.get(address).json()
    body = {"blind_one_in": blind_one_in, "version": now["version"]}
    assert page.request.put(address, data=body, headers={"X-Sightline": "1"}).ok
