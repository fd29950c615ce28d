"""Texts that are English, found again in the catalogue and said in another language.

What errors call a thing stands in the catalogue under TOLD; a text that is one of them, sign for sign, is
said by its key in the language asked for, and every other stays. Meanings of a package's columns stand under
COLUMNS.
"""

import re
from collections.abc import Mapping
from functools import cache, lru_cache
from importlib.resources import files

from sightline import messages

TOLD = "told-"
#: Meanings of the columns that a package's page explains, some with a number.
COLUMNS = "column-"
#: How cells write times, which columns of times say behind what they mean.
IN_UTC = " (ISO 8601, UTC)"
_VALUE = re.compile(r"\{ \$(\w+) \}")


def translate_text(text: str, language: str) -> str:
    """A text of the program in a language; as it is where the catalogue has none that says so."""
    key = None if language == messages.SOURCE else _english(TOLD).get(text)
    return text if key is None else messages.say(key, {}, language)


@lru_cache(maxsize=4096)
def translated_meaning(meaning: str, language: str) -> str:
    """What a column means, in a language; as it is where no page explains that column."""
    words = meaning.removesuffix(IN_UTC)
    for pattern, key in _meanings().items() if language != messages.SOURCE else ():
        if found := pattern.fullmatch(words):
            return messages.say(key, found.groupdict(), language) + meaning[len(words) :]
    return meaning


@cache
def _english(beginning: str) -> Mapping[str, str]:
    """The keys that begin so, by their English, each of one line."""
    entries = messages.entries((files(messages) / f"{messages.SOURCE}.ftl").read_text("utf-8"))
    return {
        entry.partition(" = ")[2].strip(): key for key, entry in entries.items() if key.startswith(beginning)
    }


@cache
def _meanings() -> Mapping[re.Pattern[str], str]:
    def pattern(english: str) -> re.Pattern[str]:
        words = _VALUE.split(english)  # every second is the name of a value
        return re.compile(
            "".join(rf"(?P<{one}>\d+)" if n % 2 else re.escape(one) for n, one in enumerate(words))
        )

    return {pattern(english): key for english, key in _english(COLUMNS).items()}
