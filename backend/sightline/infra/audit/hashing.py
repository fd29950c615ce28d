"""The arithmetic of the audit chain: the text that is hashed (RFC 8785) and the hashes themselves."""

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from datetime import UTC, datetime
from json.encoder import encode_basestring
from typing import Any

import numpy as np
import rfc8785

from sightline.messages.said import Said

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
    """sha256 over the canonical JSON of an event: all columns but its links and its place in the database."""
    return content_hash({key: value for key, value in row.items() if key not in _UNHASHED})


def content_hash(content: Mapping[str, Any]) -> str:
    """sha256 of a row's content, kept in its event so that a later change of the row is seen."""
    return hashlib.sha256(canonical_json(content).encode()).hexdigest()


def canonical_json(value: Any) -> str:
    """The one text of a value by RFC 8785 (JSON Canonicalization Scheme), after `to_plain_json`.

    Written in one pass, for several of them are made of each click (DECISIONS 81); what is rare is left to
    `rfc8785`, and tests hold every text against it.

    Raises ValueError for NaN, infinities, half a surrogate pair and a time without its zone.
    """
    text = _canonical_text(value)
    text.encode()  # half a surrogate pair is no text
    return text


def _canonical_text(value: Any) -> str:
    written = _WRITTEN.get(type(value))
    return _rare(value) if written is None else written(value)


def _rare(value: Any) -> str:
    """A value of any other type, as what `to_plain_json` makes of it."""
    inner = to_plain_json(value)
    written = _WRITTEN.get(type(inner))
    return rfc8785.dumps(inner).decode() if written is None else written(inner)


def _float_text(number: float) -> str:
    if number.is_integer() and abs(number) <= LARGEST_INTEGER:
        return str(int(number))
    # between these Python writes a fraction as ECMAScript does (RFC 8785, 3.2.2.3)
    return repr(number) if 1e-4 <= abs(number) < LARGEST_INTEGER else rfc8785.dumps(number).decode()


def _integer_text(number: int) -> str:
    return str(number) if abs(number) <= LARGEST_INTEGER else f'"{number}"'


def _list_text(values: Any) -> str:
    return f"[{','.join([_canonical_text(value) for value in values])}]"


def _object_text(value: Any) -> str:
    try:
        ascii_keys = "".join(value).isascii()
    except TypeError:  # keys that are no texts yet
        return _object_text({str(key): inner for key, inner in value.items()})
    keys = sorted(value) if ascii_keys else sorted(value, key=_in_utf_16)
    return f"{{{','.join([f'{encode_basestring(key)}:{_canonical_text(value[key])}' for key in keys])}}}"


def _in_utf_16(key: str) -> bytes:
    """The order of keys (RFC 8785, 3.2.3). Raises ValueError for half a surrogate pair."""
    return key.encode("utf-16be")


_WRITTEN: dict[type, Callable[[Any], str]] = {
    str: encode_basestring,
    bool: lambda value: "true" if value else "false",
    type(None): lambda value: "null",
    int: _integer_text,
    float: _float_text,
    list: _list_text,
    tuple: _list_text,
    dict: _object_text,
}


def to_plain_json(value: Any) -> Any:
    """The value as JSON can hold it in any language.

    A time is ISO 8601 text in UTC with six decimals; a whole number beyond 2^53 - 1, which many readers would
    round, is its decimal text; a record is an object, what is said its code and values, a NumPy number a
    number, a tuple a list.
    """
    if isinstance(value, str | bool | float | None):
        return value.item() if isinstance(value, np.generic) else value
    if isinstance(value, int):
        return value if abs(value) <= LARGEST_INTEGER else str(value)
    if isinstance(value, Mapping):
        return {str(key): to_plain_json(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [to_plain_json(item) for item in value]
    if isinstance(value, datetime):
        return _utc_text(value)
    if isinstance(value, np.generic):
        return to_plain_json(value.item())
    if isinstance(value, Said):
        return value.document
    if is_dataclass(value) and not isinstance(value, type):
        return {entry.name: to_plain_json(getattr(value, entry.name)) for entry in fields(value)}
    return value


def _utc_text(moment: datetime) -> str:
    if moment.tzinfo is None:
        raise ValueError("a time that is hashed needs its zone")
    return moment.astimezone(UTC).isoformat(timespec="microseconds")
