"""What the papers name exists: commands, settings, columns, files, folders; their lines fit a screen."""

import re
from pathlib import Path

import cv2
import pytest

from sightline.cli import COMMANDS
from sightline.commands import clicks, linescan, passes_csv
from sightline.export.package_tables import tables_of
from sightline.settings import Settings

ROOT = Path(__file__).resolve().parents[1]
PAPERS = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
GUIDE = sorted((ROOT / "docs" / "guide").rglob("*.md"))
ENGLISH = [page for page in GUIDE if page.parent.name == "en"]
TRANSLATED = [page for page in GUIDE if page.parent.name != "en"]
ENGLISH_OF = {page: page.parents[1] / "en" / page.name for page in TRANSLATED}
# What stands before the name of a page or of a button.
LEADS = {
    "en": r"(?:On|Open|open|opens|Press|press|Under|under|Use|from the)",
    "fr": r"(?:Avec|[Cc]hoisissez|[Cc]liquez sur|[Oo]uvrez|[Ll]a page|[Ss]ous|[Uu]tilisez)",
}
# What is written as code and yet in words.
WORDS = {
    "fr": {
        "speed x exposure x focal length in pixels / distance": (
            "vitesse x temps de pose x focale en pixels / distance"
        ),
        "Ctrl+Enter": "Ctrl+Entrée",
        "Shift+S": "Maj+S",
        "Enter": "Entrée",
        "Esc": "Échap",
        "Shift": "Maj",
        "Shift+C": "Maj+C",
        "Shift+M": "Maj+M",
    }
}
FORMATS = (ROOT / "docs" / "formats.md").read_text(encoding="utf-8")
# Variables that are no field of Settings: where the migrations are, and what only tests and errors read.
ELSEWHERE = {"MIGRATIONS", "DEBUG", "TEST_DATABASE_URL", "COMMIT", "TOKEN", "VERSION"}
ELSEWHERE |= {"SHARED_DATA", "PICTURES"}


def of(paper: Path) -> str:
    return paper.read_text(encoding="utf-8")


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.name)
def test_every_command_that_is_named_is_there(paper: Path) -> None:
    named = set(re.findall(r"(?:^|[`/])sightline ([a-z][a-z-]+)\b", of(paper), re.MULTILINE))
    assert named <= set(COMMANDS)


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.name)
def test_every_setting_that_is_named_is_there(paper: Path) -> None:
    named = set(re.findall(r"SIGHTLINE_([A-Z][A-Z_]+[A-Z])", of(paper)))
    assert named <= {name.upper() for name in Settings.model_fields} | ELSEWHERE


def section(title: str) -> str:
    """The text of one section of the formats page."""
    return FORMATS.split(f"\n## {title}\n")[1].split("\n## ")[0]


def test_every_column_of_heights_and_vehicles_is_described() -> None:
    heights, vehicles = section("clicks.csv and heights.csv"), section("vehicles.csv")
    for name in (*clicks.NEEDED, *clicks.OPTIONS, *clicks.WORDS, *clicks.RESULTS):
        assert f"`{name}`" in heights, name
    named = re.findall(r"`([a-z_0-9]+)`", vehicles.split(". Lines count")[0])
    assert tuple(name for name in named if name != "linescan") == tuple(linescan.COLUMNS)


def test_every_column_of_passes_is_described() -> None:
    passes = section("passes.csv and adjusted.json")
    assert [name for name in (*passes_csv.NEEDED, *passes_csv.OPTIONS) if f"`{name}`" not in passes] == []


def test_every_table_of_the_package_that_is_named_is_there() -> None:
    there = {table.key for table in tables_of(2)}
    named = set(re.findall(r"`((?:statistics/)?[a-z_]+\.csv)`", section("The package")))
    assert named <= there


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.name)
def test_every_path_that_is_named_is_there(paper: Path) -> None:
    named = re.findall(r"`((?:backend|frontend|tests|docs|migrations)/[\w./-]+)`", of(paper))
    assert [name for name in named if not (ROOT / name).exists()] == []


def test_the_map_names_every_room() -> None:
    text = of(ROOT / "ARCHITECTURE.md")
    package = ROOT / "backend" / "sightline"
    rooms = [path.name for path in package.iterdir() if path.is_dir() and (path / "__init__.py").exists()]
    assert [room for room in rooms if not re.search(rf"\b{room}/", text)] == []
    assert [
        path.name for path in package.glob("*.py") if path.name not in text and path.stem != "__init__"
    ] == []


def sentences(language: str) -> dict[str, str]:
    """The one-line sentences of a language's catalogue by their keys."""
    catalogue = of(ROOT / "backend" / "sightline" / "messages" / f"{language}.ftl")
    return dict(re.findall(r"^([\w-]+) = (.+)$", catalogue, re.MULTILINE))


def named_on_screens(page: Path) -> list[str]:
    """Bold words and phrases of the guide that name pages and buttons; sentences in bold do not."""
    return re.findall(rf"{LEADS[page.parent.name]} \*\*([^*]+)\*\*", " ".join(of(page).split()))


@pytest.mark.parametrize("page", GUIDE, ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_what_the_guide_calls_by_name_is_called_so_on_the_screens(page: Path) -> None:
    said = set(sentences(page.parent.name).values())
    assert [name for name in named_on_screens(page) if name not in said] == []


@pytest.mark.parametrize("page", TRANSLATED, ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_a_translated_page_names_every_page_and_button_that_the_english_names(page: Path) -> None:
    english, others = sentences("en"), sentences(page.parent.name)
    bold = set(re.findall(r"\*\*([^*]+)\*\*", " ".join(of(page).split())))
    for name in named_on_screens(ENGLISH_OF[page]):
        called = {others[key] for key, text in english.items() if text == name}
        assert bold & called, (name, called)


def test_every_language_has_every_page_of_the_guide() -> None:
    names = {page.name for page in ENGLISH}
    for language in {page.parent for page in TRANSLATED}:
        assert {page.name for page in language.glob("*.md")} == names


@pytest.mark.parametrize("page", TRANSLATED, ids=lambda page: f"{page.parent.name}-{page.stem}")
def test_a_translated_page_has_all_that_the_english_has(page: Path) -> None:
    """The same headings, items and rows in their order, and the same links and code."""
    words = WORDS[page.parent.name]
    english, other = of(ENGLISH_OF[page]), of(page)
    form = re.compile(r"^ *(#+|\d+\.|-|\|)(?= ?\S)", re.MULTILINE)
    assert form.findall(other) == form.findall(english)
    assert sorted(re.findall(r"\]\(([^)]+)\)", other)) == sorted(re.findall(r"\]\(([^)]+)\)", english))
    code = [" ".join(one.split()) for one in re.findall(r"`([^`]+)`", english)]
    assert sorted(" ".join(one.split()) for one in re.findall(r"`([^`]+)`", other)) == sorted(
        words.get(one, one) for one in code
    )


@pytest.mark.parametrize("page", sorted((ROOT / "docs/guide/fr").glob("*.md")), ids=lambda page: page.stem)
def test_french_signs_stand_apart_by_a_space_that_does_not_break(page: Path) -> None:
    text = re.sub(r"`[^`]*`|\]\([^)]*\)|<!--.*?-->", "`", of(page))
    assert re.findall(r".*(?: [;:!?%»]|« |[\w`]'\w|\w[;!?]).*", text) == []


@pytest.mark.parametrize("language", sorted({page.parent for page in GUIDE}), ids=lambda folder: folder.name)
def test_every_picture_of_the_guide_is_there_as_the_command_makes_it(language: Path) -> None:
    """Named in each language, of the size that the command makes, and small."""
    from tests.browser.guide_pictures import HEIGHT_PX, MOST_BYTES, PICTURES, WIDTH_PX  # loads Playwright

    named = {
        name for page in language.glob("*.md") for name in re.findall(r"!\[[^\]]+\]\(([^)]+)\)", of(page))
    }
    assert named == {f"pictures/{name}.webp" for name in PICTURES}
    assert {f"pictures/{file.name}" for file in (language / "pictures").iterdir()} == named
    for name in named:
        file = language / name
        image = cv2.imread(str(file))
        assert file.stat().st_size <= MOST_BYTES and image is not None
        assert image.shape[:2] == (HEIGHT_PX, WIDTH_PX)


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.name)
def test_lines_fit_a_screen(paper: Path) -> None:
    code = False
    for number, line in enumerate(of(paper).splitlines(), 1):
        code ^= line.startswith("```")
        if not code and not line.startswith(("|", "!")):
            assert len(line) <= 120, f"{paper.name}:{number}"
