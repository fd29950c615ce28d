"""Every screen, light and dark, at two sizes: no error, no sideways overflow, nothing in axe."""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Literal, cast
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import (
    APIRequestContext,
    Browser,
    BrowserContext,
    ConsoleMessage,
    Page,
    StorageState,
    ViewportSize,
    expect,
)

from .conftest import choose_plan
from .server import ROOT, Server

AXE = ROOT / "frontend" / "node_modules" / "axe-core" / "axe.min.js"
SIZES: list[ViewportSize] = [{"width": 1440, "height": 900}, {"width": 1024, "height": 768}]
LOOKS: list[Literal["light", "dark"]] = ["light", "dark"]

# The screen's name, its address, and what has to be seen before it counts as shown.
SCREENS = {
    "surveys": ("/", "main h1"),
    "survey": ("/surveys/{survey}", "main h1"),
    "planning": ("/surveys/{survey}/planning", "[data-testid=figure-plan-distance] svg"),
    "line-rate": ("/surveys/{survey}/planning?plan=lines", "[data-testid=line-plan]"),
    "camera": ("/surveys/{survey}/camera", ".shot img"),
    "recordings": ("/surveys/{survey}/recordings", "article.recording"),
    "pose": ("/surveys/{survey}/pose", "[data-testid=pose-verdict]"),
    "measure": (
        "/surveys/{survey}/measure?recording={recording}&vehicle={vehicle}&frame={frame}",
        "[data-testid=axes]",
    ),
    "checks": ("/surveys/{survey}/checks", "[data-testid=inset-drawing]"),
    "checks-traffic": ("/surveys/{survey}/checks?tab=traffic", "[data-testid=wheel-pair]"),
    "review": ("/surveys/{survey}/review", "[data-testid=review-counts]"),
    "lots": ("/surveys/{survey}/lots", "[data-testid=lots-draw]"),
    "settings": ("/surveys/{survey}/settings", "[data-testid=sample]"),
    "history": ("/surveys/{survey}/history", "main table"),
    "repeats": ("/surveys/{survey}/repeats", "[data-testid=figure-repeats] svg"),
    "click-again": ("/surveys/{survey}/repeats/click?of=all", "[data-testid=again-progress]"),
    "scans": ("/surveys/{survey}/scans", "article.scan-card img"),
    "scan-results": ("/surveys/{survey}/scans/results", "[data-testid=figure-scan-speed] svg"),
    "live": ("/surveys/{survey}/live", ".live-command"),
    "scan": ("/surveys/{survey}/scan?scan=1&vehicle=2", "[data-testid=figure-speed-profile-2] svg"),
    "export": ("/surveys/{survey}/export", "main h1"),
    "statistics": ("/statistics?survey={survey}&state=all", "[data-testid=figure-driver_eye-ecdf] svg"),
    "errors": (
        "/statistics?survey={survey}&state=all&tab=errors",
        "[data-testid=figure-absolute-error-ecdf] svg",
    ),
    "sight-distance": ("/sight-distance?survey={survey}&state=all", "[data-testid=figure-crest-k] svg"),
    "studies": ("/studies", "main h1"),
    "catalogue": ("/catalogue", "[data-testid=catalogue]"),
    "audit": ("/audit", "main table"),
    "jobs": ("/jobs", "main h1"),
    "system": ("/system", "main h1"),
    "people": ("/people", "main table"),
    "account": ("/account", "main h1"),
}


@pytest.fixture(scope="module")
def places(admin: APIRequestContext, survey_id: int) -> dict[str, int]:
    """The demonstration survey and a measured vehicle of it."""
    vehicles = admin.get(f"/api/surveys/{survey_id}/vehicles").json()
    measured = next(v for v in vehicles if len(v["measurements"]) >= 3)
    frame = measured["measurements"][0]["frame"]
    return {
        "survey": survey_id,
        "recording": measured["recording_id"],
        "vehicle": measured["id"],
        "frame": frame,
    }


@pytest.fixture
def complaints() -> list[str]:
    return []


Variants = list[tuple[ViewportSize, Literal["light", "dark"]]]
EACH_ONCE: Variants = list(zip(SIZES, LOOKS, strict=True))
EVERY: Variants = [(size, look) for size in SIZES for look in LOOKS]


@pytest.fixture
def shown(
    browser: Browser, demonstration: Server, complaints: list[str]
) -> Iterator[tuple[BrowserContext, Page]]:
    """A fresh, signed-out context, without the CSP that would keep axe out."""
    context = browser.new_context(base_url=demonstration.url, bypass_csp=True, reduced_motion="reduce")
    context.add_init_script(path=AXE)
    page = context.new_page()
    page.on("pageerror", lambda error: complaints.append(f"page error: {error}"))
    page.on("console", lambda message: note(message, complaints))
    yield context, page
    context.close()


FOLLOW = """(to) => {
  document.querySelector("#main h1, .page--bare h1").dataset.before = "";
  const link = Object.assign(document.createElement("a"), { href: to });
  document.body.append(link);
  link.click();
  link.remove();
}"""


def open_screen(page: Page, address: str, sign: str) -> None:
    """The screen at an address, by a link as within the app: only the first is loaded with the whole app."""
    at = urlsplit(page.url).path
    if at in ("blank", "/sign-in") or at == urlsplit(address).path:
        page.goto(address)
    else:
        page.evaluate(FOLLOW, address)
        expect(page.locator("h1[data-before]")).to_have_count(0)
    expect(page.locator(sign).first).to_be_visible()


def note(message: ConsoleMessage, complaints: list[str]) -> None:
    asked_who = "/api/session" in str(message.location.get("url")) and "401" in message.text
    if message.type in ("error", "warning") and not asked_who:
        complaints.append(f"console {message.type}: {message.text} ({message.location.get('url')})")


def look_at(page: Page, name: str, variant: str, folder: Path) -> list[str]:
    """What is wrong with the page as it stands, but for axe; its picture goes to `folder`."""
    settle(page)
    page.screenshot(path=folder / f"{name}-{variant}.png")
    seen = overflows(page) + clipped_away(page) + columns_out_of_sight(page) + squeezed(page)
    return [f"{name} {variant}: {one}" for one in seen]


def look_at_all(page: Page, name: str, folder: Path, variants: Variants, rows: int) -> list[str]:
    """What is wrong with the page at each size and look, which it is changed to as a window is.

    All of axe's rules are asked at the look that comes first; then, where all rows are gone through, those
    alone that another look can break. Half of the screens are dark at first.
    """
    wrong, rules = [], ALL_RULES
    for size, look in variants:
        page.set_viewport_size(size)
        page.emulate_media(color_scheme=look, reduced_motion="reduce")
        wrong += look_at(page, name, f"{size['width']}-{look}", folder)
        wrong += [f"{name} {look}: axe {one}" for one in findings(page, rules, rows)] if rules else []
        rules = RULES_OF_A_LOOK if rows == ALL_ROWS else ()
    return wrong


# A size that changed reaches a figure two frames later, and its drawing a third.
STANDS = """() => new Promise((stands) => {
  let frames = 0;
  const watch = new MutationObserver(() => { frames = 0; });
  watch.observe(document, { subtree: true, childList: true, attributes: true, characterData: true });
  const next = () => {
    frames += 1;
    if (frames <= 4) return requestAnimationFrame(next);
    watch.disconnect();
    stands();
  };
  requestAnimationFrame(next);
})"""


def settle(page: Page) -> None:
    expect(page.locator(".loading")).to_have_count(0)
    page.wait_for_function(
        "![...document.querySelectorAll('.spinner')].some(s => s.checkVisibility({opacityProperty: true}))"
    )
    page.wait_for_function(
        "[...document.images].filter(i => i.loading !== 'lazy').every(i => i.complete)"
        " && document.fonts.status === 'loaded'"
    )
    page.evaluate(STANDS)


def overflows(page: Page) -> list[str]:
    """Elements that make the page scroll sideways."""
    found: list[str] = page.evaluate(
        """() => {
          const root = document.documentElement, width = root.clientWidth;
          if (root.scrollWidth <= width && document.body.scrollWidth <= width) return [];
          return [...document.querySelectorAll('body *')]
            .filter(e => e.getBoundingClientRect().right > width + 1)
            .slice(0, 5).map(e => `runs out at the side: ${e.tagName}.${e.className}`);
        }"""
    )
    return found


def clipped_away(page: Page) -> list[str]:
    """Words that are there and cannot be seen, other than those meant for screen readers alone."""
    found: list[str] = page.evaluate(
        """() => [...document.querySelectorAll('body *')]
          .filter(e => getComputedStyle(e).clipPath === 'inset(50%)'
            && !e.matches('.visually-hidden'))
          .slice(0, 5).map(e => `cannot be seen: ${e.tagName} ${e.textContent}`)"""
    )
    return found


def squeezed(page: Page) -> list[str]:
    """Icons of buttons that their words leave no room for."""
    found: list[str] = page.evaluate(
        """() => [...document.querySelectorAll('.btn > svg[width]')]
          .filter(e => e.checkVisibility() && e.getBoundingClientRect().width < e.width.baseVal.value - 1)
          .slice(0, 5).map(e => `no room for the icon of: ${e.parentElement.textContent}`)"""
    )
    return found


def columns_out_of_sight(page: Page) -> list[str]:
    """Tables of which a column is left out, or lies where only scrolling sideways brings it."""
    found: list[str] = page.evaluate(
        """() => [...document.querySelectorAll('table')].filter(t => t.checkVisibility()).flatMap(table => {
          const heads = [...table.querySelectorAll('thead th')];
          const left = heads.filter(h => !h.checkVisibility()).map(h => `leaves out ${h.textContent}`);
          const end = table.getBoundingClientRect().right;
          for (let at = table.parentElement; at; at = at.parentElement)
            if (at === table.parentElement || getComputedStyle(at).overflowX !== 'visible') {
              const beyond = Math.round(end - at.getBoundingClientRect().right);
              if (beyond > 1) left.push(`runs ${beyond} px beyond ${at.className}`);
            }
          return left.map(one => `the table "${heads.map(h => h.textContent).join(' | ')}" ${one}`);
        })"""
    )
    return found


#: Of axe, best practice too.
ALL_RULES = ("wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice")
#: What colours and room decide; the rest follows from the document, which no look changes.
RULES_OF_A_LOOK: Sequence[str] = (
    "color-contrast",
    "link-in-text-block",
    "target-size",
    "scrollable-region-focusable",
)


#: How many rows of each table axe goes through: for hundreds alike it takes as long as for ten pages.
ROWS, ALL_ROWS = 25, 10**6


def findings(page: Page, rules: Sequence[str], rows: int) -> list[str]:
    """What axe finds, of whatever weight."""
    found: list[str] = page.evaluate(
        """([rules, rows]) => axe.run({ exclude: [`tbody > tr:nth-child(n + ${rows + 1})`] }, {
          runOnly: rules,
          // what passes is a megabyte a page that nobody reads, and the sheets are the page's own
          resultTypes: ['violations'],
          selectors: false,
          preload: false,
        }).then(result => result.violations.map(one => `${one.id} (${one.impact}): ${one.help}: `
          + one.nodes.slice(0, 3).map(node => node.html.slice(0, 160)).join('; ')))""",
        [list(rules), rows],
    )
    return found


@pytest.mark.parametrize(
    ("variants", "rows"),
    [(EACH_ONCE, ROWS), pytest.param(EVERY, ALL_ROWS, marks=pytest.mark.proof)],
    ids=["each once", "every"],
)
def test_every_screen_is_shown_without_fault(
    shown: tuple[BrowserContext, Page],
    complaints: list[str],
    places: dict[str, int],
    admin_state: StorageState,
    screenshots: Path,
    variants: Variants,
    rows: int,
) -> None:
    context, page = shown
    page.goto("/sign-in")
    expect(page.get_by_role("button", name=re.compile("sign in", re.I)).first).to_be_visible()
    wrong = look_at_all(page, "sign-in", screenshots, variants, rows)
    context.add_cookies(cast(Any, admin_state["cookies"]))
    for place, (name, (address, sign)) in enumerate(SCREENS.items()):
        # a screen is opened at one of the sizes, in turns, and then changed to the other
        first = place % len(variants)
        page.set_viewport_size(variants[first][0])
        open_screen(page, address.format(**places), sign)
        wrong += look_at_all(page, name, screenshots, variants[first:] + variants[:first], rows)
    assert not wrong + complaints, "\n".join(wrong + complaints)


@pytest.mark.usefixtures("kept")
def test_at_200_percent_the_verdict_stands_beside_the_picture(page: Page, survey_id: int) -> None:
    page.set_viewport_size({"width": 720, "height": 450})
    choose_plan(page, survey_id, 0)  # nothing is to be clicked blind first
    page.goto(f"/surveys/{survey_id}/review")
    expect(page.get_by_role("button", name="Accept")).to_be_in_viewport(ratio=1)
    expect(page.get_by_test_id("frame-view")).to_be_in_viewport(ratio=1)
