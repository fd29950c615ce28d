"""The data folder is closed to other accounts of the machine, also one that an older version left open."""

import os
import stat
from collections.abc import Iterator
from pathlib import Path

import pytest
from sqlalchemy import text

from sightline.infra.database.engine import make_engine, migrate
from sightline.infra.private import keep_private
from sightline.infra.services import open_services
from sightline.settings import Settings


@pytest.fixture(autouse=True)
def usual_umask() -> Iterator[None]:
    before = os.umask(0o022)
    yield
    os.umask(before)


def modes(folder: Path) -> dict[str, int]:
    """Of the folder and of all that is in it, by its path from there."""
    return {
        str(path.relative_to(folder)): stat.S_IMODE(path.lstat().st_mode)
        for path in (folder, *folder.rglob("*"))
    }


def test_a_data_folder_left_open_is_closed_at_the_start(tmp_path: Path) -> None:
    data_dir = tmp_path / "data"
    (data_dir / "media" / "ab").mkdir(parents=True)
    (data_dir / "media" / "ab" / "video.mp4").write_bytes(b"video")
    (data_dir / "sightline.db").write_bytes(b"")
    data_dir.chmod(0o755)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.write_text("not ours to close")
    (data_dir / "link").symlink_to(elsewhere)
    keep_private(Settings(data_dir=data_dir))
    found = modes(data_dir)
    assert found.pop("link") == 0o777
    assert found == {
        ".": 0o700,
        "media": 0o700,
        "media/ab": 0o700,
        "media/ab/video.mp4": 0o600,
        "sightline.db": 0o600,
    }
    assert stat.S_IMODE(elsewhere.stat().st_mode) == 0o644


def test_what_is_made_after_the_start_is_private(tmp_path: Path) -> None:
    settings = Settings(data_dir=tmp_path / "data", media_url=str(tmp_path / "media"))
    keep_private(settings)
    services = open_services(settings, decode_in_child=False)
    migrate(services.engine)
    source = tmp_path / "video"
    source.write_bytes(b"video")
    services.media.put_file("ab/cd/abcd.mp4", source)
    with services.writing() as session:
        session.execute(text("DELETE FROM people"))
        found = modes(settings.data_dir) | modes(tmp_path / "media")
    services.close()
    assert {"sightline.db", "sightline.db-wal", "ab/cd/abcd.mp4"} <= set(found)
    assert {name: oct(mode) for name, mode in found.items() if mode & 0o077} == {}


def test_a_database_is_private_whoever_makes_it(tmp_path: Path) -> None:
    engine = make_engine(f"sqlite:///{tmp_path / 'place' / 'a.db'}")
    with engine.begin() as connection:
        connection.exec_driver_sql("CREATE TABLE a (b)")
        found = modes(tmp_path / "place")
    engine.dispose()
    assert found == {".": 0o700, "a.db": 0o600, "a.db-wal": 0o600, "a.db-shm": 0o600}
