"""Packages made to harm who verifies them: refused in one sentence, and nothing is followed."""

from __future__ import annotations

import hashlib
import os
import stat
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from sightline.cli import main
from sightline.infra.csv_package import files


def _zip(place: Path, *entries: tuple[zipfile.ZipInfo, bytes]) -> Path:
    with zipfile.ZipFile(place, "w", zipfile.ZIP_DEFLATED) as archive:
        for info, content in entries:
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, content)
    return place


def _entry(name: str, mode: int = 0) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(name)
    info.create_system, info.external_attr = 3, mode << 16
    return info


ZIPS: dict[str, tuple[Callable[[Path], Path], str]] = {
    "a bomb": (lambda at: _zip(at, (_entry("audit.csv"), bytes(40_000_000))), "would unpack to far more"),
    "a way out": (lambda at: _zip(at, (_entry("../../etc/passwd"), b"x")), "not a plain file"),
    "from the root": (lambda at: _zip(at, (_entry("/etc/passwd"), b"x")), "not a plain file"),
    "a name of two lines": (lambda at: _zip(at, (_entry("../a\nb"), b"x")), "not a plain file"),
    "a drive": (lambda at: _zip(at, (_entry("C:/audit.csv"), b"x")), "not a plain file"),
    "a link": (
        lambda at: _zip(at, (_entry("audit.csv", stat.S_IFLNK | 0o777), b"/etc/passwd")),
        "not a plain file",
    ),
    "a device": (lambda at: _zip(at, (_entry("audit.csv", stat.S_IFCHR | 0o666), b"")), "not a plain file"),
    "a file twice": (
        lambda at: _zip(at, (_entry("audit.csv"), b"1"), (_entry("audit.csv"), b"2")),
        "twice",
    ),
}


def _refused(place: Path, words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", str(place)]) in (1, 2)
    said = capsys.readouterr().err
    assert words in said and said.count("\n") == 1, said


@pytest.mark.filterwarnings("ignore:Duplicate name")
@pytest.mark.parametrize("kind", ZIPS)
def test_a_hostile_zip_is_refused_by_its_list(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    make, words = ZIPS[kind]
    place = make(tmp_path / "package.zip")
    monkeypatch.setattr(zipfile.ZipFile, "open", lambda *_: pytest.fail("something is unpacked"))
    _refused(place, words, capsys)


def test_a_file_that_does_not_unpack_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    content = b"id,height_m\n" * 500
    sums = f"{hashlib.sha256(content).hexdigest()}  heights.csv\n".encode()
    place = _zip(tmp_path / "package.zip", (_entry("heights.csv"), content), (_entry("SHA256SUMS"), sums))
    whole = bytearray(place.read_bytes())
    at = whole.index(b"heights.csv") + len("heights.csv")
    whole[at : at + 12] = b"\xff" * 12
    place.write_bytes(whole)
    _refused(place, "heights.csv", capsys)


def test_a_zip_that_lists_too_much_is_refused_before_the_list_is_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    place = _zip(tmp_path / "package.zip", *((_entry(f"{n}.csv"), b"") for n in range(1000)))
    monkeypatch.setattr(files, "MOST_LISTING_BYTES", 10_000)
    _refused(place, "more files than a package can have", capsys)


def test_a_folder_of_too_many_files_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for n in range(50):
        (tmp_path / f"{n}.csv").touch()
    monkeypatch.setattr(files, "MOST_FILES", 20)
    _refused(tmp_path, "more files than a package can have", capsys)


@pytest.mark.parametrize("kind", ["link", "folder", "pipe"])
def test_what_is_no_file_is_neither_followed_nor_waited_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], kind: str
) -> None:
    place = tmp_path / "package"
    place.mkdir()
    (place / "SHA256SUMS").write_text(f"{'0' * 64}  audit.csv\n")
    if kind == "link":
        (place / "audit.csv").symlink_to("/etc/passwd")
    elif kind == "folder":
        (place / "audit.csv").symlink_to(place, target_is_directory=True)
    else:
        os.mkfifo(place / "audit.csv")
    _refused(place, "is a link, not a file", capsys)
