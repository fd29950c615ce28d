"""Tables that spreadsheets, databases and hands spoil, made up before the reader of tables was read.

Each is refused in one sentence that says where and what, or read for what it says and nothing else.
"""

from __future__ import annotations

import codecs
import json
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.infra.database.engine import make_engine, migrate

HEIGHTS = "id,height_m,u_height_m,reference_height_m,lighting,status\n"
GOOD = "1,1.41,0.005,1.40,daytime,ok\n2,1.52,0.005,1.50,daytime,ok\n3,1.63,0.005,1.60,daytime,ok\n"
CATALOGUE = "make,model,year_from,height_m\n"
AS_READ = {"n": 3, "bias_m": pytest.approx(0.02)}

# name: content, and what its three rows come to, or the words of the refusal
ERRORS: dict[str, tuple[bytes, dict[str, Any] | tuple[str, ...]]] = {
    "UTF-16 of a spreadsheet": (codecs.BOM_UTF16_LE + (HEIGHTS + GOOD).encode("utf-16-le"), ("UTF-8",)),
    "a NUL in a cell": ((HEIGHTS + GOOD).replace("1.52", "1.5\x002").encode(), ("line 3",)),
    "zeros after a crash": ((HEIGHTS + GOOD).encode() + b"\x00" * 512, ("line 5",)),
    "digits of another script": ((HEIGHTS + GOOD).replace("1.52", "1.٥2").encode(), ("line 3", "height_m")),
    "a value that is no number": ((HEIGHTS + GOOD).replace("1.52", "NaN").encode(), ("line 3", "height_m")),
    "a value without end": ((HEIGHTS + GOOD).replace("1.52", "inf").encode(), ("line 3", "height_m")),
    "underscores": ((HEIGHTS + GOOD).replace("1.52", "1_5.2").encode(), ("line 3", "height_m")),
    "a number of the spreadsheet's error": (
        (HEIGHTS + GOOD).replace("1.50", "#REF!").encode(), ("line 3", "reference_height_m")),
    "a negative height": (
        (HEIGHTS + GOOD).replace("1.50", "-1.50").encode(), ("line 3", "reference_height_m")),
    "a unit in the cell": ((HEIGHTS + GOOD).replace("1.52", "1.52 m").encode(), ("line 3", "height_m")),
    "a row too short": (
        (HEIGHTS + GOOD).replace("2,1.52,0.005,1.50,daytime,ok", "2,1.52").encode(), ("line 3", "2 cells")),
    "the header twice": ((HEIGHTS + GOOD + HEIGHTS + GOOD).encode(), ("line 5",)),
    "a title above the header": (("Survey of 3 May\n" + HEIGHTS + GOOD).encode(), ("height_m",)),
    "blank lines between": ((HEIGHTS + GOOD).replace("\n", "\n\n").encode(), AS_READ),
    "semicolons": ((HEIGHTS + GOOD).replace(",", ";").encode(), AS_READ),
    "semicolons and decimal commas": (
        (HEIGHTS + GOOD).replace(",", ";").replace(".", ",").encode(), ("line 2", "height_m")),
    "the separator named first": (("sep=,\n" + HEIGHTS + GOOD).encode(), AS_READ),
    "spaces around cells": ((HEIGHTS + GOOD).replace(",", " , ").encode(), AS_READ),
    "names in capitals": ((HEIGHTS.upper() + GOOD).encode(), ("height_m",)),
    "a page in HTML": (b"<!DOCTYPE html><html><body>Sign in</body></html>\n", ("height_m",)),
    "a spreadsheet's own file": (b"PK\x03\x04\x14\x00\x06\x00\x08\x00" + bytes(range(256)) * 4, ("UTF-8",)),
    "nothing": (b"", ("is empty",)),
    "a header alone": (HEIGHTS.encode(), {"n": 0}),
    "Windows' letters": ((HEIGHTS + GOOD).replace("2,1.52", "Citroën,1.52").encode("cp1252"), ("UTF-8",)),
    "a lone CR and the last line cut": ((HEIGHTS + GOOD).replace("\n", "\r").rstrip().encode(), AS_READ),
}  # fmt: skip


@pytest.mark.parametrize("name", ERRORS)
def test_heights(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    content, right = ERRORS[name]
    path = tmp_path / "heights.csv"
    path.write_bytes(content)
    status = main(["errors", str(path), "--round", "none", "--json"])
    out, err = capsys.readouterr()
    if isinstance(right, tuple):
        assert status == 2 and "Traceback" not in err and err.count("\n") == 1, (status, out[:300], err)
        assert all(word in err for word in ("heights.csv", *right)), err
        return
    assert status == 0, err
    group = json.loads(out)["groups"]["overall"]
    assert {key: group[key] for key in right} == right


# name: content, and what becomes of its lines, or the words of the refusal of the whole
MODELS: dict[str, tuple[str, dict[int, str] | tuple[str, ...]]] = {
    "a year of two digits": (CATALOGUE + "Aldo,One,18,1.48\nAldo,Two,2018,1.51\n", {2: "refused", 3: "new"}),
    "a year as a date": (CATALOGUE + "Aldo,One,2018-01-01,1.48\n", {2: "refused"}),
    "a year of a spreadsheet's number": (CATALOGUE + "Aldo,One,2018.0,1.48\n", {2: "refused"}),
    "a height of nothing": (CATALOGUE + "Aldo,One,2018,0\n", {2: "refused"}),
    "thousands": (CATALOGUE + 'Aldo,One,2018,"1,480"\n', {2: "refused"}),
    "an exponent": (CATALOGUE + "Aldo,One,2018,1.48e0\n", {2: "new"}),
    "no name": (CATALOGUE + ",One,2018,1.48\nAldo,,2018,1.48\n", {2: "refused", 3: "refused"}),
    "a column named twice": ("make,model,height_m,height_m\nAldo,One,1.48,1.58\n", ("height_m",)),
    "a column twice in two units": (
        "make,model,height_m,height_mm\nAldo,One,1.48,1580\n", ("height_m and height_mm",)),
    "a formula": (CATALOGUE + "Aldo,\"=HYPERLINK(\"\"x\"\")\",2018,1.48\n", {2: "new"}),
    "quotes of print": (CATALOGUE + "Aldo,“One”,2018,1.48\n", {2: "new"}),
    "a tab in a name": (
        CATALOGUE + "Aldo,One\tMore,2018,1.48\nAldo,One More,2018,1.48\n", {2: "new", 3: "duplicate"}),
    "to before from": ("make,model,year_from,year_to,height_m\nAldo,One,2018,2015,1.48\n", {2: "refused"}),
    "years to come": (CATALOGUE + "Aldo,One,3018,1.48\n", {2: "refused"}),
}  # fmt: skip


@pytest.fixture
def data_dir(tmp_path: Path) -> Path:
    """A data folder with an empty database."""
    engine = make_engine(f"sqlite:///{tmp_path / 'data' / 'sightline.db'}")
    migrate(engine)
    engine.dispose()
    return tmp_path / "data"


@pytest.mark.parametrize("name", MODELS)
def test_catalogue(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], data_dir: Path) -> None:
    content, right = MODELS[name]
    path = tmp_path / "catalogue.csv"
    path.write_text(content)
    status = main(["catalogue", "import", str(path), "--dry-run", "--json", "--data-dir", str(data_dir)])
    out, err = capsys.readouterr()
    if isinstance(right, tuple):
        said = err + (str(json.loads(out)["problem"]) if out else "")
        assert "Traceback" not in err and all(word in said for word in right), (status, out, err)
        return
    assert {row["line"]: row["change"] for row in json.loads(out)["rows"]} == right
