"""What is written once stays: the database refuses changes, and verify finds those made behind its back."""

import json
from collections.abc import Callable
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import Engine, text
from sqlalchemy.exc import DBAPIError
from sqlalchemy.orm import Session

from sightline.cli import main
from sightline.errors import Damaged, SightlineError
from sightline.export.store import add_export
from sightline.infra.audit import trail
from sightline.infra.audit.checkpoints import (
    checkpoint_of_chain,
    checkpoint_problem,
    hand_on,
    sign_checkpoint,
    take_key,
)
from sightline.infra.audit.guards import require_guards
from sightline.infra.audit.merkle import path_of, root_by_path, root_of
from sightline.infra.audit.records import AuditHead, Verification
from sightline.infra.audit.signing import SigningKey, put_in_force, replacing_key, signing_key
from sightline.infra.audit.tables import audit_events
from sightline.infra.audit.verification import verify_database, verify_records
from sightline.infra.audit.vouched import (
    ChangedByEvents,
    WrittenOnce,
    WrittenOnceApart,
    fingerprints,
    marked_tables,
)
from sightline.infra.database.engine import (
    SessionFactory,
    engine_of,
    make_engine,
    reading,
    session_factory,
    writing,
)
from sightline.measurements.again.store import add_computing
from sightline.measurements.click_sigma_store import choose_click_sigma
from sightline.messages.said import Said
from sightline.people.store import person_by_email
from sightline.quality.checks.store import add_wheel_pair
from sightline.recordings.store import remove_recording
from sightline.reviews.lots.store import add_decision
from sightline.reviews.store import add_review
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.settings import Settings
from sightline.surveys.photographs.store import order_photographs
from sightline.vehicles.records import VehicleChanges
from sightline.vehicles.store import create_vehicle, remove_vehicle, restore_vehicle, update_vehicle
from tests.conftest import SERVER
from tests.support import samples, scans_samples
from tests.support.events import events_of
from tests.support.kept import PutBack, Shelf
from tests.support.proofs import every

pytestmark = pytest.mark.dialect

WRITTEN_ONCE = (
    "audit_events",
    "measurement_series",
    "computings",
    "measurements",
    "lots",
    "lot_items",
    "lot_decisions",
    "reviews",
    "calibrations",
    "road_poses",
    "wheel_pairs",
    "click_sigmas",
    "scan_runs",
    "scan_measurements",
    "scan_reviews",
    "scan_references",
    "line_poses",
    "rig_calibrations",
    "study_results",
)


def _fill(url: str) -> None:
    """One of everything."""
    engine = make_engine(url)
    with writing(session_factory(engine)) as session:
        one = samples.sample(session)
        made = samples.measure(session, one)
        add_review(session, made.id, seen_revision=1, verdict="accepted", actor=one.rene.id)
        add_computing(session, one.survey.id, [], kind="asked", actor=one.olga.id)
        samples.measure(session, one, "taillight", 2)
        add_decision(session, samples.lot(session, one), "dissolved", (), actor=one.rene.id)
        create_vehicle(session, one.recording.id, {"first_frame": 50, "last_frame": 60}, actor=None)
        crc = int(samples.frame_table().crc32[20])
        points: dict[str, Any] = {"first": (1.0, 2.0), "second": (3.0, 2.0)}
        add_wheel_pair(session, one.vehicle.id, frame=20, frame_crc32=crc, **points, actor=one.olga.id)
        choose_click_sigma(session, one.survey.id, one.olga.id, sigma_px=0.7, pairs=9, actor=None)
        for n in range(2):
            samples.photograph(session, one, f"{n}.jpg")
        order_photographs(session, one.survey.id, [2, 1], actor=one.olga.id)
        scanned = scans_samples.measured(session, one)
        scans_samples.vehicle(session, one)
        scans_samples.run(session, one, scanned.scan_id)
        add_scan_review(session, scanned.id, verdict="accepted", actor=one.rene.id)
        scans_samples.reference(session, one, scanned.vehicle_id)
        scans_samples.calibrated_rig(session, one, scanned.scan_id)
        rod = scans_samples.rod(session, one, scanned.scan_id)
        height = scans_samples.tall(session, one, scanned.vehicle_id, rod)
        add_review(session, height.id, seen_revision=1, verdict="accepted", actor=one.rene.id)
        samples.study_result(session, one)
    engine.dispose()


@pytest.fixture(scope="module")
def put_back(shelf: Shelf) -> PutBack:
    return shelf.keep(_fill)[1]


@pytest.fixture
def filled(put_back: PutBack, database_url: str, factory: SessionFactory) -> SessionFactory:
    """A database with one of everything."""
    put_back(database_url)
    return factory


def test_the_database_refuses_changes_removal_and_replacing(filled: SessionFactory) -> None:
    engine = engine_of(filled)
    for table in WRITTEN_ONCE:
        for statement in _attempts(engine.dialect.name, table):
            with pytest.raises(DBAPIError, match="written once"), engine.begin() as connection:
                connection.execute(text(statement))
                pytest.fail(statement)
    with reading(filled) as session:
        assert verify_records(session).ok


def test_a_guard_that_is_missing_or_off_is_told(filled: SessionFactory) -> None:
    engine = engine_of(filled)
    off = (
        "ALTER TABLE reviews DISABLE TRIGGER USER"
        if engine.dialect.name == "postgresql"
        else "DROP TRIGGER reviews_refuse_update"
    )
    with engine.connect() as connection:
        require_guards(connection)
        connection.execute(text(off))
        with pytest.raises(Damaged, match="no longer protects reviews"):
            require_guards(connection)
        with Session(connection) as session:
            assert "no longer protects reviews" in str(verify_records(session).problem)
        connection.rollback()


def test_every_table_that_is_written_once_says_so_and_is_verified(filled: SessionFactory) -> None:
    """A table that the database protects and that bears no mark would never be hashed again."""
    said = {
        table.name: mark
        for mark, table in marked_tables()
        if isinstance(mark, WrittenOnce | WrittenOnceApart)
    }
    assert set(said) | {audit_events.name} == set(WRITTEN_ONCE) == _protected(engine_of(filled))
    apart = {mark.fingerprint for mark in said.values() if isinstance(mark, WrittenOnceApart)}
    assert apart <= {fingerprint.entity for fingerprint in fingerprints()}


def test_everything_that_is_vouched_for_has_a_name_of_its_own() -> None:
    entities = {mark.entity for mark, _ in marked_tables() if isinstance(mark, WrittenOnce | ChangedByEvents)}
    entities |= {one.entity for one in fingerprints()}
    assert len({str(Said("audit-row-removed", entity=one, id=1)) for one in entities}) == len(entities) > 20


def test_every_hash_that_an_event_keeps_is_compared_with_a_row(filled: SessionFactory) -> None:
    with reading(filled) as session:
        events = events_of(session)
    hashed = {event.entity for event in events if event.after and "content_sha256" in event.after}
    compared = {mark.entity for mark, _ in marked_tables() if isinstance(mark, WrittenOnce)}
    assert hashed == compared
    assert {event.entity for event in events if event.after and "frames_sha256" in event.after} == {
        "recording"
    }


def _protected(engine: Engine) -> set[str]:
    """The tables of which the database itself refuses to change a row."""
    query = (
        "SELECT DISTINCT event_object_table FROM information_schema.triggers"
        if engine.dialect.name == "postgresql"
        else "SELECT DISTINCT tbl_name FROM sqlite_master WHERE type = 'trigger'"
    )
    with engine.connect() as connection:
        tables = set(connection.execute(text(query)).scalars())
    return {name for name in tables if not name.startswith("procrastinate_")}


def _attempts(dialect: str, table: str) -> tuple[str, ...]:
    """SQLite's INSERT OR REPLACE takes the old row away without a DELETE that a trigger would see."""
    own = (
        (
            f"TRUNCATE {table} CASCADE",
            f"INSERT INTO {table} SELECT * FROM {table} ON CONFLICT (id) DO UPDATE SET id = EXCLUDED.id",
        )
        if dialect == "postgresql"
        else (f"DELETE FROM {table} WHERE 1", f"INSERT OR REPLACE INTO {table} SELECT * FROM {table}")
    )
    return f"UPDATE {table} SET id = id", f"DELETE FROM {table}", *own


def _tamper(engine: Engine, *statements: str) -> None:
    """Change rows as somebody with the owner's rights over the database would."""
    with engine.begin() as connection:
        if engine.dialect.name == "postgresql":
            connection.execute(text("SET LOCAL session_replication_role = replica"))
        else:
            connection.execute(text("PRAGMA defer_foreign_keys = ON"))
            triggers = connection.execute(text("SELECT name FROM sqlite_master WHERE type = 'trigger'"))
            for (name,) in triggers.all():
                connection.execute(text(f"DROP TRIGGER {name}"))
        for statement in statements:
            connection.execute(text(statement))


_OF_SURVEY = "chain = 'survey/1' AND number"
TAMPERED: dict[str, tuple[tuple[str, ...], str]] = {
    "an event's content": (
        (f'UPDATE audit_events SET after = \'{{"name":"other"}}\' WHERE {_OF_SURVEY} = 3',),
        "Audit event 3 of survey/1 was changed",
    ),
    "an event's actor": (
        (f"UPDATE audit_events SET actor_id = 2 WHERE {_OF_SURVEY} = 4",),
        "Audit event 4 of survey/1 was changed",
    ),
    "an event's time": (
        (f"UPDATE audit_events SET at = '2020' WHERE {_OF_SURVEY} = 5",),
        "Audit event 5 of survey/1 was changed",
    ),
    "an event removed": (
        (f"DELETE FROM audit_events WHERE {_OF_SURVEY} = 3",),
        "Audit event 3 of survey/1 is missing",
    ),
    "the first event removed": (
        (f"DELETE FROM audit_events WHERE {_OF_SURVEY} = 1",),
        "Audit event 1 of survey/1 is missing",
    ),
    "events exchanged": (
        (f"UPDATE audit_events SET id = 9999 WHERE {_OF_SURVEY} = 3",),
        "Audit event 3 of survey/1 is missing",
    ),
    "an event moved to another chain": (
        (f"UPDATE audit_events SET chain = 'survey/7', number = 1 WHERE {_OF_SURVEY} = 1",),
        "Audit event 1 of survey/7 was changed",
    ),
    "the tail cut off": (
        (f"DELETE FROM audit_events WHERE {_OF_SURVEY} > 8",),
        "of survey/1 ends at event 8",
    ),
    "all events removed": (("DELETE FROM audit_events",), "ends at event 0"),
    "the chain's end removed": (("DELETE FROM audit_chains",), "not where it ended"),
    "a maker's height": (
        ("UPDATE vehicles SET manufacturer_height_m = 1.7 WHERE id = 1",),
        "vehicle 1 is not what its audit events state",
    ),
    "a deleted vehicle": (("UPDATE vehicles SET deleted_at = created_at WHERE id = 2",), "vehicle 2 is not"),
    "a vehicle removed": (("DELETE FROM vehicles WHERE id = 2",), "vehicle 2 was removed"),
    "a photograph's caption": (
        ("UPDATE survey_photographs SET caption = 'Elsewhere' WHERE id = 1",),
        "photograph of the set-up 1 is not",
    ),
    "the order of photographs": (
        ("UPDATE survey_photographs SET position = 3 WHERE id = 2",),
        "photograph of the set-up 2 is not",
    ),
    "a height": (("UPDATE measurements SET height_m = 1.5 WHERE id = 1",), "measurement revision 1 is not"),
    "a click": (
        ("UPDATE measurements SET target_x_px = target_x_px + 1e-9 WHERE id = 2",),
        "measurement revision 2 is not",
    ),
    "a revision removed": (("DELETE FROM measurements WHERE id = 2",), "measurement revision 2 was removed"),
    "a revision slipped in": (
        (
            "CREATE TABLE aside AS SELECT * FROM measurements WHERE id = 1",
            "UPDATE aside SET id = 9, revision = 2",
            "INSERT INTO measurements SELECT * FROM aside",
            "DROP TABLE aside",
        ),
        "measurement revision 9 is not",
    ),
    "a scanned vehicle's speed": (
        ("UPDATE scan_measurements SET speed_mps = 12.5 WHERE id = 1",),
        "scanned vehicle’s measurement 1 is not",
    ),
    "a scanned vehicle's boundary": (
        ("UPDATE scan_measurements SET front_line_2 = front_line_2 + 0.5 WHERE id = 1",),
        "scanned vehicle’s measurement 1 is not",
    ),
    "a maker's length": (
        ("UPDATE scan_vehicles SET true_length_m = 4.5 WHERE id = 1",),
        "scanned vehicle 1 is not what its audit events state",
    ),
    "a baseline": (("UPDATE scans SET baseline_m = 0.6 WHERE id = 1",), "line-scan recording 1 is not"),
    "a run removed": (
        ("DELETE FROM scan_runs WHERE id = 1",),
        "run over a line-scan recording 1 was removed",
    ),
    "a verdict on a scanned vehicle": (
        ("UPDATE scan_reviews SET verdict = 'reopened' WHERE id = 1",),
        "scanned vehicle’s review 1 is not",
    ),
    "a line camera's height": (
        ("UPDATE line_poses SET camera_height_m = 1.2 WHERE id = 1",),
        "calibration of a line camera 1 is not",
    ),
    "a reference value": (
        ("UPDATE scan_references SET value = 20 WHERE id = 1",),
        "reference value of a scanned vehicle 1 is not",
    ),
    "a height in a line scan": (
        ("UPDATE measurements SET height_m = 1.41 WHERE line_pose_id IS NOT NULL",),
        "measurement revision 3 is not",
    ),
    "the vehicle of a height in a line scan": (
        ("UPDATE measurement_series SET scan_vehicle_id = 2 WHERE scan_vehicle_id IS NOT NULL",),
        "measurement 3 is not",
    ),
    "another vehicle": (
        ("UPDATE measurement_series SET vehicle_id = 2 WHERE id = 1",),
        "measurement 1 is not",
    ),
    "a verdict": (
        ("UPDATE reviews SET verdict = 'rejected', reason = 'x' WHERE id = 1",),
        "review 1 is not",
    ),
    "a review removed": (("DELETE FROM reviews WHERE id = 1",), "review 1 was removed"),
    "a calibration": (("UPDATE calibrations SET document = '{}' WHERE id = 1",), "calibration 1 is not"),
    "a pose": (("UPDATE road_poses SET rms_px = 0.1 WHERE id = 1",), "camera pose 1 is not"),
    "a frame's checksum": (("UPDATE frames SET crc32 = 1 WHERE n = 7",), "frame table of recording 1 is not"),
    "a frame removed": (("DELETE FROM frames WHERE n = 99",), "frame table of recording 1 is not"),
}


@pytest.mark.parametrize("what", every(3 if SERVER else 1, TAMPERED))
def test_verify_finds(filled: SessionFactory, what: str) -> None:
    statements, words = TAMPERED[what]
    engine = engine_of(filled)
    _tamper(engine, *statements)
    found = verify_database(engine.url.render_as_string(hide_password=False))
    assert not found.ok
    problem = str(found.problem)
    assert words in problem, problem
    assert problem.count(".") <= 2 and problem.endswith(".")


def test_an_event_that_lacks_what_its_kind_holds_is_a_problem_like_others(
    filled: SessionFactory, database_url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """A KeyError ended all of `verify`: what else is broken, and the other places, were not told."""
    lacking: list[tuple[Any, Any, dict[str, Any]]] = [
        ("order", "photograph", {"order": [999]}),
        ("order", "photograph", {}),
        ("sign", "checkpoint", {"at": "2026-05-04"}),
        ("sign", "checkpoint", {"at": "2026-05-04", "ends": [], "root": root_of({})}),
        ("create", "lot", {}),
    ]

    def add_lacking(session: Session, action: Any, entity: Any, after: dict[str, Any]) -> str:
        chain = trail.chain_of(entity, 1)
        trail.record(session, None, action, entity, 1, 1, after=after)
        number = trail.heads(session)[chain].count
        return f"Audit event {number} of {chain} lacks what such an event holds; restore a backup."

    for each in lacking:
        with suppress(InterruptedError), writing(filled) as session:
            said = add_lacking(session, *each)
            assert str(verify_records(session).problem) == said, each
            raise InterruptedError  # it is not kept
    assert verify_database(database_url).ok
    with writing(filled) as session:
        first, _ = (add_lacking(session, *each) for each in lacking[:2])
    assert str(verify_database(database_url).problem) == first
    assert main(["verify", database_url, "/nowhere", database_url]) == 1
    err = capsys.readouterr().err
    assert err.count(first) == 2 and "/nowhere" in err


def test_a_tail_cut_with_its_anchor_moved_is_found_by_an_export(filled: SessionFactory) -> None:
    with writing(filled) as session:
        head = trail.head(session, 1)
        add_export(
            session, 1, media_key="z", size_bytes=1, sha256="0" * 64, head=head, actor=1
        )  # carries the head as it was before itself
    with reading(filled) as session:
        cut = events_of(session, 1)[1]
    _tamper(
        engine_of(filled),
        "DELETE FROM measurements",
        f"DELETE FROM audit_events WHERE {_OF_SURVEY} > 2",
        f"UPDATE audit_chains SET count = 2, hash = '{cut.hash}' WHERE name = 'survey/1'",
    )
    with reading(filled) as session:
        found = verify_records(session)
    assert not found.ok and "package 1" in str(found.problem)


def test_a_sound_database_verifies_with_its_head(filled: SessionFactory, database_url: str) -> None:
    with reading(filled) as session:
        head = trail.head(session)
        inside = verify_records(session)
    assert inside == verify_database(database_url)
    assert (inside.ok, inside.checked, inside.head_hash, inside.problem) == (
        True,
        head.count,
        head.hash,
        None,
    )


def test_a_deleted_recording_takes_its_frames_along(filled: SessionFactory) -> None:
    with writing(filled) as session:
        made = samples.add_recording(session, 1, None)
        remove_recording(session, made.id, actor=None)
        assert verify_records(session).ok


def test_a_vehicle_that_was_changed_deleted_and_restored_is_sound(filled: SessionFactory) -> None:
    facts: VehicleChanges = {"manufacturer_height_m": 1.1 + 0.2, "make": "Škoda", "notes": "", "year": 2019}
    with writing(filled) as session:
        update_vehicle(session, 2, facts, version=1, actor=None)
        assert verify_records(session).ok
        remove_vehicle(session, 2, actor=None)
        assert verify_records(session).ok
        restore_vehicle(session, 2, actor=None)
        assert verify_records(session).ok


def _settings(folder: Path) -> Settings:
    return Settings(data_dir=folder)


def test_a_chain_written_anew_is_found_by_a_signed_checkpoint(filled: SessionFactory, tmp_path: Path) -> None:
    """Whoever holds the database and not the key: chains cut, ends and heads made to fit."""
    with writing(filled) as session:
        sign_checkpoint(session, signing_key(_settings(tmp_path)), actor=None)
        assert verify_records(session).ok
        cut = events_of(session, 1)[8]
    _tamper(
        engine_of(filled),
        f"DELETE FROM audit_events WHERE {_OF_SURVEY} > 9",
        f"UPDATE audit_chains SET count = 9, hash = '{cut.hash}' WHERE name = 'survey/1'",
    )
    with reading(filled) as session:
        assert "are not those signed on" in str(verify_records(session).problem)


def test_keys_are_handed_on(factory: SessionFactory, tmp_path: Path) -> None:
    first = signing_key(_settings(tmp_path))
    assert signing_key(_settings(tmp_path)).public == first.public
    assert (tmp_path / "signing.key").stat().st_mode & 0o77 == 0
    with writing(factory) as session:
        sign_checkpoint(session, first, actor=None)
        second, waiting = replacing_key(tmp_path)
        hand_on(session, first, second, actor=None)
    put_in_force(tmp_path, waiting)
    with writing(factory) as session:
        signed = sign_checkpoint(session, signing_key(_settings(tmp_path)), actor=None)
        told = checkpoint_of_chain(session, signed, "settings")
        end = trail.heads(session)["settings"]
        assert checkpoint_problem(told, "settings", AuditHead(end.count - 1, told["leaf"]["hash"])) is None
        assert [one["key"] for one in told["keys"]] == [first.public, second.public]
        broken = {**told, "keys": told["keys"][1:]}
        assert checkpoint_problem(broken, "settings", AuditHead(end.count - 1, told["leaf"]["hash"]))
    with writing(factory) as session, pytest.raises(SightlineError, match="signing key"):
        sign_checkpoint(session, first, actor=None)


@pytest.mark.once
@pytest.mark.parametrize("count", range(1, 18))
def test_each_leaf_has_a_path_to_the_root_and_no_other_has_it(count: int) -> None:
    ends = {f"survey/{n}": AuditHead(n, sha256(bytes([n])).hexdigest()) for n in range(count)}
    root = root_of(ends)
    for chain, end in ends.items():
        place, path = path_of(ends, chain)
        assert root_by_path(chain, end, place, count, path) == root
        assert root_by_path(chain, AuditHead(end.count + 1, end.hash), place, count, path) != root
        for wrong in range(count):
            assert wrong == place or root_by_path(chain, end, wrong, count, path) != root
        assert root_by_path(chain, end, place, count, [*path, "0" * 64]) is None


def test_an_empty_chain_is_sound(factory: SessionFactory) -> None:
    with reading(factory) as session:
        assert verify_records(session) == Verification(True, 0, sha256(b"").hexdigest(), None)


def test_verify_says_that_a_database_is_of_another_version(engine: Engine) -> None:
    url = engine.url.render_as_string(hide_password=False)
    with engine.begin() as connection:
        then = connection.execute(text("SELECT version_num FROM alembic_version")).scalar_one()
        connection.execute(text("UPDATE alembic_version SET version_num = '0007_line_scans'"))
    try:
        with pytest.raises(SightlineError, match="made by another version"):
            verify_database(url)
    finally:
        with engine.begin() as connection:
            connection.execute(text("UPDATE alembic_version SET version_num = :then"), {"then": then})


@pytest.mark.once
def test_verify_says_what_is_no_database(tmp_path: Any) -> None:
    def refused(make: Callable[[], Any]) -> str:
        with pytest.raises(SightlineError) as caught:
            make()
        return caught.value.message

    assert "no database" in refused(lambda: verify_database(f"sqlite:///{tmp_path}/none.db"))
    empty, letter = tmp_path / "empty.db", tmp_path / "letter.db"
    empty.touch()
    letter.write_text("this is a letter, not a database\n" * 100)
    assert "This address is not a Sight" in refused(lambda: verify_database(f"sqlite:///{empty}"))
    assert "letter.db is not a Sight" in refused(lambda: verify_database(f"sqlite:///{letter}", "letter.db"))
    assert "not supported" in refused(lambda: verify_database("mysql://x/y"))
    assert not (tmp_path / "none.db").exists()


def test_events_name_their_actor_and_turn_the_page(filled: SessionFactory) -> None:
    with reading(filled) as session:
        newest = trail.listing(session, limit=2)
        older = trail.listing(session, limit=2, before_id=newest[-1].id)
        of_reviews = trail.listing(session, entity="review", survey_id=1)
        rene = person_by_email(session, "René@Example.org")
    assert [event.id for event in newest + older] == sorted((e.id for e in newest + older), reverse=True)
    assert newest[0].previous_hash == newest[1].hash
    assert rene is not None and of_reviews[0].actor is not None and of_reviews[0].actor.id == rene.id
    assert of_reviews[0].after is not None and of_reviews[0].after["verdict"] == "accepted"


def test_what_was_kept_elsewhere_is_held_against_a_database(
    filled: SessionFactory, database_url: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A head and a checkpoint hold, and how far they reach is told; those of another do not."""
    sound = verify_database(database_url)
    with writing(filled) as session:
        kept = sign_checkpoint(session, SigningKey(b"1" * 32), actor=None)
    place = tmp_path / "checkpoint.json"
    place.write_text(json.dumps(kept))
    _, count, end = max(kept["ends"], key=lambda one: one[1])
    whole = verify_database(database_url)
    signed = sum(count for _, count, _ in kept["ends"])
    for given, vouched in (
        (["--head", whole.head_hash[:16]], whole.checked),
        (["--head", end], count),
        (["--checkpoint", str(place)], signed),
        (["--head", end[:16], "--checkpoint", str(place)], signed),
    ):
        assert main(["verify", database_url, *given]) == 0
        told = f"vouches for {vouched} of {whole.checked} events"
        assert (told in capsys.readouterr().out) == (vouched < whole.checked), given
    for given, said in (
        (["--head", sound.head_hash], "goes through the given audit head"),
        (["--head", end, "--head", "a" * 64], "goes through the given audit head aaaaaaaaaaaaaaaa"),
    ):
        assert main(["verify", database_url, *given]) == 1
        assert said in capsys.readouterr().err
    place.write_text(json.dumps({**kept, "root": sound.head_hash}))
    assert main(["verify", database_url, "--checkpoint", str(place)]) == 2
    assert "no checkpoint" in capsys.readouterr().err
    name, count, _ = kept["ends"][0]
    for number, words in ((count, "was rewritten"), (count + 1000, "is older than the checkpoint")):
        place.write_text(json.dumps(_signed_with(kept, {name: AuditHead(number, "b" * 64)})))
        assert main(["verify", database_url, "--checkpoint", str(place)]) == 1
        said = capsys.readouterr().err
        assert words in said and "restore" not in said


def _signed_with(kept: dict[str, Any], changed: dict[str, AuditHead]) -> dict[str, Any]:
    """A checkpoint of other ends, signed by somebody."""
    key = SigningKey(b"2" * 32)
    ends = {name: AuditHead(count, hash_) for name, count, hash_ in kept["ends"]} | changed
    said = {name: kept[name] for name in ("format", "at", "chains")}
    said |= {"root": root_of(ends), "key": key.public}
    listed = [[name, one.count, one.hash] for name, one in ends.items()]
    return {**said, "signature": key.sign(said), "ends": listed}


def test_a_key_vouches_for_no_database(
    filled: SessionFactory, database_url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Who writes events writes the true key among them: it stands in every package."""
    key = SigningKey(b"1" * 32)
    with writing(filled) as session:
        take_key(session, key, actor=None)
    assert main(["verify", database_url, "--key", key.public]) == 2
    assert "--key has no effect here; use --checkpoint" in capsys.readouterr().err


def test_the_command_says_what_the_function_finds(
    filled: SessionFactory, database_url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """`sightline verify` of a database is `verify_database`: sound, changed, and not ours (status 2)."""
    sound = verify_database(database_url)
    assert main(["verify", database_url]) == 0
    assert f"{sound.checked} events is intact, head {sound.head_hash[:16]}." in capsys.readouterr().out
    _tamper(engine_of(filled), *TAMPERED["a calibration"][0])
    assert main(["verify", database_url, "--json"]) == 1
    said = capsys.readouterr()
    problem = str(verify_database(database_url).problem)
    found = verify_database(database_url)
    told = {"status": "broken", "problems": [problem], "not_checked": [], "key": None}
    told |= {"head": found.head_hash, "count": found.checked}
    assert json.loads(said.out) == {"kind": "database", **told}
    assert problem in said.err
    assert main(["verify", "sqlite:////nowhere/sightline.db"]) == 2
