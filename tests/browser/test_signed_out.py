"""What the browser keeps of a survey is shown neither after signing out nor to the next person."""

from pathlib import Path

from playwright.sync_api import APIRequestContext, Browser, Page, expect

from sightline.media.video.writer import write_mp4
from tests.media.clips import painted
from tests.real.client import Client

from .server import Server
from .signed_in import client_of, first_page, invite

#: Asks as the pages do, by the browser's own cache: the statuses of some addresses.
STATUSES = (
    """(addresses) => Promise.all(addresses.map((one) => fetch(one).then((answer) => answer.status)))"""
)


def statuses(page: Page, addresses: list[str]) -> list[int]:
    found: list[int] = page.evaluate(STATUSES, addresses)
    return found


def test_frames_and_packages_are_not_shown_from_the_cache(
    browser: Browser, admin: APIRequestContext, demonstration: Server, tmp_path: Path
) -> None:
    clip = tmp_path / "road.mp4"
    write_mp4(clip, (painted(n, 320, 240) for n in range(12)), 25, crf=14, gop=6)
    with first_page(browser, demonstration, invite(admin, "Sam", "operator")) as page:
        client = client_of(page, demonstration.url)
        survey, recording, package = filled(client, clip)
        client.http.close()
        addresses = [f"/api/recordings/{recording}/frames/3.jpg?v=1", package]
        assert statuses(page, addresses) == statuses(page, addresses) == [200, 200]

        page.goto(f"/surveys/{survey}")
        expect(page.get_by_role("heading", name="Closed road")).to_be_visible()
        page.locator(".topbar__person").click()
        page.get_by_role("button", name="Sign out").click()
        expect(page.get_by_role("heading", name="Sign in")).to_be_visible()
        assert statuses(page, addresses) == [401, 401]
        page.go_back()
        expect(page.get_by_role("heading", name="Sign in")).to_be_visible()
        expect(page.get_by_text("Closed road")).to_have_count(0)

        page.goto(invite(admin, "Rosa", "viewer"))
        expect(page.get_by_role("heading", name="Surveys", exact=True)).to_be_visible()
        assert statuses(page, addresses) == [404, 404]
        page.goto(f"/surveys/{survey}")
        expect(page.get_by_text("There is no survey")).to_be_visible()


def filled(client: Client, clip: Path) -> tuple[int, int, str]:
    """A closed survey with a recording and a package: survey, recording, the package's address."""
    survey = int(client.post("/surveys", name="Closed road")["id"])
    recording = client.upload(survey, clip)
    client.ready(recording)
    client.finished(client.post(f"/surveys/{survey}/exports", crops=False)["id"])
    (made,) = client.get(f"/surveys/{survey}/exports")
    return survey, recording, str(made["url"])
