"""The arithmetic of the audit chain: the text that is hashed and the hashes themselves."""

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from datetime import datetime
from typing import Any

import numpy as np

from backend.storage.columns import canonical_json

GENESIS = "0" * 64


def chain_hash(row: Mapping[str, Any]) -> str:
    """sha256 over the previous hash and the row's canonical JSON (all columns but `hash`)."""
    content = {key: value for key, value in row.items() if key not in ("hash", "previous_hash")}
    return hashlib.sha256((str(row["previous_hash"]) + canonical_json(content)).encode()).hexdigest()


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
