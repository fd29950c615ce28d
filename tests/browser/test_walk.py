"""A walk through the whole app by its links: what a link, Back or Forward shows is what a reload shows.

From the survey list to every screen of the rail and every link within a page, forth and back. A page that
remembers too much or too little of where it was, a focus left behind, a question that fails and a complaint
of the browser's all end the walk.
"""

import difflib
import re
import time
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, replace
from urllib.parse import parse_qsl, urlsplit

import pytest
from playwright.sync_api import BrowserContext, ConsoleMessage, Page, Request, Response, expect

from .conftest import wait_for_demonstration

# Parts of a page that tell the time, and why they differ between two looks at the same page.
TIMES = {
    r"\bsaved \d\d:\d\d(:\d\d)?": "the clock of the last change, which a page just loaded does not know",
}

# Counts what the page asks for, and notes when it or its address last changed: it is at rest when nothing is
# asked and nothing has changed for longer than the app itself waits before it writes an address (250 ms).
WATCH = """
  window.asking = 0;
  const changed = () => { window.changedAt = performance.now(); };
  changed();
  const ask = window.fetch;
  window.fetch = async (...words) => {
    const of = String(words[0]?.url ?? words[0]);
    // pictures are fetched ahead for as long as there are neighbours; what is written does not wait for them
    const counts = !/frames[/]/.test(of);
    window.asking += counts ? 1 : 0;
    try { return await ask(...words); } finally { window.asking -= counts ? 1 : 0; }
  };
  for (const name of ["pushState", "replaceState"]) {
    const go = history[name].bind(history);
    history[name] = (...step) => { changed(); go(...step); };
  }
  window.addEventListener("popstate", changed);
  new MutationObserver(changed).observe(document, { subtree: true, childList: true, characterData: true });
"""
AT_REST = """() => window.asking === 0 && performance.now() - window.changedAt > 400
  && document.querySelector("#main h1, .page--bare h1") !== null
  && document.querySelector(".loading, .frame-loading--on") === null
  && ![...document.querySelectorAll(".spinner")].some(s => s.checkVisibility({opacityProperty: true}))"""
# What is written, and what stands in the fields.
SHOWN = """() => {
  const main = document.getElementById("main");
  const fields = [...main.querySelectorAll("input, select, textarea")].map(
    (field) => /checkbox|radio/.test(field.type) ? String(field.checked) : field.value);
  const crumbs = document.querySelector(".crumbs").innerText;
  return {
    address: location.pathname + location.search,
    title: document.title,
    heading: main.querySelector("h1")?.innerText ?? "",
    words: [crumbs, main.innerText, ...fields].join("\\n"),
  };
}"""
LINKS = """() => [...document.querySelectorAll("a[href^='/']")]
  .filter((link) => link.checkVisibility() && !link.download && !link.target)
  .map((link) => link.getAttribute("href")).filter((to) => !to.startsWith("/api/"))"""


# What has to be reached by links alone, so that the walk cannot become shorter unseen.
SCREENS_BY_LINK = {"/", "/account", "/guide", "/statistics", "/audit", "/surveys/1"} | {
    f"/surveys/1/{name}"
    for name in (
        *("planning", "camera", "recordings", "pose", "measure", "checks", "review", "repeats"),
        *("repeats/click", "scans", "scans/results", "scan", "export"),
    )
}


@dataclass(frozen=True)
class Shown:
    """What a person sees of a page."""

    address: str
    title: str
    heading: str
    words: str


@pytest.fixture
def complaints() -> list[str]:
    return []


@pytest.fixture
def walker(context: BrowserContext, complaints: list[str]) -> Iterator[Page]:
    """A page that keeps the browser's complaints and the answers that are none."""
    context.add_init_script(WATCH)
    page = context.new_page()
    page.set_default_timeout(30_000)

    def said(message: ConsoleMessage) -> None:
        if message.type in ("error", "warning"):
            complaints.append(f"{page.url}: console {message.type}: {message.text}")

    def failed(request: Request) -> None:
        # a page that is left takes back what it has asked for
        if request.failure != "net::ERR_ABORTED":
            complaints.append(f"{page.url}: {request.url} failed: {request.failure}")

    def answered(response: Response) -> None:
        if response.status >= 400:
            complaints.append(f"{page.url}: {response.url} answers {response.status}")

    page.on("pageerror", lambda error: complaints.append(f"{page.url}: {error}"))
    page.on("console", said)
    page.on("requestfailed", failed)
    page.on("response", answered)
    yield page


def begin(page: Page) -> int:
    """The demonstration survey, once no job changes what its pages say."""
    page.goto("/")
    survey = wait_for_demonstration(page)
    until = time.monotonic() + 120.0
    while any(page.request.get(f"/api/jobs?state={state}").json() for state in ("queued", "running")):
        assert time.monotonic() < until, "the demonstration's jobs take too long"
        page.wait_for_timeout(500)
    return survey


def shown(page: Page) -> Shown:
    """The page once it is at rest, without what tells the time."""
    page.wait_for_function(AT_REST)
    seen = Shown(**page.evaluate(SHOWN))
    words = seen.words
    for pattern in TIMES:
        words = re.sub(pattern, "", words)
    return replace(seen, words=words)


def path_of(address: str) -> str:
    return address.split("?")[0]


def arrived(page: Page, before: Shown) -> Shown:
    """What is shown after a step; on another page the heading has the focus."""
    now = shown(page)
    if path_of(now.address) != path_of(before.address):
        expect(page.locator("#main h1").first).to_be_focused()
    return now


def same(page: Page, now: Shown, then: Shown, step: str) -> None:
    """What is shown becomes what was shown before; a busy machine may rest in the middle of drawing it."""
    until = time.monotonic() + 10.0
    while now != then and time.monotonic() < until:
        page.wait_for_timeout(200)
        now = shown(page)
    told = difflib.unified_diff(lines_of(then), lines_of(now), "shown before", step, lineterm="", n=1)
    assert now == then, "\n".join(told)


def lines_of(page: Shown) -> list[str]:
    return [page.address, page.title, page.heading, *page.words.splitlines()]


def there_and_back(page: Page, start: Shown, link: str) -> Shown:
    """Click a link, go back and forth, reload: the same each time. What is shown behind the link."""
    page.locator(f'a[href="{link}"]:visible').first.click()
    there = arrived(page, start)
    assert asked_by(link) <= asked_by(there.address), f"{link} leads to {there.address}"
    page.go_back()
    same(page, arrived(page, there), start, f"back from {link}")
    page.go_forward()
    same(page, arrived(page, start), there, f"forward to {link}")
    page.reload()
    same(page, shown(page), there, f"reload of {link}")
    return there


def asked_by(address: str) -> set[tuple[str, str]]:
    return set(parse_qsl(urlsplit(address).query))


def shape(link: str) -> tuple[str, frozenset[str]]:
    """A link's page and what it asks of it, without the values."""
    return path_of(link), frozenset(name for name, _ in asked_by(link))


def of_another_survey(link: str) -> bool:
    """Surveys that other tests made stand in any state, some with work that never ends."""
    return re.match(r"/surveys/(?!1\b)", link) is not None


def test_every_link_forth_and_back_shows_what_a_reload_shows(walker: Page, complaints: list[str]) -> None:
    begin(walker)
    ways, known = deque(["/"]), {"/"}
    shapes: set[object] = {shape("/")}
    while ways:
        here = ways.popleft()
        walker.goto(here)
        start = shown(walker)
        for link in dict.fromkeys(walker.evaluate(LINKS)):
            # a link to the page itself is walked from each page: it may keep what it should forget. The guide
            # keeps nothing, and its sections are places of pages that are walked.
            within = path_of(link) == path_of(here) != "/guide" and link != here
            if path_of(link) == "/guide" and "section=" in link:
                continue
            # of a list's links to the same page, the first stands for all
            walked = (path_of(here), shape(link)) if within else shape(link)
            if walked in shapes or of_another_survey(link):
                continue
            shapes.add(walked)
            if link not in known:
                ways.append(link)
            known.add(link)
            there_and_back(walker, start, link)
            walker.goto(here)
            start = shown(walker)
    assert {path_of(link) for link in known} >= SCREENS_BY_LINK
    assert not complaints, "\n".join(complaints)


def test_menus_of_the_bar_lead_where_a_reload_stays(walker: Page, complaints: list[str]) -> None:
    survey = begin(walker)
    ways = [("/", "account and settings", name) for name in ("Account", "People", "Audit trail")]
    ways += [(f"/surveys/{survey}/measure", "go to another step", name) for name in ("Review", "Checks")]
    for here, menu, name in ways:
        walker.goto(here)
        start = shown(walker)
        walker.get_by_role("button", name=re.compile(menu)).click()
        walker.locator(".menu__item").get_by_text(name, exact=True).click()
        there = arrived(walker, start)
        walker.go_back()
        same(walker, arrived(walker, there), start, f"back from {name}")
        walker.go_forward()
        same(walker, arrived(walker, start), there, f"forward to {name}")
        walker.reload()
        same(walker, shown(walker), there, f"reload of {name}")
    assert not complaints, "\n".join(complaints)


def test_what_is_chosen_within_a_page_is_in_its_address(walker: Page, complaints: list[str]) -> None:
    """Each measured vehicle, each vehicle of the line scan, the tabs and the review's queue."""
    survey = begin(walker)
    vehicles = walker.request.get(f"/api/surveys/{survey}/vehicles").json()
    measured = [one["number"] for one in vehicles if one["measurements"]]
    scan = walker.request.get(f"/api/surveys/{survey}/scans").json()[0]["id"]
    passed = walker.request.get(f"/api/scans/{scan}/vehicles").json()
    assert measured and passed
    choices = {
        "measure": [f"[data-testid=pass-{number}]" for number in measured],
        f"scan?scan={scan}": [f"[data-testid=scan-vehicle-{one['number']}] button" for one in passed],
        "checks": ['.page__head label:has-text("Direction")'],
        "planning": ['.page__head label:has-text("line scan")'],
        "review": ["[data-measurement]:not([aria-current])"],
    }
    for name, chosen in choices.items():
        walker.goto(f"/surveys/{survey}/{name}")
        shown(walker)
        for one in chosen:
            walker.locator(one).first.click()
            there = shown(walker)
            walker.reload()
            same(walker, shown(walker), there, f"reload of {one}")
    assert not complaints, "\n".join(complaints)
