"""The pointer on the picture stage of frames: drag, slide, Escape, wheel, pan, loupe."""

import re
from collections.abc import Iterator
from typing import Any, Literal

import pytest
from playwright.sync_api import BrowserContext, Locator, Page, Response, expect

from .conftest import choose_plan
from .picture import on_screen
from .server import Server
from .vehicles import OwnVehicle, Pixel, click_at, own_vehicle, stored

# On the road beside the vehicle: nothing is picked there.
FREE: Pixel = (40.0, 400.0)


@pytest.fixture
def one(page: Page, demonstration: Server) -> OwnVehicle:
    """A vehicle of this test's own, open in Measure, with the roof measured."""
    return measured(page)


@pytest.fixture(scope="module")
def looked_at(administrators: BrowserContext) -> Iterator[tuple[Page, OwnVehicle]]:
    """The same once, for tests that change nothing but how the picture lies in its window."""
    page = administrators.new_page()
    yield page, measured(page)
    page.close()


@pytest.fixture
def looking(looked_at: tuple[Page, OwnVehicle]) -> tuple[Page, OwnVehicle]:
    """With the whole picture in its window."""
    looked_at[0].keyboard.press("0")
    return looked_at


def measured(page: Page) -> OwnVehicle:
    one = own_vehicle(page)
    page.goto(one.address)
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_have_attribute("aria-current", "true")
    expect(page.locator(".frame-loading--on")).to_have_count(0)
    page.get_by_test_id("target-roof").click()
    click_at(page, one.pixels["contact_rear"])
    expect(page.get_by_test_id("axes")).to_be_visible()
    click_at(page, one.pixels["roof"])
    expect(roof_row(page)).to_have_attribute("data-state", "saved")
    page.keyboard.press("Escape")
    return one


def roof_row(page: Page) -> Locator:
    return page.get_by_test_id("measurement-row-roof")


def roof(page: Page, one: OwnVehicle) -> dict[str, Any]:
    return stored(page, one.vehicle["id"])["roof"]


def undo_button(page: Page) -> Locator:
    return page.get_by_test_id("undo").get_by_role("button")


def undo_title(page: Page) -> str:
    """What the next undo would take back, as its button says."""
    return undo_button(page).get_attribute("title") or ""


def picture(page: Page) -> str:
    """How the picture lies in its window, once it does: left, top and scale."""
    canvas = page.get_by_test_id("frame-view").locator("canvas[data-picture]")
    return canvas.get_attribute("data-picture") or ""


def pixel_at(page: Page, x: float, y: float) -> Pixel:
    """The picture's pixel under a place of the window."""
    (x0, y0), (x1, y1) = on_screen(page, (0, 0)), on_screen(page, (100, 100))
    return 100 * (x - x0) / (x1 - x0), 100 * (y - y0) / (y1 - y0)


def near(a: Any, b: Any, apart: float) -> bool:
    return max(abs(p - q) for p, q in zip(a, b, strict=True)) <= apart


def begin_drag(page: Page, pixel: Any, by: tuple[float, float]) -> tuple[float, float]:
    """Press on a point and move the pointer; it is still down. Where the pointer is."""
    x, y = on_screen(page, pixel)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + by[0], y + by[1], steps=5)
    return x + by[0], y + by[1]


def is_revision(answer: Response) -> bool:
    return answer.request.method in ("PUT", "POST") and "/measurements" in answer.url and answer.ok


def test_a_dragged_point_moves_is_measured_again_and_is_one_undo_step(page: Page, one: OwnVehicle) -> None:
    before = roof(page, one)
    shown = roof_row(page).inner_text()
    x, y = begin_drag(page, before["target_point"], (0, -30))
    expect(page.get_by_test_id("loupe")).to_be_visible()
    goal = pixel_at(page, x, y)
    with page.expect_response(is_revision):
        page.mouse.up()
    expect(roof_row(page)).to_have_attribute("data-state", "saved")
    expect(page.get_by_test_id("loupe")).to_have_count(0)
    after = roof(page, one)
    assert near(after["target_point"], goal, 0.6) and after["contact"] == before["contact"]
    assert after["revision"] == before["revision"] + 1
    assert after["height_m"] > before["height_m"]
    expect(roof_row(page)).to_contain_text(f"{after['height_m']:.3f}")
    expect(undo_button(page)).to_have_attribute("title", re.compile("^Undo: move of a point"))

    with page.expect_response(is_revision):
        page.keyboard.press("Control+z")
    expect(roof_row(page)).to_have_attribute("data-state", "saved")
    assert roof(page, one)["target_point"] == before["target_point"]
    expect(roof_row(page)).to_contain_text(f"{before['height_m']:.3f}")
    assert roof_row(page).inner_text() == shown
    expect(undo_button(page)).to_have_attribute("title", re.compile("^Undo: (?!move)"))


def marks(page: Page) -> list[str]:
    """Where the points are drawn."""
    drawn: list[str] = page.locator("g.point-mark").evaluate_all(
        "found => found.map(mark => mark.getAttribute('transform')).sort()"
    )
    return drawn


def dragged_and_let_go_by_escape(page: Page, pixel: Any) -> None:
    """A drag that Escape ends, with the pointer still down, leaves the points where they were."""
    expect(page.locator("g.point-mark").first).to_be_visible()
    page.mouse.move(*on_screen(page, FREE))
    before = marks(page)
    begin_drag(page, pixel, (40, -40))
    expect(page.get_by_test_id("loupe")).to_be_visible()
    assert marks(page) != before
    page.keyboard.press("Escape")
    expect(page.get_by_test_id("loupe")).to_have_count(0)
    assert marks(page) == before
    page.mouse.up()
    page.mouse.move(*on_screen(page, FREE))
    assert marks(page) == before


def test_escape_in_a_drag_leaves_no_step_in_measure(page: Page, one: OwnVehicle) -> None:
    before, title = roof(page, one), undo_title(page)
    row = roof_row(page).inner_text()
    dragged_and_let_go_by_escape(page, before["target_point"])
    assert undo_title(page) == title
    assert roof_row(page).inner_text() == row
    assert roof(page, one) == before


@pytest.mark.usefixtures("kept")
def test_escape_in_a_drag_leaves_the_fix_where_it_was_in_review(page: Page, survey_id: int) -> None:
    # somebody else's: nobody judges what is their own
    first = page.request.get(f"/api/surveys/{survey_id}/review-queue").json()[0]["measurement"]
    choose_plan(page, survey_id, 0)
    page.goto(f"/surveys/{survey_id}/review?measurement={first['id']}")
    expect(page.locator(f"[data-measurement='{first['id']}']")).to_have_attribute("aria-current", "true")
    expect(page.locator(".frame-loading--on")).to_have_count(0)
    page.keyboard.press("e")
    hint = page.locator("#review-hint")
    expect(hint).to_contain_text("Drag a point")
    dragged_and_let_go_by_escape(page, first["target_point"])
    expect(hint).to_contain_text("Drag a point")  # the fix itself goes on
    expect(hint.locator("strong")).to_contain_text(f"{first['height_m']:.3f}")
    assert page.request.get(f"/api/measurements/{first['id']}").json() == first


@pytest.mark.parametrize("slide_px", [3, pytest.param(0, marks=pytest.mark.proof)])
def test_a_click_that_slides_counts_where_it_began(page: Page, one: OwnVehicle, slide_px: int) -> None:
    page.get_by_test_id("target-taillight").click()
    x, y = on_screen(page, one.pixels["taillight"])
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + slide_px, y)
    page.mouse.up()
    expect(page.get_by_test_id("measurement-row-taillight")).to_have_attribute("data-state", "saved")
    assert near(stored(page, one.vehicle["id"])["taillight"]["target_point"], one.pixels["taillight"], 0.6)


def turn_wheel(page: Page, turn: int) -> None:
    """A turn of the wheel, until the picture has another scale."""
    scale = picture(page).split()[2]
    page.mouse.wheel(0, turn)
    expect(page.get_by_test_id("frame-view").locator("canvas[data-picture]")).not_to_have_attribute(
        "data-picture", re.compile(rf" {re.escape(scale)}$")
    )
    assert (float(picture(page).split()[2]) > float(scale)) == (turn < 0)


def test_the_wheel_zooms_at_the_pointer(looking: tuple[Page, OwnVehicle]) -> None:
    page, one = looking
    # a browser tells of a turning wheel in whole pixels
    x, y = (round(place) for place in on_screen(page, one.pixels["roof"]))
    page.mouse.move(x, y)
    under = pixel_at(page, x, y)
    for turn in (-600, -300, 400):
        turn_wheel(page, turn)
        assert near(pixel_at(page, x, y), under, 0.05)


def panned(page: Page, button: Literal["left", "middle"]) -> tuple[float, float]:
    """How far the picture went when the pointer, with this button down, went 60 px right and 25 px down."""
    box = page.get_by_test_id("frame-view").bounding_box()
    assert box
    x, y = box["x"] + 80, box["y"] + 0.8 * box["height"]
    page.mouse.move(x, y)
    under = pixel_at(page, x, y)
    page.mouse.down(button=button)
    page.mouse.move(x + 60, y + 25, steps=4)
    page.mouse.up(button=button)
    now = on_screen(page, under)
    return now[0] - x, now[1] - y


def test_the_middle_button_and_space_move_the_picture(looking: tuple[Page, OwnVehicle]) -> None:
    page, one = looking
    page.mouse.move(*on_screen(page, one.pixels["roof"]))
    turn_wheel(page, -300)  # past the window, so that there is room to move in every direction
    frame = page.get_by_test_id("frame-box").input_value()
    assert near(panned(page, "middle"), (60, 25), 0.1)
    page.keyboard.down(" ")
    assert near(panned(page, "left"), (60, 25), 0.1)
    page.keyboard.up(" ")
    # Space that has moved the picture plays nothing, and the first button alone moves nothing
    expect(page.get_by_test_id("frame-box")).to_have_value(frame)
    assert near(panned(page, "left"), (0, 0), 0.1)
    assert set(stored(page, one.vehicle["id"])) == {"roof"}


def test_the_loupe_is_there_while_it_is_armed(looking: tuple[Page, OwnVehicle]) -> None:
    page, one = looking
    loupe = page.get_by_test_id("loupe")
    x, y = one.pixels["roof"]
    page.mouse.move(*on_screen(page, (x, y)))
    expect(loupe).to_have_count(0)
    page.keyboard.down("z")
    expect(loupe).to_be_visible()
    expect(loupe).to_contain_text(re.compile(rf"x {x:.0f}|x {int(x)}\.\d"))
    page.keyboard.up("z")
    expect(loupe).to_have_count(0)


def test_a_lost_connection_is_told_without_moving_the_picture(page: Page, one: OwnVehicle) -> None:
    # a click on its way to a roof must land there, whatever is told meanwhile
    place, box = picture(page), page.get_by_test_id("frame-view").bounding_box()
    page.context.set_offline(True)
    page.get_by_test_id("target-taillight").click()
    click_at(page, one.pixels["taillight"])
    expect(page.locator(".offline")).to_be_visible()
    page.screenshot(path=".build/screenshots/offline.png")
    assert picture(page) == place
    assert page.get_by_test_id("frame-view").bounding_box() == box
    page.context.set_offline(False)
    expect(page.get_by_test_id("measurement-row-taillight")).to_have_attribute("data-state", "saved")
    expect(page.locator(".offline")).to_have_count(0)
    assert near(stored(page, one.vehicle["id"])["taillight"]["target_point"], one.pixels["taillight"], 0.6)
