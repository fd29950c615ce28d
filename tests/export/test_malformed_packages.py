"""Packages that mail, spreadsheets, unzip programs and half copies spoil, made up before `verify` was read.

Each is refused in one sentence that names the file and is true, or read for what it is.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import shutil
import tarfile
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from sightline.cli import main
from sightline.infra.csv_package.files import FolderFiles, place_of
from tests.export.keep_released import KEPT
from tests.support.proofs import every

RELEASED = max(KEPT.glob("*.tar.xz"))


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A package that nobody writes to."""
    folder = tmp_path_factory.mktemp("released") / "package"
    with tarfile.open(RELEASED) as archive:
        archive.extractall(folder, filter="data")
    return folder


@pytest.fixture
def place(tmp_path: Path, whole: Path) -> Path:
    """A whole package in a folder of its own."""
    return shutil.copytree(whole, tmp_path / "package")


def _table(place: Path, name: str) -> Path:
    """A table of a package of any format."""
    return place / place_of(FolderFiles(place), name)


def _sum_again(place: Path) -> None:
    """What a hand does that wants it to fit: the list of hashes is made anew."""
    lines = []
    for line in (place / "SHA256SUMS").read_text().splitlines():
        name = line.split("  ", 1)[1]
        if (place / name).is_file():
            lines.append(f"{hashlib.sha256((place / name).read_bytes()).hexdigest()}  {name}")
    (place / "SHA256SUMS").write_text("\n".join(lines) + "\n")


def _written(place: Path, name: str, change: Callable[[bytes], bytes], sums: bool = True) -> None:
    path = _table(place, name)
    path.write_bytes(change(path.read_bytes()))
    if sums:
        _sum_again(place)


def _cells(place: Path, name: str, change: Callable[[list[list[str]]], object]) -> None:
    """A table changed by its rows, written as it was."""
    path = _table(place, name)
    table = list(csv.reader(io.StringIO(path.read_text(), newline="")))
    change(table)
    out = io.StringIO(newline="")
    csv.writer(out, lineterminator=(path.read_text()[:4000].count("\r\n") and "\r\n") or "\n").writerows(
        table
    )
    path.write_bytes(out.getvalue().encode())
    _sum_again(place)


def _replaced(path: Path, put: Callable[[Path], None]) -> None:
    path.unlink()
    put(path)


def _capitals(path: Path) -> None:
    path.rename(path.with_name(path.name.upper()))


def _set(name: str, value: str) -> Callable[[list[list[str]]], None]:
    def change(table: list[list[str]]) -> None:
        table[1][table[0].index(name)] = value

    return change


def _swap_columns(table: list[list[str]]) -> None:
    for row in table:
        row[0], row[1] = row[1], row[0]


def _drop_column(table: list[list[str]]) -> None:
    for row in table:
        row.pop()


def _rename(table: list[list[str]]) -> None:
    table[0][table[0].index("height_m")] = "height"


FOLDERS: dict[str, tuple[Callable[[Path], object], tuple[str, ...]]] = {
    "a table is missing": (lambda at: _table(at, "revisions.csv").unlink(), ("revisions.csv", "missing")),
    "a table is missing and the list was made again": (
        lambda at: (_table(at, "revisions.csv").unlink(), _sum_again(at)), ("revisions.csv",)),
    "a table is empty": (lambda at: _written(at, "measurements.csv", lambda _: b""), ("measurements.csv",)),
    "a spreadsheet saved it with semicolons": (
        lambda at: _written(at, "measurements.csv", lambda old: old.replace(b",", b";")),
        ("measurements.csv",)),
    "a spreadsheet saved it without a word": (
        lambda at: _written(at, "measurements.csv", lambda old: b"\xef\xbb\xbf" + old, sums=False),
        ("measurements.csv", "changed")),
    "a table in UTF-16": (
        lambda at: _written(at, "measurements.csv", lambda old: old.decode().encode("utf-16")),
        ("measurements.csv",)),
    "a table cut in the middle of a line": (
        lambda at: _written(at, "revisions.csv", lambda old: old[: len(old) * 2 // 3]), ("revisions.csv",)),
    "a table that ends in zeros": (
        lambda at: _written(at, "revisions.csv", lambda old: old + bytes(4096)), ("revisions.csv",)),
    "a height that is no number": (
        lambda at: _cells(at, "revisions.csv", _set("height_m", "NaN")), ("revisions.csv",)),
    "a height without end": (
        lambda at: _cells(at, "revisions.csv", _set("height_m", "inf")), ("revisions.csv",)),
    "a number with a comma": (
        lambda at: _cells(at, "revisions.csv", _set("height_m", "1,476")), ("revisions.csv",)),
    "a row twice": (
        lambda at: _cells(at, "revisions.csv", lambda rows: rows.append(rows[1])), ("revisions.csv",)),
    "a row less": (lambda at: _cells(at, "revisions.csv", lambda rows: rows.pop()), ("revisions.csv",)),
    "rows in another order": (
        lambda at: _cells(at, "revisions.csv", lambda rows: rows.insert(1, rows.pop())),
        ("revisions.csv",)),
    "a vehicle that is not there": (
        lambda at: _cells(at, "revisions.csv", _set("vehicle_id", "4000")), ("revisions.csv",)),
    "columns in another order": (
        lambda at: _cells(at, "measurements.csv", _swap_columns), ("measurements.csv",)),
    "a column less": (lambda at: _cells(at, "measurements.csv", _drop_column), ("measurements.csv",)),
    "a column of another name": (lambda at: _cells(at, "measurements.csv", _rename), ("measurements.csv",)),
    "a cell as long as a book": (
        lambda at: _cells(at, "vehicles.csv", _set("category", "x" * 3_000_000)), ("vehicles.csv",)),
    "no events": (lambda at: _written(at, "audit.csv", lambda old: old.splitlines(True)[0]), ("audit",)),
    "the description is no JSON": (
        lambda at: _written(at, "datapackage.json", lambda old: old[:-20]), ("datapackage.json",)),
    "the description is a list": (
        lambda at: _written(at, "datapackage.json", lambda _: b"[]"), ("datapackage.json",)),
    "the description is nested without end": (
        lambda at: _written(at, "datapackage.json", lambda _: b"[" * 200_000), ("datapackage.json",)),
    "the end of the chain is of another form": (
        lambda at: _written(at, "checkpoint.json", lambda _: b'{"head": 5}'), ("checkpoint.json",)),
    "the list of hashes is words": (
        lambda at: (at / "SHA256SUMS").write_text("everything is fine\n"), ("SHA256SUMS",)),
    "the list of hashes is empty": (lambda at: (at / "SHA256SUMS").write_text(""), ("SHA256SUMS",)),
    "the list of hashes names a file outside": (
        lambda at: (at / "SHA256SUMS").write_text(f"{'0' * 64}  ../../etc/passwd\n"), ("SHA256SUMS",)),
    "the list of hashes names a file twice": (
        lambda at: (at / "SHA256SUMS").write_text((at / "SHA256SUMS").read_text() * 2), ("SHA256SUMS",)),
    "a folder in a file's place": (
        lambda at: _replaced(_table(at, "poses.csv"), Path.mkdir), ("poses.csv",)),
    "a link that leads out": (
        lambda at: _replaced(_table(at, "poses.csv"), lambda path: path.symlink_to("/etc/passwd")),
        ("poses.csv",)),
    "names in capitals": (
        lambda at: _capitals(_table(at, "poses.csv")), ("poses.csv",)),
    "a picture of another": (
        lambda at: shutil.copyfile(*sorted((at / "crops").glob("*.jpg"))[:2]), ("crops/", "changed")),
}  # fmt: skip


def _refused(place: Path, words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    status = main(["verify", str(place)])
    said = capsys.readouterr().err
    assert status in (1, 2) and said.count("\n") == 1 and "Traceback" not in said, (status, said)
    assert all(word in said for word in words), said
    assert len(said) < 600, said


#: Each is refused at a place in the code where none of the others is.
REFUSED_APART = (
    "a table in UTF-16",
    "the description is no JSON",
    "the list of hashes is empty",
    "a link that leads out",
)


@pytest.mark.parametrize("kind", every(3, FOLDERS, REFUSED_APART))
def test_a_folder(kind: str, place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spoil, words = FOLDERS[kind]
    spoil(place)
    _refused(place, words, capsys)


def _zipped(place: Path, name: str = "package.zip") -> bytes:
    whole = place.parent / name
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED, strict_timestamps=False) as archive:
        for path in sorted(place.rglob("*")):
            archive.write(path, path.relative_to(place))
    return whole.read_bytes()


def _encrypted(place: Path) -> bytes:
    """Every entry says that it is."""
    whole = bytearray(_zipped(place))
    for signature, flags in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        at = whole.find(signature)
        while at >= 0:
            whole[at + flags] |= 1
            at = whole.find(signature, at + 4)
    return bytes(whole)


def _twice(place: Path) -> bytes:
    """A ZIP in a ZIP, as mail gateways make them."""
    inner = _zipped(place)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr("package.zip", inner)
    return out.getvalue()


ZIPS: dict[str, tuple[Callable[[Path], bytes], tuple[str, ...] | None]] = {
    "whole": (_zipped, None),
    "cut in half": (lambda at: (whole := _zipped(at))[: len(whole) // 2], ("package.zip", "ZIP")),
    "begun in the middle": (lambda at: (whole := _zipped(at))[len(whole) // 2 :], ("package.zip",)),
    "another archive with that name": (lambda _: b"Rar!\x1a\x07\x01\x00" + bytes(400), ("ZIP",)),
    "a page of a proxy with that name": (lambda _: b"<!DOCTYPE html><html>Sign in</html>", ("ZIP",)),
    "nothing": (lambda _: b"", ("ZIP",)),
    "without entries": (lambda _: b"PK\x05\x06" + bytes(18), ("SHA256SUMS",)),
    "with a password": (_encrypted, ("password",)),
    "a ZIP in it": (_twice, ("package.zip",)),
}


@pytest.mark.parametrize("kind", ZIPS)
def test_a_zip(kind: str, place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    make, words = ZIPS[kind]
    whole = place.parent / "package.zip"
    whole.write_bytes(make(place))
    if words is not None:
        return _refused(whole, words, capsys)
    key = json.loads((place / "checkpoint.json").read_text())["key"]
    assert main(["verify", str(whole), "--key", key, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["status"] == "holds"


@pytest.mark.parametrize(
    ("table", "name", "cell"),
    [
        ("line_scans.csv", "line_rate_hz", ""),
        ("line_scans.csv", "line_rate_hz", "0"),
        ("line_scans.csv", "lanes", "{"),
        ("line_scans.csv", "lanes", "5"),
        ("line_scans.csv", "lanes", '["near"]'),
        ("line_scans.csv", "lanes", '[{"name": "near"}]'),
        ("line_scans.csv", "lanes", '[{"name": "near", "distance_m": "5"}]'),
        ("scan_measurements.csv", "line_rate_hz", ""),
        ("scan_measurements.csv", "baseline_m", "half a metre"),
        ("scan_measurements.csv", "u_baseline_m", "inf"),
    ],
)
def test_the_traffic_of_a_rig_that_is_none(
    table: str, name: str, cell: str, place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The cells of a package are sealed; `flow` reads it without its seal, and told a bare error."""
    _cells(place, table, _set(name, cell))
    assert main(["flow", str(place)]) == 1
    assert capsys.readouterr().err == (
        f"{table}, row 1: the rig cannot be as it stands there (baseline, line rate, lanes or another of its "
        "values); get the complete package again.\n"
    )
