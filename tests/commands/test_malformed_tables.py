"""Tables that spreadsheets, databases and hands spoil, made up before the reader of tables was read.

Each is refused in one sentence that says where and what, or read for what it says and nothing else.
"""

from __future__ import annotations

import codecs
import csv
import io
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.commands.clicks import heights_csv
from sightline.commands.passes_csv import read_passes
from sightline.commands.tracks_csv import read_tracks
from sightline.errors import BadInput
from sightline.linescan.rig_calibration import Common
from sightline.scans.rig.passes_csv import read_rig_passes
from sightline.studies.fleet_csv import read_fleet, read_sites
from tests.geometry.scenes import pose_of
from tests.geometry.simulate import Lens, Scene
from tests.support.kept import Shelf, lay_sqlite

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
    "a known height of nothing": (
        (HEIGHTS + GOOD).replace("1.50", "0").encode(), ("line 3", "a size is above 0")),
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
    "metres as millimetres": (
        "make,model,height_mm\nAldo,One,1.48\nAldo,Two,1480\n", {2: "refused", 3: "new"}),
    "to before from": ("make,model,year_from,year_to,height_m\nAldo,One,2018,2015,1.48\n", {2: "refused"}),
    "years to come": (CATALOGUE + "Aldo,One,3018,1.48\n", {2: "refused"}),
}  # fmt: skip


@pytest.fixture
def data_dir(tmp_path: Path, shelf: Shelf) -> Path:
    return lay_sqlite(shelf, tmp_path / "data")


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


def refused(words: tuple[str, ...], read: Callable[..., object], *given: object) -> None:
    """The reading is refused with a reason that has all these words."""
    with pytest.raises(BadInput) as error:
        read(*given)
    assert all(word in str(error.value) for word in words), error.value


FLEET = "category,share\n"
SITES = "site,stratum,sites_there,traffic\n"
EVEN = {"category": {"car": pytest.approx(0.7), "van": pytest.approx(0.3)}}

# name: content, and the shares that it says, or the words of the refusal
FLEETS: dict[str, tuple[str, dict[str, Any] | tuple[str, ...]]] = {
    "shares in per cent": (FLEET + "car,70\nvan,30\n", ("100",)),
    "per cent signs": (FLEET + "car,70 %\nvan,30 %\n", ("line 2", "share")),
    "decimal commas": (FLEET + "car,0,7\nvan,0,3\n", ("line 2", "cells")),
    "a negative share": (FLEET + "car,1.1\nvan,-0.1\n", ("share", "-0.1")),
    "a class twice": (FLEET + "car,0.4\ncar,0.3\nvan,0.3\n", ("car",)),
    "a class without a name": (FLEET + "car,0.7\n,0.3\n", ("3", "category")),
    "a share that is empty": (FLEET + "car,0.7\nvan,\n", ("line 3", "share")),
    "a share that is no number": (FLEET + "car,NaN\nvan,0.3\n", ("line 2", "share")),
    "shares that lack a class": (FLEET + "car,0.7\nvan,0.2\n", ("0.9",)),
    "a line with the total": (FLEET + "car,0.7\nvan,0.3\ntotal,1.0\n", ("2",)),
    "registrations of nobody": ("category,registrations\ncar,0\nvan,0\n", ("category",)),
    "shares and registrations": ("category,share,registrations\ncar,1,10\n", ("share",)),
    "no classes": (FLEET, ("fleet.csv",)),
    "no class in the header": ("kind,share\ncar,1\n", ("category",)),
    "registrations": ("category,registrations\ncar,700\nvan,300\n", EVEN),
    "blank lines and semicolons": ("category;share\n\ncar;0.7\n\nvan;0.3\n", EVEN),
}  # fmt: skip


@pytest.mark.parametrize("name", FLEETS)
def test_fleet(name: str) -> None:
    content, right = FLEETS[name]
    if isinstance(right, tuple):
        return refused(("fleet.csv", *right), read_fleet, Path("fleet.csv"), content)
    assert read_fleet(Path("fleet.csv"), content).margins == right


OF_SITES: dict[str, tuple[str, int | tuple[str, ...]]] = {
    "a site twice": (SITES + "A,rural,10,\nA,rural,10,\n", ("A",)),
    "a stratum of two sizes": (SITES + "A,rural,10,\nB,rural,12,\n", ("rural",)),
    "half a site": (SITES + "A,rural,10.5,\n", ("sites_there", "10.5")),
    "no site there": (SITES + "A,rural,0,\n", ("sites_there", "0")),
    "traffic of some": (SITES + "A,rural,10,400\nB,rural,10,\n", ("traffic",)),
    "no traffic": (SITES + "A,rural,10,0\nB,rural,10,100\n", ("traffic",)),
    "traffic below nothing": (SITES + "A,rural,10,-5\nB,rural,10,100\n", ("traffic", "-5")),
    "a site without a name": (SITES + ",rural,10,\n", ("2", "site")),
    "a site without a stratum": (SITES + "A,,10,\n", ("2", "stratum")),
    "no strata": ("site,sites_there\nA,10\n", ("stratum",)),
    "thousands": (SITES + '"A",rural,"1,000",\n', ("line 2", "sites_there")),
    "no sites": (SITES, 0),
    "nobody knows how many": ("site,stratum\nA,rural\nB,urban\n", 2),
}  # fmt: skip


@pytest.mark.parametrize("name", OF_SITES)
def test_sites(name: str) -> None:
    content, right = OF_SITES[name]
    if isinstance(right, tuple):
        return refused(("sites.csv", *right), read_sites, Path("sites.csv"), content)
    assert len(read_sites(Path("sites.csv"), content)) == right


STAFF = "pass,distance_m,position_1_m,position_2_m,u_position_m\n"

# name: content, and the rows that are refused with words of their reasons, or the words of the refusal
RIG: dict[str, tuple[str, dict[int, str] | tuple[str, ...]]] = {
    "millimetres": (STAFF + "a,5,0,1200,2\n", {2: "1200 m"}),
    "a distance below nothing": (STAFF + "a,-5,0,1.2,0.002\n", {2: "distance_m"}),
    "no distance": (STAFF + "a,,0,1.2,0.002\nb,5,0,1.2,0.002\n", {2: "distance_m"}),
    "an uncertainty of nothing": (STAFF + "a,5,0,1.2,0\n", {2: "u_position_m"}),
    "a pass twice": (STAFF + "a,5,0,1.2,0.002\na,8,0,1.2,0.002\n", {3: "same name"}),
    "a decimal comma": (STAFF.replace(",", ";") + "a;5;0;1,2;0.002\n", {2: "1,2"}),
    "a number that is none": (STAFF + "a,5,0,inf,0.002\n", {2: "position_2_m"}),
    "half a method": (STAFF + "a,5,0,,0.002\n", {2: "position_2_m"}),
    "no distances at all": ("pass,position_1_m,position_2_m,u_position_m\na,0,1.2,0.002\n", ("rig.csv",)),
    "no method": ("pass,distance_m\na,5\n", ("rig.csv",)),
    "nothing": ("", ("rig.csv",)),
}  # fmt: skip


@pytest.mark.parametrize("name", RIG)
def test_rig_passes(name: str) -> None:
    content, right = RIG[name]
    if isinstance(right, tuple):
        return refused(right, read_rig_passes, content.encode(), "rig.csv", Common())
    refused_rows = {
        one.row: str(one.reason) for one in read_rig_passes(content.encode(), "rig.csv", Common()).refused
    }
    assert refused_rows.keys() == right.keys(), refused_rows
    assert all(word in refused_rows[row] for row, word in right.items()), refused_rows


OBSERVED = "pass,frame,point,x_px,y_px,wheelbase_m,u_wheelbase_m\n"
POINT = "front_tyre"

# name: content, and the passes left out with words of why, or the words of the refusal
PASSES: dict[str, tuple[str, dict[str, str] | tuple[str, ...]]] = {
    "a wheelbase in millimetres": (OBSERVED + f"a,1,{POINT},10,20,2700,5\n", {"a": "wheelbase_m"}),
    "a wheelbase without its uncertainty": (OBSERVED + f"a,1,{POINT},10,20,2.7,\n", {"a": "u_wheelbase_m"}),
    "a wheelbase below nothing": (OBSERVED + f"a,1,{POINT},10,20,-2.7,0.01\n", {"a": "a size is above 0"}),
    "an uncertainty below nothing": (
        OBSERVED + f"a,1,{POINT},10,20,2.7,-0.01\n", {"a": "an uncertainty is not below 0"}),
    "half a frame": (OBSERVED + f"a,1.5,{POINT},10,20,2.7,0.01\n", {"a": "frame"}),
    "a point of no name": (OBSERVED + "a,1,bonnet,10,20,2.7,0.01\n", {"a": "rear_tyre"}),
    "a pixel that is none": (OBSERVED + f"a,1,{POINT},nan,20,2.7,0.01\n", {"a": "x_px"}),
    "no name": (OBSERVED + f",1,{POINT},10,20,2.7,0.01\n", ("2",)),
    "a row too long": (OBSERVED + f"a,1,{POINT},10,20,2,7,0.01\n", ("line 2",)),
    "an open quote": (OBSERVED + f'"a,1,{POINT},10,20,2.7,0.01\n', ("line 2",)),
    "no pixels": ("pass,frame,point\na,1,front\n", ("x_px",)),
    "another language's names": ("passage,image,point,x,y\na,1,front,1,2\n", ("pass",)),
}  # fmt: skip


@pytest.mark.parametrize("name", PASSES)
def test_observed_passes(name: str, tmp_path: Path) -> None:
    content, right = PASSES[name]
    path = tmp_path / "passes.csv"
    path.write_text(content)
    if isinstance(right, tuple):
        return refused(("passes.csv", *right), read_passes, path)
    good, left_out = read_passes(path)
    assert not good and {one.name for one in left_out} == set(right)
    assert all(right[one.name] in str(one.reason) for one in left_out), left_out


TRACK = "frame,time_s,point,x_px,y_px\n"
TRACKS: dict[str, tuple[str, tuple[str, ...]]] = {
    "no time": (TRACK + "1,,target,10,20\n", ("line 2", "time_s")),
    "a time of day": (TRACK + "1,12:00:01,target,10,20\n", ("line 2", "time_s")),
    "a point of no name": (TRACK + "1,0.04,nose,10,20\n", ("nose",)),
    "half a frame": (TRACK + "1.5,0.04,target,10,20\n", ("frame",)),
    "a frame without end": (TRACK + "inf,0.04,target,10,20\n", ("line 2", "frame")),
    "a pixel that is none": (TRACK + "1,0.04,target,,20\n", ("line 2", "x_px")),
    "decimal commas": (TRACK + "1,0,04,target,10,20\n", ("line 2", "6 cells")),
    "no points": ("frame,time_s\n1,0.04\n", ("point",)),
    "a header twice": (TRACK + TRACK, ("2",)),
    "nothing": ("", ("is empty",)),
}  # fmt: skip


@pytest.mark.parametrize("name", TRACKS)
def test_tracks(name: str, tmp_path: Path) -> None:
    content, words = TRACKS[name]
    path = tmp_path / "tracks.csv"
    path.write_text(content)
    refused(("tracks.csv", *words), read_tracks, path)


POINTS = "id,contact_x_px,contact_y_px,target_x_px,target_y_px"

# name: the further columns, and what they hold in the row; the words of the row's refusal
CLICKED: dict[str, tuple[str, str, tuple[str, ...]]] = {
    "a known height below nothing": ("reference_height_m", "-1.4", ("reference_height_m", "-1.4", "above 0")),
    "a known height of nothing": ("reference_height_m", "0", ("reference_height_m", "above 0")),
    "a known height too small for a number": (
        "reference_height_m", "1e-999", ("reference_height_m", "above 0")),
    "millimetres below nothing": ("reference_height_m", "-1400", ("reference_height_m", "above 0")),
    "a known height in millimetres": ("reference_height_m", "1400", ("reference_height_m", "in mm", "1.4 m")),
    "a known height with its unit": ("reference_height_m", "1.4 m", ("reference_height_m", "not a number")),
    "a known height in a spreadsheet's error": ("reference_height_m", "#N/A", ("reference_height_m",)),
    "an inset with a decimal comma": ("inset_m", '"0,45"', ("inset_m", "decimals with a point")),
    "an inset in millimetres": ("inset_m,u_inset_m", "450,100", ("inset_m", "in mm", "0.45 m")),
    "an inset's uncertainty in millimetres": (
        "inset_m,u_inset_m", "0.45,100", ("u_inset_m", "in mm", "0.1 m")),
    "an inset's uncertainty below nothing": ("inset_m,u_inset_m", "0.45,-0.1", ("u_inset_m", "-0.1")),
    "an inset's uncertainty without end": ("inset_m,u_inset_m", "0.45,inf", ("u_inset_m",)),
    "an inset that is a word": ("inset_m,u_inset_m", "usual,0.1", ("inset_m", "usual", "not a number")),
    "clicks of an uncertainty below nothing": ("sigma_px", "-1", ("sigma_px", "-1")),
    "a target in capitals": ("target", "ROOF", ("ROOF", "roof")),
    "a side of another language": ("target,side", "driver_eye,links", ("links", "near")),
    "an eye without a side": ("target,side", "driver_eye,", ("side",)),
    "a further frame clicked by half": (
        "contact2_x_px,contact2_y_px,target2_x_px,target2_y_px", "300,400,310,", ("target2_y_px", "empty")),
    "a row too long": ("inset_m,u_inset_m", "0,45,0,1", ("line 2", "9 cells")),
}  # fmt: skip


@pytest.mark.parametrize("name", CLICKED)
def test_clicks(name: str, tmp_path: Path) -> None:
    """The row alone is refused; the same points without what is wrong have their height."""
    columns, cells, words = CLICKED[name]
    scene = Scene(Lens(), (-0.7, -3.0, 1.4), 18.0, 4.0)
    at = ",".join(f"{v:.4f}" for v in scene.look([(0.3, 0.2, 0.0), (0.1, 0.65, 1.16)]).ravel())
    blank = "," * columns.count(",")
    path = tmp_path / "clicks.csv"
    path.write_text(f"{POINTS},{columns}\n1,{at},{cells}\n2,{at},{blank}\n")
    text, counts = heights_csv(pose_of(scene), path)
    bad, good = csv.DictReader(io.StringIO(text))
    assert bad["status"] == "not_measurable" and all(word in bad["reason"] for word in words), bad["reason"]
    assert bad["height_m"] == "" and (good["status"], counts.measured) == ("ok", 1)
