"""`sightline catalogue` from the outside: a dry run, an import, an export, one sentence for what is wrong."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sightline.cli import main
from tests.support.kept import Shelf, lay_sqlite

ROWS = (
    "make,model,year_from,height_m,taillight_m\n"
    "Audi,A3,2012,1.43,0.71\nAudi,A3,2012,1.44,\nKia,Rio,2017,1.45,\n"
)


@pytest.fixture
def folder(tmp_path: Path, shelf: Shelf, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A data folder with an empty database, and a list of models beside it."""
    lay_sqlite(shelf, tmp_path / "data")
    (tmp_path / "cars.csv").write_text(ROWS)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_dry_run_stores_nothing_and_an_import_does(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["catalogue", "import", "cars.csv", "--dry-run", "--json", "--data-dir", "data"]) == 0
    plan = json.loads(capsys.readouterr().out)
    assert plan["dry_run"] and plan["counts"]["new"] == 2 and plan["counts"]["duplicate"] == 1
    assert main(["catalogue", "import", "cars.csv", "--data-dir", "data"]) == 0
    said = capsys.readouterr().out
    assert "line 3, Audi A3 2012: duplicate. The same model as line 2" in said
    assert "2 models added, 0 updated." in said
    assert main(["catalogue", "export", "-o", "out.csv", "--data-dir", "data"]) == 0
    assert "Audi,A3,2012,,,1.430000" in Path("out.csv").read_text()
    assert main(["catalogue", "import", "out.csv", "--json", "--data-dir", "data"]) == 0
    assert json.loads(capsys.readouterr().out.partition("\n")[2])["counts"]["same"] == 2


def test_what_is_wrong_is_one_sentence(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("feet.csv").write_text("make,model,height_m\nA,B,4.8\nA,C,4.9\nA,D,5.6\n")
    Path("other.csv").write_text("colour\nred\n")
    for arguments, word in (
        (["feet.csv"], "feet"),
        (["feet.csv", "--dry-run"], "feet"),
        (["other.csv"], "make"),
        (["nowhere.csv"], "nowhere.csv"),
        (["cars.csv", "--column", "height"], "equals sign"),
        (["cars.csv", "--unit", "yards"], "--unit"),
    ):
        assert main(["catalogue", "import", *arguments, "--data-dir", "data"]) == 2, arguments
        printed = capsys.readouterr()
        assert word in printed.err and printed.err.count("\n") == 1 and not printed.out
    assert main(["catalogue", "import", "cars.csv", "--data-dir", "elsewhere"]) == 2
    assert "elsewhere" in capsys.readouterr().err
