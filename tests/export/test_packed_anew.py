"""Packages as mail, unpack programs and file managers leave them: in a folder, in a ZIP, with strays."""

import shutil
import zipfile
from pathlib import Path

import pytest

from sightline.cli import main
from tests.support.packages import ground, package, worked

assert ground and package and worked  # the fixtures


def packed(place: Path, target: Path, folder: str = "", **more: str) -> Path:
    """A ZIP of the package as any program makes it."""
    with zipfile.ZipFile(target, "w") as archive:
        for path in sorted(place.rglob("*")):
            if path.is_file():
                archive.write(path, folder + path.relative_to(place).as_posix())
        for name, text in more.items():
            archive.writestr(name, text)
    return target


def test_a_zip_with_the_package_in_one_folder_is_read(
    package: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = packed(package, tmp_path / "mailed.zip", "A27 in June/")
    assert main(["verify", str(place)]) == 0
    assert "lies in the folder A27 in June: " in capsys.readouterr().out
    strayed = packed(package, tmp_path / "mac.zip", "A27/", **{"__MACOSX/A27/._events.csv": "x"})
    assert main(["verify", str(strayed)]) == 1
    assert "__MACOSX/A27/._events.csv" in capsys.readouterr().err


def test_a_package_one_level_down_is_named(
    package: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(package, tmp_path / "unpacked" / "A27")
    assert main(["verify", str(tmp_path / "unpacked")]) == 2
    assert f"in {tmp_path / 'unpacked' / 'A27'}; give that." in capsys.readouterr().err
    (tmp_path / "mail").mkdir()
    inner = packed(package, tmp_path / "mail" / "A27.zip")
    assert main(["verify", str(tmp_path / "mail")]) == 2
    assert f"in {inner}; give that." in capsys.readouterr().err


def test_strays_are_named_all_at_once_and_apart_from_what_was_changed(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    strays = (".DS_Store", "._README.txt", "Thumbs.db", "crops/desktop.ini", "__MACOSX/x.csv")
    for name in strays:
        (package / name).parent.mkdir(exist_ok=True)
        (package / name).write_text("x")
    assert main(["verify", str(package)]) == 1
    said = capsys.readouterr().err
    assert "put 5 files beside" in said and "changed" not in said
    assert all(name in said for name in strays)
    (package / "mine.txt").write_text("x")
    for name in strays:
        (package / name).unlink()
    assert main(["verify", str(package)]) == 1
    assert "mine.txt is not listed in SHA256SUMS" in capsys.readouterr().err
