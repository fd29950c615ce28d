"""A line scan's plan in a real browser: lengths and gaps beside the speed, pixels and exposure."""

import re

from playwright.sync_api import Page, expect


def test_lengths_gaps_and_exposure_are_planned(page: Page, survey_id: int) -> None:
    page.goto(f"/surveys/{survey_id}/planning?plan=lines")
    values = page.get_by_test_id("line-plan-values")
    expect(values).to_contain_text(re.compile(r"Distance gap\s*50\.00"))
    expect(values).to_contain_text(re.compile(r"Length\s*4\.500"))
    page.get_by_label("Time gap").fill("3")
    page.get_by_label("Time gap").blur()
    expect(values).to_contain_text(re.compile(r"Distance gap\s*100\.00"))
    seen = page.get_by_test_id("line-plan-exposure")
    expect(seen).to_contain_text("each line is blurred by 14 mm")
    exposure = page.get_by_label("Exposure", exact=True)
    exposure.fill("9999")
    exposure.blur()
    expect(page.get_by_text("is longer than one line")).to_be_visible()
    exposure.fill("41")
    exposure.blur()
    expect(seen).to_contain_text("each line is blurred by 1.4 mm")
