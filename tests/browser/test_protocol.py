"""The protocol of a study on the demonstration: sides, targets, place and quotas said, vehicles of both lanes
and lightings measured, an eye that cannot be seen answered, heights judged, a package of some vehicles built.
"""

import io
import re
import time
import zipfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

from tests.export.report.pdf_text import words

from .conftest import choose_plan
from .picture import on_screen
from .server import Server
from .vehicles import OwnVehicle, own_vehicle, until, whole_passes

KEYS = {"roof": "1", "driver_eye": "2", "taillight": "3"}


@pytest.fixture
def reviewer(page: Page, browser: Browser, demonstration: Server) -> Iterator[Page]:
    """Another person's browser: nobody accepts a lot with heights of their own."""
    made = page.request.post(
        "/api/people",
        headers={"X-Sightline": "1"},
        data={"name": "Rita Reviewer", "email": f"rita{time.time_ns()}@example.org", "role": "reviewer"},
    )
    assert made.ok, made.text()
    context = browser.new_context(base_url=demonstration.url, viewport={"width": 1440, "height": 900})
    theirs = context.new_page()
    theirs.goto(made.json()["link"])
    theirs.wait_for_url(lambda url: "sign-in" not in url)
    yield theirs
    context.close()


@pytest.mark.usefixtures("kept")
def test_the_protocol_from_sides_to_a_package(
    page: Page, reviewer: Page, demonstration: Server, survey_id: int, screenshots: Path
) -> None:
    _say_the_site(page, survey_id, screenshots)
    _say_the_quotas(page, survey_id)
    by_day = whole_passes("day")
    near, far = (next(one for one in by_day if one["driver_side"] == side) for side in ("near", "far"))
    day = [own_vehicle(page, "day", over) for over in (near, far)]
    night = own_vehicle(page, "low_light")
    before = _measured(page, survey_id)
    rng = np.random.default_rng(12)
    _measure(page, day[0], ("roof", "driver_eye"), rng)
    _measure(page, day[1], ("roof",), rng)
    _not_visible(page, day[1], screenshots)
    _measure(page, night, ("roof", "taillight"), rng)
    after = _measured(page, survey_id)
    assert after == {"daytime": before["daytime"] + 2, "low_light": before["low_light"] + 1}
    _heights_hold(page, [*day, night])
    choose_plan(page, survey_id, 0)
    _review(reviewer, survey_id, 2)
    _lot(reviewer, survey_id, screenshots)
    _package(page, survey_id, screenshots)


def _say_the_site(page: Page, survey_id: int, screenshots: Path) -> None:
    page.goto(f"/surveys/{survey_id}/settings")
    page.get_by_role("button", name="Edit", exact=True).click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Traffic keeps").select_option("right")
    dialog.get_by_label("Steering wheel usually").select_option("left")
    dialog.get_by_label("Camera position").select_option("verge")
    asked = dialog.get_by_test_id("asked")
    for n, target, wanted in ((0, "Taillight", False), (1, "Driver’s eye", False), (1, "Taillight", True)):
        asked.get_by_label(target).nth(n).set_checked(wanted)
    place = dialog.get_by_test_id("place")
    place.get_by_label("Latitude").fill("149.44315")
    place.get_by_label("Longitude").fill("1,09932")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog.get_by_text("Are latitude and longitude swapped?")).to_be_visible()
    place.get_by_label("Latitude").fill("49.44315")
    place.get_by_label("Speed limit").fill("50")
    place.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "protocol-site.png")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).not_to_be_visible()
    page.get_by_role("link", name="Overview").click()
    expect(page.get_by_test_id("place-said")).to_contain_text("49.44315, 1.09932")
    expect(page.get_by_test_id("place-said")).to_contain_text("limit 50 km/h")
    expect(page.get_by_test_id("traffic-said")).to_contain_text("roof and driver’s eye")


def _say_the_quotas(page: Page, survey_id: int) -> None:
    page.goto(f"/surveys/{survey_id}/settings")
    page.get_by_test_id("sample").get_by_role("button", name="Change the sample").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Daytime, any class").fill("400")
    dialog.get_by_label("Low light, any class").fill("250")
    dialog.get_by_role("button", name="Save").click()
    expect(dialog).not_to_be_visible()
    expect(page.get_by_test_id("quotas")).to_contain_text("of 400")


def _measured(page: Page, survey_id: int) -> dict[str, int]:
    found = page.request.get(f"/api/surveys/{survey_id}/sample").json()
    return {one["lighting"]: one["measured"] for one in found["quotas"]}


def _measure(page: Page, one: OwnVehicle, targets: tuple[str, ...], rng: np.random.Generator) -> None:
    page.goto(one.address)
    expect(page.get_by_test_id("quotas")).to_contain_text("of 400")
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}").locator("time")).to_be_visible()
    page.get_by_test_id("frame-view").focus()
    for position, target in enumerate(targets):
        page.keyboard.press(KEYS[target])
        if position == 0:
            _click(page, one.pixels["contact_rear"], rng)
            expect(page.get_by_test_id("axes")).to_be_visible()
        _click(page, one.pixels[target], rng)
        expect(page.get_by_test_id(f"measurement-row-{target}")).to_contain_text(re.compile(r"\d\.\d{3}"))
    until(page, one.vehicle["id"], lambda have: set(targets) <= set(have))


def _click(page: Page, pixel: tuple[float, float], rng: np.random.Generator) -> None:
    x, y = np.array(pixel) + rng.normal(0.0, 0.5, 2)
    spot = on_screen(page, (float(x), float(y)))
    page.mouse.move(*spot)
    page.mouse.click(*spot)


def _not_visible(page: Page, one: OwnVehicle, screenshots: Path) -> None:
    """The driver of the far lane is not seen: one button, one digit, and the vehicle is done."""
    page.keyboard.press(KEYS["driver_eye"])
    page.get_by_role("button", name="Not visible").click()
    expect(page.get_by_test_id("unseen-reasons")).to_be_visible()
    page.keyboard.press("6")
    expect(page.get_by_test_id("unseen-driver_eye")).to_contain_text("no driver seen")
    row = page.get_by_test_id(f"pass-{one.vehicle['number']}")
    expect(row).to_have_attribute("data-state", "measured")
    page.screenshot(path=screenshots / "protocol-unseen.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "protocol-unseen-1024.png")
    page.set_viewport_size({"width": 1440, "height": 900})


def _heights_hold(page: Page, chosen: list[OwnVehicle]) -> None:
    """Each height lies within its interval and a half of the truth; an eye's side is that of its lane."""
    for one in chosen:
        found = page.request.get(f"/api/vehicles/{one.vehicle['id']}").json()
        assert found["filmed_at"].startswith("2025-05-14T"), found["filmed_at"]
        assert found["side"] == one.truth["driver_side"]
        for made in found["measurements"]:
            error = made["height_m"] - one.truth["true_heights_m"][made["target"]]
            assert abs(error) < 1.5 * made["U95_height_m"], (made["target"], error)


def _lot(page: Page, survey_id: int, screenshots: Path) -> None:
    """What still waits as one lot: its sample drawn, judged by key, the lot accepted.

    So few heights make a lot only with risks that no study would take.
    """
    lots = f"/surveys/{survey_id}/lots"
    page.goto(lots)
    for common in ("target", "lighting"):
        page.get_by_role("checkbox", name=common, exact=True).uncheck()
    page.get_by_label("Share of wrong heights at which a lot should not pass").fill("60")
    page.get_by_label("Risk that it does", exact=True).fill("30")
    expect(page.get_by_test_id("lots-planned").locator("tbody tr")).to_have_count(1)
    page.get_by_role("button", name="Draw", exact=True).click()
    expect(page.get_by_test_id("lot-words")).to_contain_text("of the sample still wait")
    size, sample = (int(one) for one in re.findall(r"\d+", page.get_by_test_id("lot-words").inner_text())[:2])
    assert 1 <= sample < size
    page.screenshot(path=screenshots / "protocol-lot.png")
    page.get_by_role("link", name="Review the sample").click()
    expect(page.locator(".review__row")).to_have_count(sample)
    for _ in range(sample):
        expect(page.get_by_test_id("review-accept").get_by_role("button")).to_be_enabled()
        with page.expect_response(lambda answer: answer.url.endswith("/reviews") and answer.status == 201):
            page.keyboard.press("a")
    page.get_by_role("link", name="Decide on the lot").first.click()  # after the last verdict
    expect(page.get_by_test_id("lot-words")).to_contain_text("The lot can be accepted")
    page.get_by_test_id("lot").get_by_role("button", name="Accept the lot").click()
    expect(page.get_by_test_id("lot-words")).to_contain_text(f"{size - sample} heights accepted with it")


def _review(page: Page, survey_id: int, so_many: int) -> None:
    accepted = page.request.get(f"/api/surveys/{survey_id}/review-work").json()["accepted"]
    page.goto(f"/surveys/{survey_id}/review")
    for n in range(1, so_many + 1):
        expect(page.get_by_test_id("review-accept")).to_be_visible()
        page.keyboard.press("a")
        expect(page.get_by_test_id("review-counts")).to_contain_text(f"{accepted + n} accepted")


def _package(page: Page, survey_id: int, screenshots: Path) -> None:
    page.goto(f"/surveys/{survey_id}/export")
    page.get_by_label("Lighting").select_option("daytime")
    page.get_by_label("Filmed from").fill("2025-05-14")
    page.get_by_label("with images of the clicks").uncheck()
    page.screenshot(path=screenshots / "protocol-export.png")
    page.get_by_role("button", name="Build the package").click()
    row = page.get_by_role("row").filter(has_text="Daytime; filmed from 2025-05-14")
    expect(row).to_be_visible(timeout=120_000)
    with page.expect_download() as waiting:
        row.get_by_role("link", name="Download").click()
    with zipfile.ZipFile(io.BytesIO(waiting.value.path().read_bytes())) as package:
        chosen = package.read("tables/selection.csv").decode().splitlines()
        assert chosen == ["by,word", "lighting,daytime", "filmed_from,2025-05-14"]
        report = " ".join(words(package.read("report.pdf")).split())
        survey = package.read("tables/survey.csv").decode()
    assert "Only: daytime; filmed from 2025-05-14." in report
    assert re.search(r"2025-05-14 08:10 to 21:40 \(Europe/Paris\)", report)
    assert "49.44315" in survey
    page.goto(f"/statistics?survey={survey_id}&state=all&filmed_from=2025-05-15")
    expect(page.get_by_test_id("stat-counted")).to_contain_text("0 vehicles")
    page.screenshot(path=screenshots / "protocol-statistics.png")
