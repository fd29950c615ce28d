"""What of a text can be set: the template's values with every string made fit for it.

People's words travel as JSON strings and are set as text, so that no character in them means anything.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from sightline.export.report.fonts import without_lacking

Json: TypeAlias = "bool | int | str | Sequence[Json] | Mapping[str, Json] | None"
Values: TypeAlias = dict[str, Json]

_LONG_RUN = re.compile(r"[!-~\u00c0-\u024f]{19,}")
_STEP = 9
_BREAK = "\u200b"  # where a line may end; the template takes it out
_TURNS = {"LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"}


def settable(value: Json) -> Json:
    """The value with every text in it, but for the keys, as `settable_text` makes it."""
    if isinstance(value, str):
        return settable_text(value)
    if isinstance(value, Mapping):
        return {key: settable(each) for key, each in value.items()}
    if isinstance(value, Sequence):
        return [settable(each) for each in value]
    return value


def settable_text(words: str) -> str:
    """Without controls, half characters or turns of direction; long runs may be broken."""
    kept = "".join(_settable(character) for character in words.replace("\r\n", "\n"))
    return _LONG_RUN.sub(_breakable, without_lacking(kept))


def _settable(character: str) -> str:
    kind = unicodedata.category(character)
    if kind == "Cs":
        return "\ufffd"
    if kind == "Cc" and character != "\n":
        return " "
    return "" if unicodedata.bidirectional(character) in _TURNS else character


def _breakable(match: re.Match[str]) -> str:
    run = match.group()
    return _BREAK.join(run[k : k + _STEP] for k in range(0, len(run), _STEP))
