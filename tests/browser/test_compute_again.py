"""Heights of line scans computed again: what is out of date, old beside new, and the undo of all."""

import re
import time
from pathlib import Path

from playwright.sync_api import Browser, Page, expect

from sightline.infra.services import open_services
from sightline.settings import load_settings
from tests.support import samples, scans_samples

from .server import Server


def filled(server: Server) -> int:
    """A survey with two roofs in line scans, beside the server's others."""
    services = open_services(load_settings(data_dir=server.data_dir))
    try:
        with services.writing() as session:
            one = samples.sample(session, of=(f"Olga{time.time_ns()}", f"René{time.time_ns()}"))
            for _ in range(2):
                made = scans_samples.measured(session, one)
                rod = scans_samples.rod(session, one, made.scan_id)
                scans_samples.tall(session, one, made.vehicle_id, rod)
    finally:
        services.close()
    return one.survey.id


def test_heights_of_line_scans_are_computed_again_and_put_back(
    page: Page, browser: Browser, demonstration: Server, screenshots: Path
) -> None:
    survey_id = filled(demonstration)
    survey = page.request.get(f"/api/surveys/{survey_id}").json()
    body = {name: survey[name] for name in ("name", "site", "description", "version")}
    body["insets"] = {"roof_unknown": {"inset_m": 0.6, "u_inset_m": 0.1, "note": "the crown"}}
    address = f"/api/surveys/{survey_id}"
    assert page.request.put(address, data=body, headers={"X-Sightline": "1"}).ok
    page.goto(f"/surveys/{survey_id}/checks?tab=again")
    expect(page.get_by_text("2 of them are in line scans.")).to_be_visible()
    page.get_by_role("button", name="Compute again", exact=True).click()
    rows = page.get_by_test_id("computed-heights").locator("tbody tr")
    expect(rows).to_have_count(2)
    expect(rows.first).to_contain_text("line scan")
    expect(rows.first.get_by_role("link")).to_have_attribute(
        "href", re.compile(r"/scan\?scan=\d+&vehicle=\d+")
    )
    expect(page.get_by_text("Change of each height in line scans")).to_be_visible()
    page.screenshot(path=screenshots / "again-lines-1440.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "again-lines-1024.png", full_page=True)
    french = browser.new_context(
        base_url=demonstration.url,
        storage_state=page.context.storage_state(),
        viewport={"width": 1440, "height": 900},
        locale="fr-FR",
    )
    theirs = french.new_page()
    theirs.goto(f"/surveys/{survey_id}/checks?tab=again")
    expect(theirs.get_by_test_id("computed-heights")).to_contain_text("balayage")
    theirs.screenshot(path=screenshots / "again-lines-fr.png", full_page=True)
    french.close()
    page.get_by_role("button", name="Undo all").click()
    runs = page.get_by_test_id("computings").locator("tbody tr")
    expect(runs).to_have_count(2)
    expect(runs.first).to_contain_text("undo")
    expect(page.get_by_text("2 of them are in line scans.")).to_be_visible()
