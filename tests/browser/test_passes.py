"""Passes are found, shown as found, confirmed, split, taken back and joined, in a real browser."""

from pathlib import Path

import numpy as np
from playwright.sync_api import Page, expect

from sightline.media.video.writer import write_mp4
from tests.media.street import car, street

from .server import ROOT
from .waits import keep_toasts

AXE = ROOT / "frontend" / "node_modules" / "axe-core" / "axe.min.js"


def a_street(path: Path) -> Path:
    cars = [car(15), car(55, right=False, near=False, grey=40), car(95, grey=60)]
    write_mp4(path, (np.repeat(g[..., None], 3, 2) for g in street(140, cars)), 30, crf=18)
    return path


def test_from_a_video_to_its_passes(page: Page, tmp_path: Path, screenshots: Path) -> None:
    keep_toasts(page)
    headers = {"X-Sightline": "1"}
    made = page.request.post("/api/surveys", data={"name": "Drawn street"}, headers=headers)
    survey = made.json()["id"]
    page.goto(f"/surveys/{survey}/recordings")
    page.locator("input[type=file]").set_input_files(a_street(tmp_path / "street.mp4"))
    find = page.get_by_role("button", name="Find the passes")
    find.click()
    expect(page.get_by_text("street.mp4: 3 passes were found.")).to_be_visible()
    page.screenshot(path=screenshots / "passes-recordings.png")

    page.goto(f"/surveys/{survey}/measure")
    first, second = page.get_by_test_id("pass-1"), page.get_by_test_id("pass-2")
    expect(first).to_contain_text("found")
    expect(second).to_contain_text("to the left")
    spans = page.locator(".timeline__span")
    expect(spans).to_have_text(["01?→", "←02?", "03?→"])
    for width, height in ((1440, 900), (1024, 768)):
        page.set_viewport_size({"width": width, "height": height})
        page.locator("[data-testid=pass-1]").click()
        page.screenshot(path=screenshots / f"passes-measure-{width}.png")
    page.set_viewport_size({"width": 1440, "height": 900})

    page.get_by_role("button", name="Vehicle 1: split, join, discard").click()
    page.screenshot(path=screenshots / "passes-menu.png")
    page.get_by_role("button", name="Confirm: daytime").click()
    expect(first).not_to_contain_text("found")
    expect(spans.first).to_have_text("01→")

    page.keyboard.press("b")
    page.keyboard.press("Shift+K")
    expect(page.get_by_test_id("pass-4")).to_be_visible()
    expect(spans).to_have_count(4)
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("pass-4")).to_have_count(0)
    first.click()
    page.keyboard.press("Shift+J")
    expect(second).to_have_count(0)
    page.keyboard.press("Control+z")
    expect(second).to_be_visible()
    expect(spans).to_have_text(["01→", "←02", "03?→"])  # a person had it in hand
    page.keyboard.press("Shift+Delete")
    expect(page.get_by_role("dialog")).to_be_visible()
    page.keyboard.press("Escape")
    page.evaluate(AXE.read_text())
    problems = page.evaluate("async () => (await axe.run()).violations")
    assert [one["id"] for one in problems if one["impact"] in ("serious", "critical")] == []
