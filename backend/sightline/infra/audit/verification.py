"""Finding out whether somebody changed the records behind the program's back.

Every chain is walked (numbers without gap, each hash from the one before; the end that is noted, every head
that a table carries and every signed checkpoint in place), then every row that is written once and
everything that has a fingerprint is hashed again and compared with what its audit event says, and every
record that people change with what its events made of it. Which those are, tables and slices say of
themselves (`vouched`).
"""

from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from sqlalchemy import Engine, Table, inspect, select
from sqlalchemy.orm import Session

from sightline.errors import BadInput, Damaged, SightlineError
from sightline.infra.audit import trail
from sightline.infra.audit.anchors import Anchors
from sightline.infra.audit.checkpoints import CHECKPOINT, SIGN, is_signed
from sightline.infra.audit.guards import require_guards
from sightline.infra.audit.hashing import GENESIS, chain_hash, to_plain_json
from sightline.infra.audit.merkle import root_of
from sightline.infra.audit.records import AnchoredVerification, AuditHead, Verification, survey_chain
from sightline.infra.audit.tables import audit_events
from sightline.infra.audit.vouched import (
    CarriesHead,
    ChangedByEvents,
    Event,
    WrittenOnce,
    fingerprints,
    marked_tables,
)
from sightline.infra.database.engine import (
    engine_at,
    reading,
    session_factory,
    translate_database_errors,
)
from sightline.infra.database.pages import require_whole_pages
from sightline.infra.database.revisions import require_this_version
from sightline.infra.database.rows import row_hash
from sightline.infra.database.types import Saying

Promises = dict[str, dict[int, str]]


class _Problem(SightlineError):
    """The first thing found wrong."""


def verify_records(session: Session, anchors: Anchors | None = None) -> Verification:
    """Check the chains and everything that they vouch for, as one state of the database has it; `anchors`:
    what was kept elsewhere of these chains, for which the answer is an AnchoredVerification.
    """
    state = _Walk()
    try:
        state.chains(session)
        _anchors(session, state)
        _check_rows(session, state)
    except _Problem as problem:
        return Verification(False, state.checked, state.head, problem.said)
    try:
        require_guards(session.connection())
        if not anchors:
            return Verification(True, state.checked, state.head, None)
        vouched = anchors.hold_in_database(state.hashes, state.head)
    except Damaged as damage:
        return Verification(False, state.checked, state.head, damage.said)
    return AnchoredVerification(True, state.checked, state.head, None, vouched)


def verify_database(url: str, name: str = "This address", anchors: Anchors | None = None) -> Verification:
    """The same for a database by its URL, without changing it; `name` is what a refusal calls it.

    Raises BadInput for what is not ours or of another version, Damaged by table, DatabaseAway.
    """
    with engine_at(url, must_exist=True) as engine:
        if not _holds_a_chain(engine):
            raise BadInput("audit-not-a-database", name=name)
        with reading(session_factory(engine)) as session:
            require_this_version(session.connection())
            require_whole_pages(session.connection())
            return verify_records(session, anchors)


def _holds_a_chain(engine: Engine) -> bool:
    try:
        with translate_database_errors():
            return inspect(engine).has_table(audit_events.name)
    except BadInput:
        return False


class _Walk:
    """The state of a walk along the chains: what was checked and what the events promise.

    `hashes`: of every event by chain, that of none first; `checkpoints`: the ends that each signed,
    when, and whether its signature holds.
    """

    def __init__(self) -> None:
        self.checked = 0
        self.head = root_of({})
        self.hashes: dict[str, list[str]] = {}
        self.checkpoints: list[tuple[dict[str, AuditHead], str, bool]] = []
        self.promised: Promises = defaultdict(dict)
        self.fingerprints = fingerprints()
        self.marked = marked_tables()
        self.replayed: dict[str, dict[int, dict[str, Any]]] = {
            mark.entity: {} for mark, _ in self.marked if isinstance(mark, ChangedByEvents)
        }

    def chains(self, session: Session) -> None:
        """Every event of every chain in the order in which they came: number, link and hash."""
        for row in _read_all_rows(session, audit_events):
            hashes = self.hashes.setdefault(row["chain"], [GENESIS])
            if row["number"] != len(hashes):
                raise _Problem("audit-event-missing", number=len(hashes), chain=row["chain"])
            if row["previous_hash"] != hashes[-1] or row["hash"] != chain_hash(dict(row)):
                raise _Problem("audit-event-changed", number=row["number"], chain=row["chain"])
            self.checked += 1
            hashes.append(row["hash"])
            try:
                after = trail.object_of(row["after"]) or {}
                self._note(Event(row["entity"], row["action"], row["entity_id"], row["survey_id"], after))
            except (KeyError, TypeError, ValueError, AttributeError) as error:
                raise _Problem("audit-event-incomplete", number=row["number"], chain=row["chain"]) from error
        self.head = root_of(self.ends())

    def ends(self) -> dict[str, AuditHead]:
        """The end of every chain as it was walked."""
        return {name: AuditHead(len(hashes) - 1, hashes[-1]) for name, hashes in self.hashes.items()}

    def _note(self, event: Event) -> None:
        """What an event says that a row, a record or something with a fingerprint must be."""
        if "content_sha256" in event.after:
            row_id = event.after.get("revision_id", event.entity_id)
            self.promised[event.entity][row_id] = event.after["content_sha256"]
        for fingerprint in self.fingerprints:
            fingerprint.promise(event, self.promised[fingerprint.entity])
        if event.entity in self.replayed:
            self._replay(event, self.replayed[event.entity])
        if (event.entity, event.action) == (CHECKPOINT, SIGN):
            ends = {name: AuditHead(count, hash_) for name, count, hash_ in event.after["ends"]}
            signed = root_of(ends) == event.after["root"] and is_signed(event.after)
            self.checkpoints.append((ends, event.after["at"], signed))

    @staticmethod
    def _replay(event: Event, records: dict[int, dict[str, Any]]) -> None:
        if event.action == "order":
            for position, row_id in enumerate(event.after["order"], start=1):
                records[row_id]["position"] = position
        elif event.entity_id is not None:
            records.setdefault(event.entity_id, {"deleted": False}).update(event.after)


def _anchors(session: Session, walk: _Walk) -> None:
    """Chains, exports and checkpoints remember how long a chain was: a cut tail is shorter."""
    noted, walked = trail.heads(session), walk.ends()
    for name in sorted({*noted, *walked}):
        if noted.get(name) != walked.get(name):
            count = walked[name].count if name in walked else 0
            raise _Problem("audit-chain-ends-elsewhere", chain=name, number=count)
    for mark, table in walk.marked:
        if isinstance(mark, CarriesHead):
            for row in _read_all_rows(session, table):
                chain = survey_chain(row["survey_id"])
                if not _chain_passed_through(walk, chain, row["audit_count"], row["audit_head"]):
                    raise _Problem("audit-chain-not-exported", id=row["id"])
    _checkpoints(walk)


def _chain_passed_through(walk: _Walk, chain: str, count: int, hash_: str) -> bool:
    hashes = walk.hashes.get(chain, [])
    return count < len(hashes) and hashes[count] == hash_


def _checkpoints(walk: _Walk) -> None:
    """Every checkpoint is signed, and each chain still goes through the end that was signed."""
    for ends, at, signed in walk.checkpoints:
        if not signed or not all(
            _chain_passed_through(walk, name, end.count, end.hash) for name, end in ends.items()
        ):
            raise _Problem("audit-chains-not-signed", at=at)


def _check_rows(session: Session, walk: _Walk) -> None:
    """Every row that is written once is still what its event says, and none came or went by itself."""
    for mark, table in walk.marked:
        if isinstance(mark, WrittenOnce):
            stored = ((row["id"], row_hash(row)) for row in _read_all_rows(session, table))
            _compare(walk.promised[mark.entity], mark.entity, stored)
    for fingerprint in walk.fingerprints:
        _compare(walk.promised[fingerprint.entity], fingerprint.entity, fingerprint.stored(session))
    for mark, table in walk.marked:
        if isinstance(mark, ChangedByEvents):
            _changed(session, walk.replayed[mark.entity], mark.entity, table)


def _changed(session: Session, events_by_id: dict[int, dict[str, Any]], entity: str, table: Table) -> None:
    """Every record is what its events made of it, for results are compared with what it says."""
    missing = set(events_by_id)
    sayings = {column.name for column in table.columns if isinstance(column.type, Saying)}
    for row in _read_all_rows(session, table):
        now = {**row, "deleted": row["deleted_at"] is not None}
        events = events_by_id.get(row["id"])
        if events is None or any(
            to_plain_json(now.get(name)) != (to_plain_json(Saying.said(value)) if name in sayings else value)
            for name, value in events.items()
        ):
            raise _Problem("audit-row-not-events", entity=entity, id=row["id"])
        missing.discard(row["id"])
    if missing:
        raise _Problem("audit-row-removed", entity=entity, id=min(missing))


def _compare(promised: dict[int, str], entity: str, stored: Iterator[tuple[int, str]]) -> None:
    missing = set(promised)
    for row_id, content in stored:
        if promised.get(row_id) != content:
            raise _Problem("audit-row-not-first", entity=entity, id=row_id)
        missing.discard(row_id)
    if missing:
        raise _Problem("audit-row-removed", entity=entity, id=min(missing))


def _read_all_rows(session: Session, table: Table) -> Iterator[Any]:
    """Every row by its number; the cursor is closed also where a problem ends the reading."""
    query = select(table).order_by(table.c.id).execution_options(yield_per=1000)
    with session.execute(query) as found:
        yield from found.mappings()
