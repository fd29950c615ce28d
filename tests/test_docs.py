"""What the papers name exists: commands, settings, columns, files, folders; their lines fit a screen."""

import re
from pathlib import Path

import pytest

from sightline.cli import COMMANDS
from sightline.commands import clicks, linescan, passes_csv
from sightline.export.contents import tables_of
from sightline.settings import Settings

ROOT = Path(__file__).resolve().parents[1]
PAPERS = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
GUIDE = sorted((ROOT / "docs" / "guide").rglob("*.md"))
FORMATS = (ROOT / "docs" / "formats.md").read_text(encoding="utf-8")
# Variables that are no field of Settings: where the migrations are, and what only tests and errors read.
ELSEWHERE = {"MIGRATIONS", "DEBUG", "SHARED_DATA", "TEST_DATABASE_URL", "COMMIT", "VERSION"}


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
    there = {table.path for table in tables_of(2)}
    named = set(re.findall(r"`([a-z_]+\.csv)`", section("The package")))
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


@pytest.mark.parametrize("paper", GUIDE, ids=lambda paper: paper.name)
def test_what_the_guide_calls_by_name_is_called_so_on_the_screens(paper: Path) -> None:
    """Bold words and phrases in the guide are names of pages and buttons; sentences in bold are not."""
    catalogue = of(ROOT / "backend" / "sightline" / "messages" / f"{paper.parent.name}.ftl")
    said = set(re.findall(r"^[\w-]+ = (.+)$", catalogue, re.MULTILINE))
    text = " ".join(of(paper).split())
    named = re.findall(r"(?:On|Open|open|opens|Press|press|Under|under|Use|from the) \*\*([^*]+)\*\*", text)
    assert [name for name in named if name not in said] == []


@pytest.mark.parametrize("paper", PAPERS, ids=lambda paper: paper.name)
def test_lines_fit_a_screen(paper: Path) -> None:
    code = False
    for number, line in enumerate(of(paper).splitlines(), 1):
        code ^= line.startswith("```")
        if not code and not line.startswith(("|", "!")):
            assert len(line) <= 120, f"{paper.name}:{number}"
