"""The arithmetic of the audit chain: the text that is hashed and the hashes themselves."""

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from datetime import datetime
from typing import Any

import numpy as np

from sightline.infra.database.types import canonical_json

GENESIS = "0" * 64


_LINKS = ("hash", "previous_hash")


def chain_hash(row: Mapping[str, Any]) -> str:
    """The hash of an event by its row: the previous hash and the hash of its content."""
    return link_hash(str(row["previous_hash"]), event_hash(row))


def link_hash(previous_hash: str, content_sha256: str) -> str:
    """sha256 over both, so that a link can be checked by who may not see its content."""
    return hashlib.sha256((previous_hash + content_sha256).encode()).hexdigest()


def event_hash(row: Mapping[str, Any]) -> str:
    """sha256 over the canonical JSON of an event: all columns but the links of the chain."""
    return content_hash({key: value for key, value in row.items() if key not in _LINKS})


def content_hash(content: Mapping[str, Any]) -> str:
    """sha256 of a row's content, kept in its event so that a later change of the row is seen."""
    return hashlib.sha256(canonical_json(plain(content)).encode()).hexdigest()


def plain(value: Any) -> Any:
    """The value as JSON can hold it: times as ISO text, records as objects, NumPy numbers as numbers."""
    if isinstance(value, datetime):
        return value.isoformat(timespec="microseconds")
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, np.generic):
        return value.item()
    if is_dataclass(value) and not isinstance(value, type):
        return {entry.name: plain(getattr(value, entry.name)) for entry in fields(value)}
    return value
