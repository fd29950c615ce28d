"""When a recording was filmed is confirmed on its page; passes then have a time of day."""

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.media.clips import short_clip
from tests.media.test_other_recorders import two_pictures


@pytest.mark.usefixtures("kept")
def test_a_start_is_confirmed_and_passes_have_their_time(
    page: Page, survey_id: int, screenshots: Path
) -> None:
    recording = page.request.get(f"/api/surveys/{survey_id}/recordings").json()[0]
    page.goto(f"/surveys/{survey_id}/recordings")
    card = page.get_by_role("article").filter(has_text=str(recording["name"]))
    expect(card.get_by_test_id("filmed")).to_contain_text("Filmed from 14 May 2025, 08:10:00 (Europe/Paris)")
    card.get_by_test_id("filmed").get_by_role("button").click()
    dialog = page.get_by_role("dialog")
    page.screenshot(path=screenshots / "filming-dialog.png")
    dialog.get_by_label("First frame").fill("2999-01-01T08:10:00")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("is in the future")).to_be_visible()
    dialog.get_by_label("First frame").fill("2025-03-30T02:30:00")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("does not exist in Europe/Paris")).to_be_visible()
    dialog.get_by_label("First frame").fill("2025-10-26T02:30:00")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("occurs twice in Europe/Paris")).to_be_visible()
    dialog.get_by_label("the second time (+01:00)").check()
    dialog.get_by_label("Weather").fill("fog")
    page.screenshot(path=screenshots / "filming-twice.png")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).not_to_be_visible()
    expect(card.get_by_test_id("filmed")).to_contain_text("Filmed from 26 Oct 2025, 02:30:00 (Europe/Paris)")
    expect(card.get_by_test_id("filmed")).to_contain_text("fog")
    page.screenshot(path=screenshots / "filming.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "filming-1024.png")

    page.goto(f"/surveys/{survey_id}/measure?recording={recording['id']}")
    vehicles = page.request.get(f"/api/surveys/{survey_id}/vehicles").json()
    first = next(one for one in vehicles if one["recording_id"] == recording["id"])
    assert first["filmed_at"].endswith("+01:00")
    row = page.get_by_test_id(f"pass-{first['number']}")
    expect(row).to_contain_text(first["filmed_at"][11:19])
    page.screenshot(path=screenshots / "filming-measure.png")
    page.goto(f"/surveys/{survey_id}/camera")
    expect(page.get_by_test_id("camera-words")).to_contain_text("wide angle")
    page.get_by_test_id("camera-words").get_by_role("button", name="Change").click()
    page.screenshot(path=screenshots / "filming-camera.png")


@pytest.mark.usefixtures("kept")
def test_a_rate_is_stated_and_another_picture_imported(
    page: Page, survey_id: int, screenshots: Path, tmp_path: Path
) -> None:
    files = [
        short_clip(tmp_path / "slow.mp4", {"com.android.capture.fps": "100"}, {}),
        two_pictures(tmp_path / "two.mp4", (30, 30), (True, True)),
    ]
    page.goto(f"/surveys/{survey_id}/recordings")
    page.locator("input[type=file]").first.set_input_files(files)
    slow, two = (page.get_by_role("article").filter(has_text=one.name) for one in files)
    rate, pictures = slow.get_by_test_id("filming-rate"), two.get_by_test_id("pictures")
    expect(rate).to_contain_text("not confirmed; motion is not measured", timeout=60_000)
    expect(pictures).to_contain_text("Video track 1 of 2 in the file", timeout=60_000)
    page.screenshot(path=screenshots / "filming-rate.png", full_page=True)
    rate.get_by_role("button").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Filming rate").fill("0")
    expect(dialog.get_by_text("Enter a number from 1 to 2000.")).to_be_visible()
    dialog.get_by_label("Filming rate").fill("100")
    page.screenshot(path=screenshots / "filming-rate-dialog.png")
    dialog.get_by_role("button", name="Import with this rate").click()
    expect(rate).to_contain_text("Filmed at 100 frames/s, as entered", timeout=60_000)
    pictures.get_by_role("button", name="Import video track 2 of two.mp4").click()
    second = page.get_by_role("article").filter(has_text="two.mp4 (2)")
    expect(second.get_by_test_id("pictures")).to_contain_text("Video track 2 of 2", timeout=60_000)
    expect(second).to_contain_text("320 × 240")
    second.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "filming-pictures.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    slow.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "filming-pictures-1024.png")
