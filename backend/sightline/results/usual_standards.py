"""The heights of standards that a survey is read against until it has a table of its own.

They lie in `standards.csv`, in the form that a package has it, with codes: an editable beginning.

Nothing in it was read in the standards themselves unless `cited_by` is empty: it says who cites the value, or
that nobody was seen to. A percentile is the rule behind a value where a source states it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from sightline.infra.csv_package.files import Files, FolderFiles
from sightline.messages import say_or
from sightline.results import csv
from sightline.statistics.standards import Standard

STANDARDS = csv.standards_in(FolderFiles(Path(__file__).parent))
_CODES = {one.words: one.code for one in STANDARDS}


def standards_in(files: Files) -> tuple[Standard, ...]:
    """The table of a package, which has no codes: who has the program's words gets one. Raises Damaged."""
    return tuple(add_usual_code(one) for one in csv.standards_in(files))


def stored_standards(stored: Iterable[Mapping[str, Any]]) -> tuple[Standard, ...]:
    """A table as an audit event holds it; one of before there were codes gets them by its words."""
    return tuple(Standard(**one) if "code" in one else add_usual_code(Standard(**one)) for one in stored)


def in_language(standard: Standard, language: str) -> Standard:
    """With the program's words in a language; as it is where they are a person's.

    English too comes from the catalogue; what is stored stays, so that packages that hold it verify.
    """
    if standard.code is None:
        return standard
    name, vehicle_class, source, cited_by = (
        say_or(f"standard-{kind}-{standard.code}", word, language)
        for kind, word in zip(("name", "class", "source", "cited"), standard.words, strict=True)
    )
    return replace(standard, name=name, vehicle_class=vehicle_class, source=source, cited_by=cited_by)


def add_usual_code(one: Standard) -> Standard:
    """With the code that belongs to its words, if they are the program's."""
    return replace(one, code=_CODES.get(one.words))
