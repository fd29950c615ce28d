"""Backup and restore: a round trip, under load, resumed, of what is damaged; on SQLite and on PostgreSQL."""

import itertools
import json
import os
import signal
import stat
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from uuid import uuid4

import pytest
from sqlalchemy import create_engine, func, make_url, select, text
from sqlalchemy.exc import DatabaseError
from sqlalchemy.orm import Session

from sightline.cli import main
from sightline.errors import BadInput, Conflict, Damaged, SightlineError
from sightline.infra.audit.checkpoints import hand_on, sign_checkpoint
from sightline.infra.audit.records import Verification
from sightline.infra.audit.signing import put_in_force, replacing_key, signing_key
from sightline.infra.audit.tables import audit_events
from sightline.infra.audit.verification import verify_database, verify_records
from sightline.infra.backup import make
from sightline.infra.backup.make import MadeBackup, make_backup
from sightline.infra.backup.manifest import (
    JOURNAL,
    LOCK,
    MANIFEST,
    STATES,
    media_file,
    read_manifest,
    write_manifest,
)
from sightline.infra.backup.restore import check_backup, restore_backup
from sightline.infra.database.engine import make_engine, migrate, reading, session_factory, writing
from sightline.infra.database.types import metadata
from sightline.infra.jobs import registry
from sightline.infra.jobs.store import claim_job, get_job
from sightline.infra.services import Services, open_services
from sightline.measurements.records import MeasurementValues
from sightline.measurements.store import add_measurement
from sightline.measurements.tables import measurement_series
from sightline.media.store.local import LocalStore
from sightline.media.store.s3 import StorageAway
from sightline.poses.tables import road_poses
from sightline.settings import Settings
from sightline.surveys.store import create_survey
from tests.conftest import SERVER
from tests.media.test_store import OpenS3, open_s3, s3_endpoint
from tests.support import samples
from tests.support.kept import PutBack, Shelf
from tests.support.waiting import until

pytestmark = pytest.mark.dialect

assert open_s3 and s3_endpoint  # the fixtures

NewPlace = Callable[[str], Settings]


def silent(_share: float, _words: str) -> None:
    """Progress that nobody looks at."""


@pytest.fixture
def new_place(tmp_path: Path) -> Iterator[NewPlace]:
    """Settings of an empty place to restore into, of the same kind of database."""
    schemas: list[str] = []

    def made(name: str) -> Settings:
        folder = tmp_path / name
        if not SERVER:
            return Settings(data_dir=folder)
        schemas.append(f"sightline_restored_{uuid4().hex[:12]}")
        _on_server(f'CREATE SCHEMA "{schemas[-1]}"')
        url = make_url(SERVER).update_query_dict({"options": f"-csearch_path={schemas[-1]}"})
        return Settings(data_dir=folder, database_url=url.render_as_string(hide_password=False))

    yield made
    for schema in schemas:
        _on_server(f'DROP SCHEMA "{schema}" CASCADE')


def _on_server(statement: str) -> None:
    server = create_engine(SERVER, isolation_level="AUTOCOMMIT")
    with server.connect() as connection:
        connection.execute(text(statement))
    server.dispose()


def _fill(url: str) -> None:
    """Eight measurements."""
    engine = make_engine(url)
    with writing(session_factory(engine)) as session:
        one = samples.sample(session)
        first = samples.measure(session, one)
        for number in range(2, 9):
            click(session, samples.KEY.format(number), samples.values(one), first.id)
    engine.dispose()


@pytest.fixture(scope="module")
def put_back(shelf: Shelf) -> PutBack:
    return shelf.keep(_fill)[1]


@pytest.fixture
def measured(put_back: PutBack, database_url: str) -> None:
    put_back(database_url)


@pytest.fixture
def filled(measured: None, services: Services) -> Services:
    """An installation with measurements, media and both keys."""
    samples.put_bytes(services, b"a video" * 1000, ".mp4")
    samples.put_bytes(services, b"a picture", ".jpg")
    signing_key(services.settings)
    return services


def click(session: Session, key: str, values: MeasurementValues, first: int) -> None:
    """A repeat of the first measurement of the sample: as many as one likes may stand."""
    add_measurement(session, 1, client_key=key, values=values, repeat_of=first, actor=1)


def backed_up(services: Services, folder: Path, **options: bool) -> MadeBackup:
    return make_backup(services, folder, silent, **options)


@pytest.mark.parametrize("killed", [True, False])
def test_the_key_of_a_backup_is_that_of_its_database(
    filled: Services, tmp_path: Path, new_place: NewPlace, monkeypatch: pytest.MonkeyPatch, killed: bool
) -> None:
    """It was changed: by who was killed behind the commit, or while the database was being copied."""
    settings = filled.settings

    def change(*, committed_only: bool) -> None:
        old, (new, waiting) = signing_key(settings), replacing_key(settings.data_dir)
        with filled.writing() as session:
            hand_on(session, old, new, actor=None)
        if not committed_only:
            put_in_force(settings.data_dir, waiting)

    described = make._describe_state

    def meanwhile(*given: Any) -> Any:
        change(committed_only=False)
        return described(*given)

    with filled.writing() as session:
        sign_checkpoint(session, signing_key(settings), actor=None)
    if killed:
        change(committed_only=True)
    else:
        monkeypatch.setattr(make, "_describe_state", meanwhile)
    make_backup(filled, tmp_path / "backup", silent)
    place = new_place("restored")
    restore_backup(tmp_path / "backup", place, silent)
    restored = open_services(place)
    with restored.writing() as session:
        sign_checkpoint(session, signing_key(place), actor=None)
    restored.close()


def rows_of(url: str) -> dict[str, list[tuple[object, ...]]]:
    """Every row of every table but the job engine's own, in an order that does not depend on the database."""
    engine = make_engine(url, must_exist=True)
    with reading(session_factory(engine)) as session:
        found = {
            table.name: sorted((tuple(row) for row in session.execute(select(table))), key=repr)
            for table in metadata.sorted_tables
        }
    engine.dispose()
    return found


def test_what_is_restored_is_what_was_there(filled: Services, tmp_path: Path, new_place: NewPlace) -> None:
    made = backed_up(filled, tmp_path / "backup")
    place = new_place("restored")
    found = restore_backup(tmp_path / "backup", place, silent)
    assert found.audit is not None and found.audit.ok and found.audit.checked > 10
    assert rows_of(place.database_url) == rows_of(filled.settings.database_url)
    restored = open_services(place, decode_in_child=False)
    assert list(restored.media.listing()) == list(filled.media.listing())
    # counters stand where they stood: the next row gets a number of its own
    with restored.writing() as session:
        samples.person(session, "Petra")
    restored.close()
    assert verify_database(place.database_url).ok
    key = place.data_dir / "signing.key"
    assert key.read_bytes() == (filled.settings.data_dir / "signing.key").read_bytes()
    assert stat.S_IMODE(key.stat().st_mode) == 0o600
    assert made.fresh == len(made.manifest.media) == 2


def test_what_is_written_once_stays_so_after_a_restore(
    filled: Services, tmp_path: Path, new_place: NewPlace
) -> None:
    backed_up(filled, tmp_path / "backup")
    place = new_place("restored")
    restore_backup(tmp_path / "backup", place, silent)
    engine = make_engine(place.database_url)
    with engine.connect() as connection, pytest.raises(Exception, match="written once"):
        connection.execute(text("UPDATE measurements SET revision = 7"))
    engine.dispose()


@pytest.mark.once
def test_the_folder_is_for_its_owner_alone(filled: Services, tmp_path: Path) -> None:
    made = backed_up(filled, tmp_path / "backup").manifest
    state = tmp_path / "backup" / STATES / made.state
    assert stat.S_IMODE((tmp_path / "backup").stat().st_mode) == 0o700
    assert stat.S_IMODE(state.stat().st_mode) == 0o700
    assert {stat.S_IMODE(path.stat().st_mode) for path in state.iterdir()} == {0o600}
    # what comes from the environment stays there, and no secret is among the settings
    assert made.keys == {"signing.key": "file", "secret.key": "environment"}
    assert "a secret for tests only" not in (tmp_path / "backup" / MANIFEST).read_text()


@pytest.mark.once
def test_only_what_is_new_is_copied(filled: Services, tmp_path: Path) -> None:
    first = backed_up(filled, tmp_path / "backup").manifest
    samples.put_bytes(filled, b"another picture", ".jpg")
    second = backed_up(filled, tmp_path / "backup")
    assert (second.fresh, len(second.manifest.media)) == (1, 3)
    assert sorted(path.name for path in (tmp_path / "backup" / STATES).iterdir()) == [
        first.state,
        second.manifest.state,
    ]
    assert not (tmp_path / "backup" / JOURNAL).exists()


@pytest.mark.once
def test_a_stopped_backup_goes_on_and_leaves_the_one_before_whole(
    filled: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, new_place: NewPlace
) -> None:
    folder = tmp_path / "backup"

    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(make, "_copy_database", stopped)
        backed_up(filled, folder)
    with pytest.raises(BadInput, match="no complete backup"):
        restore_backup(folder, new_place("too soon"), silent)
    with (folder / JOURNAL).open("a") as journal:
        journal.write('["torn')
    first = backed_up(filled, folder)
    assert (first.fresh, len(first.manifest.media)) == (0, 2)
    samples.put_bytes(filled, b"later", ".jpg")
    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(make, "write_manifest", stopped)
        backed_up(filled, folder)
    assert check_backup(folder, silent).manifest == first.manifest


HOLD = """
import fcntl, sys
file = open(sys.argv[1], "ab")
fcntl.lockf(file, fcntl.LOCK_EX)
print("held", flush=True)
sys.stdin.read()
"""


@pytest.mark.once
def test_one_backup_at_a_time_in_a_folder(filled: Services, tmp_path: Path) -> None:
    backed_up(filled, tmp_path / "backup")
    holder = [sys.executable, "-c", HOLD, str(tmp_path / "backup" / LOCK)]
    with subprocess.Popen(holder, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        try:
            assert other.stdout is not None
            assert other.stdout.readline() == b"held\n"
            with pytest.raises(Conflict, match="Another backup"):
                backed_up(filled, tmp_path / "backup")
        finally:
            other.kill()
    backed_up(filled, tmp_path / "backup")


#: The program, which kills itself when it comes to a function of the copying of media for the n-th time.
KILLED = """
import os, signal, sys
from types import SimpleNamespace
from sightline.cli import main
from sightline.infra.backup import media_copy
where, left = sys.argv[1], int(sys.argv[2])
def killed(work):
    def counted(*given):
        global left
        left -= 1
        if left == 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return work(*given)
    return counted
if where == "replace":
    media_copy.os = SimpleNamespace(**{**vars(os), "replace": killed(os.replace)})
else:
    setattr(media_copy, where, killed(getattr(media_copy, where)))
sys.exit(main(sys.argv[3:]))
"""


@pytest.mark.once  # media are copied before the database is, of whatever kind it is
@pytest.mark.parametrize(
    ("files", "places"),
    [
        (20, ("replace",)),
        *(
            pytest.param(files, ("check_room", "replace", "sync_to_disk"), marks=pytest.mark.proof)
            for files in (50, 120)
        ),
    ],
)
def test_a_killed_backup_goes_on(
    filled: Services, tmp_path: Path, new_place: NewPlace, files: int, places: tuple[str, ...]
) -> None:
    """SIGKILL before a file, when it is written, and when it is in its place but not noted: what was copied
    is not copied again, and nothing looks whole before it is.
    """
    for number in range(files):
        samples.put_bytes(filled, bytes([number % 251]) * 20_000 + str(number).encode(), ".jpg")
    folder, settings = tmp_path / "backup", filled.settings
    asked = ["backup", str(folder), "--data-dir", str(settings.data_dir)]
    addresses = {"SIGHTLINE_DATABASE_URL": settings.database_url, "SIGHTLINE_MEDIA_URL": settings.media_url}
    copied = 0
    for where in places:
        command = [sys.executable, "-c", KILLED, where, "16", *asked]
        done = subprocess.run(command, env=os.environ | addresses, stderr=subprocess.DEVNULL, check=False)
        assert done.returncode == -signal.SIGKILL
        copied += 15
        assert _lines(folder / JOURNAL) == copied
        assert not (folder / MANIFEST).exists()
        with pytest.raises(BadInput, match="no complete backup"):
            check_backup(folder, silent)
    made = backed_up(filled, folder)
    assert (made.fresh + copied, len(made.manifest.media)) == (files + 2, files + 2)
    assert list(folder.rglob("*.part")) == []
    assert restore_backup(folder, new_place("restored"), silent).audit is not None


def _lines(path: Path) -> int:
    return path.read_bytes().count(b"\n") if path.is_file() else 0


@pytest.mark.once
def test_media_in_s3(
    filled: Services, open_s3: OpenS3, tmp_path: Path, new_place: NewPlace, s3_endpoint: str
) -> None:
    store = open_s3()
    for key, _ in filled.media.listing():
        store.put_file(key, filled.media.local_path(key))
    made = backed_up(replace(filled, media=store), tmp_path / "backup")
    assert made.fresh == 2
    address = f"s3://restored-{uuid4().hex[:8]}/some/place?endpoint={s3_endpoint}"
    place = new_place("restored").model_copy(update={"media_url": address})
    restore_backup(tmp_path / "backup", place, silent)
    restored = open_services(place, decode_in_child=False)
    assert list(restored.media.listing()) == list(filled.media.listing())
    restored.close()
    again = new_place("again").model_copy(update={"media_url": address})
    with pytest.raises(BadInput, match="is not empty"):
        restore_backup(tmp_path / "backup", again, silent)
    assert not again.data_dir.exists()


def test_clicks_are_stored_while_it_runs(
    filled: Services, tmp_path: Path, new_place: NewPlace, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A restored database verifies, holds the clicks up to one of those acknowledged, none after it, and the
    media of each.
    """
    with filled.reading() as session:
        before = session.execute(select(func.count()).select_from(measurement_series)).scalar_one()
        first = session.execute(select(func.min(measurement_series.c.id))).scalar_one()
        values = samples.values(_sample_of(session))
    acknowledged: list[tuple[str, str]] = []
    stop = threading.Event()

    def click_on() -> None:
        for number in itertools.count(10_000):
            if stop.is_set():
                return
            picture, key = samples.put_bytes(filled, str(number).encode(), ".jpg"), samples.KEY.format(number)
            with filled.writing(1) as session:
                click(session, key, values, first)
            acknowledged.append((key, picture))

    moments: list[int] = []
    copy = {name: getattr(make, name) for name in ("copy_sqlite", "copy_out")}

    def between(*given: Any) -> Any:
        """The copy of the database with clicks before, while and after."""
        moments.append(_wait_for(acknowledged, 5))
        done = copy["copy_out" if SERVER else "copy_sqlite"](*given[:2], lambda _: _wait_for(acknowledged, 1))
        moments.append(_wait_for(acknowledged, 5))
        return done

    for name in copy:
        monkeypatch.setattr(make, name, between)
    monkeypatch.setattr("sightline.infra.backup.sqlite_copy._PAGES", 16)
    thread = threading.Thread(target=click_on)
    thread.start()
    try:
        backed_up(filled, tmp_path / "backup")
    finally:
        stop.set()
        thread.join()
    place = new_place("restored")
    found = restore_backup(tmp_path / "backup", place, silent)
    assert found.audit is not None and found.audit.ok
    restored = open_services(place, decode_in_child=False)
    s = measurement_series.c
    with restored.reading() as session:
        stored = list(session.execute(select(s.client_key).order_by(s.id).offset(before)).scalars())
    assert stored == [key for key, _ in acknowledged[: len(stored)]]
    # PostgreSQL's snapshot is older than its first table; a click may be on its way while one is taken
    assert (0 if SERVER else moments[0]) <= len(stored) <= moments[1] + 1
    assert len(acknowledged) >= moments[0] + 10
    assert all(restored.media.exists(picture) for _, picture in acknowledged[: len(stored)])
    restored.close()


def _wait_for(growing: list[Any], more: int) -> int:
    """Wait until a list has so many more; how many it has."""
    start = len(growing)
    until(lambda: len(growing) >= start + more)
    return len(growing)


def _sample_of(session: Session) -> Any:
    """The numbers that `samples.values` takes of the sample that is stored."""
    pose = session.execute(select(road_poses.c.id, road_poses.c.calibration_id)).one()
    return SimpleNamespace(
        pose=SimpleNamespace(id=pose.id), calibration=SimpleNamespace(id=pose.calibration_id)
    )


@pytest.mark.parametrize("harm", ["truncated", "changed", "gone"])
@pytest.mark.parametrize(
    "of", ["database", *(pytest.param(one, marks=pytest.mark.once) for one in ("media", "manifest"))]
)
def test_a_damaged_backup_is_refused_by_name(
    filled: Services, tmp_path: Path, new_place: NewPlace, harm: str, of: str
) -> None:
    made = backed_up(filled, tmp_path / "backup").manifest
    path = {
        "media": media_file(tmp_path / "backup", next(iter(made.media.values())).sha256),
        "database": tmp_path
        / "backup"
        / STATES
        / made.state
        / max(made.files, key=lambda name: made.files[name].size),
        "manifest": tmp_path / "backup" / MANIFEST,
    }[of]
    content = path.read_bytes()
    if harm == "gone":
        path.unlink()
    elif harm == "truncated":
        path.write_bytes(content[: len(content) // 2])
    else:
        path.write_bytes(content.replace(b'"files"', b'"fi1es"') if of == "manifest" else b"!" + content[1:])
    place = new_place("restored")
    for refused in (
        lambda: check_backup(tmp_path / "backup", silent),
        lambda: restore_backup(tmp_path / "backup", place, silent),
    ):
        with pytest.raises(SightlineError) as said:
            refused()
        assert path.name in said.value.message
    assert not place.data_dir.exists()


def test_figures_changed_in_the_manifest_are_seen(
    filled: Services, tmp_path: Path, new_place: NewPlace
) -> None:
    backed_up(filled, tmp_path / "backup")
    path = tmp_path / "backup" / MANIFEST
    content = json.loads(path.read_bytes())
    content["heads"] = {name: [count - 1, hash_] for name, (count, hash_) in content["heads"].items()}
    path.write_text(json.dumps(content))
    with pytest.raises(Damaged, match=r"manifest\.json"):
        restore_backup(tmp_path / "backup", new_place("restored"), silent)


def test_a_place_that_is_not_empty_is_refused(filled: Services, tmp_path: Path, new_place: NewPlace) -> None:
    backed_up(filled, tmp_path / "backup")
    place = new_place("restored")
    place.data_dir.mkdir()
    (place.data_dir / "mine.txt").write_text("mine")
    with pytest.raises(BadInput, match="is not empty"):
        restore_backup(tmp_path / "backup", place, silent)
    assert [path.name for path in place.data_dir.iterdir()] == ["mine.txt"]
    there = place.model_copy(update={"data_dir": tmp_path / "new"})
    if SERVER:
        engine = make_engine(there.database_url)
        migrate(engine)
        engine.dispose()
        with pytest.raises(BadInput, match="already has tables"):
            restore_backup(tmp_path / "backup", there, silent)
        assert not there.data_dir.exists()


def test_an_installation_moves_to_the_other_kind_of_database_and_back(
    filled: Services, tmp_path: Path, new_place: NewPlace
) -> None:
    """With every row, signs that mean something to COPY, and a job that waits; it goes on where it is."""
    if not SERVER:
        pytest.skip("needs both kinds")
    with filled.writing() as session:
        create_survey(session, name="tab\tline\nback\\slash \\N é \v", description="", actor=1)
        waiting = registry.enqueue(session, "test_make_survey", {"folder": "x"}, survey_id=None, actor=1)
    backed_up(filled, tmp_path / "first")
    laptop = Settings(data_dir=tmp_path / "laptop")
    restore_backup(tmp_path / "first", laptop, silent)
    assert rows_of(laptop.database_url) == rows_of(filled.settings.database_url)

    opened = open_services(laptop, decode_in_child=False)
    with opened.writing() as session:
        claim_job(session, waiting.id, worker="one that the move ends")
        with pytest.raises(DatabaseError, match="audit_events"):
            session.execute(text("DELETE FROM audit_events"))
    backed_up(opened, tmp_path / "second")
    moved = rows_of(laptop.database_url)
    opened.close()

    agency = new_place("agency")
    restore_backup(tmp_path / "second", agency, silent)
    then = rows_of(agency.database_url)
    assert {name for name in moved if moved[name] != then[name]} == {"jobs", "audit_events", "audit_chains"}
    opened = open_services(agency, decode_in_child=False)
    with opened.writing() as session:
        delivered = text("SELECT args ->> 'job_id' FROM procrastinate_jobs WHERE status = 'todo'")
        assert session.execute(delivered).scalars().all() == [str(waiting.id)]
        assert get_job(session, waiting.id).state == "queued" and verify_records(session).ok
        survey = create_survey(session, name="the next number", actor=1)
        assert survey.id == max(row[0] for row in moved["surveys"]) + 1
    opened.close()


@pytest.mark.once
def test_folders_that_hold_other_things_are_left_alone(filled: Services, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(BadInput, match="not a backup"):
        backed_up(filled, tmp_path / "mine")
    with pytest.raises(BadInput, match="lies within the other"):
        backed_up(filled, filled.settings.data_dir / "backup")
    with pytest.raises(BadInput, match="lies within the other"):
        backed_up(filled, tmp_path)
    media = tmp_path / "elsewhere"
    for url in (str(media), f"file://{media}"):
        apart = replace(filled, settings=filled.settings.model_copy(update={"media_url": url}))
        for folder in (media / "backup", media):
            with pytest.raises(BadInput, match="within the other"):
                backed_up(apart, folder)


@pytest.mark.once
def test_a_backup_of_another_installation_is_not_replaced(filled: Services, tmp_path: Path) -> None:
    backed_up(filled, tmp_path / "backup")
    path = tmp_path / "backup" / MANIFEST
    manifest = read_manifest(tmp_path / "backup")
    other = {name: (count, "0" * 64) for name, (count, _) in manifest.heads.items()}
    write_manifest(tmp_path / "backup", replace(manifest, heads=other))
    before = path.read_bytes()
    with pytest.raises(BadInput, match="another installation"):
        backed_up(filled, tmp_path / "backup")
    assert path.read_bytes() == before


@pytest.mark.once
def test_the_two_latest_states_are_kept_and_either_is_restored(
    filled: Services, tmp_path: Path, new_place: NewPlace
) -> None:
    folder = tmp_path / "backup"
    backed_up(filled, folder)
    with pytest.raises(BadInput, match="one backup only"):
        restore_backup(folder, new_place("too soon"), silent, earlier=True)
    gone = samples.put_bytes(filled, b"soon gone", ".jpg")
    earlier = backed_up(filled, folder).manifest
    rows = rows_of(filled.settings.database_url)
    filled.media.delete(gone)
    with filled.writing() as session:
        samples.person(session, "Petra")
    last = backed_up(filled, folder, pruning=True).manifest
    assert sorted(path.name for path in (folder / STATES).iterdir()) == [earlier.state, last.state]
    place = new_place("restored")
    assert restore_backup(folder, place, silent, earlier=True).manifest == earlier
    assert rows_of(place.database_url) == rows
    assert restore_backup(folder, new_place("last"), silent).manifest == last


@pytest.mark.once
def test_old_media_go_only_when_asked(filled: Services, tmp_path: Path) -> None:
    key = samples.put_bytes(filled, b"soon gone", ".jpg")
    backed_up(filled, tmp_path / "backup")
    filled.media.delete(key)

    def files() -> int:
        return len(list((tmp_path / "backup" / "media").glob("??/??/*")))

    assert backed_up(filled, tmp_path / "backup").pruned == 0
    assert files() == 3
    assert backed_up(filled, tmp_path / "backup", pruning=True).pruned == 1  # neither state names it
    assert files() == 2
    check_backup(tmp_path / "backup", silent)


@pytest.mark.parametrize("good_before", [True, False])
def test_a_chain_that_does_not_hold_is_not_backed_up(
    filled: Services, tmp_path: Path, good_before: bool
) -> None:
    folder = tmp_path / "backup"
    good = backed_up(filled, folder).manifest if good_before else None
    _forge(filled)
    said = "still in" if good else "no earlier one"
    with pytest.raises(Damaged, match=rf"^Audit event 1 of .* was changed .* {said}"):
        backed_up(filled, folder)
    assert [path.name for path in (folder / STATES).iterdir()] == ([good.state] if good else [])
    if good:
        assert check_backup(folder, silent).manifest == good


def test_a_chain_that_does_not_hold_is_not_restored(
    filled: Services, tmp_path: Path, new_place: NewPlace, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In a backup of a version that did not look; where the store then goes away, the folder is empty too."""
    _forge(filled)
    monkeypatch.setattr(make, "verify_records", lambda _: Verification(True, 0, "", None))
    backed_up(filled, tmp_path / "backup")
    place = new_place("restored")
    with pytest.raises(Damaged, match="does not verify"):
        restore_backup(tmp_path / "backup", place, silent)
    assert not place.data_dir.exists()

    def away(_store: LocalStore, key: str) -> None:
        raise StorageAway("store-no-answer", key=key, name="Timeout")

    monkeypatch.setattr(LocalStore, "delete", away)
    with pytest.raises(StorageAway):
        restore_backup(tmp_path / "backup", place, silent)
    assert not place.data_dir.exists()


def _forge(filled: Services) -> None:
    with filled.engine.begin() as connection:
        if SERVER:
            connection.execute(text("SET LOCAL session_replication_role = replica"))
        else:
            connection.execute(text("DROP TRIGGER audit_events_refuse_update"))
        first = select(func.min(audit_events.c.id)).scalar_subquery()
        connection.execute(audit_events.update().where(audit_events.c.id == first).values(action="forge"))


def first_hash(services: Services) -> str:
    """Of the first event."""
    with services.engine.connect() as connection:
        return str(connection.scalar(select(audit_events.c.hash).order_by(audit_events.c.id).limit(1)))


def test_by_commands(
    filled: Services,
    tmp_path: Path,
    new_place: NewPlace,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("SIGHTLINE_DATABASE_URL", filled.settings.database_url)
    monkeypatch.setenv("SIGHTLINE_MEDIA_URL", filled.settings.media_url)
    folder = str(tmp_path / "backup")
    data_dir = str(filled.settings.data_dir)
    # the sample's recording has a row and no file: said, and the rest is backed up all the same
    assert main(["backup", folder, "--data-dir", data_dir, "--verify", "--prune"]) == 1
    said = capsys.readouterr()
    assert "not in the media store" in said.err and "media files are new" in said.out
    assert "every file is the one that was backed up" in said.out
    assert main(["verify", folder]) == 0
    assert "every file" in capsys.readouterr().out
    for kept in (["--key", "a" * 64], *([["--head", "a" * 64]] if SERVER else [])):
        assert main(["verify", folder, *kept]) == 2
        assert "no effect here" in capsys.readouterr().err or SERVER
    if not SERVER:
        first = first_hash(filled)
        assert main(["verify", folder, "--head", first]) == 0
        assert "What was given vouches for 1 of " in capsys.readouterr().out
        assert main(["verify", folder, "--head", "a" * 64, "--json"]) == 1
        assert json.loads(capsys.readouterr().out)["status"] == "broken"
    place = new_place("restored")
    monkeypatch.delenv("SIGHTLINE_MEDIA_URL")
    if SERVER:
        monkeypatch.setenv("SIGHTLINE_DATABASE_URL", place.database_url)
    else:
        monkeypatch.delenv("SIGHTLINE_DATABASE_URL")
    assert main(["restore", folder, "--data-dir", str(place.data_dir)]) == 0
    assert "events is intact" in capsys.readouterr().out
    assert main(["restore", folder, "--data-dir", str(place.data_dir)]) == 2
    assert verify_database(place.database_url).ok
