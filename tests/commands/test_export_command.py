"""`sightline export` and `sightline verify` on a stored survey."""

import json
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest

from sightline.cli import main
from sightline.infra.audit import signing
from sightline.infra.database.engine import make_engine, migrate, session_factory, writing
from sightline.settings import Settings
from sightline.surveys.store import create_survey
from tests.conftest import SERVER
from tests.support.proofs import every


@pytest.fixture
def stored(tmp_path: Path, database_url: str, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A data folder with two surveys; on PostgreSQL the database is named by the environment."""
    monkeypatch.setenv("SIGHTLINE_DATA_DIR", str(tmp_path))
    monkeypatch.setenv("SIGHTLINE_DATABASE_URL", database_url)
    assert Settings().database_url == database_url
    engine = make_engine(database_url)
    with writing(session_factory(engine)) as session:
        create_survey(session, name="Rouen south", site="=lane 1", actor=None)
        create_survey(session, name="Other", actor=None)
    engine.dispose()
    yield tmp_path


def test_a_survey_by_name_or_number_is_written_and_verified(
    stored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, place in (("Rouen south", "by-name"), ("1", "by-number")):
        assert main(["export", "--survey", name, "-o", str(stored / place)]) == 0, capsys.readouterr()
        assert main(["verify", str(stored / place)]) == 0
    for name in ("datapackage.json", "tables/measurements.csv"):
        assert (stored / "by-name" / name).exists()
    one, two = (
        set((stored / place / "SHA256SUMS").read_text().splitlines()) for place in ("by-name", "by-number")
    )
    # each has a seal of its own, its signature, and both again for the page
    own = {"audit.csv", "checkpoint.json", "audit.js"}
    assert {line.partition("  ")[2] for line in one - two} == own
    assert "Other" not in (stored / "by-name" / "audit.csv").read_text()


def test_an_unknown_survey_or_a_taken_place_is_refused(
    stored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["export", "--survey", "Nowhere", "-o", str(stored / "out")]) == 2
    assert "Nowhere" in capsys.readouterr().err
    assert not (stored / "out").exists()
    (stored / "taken").write_text("a file")
    assert main(["export", "--survey", "Other", "-o", str(stored / "taken")]) == 2
    assert (stored / "taken").read_text() == "a file"


def test_a_name_that_several_surveys_have_is_refused_and_their_numbers_are_said(
    stored: Path, database_url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    engine = make_engine(database_url)
    with writing(session_factory(engine)) as session:
        create_survey(session, name="Other", actor=None)
    engine.dispose()
    assert main(["export", "--survey", "Other", "-o", str(stored / "out")]) == 2
    assert "give the number of one: 3, 2." in capsys.readouterr().err and not (stored / "out").exists()
    assert main(["export", "--survey", "2", "-o", str(stored / "out")]) == 0, capsys.readouterr()


def test_an_earlier_export_gives_way_and_nothing_else_does(
    stored: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, videos = stored / "out", stored / "videos"
    again = ["export", "--survey", "Other", "-o"]
    assert main([*again, str(out)]) == 0
    (out / ".DS_Store").write_text("a system's")
    assert main([*again, str(out)]) == 0
    assert not (out / ".DS_Store").exists()
    videos.mkdir()
    (videos / "road.mp4").write_text("a video")
    (videos / "SHA256SUMS").write_text(f"{'0' * 64}  road.mp4\n")
    (out / "notes.txt").write_text("mine")
    kept = {videos: {"road.mp4", "SHA256SUMS"}, out: {one.name for one in out.iterdir()}}
    for place, names in kept.items():
        capsys.readouterr()
        assert main([*again, str(place)]) == 2
        assert "contains other files" in capsys.readouterr().err
        assert {one.name for one in place.iterdir()} == names
    (videos / "datapackage.json").write_text("{}")
    (videos / "SHA256SUMS").write_text("no list\n")
    assert main([*again, str(videos)]) == 2


def test_a_change_of_the_key_killed_behind_its_commit_is_taken_up(
    stored: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    assert main(["checkpoint", "-o", str(stored / "first.json")]) == 0
    with monkeypatch.context() as patched:
        patched.setattr(signing, "put_in_force", killed)
        assert main(["checkpoint", "--new-key"]) == 1
    assert main(["export", "--survey", "1", "-o", str(stored / "out")]) != 0
    assert "run `sightline checkpoint`" in capsys.readouterr().err
    assert main(["checkpoint", "-o", str(stored / "second.json")]) == 0
    first, second = (json.loads((stored / f"{one}.json").read_text()) for one in ("first", "second"))
    assert [one["key"] for one in second["keys"]] == [first["key"], second["key"]] != [first["key"]] * 2
    assert main(["export", "--survey", "1", "-o", str(stored / "out")]) == 0


def test_a_row_changed_behind_our_back_is_found(
    stored: Path, database_url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    if SERVER:
        assert main(["verify", database_url]) == 0
        return
    path = stored / "sightline.db"
    assert main(["verify", str(path)]) == 0
    connection = sqlite3.connect(path)
    for (trigger,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
        connection.execute(f'DROP TRIGGER "{trigger}"')
    connection.execute("UPDATE audit_events SET after = replace(after, 'Rouen', 'Caen') WHERE id = 1")
    connection.commit()
    connection.close()
    capsys.readouterr()
    assert main(["verify", str(path)]) == 1
    said = capsys.readouterr().err
    assert "sightline.db" in said and said.count("\n") == 1


@pytest.mark.parametrize("name", every(2, ["what?mode=ro", "a%20b", "é%3F b#c"]))
def test_a_data_folder_of_any_name_holds_its_own_database(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    folder = tmp_path / name
    folder.mkdir()
    monkeypatch.delenv("SIGHTLINE_DATABASE_URL", raising=False)
    engine = make_engine(Settings(data_dir=folder).database_url)
    migrate(engine)
    with writing(session_factory(engine)) as session:
        create_survey(session, name="Road", actor=None)
    engine.dispose()
    assert (folder / "sightline.db").is_file()
    assert [path.name for path in tmp_path.iterdir()] == [name]
    for place in (folder, folder / "sightline.db"):
        assert main(["verify", str(place)]) == 0, capsys.readouterr()
    exported = ["export", "--data-dir", str(folder), "--survey", "Road", "-o", str(tmp_path / "out")]
    assert main(exported) == 0, capsys.readouterr()
