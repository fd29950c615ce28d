"""What a template is given as JSON: records and rows as they are, sayings in words, every text fit to be set.

People's words travel as JSON strings and are set as text, so that no character in them means anything.
"""

import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from datetime import date
from typing import Any, TypeAlias

import numpy as np

from sightline.export.report.fonts import without_lacking
from sightline.export.report.said import day_parts, sentence_of_said
from sightline.messages.said import Said

Values: TypeAlias = dict[str, Any]

_LONG_RUN = re.compile(r"[!-~\u00c0-\u024f]{19,}")
_STEP = 9
_BREAK = "\u200b"  # where a line may end; the template takes it out
_TURNS = {"LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"}


def make_settable(value: Any) -> Any:
    """The value as JSON has it: a record by its fields but for arrays, a day or moment by its parts (by its
    own clock), with every text in it, but for the keys, as `settable_text` makes it.
    """
    if isinstance(value, str | Said):
        return settable_text(sentence_of_said(value) if isinstance(value, Said) else value)
    if isinstance(value, date):
        return {**day_parts(value), "time": f"{value:%H:%M}", "second": f"{value:%H:%M:%S}"}
    if is_dataclass(value):
        names = (one.name for one in fields(value))
        return {name: _field(getattr(value, name)) for name in names}
    if isinstance(value, Mapping):
        return {str(key): make_settable(each) for key, each in value.items()}
    if isinstance(value, Sequence):
        return [make_settable(each) for each in value]
    return value


def _field(value: Any) -> Any:
    return None if isinstance(value, np.ndarray) else make_settable(value)


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
