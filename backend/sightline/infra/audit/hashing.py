"""The arithmetic of the audit chain: the text that is hashed (RFC 8785) and the hashes themselves."""

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from datetime import UTC, datetime
from typing import Any

import numpy as np
import rfc8785

GENESIS = "0" * 64
#: The largest whole number that every reader of JSON holds exactly (RFC 8785, 3.2.2.3; RFC 7493, 2.2).
LARGEST_INTEGER = 2**53 - 1

_UNHASHED = ("id", "hash", "previous_hash")


def chain_hash(row: Mapping[str, Any]) -> str:
    """The hash of an event by its row: the previous hash and the hash of its content."""
    return link_hash(str(row["previous_hash"]), event_hash(row))


def link_hash(previous_hash: str, content_sha256: str) -> str:
    """sha256 over both texts."""
    return hashlib.sha256((previous_hash + content_sha256).encode()).hexdigest()


def event_hash(row: Mapping[str, Any]) -> str:
    """sha256 over the canonical JSON of an event: all columns but the links of the chain and its place in the
    database.
    """
    return content_hash({key: value for key, value in row.items() if key not in _UNHASHED})


def content_hash(content: Mapping[str, Any]) -> str:
    """sha256 of a row's content, kept in its event so that a later change of the row is seen."""
    return hashlib.sha256(canonical_json(content).encode()).hexdigest()


def canonical_json(value: Any) -> str:
    """The one text of a value by RFC 8785 (JSON Canonicalization Scheme), after `plain`.

    Raises ValueError for NaN, infinities, half a surrogate pair and a time without its zone.
    """
    return rfc8785.dumps(plain(value)).decode()


def plain(value: Any) -> Any:
    """The value as JSON can hold it in any language.

    A time is ISO 8601 text in UTC with six decimals; a whole number beyond 2^53 - 1, which many readers would
    round, is its decimal text; a record is an object, a NumPy number a number, a tuple a list.
    """
    if isinstance(value, str | bool | float | None):
        return value.item() if isinstance(value, np.generic) else value
    if isinstance(value, int):
        return value if abs(value) <= LARGEST_INTEGER else str(value)
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, datetime):
        return _utc_text(value)
    if isinstance(value, np.generic):
        return plain(value.item())
    if is_dataclass(value) and not isinstance(value, type):
        return {entry.name: plain(getattr(value, entry.name)) for entry in fields(value)}
    return value


def _utc_text(moment: datetime) -> str:
    if moment.tzinfo is None:
        raise ValueError("a time that is hashed needs its zone")
    return moment.astimezone(UTC).isoformat(timespec="microseconds")
