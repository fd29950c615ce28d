"""What a report says, in the language that it is set in: `with speaking("fr"): ...`.

The language is a context, as decimal's precision is: it says how everything below is written and nothing of
what is found. Outside of any it is that of the source, in which tables and descriptions are.
"""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from datetime import date
from functools import cache

from sightline import messages
from sightline.messages.parts import parts_of, plurals
from sightline.messages.said import Said

_BEGINNING = "report-"
_language: ContextVar[str] = ContextVar("language", default=messages.SOURCE)


@contextmanager
def speaking(language: str) -> Iterator[None]:
    """What is said within is said in that language."""
    before = _language.set(language)
    try:
        yield
    finally:
        _language.reset(before)


def spoken_language() -> str:
    """The language that is spoken."""
    return _language.get()


def sentence_of_key(key: str, **values: str | int) -> str:
    """The sentence of a key of the catalogue."""
    return messages.say(key, values, spoken_language())


def sentence_of_said(what: Said | str) -> str:
    """What was said; a text that was stored by a program without codes as it is."""
    return what.sentence(spoken_language()) if isinstance(what, Said) else what


def day_parts(day: date) -> dict[str, str]:
    """Year, month and day, as sentences take them."""
    return {"year": f"{day.year:04d}", "month": f"{day.month:02d}", "day": f"{day.day:02d}"}


class Called:
    """What things of a kind are called: by name, under keys of the catalogue that begin alike."""

    def __init__(self, beginning: str) -> None:
        self._beginning = beginning

    def __getitem__(self, name: str) -> str:
        return sentence_of_key(f"{self._beginning}{name}")

    def get(self, name: str, other: str) -> str:
        """What it is called; `other` for what the catalogue has no name for."""
        return (
            self[name]
            if name and f"{self._beginning}{name}" in parts_of(_BEGINNING, spoken_language())
            else other
        )


@cache
def catalogue_json(language: str) -> bytes:
    """The messages that templates say, taken apart (`blocks.typ`)."""
    said_in = parts_of(_BEGINNING, language)
    return json.dumps(
        {"language": language, "plurals": plurals(language), "messages": said_in}, ensure_ascii=False
    ).encode("utf-8")
