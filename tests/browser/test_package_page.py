"""The page of a package, opened from a folder without a server: what it computes, finds and shows."""

import base64
import csv
import json
import re
import shutil
import zlib
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from sightline.export.build import build
from sightline.geometry.documents import pose_from_dict
from sightline.infra.csv_package.files import Staging
from sightline.infra.database import Session
from sightline.infra.services import open_services
from sightline.measurements.height_of_clicks import answer
from sightline.measurements.verify import clicks_of_row
from sightline.results.selection import Selection
from sightline.settings import Settings
from sightline.surveys.records import Inset
from sightline.surveys.store import list_surveys, update_survey

from .conftest import made_once


def built(
    factory: pytest.TempPathFactory,
    name: str,
    change: Callable[[Session], None] | None = None,
    **of: Selection,
) -> Path:
    """A package of the small demonstration survey, after a `change` of its database."""
    here = factory.getbasetemp()
    shared = here.parent if here.name.startswith("popen") else here
    data_dir = factory.mktemp(name) / "data"
    shutil.copytree(made_once(shared / "made-demonstration"), data_dir)
    services = open_services(Settings(data_dir=data_dir))
    place = data_dir.parent / "package"
    place.mkdir()
    if change is not None:
        with services.writing() as session:
            change(session)
    with services.reading() as session:
        (survey,) = list_surveys(session)
        build(Staging(place), session, survey.id, services, **of)
    services.close()
    return place


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The package of the small demonstration survey."""
    return built(tmp_path_factory, "opened")


def another_roof_inset(session: Session) -> None:
    """The survey's inset of roofs is another one now; no height is computed again."""
    (survey,) = list_surveys(session)
    told = Inset(0.456, 0.1, "told in a test")
    insets = survey.insets | {name: told for name in survey.insets if name.startswith("roof")}
    update_survey(session, replace(survey, insets=insets), actor=None)


@pytest.fixture(scope="module")
def limited(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """The package of one class of the same survey alone, its roofs out of date; and that class."""
    chosen = Selection(categories=("suv",))
    return built(tmp_path_factory, "limited", another_roof_inset, selection=chosen), "suv"


@pytest.fixture
def opened(browser: Browser) -> Iterator[Callable[[Path], Page]]:
    """Opens a package from its folder; whatever goes wrong in the page fails the test."""
    context = browser.new_context(viewport={"width": 1440, "height": 900}, offline=True)
    problems: list[str] = []

    def open_(place: Path) -> Page:
        page = context.new_page()
        page.on("pageerror", lambda error: problems.append(str(error)))
        page.on("console", lambda told: problems.append(told.text) if told.type == "error" else None)
        page.goto(f"file://{place}/index.html")
        expect(page.locator('html[data-checked="true"]')).to_be_attached()
        return page

    yield open_
    context.close()
    assert problems == []


def states(page: Page) -> dict[str, str]:
    found = page.locator("[data-check]").all()
    return {str(one.get_attribute("data-check")): str(one.get_attribute("data-state")) for one in found}


def heights(page: Page) -> dict[str, str]:
    """Every height that the page computed, in all its digits."""
    found: dict[str, str] = {}
    while True:
        for one in page.locator("[data-measurement]").all():
            found[str(one.get_attribute("data-measurement"))] = str(one.get_attribute("data-height"))
        after = page.get_by_role("button", name="Next")
        if after.is_disabled():
            return found
        after.click()


def rows(place: Path, name: str) -> list[dict[str, str]]:
    with (place / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_its_heights_are_those_of_verify_to_a_nanometre(whole: Path, opened: Callable[[Path], Page]) -> None:
    page = opened(whole)
    assert set(states(page).values()) == {"fine"}, states(page)
    assert page.locator("[data-verdict]").get_attribute("data-verdict") == "fine"
    found = heights(page)
    told = rows(whole, "tables/measurements.csv")
    assert set(found) == {row["id"] for row in told} and len(told) >= 10
    assert any(row["frames"] != "1" for row in told), "several frames are computed too"
    poses = {
        row["id"]: json.loads((whole / f"poses/pose-{row['id']}.json").read_text())
        for row in rows(whole, "tables/poses.csv")
    }
    for row in told:
        height_m = answer(pose_from_dict(poses[row["pose_id"]]), clicks_of_row(row)).height_m
        assert (height_m is None) == (found[row["id"]] == ""), row["id"]
        assert height_m is None or abs(float(found[row["id"]]) - height_m) <= 1e-9, row["id"]


def wide_px(one: Locator) -> float:
    box = one.bounding_box()
    assert box
    return box["width"]


def test_crops_figures_tables_and_sizes_are_shown(whole: Path, opened: Callable[[Path], Page]) -> None:
    page = opened(whole)
    for figure in page.locator("#figures img").all():
        figure.scroll_into_view_if_needed()
        expect(figure).to_have_js_property("complete", True)
        assert figure.evaluate("one => one.naturalWidth") > 0
    one = page.locator("#figures figure", has=page.locator('img[src="figures/driver_eye-ecdf.svg"]'))
    expect(one.locator("figcaption")).to_have_text("Heights of the driver’s eye, cumulative")
    half = page.locator("#figures figure:not(.opened__sheet--wide)").first
    assert wide_px(one) > 1.8 * wide_px(half)
    crop = next(row for row in rows(whole, "tables/crops.csv") if row["file"])
    page.locator(f'[data-measurement="{crop["measurement_id"]}"]').get_by_role("button").click()
    assert page.locator("#measurements image").first.get_attribute("href") == crop["file"]
    expect(page.locator("#measurements circle").first).to_be_visible()
    page.get_by_text("statistics/total_uncertainty.csv").locator("..").click(position={"x": 4, "y": 8})
    column = page.get_by_role("columnheader", name="raw_m")
    expect(column).to_be_visible()
    expect(column).to_have_attribute("title", "of a percentile: the plain one of the measured heights")
    beside = {"index.html", "datapackage.json", "audit.csv", "audit.js", "checkpoint.json", "SHA256SUMS"}
    files = [one for one in whole.rglob("*") if one.is_file() and one.name not in beside]
    expect(page.locator("#sizes")).to_contain_text(f"{len(files):,} files")
    page.get_by_role("button", name="français").click()  # of a package in English
    said = "d’un centile : celui des hauteurs mesurées, sans correction"
    expect(column).to_have_attribute("title", said)


def test_a_package_that_was_changed_shows_it(
    whole: Path, opened: Callable[[Path], Page], tmp_path: Path
) -> None:
    place = Path(shutil.copytree(whole, tmp_path / "changed"))
    row = next(row for row in rows(whole, "tables/measurements.csv") if row["status"] == "ok")
    index = place / "index.html"
    index.write_text(with_table(index.read_text(), "tables/measurements.csv", row["height_m"], "1.999999"))
    page = opened(place)
    found = states(page)
    assert (found["heights"], found["seal"], found["rows"], found["chain"]) == (
        "wrong",
        "wrong",
        "wrong",
        "fine",
    )
    expect(page.locator("[data-verdict]")).to_have_text("This package was changed after it was made.")
    page.get_by_label("Show").select_option("differs")
    expect(page.locator(f'[data-measurement="{row["id"]}"]')).to_contain_text("1.999999")


def test_a_chain_that_was_changed_shows_it(
    whole: Path, opened: Callable[[Path], Page], tmp_path: Path
) -> None:
    place = Path(shutil.copytree(whole, tmp_path / "chain"))
    script = place / "audit.js"
    told = json.loads(script.read_text().removeprefix("globalThis.sightlineAudit = ").removesuffix(";\n"))
    text = zlib.decompress(base64.b64decode(told["audit.csv"]), -15).replace(b"height_m", b"heigth_m", 1)
    told["audit.csv"] = packed(text)
    script.write_text(f"globalThis.sightlineAudit = {json.dumps(told)};\n")
    found = states(opened(place))
    assert (found["chain"], found["seal"]) == ("wrong", "wrong")


def test_the_files_beside_it_are_checked_once_the_folder_is_chosen(
    whole: Path, opened: Callable[[Path], Page], tmp_path: Path
) -> None:
    place = Path(shutil.copytree(whole, tmp_path / "folder"))
    page = opened(place)
    choice = page.locator('[data-choice="folder"]')
    choice.set_input_files(place)
    expect(page.locator('[data-check="folder"]')).to_have_attribute("data-state", "fine")
    picture = next((place / "crops").glob("*.jpg"))
    picture.write_bytes(picture.read_bytes() + b"\0")
    (place / "more.txt").write_text("put in")
    choice.set_input_files(place)
    expect(page.locator('[data-check="folder"]')).to_have_attribute("data-state", "wrong")
    expect(page.locator('[data-check="folder"]')).to_contain_text("crops/")
    expect(page.locator("[data-verdict]")).to_have_attribute("data-verdict", "wrong")


DROP = """([name, content]) => {
    const dropped = new DataTransfer();
    dropped.items.add(new File([Uint8Array.from(atob(content), (one) => one.charCodeAt(0))], name));
    const told = { dataTransfer: dropped, bubbles: true, cancelable: true };
    if (document.body.dispatchEvent(new DragEvent("dragover", told))) throw new Error("not taken");
    document.body.dispatchEvent(new DragEvent("drop", told));
}"""


def drop(page: Page, zipped: Path) -> None:
    """Lets go of a file over the page."""
    page.evaluate(DROP, [zipped.name, base64.b64encode(zipped.read_bytes()).decode()])


def test_a_zip_dropped_on_the_page_is_checked_whole(
    whole: Path, opened: Callable[[Path], Page], tmp_path: Path
) -> None:
    zipped = Path(shutil.make_archive(str(tmp_path / "package"), "zip", whole))
    page = opened(whole)
    drop(page, zipped)
    check = page.locator('[data-check="folder"]')
    expect(check).to_have_attribute("data-state", "fine")
    files = sum(1 for one in whole.rglob("*") if one.is_file())
    expect(check).to_contain_text(f"All {files} files")
    zipped.write_bytes(zipped.read_bytes()[:-200])
    drop(page, zipped)
    expect(check).to_contain_text("not a complete package")
    place = Path(shutil.copytree(whole, tmp_path / "changed" / "package"))
    (place / "tables/measurements.csv").write_text((place / "tables/measurements.csv").read_text() + "\n")
    page.locator('[data-choice="zip"]').set_input_files(
        shutil.make_archive(str(tmp_path / "other"), "zip", tmp_path / "changed")
    )
    expect(check).to_contain_text("Changed after the export: tables/measurements.csv")
    expect(page.locator("[data-verdict]")).to_have_attribute("data-verdict", "wrong")


def test_a_page_taken_out_of_its_zip_has_the_chain_from_there(
    whole: Path, opened: Callable[[Path], Page], tmp_path: Path
) -> None:
    zipped = Path(shutil.make_archive(str(tmp_path / "package"), "zip", whole))
    # Everything but the chain: the console's words on what is not there would fail the test.
    alone = Path(shutil.copytree(whole, tmp_path / "alone"))
    (alone / "audit.js").write_text("")
    page = opened(alone)
    assert states(page)["chain"] == "open"
    drop(page, zipped)
    expect(page.locator('[data-check="folder"]')).to_have_attribute("data-state", "fine")
    assert set(states(page).values()) == {"fine"}, states(page)


def test_a_limited_package_says_so_at_its_top_and_of_what_lies_outside(
    limited: tuple[Path, str], opened: Callable[[Path], Page]
) -> None:
    place, kept = limited
    page = opened(place)
    expect(page.locator("header [data-only]")).to_contain_text("cover only: SUV")
    outside = {row["id"] for row in rows(place, "tables/vehicles.csv") if row["category"] != kept}
    pictured = {row["measurement_id"] for row in rows(place, "tables/crops.csv")}
    told = [row for row in rows(place, "tables/measurements.csv") if row["withdrawn"] != "true"]
    strange = next(row["id"] for row in told if row["vehicle_id"] in outside)
    line = page.locator(f'[data-measurement="{strange}"]')
    expect(line).to_contain_text("outside the limits")
    line.get_by_role("button").click()
    expect(page.locator("[data-outside]")).to_contain_text("Outside the limits of this package (SUV)")
    inside = page.locator(f'[data-measurement="{next(iter(pictured))}"]')
    expect(inside).not_to_contain_text("outside the limits")


def test_heights_that_are_out_of_date_are_counted_marked_and_found_by_the_filter(
    whole: Path, limited: tuple[Path, str], opened: Callable[[Path], Page]
) -> None:
    page = opened(whole)
    expect(page.locator("[data-stale]")).to_have_count(0)
    before = states(page)
    place, _ = limited
    page = opened(place)
    standing = [row for row in rows(place, "tables/measurements.csv") if row["withdrawn"] != "true"]
    usual = [row for row in standing if (row["target"], row["inset_from"]) == ("roof", "usual")]
    stale = {row["id"] for row in standing if row["out_of_date"]}
    assert stale == {row["id"] for row in usual} and len(stale) > 1
    told = page.locator(f'[data-stale="{len(stale)}"]')
    expect(told).to_contain_text(f"{len(stale)} heights are out of date")
    page.get_by_label("Show").select_option("stale")
    assert set(heights(page)) == stale
    line = page.locator("[data-measurement]").first
    expect(line).to_contain_text("out of date")
    line.get_by_role("button").click()
    said = "Out of date: the inset was changed after it was computed."
    expect(page.locator("[data-stale-cause]")).to_have_text(said)
    assert states(page) == before


def with_table(text: str, path: str, old: str, new: str) -> str:
    """The page with some words of a table replaced."""
    found = re.search(rf'data-path="{path}">([^<]*)<', text)
    assert found
    table = zlib.decompress(base64.b64decode(found[1]), -15).replace(old.encode(), new.encode(), 1)
    return text.replace(found[1], packed(table))


def packed(content: bytes) -> str:
    packer = zlib.compressobj(6, zlib.DEFLATED, -15)
    return base64.b64encode(packer.compress(content) + packer.flush()).decode()
