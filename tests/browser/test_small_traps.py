"""Small traps of daily use: what a page said that was not so, what got in the way, what a slip lost."""

import re
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest
from playwright.sync_api import Page, Route, expect

from .server import Server
from .test_narrow import apart
from .vehicles import own_vehicle
from .waits import wait_until

HEADERS = {"X-Sightline": "1"}


def numbers_of(page: Page) -> list[int]:
    cells = page.locator("table.audit tbody tr td:first-child").all_inner_texts()
    return [int(re.sub(r"\D", "", one)) for one in cells]


def test_a_surveys_audit_events_are_numbered_without_a_gap_and_its_jobs_named(
    page: Page, survey_id: int
) -> None:
    page.goto(f"/audit?survey_id={survey_id}")
    expect(page.get_by_text("a filtered list has gaps")).to_be_visible()
    rows = page.locator("table.audit tbody tr")
    wait_until(page, lambda: rows.count() >= 100)
    seen = numbers_of(page)
    assert seen == list(range(seen[0], seen[0] - len(seen), -1))
    page.goto(f"/audit?survey_id={survey_id}&entity=job")
    expect(page.get_by_text("job “Camera stability check”").first).to_be_visible()
    # beside the columns that changed there is room for what was done
    did = page.locator("td.audit__did").first.bounding_box()
    assert did is not None and did["width"] >= 240


def test_a_job_that_is_done_does_not_say_what_it_did_last(page: Page) -> None:
    page.goto("/jobs?state=done")
    row = page.get_by_role("row", name=re.compile("Camera stability check")).first
    expect(row).to_be_visible()
    expect(row).not_to_contain_text("Searching")


def test_the_rigs_plan_says_what_the_rig_measures(page: Page, survey_id: int) -> None:
    """0.593 m and 2441 lines/s at 120 km/h: ± 0.15 km/h by 0.23 mm of registering and 0.3 mm of baseline."""
    page.goto(f"/surveys/{survey_id}/planning?plan=lines")
    plan = page.get_by_test_id("line-plan")
    expect(plan).to_contain_text("120.00 ± 0.15 km/h")
    expect(plan).to_contain_text("does not need these line rates")
    expect(plan).not_to_contain_text("more than the 1 % allowed")


def test_a_bench_without_a_recording_is_the_list_where_one_is_chosen(page: Page, survey_id: int) -> None:
    page.goto(f"/surveys/{survey_id}/scan")
    expect(page).to_have_url(re.compile(rf"/surveys/{survey_id}/scans$"))
    expect(page.locator("article.scan-card")).to_have_count(1)
    expect(page.locator("nav.rail")).to_be_visible()


def test_a_study_without_a_number_is_the_list_where_one_is_chosen(page: Page) -> None:
    page.goto("/study")
    expect(page).to_have_url(re.compile("/studies$"))


def test_in_a_narrow_window_a_line_scans_card_is_whole(page: Page, survey_id: int) -> None:
    page.set_viewport_size({"width": 1024, "height": 768})
    page.goto(f"/surveys/{survey_id}/scans")
    card = page.locator("article.scan-card")
    box, way = card.bounding_box(), card.get_by_role("link", name="Open").bounding_box()
    assert box and way and way["x"] + way["width"] < box["x"] + box["width"]


def test_a_recordings_card_names_its_file_as_the_file_is_named(page: Page, survey_id: int) -> None:
    recording = page.request.get(f"/api/surveys/{survey_id}/recordings").json()[0]
    assert recording["name"].endswith(".mp4") and recording["container"].startswith("mov,")
    page.goto(f"/surveys/{survey_id}/recordings")
    expect(page.locator(".recording__facts").first).to_contain_text(f"{recording['codec']} in mp4")


def test_the_camera_of_a_plan_is_read_whole_in_a_narrow_window(page: Page, survey_id: int) -> None:
    page.set_viewport_size({"width": 1024, "height": 768})
    page.goto(f"/surveys/{survey_id}/planning")
    choice = page.get_by_label("Camera", exact=True)
    expect(choice.locator("option:checked")).to_have_text(re.compile(r", calibration \d+ of .+ \(current\)$"))
    wide = """one => { const drawn = document.createElement("canvas").getContext("2d");
        drawn.font = getComputedStyle(one).font;
        return drawn.measureText(one.selectedOptions[0].text).width }"""
    box = choice.bounding_box()
    assert box and choice.evaluate(wide) < box["width"] - 40
    expect(page.locator(".plan-form")).to_contain_text("views used")


def test_in_a_narrow_window_the_tabs_of_review_stand_in_one_row(page: Page, survey_id: int) -> None:
    page.set_viewport_size({"width": 1024, "height": 768})
    page.goto(f"/surveys/{survey_id}/review")
    tabs = page.locator(".review .page-tabs > *")
    expect(tabs).to_have_count(3)
    assert len({one.evaluate("one => one.offsetTop") for one in tabs.all()}) == 1


def test_a_year_outside_the_models_moves_no_field(page: Page, survey_id: int) -> None:
    recording = page.request.get(f"/api/surveys/{survey_id}/recordings").json()[0]["id"]
    facts = {"first_frame": 0, "last_frame": 8, "make": "Corvane", "model": "Lindo"}
    made = page.request.post(f"/api/recordings/{recording}/vehicles", headers=HEADERS, data=facts)
    assert made.ok, made.text()
    vehicle = made.json()["id"]
    page.goto(f"/surveys/{survey_id}/measure?vehicle={vehicle}")
    year, category = page.get_by_label("Year", exact=True), page.get_by_label("Category", exact=True)
    expect(year).to_be_enabled()

    def stairs_px() -> float:
        """By how much one field's lower edge lies under the other's, both read in one moment."""
        read = "(one, other) => one.getBoundingClientRect().bottom - other.getBoundingClientRect().bottom"
        return abs(float(year.evaluate(read, category.element_handle())))

    assert stairs_px() < 2
    year.fill("1999")
    year.blur()
    expect(page.get_by_test_id("model-years")).not_to_be_empty()
    assert stairs_px() < 2
    year.fill("2090")
    year.blur()
    expect(page.get_by_text("Enter a year from 1885 to")).to_be_visible()
    assert stairs_px() < 2


def test_the_head_of_the_list_counts_like_the_overview(page: Page, survey_id: int) -> None:
    told = page.request.get(f"/api/surveys/{survey_id}/vehicles").json()
    states = [one["state"] for one in told]
    to_do, rejected = sum(one in ("to_do", "partial") for one in states), states.count("rejected")
    page.goto(f"/surveys/{survey_id}/measure")
    head = f"{to_do} to do" + (f", {rejected} rejected" if rejected else "")
    expect(page.locator(".passes__head h2")).to_contain_text(re.compile(rf"Passes\s+{head}$"))


def test_a_start_that_no_file_states_is_entered_not_confirmed(page: Page, survey_id: int) -> None:
    def unknown(route: Route) -> None:
        given = route.fetch()
        nothing: dict[str, Any] = {"started_local": None, "started_at": None, "start_proposed": None}
        route.fulfill(response=given, json=[{**one, **nothing} for one in given.json()])

    page.route(re.compile(r"/api/surveys/\d+/recordings$"), unknown)
    page.goto(f"/surveys/{survey_id}/recordings")
    line = page.get_by_test_id("filmed").first
    expect(line).to_contain_text("the file contains no time")
    expect(line.get_by_role("button")).to_have_text("Enter the start")


def test_words_of_the_corner_leave_the_verdicts_free(page: Page, survey_id: int) -> None:
    page.set_viewport_size({"width": 1024, "height": 768})
    page.goto(f"/surveys/{survey_id}/review?state=all")
    accept, toasts = page.get_by_test_id("review-accept"), page.locator(".toasts")
    # the first of the queue may be drawn for a blind check, which has nothing to accept yet
    page.get_by_role("navigation", name="Queue").get_by_role("button").filter(has_text="±").first.click()
    expect(accept).to_be_visible()
    toasts.evaluate("one => one.insertAdjacentHTML('beforeend', '<p class=toast>Undone: verdict.</p>')")
    assert apart(toasts, accept) and apart(toasts, page.get_by_test_id("review-reject"))


def test_a_refusal_offers_no_second_try(page: Page, survey_id: int) -> None:
    page.goto(f"/statistics?survey={survey_id}&filmed_from=2030-01-01&filmed_to=2020-01-01")
    expect(page.get_by_text("The last day is before the first; swap them.")).to_be_visible()
    expect(page.get_by_role("button", name="Try again")).to_have_count(0)


def test_esc_asks_before_it_loses_what_was_typed(page: Page, survey_id: int) -> None:
    page.goto(f"/surveys/{survey_id}/settings")
    page.get_by_role("button", name="Edit", exact=True).click()
    form = page.get_by_role("dialog", name="Edit the survey")
    name = form.get_by_label("Name", exact=True)
    name.fill("")
    form.get_by_role("button", name="Save").click()
    expect(form.get_by_text("Enter a name for the survey.")).to_be_visible()
    expect(form.get_by_text("of the body")).to_have_count(0)
    name.fill("Typed for nothing")
    page.keyboard.press("Escape")
    asked = page.get_by_role("dialog", name="Discard what you entered?")
    asked.get_by_role("button", name="Cancel").click()
    expect(name).to_have_value("Typed for nothing")
    page.keyboard.press("Escape")
    asked.get_by_role("button", name="Discard").click()
    expect(form).to_have_count(0)
    assert page.request.get(f"/api/surveys/{survey_id}").json()["name"] != "Typed for nothing"


@pytest.mark.parametrize("low", [None, 47.0])
def test_no_band_is_spoken_of_where_there_is_no_interval(
    page: Page, survey_id: int, low: float | None
) -> None:
    def told(route: Route) -> None:
        given = route.fetch()
        answer = given.json()
        for case in answer["cases"]:
            case["k_m"] = [{**one, "low": low, "high": low and 49.0} for one in case["k_m"] or []]
        route.fulfill(response=given, json=answer)

    page.route(re.compile(r"/api/.*sightdistance\?"), told)
    page.goto(f"/sight-distance?survey={survey_id}&state=all&eye_percent=50&object_percent=50")
    said = "There is no interval, so no band is drawn." if low is None else "it is narrower than the line"
    expect(page.get_by_text(said)).to_be_visible()


@pytest.mark.usefixtures("kept")
def test_what_does_not_fit_and_what_has_no_class_stand_in_the_list(
    page: Page, demonstration: Server, screenshots: Path
) -> None:
    """A lorry with a car's roof, and a vehicle of which nobody said the class: a mark, a filter, a count."""
    own = own_vehicle(page, "day")
    path, number = f"/api/vehicles/{own.vehicle['id']}", own.vehicle["number"]
    clicked = {"target": "roof", "frame": own.frame, "client_key": str(uuid4())}
    clicked |= {"contact": own.pixels["contact_rear"], "target_point": own.pixels["roof"]}
    made = page.request.post(f"{path}/measurements", headers=HEADERS, data=clicked)
    assert made.ok, made.text()
    page.goto(own.address)
    mark, row = page.get_by_test_id(f"look-{number}"), page.get_by_test_id(f"pass-{number}")
    expect(mark).to_have_attribute("title", "The class is missing.")
    page.get_by_label("Show", exact=True).select_option("no_class")
    expect(row).to_be_visible()
    expect(page.get_by_label("Category", exact=True)).to_have_accessible_description(
        re.compile("the inset of the roof")
    )
    page.goto(f"/statistics?survey={own.survey}&state=all")
    page.get_by_role("link", name=re.compile("Choose (it|them) in Measure")).click()
    expect(page).to_have_url(re.compile(rf"/surveys/{own.survey}/measure"))

    version = page.request.get(path).json()["version"]
    said = page.request.put(path, headers=HEADERS, data={"category": "lorry", "version": version})
    assert said.ok, said.text()
    page.goto(own.address)
    expect(row).to_have_count(0)  # it has a class now
    page.get_by_label("Show", exact=True).select_option("doubtful")
    expect(row).to_be_visible()
    expect(mark).to_have_attribute("title", "One height is unusual: check it again.")
    page.screenshot(path=screenshots / "doubts-in-the-list.png")
