"""Photographs of the set-up through the browser: add, refuse, caption, order, take out and undo."""

from playwright.sync_api import Page, expect

from tests.support.boards import POSES, picture_bytes, view

from .test_bad_input import new_survey, one_sentence
from .waits import keep_toasts


def test_photographs_are_added_put_in_order_and_brought_back(page: Page) -> None:
    keep_toasts(page)
    survey = new_survey(page, "Photographs")
    page.goto(f"/surveys/{survey}/settings")
    png = picture_bytes(view(POSES[0]))
    names = ("rig.png", "road.png")
    files = [{"name": name, "mimeType": "image/png", "buffer": png} for name in names]
    broken = {"name": "notes.jpg", "mimeType": "image/jpeg", "buffer": b"no picture"}
    chooser = page.get_by_label("Choose photographs to add")
    chooser.set_input_files([files[0], broken, files[1]])  # type: ignore[list-item]
    cards = page.locator(".photograph")
    expect(cards).to_have_count(2)
    expect(page.locator(".photographs .field__problem")).to_have_count(1)
    assert "notes.jpg" in one_sentence(page.locator(".photographs .field__problem").inner_text())
    caption = page.get_by_label("Caption of road.png")
    caption.fill("The road")
    caption.blur()
    page.get_by_role("button", name="Move The road to the left").click()
    expect(cards.first.locator("img")).to_have_attribute("alt", "The road")
    page.get_by_role("button", name="Remove rig.png").click()
    expect(cards).to_have_count(1)
    page.get_by_role("button", name="Undo").click()
    expect(cards).to_have_count(2)
    expect(cards.last.locator("img")).to_have_attribute("alt", "rig.png")
    page.reload()
    expect(page.get_by_label("Caption of road.png")).to_have_value("The road")
    expect(cards.first.locator("img")).to_have_attribute("alt", "The road")
