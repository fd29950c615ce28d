"""A survey gets a member: whom the manager adds sees it, with the role that was given."""

from pathlib import Path

from playwright.sync_api import Browser, expect

from tests.browser.server import start
from tests.browser.signed_in import client_of, first_page


def test_a_manager_adds_a_member_and_takes_them_out(
    browser: Browser, tmp_path: Path, screenshots: Path
) -> None:
    server = start("serve", tmp_path / "data")
    try:
        page = first_page(browser, server)
        client = client_of(page, server.url)
        survey = client.post("/surveys", name="Closed road")["id"]
        link = client.post("/people", name="Rosa", email="rosa@example.org", role="viewer")["link"]
        client.http.close()

        theirs = browser.new_context(base_url=server.url, viewport={"width": 1024, "height": 768})
        rosa = theirs.new_page()
        rosa.goto(link)
        expect(rosa.get_by_role("heading", name="Surveys", exact=True)).to_be_visible()
        rosa.goto(f"/surveys/{survey}")
        expect(rosa.get_by_text("There is no survey")).to_be_visible()

        page.goto(f"/surveys/{survey}/settings")
        page.get_by_role("button", name="Members").click()
        dialog = page.get_by_role("dialog")
        dialog.get_by_label("Person").select_option(label="Rosa")
        dialog.get_by_label("Role", exact=True).select_option("operator")
        dialog.get_by_role("button", name="Add").click()
        expect(dialog.get_by_label("Role of Rosa in this survey")).to_have_value("operator")
        page.screenshot(path=screenshots / "members-1440.png")
        dialog.get_by_role("button", name="Invite a new user").click()
        form = page.get_by_role("dialog", name="Add a user")
        form.get_by_label("Name", exact=True).fill("Nils")
        form.get_by_label("E-mail").fill("nils@example.org")
        form.get_by_label("Role", exact=True).select_option("reviewer")
        form.get_by_role("button", name="Add", exact=True).click()
        shown = page.get_by_role("dialog", name="Sign-in link for Nils")
        shown.get_by_role("button", name="Done").click()
        expect(dialog.get_by_label("Role of Nils in this survey")).to_have_value("reviewer")

        rosa.reload()
        expect(rosa.get_by_role("heading", name="Closed road")).to_be_visible()
        rosa.get_by_role("link", name="Settings").click()
        expect(rosa.get_by_role("button", name="Edit")).to_be_visible()
        rosa.get_by_role("button", name="Members").click()
        expect(rosa.get_by_role("dialog").get_by_text("Operator")).to_be_visible()
        expect(rosa.get_by_role("dialog").get_by_role("button", name="Add")).to_have_count(0)
        rosa.screenshot(path=screenshots / "members-1024.png")
    finally:
        server.stop()
