"""A jump: its thumbnail at once, nothing to click on meanwhile; and what is there before it is asked for."""

import re
from pathlib import Path

from playwright.sync_api import Page, Route, expect

from tests.media.clips import Spec, write

FRAMES = 140
FAR = 131


def test_a_thumbnail_stands_in_until_the_frame_is_here(page: Page, tmp_path: Path, screenshots: Path) -> None:
    headers = {"X-Sightline": "1"}
    survey = page.request.post("/api/surveys", data={"name": "Jumps"}, headers=headers).json()["id"]
    clip = write(tmp_path / "jump.mp4", Spec("jump.mp4", gop=250, count=FRAMES))
    page.goto(f"/surveys/{survey}/recordings")
    page.locator("input[type=file]").set_input_files(clip)
    expect(page.get_by_role("link", name="Measure").first).to_be_visible()
    expect(page.get_by_role("button", name="Find the passes")).to_be_visible(timeout=30_000)
    recording = page.request.get(f"/api/surveys/{survey}/recordings").json()[0]["id"]
    span = {"first_frame": 60, "last_frame": 80, "best_frame": 70}
    page.request.post(f"/api/recordings/{recording}/vehicles", data=span, headers=headers)

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
    expect(stand_in).to_contain_text(f"frame {FAR} is coming")
    for width, height in ((1440, 900), (1024, 768)):
        page.set_viewport_size({"width": width, "height": height})
        page.screenshot(path=screenshots / f"jump-stand-in-{width}.png")
    held.pop().continue_()
    expect(stand_in).to_have_count(0)
    page.screenshot(path=screenshots / "jump-there.png")
    before = len(asked)
    box.fill("70")
    box.press("Enter")
    expect(stand_in).to_have_count(0)
    page.wait_for_timeout(300)
    assert 70 not in asked[before:], "it was in the browser already"
