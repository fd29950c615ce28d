"""An evidence file from the bench to a stranger's desk: made, opened without a network, set by hand."""

import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Locator, Page, expect

from sightline.export.evidence.page import read_page, written_page
from sightline.export.evidence.pictures import StripPicture
from sightline.export.evidence.verify import verify_evidence

from .test_languages import SHOWN, Catalogues

SIZES = [(1440, 900), (1024, 768)]


@pytest.fixture(scope="module")
def once(
    administrators: BrowserContext,
    survey_id: int,
    tmp_path_factory: pytest.TempPathFactory,
    screenshots: Path,
) -> Path:
    """The file of the demonstration's second scanned vehicle, made with the bench's own button."""
    page = administrators.new_page()
    scan = page.request.get(f"/api/surveys/{survey_id}/scans").json()[0]
    page.goto(f"/surveys/{survey_id}/scan?scan={scan['id']}")
    page.get_by_test_id("scan-vehicle-2").get_by_role("button").click()
    page.get_by_role("button", name="Evidence file").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_text("Speed", exact=True).click()
    dialog.get_by_role("button", name="Make the file").click()
    expect(dialog.get_by_text("Enter a limit and a risk above 0.")).to_be_visible()
    dialog.get_by_label("Limit: at most").fill("50")
    dialog.get_by_label("Source of the limit").fill("Sign at the entry")
    page.screenshot(path=screenshots / "evidence-dialog.png")
    with page.expect_download() as file:
        dialog.get_by_role("button", name="Make the file").click()
    expect(dialog).to_be_hidden()
    place = tmp_path_factory.mktemp("evidence") / file.value.suggested_filename
    file.value.save_as(place)
    page.close()
    found = verify_evidence(place.read_bytes())
    assert found.ok, found.problems
    return place


@pytest.fixture
def made(once: Path, tmp_path: Path) -> Path:
    """That file, for a test to change."""
    return Path(shutil.copy(once, tmp_path))


@pytest.fixture(params=SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
def stranger(browser: Browser, request: pytest.FixtureRequest) -> Iterator[Page]:
    """Somebody with a browser and no network, far from the installation; a problem in the page fails."""
    width, height = request.param
    context = browser.new_context(viewport={"width": width, "height": height}, offline=True)
    problems: list[str] = []
    opened = context.new_page()
    opened.on("pageerror", lambda error: problems.append(str(error)))
    opened.on("console", lambda told: problems.append(told.text) if told.type == "error" else None)
    yield opened
    context.close()
    assert problems == []


def open_(page: Page, place: Path) -> None:
    page.goto(f"file://{place}")
    expect(page.locator('html[data-checked="true"]')).to_be_attached()


def states(page: Page) -> dict[str, str]:
    found = page.locator("[data-check]").all()
    return {str(one.get_attribute("data-check")): str(one.get_attribute("data-state")) for one in found}


def x_of(strip: Locator, line: float) -> tuple[float, float]:
    """Where a line of the strip lies on the screen."""
    strip.scroll_into_view_if_needed()
    start, _, width, _ = (float(one) for one in str(strip.get_attribute("viewBox")).split())
    box = strip.bounding_box()
    assert box
    return box["x"] + (line - start) / width * box["width"], box["y"] + box["height"] / 2


def test_a_stranger_lays_both_pictures_over_each_other_and_sets_boundaries(
    made: Path, stranger: Page, screenshots: Path
) -> None:
    open_(stranger, made)
    checks = {"text", "pictures", "events", "measurement", "signature"}
    assert states(stranger) == dict.fromkeys(checks, "fine")
    told: dict[str, Any] = read_page(made.read_bytes()).document
    motion = told["measurement"]
    expect(stranger.locator("#decision")).to_contain_text(told["decision"]["words"])
    expect(stranger.locator("#decision")).to_contain_text("Sign at the entry")
    expect(stranger.get_by_text("not who holds the key")).to_be_visible()
    expect(stranger.locator("#motion")).to_contain_text(f"{motion['speed_mps'] * 3.6:.1f}"[:-1])
    for picture in stranger.locator("#by-hand svg image").all():
        size = picture.evaluate(
            "async one => { const i = new Image(); i.src = one.getAttribute('href'); await i.decode();"
            " return [i.naturalWidth, i.naturalHeight] }"
        )
        assert size in [[one["columns"], one["rows_px"]] for one in told["pictures"]]

    # nothing is set beforehand, so nothing looks like a reader's own result
    speed = stranger.locator('[data-hand="front"]')
    expect(speed).to_have_text("set all four boundaries")
    for camera in (1, 2):
        strip = stranger.locator(f'svg[data-camera="{camera}"]')
        for edge in ("front", "rear"):
            stranger.get_by_label(f"Set the {edge}").check()
            stranger.mouse.click(*x_of(strip, motion[f"{edge}_line_{camera}"]))
    lines = {
        name: float(stranger.locator(f'[data-line="{name}"]').input_value())
        for name in ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2")
    }
    # one pixel of the screen is so many lines
    for name, line in lines.items():
        assert abs(line - motion[name]) < 4, name
    rig, baseline_m = motion["rig"], told["at_vehicle"]["baseline_m"]
    front = baseline_m * rig["line_rate_hz"] / (lines["front_line_2"] - lines["front_line_1"])
    rear = baseline_m * rig["line_rate_hz"] / (lines["rear_line_2"] - lines["rear_line_1"])
    passing = (lines["rear_line_1"] - lines["front_line_1"]) / rig["line_rate_hz"]
    expect(speed).to_have_text(f"{3.6 * front:.2f} km/h ({front:.3f} m/s)")
    expect(stranger.locator('[data-hand="rear"]')).to_have_text(f"{3.6 * rear:.2f} km/h ({rear:.3f} m/s)")
    expect(stranger.locator('[data-hand="length"]')).to_have_text(f"{(front + rear) / 2 * passing:.3f} m")
    assert abs(front / motion["speed_mps"] - 1) < 0.1
    expect(stranger.get_by_text("It differs from the server’s result")).to_be_visible()

    # a field takes a line too, by keyboard
    field = stranger.locator('[data-line="front_line_2"]')
    field.focus()
    stranger.keyboard.press("ArrowUp")
    expect(field).not_to_have_value(f"{lines['front_line_2']:g}")

    overlay = stranger.get_by_test_id("overlay")
    words = stranger.get_by_test_id("shift-words")
    before = grey(overlay)
    stranger.get_by_role("button", name="Align the file’s fronts").click()
    shift = round(motion["front_line_2"] - motion["front_line_1"], 1)
    expect(words).to_contain_text(f"{shift:.1f} lines are {1e3 * shift / rig['line_rate_hz']:.3f} ms")
    assert grey(overlay) != before
    stranger.get_by_label("Show the difference").check()
    stranger.get_by_label("Show the file’s boundaries").check()
    width = stranger.viewport_size["width"] if stranger.viewport_size else 0
    assert stranger.evaluate("document.documentElement.scrollWidth") <= width
    stranger.screenshot(path=screenshots / f"evidence-{width}.png", full_page=True)


def grey(overlay: Locator) -> bytes:
    return overlay.screenshot()


def test_in_french_no_english_is_left_on_it(made: Path, stranger: Page, screenshots: Path) -> None:
    """Whoever made the file read English; its reader chooses."""
    open_(stranger, made)
    assert stranger.locator("html").get_attribute("lang") == "en"
    stranger.get_by_role("button", name="français").click()
    expect(stranger.locator("html")).to_have_attribute("lang", "fr")
    expect(stranger.locator('[data-check="signature"]')).to_contain_text("La signature est valable")
    document = read_page(made.read_bytes()).document
    words = document["said"]["fr"][document["decision"]["words"]]
    expect(stranger.locator("#decision")).to_contain_text(words)
    known = Catalogues("fr")
    stranger.locator("summary", has_text="Ce qui est contrôlé").click()
    assert [one for one in stranger.evaluate(SHOWN) if known.is_english(one)] == []
    for one in stranger.locator("#motion td, #budget td, #rig td").all_inner_texts():
        assert not re.search(r"\d\.\d", re.sub(r"Sightline \S+", "", one)), one
    width = stranger.viewport_size["width"] if stranger.viewport_size else 0
    assert stranger.evaluate("document.documentElement.scrollWidth") <= width
    stranger.screenshot(path=screenshots / f"evidence-fr-{width}.png", full_page=True)


@pytest.mark.parametrize("stranger", SIZES[:1], indirect=True)
def test_what_was_changed_is_told_by_the_page_itself(made: Path, stranger: Page) -> None:
    html = made.read_text("utf-8")
    speed = re.search(r'"speed_mps":([\d.]+)', html)
    assert speed
    made.write_text(html.replace(speed[0], f'"speed_mps":{float(speed[1]) + 1:.6f}', 1), "utf-8")
    open_(stranger, made)
    found = states(stranger)
    assert (found["signature"], found["pictures"]) == ("wrong", "fine")
    expect(stranger.locator("[data-verdict]")).to_have_text("This file was changed after it was made.")

    old = read_page(html.encode())
    pictures = [StripPicture(name=name, content=data, facts={}) for name, data in old.pictures.items()]
    exchanged = [
        StripPicture(name=one.name, content=other.content, facts={})
        for one, other in zip(pictures, reversed(pictures), strict=True)
    ]
    made.write_bytes(written_page(old.document, old.signature, exchanged))
    open_(stranger, made)
    assert states(stranger)["pictures"] == "wrong"


@pytest.mark.parametrize("stranger", SIZES[:1], indirect=True)
def test_without_ed25519_the_page_says_so_and_checks_the_hashes(made: Path, stranger: Page) -> None:
    stranger.add_init_script(
        "SubtleCrypto.prototype.importKey = () => Promise.reject(new DOMException('no', 'NotSupportedError'))"
    )
    open_(stranger, made)
    found = states(stranger)
    assert found.pop("signature") == "open" and set(found.values()) == {"fine"}
    expect(stranger.get_by_text("this browser does not support Ed25519")).to_be_visible()
