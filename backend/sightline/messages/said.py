"""What the program says and keeps: a code of the catalogue with its values.

Reasons and flags are stored, hashed, sent and compared in this form, and made into a sentence where somebody
reads it. The code names the case, is its key in the catalogue, and stays when the sentence is worded anew.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any

from typing_extensions import TypedDict

from sightline.messages import SOURCE, Value, say

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler
    from pydantic_core import CoreSchema

#: of a text in a sentence; somebody's cell of a table may hold a megabyte
MOST_SIGNS = 900
#: The code of a sentence that was kept as a text, by a program that had no codes.
_TEXT = "said"
_NAME = re.compile(r"[A-Za-z0-9_-]{1,100}")
#: JSON keeps these whole.
_MOST_COUNT = 2**53
#: of sayings within sayings
_MOST_DEEP = 30
# A line has no second line, and no sign turns the order of the others round.
_UNSEEN = re.compile(r"[\x00-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")


class SaidDocument(TypedDict):
    """As it is stored and hashed."""

    code: str
    values: dict[str, str | int | float | SaidDocument]


class SaidInWords(TypedDict):
    """As it is answered: with the sentence, in the language of the request."""

    code: str
    values: dict[str, str | int | float | SaidInWords]
    message: str


class Said:
    """A code and the values of its sentence, which may be sayings themselves; two of the same are equal.

    Values that are neither numbers nor texts are kept as texts. A number counts to the last digit: whoever
    says it rounds it to what the sentence shows.
    """

    __slots__ = ("_code", "_values")

    def __init__(self, code: str, /, **values: object) -> None:
        self._code = code
        self._values = {
            name: value if isinstance(value, Said) else plain_value(value)
            for name, value in sorted(values.items())
        }

    @classmethod
    def read(cls, stored: SaidDocument | str) -> Said:
        """What `document` was; a text is what an earlier program stored, and says itself.

        Raises TypeError, LookupError, AttributeError for anything else.
        """
        if isinstance(stored, str):
            return cls(_TEXT, sentence=stored)
        code, values = stored["code"], stored["values"]
        if not isinstance(code, str):
            raise TypeError("a code is a text")
        return cls(
            code, **{n: v if isinstance(v, str | int | float) else cls.read(v) for n, v in values.items()}
        )

    @property
    def code(self) -> str:
        return self._code

    @property
    def values(self) -> Mapping[str, Value | Said]:
        return dict(self._values)

    @property
    def document(self) -> SaidDocument:
        """Its stored form."""
        values = {n: v.document if isinstance(v, Said) else v for n, v in self._values.items()}
        return {"code": self._code, "values": values}

    @property
    def body(self) -> SaidInWords:
        """Its form in an answer, in English."""
        values = {n: v.body if isinstance(v, Said) else v for n, v in self._values.items()}
        return {"code": self._code, "values": values, "message": str(self)}

    def sentence(self, language: str = SOURCE) -> str:
        """In words; the code where this program has no such sentence, as an older or a later one's."""
        return _sentence(self, language)

    def __str__(self) -> str:
        return self.sentence()

    def __repr__(self) -> str:
        given = "".join(f", {name}={value!r}" for name, value in self._values.items())
        return f"Said({self._code!r}{given})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Said):
            return NotImplemented
        return self._code == other._code and self._values == other._values

    def __hash__(self) -> int:
        return hash((self._code, *self._values.items()))

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """It is answered as `body`; taken as it is, or in its stored form."""
        from pydantic_core import PydanticCustomError, core_schema

        def taken(value: Any) -> Said:
            try:
                said = value if isinstance(value, cls) else cls.read(value)
            except (TypeError, LookupError, AttributeError, RecursionError):
                said = None
            if said is None or not _is_sound(said):
                raise PydanticCustomError("said", "a sentence is given by its code and values")
            return said

        answered = core_schema.plain_serializer_function_ser_schema(
            lambda one: one.body, return_schema=handler.generate_schema(SaidInWords)
        )
        # values may be sentences themselves: a description that says so refers to itself, and has no end
        given = core_schema.typed_dict_schema(
            {
                "code": core_schema.typed_dict_field(core_schema.str_schema()),
                "values": core_schema.typed_dict_field(core_schema.dict_schema()),
            }
        )
        return core_schema.no_info_plain_validator_function(
            taken, serialization=answered, json_schema_input_schema=given
        )


def _is_sound(said: Said, deep: int = 0) -> bool:
    """Whether it is of names and values that can be stored and said, as whoever sends it may have made it."""
    each = said.values.values()
    return (
        deep < _MOST_DEEP
        and all(map(_NAME.fullmatch, (said.code, *said.values)))
        and all(_is_sound(one, deep + 1) for one in each if isinstance(one, Said))
        and all(abs(one) < _MOST_COUNT for one in each if isinstance(one, int))
    )


@lru_cache(maxsize=4096)
def _sentence(said: Said, language: str) -> str:
    values = {n: v.sentence(language) if isinstance(v, Said) else v for n, v in said.values.items()}
    try:
        return say(said.code, values, language)
    except (KeyError, ValueError):
        return said.code


def join_with_and(each: Sequence[Said]) -> Said:
    """`a, b and c`, of one or more."""
    *before, last = each
    return Said("words-both", first=with_commas(before), second=last) if before else last


def with_commas(each: Sequence[Said]) -> Said:
    """`a, b, c`, of one or more."""
    *before, last = each
    return Said("words-comma", first=with_commas(before), second=last) if before else last


def plain_value(value: object) -> Value:
    """What JSON and every language can hold; a truth is a text here, and a text has an end."""
    if isinstance(value, Integral) and not isinstance(value, bool):
        return int(value)
    if isinstance(value, Real) and not isinstance(value, bool) and math.isfinite(value):
        return float(value)
    text = _UNSEEN.sub("\N{REPLACEMENT CHARACTER}", str(value))
    return text if len(text) <= MOST_SIGNS else text[: MOST_SIGNS - 1] + "…"
