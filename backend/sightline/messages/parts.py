"""Messages taken apart, for a program that reads no Fluent: texts, values, choices, marked parts.

The templates of the report are such a program (Typst). A message is a list of parts, each a text,
`{"value"}`, `{"strong"}` or `{"sub"}` of a text, or `{"choose", "among", "else"}`; `plurals` holds the plural
of 0 to 199, which is that of every larger number with the same last two digits.
"""

from __future__ import annotations

import re
from functools import cache
from importlib.resources import files
from typing import TypeAlias

from babel import Locale
from fluent.syntax import FluentParser
from fluent.syntax import ast as ftl

from sightline import messages

Parts: TypeAlias = "list[str | dict[str, str | Parts | dict[str, Parts]]]"
_MARKED = re.compile(r"<(strong|sub)>(.*?)</\1>", re.DOTALL)
_PLURALS = 200


@cache
def parts_of(beginning: str, language: str) -> dict[str, Parts]:
    """The messages whose keys begin so, in a language, each in English where that lacks it."""
    return {**_parsed(beginning, messages.SOURCE), **_parsed(beginning, language)}


@cache
def plurals(language: str) -> list[str]:
    """The plural of each number from 0 on, by the rules of CLDR."""
    form = Locale.parse(language).plural_form
    return [form(number) for number in range(_PLURALS)]


@cache
def _parsed(beginning: str, language: str) -> dict[str, Parts]:
    there = files(messages) / f"{language}.ftl"
    entries = messages.entries(there.read_text("utf-8") if there.is_file() else "")
    text = "\n".join(entry for key, entry in entries.items() if key.startswith(beginning))
    return {
        one.id.name: _parts(one.value)
        for one in FluentParser().parse(text).body
        if isinstance(one, ftl.Message) and one.value
    }


def _parts(pattern: ftl.Pattern) -> Parts:
    parts: Parts = []
    for element in pattern.elements:
        if isinstance(element, ftl.TextElement):
            parts += _split_marks(element.value.replace("\n", " "))
        elif isinstance(element.expression, ftl.SelectExpression):
            parts.append(_choice(element.expression))
        else:
            parts.append({"value": _value_in(element.expression)})
    return parts


def _value_in(expression: ftl.InlineExpression | ftl.Placeable) -> str:
    """The name of a value, one asked for by NUMBER too: the templates write whole numbers as counts."""
    if isinstance(expression, ftl.FunctionReference):
        (expression,) = expression.arguments.positional
    assert isinstance(expression, ftl.VariableReference)
    return expression.id.name


def _split_marks(text: str) -> Parts:
    """A text, with its marked parts apart."""
    parts: Parts = []
    start = 0
    for part in _MARKED.finditer(text):
        parts += [text[start : part.start()], {part[1]: part[2]}]
        start = part.end()
    return [one for one in [*parts, text[start:]] if one]


def _choice(expression: ftl.SelectExpression) -> dict[str, str | Parts | dict[str, Parts]]:
    usual: Parts = next(_parts(one.value) for one in expression.variants if one.default)
    assert isinstance(expression.selector, ftl.VariableReference)
    return {
        "choose": expression.selector.id.name,
        "among": {_name(one.key): _parts(one.value) for one in expression.variants},
        "else": usual,
    }


def _name(key: ftl.Identifier | ftl.NumberLiteral) -> str:
    return str(key.name if isinstance(key, ftl.Identifier) else key.value)
