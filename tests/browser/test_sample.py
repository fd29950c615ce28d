"""A survey's sample: rule and quotas said, their progress beside the passes, a pass discarded."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect


@pytest.mark.usefixtures("kept")
def test_a_sample_is_chosen_and_its_progress_followed(page: Page, survey_id: int, screenshots: Path) -> None:
    vehicles = page.request.get(f"/api/surveys/{survey_id}/vehicles").json()
    free = next(one for one in vehicles if one["state"] == "to_do")
    start = 2 - free["number"] % 2
    page.goto(f"/surveys/{survey_id}/settings")
    sample = page.get_by_test_id("sample")
    expect(sample).to_contain_text("Every pass is measured.")
    sample.get_by_role("button", name="Change the sample").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Passes").select_option("nth")
    dialog.get_by_label("n", exact=True).fill("1")
    dialog.get_by_label("Daytime, any class").fill("400")
    dialog.get_by_label("Low light, Passenger cars").fill("250")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("Enter a whole number from 2 to 1000.")).to_be_visible()
    dialog.get_by_label("n", exact=True).fill("2")
    dialog.get_by_label("First number").fill(str(start))
    page.screenshot(path=screenshots / "sample-dialog.png")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).not_to_be_visible()
    expect(sample).to_contain_text(f"One pass in 2 is measured, starting with number {start}.")
    found = page.request.get(f"/api/surveys/{survey_id}/sample").json()
    by_day = found["quotas"][0]["measured"]
    expect(sample.get_by_test_id("quotas")).to_contain_text(f"{by_day} of 400")
    sample.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "sample.png")

    vehicles = page.request.get(f"/api/surveys/{survey_id}/vehicles").json()
    page.goto(f"/surveys/{survey_id}/measure?recording={free['recording_id']}&vehicle={free['id']}")
    expect(page.get_by_test_id("quotas")).to_contain_text(f"{by_day} of 400")
    row = page.get_by_test_id(f"pass-{free['number']}")
    expect(row).to_have_attribute("data-state", "to_do")
    page.get_by_label("Pass", exact=True).select_option("stopped")
    expect(row).to_have_attribute("data-state", "discarded")
    page.screenshot(path=screenshots / "sample-measure.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "sample-measure-1024.png")
    page.keyboard.press("Control+z")
    expect(row).to_have_attribute("data-state", "to_do")

    # the other half of the passes: it is then outside the sample, and what was measured of that half is said
    now = page.request.get(f"/api/surveys/{survey_id}").json()
    rule = {**now["sampling"], "start": 3 - start}
    body = {"name": now["name"], "version": now["version"], "sampling": rule}
    assert page.request.put(f"/api/surveys/{survey_id}", data=body, headers={"X-Sightline": "1"}).ok
    page.reload()
    page.get_by_label("Show", exact=True).select_option("left_out")
    expect(row).to_have_attribute("data-state", "out_of_sample")
    expect(row).to_contain_text(re.compile("outside the sample", re.IGNORECASE))
    page.goto(f"/surveys/{survey_id}/settings")
    expect(page.get_by_test_id("sample")).to_contain_text("outside the sample")
