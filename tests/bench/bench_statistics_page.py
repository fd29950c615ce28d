"""The statistics page in Chromium: `python tests/bench/bench_statistics_page.py [COUNT ...]`, seconds.

Until the error table is there, which fills the view, and until the first two figures below it are drawn, in
a browser that has the app's code; on a SQLite of its own. Cold: from the click on the survey's link, when
the server has never counted it; the others: from opening the address.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from playwright.sync_api import Browser, Page

from sightline.infra.database.engine import make_engine, migrate, session_factory
from sightline.settings import Settings
from tests.bench.seed import seed
from tests.bench.web_ground import chromium, serving, sign_in_link

GOALS_S = {100_000: 1.0, 1_000_000: 5.0}
READY = "[data-testid^=figure-] svg"
FIGURES = 2
SEEDED = "olga@example.org"  # one of the people whom the seed brings


def signed_in(browser: Browser, url: str, folder: Path) -> Page:
    """A page that has been opened before, when nothing was there to count."""
    page = browser.new_context(base_url=url, viewport={"width": 1440, "height": 900}).new_page()
    page.goto(sign_in_link(folder, SEEDED))
    page.wait_for_url(lambda address: "sign-in" not in address)
    page.goto("/statistics?last_day=2000-01-01")
    page.get_by_test_id("stat-counted").get_by_text("0 measurements").wait_for()
    return page


def shown(page: Page, act: Callable[[], object]) -> tuple[float, float]:
    """Seconds from an act to the error table, which fills the view, and to the first figures below it."""
    begun = time.perf_counter()
    act()
    page.get_by_test_id("errors-overall").wait_for(timeout=120_000)
    table = time.perf_counter() - begun
    page.locator(READY).nth(FIGURES - 1).wait_for(timeout=120_000)
    return table, time.perf_counter() - begun


def clicked(page: Page, survey_id: int) -> tuple[float, float]:
    """From the click on a survey's link."""
    page.goto(f"/surveys/{survey_id}", wait_until="networkidle")
    return shown(page, page.get_by_role("link", name="Statistics").first.click)


def measure(count: int, browser: Browser) -> None:
    with tempfile.TemporaryDirectory(prefix="sightline-bench-") as name:
        folder = Path(name)
        engine = make_engine(Settings(data_dir=folder).database_url)
        migrate(engine)
        survey_id = seed(session_factory(engine), count).survey.id
        engine.dispose()
        with serving("serve", folder) as server:
            page = signed_in(browser, server.url, folder)
            path = f"/statistics?survey={survey_id}"
            cold = clicked(page, survey_id)
            filtered = shown(page, lambda: page.goto(f"{path}&lighting=daytime", wait_until="commit"))
            again = shown(page, lambda: page.goto(path, wait_until="commit"))
            page.context.close()
    goal = GOALS_S.get(count)
    print(f"{count} measurements, s to the table / to two figures; load {os.getloadavg()[0]:.1f}")
    for what, (table, figures) in (("cold", cold), ("another filter", filtered), ("again", again)):
        asked = f" (asked {goal:.0f})" if goal and what == "cold" else ""
        print(f"  {what}{asked}: {table:.2f} / {figures:.2f}", flush=True)


def main(counts: list[int]) -> int:
    with chromium() as browser:
        for count in counts:
            measure(count, browser)
    return 0


if __name__ == "__main__":
    sys.exit(main([int(word) for word in sys.argv[1:]] or list(GOALS_S)))
