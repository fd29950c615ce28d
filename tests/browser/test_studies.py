"""A study in the browser: made, given a survey, refused and failed in a sentence each, computed, removed."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect


@pytest.mark.usefixtures("kept")
def test_a_study_from_its_name_to_its_figures(page: Page, survey_id: int, screenshots: Path) -> None:
    survey = page.request.get(f"/api/surveys/{survey_id}").json()["name"]
    page.goto("/studies")
    page.get_by_role("button", name="New study").first.click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Name").fill("Eyes of one road")
    dialog.get_by_role("button", name="Create study").click()
    expect(page.get_by_role("heading", name="Eyes of one road")).to_be_visible()

    page.get_by_role("button", name="Add surveys").click()
    dialog.get_by_label("Add a survey").select_option(label=survey)
    fleet = dialog.get_by_label("Fleet (CSV)", exact=True)
    fleet.fill("category,share\nsuv,0.4\nvan,0.4")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("sum to 0.8, not to 1")).to_be_visible()
    fleet.fill("category,share\nbus,1")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).not_to_be_visible()

    page.get_by_role("button", name="Compute").click()
    expect(page.get_by_text("bus, which no survey contains")).to_be_visible()
    page.screenshot(path=screenshots / "study-failed.png")
    page.get_by_role("button", name="Edit", exact=True).click()
    fleet.fill("")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).not_to_be_visible()
    page.get_by_role("button", name="Compute").click()
    expect(page.get_by_test_id("study-counted")).to_have_text(
        re.compile("accepted heights of .* vehicles at 1 site")
    )
    expect(page.get_by_test_id("study-percentiles")).to_be_visible()
    page.screenshot(path=screenshots / "study.png", full_page=True)
    with page.expect_download() as report:
        page.get_by_role("link", name="Report (PDF)").click()
    assert report.value.path().read_bytes().startswith(b"%PDF")

    page.get_by_role("button", name="Remove study").click()
    dialog.get_by_role("button", name="Remove", exact=True).click()
    expect(page.get_by_role("link", name="Eyes of one road")).to_have_count(0)
