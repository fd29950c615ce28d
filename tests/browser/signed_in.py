"""Who is invited: in a browser of their own by their one-time link, and beside it as a client of the API."""

import time
from collections.abc import Iterator
from contextlib import contextmanager

from playwright.sync_api import APIRequestContext, Browser, Page, ViewportSize, expect

from tests.browser.server import Server
from tests.real.client import Client

USUAL: ViewportSize = {"width": 1440, "height": 900}


def invite(admin: APIRequestContext, name: str, role: str) -> str:
    """The link of somebody new, whom no other test knows."""
    person = {"name": name, "email": f"{name.lower()}{time.time_ns()}@example.org", "role": role}
    made = admin.post("/api/people", headers={"X-Sightline": "1"}, data=person)
    assert made.ok, made.text()
    return str(made.json()["link"])


@contextmanager
def first_page(browser: Browser, server: Server, link: str, size: ViewportSize = USUAL) -> Iterator[Page]:
    """The page of whoever opens their link, at the list of surveys."""
    context = browser.new_context(base_url=server.url, viewport=size)
    page = context.new_page()
    page.goto(link)
    expect(page.get_by_role("heading", name="Surveys", exact=True)).to_be_visible()
    yield page
    context.close()


def client_of(page: Page, base_url: str) -> Client:
    """A client of the API with the page's session."""
    client = Client(base_url)
    for cookie in page.context.cookies():
        client.http.cookies.set(cookie["name"], cookie["value"])
    return client
