"""A survey gets a member: whom the manager adds sees it, with the role that was given."""

import time
from pathlib import Path

from playwright.sync_api import APIRequestContext, Browser, Page, expect

from .server import Server
from .signed_in import first_page, invite


def test_a_manager_adds_a_member_and_takes_them_out(
    page: Page, browser: Browser, admin: APIRequestContext, demonstration: Server, screenshots: Path
) -> None:
    made = admin.post("/api/surveys", headers={"X-Sightline": "1"}, data={"name": "Closed road"})
    survey = made.json()["id"]
    name, guest = (f"{one} {time.time_ns()}" for one in ("Rosa", "Nils"))
    link = invite(admin, name, "viewer")
    with first_page(browser, demonstration, link, {"width": 1024, "height": 768}) as rosa:
        rosa.goto(f"/surveys/{survey}")
        expect(rosa.get_by_text("There is no survey")).to_be_visible()

        page.goto(f"/surveys/{survey}/settings")
        page.get_by_role("button", name="Members").click()
        dialog = page.get_by_role("dialog")
        dialog.get_by_label("Person").select_option(label=name)
        dialog.get_by_label("Role", exact=True).select_option("operator")
        dialog.get_by_role("button", name="Add").click()
        expect(dialog.get_by_label(f"Role of {name} in this survey")).to_have_value("operator")
        page.screenshot(path=screenshots / "members-1440.png")
        dialog.get_by_role("button", name="Invite a new user").click()
        form = page.get_by_role("dialog", name="Add a user")
        form.get_by_label("Name", exact=True).fill(guest)
        form.get_by_label("E-mail").fill(f"nils{time.time_ns()}@example.org")
        form.get_by_label("Role", exact=True).select_option("reviewer")
        form.get_by_role("button", name="Add", exact=True).click()
        shown = page.get_by_role("dialog", name=f"Sign-in link for {guest}")
        shown.get_by_role("button", name="Done").click()
        expect(dialog.get_by_label(f"Role of {guest} in this survey")).to_have_value("reviewer")

        rosa.reload()
        expect(rosa.get_by_role("heading", name="Closed road")).to_be_visible()
        rosa.get_by_role("link", name="Settings").click()
        expect(rosa.get_by_role("button", name="Edit")).to_be_visible()
        rosa.get_by_role("button", name="Members").click()
        expect(rosa.get_by_role("dialog").get_by_text("Operator")).to_be_visible()
        expect(rosa.get_by_role("dialog").get_by_role("button", name="Add")).to_have_count(0)
        rosa.screenshot(path=screenshots / "members-1024.png")
