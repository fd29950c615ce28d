"""One small demonstration survey, one server and one Chromium for all browser tests."""

import fcntl
import os
import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import (
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

from .server import ROOT, Server, start

# A busy machine is slow, not wrong: only what never comes fails.
expect.set_options(timeout=30_000)

# Few vehicles, because drawing them is most of the wait: three by day with their driver on the near side, one
# by day that is not measured, and one of the line scan without heights. What a test stores of a vehicle, it
# stores of one of its own (`vehicles.py`).
SCENES, SCAN_VEHICLES = ("day:8", "low_light:2"), 7


# The longest files, which begin first, so that no browser is left alone with one at the end.
LONGEST = ("test_walk_links", "test_screens", "test_walk", "test_journey", "test_killed_ingest", "test_scans")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    places = {f"{name}.py": place for place, name in enumerate(LONGEST)}
    items.sort(key=lambda item: places.get(item.path.name, len(places)))


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
    yield launched
    launched.close()


@pytest.fixture(scope="session")
def demonstration(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """`sightline demo` over a copy of a small demonstration survey, which the first of all workers makes."""
    here = tmp_path_factory.getbasetemp()
    shared = here.parent if "PYTEST_XDIST_WORKER" in os.environ else here
    data_dir = here / "demonstration"
    shutil.copytree(made_once(shared / "small-demonstration"), data_dir)
    server = start("demo", data_dir)
    try:
        server.wait(300)
        yield server
    finally:
        server.stop()


def made_once(folder: Path) -> Path:
    """The data folder of a small demonstration survey; who comes while it is made waits."""
    with folder.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            part = folder.with_suffix(".part")
            make_small_survey(part)
            part.rename(folder)
    return folder


def make_small_survey(data_dir: Path, **settings: str) -> None:
    """As a worker of `sightline demo` makes it, but of fewer vehicles."""
    services = open_services(load_settings(data_dir=data_dir, find_passes=False, **settings))
    migrate(services.engine)
    assert first_sign_in_link(services)  # whoever makes it comes first; the server then prints their link
    with services.writing() as session:
        ensure_requested(session, scenes=SCENES, scan_vehicles=SCAN_VEHICLES)
    (job,) = run_jobs(services)
    services.close()
    assert job.state == "done", job


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


def wait_for_demonstration(page: Page, seconds: float = 300) -> int:
    """The id of the demonstration survey, once it is complete."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        me = page.request.get("/api/session").json()
        if me.get("demo_survey_id"):
            return int(me["demo_survey_id"])
        time.sleep(0.5)
    raise AssertionError("the demonstration survey was not made in time")


@pytest.fixture
def context(browser: Browser, demonstration: Server, admin_state: StorageState) -> Iterator[BrowserContext]:
    opened = browser.new_context(
        base_url=demonstration.url, storage_state=admin_state, viewport={"width": 1440, "height": 900}
    )
    yield opened
    opened.close()


@pytest.fixture
def page(context: BrowserContext) -> Page:
    opened = context.new_page()
    opened.set_default_timeout(30_000)
    return opened


@pytest.fixture(scope="session")
def screenshots() -> Path:
    """Where the tests leave pictures to look at; made anew each time, never committed."""
    folder = ROOT / ".build" / "screenshots"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def choose_plan(page: Page, survey_id: int, blind_one_in: int) -> None:
    """How many of a survey's measurements are clicked blind from now on, as its administrator chooses it."""
    address = f"/api/surveys/{survey_id}/review-plan"
    now = page.request.get(address).json()
    body = {"blind_one_in": blind_one_in, "version": now["version"]}
    assert page.request.put(address, data=body, headers={"X-Sightline": "1"}).ok
