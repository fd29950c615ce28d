"""The catalogue of messages: what is said to a person, by key, in the languages whose file lies here.

`en.ftl` is the source (Project Fluent); the pages read the same files. Code raises keys and values; the
sentence is made where somebody reads it. Numbers keep all their digits. The thousands of what a sentence asks
for with NUMBER, as every count, stand apart from 10,000 on, in every language by a narrow space that does not
break; most others are frames, lines and identifiers. SMALL writes metres as a small length: "14 mm" here,
inches in the pages of those who read feet.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from decimal import ROUND_HALF_UP, Decimal, localcontext
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fluent.runtime import FluentBundle

Value = str | int | float
SOURCE = "en"
_LEAST_APART, _NARROW = 10_000, "\u202f"
_MOST_DIGITS = 15
_LARGEST = 1e13  # Babel writes no larger number with so many digits behind the point
# An entry: from its key, which begins a line, up to the next line that begins with a key or a comment.
_ENTRY = re.compile(r"^(-?[A-Za-z][\w-]*) *=.*(?:\n(?![-A-Za-z#]).*)*", re.MULTILINE)
_BETWEEN = re.compile("[^a-z]+")
_NAMED = re.compile(r"\{\s*(-?[A-Za-z][\w-]*)")


def say(key: str, values: Mapping[str, Value], language: str = SOURCE) -> str:
    """The sentence of a key. KeyError for a key that en.ftl lacks, ValueError for a missing value."""
    for bundle in dict.fromkeys((language, SOURCE)):
        found = _bundle(bundle)
        if found.has(key):
            return _format_message(
                found.with_message(key), key, {name: _fluent_value(value) for name, value in values.items()}
            )
    raise KeyError(key)


def name_of(kind: str, name: str, language: str) -> str:
    """What a name in stored data is called, by its key: "click, target" of "budget-of" is
    budget-of-click-target. The name itself where there is no such key.
    """
    return say_or(f"{kind}-{_BETWEEN.sub('-', name)}", name, language)


def say_or(key: str, otherwise: str, language: str) -> str:
    """The sentence of a key without values; what is given where the language has no such key."""
    return say(key, {}, language) if _bundle(language).has(key) else otherwise


@cache
def languages() -> tuple[str, ...]:
    """The languages that there are, the source first."""
    others = sorted(one.name[:-4] for one in files(__name__).iterdir() if one.name.endswith(".ftl"))
    return (SOURCE, *(name for name in others if name != SOURCE))


@cache
def decimal_sign(language: str) -> str:
    """The sign between the units and the tenths of a number."""
    from babel.numbers import get_decimal_symbol

    return str(get_decimal_symbol(language))


def entries(text: str) -> dict[str, str]:
    """Each message of a file by its key, as it is written there."""
    return {found[1]: found[0] for found in _ENTRY.finditer(text)}


def _format_message(bundle: FluentBundle, key: str, values: Mapping[str, Any]) -> str:
    pattern = bundle.get_message(key).value
    assert pattern is not None, key
    with localcontext(rounding=ROUND_HALF_UP):
        text, errors = bundle.format_pattern(pattern, dict(values))
    if errors:
        raise ValueError(f"{key}: {'; '.join(str(error) for error in errors)}")
    return str(text)


def _fluent_value(value: Value) -> Any:
    from fluent.runtime.types import fluent_number

    if isinstance(value, str):
        return value
    if abs(value) >= _LARGEST:
        return f"{value:g}" if isinstance(value, float) else str(value)
    return fluent_number(value, useGrouping=False, maximumFractionDigits=_MOST_DIGITS)


def write_count(count: int) -> str:
    """A count as sentences have it."""
    return _number("en")(count)


def write_fixed(value: float, digits: int) -> str:
    """A number with so many decimals; halves of its fewest digits go away from zero, as in browsers."""
    return f"{Decimal(str(value)).quantize(Decimal(1).scaleb(-digits), ROUND_HALF_UP):f}"


def write_small(length_m: float) -> str:
    """A length in mm as sentences have it: below 1 cm with one decimal."""
    return _small_length("en")(length_m)


def _number(locale: str) -> Callable[..., str]:
    def number(value: Any, **options: Any) -> str:
        """A text stays as it is."""
        from babel import Locale
        from babel.numbers import get_group_symbol
        from fluent.runtime.types import fluent_number

        if isinstance(value, str):
            return value
        spoken = Locale.parse(locale, sep="-")
        written = fluent_number(value, **{"useGrouping": abs(value) >= _LEAST_APART, **options})
        return str(written.format(spoken)).replace(get_group_symbol(spoken), _NARROW)

    return number


def _small_length(locale: str) -> Callable[..., str]:
    def small(length_m: float, digits: int | None = None) -> str:
        """Below 1 cm with one decimal, unless the sentence asks for `digits`."""
        from babel.numbers import format_decimal

        length_mm = 1000 * float(length_m)
        decimals = int(digits) if digits is not None else 1 if abs(length_mm) < 10 else 0
        pattern = "0." + decimals * "0" if decimals else "0"
        return f"{format_decimal(length_mm, pattern, locale.replace('-', '_'))} mm"

    return small


class _Bundle:
    """The messages of one language, each parsed when it is first said: all of them take half a second."""

    def __init__(self, language: str) -> None:
        from fluent.runtime import FluentBundle  # a start needs none

        there = files(__name__) / f"{language}.ftl"
        text = there.read_text("utf-8") if there.is_file() else ""
        self._texts = entries(text)
        locale = "en-GB" if language == SOURCE else language
        functions: dict[str, Any] = {"NUMBER": _number(locale), "SMALL": _small_length(locale)}
        self._parsed = FluentBundle([locale], functions=functions, use_isolating=False)

    def has(self, key: str) -> bool:
        return key in self._texts

    def with_message(self, key: str) -> FluentBundle:
        """The bundle with this message in it, and those that it speaks of."""
        from fluent.runtime import FluentResource

        if not self._parsed.has_message(key):
            self._parsed.add_resource(FluentResource("\n".join(self._needed(key))))
        return self._parsed

    def _needed(self, key: str) -> list[str]:
        texts, waiting = dict[str, str](), [key]
        while waiting:
            name = waiting.pop()
            if name in self._texts and name not in texts:
                texts[name] = self._texts[name]
                waiting += _NAMED.findall(texts[name])
        return list(texts.values())


@cache
def _bundle(language: str) -> _Bundle:
    return _Bundle(language)
