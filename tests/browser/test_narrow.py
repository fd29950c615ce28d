"""What stays readable where there is little room: words beside their buttons, whole and not under them."""

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Locator, Page, Route, StorageState, expect

from .server import Server
from .test_screens import columns_out_of_sight, overflows, settle

SIZES = ((1024, 768), (1440, 900))


def box(of: Locator) -> tuple[float, float, float, float]:
    """Left, top, right, bottom in pixels of the screen."""
    found = of.bounding_box()
    assert found is not None
    return found["x"], found["y"], found["x"] + found["width"], found["y"] + found["height"]


def apart(one: Locator, other: Locator) -> bool:
    (left, top, right, bottom), (left2, top2, right2, bottom2) = box(one), box(other)
    return right <= left2 + 0.5 or right2 <= left + 0.5 or bottom <= top2 + 0.5 or bottom2 <= top + 0.5


def is_whole(of: Locator) -> bool:
    """Whether none of it is cut off by its own edge."""
    return bool(of.evaluate("one => one.scrollWidth <= one.clientWidth"))


def out_of_the_sample_and_at_work(page: Page, survey_id: int) -> None:
    """Every pass is out of the sample, and proposals are being made: as the server would say it."""
    job = {"id": 999, "survey_id": survey_id, "kind": "proposals", "state": "running", "progress": 0.3}
    message = {"code": "proposals-looking", "values": {}, "message": "Searching for points to suggest."}
    job |= {"message": message, "result": None, "error": None, "cancellable": True}

    def answer(route: Route, change: dict[str, Any]) -> None:
        given = route.fetch()
        route.fulfill(response=given, json=[{**one, **change} for one in given.json()])

    state = {"state": "out_of_sample", "origin": "found"}
    page.route(re.compile(r"/api/surveys/\d+/vehicles"), lambda route: answer(route, state))
    page.route(re.compile(r"/api/surveys/\d+/recordings$"), lambda route: answer(route, {"job": job}))
    page.route(re.compile(r"/api/jobs/999"), lambda route: route.fulfill(json=job))


def with_one_camera(page: Page) -> int:
    """A survey of this test's own; other tests add cameras to the demonstration."""
    headers = {"X-Sightline": "1"}
    survey_id = int(page.request.post("/api/surveys", headers=headers, data={"name": "Narrow"}).json()["id"])
    made = page.request.post(
        f"/api/surveys/{survey_id}/cameras", headers=headers, data={"name": "The only one"}
    )
    assert made.ok, made.text()
    return survey_id


@pytest.mark.parametrize("size", SIZES)
def test_words_are_neither_cut_nor_covered(
    page: Page, survey_id: int, size: tuple[int, int], screenshots: Path
) -> None:
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.goto(f"/surveys/{with_one_camera(page)}/camera")
    expect(page.get_by_test_id("camera-name")).to_have_text("The only one")
    page.locator("header.topbar, .topbar").get_by_role("button").last.click()
    labels = page.locator(".menu__choice .field__label").all()
    assert labels
    for label in labels:
        assert is_whole(label), label.inner_text()
        assert apart(label, label.locator("xpath=following-sibling::*").first)
    page.screenshot(path=screenshots / f"narrow-menu-{size[0]}.png")

    out_of_the_sample_and_at_work(page, survey_id)
    page.goto(f"/surveys/{survey_id}/measure")
    said = page.get_by_text("Searching for points to suggest.")
    expect(said).to_be_visible()
    cancel = page.locator(".propose").get_by_role("button", name="Cancel")
    assert apart(said, cancel)
    list_right = box(page.locator(".passes"))[2]
    for mark in page.locator(".pass__state .mark").all()[:3]:
        words = mark.locator("span")
        assert is_whole(mark) and box(words)[2] <= list_right
        assert apart(words, mark.locator("xpath=ancestor::button").locator(".pass__way").first)
    delete = page.locator(".vehicle__head").get_by_role("button")
    assert box(delete)[2] <= size[0]
    page.screenshot(path=screenshots / f"narrow-measure-{size[0]}.png")


#: Pages that are read more than worked on: they do at 320 px, which is 1280 px at 400 %.
READ = (
    *("/", "/guide", "/guide?page=access", "/guide?page=formats", "/account", "/people", "/audit", "/jobs"),
    *("/catalogue", "/studies", "/system", "/surveys/{survey}", "/surveys/{survey}/export"),
)


#: A package with everything that its row may say, as the server would tell it.
PACKAGE = {
    "id": 1,
    "created_at": "2026-11-28T12:34:56+00:00",
    "created_by": {"id": 1, "name": "Demonstration operator"},
    "size_bytes": 999_400_000,
    "sha256": "0123456789abcdef" * 4,
    "audit_count": 1000,
    "audit_head": "fedcba9876543210" * 4,
    "selection": {
        "lighting": "low_light",
        "class_sets": ["cars"],
        "categories": [],
        "filmed_from": "2026-05-01",
        "filmed_to": "2026-05-31",
        "hour_from": None,
        "hour_to": None,
    },
    "language": "fr",
    "signing_key": "0123456789abcdef" * 4,
    "url": "/api/exports/1.zip",
    "filename": "package.zip",
    "since": {"heights": 0, "reviews": 0, "other": 0},
}


@pytest.mark.parametrize("locale", ["en-GB", "fr-FR"])
def test_tables_that_are_opened_later_show_each_column(
    browser: Browser,
    demonstration: Server,
    admin_state: StorageState,
    survey_id: int,
    screenshots: Path,
    locale: str,
) -> None:
    """As those do that a screen shows at once: every screen is looked at for it (`test_screens.look_at`)."""
    context = browser.new_context(
        base_url=demonstration.url,
        storage_state=admin_state,
        locale=locale,
        viewport={"width": 1024, "height": 768},
        bypass_csp=True,
    )
    page = context.new_page()
    page.route(re.compile(r"/api/surveys/\d+/exports$"), lambda route: route.fulfill(json=[PACKAGE]))
    page.goto(f"/surveys/{survey_id}/export")
    expect(page.locator("main table td code").first).to_be_visible()
    wrong = columns_out_of_sight(page)
    page.screenshot(path=screenshots / f"narrow-export-{locale}.png")
    page.goto("/system")
    page.locator("main section").last.get_by_role("button").click()
    expect(page.locator("main table").nth(1)).to_be_visible()
    wrong += columns_out_of_sight(page)
    page.screenshot(path=screenshots / f"narrow-system-{locale}.png")
    assert not wrong, "\n".join(wrong)

    page.add_style_tag(content="td { min-width: 400px } th:last-child { display: none }")
    assert any("runs" in one for one in columns_out_of_sight(page))
    assert any("leaves out" in one for one in columns_out_of_sight(page))
    # and where a table must be wider, all of it is reached by keyboard, and a shadow tells that there is more
    scrolls = page.locator("main .table-scroll").first
    expect(scrolls).to_have_attribute("tabindex", "0")
    expect(scrolls).to_have_attribute("aria-label", re.compile("."))
    expect(scrolls).not_to_have_css("box-shadow", "none")
    context.close()


#: What makes the page itself scroll sideways, rather than a table within it.
BEYOND_MAIN = """() => {
  const main = document.querySelector("main"), edge = main.getBoundingClientRect().right + 1;
  const scrolls = e => e !== main && (/auto|scroll|hidden/.test(getComputedStyle(e).overflowX)
    || (e.parentElement && scrolls(e.parentElement)));
  if (main.scrollWidth <= main.clientWidth + 1) return [];
  return [...main.querySelectorAll("*")]
    .filter(e => e.getBoundingClientRect().right > edge && !scrolls(e.parentElement))
    .slice(0, 4).map(e => `${e.textContent.slice(0, 40)} ${e.outerHTML.slice(0, 120)}`);
}"""


def test_pages_that_are_read_do_at_320_pixels(page: Page, survey_id: int, screenshots: Path) -> None:
    """Nothing runs out at the side (WCAG 1.4.10); wide tables scroll by themselves."""
    page.set_viewport_size({"width": 320, "height": 640})
    wrong = []
    for address in READ:
        page.goto(address.format(survey=survey_id))
        expect(page.locator("main h1").first).to_be_visible()
        settle(page)
        wrong += [f"{address}: {one}" for one in overflows(page)]
        wrong += [f"{address}: the page scrolls sideways: {one}" for one in page.evaluate(BEYOND_MAIN)]
        if not apart(page.locator(".crumbs"), page.locator(".topbar > a.btn")):
            wrong.append(f"{address}: where you are stands under the tools")
    page.screenshot(path=screenshots / "export-320.png")
    assert not wrong, "\n".join(wrong)
