"""A walk through the app's pages: when a page is at rest, what it shows, whether that is as it was before."""

import difflib
import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from urllib.parse import parse_qsl, urlsplit

from playwright.sync_api import BrowserContext, ConsoleMessage, Page, Request, Response, expect

from tests.support.waiting import NEVER_S

from .conftest import wait_for_demonstration
from .waits import wait_until

# Parts of a page that tell the time, and why they differ between two looks at the same page.
TIMES = {
    r"\bsaved \d\d:\d\d(:\d\d)?": "the clock of the last change, which a page just loaded does not know",
    r"\bjust now\b|\b\d+ min ago\b": "how long ago somebody signed in, which grows by the minute",
}

# Counts what the page asks for and what it has put off by less than a second (an address is written 250 ms
# late), and notes when it or its address last changed.
WATCH = """
  window.asking = 0;
  window.putOff = new Set();
  window.changed = () => { window.changedAt = performance.now(); window.drawn = 0; };
  changed();
  const ask = window.fetch;
  window.fetch = async (...words) => {
    const of = String(words[0]?.url ?? words[0]);
    // pictures are fetched ahead for as long as there are neighbours; what is written does not wait for them
    const counts = !/frames[/]/.test(of);
    window.asking += counts ? 1 : 0;
    try { return await ask(...words); } finally { window.asking -= counts ? 1 : 0; }
  };
  // an answer is read after it has come
  for (const name of ["json", "text"]) {
    const read = Response.prototype[name];
    Response.prototype[name] = async function () {
      window.asking += 1;
      try { return await read.call(this); } finally { window.asking -= 1; }
    };
  }
  const later = window.setTimeout.bind(window), never = window.clearTimeout.bind(window);
  window.setTimeout = (run, ms = 0, ...words) => {
    if (ms >= 1000) return later(run, ms, ...words);
    const timer = later(() => { window.putOff.delete(timer); run(...words); }, ms);
    window.putOff.add(timer);
    return timer;
  };
  window.clearTimeout = (timer) => { window.putOff.delete(timer); never(timer); };
  for (const name of ["pushState", "replaceState"]) {
    const go = history[name].bind(history);
    history[name] = (...step) => { changed(); go(...step); };
  }
  window.addEventListener("popstate", changed);
  new MutationObserver(changed).observe(document, { subtree: true, childList: true, characterData: true });
"""
# What is written, and what stands in the fields, once the page is at rest: nothing is asked or put off, and
# nothing changed for 60 ms in which it was drawn twice. `twice`: once two such looks in a row agree.
SHOWN = """(twice) => {
  const rests = window.asking === 0 && window.putOff.size === 0 && performance.now() - window.changedAt > 60
    && document.querySelector("#main h1, .page--bare h1") !== null
    && document.querySelector(".loading, .frame-loading--on, [data-testid=axes-awaited]") === null
    && [...document.querySelectorAll(".stat-figure__box:empty")].every(box => box.clientWidth < 200)
    && ![...document.querySelectorAll(".spinner")].some(s => s.checkVisibility({opacityProperty: true}));
  if (!rests) window.drawn = 0;
  if (!rests || ++window.drawn < 3) return null;  // asked once a frame
  const main = document.getElementById("main");
  const fields = [...main.querySelectorAll("input, select, textarea")].map(
    (field) => /checkbox|radio/.test(field.type) ? String(field.checked) : field.value);
  const crumbs = document.querySelector(".crumbs").innerText;
  const shown = {
    address: location.pathname + location.search,
    title: document.title,
    heading: main.querySelector("h1")?.innerText ?? "",
    words: [crumbs, main.innerText, ...fields].join("\\n"),
  };
  const before = window.seen, now = JSON.stringify(shown);
  const settled = !twice || before === now;
  window.seen = settled ? null : now;
  if (!settled) changed();
  return settled ? shown : null;
}"""


@dataclass(frozen=True)
class Shown:
    """What a person sees of a page."""

    address: str
    title: str
    heading: str
    words: str


@contextmanager
def walking(context: BrowserContext) -> Iterator[Page]:
    """A page for a walk, which must end without a complaint of the browser's or an answer that is none."""
    complaints: list[str] = []
    page = context.new_page()
    page.add_init_script(WATCH)

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
    assert not complaints, "\n".join(complaints)


def begin(page: Page) -> int:
    """The demonstration survey, once no job changes what its pages say."""
    survey = wait_for_demonstration(page)

    def working() -> bool:
        return any(page.request.get(f"/api/jobs?state={state}").json() for state in ("queued", "running"))

    wait_until(page, lambda: not working(), lambda: "the demonstration's jobs do not end")
    return survey


def shown(page: Page, *, twice: bool = False) -> Shown:
    """The page once it is at rest, less what tells the time; `twice` for a look that others are held to."""
    seen = Shown(**page.wait_for_function(SHOWN, arg=twice).json_value())
    words = seen.words.replace("\xa0", " ")  # the server writes "14 mm" with another space than the pages
    for pattern in TIMES:
        words = re.sub(pattern, "", words)
    return replace(seen, words=words)


def path_of(address: str) -> str:
    return address.split("?")[0]


def arrived(page: Page, before: Shown, *, twice: bool = False) -> Shown:
    """What is shown after a step; on another page the heading has the focus."""
    now = shown(page, twice=twice)
    if path_of(now.address) != path_of(before.address):
        expect(page.locator("#main h1").first).to_be_focused()
    return now


def same(page: Page, now: Shown, then: Shown, step: str) -> None:
    """What is shown becomes what was shown before; a busy machine may rest in the middle of drawing it."""
    until = time.monotonic() + NEVER_S
    while now != then and time.monotonic() < until:
        page.wait_for_timeout(200)
        now = shown(page)
    told = difflib.unified_diff(lines_of(then), lines_of(now), "shown before", step, lineterm="", n=1)
    assert now == then, "\n".join(told)


def lines_of(page: Shown) -> list[str]:
    return [page.address, page.title, page.heading, *page.words.splitlines()]


def there_and_back(page: Page, start: Shown, step: Callable[[], None], name: str) -> Shown:
    """Take a step, go back and forth, reload, go back: the same each time. What is shown after the step."""
    there = there_and_loaded(page, start, step, name)
    back_from(page, start, there, name)
    return there


def there_and_loaded(page: Page, start: Shown, step: Callable[[], None], name: str) -> Shown:
    """Take a step, go back and forth, reload: the same each time. What is shown; the page stays there."""
    step()
    there = arrived(page, start, twice=True)
    back_from(page, start, there, name)
    page.go_forward()
    same(page, arrived(page, start), there, f"forward to {name}")
    return reloaded(page, there, name)


def reloaded(page: Page, there: Shown, name: str) -> Shown:
    """Reload: the same once more."""
    page.reload()
    same(page, shown(page), there, f"reload of {name}")
    return there


def back_from(page: Page, start: Shown, there: Shown, name: str) -> None:
    """Go back to where a step began: the same as before it."""
    page.go_back()
    same(page, arrived(page, there), start, f"back from {name}")


def asked_by(address: str) -> set[tuple[str, str]]:
    return set(parse_qsl(urlsplit(address).query))
