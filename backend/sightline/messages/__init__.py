"""The catalogue of messages: what is said to a person, by key, in the languages whose file lies here.

`en.ftl` is the source (Project Fluent); the pages read the same files. Code raises keys and values; the
sentence is made where somebody reads it. Numbers keep all their digits and are not grouped unless the
sentence asks with NUMBER, for most of them are frames, lines and identifiers.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fluent.runtime import FluentBundle

Value = str | int | float
SOURCE = "en"
_MOST_DIGITS = 15


def say(key: str, values: Mapping[str, Value], language: str = SOURCE) -> str:
    """The sentence of a key. KeyError for a key that en.ftl lacks, ValueError for a missing value."""
    for bundle in dict.fromkeys((language, SOURCE)):
        found = _bundle(bundle)
        if found.has_message(key):
            return _formatted(found, key, values)
    raise KeyError(key)


def languages() -> tuple[str, ...]:
    """The languages that there are, the source first."""
    others = sorted(one.name[:-4] for one in files(__name__).iterdir() if one.name.endswith(".ftl"))
    return (SOURCE, *(name for name in others if name != SOURCE))


def _formatted(bundle: FluentBundle, key: str, values: Mapping[str, Value]) -> str:
    pattern = bundle.get_message(key).value
    assert pattern is not None, key
    text, errors = bundle.format_pattern(pattern, {name: _given(value) for name, value in values.items()})
    if errors:
        raise ValueError(f"{key}: {'; '.join(str(error) for error in errors)}")
    return str(text)


def _given(value: Value) -> Any:
    from fluent.runtime.types import fluent_number

    if isinstance(value, str):
        return value
    return fluent_number(value, useGrouping=False, maximumFractionDigits=_MOST_DIGITS)


@cache
def _bundle(language: str) -> FluentBundle:
    from fluent.runtime import FluentBundle, FluentResource  # a start needs none

    bundle = FluentBundle(["en-GB" if language == SOURCE else language], use_isolating=False)
    there = files(__name__) / f"{language}.ftl"
    if there.is_file():
        bundle.add_resource(FluentResource(there.read_text("utf-8")))
    return bundle
