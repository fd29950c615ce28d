"""Pages of a SQLite file that hold noise: every command and the server say so, and name the tables. And a
file on a medium that cannot be written, which is read where it lies.
"""

import os
import random
import re
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import click
import pytest

from sightline.cli import cli, main
from sightline.infra.audit.signing import signing_key
from sightline.infra.backup.manifest import STATES, read_manifest
from sightline.infra.database.engine import migrate
from sightline.infra.services import open_services
from sightline.infra.web.health import database_trouble
from sightline.settings import Settings
from sightline.surveys.store import create_survey
from tests.support import samples

TABLES = {"one table": ["road_poses"], "three tables": ["measurements", "road_poses", "surveys"]}


@pytest.fixture(autouse=True, scope="module")
def own_settings() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        for name in ("DATABASE_URL", "MEDIA_URL", "SIGNING_KEY", "SECRET"):
            patch.delenv(f"SIGHTLINE_{name}", raising=False)
        yield


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory, own_settings: None) -> Path:
    """A data folder with a measurement and a medium, on SQLite, that nobody opens."""
    folder = tmp_path_factory.mktemp("whole") / "data"
    with_services(folder)
    return folder


@pytest.fixture
def data_dir(tmp_path: Path, whole: Path) -> Path:
    """A copy of that data folder."""
    return shutil.copytree(whole, tmp_path / "data")


def with_services(folder: Path) -> None:
    services = open_services(Settings(data_dir=folder), decode_in_child=False)
    migrate(services.engine)
    with services.writing() as session:
        samples.measure(session, samples.sample(session))
        create_survey(session, name="Empty", description="", actor=None)
    samples.put_bytes(services, b"a picture", ".jpg")
    signing_key(services.settings)
    services.close()
    settle(folder / "sightline.db")


def settle(path: Path) -> None:
    """All in the one file, whose pages can then be overwritten."""
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchall()


def spoil(path: Path, *tables: str) -> None:
    """Noise over the first page of each table's tree."""
    with closing(sqlite3.connect(path)) as connection:
        size = connection.execute("PRAGMA page_size").fetchone()[0]
        query = "SELECT rootpage FROM sqlite_master WHERE name = ?"
        pages = [connection.execute(query, (table,)).fetchone()[0] for table in tables]
    noise = random.Random(5)
    with path.open("r+b") as file:
        for page in pages:
            file.seek((page - 1) * size)
            file.write(b"\xff" + noise.randbytes(size - 1))


def test_every_command_says_what_is_damaged(
    data_dir: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spoil(data_dir / "sightline.db", "measurements", "surveys")
    assert main(["verify", str(data_dir)]) == 1
    said = capsys.readouterr().err
    assert "damaged in measurements, surveys; its " in said and said.count("\n") == 1
    asked = ["--survey", "1", "-o", str(tmp_path / "out"), "--data-dir", str(data_dir)]
    assert main(["export", *asked]) == 1
    assert "The database is damaged" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


MODELS = "make,model,height_m\nAldo,One,1.48\n"
LIVE = "--rows 8 --baseline 1 --line-rate 1000 --survey Empty"
#: Every command that opens the installation's database, and what it is given beside the data folder.
OPENING = {
    "serve": "--port 0 --workers 0",
    "demo": "--port 0",
    "worker": "",
    "migrate": "",
    "sign-in-link": "olga@example.org",
    "catalogue export": "-o {place}/models.csv",
    "catalogue import": "{place}/given.csv",
    "stream": LIVE,
    "export": "--survey Empty -o {place}/out",
    "evidence": "--survey Empty --scan 1 --vehicle 1 -o {place}/evidence.html",
    "checkpoint": "-o {place}/checkpoint.json",
    "backup": "{place}/backup",
}
#: It makes a database where there is none.
MAKING = {"restore"}


def opening(group: click.Group, *names: str) -> Iterator[str]:
    """The commands, by their whole names, that take a data folder."""
    context = click.Context(group)
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        if isinstance(command, click.Group):
            yield from opening(command, *names, name)
        elif command is not None and any("--data-dir" in one.opts for one in command.params):
            yield " ".join((*names, name))


def test_every_command_that_opens_a_database_is_tried() -> None:
    assert set(opening(cli)) == OPENING.keys() | MAKING


@pytest.mark.parametrize("command", OPENING)
def test_every_command_says_that_the_database_is_damaged(
    data_dir: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], command: str
) -> None:
    given = tmp_path / "given.csv"
    given.write_text(MODELS)
    assert main(["catalogue", "import", str(given), "--data-dir", str(data_dir)]) == 0
    settle(data_dir / "sightline.db")
    spoil(data_dir / "sightline.db", "surveys", "people", "catalogue", "audit_events")
    capsys.readouterr()
    before = sorted(tmp_path.iterdir())
    words = [one.format(place=tmp_path) for one in OPENING[command].split()]
    assert main([*command.split(), *words, "--data-dir", str(data_dir)]) == 1
    said = capsys.readouterr().err
    assert "The database is damaged" in said and "sightline restore" in said
    assert "Traceback" not in said and "DatabaseError" not in said
    assert [one for one in sorted(tmp_path.iterdir()) if one.name != "backup"] == before


@pytest.mark.parametrize("command", ["verify", "export"])
def test_a_file_whose_beginning_is_noise(
    data_dir: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], command: str
) -> None:
    with (data_dir / "sightline.db").open("r+b") as file:
        file.write(random.Random(1).randbytes(8192))
    rest = {
        "verify": [str(data_dir)],
        "export": ["--survey", "1", "-o", str(tmp_path / "out"), "--data-dir", str(data_dir)],
    }[command]
    assert main([command, *rest]) == 2
    said = capsys.readouterr().err
    assert "its beginning is damaged" in said and "DatabaseError" not in said


@pytest.mark.parametrize("harm", ["one table", "three tables", "beginning"])
def test_a_backup_of_a_damaged_database_leaves_the_last_good_one(
    data_dir: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], harm: str
) -> None:
    folder, asked = tmp_path / "backup", ["backup", str(tmp_path / "backup"), "--data-dir", str(data_dir)]
    main(asked)
    good = read_manifest(folder)
    if harm == "beginning":
        with (data_dir / "sightline.db").open("r+b") as file:
            file.write(random.Random(1).randbytes(8192))
    else:
        spoil(data_dir / "sightline.db", *TABLES[harm])
    capsys.readouterr()
    assert main(asked) == 1
    said = capsys.readouterr().err.splitlines()[-1]
    assert "No new backup was made; the last good one, of 20" in said and str(folder) in said
    if harm != "beginning":
        assert f"damaged in {', '.join(TABLES[harm])}; its " in said
    assert [path.name for path in (folder / STATES).iterdir()] == [good.state]
    assert main(["verify", str(folder)]) == 0
    assert main(["restore", str(folder), "--data-dir", str(tmp_path / "restored")]) == 0


def test_a_damaged_database_without_an_earlier_backup(
    data_dir: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spoil(data_dir / "sightline.db", "measurements")
    assert main(["backup", str(tmp_path / "backup"), "--data-dir", str(data_dir)]) == 1
    said = capsys.readouterr().err
    assert "damaged in measurements" in said and "has no earlier one" in said
    assert list((tmp_path / "backup" / STATES).iterdir()) == []
    assert main(["restore", str(tmp_path / "backup"), "--data-dir", str(tmp_path / "x")]) == 2


def test_a_server_does_not_start_on_a_damaged_database(
    data_dir: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spoil(data_dir / "sightline.db", "measurements")
    assert main(["serve", "--port", "0", "--workers", "0", "--data-dir", str(data_dir)]) == 1
    assert "damaged in measurements; its " in capsys.readouterr().err


def test_a_server_on_a_damaged_database_is_not_ready(data_dir: Path) -> None:
    spoil(data_dir / "sightline.db", "measurements")
    services = open_services(Settings(data_dir=data_dir), decode_in_child=False)
    said = database_trouble(services)
    services.close()
    assert said is not None and "damaged in measurements; its " in said


READ_ONLY = """
set -e
mount --bind "$1" "$1"
mount -o remount,ro,bind "$1"
if touch "$1/x" 2>/dev/null; then exit 99; fi
exec "$3" -c "$4" "$1" "$2"
"""
ASKED = """
import sys
from sightline.cli import main
data, folder = sys.argv[1:]
statuses = [
    main(["verify", data]),
    main(["export", "--survey", "Empty", "-o", folder + "/out", "--data-dir", data]),
    main(["backup", folder + "/backup", "--data-dir", data]),
    main(["verify", folder + "/backup"]),
]
print("statuses:", *statuses)
"""


def test_a_database_that_cannot_be_written_is_read_where_it_lies(data_dir: Path, tmp_path: Path) -> None:
    if subprocess.run(["unshare", "-m", "true"], check=False, capture_output=True).returncode:
        pytest.skip("a read-only mount needs the right to make one")
    before = sorted(data_dir.rglob("*"))
    told = ["unshare", "-m", "sh", "-c", READ_ONLY, "sh", str(data_dir), str(tmp_path), sys.executable, ASKED]
    done = subprocess.run(told, check=False, capture_output=True, text=True, env=dict(os.environ))
    assert done.returncode == 0, done.stderr
    # the sample names a video that is not there: its backup says so
    assert re.search(r"^statuses: 0 [12] [01] 0$", done.stdout, re.MULTILINE), done.stdout
    assert done.stdout.count("is intact") == 2
    assert "Every package is recorded in the audit trail" in done.stderr
    assert not (tmp_path / "out").exists()
    assert sorted(data_dir.rglob("*")) == before
