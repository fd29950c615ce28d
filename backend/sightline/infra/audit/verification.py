"""Finding out whether somebody changed the records behind the program's back.

The chain is walked (ids without gap, each hash from the one before, the anchor and every export's head in
place), then every row that is written once (revisions, reviews, calibrations, poses) and every frame table
is hashed again and compared with what its audit event says, and every vehicle record, line-scan recording
and photograph with what its events made of it.
"""

import json
from collections.abc import Iterator
from typing import Any

from sqlalchemy import Engine, Table, inspect, select
from sqlalchemy.exc import DatabaseError, OperationalError
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.tables import calibrations
from sightline.errors import BadInput
from sightline.export.tables import exports
from sightline.infra.audit.hashing import GENESIS, chain_hash, plain
from sightline.infra.audit.records import Verification
from sightline.infra.audit.tables import audit_anchor, audit_events
from sightline.infra.database.engine import (
    explanation,
    lock_chain,
    make_engine,
    newest_revision,
    reading,
    session_factory,
    stored_revision,
)
from sightline.infra.database.rows import row_hash
from sightline.measurements.tables import click_sigmas, measurement_series, measurements
from sightline.poses.tables import road_poses
from sightline.quality.checks.tables import wheel_pairs
from sightline.recordings.frames.store import frame_table_fingerprint, get_frame_table
from sightline.recordings.tables import recordings
from sightline.reviews.tables import reviews
from sightline.scans.heights.tables import line_heights, line_poses
from sightline.scans.tables import scan_measurements, scan_reviews, scan_runs, scan_vehicles, scans
from sightline.surveys.photographs.tables import survey_photographs
from sightline.vehicles.tables import vehicles

Promises = dict[tuple[str, int], str]

# Records that people change: each must be what its events, one after the other, made of it.
_CHANGED: dict[str, tuple[str, Table]] = {
    "vehicle": ("vehicle", vehicles),
    "scan": ("line-scan recording", scans),
    "scan_vehicle": ("scanned vehicle", scan_vehicles),
    "photograph": ("photograph of the set-up", survey_photographs),
}


class _Problem(Exception):
    """The first thing found wrong, as one sentence."""


def verify_records(session: Session) -> Verification:
    """Check the chain and everything that it vouches for; writers wait meanwhile on PostgreSQL."""
    lock_chain(session)
    state = _Walk()
    try:
        state.chain(session)
        _anchors(session, state)
        _rows(session, state)
    except _Problem as problem:
        return Verification(False, state.checked, state.head, str(problem))
    return Verification(True, state.checked, state.head, None)


def verify_database(url: str, name: str = "This address") -> Verification:
    """The same for a database by its URL, without changing it; `name` is what a refusal calls it.

    Raises BadInput for what is not ours or of another version, DatabaseAway.
    """
    engine = make_engine(url, must_exist=True)
    try:
        if not _holds_a_chain(engine):
            raise BadInput(f"{name} is not a Sightline database; name the sightline.db of a data folder.")
        with reading(session_factory(engine)) as session:
            _require_version(session)
            return verify_records(session)
    finally:
        engine.dispose()


def _require_version(session: Session) -> None:
    """Raises BadInput for a database of another version, whose tables are others."""
    if stored_revision(session.connection()) != newest_revision():
        raise BadInput(
            "This database was made by another version; verify it with that one, or open it once with this "
            "one (`sightline serve`), which brings it up to date."
        )


def _holds_a_chain(engine: Engine) -> bool:
    try:
        return inspect(engine).has_table(audit_events.name)
    except OperationalError as error:
        raise explanation(error) from error
    except DatabaseError:
        return False


class _Walk:
    """The state of a walk along the chain: what was checked and what the events promise."""

    def __init__(self) -> None:
        self.checked = 0
        self.head = GENESIS
        self.hashes: list[str] = [GENESIS]
        self.promised: Promises = {}
        self.told: dict[str, dict[int, dict[str, Any]]] = {entity: {} for entity in _CHANGED}

    def chain(self, session: Session) -> None:
        """Every event in order: number, link and hash."""
        query = select(audit_events).order_by(audit_events.c.id).execution_options(yield_per=1000)
        for row in session.execute(query).mappings():
            expected = self.checked + 1
            if row["id"] != expected:
                raise _Problem(f"Audit event {expected} is missing; restore the database from a backup.")
            if row["previous_hash"] != self.head or row["hash"] != chain_hash(dict(row)):
                raise _Problem(f"Audit event {row['id']} was changed after it was written; restore a backup.")
            self.checked, self.head = row["id"], row["hash"]
            self.hashes.append(row["hash"])
            self._promise(row)

    def _promise(self, row: Any) -> None:
        after = _object(row["after"])
        if "content_sha256" in after:
            row_id = after["revision_id"] if row["entity"] == "measurement" else row["entity_id"]
            self.promised[(row["entity"], row_id)] = after["content_sha256"]
        if "frames_sha256" in after:
            self.promised[("frames", row["entity_id"])] = after["frames_sha256"]
        if (row["entity"], row["action"]) == ("photograph", "order"):
            for position, one in enumerate(after["order"], start=1):
                self.told["photograph"][one]["position"] = position
        elif row["entity"] in _CHANGED:
            self.told[row["entity"]].setdefault(row["entity_id"], {"deleted": False}).update(after)
        if (row["entity"], row["action"]) == ("measurement", "create"):
            place = {"survey_id": row["survey_id"], "vehicle_id": after["vehicle_id"]}
            place["repeat_of"] = after.get("repeat_of")
            self.promised[("series", row["entity_id"])] = str(sorted(place.items()))
        if (row["entity"], row["action"]) == ("recording", "delete"):
            self.promised.pop(("frames", row["entity_id"]), None)


def _object(text: str | None) -> dict[str, Any]:
    """The JSON object of an event's text, empty where there is none."""
    return {} if text is None else dict(json.loads(text))


def _anchors(session: Session, walk: _Walk) -> None:
    """The anchor and every export remember how long the chain was: a cut tail is shorter."""
    anchor = session.execute(select(audit_anchor)).mappings().one_or_none()
    if anchor is None or (anchor["count"], anchor["hash"]) != (walk.checked, walk.head):
        raise _Problem(
            f"The audit chain ends at event {walk.checked}, which is not where it ended; restore a backup."
        )
    for row in session.execute(select(exports).order_by(exports.c.id)).mappings():
        count = row["audit_count"]
        if count > walk.checked or walk.hashes[count] != row["audit_head"]:
            raise _Problem(f"The audit chain is not the one in export {row['id']}; restore a backup.")


def _rows(session: Session, walk: _Walk) -> None:
    """Every row that is written once is still what its event says, and none came or went by itself."""
    kept: tuple[tuple[str, str, Table], ...] = (
        ("measurement", "measurement revision", measurements),
        ("review", "review", reviews),
        ("calibration", "calibration", calibrations),
        ("pose", "road pose", road_poses),
        ("wheel_pair", "pair of tyre contacts", wheel_pairs),
        ("click_sigma", "click sigma", click_sigmas),
        ("scan_run", "run over a line-scan recording", scan_runs),
        ("scan_measurement", "scanned vehicle's measurement", scan_measurements),
        ("scan_review", "scanned vehicle's review", scan_reviews),
        ("line_pose", "calibration of a line camera", line_poses),
        ("line_height", "scanned vehicle's height", line_heights),
    )
    for entity, words, table in kept:
        found = ((row["id"], row_hash(row)) for row in _all(session, table))
        _compare(walk.promised, entity, words, found)
    _compare(walk.promised, "series", "measurement", _series(session))
    _compare(walk.promised, "frames", "frame table of recording", _frame_tables(session))
    for entity, (words, table) in _CHANGED.items():
        _changed(session, walk.told[entity], words, table)


def _changed(session: Session, told: dict[int, dict[str, Any]], words: str, table: Table) -> None:
    """Every record is what its events made of it, for results are compared with what it says."""
    missing = set(told)
    for row in _all(session, table):
        now = {**row, "deleted": row["deleted_at"] is not None}
        events = told.get(row["id"])
        if events is None or any(plain(now.get(name)) != value for name, value in events.items()):
            raise _Problem(f"The {words} {row['id']} is not what its events say; restore a backup.")
        missing.discard(row["id"])
    if missing:
        raise _Problem(f"The {words} {min(missing)} was removed behind the program's back; restore a backup.")


def _compare(promised: Promises, entity: str, words: str, found: Iterator[tuple[int, str]]) -> None:
    missing = {row_id for kind, row_id in promised if kind == entity}
    for row_id, content in found:
        if promised.get((entity, row_id)) != content:
            raise _Problem(f"The {words} {row_id} is not what was written at first; restore a backup.")
        missing.discard(row_id)
    if missing:
        raise _Problem(f"The {words} {min(missing)} was removed behind the program's back; restore a backup.")


def _all(session: Session, table: Table) -> Iterator[Any]:
    query = select(table).order_by(table.c.id).execution_options(yield_per=1000)
    return iter(session.execute(query).mappings())


def _series(session: Session) -> Iterator[tuple[int, str]]:
    for row in _all(session, measurement_series):
        place = {name: row[name] for name in ("survey_id", "vehicle_id", "repeat_of")}
        yield row["id"], str(sorted(place.items()))


def _frame_tables(session: Session) -> Iterator[tuple[int, str]]:
    query = select(recordings.c.id).where(
        recordings.c.frame_count.is_not(None), recordings.c.deleted_at.is_(None)
    )
    for recording_id in session.execute(query.order_by(recordings.c.id)).scalars().all():
        yield recording_id, frame_table_fingerprint(get_frame_table(session, recording_id))
