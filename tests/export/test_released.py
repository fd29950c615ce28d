"""Packages of earlier versions go on to verify, what other versions made is told, forgeries are found."""

import json
import re
import shutil
import tarfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.export import contents, package_tables
from sightline.export.contents import HEIGHTS, STATISTICS, WORDS
from sightline.export.package_tables import PACKAGE, Part
from sightline.export.seal import check_sealed
from sightline.export.verify import derived, described
from sightline.export.verify.package import PackageCheck, verify_package
from sightline.infra import source_hash
from sightline.infra.audit.anchors import Anchors
from sightline.infra.audit.hashing import canonical_json, content_hash
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.csv_package.schema import Column, Table, json_bytes
from sightline.measurements import verify as measured
from sightline.measurements.height_of_clicks import Answer
from sightline.studies.packages import read_packages
from sightline.studies.query import READ, StudyTables
from tests.export.keep_released import KEPT
from tests.support.forgeries import a_height, roof
from tests.support.packages import (
    edit,
    ground,
    package,
    rederive,
    rehash,
    reseal,
    rewrite,
    rows,
    worked,
)

__all__ = ["ground", "package", "worked"]

RELEASED = sorted(KEPT.glob("*.tar.xz"))
#: What is said of each beyond that it verifies: here of one, in `make proofs` of all.
ONE_RELEASED = pytest.mark.parametrize(
    "released",
    [RELEASED[0], *(pytest.param(one, marks=pytest.mark.proof) for one in RELEASED[1:])],
    ids=lambda place: place.name.removesuffix(".tar.xz"),
    indirect=True,
)


def check(place: Path, *heads: str) -> PackageCheck:
    return verify_package(FolderFiles(place), Anchors(heads=heads))


@pytest.fixture(params=RELEASED, ids=lambda place: place.name.removesuffix(".tar.xz"))
def released(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A package that an earlier version made."""
    place = tmp_path / "released"
    with tarfile.open(request.param) as archive:
        archive.extractall(place, filter="data")
    return place


@pytest.fixture
def later(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Makes this program a later version, whose parts of these names have another source."""

    def become(*changed: str) -> None:
        real = contents.made_with()

        def made_with() -> dict[str, str]:
            return {**real, "sightline": "9.0", **dict.fromkeys(changed, "another")}

        monkeypatch.setattr(described, "made_with", made_with)
        monkeypatch.setattr(described, "code_version", lambda: "9.0")

    return become


def test_a_package_is_kept() -> None:
    assert RELEASED and all(place.stat().st_size < 600_000 for place in RELEASED)


def test_a_package_of_an_earlier_version_verifies(released: Path) -> None:
    found = check(released)
    assert found.ok, found.problem
    compared = len(rows(released, "revisions.csv")) + len(rows(released, "repeats.csv"))
    assert found.heights == compared or "heights" in found.not_checked
    version = json.loads((released / "datapackage.json").read_text())["made_with"]["sightline"]
    assert f"Made by version {version}" in " ".join(found.notes)
    assert ("drawings" in found.not_checked) == (found.drawings == 0)


def test_flow_reads_a_package_of_an_earlier_version(
    released: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of two without codes of reasons it told a bare error."""
    assert main(["flow", str(released), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["notes"] == [
        "Gate: The start of this line scan is not confirmed. Confirm it to count its traffic by time of day."
    ]


@ONE_RELEASED
def test_an_anchor_tells_what_is_said_of_a_package_of_an_earlier_version(
    released: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = check(released)
    assert main(["verify", str(released), "--json"]) == (3 if found.not_checked else 0)
    told = json.loads(capsys.readouterr().out)
    assert (told["not_checked"], told["problems"]) == (found.not_checked, [])
    assert told["status"] == ("unanchored" if found.not_checked else "holds")
    first, (kept, key) = rows(released, "audit.csv")[0]["hash"], (released / "checkpoint.json", found.key)
    for anchor, status in (
        (["--head", found.head_hash], 0),
        (["--key", key], 0),
        (["--checkpoint", str(kept)], 0),
        (["--head", first], 3 if found.not_checked else 0),
    ):
        assert main(["verify", str(released), *anchor, "--json"]) == status, anchor
        told = json.loads(capsys.readouterr().out)
        assert told["status"] == ("unanchored" if status else "holds")


def test_a_package_of_an_earlier_version_enters_a_study(released: Path, tmp_path: Path) -> None:
    """Its tables lie in its root, since format 3 in `tables/`."""
    assert (released / "measurements.csv").is_file() != (released / "tables" / "measurements.csv").is_file()
    accepted = [row for row in rows(released, "measurements.csv") if row["verdict"] in ("accepted", "fixed")]
    (found,) = read_packages([released], lambda files: check_sealed(files, READ), tmp_path / "scratch")
    with StudyTables([found]) as tables:
        (counted,), (outside,) = tables.counted()
    assert accepted and counted + outside <= len(accepted) and counted > 0


def test_packages_of_all_versions_enter_one_study(package: Path, tmp_path: Path) -> None:
    """With columns that earlier ones lack, and that no figure is made of."""
    places = [tmp_path / kept.name for kept in RELEASED]
    for kept, place in zip(RELEASED, places, strict=True):
        with tarfile.open(kept) as archive:
            archive.extractall(place, filter="data")
    found = read_packages([*places, package], lambda files: check_sealed(files, READ), tmp_path / "scratch")
    with StudyTables(found) as tables:
        counted, _ = tables.counted()
    assert len(counted) == len(RELEASED) + 1 and all(counted > 0)


def test_the_root_of_a_package_is_short(package: Path) -> None:
    """And what a reader opens first lies there."""
    root = {path.name for path in package.iterdir()}
    assert len(root) <= 20, sorted(root)
    assert {"README.txt", "datapackage.json", "audit.csv", "report.pdf", "tables"} <= root
    assert [name for name in root if name.endswith(".csv")] == ["audit.csv"]


def test_a_table_in_two_places_is_refused(package: Path, later: Callable[..., None]) -> None:
    """By every version, for two programs could read two tables; whether it is described once or twice."""
    shutil.copyfile(package / "tables" / "people.csv", package / "people.csv")
    reseal(package)
    assert "people.csv" in str(check(package).problem)
    assert "people.csv is in the package twice" in str(check_sealed(FolderFiles(package), ["people.csv"]))
    place = package / "datapackage.json"
    told = json.loads(place.read_text())
    (people,) = (one for one in told["resources"] if one["path"] == "tables/people.csv")
    told["resources"].append({**people, "path": "people.csv"})
    place.write_bytes(json_bytes(told))
    reseal(package)
    for version in ("this", "another"):
        assert str(check(package).problem).startswith("people.csv is in the package twice"), version
        later()


@ONE_RELEASED
@pytest.mark.parametrize("name", ["height_m", "u_height_m", "target_y_px", "code_version"])
def test_a_forged_height_of_an_earlier_version_is_found(released: Path, name: str) -> None:
    """All sums, the seal and a signature fit; the height's own event does not.

    While the geometry is the one that made the package, what the clicks give is compared first.
    """
    number = "1.210000" if name.endswith("_m") else "99.5" if name.endswith("_px") else "0.0.1+other"
    for table in ("measurements.csv", "revisions.csv"):
        edit(released, table, roof, **{name: number})
    reseal(released)
    found = check(released)
    assert not found.ok
    assert re.search("1 differs from its audit event|1 states height .* one is wrong", str(found.problem))


def forge_with_its_event(place: Path) -> str:
    """A roof's height everywhere, its event too, and the chain from there on; the head before that."""
    events = rows(place, "audit.csv")
    head = events[-1]["hash"]
    for at, event in enumerate(events):
        if event["entity"] == "measurement" and '"height_m":1.31' in event["after"]:
            after = json.loads(event["after"])
            after["row"]["height_m"] = 1.3099
            after["content_sha256"] = content_hash(after["row"])
            events[at]["after"] = canonical_json(after)
            first = at
    rewrite(place, "audit.csv", rehash(events, first))
    for table in ("measurements.csv", "revisions.csv"):
        edit(place, table, roof, height_m="1.309900")
    rederive(place)
    return head


def test_a_height_that_another_version_computed_otherwise_is_told(
    package: Path, later: Callable[..., None]
) -> None:
    """Who writes chain and signature anew is found by the same program, and by one that computes alike; any
    other tells the number, and the head that was kept finds it.
    """
    head = forge_with_its_event(package)
    found = check(package)
    assert not found.ok and "its clicks give 1.310000 m" in str(found.problem)
    later()
    assert "its clicks give 1.310000 m" in str(check(package).problem)
    later(HEIGHTS)
    found = check(package)
    assert found.ok and found.not_checked[0] == "heights", found.problem
    assert "states height 1.309900, its clicks give 1.310000 m" in " ".join(found.notes)
    assert "goes through the given audit head" in str(check(package, head).problem)


def test_words_are_held_against_their_codes_and_codes_against_the_events(
    package: Path, later: Callable[..., None]
) -> None:
    """Codes are the events' for every version; the words of another version only the seal binds."""

    def forge(**cells: str) -> None:
        for table in ("measurements.csv", "revisions.csv"):
            edit(package, table, lambda row: row["flags"] != "", **cells)

    forge(flags="Nothing is wrong.")
    rederive(package)
    assert "flags does not match the code beside it" in str(check(package).problem)
    later(WORDS)
    found = check(package)
    assert found.ok, found.problem
    assert "words" in found.not_checked and "put into words by another version" in " ".join(found.notes)
    forge(flags_code='[{"code":"height-flag-u-large","values":{}}]')
    rederive(package)
    assert "differs from its audit event" in str(check(package).problem)


def test_a_later_geometry_calls_no_height_wrong(
    package: Path, later: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    real = measured.answer

    def improved(*given: Any) -> Answer:
        found = real(*given)
        return found if found.height_m is None else replace(found, height_m=found.height_m + 2e-6)

    monkeypatch.setattr(measured, "answer", improved)
    assert "one is wrong" in str(check(package).problem)
    later(HEIGHTS)
    found = check(package)
    assert found.ok, found.problem
    assert found.not_checked == ["heights", "description"]
    assert "8 numbers that other versions computed differ" in " ".join(found.notes)
    a_height(package)
    assert "differs from its audit event" in str(check(package).problem)


def test_statistics_and_drawings_of_a_changed_module_are_sealed_and_not_wrong(
    package: Path, later: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    real = derived.statistics_rows

    def otherwise(*given: Any) -> dict[str, list[dict[str, Any]]]:
        return {path: list(found)[:-1] for path, found in real(*given).items()}

    monkeypatch.setattr(derived, "draw_derived_files", lambda *_: [("report.pdf", b"another")])
    assert "report.pdf is not what these rows" in str(check(package).problem)
    later("drawing")
    found = check(package)
    assert found.ok and (found.drawings, found.not_checked) == (0, ["description", "drawings"]), found.problem
    assert "covered by the seal, not compared" in " ".join(found.notes)
    monkeypatch.setattr(derived, "statistics_rows", otherwise)
    assert not check(package).ok
    later(STATISTICS, "drawing")
    found = check(package)
    assert found.ok and found.not_checked == ["description", "statistics", "drawings"], found.problem
    assert "Statistics differ from those of this version" in " ".join(found.notes)
    path = package / "report.pdf"
    path.write_bytes(path.read_bytes() + b"%")
    reseal(package, seal=False)
    assert "is not what the package’s seal" in str(check(package).problem)


@ONE_RELEASED
def test_later_tables_and_columns_break_no_package(
    package: Path, released: Path, later: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    table: Table[Any] = Table("later", "Made later.", (Column("id", "integer", "a number"),), primary=("id",))
    column: Column[Any] = Column("later", "string", "a word", of=lambda _: "word")
    revisions = replace(measured.REVISIONS, columns=(*measured.REVISIONS.columns, column))
    monkeypatch.setattr(measured, "REVISIONS", revisions)
    monkeypatch.setattr(package_tables, "REVISIONS", revisions)
    monkeypatch.setattr(package_tables, "PACKAGE", (*PACKAGE, Part((table,), lambda _: None)))
    assert check(released).ok, check(released).problem
    assert not check(package).ok
    later()
    found = check(package)
    assert found.ok, found.problem
    assert found.not_checked == ["description"] and found.drawings > 0


def test_a_column_put_into_the_budget_is_refused(package: Path, later: Callable[..., None]) -> None:
    """By every version: no event says it."""
    rewrite(package, "budget.csv", [{**row, "u_mm": "0.1"} for row in rows(package, "budget.csv")])
    place = package / "datapackage.json"
    told = json.loads(place.read_text())
    (budget,) = (one for one in told["resources"] if one["path"] == "tables/budget.csv")
    budget["schema"]["fields"].append({"name": "u_mm", "type": "number", "description": "put in"})
    place.write_bytes(json_bytes(told))
    reseal(package)
    for version in ("this", "another"):
        found = str(check(package).problem)
        assert found.startswith("budget.csv: the contributions to 1 differ"), (version, found)
        later()


def test_a_program_knows_its_own_parts(package: Path, later: Callable[..., None]) -> None:
    """Nobody escapes a comparison by naming another source for the version that checks."""
    place = package / "datapackage.json"
    told = json.loads(place.read_text())
    for drawing, said in (("0" * 16, "another made_with"), (told["made_with"]["drawing"], "None")):
        told["made_with"] |= {"sightline": "9.0", "drawing": drawing}
        place.write_bytes(json_bytes(told))
        reseal(package)
        later()
        assert said in str(check(package).problem)


def test_another_format_is_refused(package: Path) -> None:
    place = package / "datapackage.json"
    text = place.read_text()
    assert json.loads(text)["format"] == 3
    place.write_text(text.replace('"format": 3,', '"format": 4,', 1))
    reseal(package)
    assert "has format 4, which this version of Sightline does not know" in str(check(package).problem)


def test_what_statistics_and_drawings_rest_on_is_found_by_their_imports() -> None:
    """Among them what a list by hand had left out, and nothing that serves pages or starts the program."""

    def names(part: str) -> set[str]:
        modules, _ = contents.PARTS[part]
        files = source_hash.import_closure(*modules)
        return {path.relative_to(source_hash.ROOT / "sightline").as_posix() for path in files}

    drawing = names("drawing")
    left_out = {"coverage.py", "enums.py", "geometry/documents.py", "recordings/filming.py"}
    assert left_out | {"infra/local_time.py", "vehicles/records.py"} <= drawing
    assert names(STATISTICS) <= drawing
    assert not {name for name in drawing if name.endswith(("routes.py", "app.py"))}
    assert "geometry/height.py" in names(HEIGHTS) and not {
        n for n in names(HEIGHTS) if n.startswith("export")
    }


def test_a_hash_changes_with_what_is_imported_and_with_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(source_hash, "ROOT", tmp_path)
    room = tmp_path / "sightline" / "somewhere"
    room.mkdir(parents=True)
    for folder in (room.parent, room):
        (folder / "__init__.py").write_text("")
    lines = (
        "from typing import TYPE_CHECKING",
        "if TYPE_CHECKING:",
        "    from sightline.somewhere import typed",
        "def f():",
        "    from sightline.somewhere import late",
        "    import numpy",
    )
    (room / "first.py").write_text("\n".join(lines))
    for name in ("late", "typed", "beside"):
        (room / f"{name}.py").write_text("")
    (room / "words.ftl").write_text("a = A")

    def now() -> tuple[str, str]:
        for one in (source_hash.source_hash, source_hash._imports, source_hash._file_of):
            one.cache_clear()
        place = "sightline.somewhere.first"
        return source_hash.source_hash(place), source_hash.source_hash(place, texts=(".ftl",))

    before = now()
    for name in ("typed.py", "beside.py"):
        (room / name).write_text("changed = 1")
        assert now() == before
    (room / "words.ftl").write_text("a = B")
    assert now()[0] == before[0] and now()[1] != before[1]
    for name in ("late.py", "__init__.py"):
        (room / name).write_text("changed = 1")
        assert now()[0] != before[0]
        (room / name).write_text("")
        assert now()[0] == before[0]
    for one in (source_hash.source_hash, source_hash._imports, source_hash._file_of):
        one.cache_clear()
