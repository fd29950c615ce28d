"""Review by lots from end to end: drawn, judged by key, accepted, taken back; another inspected whole."""

import re
from dataclasses import replace
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sightline.demo import invented
from sightline.infra.services import open_services
from sightline.settings import load_settings

from .server import Server

SITE = replace(invented.SITES[0], daytime=24, low_light=0)


@pytest.fixture
def site(demonstration: Server, monkeypatch: pytest.MonkeyPatch) -> int:
    """A simulated site that nobody has reviewed, beside the demonstration: 24 roofs and 24 eyes by day."""
    monkeypatch.setattr(invented, "_review_by_lots", lambda *_, **__: None)
    services = open_services(load_settings(data_dir=demonstration.data_dir))
    try:
        films = {"daytime": invented._film(services, SITE, "daytime")}
        with services.writing() as session:
            return invented.store_site(session, SITE, films)  # type: ignore[arg-type]
    finally:
        services.close()


def test_a_lot_from_its_draw_to_its_decision(page: Page, site: int, screenshots: Path) -> None:
    lots = f"/surveys/{site}/lots"
    page.goto(lots)
    _drawn(page, screenshots)
    sample, size = _judged(page, site, screenshots)
    lot = page.get_by_test_id("lot")
    lot.get_by_role("button", name="Accept the lot").click()
    words = page.get_by_test_id("lot-words")
    expect(words).to_contain_text(f"{size - sample} heights accepted with it")
    expect(page.get_by_test_id("lots-summary")).to_contain_text(
        f"Accepted measurements: {sample} individually, {size - sample} by the sample of their lot."
    )
    lot.get_by_role("img").first.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "lots-accepted.png", full_page=True)
    lot.get_by_role("button", name="Undo").click()
    expect(words).to_contain_text(f"Acceptance undone: {size - sample} heights wait again")
    page.get_by_test_id("lots").get_by_role("button", name="Show").click()
    lot.get_by_role("button", name="Full inspection").click()
    page.get_by_role("dialog").get_by_role("button", name="Full inspection").click()
    expect(words).to_contain_text("Not accepted by its sample")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "lots-1024.png")
    found = page.request.get(f"/api/surveys/{site}/lots").json()
    assert sorted(one["state"] for one in found) == ["full_inspection", "taken_back"]
    audit = page.request.get(f"/api/audit/verify?survey_id={site}")
    assert not audit.ok or audit.json()["ok"]


def _drawn(page: Page, screenshots: Path) -> None:
    """Risks that are none are said in one sentence; the plan follows from those that are."""
    planned = page.get_by_test_id("lots-planned")
    expect(planned.locator("tbody tr")).to_have_count(2)
    page.get_by_label("Share of wrong heights at which a lot should pass").fill("30")
    expect(page.get_by_text("must be smaller than that of one that should not")).to_be_visible()
    page.get_by_label("Share of wrong heights at which a lot should pass").fill("1")
    page.get_by_label("Share of wrong heights at which a lot should not pass").fill("25")
    page.get_by_label("Risk that it does", exact=True).fill("20")
    expect(planned).to_contain_text("verdicts")
    page.screenshot(path=screenshots / "lots-plan.png")
    page.get_by_role("button", name="Draw", exact=True).click()
    expect(page.get_by_test_id("lots").locator("tbody tr")).to_have_count(2)
    expect(page.get_by_test_id("lot-words")).to_contain_text("of the sample still wait")


def _judged(page: Page, site: int, screenshots: Path) -> tuple[int, int]:
    """The whole sample in the queue, by one key; how many of how many."""
    words = page.get_by_test_id("lot-words").inner_text()
    size, sample = (int(one) for one in re.findall(r"\d+", words)[:2])
    page.get_by_role("link", name="Review the sample").click()
    rows = page.locator(".review__row")
    expect(rows).to_have_count(sample)
    expect(page.get_by_test_id("review-lot")).to_contain_text("sample of lot")
    page.screenshot(path=screenshots / "lots-queue.png")
    accept = page.get_by_test_id("review-accept").get_by_role("button")
    for at in range(sample):
        expect(accept).to_be_enabled()
        current = page.locator(".review__row[aria-current=true]")
        measurement = current.get_attribute("data-measurement")
        with page.expect_response(lambda answer: answer.url.endswith("/reviews") and answer.status == 201):
            page.keyboard.press("a")
        if at < sample - 1:
            expect(page.locator(f'[data-measurement="{measurement}"][aria-current=true]')).to_have_count(0)
    page.go_back()
    page.wait_for_url(re.compile("lots|review"))
    page.goto(f"/surveys/{site}/lots")
    page.get_by_test_id("lots").locator("tr", has_text=f"{sample} of {sample}").get_by_role("button").or_(
        page.get_by_test_id("lots").locator("tr[aria-current=true]", has_text=f"{sample} of {sample}")
    ).first.click()
    expect(page.get_by_test_id("lot-words")).to_contain_text("The lot can be accepted")
    return sample, size
