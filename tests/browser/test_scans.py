"""The line-scan bench in a real browser: vehicles, boundaries by keyboard, wheels by two clicks, undo."""

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Locator, Page, StorageState, expect

from tests.simulation.make import RODS, SITE
from tests.simulation.scan_rod import row_of

from .server import Server
from .waits import keep_toasts

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def scan(page: Page, survey_id: int) -> dict[str, Any]:
    """The demonstration's line scan."""
    found: dict[str, Any] = page.request.get(f"/api/surveys/{survey_id}/scans").json()[0]
    return found


def vehicle_of(page: Page, scan: dict[str, Any], number: int) -> dict[str, Any]:
    all_of_it = page.request.get(f"/api/scans/{scan['id']}/vehicles").json()
    return next(one for one in all_of_it if one["number"] == number)


def x_of(strips: Locator, line: float, first: float, last: float) -> float:
    """Where a line lies in a window that shows a vehicle with a quarter of it before and behind."""
    box = strips.bounding_box()
    assert box
    span = last - first
    return box["x"] + (line - first + 0.25 * span) / (1.5 * span) * box["width"]


def test_the_bench_from_the_list_to_a_corrected_and_reviewed_vehicle(
    page: Page, scan: dict[str, Any], screenshots: Path
) -> None:
    page.goto(f"/surveys/{scan['survey_id']}/scans")
    card = page.get_by_test_id(f"scan-{scan['id']}")
    expect(card).to_contain_text("vehicles")
    card.get_by_role("link", name="Open").click()
    expect(page).to_have_url(re.compile(rf"scan\?scan={scan['id']}"))
    before = vehicle_of(page, scan, 2)["measurement"]
    row = page.get_by_test_id("scan-vehicle-2")
    row.get_by_role("button").click()
    speed, length = page.get_by_test_id("scan-speed"), page.get_by_test_id("scan-length")
    expect(speed).to_contain_text(f"{before['speed_mps'] * 3.6:.2f}")
    expect(length).to_contain_text(f"{before['length_m']:.3f}")
    expect(page.get_by_test_id("figure-speed-profile-2").locator("svg")).to_be_visible()

    # the front at camera 1 by keyboard, ten lines earlier: a longer vehicle, a revision, an undo
    strips = page.get_by_test_id("strips")
    strips.focus()
    page.keyboard.press("q")
    page.keyboard.press("w")
    with page.expect_response(lambda answer: answer.url.endswith("/boundaries")) as stored:
        page.keyboard.press("Shift+ArrowLeft")
    changed = stored.value.json()["measurement"]
    assert changed["front_line_1"] == pytest.approx(before["front_line_1"] - 10)
    assert changed["placed_by_person"] and changed["revision"] == before["revision"] + 1
    expect(length).to_contain_text(f"{changed['length_m']:.3f}")
    with page.expect_response(lambda answer: answer.url.endswith("/boundaries")):
        page.get_by_test_id("undo").get_by_role("button").click()
    expect(length).to_contain_text(f"{before['length_m']:.3f}")
    page.screenshot(path=screenshots / "scan-bench.png")

    # both hubs by two clicks
    third = vehicle_of(page, scan, 4)["measurement"]
    page.get_by_test_id("scan-vehicle-4").get_by_role("button").click()
    expect(speed).to_contain_text(f"{third['speed_mps'] * 3.6:.2f}")
    strips.focus()
    page.keyboard.press("q")
    page.keyboard.press("u")
    asked = page.locator(".strips__asked")
    expect(asked).to_contain_text("front wheel")
    first, last = third["front_line_1"], max(third["rear_line_1"], third["rear_line_2"])
    lines = [first + share * (third["rear_line_1"] - first) for share in (0.2, 0.8)]
    box = strips.bounding_box()
    assert box
    page.mouse.click(x_of(strips, lines[0], first, last), box["y"] + 60)
    expect(asked).to_contain_text("rear wheel")
    with page.expect_response(lambda answer: answer.url.endswith("/wheels")) as placed:
        page.mouse.click(x_of(strips, lines[1], first, last), box["y"] + 60)
    wheelbase = placed.value.json()["measurement"]
    assert wheelbase["front_wheel_line"] == pytest.approx(lines[0], abs=0.02 * (last - first))
    expect(page.get_by_test_id("scan-wheelbase")).to_contain_text(f"{wheelbase['wheelbase_m']:.3f}")


def test_an_empty_survey_says_what_to_do_and_takes_two_strips(page: Page) -> None:
    headers = {"X-Sightline": "1"}
    made = page.request.post("/api/surveys", data={"name": "Strips"}, headers=headers)
    page.goto(f"/surveys/{made.json()['id']}/scans")
    send = page.get_by_role("button", name="Import and find the vehicles")
    expect(send).to_be_disabled()
    page.locator("input[type=file]").set_input_files(
        [{"name": name, "mimeType": "image/png", "buffer": b"no picture"} for name in ("a.png", "b.png")]
    )
    expect(page.get_by_label("Camera 2")).to_contain_text("b.png")
    expect(send).to_be_enabled()
    send.click()
    expect(page.get_by_text("Enter the distance between the two scanning planes.")).to_be_visible()
    page.get_by_label("Baseline", exact=True).fill("0.593")
    page.get_by_label("Line rate", exact=True).fill("4882.8")
    send.click()
    problem = page.get_by_role("alert").first
    expect(problem).to_contain_text("a.png")


def test_what_the_traffic_says_of_the_rig_is_put_in_force_and_taken_back(
    page: Page, scan: dict[str, Any]
) -> None:
    keep_toasts(page)
    address = f"/api/scans/{scan['id']}"
    told = page.request.get(f"{address}/rig-of-traffic").json()["misalignment"]
    page.goto(f"/surveys/{scan['survey_id']}/scans")
    card = page.get_by_test_id(f"scan-{scan['id']}")
    card.get_by_text("Rig, and estimates from the traffic").click()
    table = card.get_by_test_id("rig-of-traffic")
    expect(table).to_contain_text(f"{told['value']:.3f}")
    card.get_by_role("button", name="Use this for Misalignment").click()
    dialog = page.get_by_role("dialog")
    expect(dialog.get_by_label("Misalignment", exact=True)).to_have_value(f"{told['value']:.4f}")
    dialog.get_by_role("button", name="Save", exact=True).click()
    expect(dialog).to_be_hidden()
    in_force = page.request.get(address).json()["rig"]
    assert in_force["misalignment_px"] == pytest.approx(told["value"], abs=1e-4)
    assert in_force["baseline_m"] == scan["rig"]["baseline_m"]
    page.get_by_role("button", name="Undo").click()
    expect(table).to_contain_text("from the traffic")
    assert page.request.get(address).json()["rig"] == scan["rig"]


def test_a_line_rate_is_planned_with_the_surveys_rig(page: Page, scan: dict[str, Any]) -> None:
    page.goto(f"/surveys/{scan['survey_id']}/scans")
    page.locator("a.btn", has_text="Plan the site").click()  # the rail has its name too
    expect(page.get_by_label("Camera’s line rate")).to_have_value(f"{scan['rig']['line_rate_hz']:g}")
    plan = page.get_by_test_id("line-plan")
    expect(plan).to_contain_text("2 / (n + 2)")
    page.get_by_label("Camera’s line rate").fill("")
    page.get_by_label("Camera’s line rate").blur()
    page.get_by_label("Baseline", exact=True).fill("1")
    page.get_by_label("Baseline", exact=True).blur()
    expect(plan).to_contain_text(re.compile(r"6[,\s]?667\sHz"))
    page.reload()
    expect(plan).to_contain_text(re.compile(r"6\s?600\sHz"))


def test_heights_of_a_line_scan_are_reviewed(page: Page, scan: dict[str, Any], screenshots: Path) -> None:
    """In the queue of the others, on their strips: accepted, rejected with a reason, taken back."""
    address = f"/api/scans/{scan['id']}/heights"
    waiting = [one for one in page.request.get(address).json() if one["review"]["verdict"] == "to_review"]
    of_one = [one for one in waiting if one["vehicle_id"] == waiting[0]["vehicle_id"]]
    assert len(of_one) >= 2 and scan["counts"]["heights_to_review"] == len(waiting)
    vehicles = page.request.get(f"/api/scans/{scan['id']}/vehicles").json()
    number = next(one["number"] for one in vehicles if one["id"] == waiting[0]["vehicle_id"])
    bench = f"/surveys/{scan['survey_id']}/scan?scan={scan['id']}"
    page.goto(bench)
    row = page.get_by_test_id(f"scan-vehicle-{number}")
    said = row.locator(".mark span:not(.visually-hidden)", has_text="heights to review")
    expect(said).to_have_text(f"{len(of_one)} heights to review")
    row.get_by_role("button").click()
    page.locator(".line-heights").get_by_role("link", name="Review").first.click()
    strips = page.get_by_test_id("strips")
    expect(strips).to_be_visible()
    panel = page.get_by_role("complementary", name="measurement")
    expect(panel).to_contain_text("Line scan")
    expect(page.get_by_test_id("review-fix")).to_have_count(0)
    page.screenshot(path=screenshots / "review-line.png")

    def judge(one: dict[str, Any]) -> None:
        page.goto(f"/surveys/{scan['survey_id']}/review?measurement={one['id']}")
        expect(page.get_by_test_id(f"review-{one['id']}")).to_have_attribute("aria-current", "true")
        expect(page.get_by_test_id(f"review-{one['id']}")).to_contain_text("line scan")

    def is_verdict(answer: Any) -> bool:
        return bool(re.search(r"/measurements/\d+/reviews$", answer.url))

    judge(of_one[0])
    strips.focus()
    with page.expect_response(is_verdict) as accepted:
        page.keyboard.press("a")
    found = accepted.value.json()
    assert (found["id"], found["review"]["verdict"]) == (of_one[0]["id"], "accepted")
    undo = page.get_by_test_id("undo").get_by_role("button")
    with page.expect_response(is_verdict) as back:
        undo.click()
    assert back.value.json()["review"]["verdict"] == "reopened"
    judge(of_one[1])
    strips.focus()
    page.keyboard.press("x")
    page.get_by_role("button", name="The target point is off the feature.").click()
    with page.expect_response(is_verdict) as rejected:
        page.get_by_test_id("review-send-rejection").get_by_role("button").click()
    refused = rejected.value.json()
    assert (refused["id"], refused["review"]["verdict"]) == (of_one[1]["id"], "rejected")
    with page.expect_response(is_verdict) as back:
        undo.click()
    assert back.value.json()["review"]["verdict"] == "reopened"
    page.goto(bench)
    expect(row).to_contain_text(f"{len(of_one)} heights to review")
    # the report of the survey counts what is accepted and says what waits
    page.goto(f"/surveys/{scan['survey_id']}/scans/results")
    expect(page.get_by_test_id("scanned-heights")).to_contain_text("Roof")
    expect(page.get_by_text(f"{len(waiting)} heights wait for a verdict")).to_be_visible()
    page.screenshot(path=screenshots / "scan-heights-results.png")


def place_of(strips: Locator, line: float, row: float, shown: tuple[float, float]) -> tuple[float, float]:
    """Where a line and a row of camera 1 lie while all 256 rows are shown."""
    box = strips.bounding_box()
    assert box
    return x_of(strips, line, *shown), box["y"] + (row + 0.5) / 256 * (box["height"] - 24) / 2


def test_a_rod_and_two_clicks_give_a_height(page: Page, scan: dict[str, Any], screenshots: Path) -> None:
    page.goto(f"/surveys/{scan['survey_id']}/scan?scan={scan['id']}")
    page.get_by_test_id("scan-vehicle-7").get_by_role("button").click()
    strips, height = page.get_by_test_id("strips"), page.get_by_test_id("line-height-roof")
    expect(height).to_have_text("–")

    # the rod's marks clicked anew, from the foot up at both of its distances
    page.get_by_role("button", name="Calibrate height").click()
    camera, store = page.get_by_test_id("rod-camera-height"), page.get_by_role("button", name="Save the")
    expect(store).to_be_disabled()
    page.get_by_role("button", name="Remove all marks").click()
    expect(page.get_by_text("No marks yet")).to_be_visible()
    lines = [(rod.from_s + rod.to_s) / 2 * SITE.line_rate_hz for rod in RODS]
    for rod, line in zip(RODS, lines, strict=True):
        page.get_by_label("Rod distance").fill(str(rod.distance_m))
        page.get_by_label("Rod distance").press("Enter")
        for height_m in rod.marks_m[:4]:
            expect(page.locator(".strips__asked")).to_contain_text(f"{height_m:.2f} m above")
            row = row_of(SITE, rod.distance_m, height_m)
            # the window shows half of what lies between both stands before and behind them
            shown = (lines[0] - (lines[1] - lines[0]) / 6, lines[1] + (lines[1] - lines[0]) / 6)
            page.mouse.click(*place_of(strips, line, row, shown))
    expect(page.get_by_test_id("rod-marks").locator("tbody tr")).to_have_count(8)
    expect(camera).to_contain_text(re.compile(r"1\.(1[5-9]|2[0-5])\d\s±\s0\.0"))
    page.screenshot(path=screenshots / "scan-rod.png")
    with page.expect_response(lambda answer: answer.url.endswith("/line-pose")) as kept:
        store.click()
    assert len(kept.value.json()["marks"]) == 8

    # contact, then roof; the figure that is stored is the one that the pointer showed
    motion = vehicle_of(page, scan, 7)["measurement"]
    shown = (motion["front_line_1"], max(motion["rear_line_1"], motion["rear_line_2"]))
    strips.focus()
    page.keyboard.press("q")
    page.keyboard.press("1")
    asked = page.locator(".strips__asked")
    expect(asked).to_contain_text("tyre contact point")
    line = shown[0] + 0.8 * (motion["rear_line_1"] - shown[0])
    page.mouse.click(*place_of(strips, line, 236.0, shown))
    expect(asked).to_contain_text("roof")
    roof = place_of(strips, line - 100, 86.0, shown)
    page.mouse.move(*roof)
    expect(height).to_contain_text("±")
    with page.expect_response(lambda answer: answer.url.endswith("/heights")) as stored:
        page.mouse.click(*roof)
    made = stored.value.json()
    assert made["status"] == "ok" and made["distance_m"] == pytest.approx(3.0, abs=0.15)
    expect(height).to_contain_text(f"{made['height_m']:.3f}")
    page.screenshot(path=screenshots / "scan-height.png")

    # a row up by keyboard is higher; both steps are undone
    page.keyboard.press("Escape")
    page.keyboard.press("w")
    for _ in range(4):
        page.keyboard.press("w")
    with page.expect_response(lambda answer: answer.url.endswith("/heights")) as nudged:
        page.keyboard.press("ArrowUp")
    assert nudged.value.json()["target_point"][1] == pytest.approx(made["target_point"][1] - 1)
    expect(height).to_contain_text(f"{nudged.value.json()['height_m']:.3f}")
    undo = page.get_by_test_id("undo").get_by_role("button")
    undo.click()
    expect(height).to_contain_text(f"{made['height_m']:.3f}")
    undo.click()
    expect(height).to_have_text("–")
    with page.expect_response(lambda answer: answer.url.endswith("/line-pose")) as back:
        undo.click()
    assert len(back.value.json()["marks"]) == 10


def test_a_start_is_confirmed_and_vehicles_have_their_time(
    page: Page, scan: dict[str, Any], screenshots: Path
) -> None:
    page.goto(f"/surveys/{scan['survey_id']}/scans")
    start = page.get_by_test_id(f"scan-{scan['id']}").get_by_test_id("scan-start")
    expect(start).to_contain_text("Filmed from 14 May 2025, 09:29:20 (Europe/Paris) (u = 0.001 s)")
    start.get_by_role("button").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_role("button", name="Not known").click()
    dialog.get_by_role("button", name="Save").click()
    expect(start).to_contain_text("no vehicle has a time of day")
    page.screenshot(path=screenshots / "scan-start-unknown.png")
    start.get_by_role("button").click()
    dialog.get_by_label("First line").fill("2025-10-26T02:30:00.250")
    dialog.get_by_label("Standard uncertainty u").fill("")
    dialog.get_by_role("button", name="Confirm").click()
    expect(dialog.get_by_text("Enter the standard uncertainty of the start")).to_be_visible()
    dialog.get_by_label("Standard uncertainty u").fill("0.01")
    dialog.get_by_role("button", name="Confirm").click()
    dialog.get_by_label("the second time (+01:00)").check()
    page.screenshot(path=screenshots / "scan-start-dialog.png")
    dialog.get_by_role("button", name="Confirm").click()
    expect(dialog).not_to_be_visible()
    expect(start).to_contain_text("Filmed from 26 Oct 2025, 02:30:00 (Europe/Paris) (u = 0.01 s)")

    page.goto(f"/surveys/{scan['survey_id']}/scan?scan={scan['id']}")
    second = vehicle_of(page, scan, 2)
    assert second["filmed_at"].endswith("+01:00") and second["u_filmed_at_s"] >= 0.01
    row = page.get_by_test_id("scan-vehicle-2")
    expect(row).to_contain_text(second["filmed_at"][11:19])
    row.get_by_role("button").click()
    expect(page.get_by_test_id("scan-passed")).to_contain_text(f"26 Oct 2025, {second['filmed_at'][11:22]}")
    page.screenshot(path=screenshots / "scan-start-bench.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "scan-start-bench-1024.png")


def test_traffic_by_the_clock_stands_below_the_results(
    page: Page, scan: dict[str, Any], screenshots: Path
) -> None:
    survey = scan["survey_id"]
    told = page.request.get(f"/api/surveys/{survey}/scan-traffic?minutes=1").json()["scans"][0]["intervals"]
    assert sum(one["vehicles"] for one in told) == scan["counts"]["vehicles"]
    page.goto(f"/surveys/{survey}/scans/results")
    traffic = page.get_by_test_id("scan-traffic")
    traffic.get_by_label("1 min", exact=True).check()
    table = page.get_by_test_id(f"traffic-{scan['id']}")
    expect(table.locator("tbody tr")).to_have_count(len(told))
    expect(table).to_contain_text(told[0]["begins_at"][11:19])
    expect(table).to_contain_text("partial")
    assert len(told) < 3  # which make no plot
    expect(traffic).to_contain_text("Plots are drawn from three intervals on")
    expect(page.get_by_test_id(f"figure-traffic-flow-{scan['id']}")).to_have_count(0)
    traffic.screenshot(path=screenshots / "scan-traffic.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    traffic.screenshot(path=screenshots / "scan-traffic-1024.png")


def test_motion_leads_with_the_traffic_and_says_nothing_twice(
    page: Page, scan: dict[str, Any], screenshots: Path
) -> None:
    """Traffic, lengths, reference speeds, heights; no quantity breaks in two at 1024 px."""
    page.set_viewport_size({"width": 1024, "height": 768})
    page.goto(f"/surveys/{scan['survey_id']}/scans/results")
    speeds, sizes = page.get_by_test_id("scan-reference-errors"), page.get_by_test_id("scan-errors")
    parts = ["scan-traffic", "figure-scan-speed", "scan-errors", "scan-reference-errors", "scanned-heights"]
    for part in parts:
        expect(page.get_by_test_id(part)).to_be_visible()
    tops = [page.get_by_test_id(part).evaluate("it => it.getBoundingClientRect().top") for part in parts]
    assert tops == sorted(tops)
    # one source of speeds, all by day: what is said of all together would say the same row once more
    rows = page.get_by_role("row").filter(has_text=re.compile("^(Speed|Length|Wheelbase), "))
    told = [re.split(r"\s*\t", name)[0] for name in rows.all_inner_texts()]
    assert told == ["Length, overall", "Wheelbase, overall", "Speed, radar"]
    speeds.scroll_into_view_if_needed()
    page.screenshot(path=screenshots / "scan-errors-1024.png")
    line = "it => parseFloat(getComputedStyle(it).lineHeight)"
    for table in (speeds, sizes):
        for name in table.locator("tbody td:first-child").all():
            inside = name.evaluate(
                "it => { const all = document.createRange(); all.selectNodeContents(it);"
                " return all.getBoundingClientRect().height }"
            )
            assert inside < 1.5 * name.evaluate(line), name.inner_text()
        width, room = table.evaluate("it => [it.parentElement.scrollWidth, it.parentElement.clientWidth]")
        assert width <= room


@pytest.mark.parametrize(
    ("locale", "views"),
    [
        pytest.param("en-GB", ("Flow", "Speeds and headways", "Length classes"), marks=pytest.mark.proof),
        ("fr-FR", ("Débit", "Vitesses et TIV", "Classes de longueur")),
    ],
)
def test_the_traffics_table_fits_a_small_screen(
    browser: Browser,
    demonstration: Server,
    admin_state: StorageState,
    scan: dict[str, Any],
    screenshots: Path,
    locale: str,
    views: tuple[str, ...],
) -> None:
    """All columns of a view stand beside each other at 1024 px; those of all views were too many."""
    context = browser.new_context(
        base_url=demonstration.url,
        storage_state=admin_state,
        viewport={"width": 1024, "height": 768},
        locale=locale,
    )
    small = context.new_page()
    small.goto(f"/surveys/{scan['survey_id']}/scans/results")
    table = small.get_by_test_id(f"traffic-{scan['id']}")
    for number, view in enumerate(views):
        small.get_by_label(view, exact=True).check()
        expect(table.locator("tbody tr").first).to_be_visible()
        table.scroll_into_view_if_needed()
        small.screenshot(path=screenshots / f"scan-traffic-{locale}-{number}.png")
        width, room = table.evaluate("it => [it.parentElement.scrollWidth, it.parentElement.clientWidth]")
        assert width <= room, view
    context.close()
