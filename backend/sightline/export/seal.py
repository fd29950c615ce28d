"""The seal of a package: the last event of its audit chain, which names every other file by its SHA-256.

What no row's own event vouches for (names of people, pictures, figures, the description) is bound by it too,
so that nothing in a package can be changed without writing the chain anew. The chain's end is in the
checkpoint that the installation signs (`checkpoint.json`), which comes after the seal.
"""

import csv
import hashlib
import json
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any, Final

from sightline.errors import Damaged
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files, checksum_lines, place_of, sum_of
from sightline.infra.csv_package.schema import (
    CHECKSUMS,
    DESCRIPTION,
    PARQUET,
    TABLES,
    Written,
    parquet_path,
    sha256_hex,
)

ENTITY: Final = "package"
ACTION: Final = "seal"
CHECKPOINT = "checkpoint.json"
#: The package's page, and the chain and checkpoint for it, written after both.
PAGE, AUDIT_SCRIPT = "index.html", "audit.js"
REPORT, FIGURES = "report.pdf", "figures/"
_CROPS = "crops/"  # one hash for all of them: there may be a million


@dataclass(frozen=True)
class Seal:
    """What the last event says. `as_of`: the last event that the tables tell of; those between it and the
    seal came while the package was made. `before_sha256`: audit.csv without the seal's own line.
    """

    number: int
    survey_id: int
    as_of: int
    files: Mapping[str, str]
    before_sha256: str


def sealed_hashes(written: Mapping[str, Written], before_sha256: str) -> dict[str, str]:
    """The SHA-256 of every file by path; of audit.csv that of all lines but the seal's, of the crops that of
    their lines in SHA256SUMS.
    """
    own = {CHECKSUMS, CHECKPOINT, AUDIT.path, AUDIT_SCRIPT}
    crops = {path: one for path, one in written.items() if path.startswith(_CROPS)}
    named = {path: one.sha256 for path, one in written.items() if path not in own and path not in crops}
    return {**named, _CROPS: sha256_hex(checksum_lines(crops)), AUDIT.path: before_sha256}


def read_seal(files: Files) -> Seal:
    """The seal of a package: the last line of its audit.csv. Raises Damaged where that is none."""
    digest, last = hashlib.sha256(), b""
    with files.open(AUDIT.path) as file:
        for line in file:
            digest.update(last)
            last = line
    try:
        (cells,) = csv.reader([last.decode("utf-8")], strict=True)
        row = dict(zip(AUDIT.header, cells, strict=True))
        after: dict[str, Any] = json.loads(row["after"])
        if (row["entity"], row["action"]) != (ENTITY, ACTION):
            raise ValueError(row["entity"])
        return Seal(
            number=int(row["number"]),
            survey_id=int(row["survey_id"]),
            as_of=int(after["as_of"]),
            files=dict(after["files"]),
            before_sha256=digest.hexdigest(),
        )
    except (csv.Error, KeyError, TypeError, ValueError) as error:
        raise Damaged("export-no-seal") from error


def check_seal(seal: Seal, written: Mapping[str, Written]) -> None:
    """Every file is the one that the seal names, and there is no other. Raises Damaged."""
    found = sealed_hashes(written, seal.before_sha256)
    for path in sorted({*found, *seal.files}, key=_told_first):
        if found.get(path) != seal.files.get(path):
            raise Damaged("export-seal-differs", path=path)


def _told_first(path: str) -> tuple[bool, bool, bool, bool, str]:
    """Tables come first, then what is made of them, a table's Parquet, the page, last the description."""
    return path == DESCRIPTION, path == PAGE, path.startswith(PARQUET), not path.startswith(TABLES), path


def check_sealed(files: Files, tables: Collection[str]) -> str | None:
    """Whether some tables, by key, and their Parquet are the files that the package's seal names, in one
    sentence what is wrong, None when all is well. Nothing is computed again: the package is to have been
    verified before.
    """
    try:
        seal = read_seal(files)
        if seal.before_sha256 != seal.files.get(AUDIT.path):
            raise Damaged("export-seal-differs", path=AUDIT.path)
        places = (place_of(files, table) for table in tables)
        for path in (DESCRIPTION, *places, *(parquet_path(path) for path in tables)):
            if path in files.paths and sum_of(files, path).sha256 != seal.files.get(path):
                raise Damaged("export-seal-differs", path=path)
    except Damaged as error:
        return error.message
    return None
