"""The statistics page: from the survey to its figures, filtered by link and by hand, downloaded, printed."""

import csv
import io
import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, StorageState, expect

from .server import Server


def saved(page: Page, title: str) -> tuple[str, str]:
    """(name, content) of the file behind a download button."""
    with page.expect_download() as waiting:
        page.get_by_title(title, exact=True).click()
    return waiting.value.suggested_filename, waiting.value.path().read_bytes().decode()


@pytest.mark.usefixtures("kept")
def test_figures_are_filtered_downloaded_and_linked(page: Page, survey_id: int) -> None:
    page.goto(f"/surveys/{survey_id}")
    page.locator(".step").get_by_role("link", name="Results").first.click()
    expect(page).to_have_url(re.compile(rf"/statistics\?survey={survey_id}$"))
    told = page.request.get(f"/api/statistics?survey={survey_id}").json()
    counted = page.get_by_test_id("stat-counted")
    expect(counted).to_contain_text(f"{told['counted']['measurements']} measurements")
    said = page.request.get(f"/api/surveys/{survey_id}/conclusion").json()["sentences"]
    expect(page.get_by_test_id("conclusion").locator("li")).to_have_text(said[1:])
    tabs = page.get_by_role("navigation", name="Results")
    tabs.get_by_role("link", name="Errors").click()
    row = page.get_by_test_id("errors-overall")
    expect(row).not_to_contain_text("Table 1")
    page.get_by_label("As in the paper").check()
    expect(row).to_contain_text("Table 1, “Overall”")

    page.get_by_label("Review state").select_option("all")
    everything = page.request.get(f"/api/statistics?survey={survey_id}&state=all&rounding=none").json()
    expect(counted).to_contain_text(f"{everything['counted']['measurements']} measurements")
    mae_m = everything["errors"]["groups"][2]["figures"]["mae_m"]["value"]
    expect(row).to_contain_text(f"{1000 * mae_m:.1f}")
    tabs.get_by_role("link", name="Heights and standards").click()
    expect(page.get_by_test_id("conclusion")).to_have_count(0)
    figure = page.get_by_test_id("figure-driver_eye-ecdf")
    expect(figure.locator("svg")).to_contain_text("AASHTO (USA) 1.08 m")
    eye = everything["targets"][0]
    place = [one["standard"]["name"] for one in eye["corrected"]["shares"]].index("AASHTO (USA)")
    # of true heights, where their interval is known; else of those measured
    total = (eye["total"] or {"shares": []})["shares"][place : place + 1]
    shares = [one["value"] for one in total if one["U95_low"] is not None]
    shares.append(eye["corrected"]["shares"][place]["share"])
    expect(page.get_by_test_id("shares-driver_eye")).to_contain_text(f"{100 * shares[0]:.1f} %")

    name, text = saved(page, "Driver’s eye, cumulative as CSV")
    rows = list(csv.reader(io.StringIO(text, newline="")))
    assert name == "sightline-driver_eye-ecdf.csv" and "\r\n" in text
    assert rows[0] == ["distribution", "height_m", "share", "band95_low", "band95_high", "n"]
    corrected = [float(row[1]) for row in rows if row[0] == "corrected"]
    assert corrected == everything["targets"][0]["corrected"]["ecdf"]["value"]
    name, drawn = saved(page, "Driver’s eye, cumulative as SVG")
    assert name.endswith(".svg") and "AASHTO" in drawn and "var(--" not in drawn

    page.get_by_label("Show AASHTO (USA), eye, passenger cars").uncheck()
    expect(figure.locator("svg")).not_to_contain_text("AASHTO")
    page.get_by_label("Own value for").select_option("eye_car")
    height = page.get_by_label("Height", exact=True)
    height.fill("12")
    page.keyboard.press("Enter")
    expect(page.get_by_text("Enter a height above 0")).to_be_visible()
    height.fill("1,12")
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("shares-driver_eye")).to_contain_text("own value, 1.12 m")

    page.get_by_text("More filters").click()
    page.get_by_label("Correction").select_option("regression")
    expect(page.get_by_test_id("correction-driver_eye")).to_contain_text("regression on the measured height")
    expect(page.get_by_test_id("target-taillight")).to_contain_text("extrapolates there and is not reliable")
    page.get_by_test_id("groups").get_by_text("Lighting").click()
    groups = everything["targets"][0]["groups"]["lighting"]["groups"]
    expect(page.get_by_test_id("groups").locator("tbody tr")).to_have_count(len(groups))
    page.get_by_label("Percentile", exact=True).fill("50")
    expect(page.get_by_test_id("sample-size")).to_contain_text("vehicles give percentile 50")

    page.get_by_role("button", name="Change this survey’s standards").click()
    page.get_by_label("Remove United Kingdom, high").click()
    page.get_by_role("button", name="Save for this survey").click()
    drawn = page.get_by_test_id("standards")
    expect(drawn).to_contain_text("United Kingdom, low")
    expect(drawn).not_to_contain_text("United Kingdom, high")

    # the link holds it all, and feet are only shown
    page.evaluate("localStorage.setItem('sightline.unit', '\"ft\"')")
    page.goto(page.url)
    expect(page.get_by_test_id("correction-driver_eye")).to_contain_text("regression on the measured height")
    expect(page.get_by_test_id("shares-driver_eye")).to_contain_text("own value")
    expect(drawn).to_contain_text("United Kingdom, low")
    expect(drawn).not_to_contain_text("United Kingdom, high")

    page.get_by_label("Measured from (UTC)").fill("2000-01-02")
    page.get_by_label("Measured to (UTC)").fill("2000-01-01")
    expect(page.get_by_role("alert")).to_contain_text("The last day is before the first")
    page.get_by_label("Measured to (UTC)").fill("2000-01-03")
    expect(page.get_by_text("No measurements match the filter")).to_be_visible()
    page.get_by_role("button", name="Clear filters").first.click()
    expect(counted).to_contain_text(f"{told['counted']['measurements']} measurements")


def test_a_figure_is_read_by_pointer_and_by_keys(page: Page, survey_id: int) -> None:
    page.goto(f"/statistics?survey={survey_id}&state=all&paper=1")
    reader = page.get_by_role("slider", name="Read values: Driver’s eye, cumulative")
    expect(reader).to_have_attribute("aria-valuetext", "Arrow keys move along the axis.")
    reader.focus()
    page.keyboard.press("End")
    expect(reader).to_have_attribute("aria-valuetext", re.compile(r"above the road.*; corrected: 100\.0"))
    page.keyboard.press("Home")
    expect(reader).to_have_attribute("aria-valuetext", re.compile(r"; corrected: 0\.0$"))
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Escape")
    expect(reader).to_have_attribute("aria-valuetext", "Arrow keys move along the axis.")
    reader.hover()
    expect(page.locator(".figure-reader__words")).to_contain_text("uncorrected:")


@pytest.mark.parametrize("locale", ["en-GB", "fr-FR"])
def test_the_first_screen_of_results_holds_the_whole_answer(
    browser: Browser,
    demonstration: Server,
    admin_state: StorageState,
    survey_id: int,
    locale: str,
    screenshots: Path,
) -> None:
    context = browser.new_context(
        base_url=demonstration.url,
        storage_state=admin_state,
        locale=locale,
        viewport={"width": 1440, "height": 900},
    )
    page = context.new_page()
    page.goto(f"/statistics?survey={survey_id}")
    asked = {"Accept-Language": locale}
    told = page.request.get(f"/api/surveys/{survey_id}/conclusion", headers=asked).json()["sentences"]
    answer = page.get_by_test_id("conclusion")
    expect(answer.locator("li")).to_have_text(told[1:])
    expect(page.get_by_test_id("same-rule")).to_be_visible()  # what comes after it moves it no more
    page.screenshot(path=screenshots / f"results-first-screen-{locale}.png")
    # so few vehicles give no verdict; the table says so before its rows do
    none = "No verdict on any standard yet" if locale == "en-GB" else "Aucune conclusion pour l’instant"
    expect(page.get_by_test_id("same-rule")).to_contain_text(none)
    box = answer.bounding_box()
    assert box and box["y"] >= 0 and box["y"] + box["height"] <= 900, box
    context.close()
