"""Every public function of the storage room that writes leaves exactly one event, in its own transaction."""

import inspect
import pkgutil
import re
from collections.abc import Callable
from importlib import import_module
from typing import Any

import pytest
from sqlalchemy import event, select
from sqlalchemy.orm import Session

import backend.storage
from backend.storage import (
    audit,
    cameras,
    catalogue,
    click_sigmas,
    database,
    exports,
    jobs,
    measurements,
    people,
    photographs,
    recordings,
    reviews,
    standards,
    surveys,
    uploads,
    vehicles,
    wheel_pairs,
)
from backend.storage.records import CatalogueRow
from backend.storage.tables_of_work import audit_events
from tests.storage import samples, scans_samples
from tests.storage.samples import Sample, frame_table, values

Write = Callable[[Session, Sample], Any]


def _image(session: Session, one: Sample) -> Any:
    detected: dict[str, Any] = {"found": True, "reason": None, "corners_px": [(1.0, 2)]}
    size = {"columns": 9, "rows": 6, "sharpness": 3.0, "actor": one.olga.id}
    file = {"name": "a.png", "media_key": "k", "width_px": 640, "height_px": 480}
    return cameras.add_image(session, one.camera.id, **file, **detected, **size)


def _detect(session: Session, image_id: int, actor: int) -> Any:
    found = {"found": False, "reason": "No board.", "corners_px": []}
    return cameras.set_detection(session, image_id, **found, columns=8, rows=5, sharpness=None, actor=actor)


def _upload(session: Session, one: Sample) -> Any:
    return uploads.create(
        session, one.survey.id, filename="a.mp4", size_bytes=9, media_key="u", actor=one.olga.id
    )


def _strip(session: Session, one: Sample) -> Any:
    file: dict[str, Any] = {"filename": "first.tif", "size_bytes": 9, "media_key": "", "purpose": "strip"}
    return uploads.create(session, one.survey.id, **file, actor=one.olga.id)


def _job(session: Session, one: Sample) -> Any:
    return jobs.create(session, "ingest", {"a": 1}, survey_id=one.survey.id, actor=one.olga.id)


def _claimed(session: Session, one: Sample) -> Any:
    return jobs.claim(session, _job(session, one).id, worker="w", lease_s=5)


def _withdrawn(session: Session, one: Sample) -> Any:
    made = samples.measure(session, one)
    return measurements.withdraw(session, made.id, seen_revision=1, actor=one.olga.id)


def _review(session: Session, one: Sample, made: Any) -> Any:
    return reviews.add(session, made.id, seen_revision=1, verdict="accepted", actor=one.rene.id)


def _wheels(session: Session, one: Sample) -> Any:
    crc = int(frame_table().crc32[20])
    points: dict[str, Any] = {"first": (100.0, 400.0), "second": (300.5, 410.0)}
    return wheel_pairs.add(session, one.vehicle.id, frame=20, frame_crc=crc, **points, actor=one.olga.id)


def _moved(session: Session, one: Sample) -> Any:
    spans = [{"first_frame": 50, "last_frame": 99, "moved": True, "moved_px": 3.0, "change_m": 0.01}]
    check = {"state": "moved", "words": "Moved at frame 50.", "bumps": [50], "spans": spans}
    return recordings.drift_found(session, one.recording.id, one.pose.id, check, actor=None)


def _decided(session: Session, one: Sample) -> Any:
    _moved(session, one)
    return recordings.decide_drift(session, one.recording.id, "A bird sat on it.", actor=one.olga.id)


def _recording(session: Session, one: Sample) -> Any:
    return samples.add_recording(session, one.survey.id, one.olga.id)


def _no_photograph(session: Session, one: Sample) -> Any:
    made = samples.photograph(session, one)
    return photographs.remove(session, made.id, version=1, actor=one.olga.id)


# name -> (what must be there first, the write itself)
WRITES: dict[str, tuple[Write, Callable[[Session, Sample, Any], Any]]] = {
    "people.create": (lambda s, o: None, lambda s, o, _: samples.person(s, "Ada", "admin")),
    "people.update": (
        lambda s, o: None,
        lambda s, o, _: people.update(s, o.olga.id, name="O.", role="viewer", active=True, actor=o.rene.id),
    ),
    "people.set_password": (
        lambda s, o: None,
        lambda s, o, _: people.set_password(s, o.olga.id, "$argon2", actor=o.olga.id),
    ),
    "people.end_sessions": (
        lambda s, o: None,
        lambda s, o, _: people.end_sessions(s, o.olga.id, actor=o.olga.id),
    ),
    "people.new_link": (lambda s, o: None, lambda s, o, _: people.new_link(s, o.olga.id, actor=o.rene.id)),
    "people.use_link": (
        lambda s, o: people.new_link(s, o.olga.id, actor=None),
        lambda s, o, token: people.use_link(s, token),
    ),
    "surveys.create": (lambda s, o: None, lambda s, o, _: surveys.create(s, name="B", actor=o.olga.id)),
    "surveys.update": (
        lambda s, o: None,
        lambda s, o, _: surveys.update(
            s, o.survey.id, name="C", site="", description="", insets={}, version=1, actor=o.olga.id
        ),
    ),
    "standards.choose": (
        lambda s, o: None,
        lambda s, o, _: standards.choose(s, o.survey.id, [], version=0, actor=o.olga.id),
    ),
    "photographs.add": (lambda s, o: None, lambda s, o, _: samples.photograph(s, o)),
    "photographs.change_caption": (
        samples.photograph,
        lambda s, o, made: photographs.change_caption(s, made.id, "The rig", version=1, actor=o.olga.id),
    ),
    "photographs.order": (
        samples.photograph,
        lambda s, o, made: photographs.order(s, o.survey.id, [made.id], actor=o.olga.id),
    ),
    "photographs.remove": (
        samples.photograph,
        lambda s, o, made: photographs.remove(s, made.id, version=1, actor=o.olga.id),
    ),
    "photographs.restore": (
        _no_photograph,
        lambda s, o, made: photographs.restore(s, made.id, actor=o.olga.id),
    ),
    "cameras.create": (
        lambda s, o: None,
        lambda s, o, _: cameras.create(s, o.survey.id, name="Right", actor=o.olga.id),
    ),
    "cameras.add_image": (lambda s, o: None, lambda s, o, _: _image(s, o)),
    "cameras.set_detection": (_image, lambda s, o, image: _detect(s, image.id, o.olga.id)),
    "cameras.remove_image": (_image, lambda s, o, image: cameras.remove_image(s, image.id, actor=o.olga.id)),
    "cameras.choose_calibration": (
        lambda s, o: None,
        lambda s, o, _: cameras.choose_calibration(s, o.camera.id, o.calibration.id, actor=o.olga.id),
    ),
    "calibrations.add": (
        lambda s, o: None,
        lambda s, o, _: samples.add_calibration(s, o.camera.id, o.olga.id),
    ),
    "recordings.create": (
        lambda s, o: None,
        lambda s, o, _: recordings.create(
            s, o.survey.id, name="b", media_key="k", sha256="0" * 64, size_bytes=1, actor=o.olga.id
        ),
    ),
    "recordings.update": (
        lambda s, o: None,
        lambda s, o, _: recordings.update(s, o.recording.id, {"lighting": "daytime"}, actor=o.olga.id),
    ),
    "recordings.ingested": (
        lambda s, o: None,
        lambda s, o, _: recordings.ingested(s, o.recording.id, samples.facts(), frame_table(), actor=None),
    ),
    "recordings.ingest_failed": (
        lambda s, o: None,
        lambda s, o, _: recordings.ingest_failed(s, o.recording.id, "No video in it.", actor=None),
    ),
    "recordings.restart_ingest": (
        lambda s, o: None,
        lambda s, o, _: recordings.restart_ingest(s, o.recording.id, actor=o.olga.id),
    ),
    "recordings.drift_found": (lambda s, o: None, lambda s, o, _: _moved(s, o)),
    "recordings.decide_drift": (
        _moved,
        lambda s, o, _: recordings.decide_drift(s, o.recording.id, "A bird.", actor=o.olga.id),
    ),
    "recordings.take_back_drift_decision": (
        _decided,
        lambda s, o, _: recordings.take_back_drift_decision(s, o.recording.id, actor=o.olga.id),
    ),
    "recordings.remove": (_recording, lambda s, o, made: recordings.remove(s, made.id, actor=o.olga.id)),
    "uploads.create": (lambda s, o: None, lambda s, o, _: _upload(s, o)),
    "uploads.finish": (
        _upload,
        lambda s, o, up: uploads.finish(s, up.id, recording_id=o.recording.id, actor=o.olga.id),
    ),
    "uploads.strip_arrived": (
        _strip,
        lambda s, o, up: uploads.strip_arrived(s, up.id, media_key="k", sha256="0" * 64, actor=o.olga.id),
    ),
    "uploads.remove": (_upload, lambda s, o, up: uploads.remove(s, up.id, actor=o.olga.id)),
    "poses.add": (
        lambda s, o: None,
        lambda s, o, _: samples.add_pose(s, o.recording.id, o.calibration.id, o.olga.id),
    ),
    "catalogue.add": (
        lambda s, o: None,
        lambda s, o, _: catalogue.add(s, CatalogueRow("Peugeot", "3008", height_m=1.624), actor=o.olga.id),
    ),
    "catalogue.import_rows": (
        lambda s, o: None,
        lambda s, o, _: catalogue.import_rows(
            s, [CatalogueRow("A", "B"), CatalogueRow("A", "C")], actor=o.olga.id
        ),
    ),
    "vehicles.create": (
        lambda s, o: None,
        lambda s, o, _: vehicles.create(
            s, o.recording.id, {"first_frame": 1, "last_frame": 2}, actor=o.olga.id
        ),
    ),
    "vehicles.update": (
        lambda s, o: None,
        lambda s, o, _: vehicles.update(s, o.vehicle.id, {"make": "X"}, version=1, actor=o.olga.id),
    ),
    "vehicles.remove": (lambda s, o: None, lambda s, o, _: vehicles.remove(s, o.vehicle.id, actor=o.olga.id)),
    "vehicles.restore": (
        lambda s, o: vehicles.remove(s, o.vehicle.id, actor=o.olga.id),
        lambda s, o, _: vehicles.restore(s, o.vehicle.id, actor=o.olga.id),
    ),
    "measurements.add": (lambda s, o: None, lambda s, o, _: samples.measure(s, o)),
    "measurements.revise": (
        lambda s, o: samples.measure(s, o),
        lambda s, o, made: measurements.revise(
            s, made.id, seen_revision=1, values=values(o, point=(1.0, 2.0)), actor=o.olga.id
        ),
    ),
    "measurements.withdraw": (
        lambda s, o: samples.measure(s, o),
        lambda s, o, made: measurements.withdraw(s, made.id, seen_revision=1, actor=o.olga.id),
    ),
    "measurements.restore": (
        _withdrawn,
        lambda s, o, made: measurements.restore(s, made.id, seen_revision=2, actor=o.olga.id),
    ),
    "wheel_pairs.add": (lambda s, o: None, lambda s, o, _: _wheels(s, o)),
    "wheel_pairs.withdraw": (
        _wheels,
        lambda s, o, _: wheel_pairs.withdraw(s, o.vehicle.id, actor=o.olga.id),
    ),
    "click_sigmas.choose": (
        lambda s, o: None,
        lambda s, o, _: click_sigmas.choose(
            s, o.survey.id, o.olga.id, sigma_px=0.6, pairs=12, actor=o.rene.id
        ),
    ),
    "reviews.add": (lambda s, o: samples.measure(s, o), _review),
    "exports.add": (
        lambda s, o: None,
        lambda s, o, _: exports.add(
            s, o.survey.id, media_key="z", size_bytes=1, sha256="0" * 64, head=audit.head(s), actor=o.olga.id
        ),
    ),
    "jobs.create": (lambda s, o: None, lambda s, o, _: _job(s, o)),
    "jobs.request_cancel": (_job, lambda s, o, job: jobs.request_cancel(s, job.id, actor=o.olga.id)),
    "jobs.finish": (_claimed, lambda s, o, job: jobs.finish(s, job, {"x": 1})),
    "jobs.fail": (_claimed, lambda s, o, job: jobs.fail(s, job, "It cannot be read.")),
    "jobs.cancelled": (_claimed, lambda s, o, job: jobs.cancelled(s, job)),
    "jobs.requeue": (_claimed, lambda s, o, job: jobs.requeue(s, job)),
    "jobs.release": (_claimed, lambda s, o, job: jobs.release(s, job)),
    **scans_samples.WRITES,
}

# What changes rows but is no act of a person that anybody would look for; the reason stands beside it.
NO_EVENT = {
    "people.seen": "a time stamp of presence",
    "people.rehash_password": "the same password under newer hash parameters",
    "uploads.advance": "bytes that arrive; the upload's beginning and end are events",
    "jobs.claim": "bookkeeping of leases",
    "jobs.renew": "bookkeeping of leases",
    "frames.replace": "part of recordings.ingested",
    "frames.remove": "part of recordings.remove",
    "measurements.append_revision": "writes an event; part of revise, withdraw, restore and reviews.add",
    "audit.record": "is the event",
    "audit.record_many": "is the events",
}
HELPERS = {
    "rows",
    "database",
    "columns",
    "chain",
    "tables",
    "tables_of_work",
    "tables_of_scans",
    "records",
    "words",
    "verification",
}
WRITING = re.compile(
    r"(?<![.\w])(insert|update|sql_update|delete|add_rows?|change_row|_append|_appended|create_many|append_many|_end|_back|_state|_drift_decision)\("
    r"|append_revision\(|audit\.record(_many)?\("
)


@pytest.mark.parametrize("name", WRITES)
def test_a_write_leaves_one_event_in_its_transaction(name: str, factory: database.SessionFactory) -> None:
    """Or nothing, where the transaction was rolled back."""
    prepare, write = WRITES[name]
    with database.writing(factory) as session:
        one = samples.sample(session)
        there = prepare(session, one)
        before = audit.head(session)
    with pytest.raises(ZeroDivisionError), database.writing(factory) as session:
        write(session, one, there)
        raise ZeroDivisionError
    with database.reading(factory) as session:
        assert audit.head(session) == before
        assert audit.verify(session).ok
        ids = session.execute(select(audit_events.c.id)).scalars()
        assert sorted(ids) == list(range(1, before.count + 1))
    with database.writing(factory) as session:
        changes = _count_changes(session)
        write(session, one, there)
        after = audit.head(session)
    assert after.count - before.count == 1
    # the write, the event and the anchor; standards are kept in the event itself
    assert changes["n"] > (1 if name == "standards.choose" else 2)
    with database.reading(factory) as session:
        assert audit.head(session) == after
        assert audit.verify(session).ok


def test_every_public_function_that_writes_is_in_the_list() -> None:
    found = set()
    for module in pkgutil.iter_modules(backend.storage.__path__):
        if module.name in HELPERS:
            continue
        held = import_module(f"backend.storage.{module.name}")
        for name, function in inspect.getmembers(held, inspect.isfunction):
            if name.startswith("_") or function.__module__ != held.__name__:
                continue
            if WRITING.search(inspect.getsource(function).split("\n", 1)[1]):
                found.add(f"{module.name}.{name}")
    assert found - set(NO_EVENT) == set(WRITES)


def test_a_fix_writes_the_revision_and_the_review(factory: database.SessionFactory) -> None:
    with database.writing(factory) as session:
        one = samples.sample(session)
        made = samples.measure(session, one)
        before = audit.head(session).count
        content = values(one, point=(1.0, 2.0))
        reviews.add(session, made.id, seen_revision=1, verdict="fixed", fixed=content, actor=one.rene.id)
        told = [(e.entity, e.action) for e in audit.listing(session, limit=2)]
    assert audit_count(factory) - before == 2
    assert told == [("review", "review"), ("measurement", "fix")]


def audit_count(factory: database.SessionFactory) -> int:
    with database.reading(factory) as session:
        return audit.head(session).count


def _count_changes(session: Session) -> dict[str, int]:
    counted = {"n": 0}

    def count(_c: Any, _cursor: Any, statement: str, *_rest: Any) -> None:
        if statement.lstrip().upper().startswith(("INSERT", "UPDATE", "DELETE")):
            counted["n"] += 1

    event.listen(session.connection(), "before_cursor_execute", count)
    return counted
