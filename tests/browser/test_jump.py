"""A jump: its thumbnail at once, nothing to click on meanwhile; and what is there before it is asked for."""

import re
from pathlib import Path

from playwright.sync_api import Page, Route, expect

from tests.browser.server import Server
from tests.browser.signed_in import client_of
from tests.media.clips import QVGA, Spec, write

FRAMES = 140
FAR = 131


def recording_with_a_pass(page: Page, base_url: str, folder: Path) -> tuple[int, int]:
    """Survey and recording, uploaded with the browser's session, and a pass with its best frame at 70."""
    client = client_of(page, base_url)
    survey = client.post("/surveys", name="Jumps")["id"]
    recording = client.upload(
        survey, write(folder / "jump.mp4", Spec("jump.mp4", size=QVGA, gop=250, count=FRAMES))
    )
    client.ready(recording)
    client.post(f"/recordings/{recording}/vehicles", first_frame=60, last_frame=80, best_frame=70)
    client.http.close()
    return survey, recording


def test_a_thumbnail_stands_in_until_the_frame_is_here(
    page: Page, demonstration: Server, tmp_path: Path, screenshots: Path
) -> None:
    survey, recording = recording_with_a_pass(page, demonstration.url, tmp_path)
    asked: list[int] = []
    held: list[Route] = []

    def note(route: Route) -> None:
        n = int(re.search(r"frames/(\d+)\.jpg", route.request.url)[1])  # type: ignore[index]
        asked.append(n)
        if n == FAR:
            held.append(route)
        else:
            route.continue_()

    page.route("**/frames/*.jpg*", note)
    page.goto(f"/surveys/{survey}/measure?recording={recording}&frame=20")
    stand_in = page.get_by_test_id("stand-in")
    box = page.get_by_test_id("frame-box")
    # the neighbours in the direction of travel, and then the next pass before anybody asks for it
    expect(page.locator(".timeline__loaded")).to_have_count(2)
    assert {21, 28, 19, 70} <= set(asked)
    expect(page.locator(".timeline__ready").first).to_be_attached()

    box.fill(str(FAR))
    box.press("Enter")
    expect(stand_in).to_contain_text(f"loading frame {FAR}")
    page.screenshot(path=screenshots / "jump-stand-in.png")
    held.pop().continue_()
    expect(stand_in).to_have_count(0)
    before = len(asked)
    box.fill("70")
    with page.expect_request("**/frames/78.jpg*"):
        box.press("Enter")
    expect(stand_in).to_have_count(0)
    assert 70 not in asked[before:], (
        "it was in the browser already, and its neighbours are asked for after it"
    )
