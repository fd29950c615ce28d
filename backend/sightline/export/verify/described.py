"""What a package says of itself in datapackage.json: which program made it, its format and its tables."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sightline.errors import Damaged
from sightline.export.contents import LIBRARIES, PARTS, about_of, describe_package, made_with
from sightline.export.report.words import selection_words
from sightline.export.seal import AUDIT_SCRIPT, CHECKPOINT
from sightline.export.verify.chain import ReplayedState
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import EarlierFiles, Files
from sightline.infra.csv_package.forms import read_json
from sightline.infra.csv_package.schema import (
    DESCRIPTION,
    FORMAT,
    AnyTable,
    Written,
    json_bytes,
    tables_described,
)
from sightline.infra.version import code_version
from sightline.measurements.csv import MEASUREMENTS, count_frames
from sightline.messages import languages, say
from sightline.results.csv import selection_in

_FIRST_FORMAT = 1  # it stated none
_INEXACT = (".dirty", "+unknown")  # two programs may call themselves so
_CROPS = "crops/"  # described by crops.csv
_UNDESCRIBED = {DESCRIPTION, AUDIT.path, AUDIT_SCRIPT, CHECKPOINT}


@dataclass(frozen=True, eq=False)
class Described:
    """datapackage.json as it is, and its tables by it."""

    document: Mapping[str, Any]
    tables: tuple[AnyTable, ...]
    made_with: Mapping[str, Any]
    language: str

    @cached_property
    def headers(self) -> Mapping[str, frozenset[str]]:
        """The columns of each table by its key."""
        return {table.key: frozenset(table.header) for table in self.tables}

    @cached_property
    def mine(self) -> Mapping[str, str]:
        """What this program makes packages with."""
        return made_with()

    @property
    def program(self) -> str:
        return str(self.made_with.get("sightline"))

    def made_by_this_program(self) -> bool:
        return self.made_with == self.mine

    def is_made_alike(self, part: str) -> bool:
        """Whether a part of this program (source, imports, libraries) is the one that made the package."""
        return all(self.made_with.get(name) == self.mine[name] for name in (part, *LIBRARIES[part]))

    def is_computed_alike(self, part: str, by: str) -> bool:
        """Whether this program computes as version `by`, which computed a row of this package."""
        return by == code_version() or (by == self.program and self.is_made_alike(part))

    @property
    def most_frames(self) -> int:
        """For how many frames of a measurement the package has columns."""
        return count_frames(self.headers.get(MEASUREMENTS.key, ()))

    def read_in_its_format(self, files: Files, mine: Sequence[AnyTable]) -> Files:
        """The package, with nothing in the tables and columns of this program (`mine`) that it lacks."""
        return files if self.made_by_this_program() else EarlierFiles(files, mine, self.tables)


def read_description(files: Files) -> Described:
    """Raises Damaged where it cannot be read, or is of a format that this program does not know."""
    document = read_json(files, DESCRIPTION)
    try:
        number = document.get("format", _FIRST_FORMAT)
        made = dict(document["made_with"])
        if not isinstance(number, int) or number > FORMAT:
            raise Damaged("export-format-not-known", format=number, program=str(made.get("sightline")))
        return Described(document, tables_described(document), made, str(document["language"]))
    except (KeyError, TypeError, AttributeError) as error:
        raise Damaged("export-description-unreadable", description=DESCRIPTION) from error


def check_description(
    files: Files,
    description: Described,
    state: ReplayedState,
    written: Mapping[str, Written],
    mine: Sequence[AnyTable],
) -> list[str]:
    """datapackage.json is what this program, whose tables are `mine`, would say of these files; of another
    version's, that it names every file with its bytes. Returns what could not be compared. Raises Damaged.
    """
    words = {name: str(state.survey.get(name, "")) for name in ("name", "site", "description")}
    about = about_of(**words, created=state.moment, only=selection_words(selection_in(files)))
    expected = describe_package(about, description.language, mine, written)
    expected["made_with"] = description.document["made_with"]
    if description.made_with.get("sightline") == code_version():
        _check_own(description, expected)
        return []
    return _compare_others(description, expected, written)


def _check_own(described_as: Described, expected: Mapping[str, Any]) -> None:
    document = described_as.document
    exact = not described_as.program.endswith(_INEXACT)
    if list(document) != list(expected):
        raise Damaged("export-description-differs", description=DESCRIPTION, name="order")
    for name in sorted(set(expected) - {"resources"}):
        if json_bytes(document[name]) != json_bytes(expected[name]):
            raise Damaged("export-description-differs", description=DESCRIPTION, name=name)
    if exact and any(document["made_with"].get(part) != described_as.mine[part] for part in PARTS):
        raise Damaged("export-description-differs", description=DESCRIPTION, name="made_with")
    if document["language"] not in languages():
        raise Damaged("export-description-differs", description=DESCRIPTION, name="language")
    mine, theirs = (list(one["resources"]) for one in (expected, document))
    for n in range(max(len(mine), len(theirs))):
        if json_bytes(mine[n : n + 1]) != json_bytes(theirs[n : n + 1]):
            named = (theirs[n : n + 1] or mine[n : n + 1])[0].get("path", "a file")
            raise Damaged("export-program-differs", description=DESCRIPTION, named=named)


def _compare_others(
    description: Described, expected: Mapping[str, Any], written: Mapping[str, Written]
) -> list[str]:
    resources = list(description.document["resources"])
    paths = Counter(str(one["path"]) for one in resources)
    for one in resources:
        path = str(one["path"])
        sums = (one.get("bytes"), one.get("hash"))
        there = written.get(path)
        is_right = path in _UNDESCRIBED or (
            sums == (None, None) if there is None else sums == (there.size, f"sha256:{there.sha256}")
        )
        if not is_right or paths[path] > 1:
            raise Damaged("export-program-differs", description=DESCRIPTION, named=path)
    for path in sorted(set(written) - set(paths) - _UNDESCRIBED):
        if not path.startswith(_CROPS):
            raise Damaged("export-program-differs", description=DESCRIPTION, named=path)
    mine = {one["path"]: one for one in expected["resources"]}
    otherwise = sum(json_bytes(mine.get(one["path"])) != json_bytes(one) for one in resources)
    names = {*description.document, *expected} - {"resources", "format", "made_with"}
    differ = sorted(
        n for n in names if json_bytes(description.document.get(n)) != json_bytes(expected.get(n))
    )
    notes = [say("export-made-by-another-version", {"program": description.program, "mine": code_version()})]
    if otherwise or differ:
        values: dict[str, str | int] = {"count": otherwise, "names": ", ".join(differ) or "-"}
        notes.append(say("export-described-otherwise", values))
    return notes
