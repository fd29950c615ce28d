"""The guide's "First survey" done step by step as it is written, in French; in `make proofs` in English too.

What is pressed is named by its message, and the guide has to name it so; it ends on the page of the package.
"""

import json
import re
import shutil
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import (
    APIRequestContext,
    Browser,
    BrowserContext,
    Locator,
    Page,
    Playwright,
    StorageState,
    expect,
)

from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.messages import say

from .conftest import made_once
from .server import ROOT, Server, start
from .test_journey import go_to_frame
from .test_languages import SHOWN, Catalogues
from .vehicles import click_at, open_pass, scene_truth, whole_frames
from .waits import NEVER_MS, wait_until

LOCALES = {"en": "en-GB", "fr": "fr-FR"}
KEYS = {"roof": "1", "driver_eye": "2", "taillight": "3"}
REST_FRAME = 30


@pytest.fixture(scope="module")
def small_demonstration(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server of its own over the small demonstration, which looks for the vehicles of a new recording."""
    here = tmp_path_factory.getbasetemp()
    shared = here.parent if here.name.startswith("popen") else here
    data_dir = tmp_path_factory.mktemp("guide") / "data"
    shutil.copytree(made_once(shared / "made-demonstration"), data_dir)
    server = start("demo", data_dir, extra={"SIGHTLINE_FIND_PASSES": "true"})
    try:
        server.wait()
        yield server
    finally:
        server.stop()


@pytest.fixture(scope="module")
def cookies(playwright: Playwright, small_demonstration: Server) -> Iterator[APIRequestContext]:
    """The administrator whom the first link made."""
    asking = playwright.request.new_context(base_url=small_demonstration.url, timeout=NEVER_MS)
    token = small_demonstration.sign_in_link().split("token=")[1]
    assert asking.post("/api/session/link", data={"token": token}, headers={"X-Sightline": "1"}).ok
    yield asking
    asking.dispose()


@cache
def text_of(language: str) -> str:
    written = (ROOT / "docs/guide" / language / "first-survey.md").read_text("utf-8")
    return " ".join(written.split())


@dataclass(frozen=True)
class Guide:
    """The page of the guide in a language, and somebody who follows it."""

    language: str
    page: Page

    def word(self, key: str, values: Mapping[str, str | int] | None = None) -> str:
        return say(key, values or {}, self.language)

    def named(self, key: str) -> str:
        """What the guide names, in bold or in italics, as the screens do; in the other language too."""
        for language in LOCALES:
            word = say(key, {}, language)
            assert f"*{word}*" in text_of(language), f"the guide does not name “{word}”"
        return self.word(key)

    def press(self, key: str, where: Locator | None = None) -> None:
        (where or self.page).get_by_role("button", name=self.named(key), exact=True).click()

    def open(self, key: str) -> None:
        """By its link in the rail, or in the menu that takes the rail's place beside a large image."""
        link = self.page.get_by_role("link", name=re.compile(rf"^{self.named(key)}\b"))  # its state follows
        menu = self.page.locator(".crumbs").get_by_role("button")
        expect(link.or_(menu).first).to_be_visible()
        if not link.count():
            menu.click()
        link.first.click()
        expect(self.page.locator("h1")).to_have_text(self.word(key))

    def fill(self, where: Page | Locator, fields: Mapping[str, object]) -> None:
        for key, value in fields.items():
            where.get_by_label(self.word(key), exact=True).fill(str(value))

    def choose(self, where: Page | Locator, fields: Mapping[str, str]) -> None:
        for key, value in fields.items():
            where.get_by_label(self.word(key), exact=True).select_option(value)


# The way in English, without a guide, is that of test_journey.
@pytest.fixture(params=["fr", pytest.param("en", marks=pytest.mark.proof)])
def guide(
    request: pytest.FixtureRequest, browser: Browser, small_demonstration: Server, cookies: APIRequestContext
) -> Iterator[Guide]:
    context = browser_in(request.param, browser, small_demonstration, cookies.storage_state())
    yield Guide(request.param, context.new_page())
    context.close()


def browser_in(
    language: str, browser: Browser, server: Server, state: StorageState | None = None
) -> BrowserContext:
    return browser.new_context(
        base_url=server.url,
        locale=LOCALES[language],
        viewport={"width": 1440, "height": 900},
        storage_state=state,
    )


def test_the_guide_can_be_followed_to_the_package(
    guide: Guide, browser: Browser, small_demonstration: Server, tmp_path: Path, screenshots: Path
) -> None:
    survey_id = create_the_survey(guide)
    calibrate_the_camera(guide, tmp_path)
    add_the_recording(guide, survey_id, tmp_path)
    find_the_road(guide)
    heights = measure(guide, small_demonstration)
    review(guide, browser, small_demonstration, len(heights))
    read_the_results(guide, screenshots)
    place = hand_over(guide, tmp_path)
    look_at_the_package(guide, browser, place, screenshots)


def create_the_survey(guide: Guide) -> int:
    page = guide.page
    page.goto("/")
    expect(page.locator("h1")).to_have_text(guide.named("page-surveys"))
    guide.press("surveys-new")
    form = page.get_by_role("dialog")
    guide.fill(form, {"surveys-new-name": f"First survey {guide.language}"})
    guide.choose(form, {"traffic-side": "right", "traffic-steering": "left", "traffic-camera": "verge"})
    by_day = form.get_by_test_id("asked").locator(".row").filter(has_text=guide.word("lighting-daytime"))
    by_day.get_by_label(guide.word("target-taillight"), exact=True).check()
    form.get_by_role("button", name=guide.word("surveys-new-make"), exact=True).click()
    page.wait_for_url(re.compile(r"/surveys/\d+$"))
    return int(page.url.rpartition("/")[2])


def calibrate_the_camera(guide: Guide, place: Path) -> None:
    page = guide.page
    guide.open("page-camera")
    guide.press("camera-add-first")
    page.get_by_role("dialog").get_by_role("button", name=guide.word("action-add"), exact=True).click()
    guide.fill(page, {"camera-columns": 9, "camera-rows": 6, "camera-square": 30})
    expect(page.get_by_role("link", name=guide.named("camera-print"), exact=True)).to_be_visible()
    with page.expect_download() as download:
        page.locator("a[href='/api/samples/pictures.zip']").click()
    download.value.save_as(place / "images.zip")
    with zipfile.ZipFile(place / "images.zip") as archive:
        archive.extractall(place / "images")
    images = sorted((place / "images").iterdir())
    page.get_by_label(guide.word("camera-choose-pictures")).set_input_files(images)
    calibrate = page.get_by_role("button", name=guide.named("camera-calibrate"), exact=True)
    expect(calibrate).to_be_enabled()
    calibrate.click()
    expect(page.get_by_text(guide.word("camera-trusted"))).to_be_visible()


def add_the_recording(guide: Guide, survey_id: int, place: Path) -> None:
    page = guide.page
    guide.open("page-recordings")
    with page.expect_download() as download:
        page.get_by_role("link", name=guide.word("samples-clip"), exact=True).click()
    clip = place / download.value.suggested_filename
    download.value.save_as(clip)
    page.get_by_label(guide.word("recordings-choose")).set_input_files(clip)
    card = page.get_by_role("article")
    guide.choose(card, {"recordings-camera": camera_of(page, survey_id)})
    card.get_by_text(re.compile(guide.word("lighting-daytime"))).click()
    filmed = card.get_by_test_id("filmed")
    start = filmed.get_by_role("button")
    assert start.inner_text() in (guide.named("filmed-confirm"), guide.named("filmed-enter"))
    start.click()
    form = page.get_by_role("dialog")
    guide.fill(form, {"filmed-started": "2025-05-14T08:10:00"})
    form.get_by_role("button", name=guide.word("filmed-confirm-action"), exact=True).click()
    expect(form).to_have_count(0)
    # the search for vehicles starts by itself
    expect(card.get_by_test_id(re.compile("passes-of-"))).to_contain_text(re.compile(r"[1-9]"))


def camera_of(page: Page, survey_id: int) -> str:
    (camera,) = page.request.get(f"/api/surveys/{survey_id}/cameras").json()
    return str(camera["id"])


def find_the_road(guide: Guide) -> None:
    page = guide.page
    guide.open("page-pose")
    guide.fill(page, {"pose-columns": 6, "pose-rows": 9, "pose-square": 100})
    go_to_frame(page, REST_FRAME)
    page.get_by_test_id("pose-span-offer").get_by_role("button").click()
    page.get_by_text(guide.word("pose-reference-top"), exact=True).click()
    height = guide.word("pose-reference-height", {"reference": "top"})
    page.get_by_label(height, exact=True).fill("1,125" if guide.language == "fr" else "1.125")
    guide.press("pose-find")
    expect(page.get_by_test_id("road-overlay")).to_be_visible()
    expect(page.get_by_test_id("pose-verdict")).to_contain_text("±")


def measure(guide: Guide, server: Server) -> dict[str, float]:
    """The heights of one vehicle of the list, each as near to the truth as its interval says."""
    page = guide.page
    guide.open("page-measure")
    passes = scene_truth("day")["passes"]
    vehicles = page.request.get(f"/api{page.url.split(server.url)[1].split('/measure')[0]}/vehicles").json()
    vehicle, truth = next(
        (vehicle, one)
        for one in passes
        for vehicle in vehicles
        if whole_frames(one) and abs(vehicle["best_frame"] - one["best_frame"]) < 5
    )
    shown = whole_frames(truth)[0]
    open_pass(page, vehicle["number"])
    go_to_frame(page, shown["frame"])
    found: dict[str, float] = {}
    for target, key in KEYS.items():
        page.keyboard.press(key)
        if not found:
            click_at(page, shown["pixels"]["contact_rear"])
            expect(page.get_by_test_id("ladder")).to_be_visible()
        click_at(page, shown["pixels"][target])
        expect(page.get_by_test_id(f"measurement-row-{target}")).to_contain_text("±")
        found[target] = truth["true_heights_m"][target]
    expect(page.get_by_test_id("save-state")).to_contain_text(re.compile(r"\d\d:\d\d"))
    told = page.request.get(f"/api/vehicles/{vehicle['id']}").json()["measurements"]
    for one in told:
        assert abs(one["height_m"] - found[one["target"]]) <= one["U95_height_m"], one
    return found


def review(guide: Guide, browser: Browser, server: Server, heights: int) -> None:
    """By somebody who is invited and made a member."""
    page, survey = guide.page, re.search(r"/surveys/\d+", guide.page.url)
    assert survey
    name = f"Rosa {guide.language}"
    page.get_by_role("button", name=guide.word("app-admin"), exact=True).click()
    guide.open("page-people")
    page.get_by_role("button", name=guide.word("people-add"), exact=True).click()
    form = page.get_by_role("dialog")
    guide.fill(form, {"people-add-name": name, "people-add-email": f"rosa.{guide.language}@example.org"})
    guide.choose(form, {"people-add-role": "reviewer"})
    form.get_by_role("button", name=guide.word("people-add-action"), exact=True).click()
    link = page.get_by_label(guide.word("people-link"), exact=True).input_value()
    page.goto(survey[0])
    guide.open("page-settings")
    guide.press("members-open")
    form = page.get_by_role("dialog")
    form.get_by_label(guide.word("members-add-person"), exact=True).select_option(label=name)
    form.get_by_label(guide.word("members-add-role"), exact=True).select_option(
        label=guide.named("role-reviewer")
    )
    form.get_by_role("button", name=guide.word("members-add"), exact=True).click()
    theirs = guide.word("members-role-of", {"person": name})
    expect(form.get_by_label(theirs, exact=True)).to_have_value("reviewer")
    page.keyboard.press("Escape")

    context = browser_in(guide.language, browser, server)
    rosa = Guide(guide.language, context.new_page())
    rosa.page.goto(link)
    rosa.page.get_by_role("link", name=f"First survey {guide.language}").first.click()
    rosa.open("page-review")
    queue = rosa.page.request.get(f"/api{survey[0]}/review-queue").json()
    assert len(queue) == heights
    judged: set[int] = set()
    for count in range(1, heights + 1):
        judged.add(accept(rosa, queue, judged))
        counts = {"accepted": count, "rejected": 0, "count": heights}
        expect(rosa.page.get_by_test_id("review-counts")).to_contain_text(rosa.word("review-counts", counts))
    context.close()


def accept(theirs: Guide, queue: list[dict[str, Any]], judged: set[int]) -> int:
    """The height that is open once another one is; one that is drawn blind is clicked again first."""
    page = theirs.page
    row = page.locator("[data-measurement][aria-current=true]")

    def opened() -> int | None:
        number = int(row.get_attribute("data-measurement") or 0)
        return None if number in judged else number

    of = wait_until(page, opened)
    (first,) = [one["measurement"] for one in queue if one["measurement"]["id"] == of]
    if row.get_by_text(theirs.named("review-blind-click")).count():
        expect(page.get_by_test_id("blind-panel")).to_be_visible()
        click_at(page, first["contact"])
        click_at(page, first["target_point"])
        expect(page.get_by_test_id("comparisons")).to_be_visible()
    page.get_by_test_id("review-accept").click()
    return of


def read_the_results(guide: Guide, screenshots: Path) -> None:
    guide.open("page-statistics")
    conclusion = guide.page.get_by_test_id("conclusion")
    expect(conclusion.locator("li").first).to_be_visible()
    guide.page.screenshot(path=screenshots / f"guide-results-{guide.language}.png")


def hand_over(guide: Guide, place: Path) -> Path:
    """The package, unpacked."""
    page = guide.page
    guide.open("page-export")
    guide.press("export-build")
    with page.expect_download() as download:
        page.get_by_role("link", name=guide.word("export-download"), exact=True).click()
    download.value.save_as(place / "package.zip")
    with zipfile.ZipFile(place / "package.zip") as archive:
        archive.extractall(place / "package")
    if guide.language != "en":  # what is verified of an English one is in tests/export
        verified = verify_package(FolderFiles(place / "package"))
        assert verified.ok, verified.problem
    assert json.loads((place / "package/datapackage.json").read_text())["language"] == guide.language
    return place / "package"


def look_at_the_package(guide: Guide, browser: Browser, place: Path, screenshots: Path) -> None:
    """Its page opens in the package's language, without a server, and finds nothing wrong."""
    context = browser.new_context(viewport={"width": 1440, "height": 900}, offline=True)
    page = context.new_page()
    page.goto(f"file://{place}/index.html")
    expect(page.locator("html[data-checked=true]")).to_be_attached()
    expect(page.locator("[data-verdict]")).to_have_attribute("data-verdict", "fine")
    assert page.locator("html").get_attribute("lang") == guide.language
    page.screenshot(path=screenshots / f"guide-package-{guide.language}.png")
    if guide.language != "en":
        known = Catalogues(guide.language)
        assert [one for one in page.evaluate(SHOWN) if known.is_english(one)] == []
    context.close()
