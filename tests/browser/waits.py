"""How tests in a browser wait for what the page does not show, and keep what it shows for a moment only."""

import time
from collections.abc import Callable
from typing import TypeVar

from playwright.sync_api import Page

from tests.support.waiting import NEVER_S

NEVER_MS = 1000 * NEVER_S
Found = TypeVar("Found")

# What takes a word out of the corner is put off by 5 or 10 s, which a busy machine may need to look.
TOASTS_STAY = """
  const later = window.setTimeout.bind(window);
  window.setTimeout = (run, ms, ...words) => later(run, ms >= 5000 ? 2 ** 31 - 1 : ms, ...words);
"""


def wait_until(
    page: Page,
    condition: Callable[[], Found | None],
    said: Callable[[], object] = lambda: "it never came",
    seconds: float = NEVER_S,
) -> Found:
    """What the condition gives once it is true, while the page goes on."""
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, said()
        page.wait_for_timeout(50)
    return found


def keep_toasts(page: Page) -> None:
    """From the next load on what the page says in its corner stays there."""
    page.add_init_script(TOASTS_STAY)
