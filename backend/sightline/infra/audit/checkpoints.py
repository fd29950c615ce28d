"""Checkpoints: the ends of all audit chains at one moment, signed with the installation's key.

A checkpoint is an event of the settings' chain and holds every end; a package carries its own chain's leaf,
the path to the root, the signature, and how each key was handed on to the next.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Final

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.errors import Damaged, NotFound
from sightline.infra.audit import trail
from sightline.infra.audit.merkle import path_of, root_by_path, root_of
from sightline.infra.audit.records import AuditEvent, AuditHead, Checkpoint, Checkpoints
from sightline.infra.audit.signing import SigningKey, signature_holds
from sightline.infra.audit.tables import audit_events
from sightline.infra.by_name import record_of
from sightline.infra.database.types import now

CHECKPOINT: Final = "checkpoint"
SIGN: Final = "sign"
KEY: Final = "signing_key"
TAKE: Final = "take"
FORMAT, KEY_FORMAT = "sightline-checkpoint-1", "sightline-key-1"
_STATEMENT = ("format", "at", "chains", "root", "key")
_KEY_STATEMENT = ("format", "at", "key", "after")
#: The parts of how a key was handed on, in their order.
KEY_PARTS = (*_KEY_STATEMENT, "signature")
#: The parts of a package's checkpoint, in their order.
_PARTS = (*_STATEMENT, "signature", "leaf", "place", "path", "keys")


def sign_checkpoint(session: Session, key: SigningKey, *, actor: int | None) -> JsonObject:
    """Sign the ends of all chains as this transaction sees them; noted in the settings' chain."""
    take_key(session, key, actor=actor)
    ends = trail.heads(session)
    moment = now().isoformat(timespec="microseconds")
    statement = {"format": FORMAT, "at": moment, "chains": len(ends), "root": root_of(ends)}
    statement["key"] = key.public
    signed = {**statement, "signature": key.sign(statement)}
    listed = [[name, end.count, end.hash] for name, end in ends.items()]
    trail.record(session, actor, SIGN, CHECKPOINT, None, None, None, {**signed, "ends": listed})
    return {**signed, "ends": listed}


def listed_checkpoints(session: Session, limit: int) -> Checkpoints:
    """The newest checkpoints, those of exports among them, and the key that signs now."""
    keys = known_keys(session)
    found = trail.listing(session, entity=CHECKPOINT, limit=limit)
    return Checkpoints(
        key=keys[-1]["key"] if keys else None,
        keys_before=max(0, len(keys) - 1),
        newest=tuple(_checkpoint_of(event) for event in found),
    )


def checkpoint_document(session: Session, event_id: int) -> JsonObject:
    """A checkpoint whole, with every key and how each was handed on, as `sightline checkpoint` writes it.

    Raises:
        NotFound: no checkpoint has this number.
    """
    event = trail.one_event(session, CHECKPOINT, event_id)
    if event is None:
        raise NotFound("audit-checkpoint-none")
    return {**(event.after or {}), "keys": known_keys(session)}


def _checkpoint_of(event: AuditEvent) -> Checkpoint:
    signed = event.after or {}
    events = sum(count for _, count, _ in signed["ends"])
    return record_of(Checkpoint, signed, id=event.id, at=event.at, by=event.actor, events=events)


def is_signed(checkpoint: Mapping[str, Any]) -> bool:
    """Whether a checkpoint carries its key's signature."""
    statement = {name: checkpoint[name] for name in _STATEMENT}
    return signature_holds(statement, str(checkpoint["key"]), str(checkpoint["signature"]))


def checkpoint_of_chain(session: Session, checkpoint: Mapping[str, Any], chain: str) -> JsonObject:
    """What a package of this chain says of a checkpoint: enough to check it, and nothing of other chains."""
    ends = {name: AuditHead(count, hash_) for name, count, hash_ in checkpoint["ends"]}
    place, path = path_of(ends, chain)
    signed = {name: value for name, value in checkpoint.items() if name != "ends"}
    leaf = {"chain": chain, "count": ends[chain].count, "hash": ends[chain].hash}
    return {**signed, "leaf": leaf, "place": place, "path": path, "keys": known_keys(session)}


def checkpoint_problem(document: Mapping[str, Any], chain: str, end: AuditHead) -> Damaged | None:
    """Why a package's checkpoint does not vouch for the end of its chain; None where it does."""
    try:
        leaf = {"chain": chain, "count": end.count, "hash": end.hash}
        if not _is_whole(document) or tuple(document) != _PARTS:
            return Damaged("export-checkpoint-form")
        if document["format"] != FORMAT or not is_signed(document):
            return Damaged("export-checkpoint-signature")
        found = root_by_path(chain, end, document["place"], document["chains"], document["path"])
        lower = all(step == step.lower() for step in document["path"])
        if document["leaf"] != leaf or found != document["root"] or not lower:
            return Damaged("export-checkpoint-other-chain")
        return None if are_handed_on(document["keys"], document["key"]) else Damaged("export-checkpoint-keys")
    except (KeyError, TypeError, ValueError):
        return Damaged("export-checkpoint-form")


def _is_whole(value: Any) -> bool:
    """Whether every number is written as a whole one: 8.0 counts as 8, true as 1, in other bytes."""
    if isinstance(value, Mapping):
        return all(_is_whole(one) for one in value.values())
    if isinstance(value, list | tuple):
        return all(_is_whole(one) for one in value)
    return not isinstance(value, float | bool)


def are_handed_on(keys: Sequence[Mapping[str, Any]], last: str) -> bool:
    """Whether each key was signed by the one before, the first by itself, and the last is this one."""
    before: str | None = None
    for key in keys:
        if tuple(key) != KEY_PARTS or key["format"] != KEY_FORMAT:
            return False
        statement = {name: key[name] for name in _KEY_STATEMENT}
        by = key["key"] if before is None else before
        if key["after"] != before or not signature_holds(statement, by, key["signature"]):
            return False
        before = key["key"]
    return before == last


def known_keys(session: Session) -> list[JsonObject]:
    """Every key that this installation signed with, oldest first, each signed by the one before."""
    e = audit_events.c
    query = select(e.after).where(e.entity == KEY).order_by(e.id)
    found = [trail.object_of(text) or {} for text in session.execute(query).scalars()]
    return [{name: one[name] for name in KEY_PARTS} for one in found]


def hand_on(session: Session, old: SigningKey, new: SigningKey, *, actor: int | None) -> None:
    """From now on another key signs; the old one says so."""
    take_key(session, old, actor=actor)
    _append_key(session, new.public, old.public, old, actor)


def take_key(session: Session, key: SigningKey, *, actor: int | None) -> None:
    """The first key is noted. Raises Damaged for one that no key before it handed on to."""
    known = known_keys(session)
    if not known:
        _append_key(session, key.public, None, key, actor)
    elif known[-1]["key"] != key.public:
        raise Damaged("audit-signing-key-another")


def _append_key(session: Session, key: str, after: str | None, by: SigningKey, actor: int | None) -> None:
    moment = now().isoformat(timespec="microseconds")
    statement = {"format": KEY_FORMAT, "at": moment, "key": key, "after": after}
    signed = {**statement, "signature": by.sign(statement)}
    trail.record(session, actor, TAKE, KEY, None, None, None, signed)
