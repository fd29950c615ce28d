"""Sentences that are kept in English, found again in the catalogue and said in another language.

Answers, packages and the audit chain hold sentences of the program as they were written, in English, and what
is stored stays so. Their patterns stand in the catalogue under KEYS, most of which begin with "told-"; a
sentence that one of them makes, sign for sign, is said by that key in the language asked for. What none makes
stays. What the columns of a package mean stands apart, under COLUMNS: much of it are words that a person
may have typed.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from sightline import messages

if TYPE_CHECKING:
    from fluent.syntax import ast as ftl

#: Those of tables that are imported are made by their key and sent as text, each of one line and without a
#: choice.
KEYS = ("told-", "csv-")
#: Meanings of the columns that a package's page explains.
COLUMNS = ("column-",)
_NUMBER = re.compile(r"-?\d+(?:\.(\d+))?")
_QUANTITY = re.compile(r"[-+±]?\d+\.\d+\W{0,2}[A-Za-z°%]{0,3}")
_NEXT_SENTENCE = re.compile(r"(?<=[.!?]) (?=[A-Z±\d])")


@dataclass(frozen=True)
class _Known:
    key: str
    pattern: re.Pattern[str]
    literal: int


def translated(text: str, language: str) -> str:
    """The sentence, or each of several, in a language; as it is where the catalogue does not make it."""
    if language == messages.SOURCE or not re.search("[A-Za-z]", text):
        return text
    return _said(text, language) or text


def translated_meaning(meaning: str, language: str) -> str:
    """What a column means, in a language; as it is where no page explains that column."""
    return meaning if language == messages.SOURCE else _whole(meaning, language, COLUMNS) or meaning


@lru_cache(maxsize=4096)
def _said(text: str, language: str) -> str | None:
    inner = text.strip()
    before, after = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
    each = _row(inner, language)
    found = _list(inner, language) or (each if _is_known(inner, language) else None)
    found = found or _whole(inner, language) or each
    return None if found is None else f"{before}{found}{after}"


def _whole(text: str, language: str, keys: tuple[str, ...] = KEYS) -> str | None:
    for known in _catalogue(keys):
        made = known.pattern.fullmatch(text)
        if made:
            given = {name: _given(value, language) for name, value in made.groupdict().items()}
            return messages.say_formatted(known.key, given, language)
    return None


def _given(value: str, language: str) -> Any:
    from fluent.runtime.types import fluent_number

    if number := _NUMBER.fullmatch(value):
        digits = len(number[1] or "")
        return fluent_number(
            float(value) if digits else int(value),
            useGrouping=False,
            minimumFractionDigits=digits,
            maximumFractionDigits=digits,
        )
    if _QUANTITY.fullmatch(value):
        return value.replace(".", messages.decimal_sign(language))
    return translated(value, language)


def _list(text: str, language: str) -> str | None:
    """Words with commas between, each of which is known by itself."""
    said = [_said(one, language) for one in text.split(", ")] if ", " in text else [None]
    return None if None in said else ", ".join(one for one in said if one)


def _row(text: str, language: str) -> str | None:
    """Several sentences in a row; one that is not known stays as it is."""
    parts = _NEXT_SENTENCE.split(text)
    said = [_said(one, language) for one in parts] if len(parts) > 1 else []
    return " ".join(new or old for new, old in zip(said, parts, strict=True)) if any(said) else None


def _is_known(text: str, language: str) -> bool:
    """Whether each of several sentences is known by itself: no value of one reaches into the next."""
    parts = _NEXT_SENTENCE.split(text)
    return len(parts) > 1 and None not in [_said(one, language) for one in parts]


@cache
def _catalogue(keys: tuple[str, ...]) -> tuple[_Known, ...]:
    """What is told in English under keys that begin so, that with most text of its own first."""
    from fluent.syntax import FluentParser
    from fluent.syntax import ast as ftl

    source = (files(messages) / f"{messages.SOURCE}.ftl").read_text("utf-8")
    lines = "\n".join(line for line in source.splitlines() if line.startswith(keys))
    found = [
        _known(one.id.name, one.value)
        for one in FluentParser().parse(lines).body
        if isinstance(one, ftl.Message) and one.value
    ]
    return tuple(sorted(found, key=lambda one: -one.literal))


def _known(key: str, pattern: ftl.Pattern) -> _Known:
    """A message of one line without a choice, which English has none of here."""
    regex, literal = "", 0
    for part in pattern.elements:
        text = getattr(part, "value", None)
        if text is not None:
            regex, literal = regex + re.escape(text), literal + len(text)
        else:
            name = part.expression.id.name  # type: ignore[union-attr]
            regex += f"(?P={name})" if f"(?P<{name}>" in regex else f"(?P<{name}>.+?)"
    return _Known(key, re.compile(regex, re.DOTALL), literal)
