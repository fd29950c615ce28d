"""Reference speeds in a real browser: entered beside the vehicle, imported from a CSV, told on Results."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect


@pytest.mark.usefixtures("kept")
def test_references_are_entered_imported_and_compared(page: Page, survey_id: int, screenshots: Path) -> None:
    scan = page.request.get(f"/api/surveys/{survey_id}/scans").json()[0]
    vehicles = page.request.get(f"/api/scans/{scan['id']}/vehicles").json()
    measured = [one for one in vehicles if one["measurement"]["status"] == "ok"]
    first, second = measured[0], measured[1]
    page.goto(f"/surveys/{survey_id}/scan?scan={scan['id']}&vehicle={first['id']}")
    panel = page.get_by_role("region", name="Reference measurements")

    # a speedometer that shows 10 km/h too much is outside; one that says what it is worth is within
    shown = first["measurement"]["speed_mps"] * 3.6 + 10
    panel.get_by_role("button", name="Add a reference").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Measured by").select_option("counter")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("Enter a number above 0.")).to_be_visible()
    dialog.get_by_label("Value").fill(f"{shown:.1f}")
    dialog.get_by_label("Standard uncertainty").fill("1")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).to_have_count(0)
    counter = panel.get_by_test_id("scan-reference").filter(has_text="speedometer")
    expect(counter).to_contain_text(f"{shown:.1f} ± 2.0 km/h")
    expect(counter).to_contain_text(re.compile(r"outside ±\s1.9"))
    counter.get_by_role("button", name="Edit Speed, speedometer").click()
    dialog.get_by_label("Standard uncertainty").fill("8")
    dialog.get_by_role("button", name="Save").click()
    expect(counter).to_contain_text("within ± 15.68")
    page.screenshot(path=screenshots / "references.png")

    text = (
        "number,source,speed_kmh,u_speed_kmh,run_of\n"
        f"{first['number']},gps,70,0.2,The Golf\n{second['number']},,,,The Golf\n99,gps,70,0.2,\n"
    )
    panel.get_by_role("button", name="Import CSV").click()
    file = {"name": "gps.csv", "mimeType": "text/csv", "buffer": text.encode()}
    page.locator("input[type=file]").set_input_files(file)
    lines = page.get_by_test_id("reference-lines")
    expect(lines).to_contain_text("This recording has no vehicle 99.")
    expect(page.get_by_test_id("reference-counts")).to_contain_text("2 new")
    page.screenshot(path=screenshots / "references-import.png")
    dialog.get_by_role("button", name="Import 2 lines").click()
    expect(dialog).to_contain_text("1 reference value and 2 car names imported.")
    dialog.get_by_role("button", name="Close").last.click()
    expect(panel).to_contain_text("Speed, GPS: 70.0 ± 0.4 km/h")
    expect(panel.get_by_label("Run of car")).to_have_value("The Golf")

    # by time of day: one vehicle alone fits the line, or none; the tolerance is shown and can be changed
    lines_of = [f"{one['filmed_at'][11:23]},gps,70,0.2,The Golf" for one in (first, second)]
    late = f"{int(first['filmed_at'][11:13]) - 1:02d}:00:00,gps,70,0.2,"
    text = "\n".join(["time,source,speed_kmh,u_speed_kmh,run_of", *lines_of, late])
    panel.get_by_role("button", name="Import CSV").click()
    file = {"name": "times.csv", "mimeType": "text/csv", "buffer": text.encode()}
    page.locator("input[type=file]").set_input_files(file)
    lines = page.get_by_test_id("reference-lines")
    expect(lines).to_contain_text(f"{first['number']} (by time)")
    expect(lines).to_contain_text("No vehicle passed within 1 s of")
    expect(page.get_by_test_id("reference-counts")).to_contain_text("1 refused")
    page.screenshot(path=screenshots / "references-times-1440.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "references-times-1024.png")
    page.set_viewport_size({"width": 1440, "height": 900})
    dialog.get_by_label("Time tolerance").fill("60")
    dialog.get_by_label("Time tolerance").press("Enter")
    expect(lines).to_contain_text("passed within 60 s of")
    expect(page.get_by_test_id("reference-counts")).to_contain_text("2 ambiguous")
    dialog.get_by_role("button", name="Cancel").click()

    page.goto(f"/surveys/{survey_id}/scans/results")
    page.get_by_role("radio", name="Include unreviewed").click()
    errors = page.get_by_test_id("scan-reference-errors")
    expect(errors).to_contain_text("Speed, radar")
    expect(errors).to_contain_text("Speed, all sources")
    cars = page.get_by_test_id("scan-cars")
    expect(cars).to_contain_text("2 runs:")
    # they are two models of the demonstration under one name
    expect(cars).to_contain_text("Differ by more than stated")
    expect(page.get_by_test_id("scan-table-own")).to_contain_text("70.0 GPS")

    page.goto(f"/surveys/{survey_id}/scan?scan={scan['id']}&vehicle={first['id']}")
    for source in ("GPS", "speedometer"):
        one = panel.get_by_test_id("scan-reference").filter(has_text=source)
        one.get_by_role("button", name="Remove").click()
        expect(one).to_have_count(0)
