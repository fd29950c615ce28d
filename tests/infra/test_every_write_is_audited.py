"""Every public function of the storage room that writes leaves exactly one event, in its own transaction."""

import inspect
import pkgutil
import re
from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any, get_args

import pytest
from sqlalchemy import event, select
from sqlalchemy.orm import Session

import sightline
from sightline.cameras.calibrations.records import Detection
from sightline.cameras.store import (
    add_calibration_image,
    choose_calibration,
    create_camera,
    remove_calibration_image,
    set_detection,
    update_camera,
)
from sightline.enums import AuditAction, AuditEntity
from sightline.errors import SightlineError
from sightline.export.evidence.store import note_evidence
from sightline.export.store import add_export
from sightline.infra.audit import trail
from sightline.infra.audit.tables import audit_events
from sightline.infra.audit.verification import verify_records
from sightline.infra.audit.vouched import ChangedByEvents, WrittenOnce
from sightline.infra.database.engine import SessionFactory, make_engine, reading, session_factory, writing
from sightline.infra.database.types import metadata
from sightline.infra.jobs.store import (
    claim_job,
    create_job,
    fail_job,
    finish_job,
    job_cancelled,
    postpone_job,
    release_job,
    request_job_cancel,
    requeue_job,
)
from sightline.measurements.again.store import add_computing
from sightline.measurements.click_sigma_store import choose_click_sigma
from sightline.measurements.store import restore_measurement, revise_measurement, withdraw_measurement
from sightline.messages.said import Said
from sightline.people.store import (
    create_sign_in_link,
    end_sessions,
    set_password,
    update_person,
    use_sign_in_link,
)
from sightline.people.token_store import create_api_token, revoke_api_token
from sightline.quality.checks.store import add_wheel_pair, withdraw_wheel_pair
from sightline.recordings.store import (
    change_fact,
    create_recording,
    decide_drift,
    note_ingest_failed,
    note_ingested,
    remove_recording,
    restart_ingest,
    store_drift,
    take_back_drift_decision,
    update_recording,
)
from sightline.recordings.uploads.store import create_upload, finish_upload, remove_upload, strip_arrived
from sightline.results.standards_store import choose_standards
from sightline.reviews.lots.query import get_lot
from sightline.reviews.lots.store import add_decision, add_taking_back, add_verdicts_by_lot
from sightline.reviews.plan_store import choose_review_plan
from sightline.reviews.store import add_review
from sightline.studies.members_store import add_study_member, open_study_to_all, remove_study_member
from sightline.studies.records import StudyFacts
from sightline.studies.store import (
    note_study_job,
    remove_study,
    update_study,
)
from sightline.surveys.members.store import open_survey_to_all, put_member, remove_member
from sightline.surveys.photographs.store import (
    change_photograph_caption,
    order_photographs,
    remove_photograph,
    restore_photograph,
)
from sightline.surveys.store import create_survey, update_survey
from sightline.vehicles.catalogue.records import CatalogueRow
from sightline.vehicles.catalogue.store import (
    add_catalogue_row,
    correct_catalogue_row,
    import_catalogue_rows,
    retire_catalogue_row,
)
from sightline.vehicles.proposing.plan_store import choose_free_plan
from sightline.vehicles.proposing.store import replace_proposals
from sightline.vehicles.store import create_vehicle, remove_vehicle, restore_vehicle, update_vehicle
from tests.conftest import SERVER
from tests.support import samples, scans_samples
from tests.support.kept import PutBack, Shelf
from tests.support.proofs import every
from tests.support.samples import Sample, frame_table, values

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.dialect

Write = Callable[[Session, Sample], Any]


def _token(session: Session, one: Sample) -> Any:
    return create_api_token(session, one.olga.id, name="a", scopes=["read"], days=1)


def _image(session: Session, one: Sample) -> Any:
    detection = Detection(True, None, [[1.0, 2.0]], columns=9, rows=6, sharpness=3.0)
    file: dict[str, Any] = {"name": "a.png", "media_key": "k", "width_px": 640, "height_px": 480}
    return add_calibration_image(session, one.camera.id, **file, detection=detection, actor=one.olga.id)


def _detect(session: Session, image_id: int, actor: int) -> Any:
    detection = Detection(False, "No board.", [], columns=8, rows=5, sharpness=None)
    return set_detection(session, image_id, detection, actor=actor)


def _upload(session: Session, one: Sample) -> Any:
    return create_upload(
        session, one.survey.id, filename="a.mp4", size_bytes=9, media_key="u", actor=one.olga.id
    )


def _strip(session: Session, one: Sample) -> Any:
    file: dict[str, Any] = {"filename": "first.tif", "size_bytes": 9, "media_key": "", "purpose": "strip"}
    return create_upload(session, one.survey.id, **file, actor=one.olga.id)


def _job(session: Session, one: Sample) -> Any:
    return create_job(session, "ingest", {"a": 1}, survey_id=one.survey.id, actor=one.olga.id)


def _claimed(session: Session, one: Sample) -> Any:
    return claim_job(session, _job(session, one).id, worker="w")


def _withdrawn(session: Session, one: Sample) -> Any:
    made = samples.measure(session, one)
    return withdraw_measurement(session, made.id, seen_revision=1, actor=one.olga.id)


def _review(session: Session, one: Sample, made: Any) -> Any:
    return add_review(session, made.id, seen_revision=1, verdict="accepted", actor=one.rene.id)


def _lot(session: Session, one: Sample) -> Any:
    samples.measure(session, one)
    return samples.lot(session, one)


def _accepted_lot(session: Session, one: Sample) -> Any:
    lot = _lot(session, one)
    add_decision(session, lot, "accepted", (), actor=one.rene.id)
    return get_lot(session, lot.id)


def _wheels(session: Session, one: Sample) -> Any:
    crc = int(frame_table().crc32[20])
    points: dict[str, Any] = {"first": (100.0, 400.0), "second": (300.5, 410.0)}
    return add_wheel_pair(session, one.vehicle.id, frame=20, frame_crc32=crc, **points, actor=one.olga.id)


def _moved(session: Session, one: Sample) -> Any:
    spans = [{"first_frame": 50, "last_frame": 99, "moved": True, "moved_px": 3.0, "change_m": 0.01}]
    check = {"state": "moved", "words": [Said("drift-more", count=50)], "bumps": [50], "spans": spans}
    return store_drift(session, one.recording.id, one.pose.id, check, actor=None)


def _decided(session: Session, one: Sample) -> Any:
    _moved(session, one)
    return decide_drift(session, one.recording.id, "A bird sat on it.", actor=one.olga.id)


def _recording(session: Session, one: Sample) -> Any:
    return samples.add_recording(session, one.survey.id, one.olga.id)


def _no_photograph(session: Session, one: Sample) -> Any:
    made = samples.photograph(session, one)
    return remove_photograph(session, made.id, version=1, actor=one.olga.id)


# name -> (what must be there first, the write itself)
WRITES: dict[str, tuple[Write, Callable[[Session, Sample, Any], Any]]] = {
    "create_person": (lambda s, o: None, lambda s, o, _: samples.person(s, "Ada", "admin")),
    "update_person": (
        lambda s, o: None,
        lambda s, o, _: update_person(s, o.olga.id, name="O.", role="viewer", active=True, actor=o.rene.id),
    ),
    "set_password": (
        lambda s, o: None,
        lambda s, o, _: set_password(s, o.olga.id, "$argon2", actor=o.olga.id),
    ),
    "end_sessions": (
        lambda s, o: None,
        lambda s, o, _: end_sessions(s, o.olga.id, actor=o.olga.id),
    ),
    "create_sign_in_link": (
        lambda s, o: None,
        lambda s, o, _: create_sign_in_link(s, o.olga.id, actor=o.rene.id),
    ),
    "use_sign_in_link": (
        lambda s, o: create_sign_in_link(s, o.olga.id, actor=None),
        lambda s, o, token: use_sign_in_link(s, token),
    ),
    "create_api_token": (lambda s, o: None, lambda s, o, _: _token(s, o)),
    "revoke_api_token": (
        lambda s, o: _token(s, o)[0].id,
        lambda s, o, id_: revoke_api_token(s, o.olga.id, id_, actor=o.olga.id),
    ),
    "create_survey": (lambda s, o: None, lambda s, o, _: create_survey(s, name="B", actor=o.olga.id)),
    "update_survey": (
        lambda s, o: None,
        lambda s, o, _: update_survey(s, replace(o.survey, name="C"), actor=o.olga.id),
    ),
    "put_member": (
        lambda s, o: None,
        lambda s, o, _: put_member(s, o.survey.id, o.rene.id, "reviewer", actor=o.olga.id),
    ),
    "remove_member": (
        lambda s, o: put_member(s, o.survey.id, o.rene.id, "reviewer", actor=o.olga.id),
        lambda s, o, _: remove_member(s, o.survey.id, o.rene.id, actor=o.olga.id),
    ),
    "open_survey_to_all": (
        lambda s, o: None,
        lambda s, o, _: open_survey_to_all(s, o.survey.id, True, actor=o.olga.id),
    ),
    "choose_standards": (
        lambda s, o: None,
        lambda s, o, _: choose_standards(s, o.survey.id, [], version=0, actor=o.olga.id),
    ),
    "choose_review_plan": (
        lambda s, o: None,
        lambda s, o, _: choose_review_plan(s, o.survey.id, blind_one_in=3, version=0, actor=o.olga.id),
    ),
    "choose_free_plan": (
        lambda s, o: None,
        lambda s, o, _: choose_free_plan(s, o.survey.id, free_one_in=3, version=0, actor=o.olga.id),
    ),
    "add_photograph": (lambda s, o: None, lambda s, o, _: samples.photograph(s, o)),
    "change_photograph_caption": (
        samples.photograph,
        lambda s, o, made: change_photograph_caption(s, made.id, "The rig", version=1, actor=o.olga.id),
    ),
    "order_photographs": (
        samples.photograph,
        lambda s, o, made: order_photographs(s, o.survey.id, [made.id], actor=o.olga.id),
    ),
    "remove_photograph": (
        samples.photograph,
        lambda s, o, made: remove_photograph(s, made.id, version=1, actor=o.olga.id),
    ),
    "restore_photograph": (
        _no_photograph,
        lambda s, o, made: restore_photograph(s, made.id, actor=o.olga.id),
    ),
    "update_camera": (
        lambda s, o: None,
        lambda s, o, _: update_camera(s, o.camera.id, {"zoom": "28 mm"}, actor=o.olga.id),
    ),
    "create_camera": (
        lambda s, o: None,
        lambda s, o, _: create_camera(s, o.survey.id, name="Right", actor=o.olga.id),
    ),
    "add_calibration_image": (lambda s, o: None, lambda s, o, _: _image(s, o)),
    "set_detection": (_image, lambda s, o, image: _detect(s, image.id, o.olga.id)),
    "remove_calibration_image": (
        _image,
        lambda s, o, image: remove_calibration_image(s, image.id, actor=o.olga.id),
    ),
    "choose_calibration": (
        lambda s, o: None,
        lambda s, o, _: choose_calibration(s, o.camera.id, o.calibration.id, actor=o.olga.id),
    ),
    "add_calibration": (
        lambda s, o: None,
        lambda s, o, _: samples.calibration(s, o.camera.id, o.olga.id),
    ),
    "create_recording": (
        lambda s, o: None,
        lambda s, o, _: create_recording(
            s, o.survey.id, name="b", media_key="k", sha256="0" * 64, size_bytes=1, actor=o.olga.id
        ),
    ),
    "update_recording": (
        lambda s, o: None,
        lambda s, o, _: update_recording(s, o.recording.id, {"lighting": "daytime"}, actor=o.olga.id),
    ),
    "note_ingested": (
        lambda s, o: None,
        lambda s, o, _: note_ingested(s, o.recording.id, samples.facts(), frame_table(), actor=None),
    ),
    "change_fact": (
        lambda s, o: None,
        lambda s, o, _: change_fact(s, o.recording.id, "duration_s", 12.5, actor=None),
    ),
    "note_ingest_failed": (
        lambda s, o: None,
        lambda s, o, _: note_ingest_failed(s, o.recording.id, Said("jobs-cancelled"), actor=None),
    ),
    "restart_ingest": (
        lambda s, o: None,
        lambda s, o, _: restart_ingest(s, o.recording.id, actor=o.olga.id),
    ),
    "store_drift": (lambda s, o: None, lambda s, o, _: _moved(s, o)),
    "decide_drift": (
        _moved,
        lambda s, o, _: decide_drift(s, o.recording.id, "A bird.", actor=o.olga.id),
    ),
    "take_back_drift_decision": (
        _decided,
        lambda s, o, _: take_back_drift_decision(s, o.recording.id, actor=o.olga.id),
    ),
    "remove_recording": (_recording, lambda s, o, made: remove_recording(s, made.id, actor=o.olga.id)),
    "create_upload": (lambda s, o: None, lambda s, o, _: _upload(s, o)),
    "finish_upload": (
        _upload,
        lambda s, o, up: finish_upload(s, up.id, recording_id=o.recording.id, actor=o.olga.id),
    ),
    "strip_arrived": (
        _strip,
        lambda s, o, up: strip_arrived(s, up.id, media_key="k", sha256="0" * 64, actor=o.olga.id),
    ),
    "remove_upload": (_upload, lambda s, o, up: remove_upload(s, up.id, actor=o.olga.id)),
    "add_pose": (
        lambda s, o: None,
        lambda s, o, _: samples.road_pose(s, o.recording.id, o.calibration.id, o.olga.id),
    ),
    "add_catalogue_row": (
        lambda s, o: None,
        lambda s, o, _: add_catalogue_row(
            s, CatalogueRow("Peugeot", "3008", height_m=1.624), actor=o.olga.id
        ),
    ),
    "import_catalogue_rows": (
        lambda s, o: None,
        lambda s, o, _: import_catalogue_rows(
            s, [CatalogueRow("A", "B"), CatalogueRow("A", "C")], actor=o.olga.id
        ),
    ),
    "correct_catalogue_row": (
        lambda s, o: add_catalogue_row(s, CatalogueRow("Audi", "A3"), actor=None),
        lambda s, o, row: correct_catalogue_row(
            s, row.id, CatalogueRow("Audi", "A3", height_m=1.43), version=1, actor=o.olga.id
        ),
    ),
    "retire_catalogue_row": (
        lambda s, o: add_catalogue_row(s, CatalogueRow("Audi", "A3"), actor=None),
        lambda s, o, row: retire_catalogue_row(s, row.id, version=1, retired=True, actor=o.olga.id),
    ),
    "create_vehicle": (
        lambda s, o: None,
        lambda s, o, _: create_vehicle(
            s, o.recording.id, {"first_frame": 1, "last_frame": 2}, actor=o.olga.id
        ),
    ),
    "replace_proposals": (
        lambda s, o: None,
        lambda s, o, _: replace_proposals(s, o.recording.id, o.pose.id, [], actor=o.olga.id),
    ),
    "update_vehicle": (
        lambda s, o: None,
        lambda s, o, _: update_vehicle(s, o.vehicle.id, {"make": "X"}, version=1, actor=o.olga.id),
    ),
    "remove_vehicle": (lambda s, o: None, lambda s, o, _: remove_vehicle(s, o.vehicle.id, actor=o.olga.id)),
    "restore_vehicle": (
        lambda s, o: remove_vehicle(s, o.vehicle.id, actor=o.olga.id),
        lambda s, o, _: restore_vehicle(s, o.vehicle.id, actor=o.olga.id),
    ),
    "add_measurement": (lambda s, o: None, lambda s, o, _: samples.measure(s, o)),
    "revise_measurement": (
        lambda s, o: samples.measure(s, o),
        lambda s, o, made: revise_measurement(s, made, values(o, target_point=(1.0, 2.0)), actor=o.olga.id),
    ),
    "withdraw_measurement": (
        lambda s, o: samples.measure(s, o),
        lambda s, o, made: withdraw_measurement(s, made.id, seen_revision=1, actor=o.olga.id),
    ),
    "restore_measurement": (
        _withdrawn,
        lambda s, o, made: restore_measurement(s, made.id, seen_revision=2, actor=o.olga.id),
    ),
    "add_computing": (
        lambda s, o: None,
        lambda s, o, _: add_computing(s, o.survey.id, [], kind="asked", actor=o.olga.id),
    ),
    "add_lot": (lambda s, o: samples.measure(s, o), lambda s, o, _: samples.lot(s, o)),
    "add_decision": (
        _lot,
        lambda s, o, lot: add_decision(s, lot, "full_inspection", (), actor=o.rene.id),
    ),
    "add_taking_back": (
        _accepted_lot,
        lambda s, o, lot: add_taking_back(s, lot, lot.decision, 0, actor=o.rene.id),
    ),
    "add_verdicts_by_lot": (
        _lot,
        lambda s, o, lot: add_verdicts_by_lot(
            s, lot, "accepted", [(1, 1, o.vehicle.id)], then="to_review", actor=o.rene.id
        ),
    ),
    "add_wheel_pair": (lambda s, o: None, lambda s, o, _: _wheels(s, o)),
    "withdraw_wheel_pair": (
        _wheels,
        lambda s, o, _: withdraw_wheel_pair(s, o.vehicle.id, actor=o.olga.id),
    ),
    "choose_click_sigma": (
        lambda s, o: None,
        lambda s, o, _: choose_click_sigma(
            s, o.survey.id, o.olga.id, sigma_px=0.6, pairs=12, actor=o.rene.id
        ),
    ),
    "add_review": (lambda s, o: samples.measure(s, o), _review),
    "add_export": (
        lambda s, o: None,
        lambda s, o, _: add_export(
            s,
            o.survey.id,
            media_key="z",
            size_bytes=1,
            sha256="0" * 64,
            head=trail.head(s, o.survey.id),
            actor=o.olga.id,
        ),
    ),
    "note_evidence": (
        scans_samples.vehicle,
        lambda s, o, made: note_evidence(s, made.id, {"sha256": "0" * 64}, actor=o.olga.id),
    ),
    "create_study": (lambda s, o: None, lambda s, o, _: samples.study(s, o)),
    "update_study": (
        samples.study,
        lambda s, o, study: update_study(s, study.id, StudyFacts("Hills 2"), version=1, actor=o.olga.id),
    ),
    "remove_study": (
        samples.study,
        lambda s, o, study: remove_study(s, study.id, version=1, actor=o.olga.id),
    ),
    "note_study_job": (
        lambda s, o: (samples.study(s, o), _job(s, o)),
        lambda s, o, both: note_study_job(s, both[0].id, both[1].id, actor=o.olga.id),
    ),
    "add_study_member": (
        samples.study,
        lambda s, o, study: add_study_member(s, study.id, o.rene.id, actor=o.olga.id),
    ),
    "remove_study_member": (
        samples.study_with_member,
        lambda s, o, study: remove_study_member(s, study.id, o.rene.id, actor=o.olga.id),
    ),
    "open_study_to_all": (
        samples.study,
        lambda s, o, study: open_study_to_all(s, study.id, True, actor=o.olga.id),
    ),
    "add_study_result": (samples.study, lambda s, o, study: samples.result_of_study(s, o, study)),
    "create_job": (lambda s, o: None, lambda s, o, _: _job(s, o)),
    "request_job_cancel": (_job, lambda s, o, job: request_job_cancel(s, job.id, actor=o.olga.id)),
    "finish_job": (_claimed, lambda s, o, job: finish_job(s, job, {"x": 1})),
    "fail_job": (
        _claimed,
        lambda s, o, job: fail_job(s, job, SightlineError("said", sentence="It cannot be read.")),
    ),
    "job_cancelled": (_claimed, lambda s, o, job: job_cancelled(s, job)),
    "requeue_job": (_claimed, lambda s, o, job: requeue_job(s, job)),
    "release_job": (_claimed, lambda s, o, job: release_job(s, job)),
    "postpone_job": (_claimed, lambda s, o, job: postpone_job(s, job)),
    **scans_samples.WRITES,
}

# What changes rows but is no act of a person that anybody would look for; the reason stands beside it.
NO_EVENT = {
    "note_api_token_used": "a time stamp of presence",
    "count_against": "tries that are counted, gone within the hour",
    "count_tried": "tries that are counted, gone within the hour",
    "forget_counted": "tries that count no more",
    "uncount": "a try that counts no more",
    "note_person_seen": "a time stamp of presence",
    "rehash_password": "the same password under newer hash parameters",
    "claim_job": "which worker process has it",
    "note_progress": "how far it is",
    "replace_frames": "part of recordings.ingested",
    "remove_frames": "part of recordings.remove",
    "change_times": "part of recordings.ingested, whose event holds the frame table's fingerprint",
    "state_filming_rate": "writes an event, before the one of restart_ingest",
    "append_measurement_revision": "writes an event; part of revise, withdraw, restore and reviews.add",
    "written_once": "writes an event; part of every write of what is written once",
    "append_computed_again": "writes an event of each, after the one of add_computing",
    "append_revision": "writes an event; part of adding, revising, withdrawing and restoring",
    "note_key": "the key of the request that an event came by; part of record",
    "keep_answers": "what a request was answered, for its repeats; gone within days",
    "forget_old_keys": "requests that are not sent again any more",
    "record": "is the event",
    "hold_chain_end": "begins a chain; part of record",
    "record_many": "is the events",
    "add_live_scan": "beside the event of create_scan",
    "hear_live_scan": "how a stream is now, every second; what it recorded is an event at its end",
    "end_live_scan": "beside the event of note_scan_recorded",
    "seal_package": "is the event that a package ends with",
}
WRITING = re.compile(
    r"(?<![.\w])(insert|update|sql_update|delete|add_rows?|change_row|written_once|make_rows|alter_row|take_out_row|bring_back_row|_write|_note|_append|_appended|create_scan_vehicles|append_scan_measurements|_end|_put_back|_state|choice\.choose|_PLAN\.choose)\("
    r"|append_measurement_revision\(|trail\.record(_many)?\(|_add_decision\("
)


# What events tell besides the columns of their row, as the formats say, by entity.
_SECTION = (ROOT / "docs" / "formats.md").read_text("utf-8").split("| entity | keys | meaning |")[1]
TOLD_BESIDE = defaultdict[str, set[str]](set)
for _entities, _keys in re.findall(r"^\| ([^|]+) \| (`[^|]+) \|", _SECTION.split("\n\n")[0], re.M):
    for _entity in re.findall(r"\w+", _entities):
        TOLD_BESIDE[_entity].update(re.findall(r"\w+", _keys))


def _fill(url: str) -> Sample:
    engine = make_engine(url)
    with writing(session_factory(engine)) as session:
        one = samples.sample(session)
    engine.dispose()
    return one


@pytest.fixture(scope="module")
def sampled(shelf: Shelf) -> tuple[Sample, PutBack]:
    return shelf.keep(_fill)


@pytest.fixture
def one(sampled: tuple[Sample, PutBack], database_url: str) -> Sample:
    """The sample, which the database holds."""
    made, put_back = sampled
    put_back(database_url)
    return made


# What a function writes beside its transaction it writes on any database; the end is verified on each.
VERIFIED = [False, pytest.param(True, marks=pytest.mark.proof)] if SERVER else [True]


@pytest.mark.parametrize("undone_is_verified", VERIFIED)
@pytest.mark.parametrize("name", every(3 if SERVER else 1, WRITES))
def test_a_write_leaves_one_event_in_its_transaction(
    name: str, undone_is_verified: bool, one: Sample, factory: SessionFactory
) -> None:
    """Or nothing, where the transaction was rolled back."""
    prepare, write = WRITES[name]
    with writing(factory) as session:
        there = prepare(session, one)
        before = trail.head(session)
    with pytest.raises(ZeroDivisionError), writing(factory) as session:
        write(session, one, there)
        raise ZeroDivisionError
    with reading(factory) as session:
        assert trail.head(session) == before
        assert not undone_is_verified or verify_records(session).ok
        for chain, end in trail.heads(session).items():
            numbers = session.execute(select(audit_events.c.number).where(audit_events.c.chain == chain))
            assert sorted(numbers.scalars()) == list(range(1, end.count + 1))
    with writing(factory) as session:
        changes = _count_changes(session)
        write(session, one, there)
        after = trail.head(session)
    assert after.count - before.count == 1
    with reading(factory) as session:
        (told,) = trail.listing(session, limit=1)
        named = _columns()[told.entity] | TOLD_BESIDE["every"] | TOLD_BESIDE[told.entity]
        assert {*(told.before or ()), *(told.after or ())} <= named
    # the write, the event and the anchor; what is kept in the event itself has no other write
    in_event = ("choose_standards", "choose_review_plan", "choose_free_plan", "note_evidence")
    assert changes["n"] > (1 if name in in_event else 2)
    with reading(factory) as session:
        assert trail.head(session) == after
        assert verify_records(session).ok


def _columns() -> Mapping[str, set[str]]:
    """The columns of the tables whose rows an entity's events make, by entity."""
    found = defaultdict[str, set[str]](set)
    for table in metadata.tables.values():
        mark = table.info.get("vouched")
        marked = isinstance(mark, WrittenOnce | ChangedByEvents)
        found[mark.entity if marked else table.name.removesuffix("s")] |= {*table.columns.keys()}
    return found


def test_every_public_function_that_writes_is_in_the_list() -> None:
    found = set()
    for module in pkgutil.walk_packages(sightline.__path__, "sightline."):
        if not re.search(r"(^|[._])(store|query)$|\.trail$", module.name):
            continue
        held = import_module(module.name)
        for name, function in inspect.getmembers(held, inspect.isfunction):
            if name.startswith("_") or function.__module__ != held.__name__:
                continue
            if WRITING.search(inspect.getsource(function).split("\n", 1)[1]):
                found.add(name)
    assert found - set(NO_EVENT) == set(WRITES)


def test_a_fix_writes_the_revision_and_the_review(factory: SessionFactory) -> None:
    with writing(factory) as session:
        one = samples.sample(session)
        made = samples.measure(session, one)
        before = trail.head(session).count
        content = values(one, target_point=(1.0, 2.0))
        add_review(session, made.id, seen_revision=1, verdict="fixed", fixed=content, actor=one.rene.id)
        told = [(e.entity, e.action) for e in trail.listing(session, limit=2)]
    assert audit_count(factory) - before == 2
    assert told == [("review", "review"), ("measurement", "fix")]


def audit_count(factory: SessionFactory) -> int:
    with reading(factory) as session:
        return trail.head(session).count


def _count_changes(session: Session) -> dict[str, int]:
    counted = {"n": 0}

    def count(_c: Any, _cursor: Any, statement: str, *_rest: Any) -> None:
        # PostgreSQL's statement of an event moves the end of its chain too
        counted["n"] += len(re.findall(r"\b(?:INSERT INTO|UPDATE \w+ SET|DELETE FROM)\b", statement))

    event.listen(session.connection(), "before_cursor_execute", count)
    return counted


def test_every_word_of_events_is_said() -> None:
    said = (ROOT / "backend" / "sightline" / "messages" / "en.ftl").read_text("utf-8")
    assert {*re.findall(r"^audit-entity-(\w+) =", said, re.M)} == {*get_args(AuditEntity)}
    assert {*re.findall(r"^audit-action-(\w+) =", said, re.M)} == {*get_args(AuditAction)}
