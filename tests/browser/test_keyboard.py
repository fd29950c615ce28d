"""Everything by keyboard: a vehicle's three targets, undo and redo, the key map, stepping through frames."""

import re

from playwright.sync_api import Page, Response, expect

from .picture import on_screen
from .server import Server
from .vehicles import TARGETS, Pixel, own_vehicle, stored, until

MOVES = (10.0, "Shift+"), (1.0, ""), (0.1, "Alt+")


def steer(page: Page, start: Pixel, goal: Pixel) -> None:
    """Presses arrows until the keyboard's cursor has gone from `start` to `goal`, to 0.1 px."""
    for here, there, keys in zip(
        start, goal, (("ArrowLeft", "ArrowRight"), ("ArrowUp", "ArrowDown")), strict=True
    ):
        way = there - here
        for step_px, modifier in MOVES:
            for _ in range(int(abs(way) / step_px + 1e-6)):
                page.keyboard.press(modifier + keys[way > 0])
            way -= step_px * (int(abs(way) / step_px + 1e-6)) * (1 if way > 0 else -1)


def cursor(page: Page) -> Pixel:
    """Image pixel under the cross: it is drawn from the frame view's edges through the point."""
    mark = page.get_by_test_id("keyboard-cursor")
    shape = str(mark.locator("path").first.get_attribute("d"))
    found = re.match(r"M0 ([\d.]+)H.*M([\d.]+) 0V", shape)
    assert found, shape
    frame = page.get_by_test_id("frame-view").bounding_box()
    assert frame
    x, y = frame["x"] + float(found[2]), frame["y"] + float(found[1])
    (x0, y0), (x1, y1) = on_screen(page, (0, 0)), on_screen(page, (100, 100))
    return 100 * (x - x0) / (x1 - x0), 100 * (y - y0) / (y1 - y0)


def test_three_targets_by_keyboard_and_back_again(page: Page, demonstration: Server) -> None:
    one = own_vehicle(page)
    number = int(one.vehicle["number"])
    vehicles = page.request.get(f"/api/surveys/{one.survey}/vehicles").json()
    before = next(v for v in vehicles if v["number"] == number - 1)
    page.goto(f"/surveys/{one.survey}/measure?recording={before['recording_id']}&vehicle={before['id']}")
    expect(page.get_by_test_id(f"pass-{number - 1}")).to_have_attribute("aria-current", "true")

    box = page.get_by_test_id("frame-box")
    expect(box).to_have_value(str(before["best_frame"]))
    page.keyboard.press("Home")
    expect(box).to_have_value("0")
    page.keyboard.press("n")
    expect(page.get_by_test_id(f"pass-{number}")).to_have_attribute("aria-current", "true")
    expect(box).to_have_value(str(one.vehicle["best_frame"]))
    page.keyboard.press("g")
    expect(box).to_be_focused()
    page.keyboard.type(str(one.frame))
    page.keyboard.press("Enter")
    page.wait_for_url(re.compile(rf"[?&]frame={one.frame}\b"))

    page.keyboard.press("m")
    here = cursor(page)
    for place, name in enumerate(("contact_rear", *TARGETS)):
        if name in TARGETS:
            page.keyboard.press(str(TARGETS.index(name) + 1))
        steer(page, here, one.pixels[name])
        here = cursor(page)
        assert max(abs(a - b) for a, b in zip(here, one.pixels[name], strict=True)) < 0.5
        if place > 0:
            expect(page.get_by_test_id("live-height")).to_contain_text("±")
        page.keyboard.press("Enter")
        if name in TARGETS:
            row = page.get_by_test_id(f"measurement-row-{name}")
            expect(row).to_have_attribute("data-state", "saved")
            expect(row).to_contain_text("±")
    have = stored(page, one.vehicle["id"])
    assert set(have) == set(TARGETS)
    for name in TARGETS:
        assert have[name]["frame"] == one.frame and have[name]["status"] == "ok"
        assert (
            max(abs(a - b) for a, b in zip(have[name]["target_point"], one.pixels[name], strict=True)) < 0.5
        )

    undo_and_redo(page, one.vehicle["id"], have["taillight"]["target_point"])
    nudge(page, one.vehicle["id"], have["taillight"]["target_point"])


def undo_and_redo(page: Page, vehicle: int, point: list[float]) -> None:
    """What is taken back is withdrawn on the server, what is done again is there again."""
    row = page.get_by_test_id("measurement-row-taillight")
    page.keyboard.press("Control+z")
    expect(row).to_have_attribute("data-state", "missing")
    until(page, vehicle, lambda have: set(have) == {"roof", "driver_eye"})
    page.keyboard.press("Control+Shift+z")
    expect(row).to_have_attribute("data-state", "saved")
    assert stored(page, vehicle)["taillight"]["target_point"] == point


def is_revision(answer: Response) -> bool:
    return answer.request.method == "PUT" and "/measurements/" in answer.url and answer.ok


def nudge(page: Page, vehicle: int, point: list[float]) -> None:
    """A selected point goes one pixel by an arrow, as one new revision; undo takes it back."""
    page.keyboard.press("Escape")  # the cursor goes
    expect(page.get_by_test_id("keyboard-cursor")).to_have_count(0)
    page.keyboard.press("w")
    with page.expect_response(is_revision):
        page.keyboard.press("ArrowRight")
    expect(page.get_by_test_id("measurement-row-taillight")).to_have_attribute("data-state", "saved")
    until(page, vehicle, lambda have: have["taillight"]["target_point"] == [point[0] + 1, point[1]])
    moved = stored(page, vehicle)["taillight"]
    page.keyboard.press("Control+z")
    until(page, vehicle, lambda have: have["taillight"]["target_point"] == point)
    assert stored(page, vehicle)["taillight"]["revision"] == moved["revision"] + 1


def test_help_and_frames_by_keyboard(page: Page, demonstration: Server) -> None:
    one = own_vehicle(page)
    page.goto(one.address)
    box = page.get_by_test_id("frame-box")
    expect(box).to_have_value(str(one.frame))
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_have_attribute("aria-current", "true")
    for key, frame in (("f", 1), ("f", 2), ("d", 1), ("v", 11), ("c", 1), ("ArrowLeft", 0)):
        page.keyboard.press(key)
        expect(box).to_have_value(str(one.frame + frame))
    page.keyboard.press("?")
    dialog = page.get_by_role("dialog", name="Keyboard shortcuts")
    expect(dialog).to_be_visible()
    expect(dialog).to_contain_text("Keyboard cursor on or off")
    page.keyboard.press("f")
    page.keyboard.press("Escape")
    expect(dialog).to_have_count(0)
    expect(box).to_have_value(str(one.frame))
