"""A walk through the app by its links: what a link, Back or Forward shows is what a reload shows.

In `make test` from a survey's overview along each of its links, to every screen of the rail, Back and Forward
of the first; in `make proofs` from the survey list to every link within a page. A page that remembers too
much or too little of where it was, a focus left behind, a question that fails and a complaint of the
browser's all end the walk.
"""

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import BrowserContext, Page

from .walking import (
    Shown,
    arrived,
    asked_by,
    back_from,
    begin,
    path_of,
    reloaded,
    shown,
    there_and_loaded,
    walking,
)

LINKS = """() => [...document.querySelectorAll("a[href^='/']")]
  .filter((link) => link.checkVisibility() && !link.download && !link.target)
  .map((link) => link.getAttribute("href")).filter((to) => !to.startsWith("/api/"))"""


# What has to be reached by links alone, so that the walk cannot become shorter unseen.
OF_A_SURVEY = {"/statistics", "/studies", "/catalogue"} | {
    f"/surveys/1/{name}"
    for name in (
        *("settings", "history", "planning", "camera", "recordings", "pose", "measure", "checks", "review"),
        *("scans", "export"),
    )
}
OF_ALL = {
    *OF_A_SURVEY,
    *("/", "/account", "/surveys/1"),
    *(f"/surveys/1/{name}" for name in ("lots", "repeats", "repeats/click", "scans/results", "scan")),
}


def shape(link: str) -> tuple[str, frozenset[str]]:
    """A link's page and what it asks of it, without the values."""
    return path_of(link), frozenset(name for name, _ in asked_by(link))


def of_another_survey(link: str) -> bool:
    """Surveys that other tests made stand in any state, some with work that never ends."""
    return re.match(r"/surveys/(?!1\b)", link) is not None


def first(walker: Page, link: str) -> Callable[[], None]:
    """A click on the first of the links to there that can be seen."""
    return walker.locator(f'a[href="{link}"]:visible').first.click


class Walk:
    """A page is walked where a link has led to it; of a walk that is not `whole`, the first page alone."""

    def __init__(self, walker: Page, start: str, *, whole: bool) -> None:
        self.walker = walker
        self.whole = whole
        self.known = {start}
        self.shapes: set[object] = {shape(start)}

    def is_to_walk(self, here: str, link: str) -> bool:
        """Whether it is the first of its kind.

        A link to the page itself is walked from each page: it may keep what it should forget. The guide keeps
        nothing, and its sections are places of pages that are walked.
        """
        if (path_of(link) == "/guide" and "section=" in link) or of_another_survey(link):
            return False
        within = path_of(link) == path_of(here) != "/guide" and link != here
        # of a list's links to the same page, the first stands for all
        walked = (path_of(here), shape(link)) if within else shape(link)
        if walked in self.shapes:
            return False
        self.shapes.add(walked)
        return True

    def go_on_from(self, here: str, start: Shown) -> None:
        """Every link of the page that is shown, and of a whole walk those of the pages that they lead to."""
        for link in dict.fromkeys(self.walker.evaluate(LINKS)):
            if not self.is_to_walk(here, link):
                continue
            follow = first(self.walker, link)
            if self.whole or len(self.known) == 1:
                there = there_and_loaded(self.walker, start, follow, link)
            else:
                follow()
                there = reloaded(self.walker, arrived(self.walker, start, twice=True), link)
            assert asked_by(link) <= asked_by(there.address), f"{link} leads to {there.address}"
            if link not in self.known:
                self.known.add(link)
                if self.whole:
                    self.go_on_from(link, there)
            back_from(self.walker, start, there, link)


@pytest.mark.parametrize(
    ("start", "reached"),
    [("/surveys/1", OF_A_SURVEY), pytest.param("/", OF_ALL, marks=pytest.mark.proof)],
    ids=["of a survey", "of all"],
)
def test_links_forth_and_back_show_what_a_reload_shows(
    context: BrowserContext, start: str, reached: set[str]
) -> None:
    with walking(context) as walker:
        begin(walker)
        walker.goto(start)
        walk = Walk(walker, start, whole=reached == OF_ALL)
        walk.go_on_from(start, shown(walker, twice=True))
        assert {path_of(link) for link in walk.known} >= reached
