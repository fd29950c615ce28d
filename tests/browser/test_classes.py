"""Classes of vehicles: a survey sorts one into another set, statistics and a package follow, and say so."""

import io
import zipfile
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.export.report.pdf_text import words


@pytest.mark.usefixtures("kept")
def test_a_set_is_edited_and_a_package_of_it_is_built(page: Page, survey_id: int, screenshots: Path) -> None:
    asked = f"/api/statistics?survey={survey_id}&state=all&class_set=light_trucks"
    before = page.request.get(asked).json()["counted"]["vehicles"]

    page.goto(f"/surveys/{survey_id}/settings")
    page.get_by_role("button", name="Classes").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("FHWA classes of SUV").fill("3-14")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("numbers from 1 to 13")).to_be_visible()
    dialog.get_by_label("FHWA classes of SUV").fill("3")
    for body in ("Hatchback", "Saloon", "Estate", "SUV"):
        dialog.get_by_label(f"Set of {body}").select_option("light_trucks")
    page.screenshot(path=screenshots / "classes.png")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).not_to_be_visible()
    after = page.request.get(asked).json()["counted"]["vehicles"]
    assert after > before

    page.goto(f"/statistics?survey={survey_id}&state=all")
    page.locator("summary").filter(has_text="all classes").click()
    page.get_by_label("Light trucks and multi-purpose").check()
    page.get_by_label("Lorry").check()
    page.screenshot(path=screenshots / "classes-filter.png")
    expect(page).to_have_url(
        f"/statistics?survey={survey_id}&state=all&class_set=light_trucks&category=lorry"
    )
    # lorries of other tests count too: the page asks for both
    both = page.request.get(f"{asked}&category=lorry").json()["counted"]["vehicles"]
    expect(page.get_by_test_id("stat-counted")).to_contain_text(f"{both} vehicles")

    page.goto(f"/surveys/{survey_id}/export")
    page.get_by_label("Lighting").select_option("daytime")
    page.locator("summary").filter(has_text="all classes").click()
    page.get_by_label("Light trucks and multi-purpose").check()
    page.keyboard.press("Escape")
    expect(page.get_by_label("Heavy vehicles")).not_to_be_visible()
    page.get_by_label("with images of the clicks").uncheck()
    page.get_by_role("button", name="Build the package").click()
    row = page.get_by_role("row").filter(has_text="Daytime; Light trucks and multi-purpose")
    expect(row).to_be_visible(timeout=120_000)
    page.screenshot(path=screenshots / "classes-export.png")
    with page.expect_download() as waiting:
        row.get_by_role("link", name="Download").click()
    with zipfile.ZipFile(io.BytesIO(waiting.value.path().read_bytes())) as package:
        assert package.read("tables/selection.csv").decode().splitlines() == [
            "by,word",
            "lighting,daytime",
            "class_set,light_trucks",
        ]
        report = " ".join(words(package.read("report.pdf")).split())
    assert "Only: daytime; light trucks and multi-purpose vehicles." in report
