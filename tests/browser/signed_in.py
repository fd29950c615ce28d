"""Who signed in: in the browser by a server's first link, and beside it as a client of the API."""

from playwright.sync_api import Browser, Page, expect

from tests.browser.server import Server
from tests.real.client import Client


def first_page(browser: Browser, server: Server) -> Page:
    """The page of whoever opens a new server's one-time link, at the list of surveys."""
    server.wait()
    context = browser.new_context(base_url=server.url, viewport={"width": 1440, "height": 900})
    page = context.new_page()
    page.goto(server.sign_in_link())
    expect(page.get_by_role("heading", name="Surveys", exact=True)).to_be_visible()
    return page


def client_of(page: Page, base_url: str) -> Client:
    """A client of the API with the page's session."""
    client = Client(base_url)
    for cookie in page.context.cookies():
        client.http.cookies.set(cookie["name"], cookie["value"])
    return client
