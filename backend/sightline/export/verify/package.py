"""Checking an export without the database: nothing in it is believed that something else does not vouch for.

In order: the sums of all files and their one form; the audit chain, link by link; its seal, which names
every file; the installation's signature over the chain's end; then, as though there were neither: every
height from clicks, pose and camera, and every row against its audit event; keys; poses, calibrations and
photographs against the chain; verdicts; the description; exclusions and statistics computed again from the
rows; crops; figures and report drawn again; the page, which carries the tables and nothing else.

A package is read by its own description. What another version of the program computed or drew is compared
where the source that made it, with all that it imports, is this one's; else the chain and the seal alone
bind it, and the check says so.

What is left: who holds the installation's key can write and sign another chain; who does not can sign one
with a key of their own, which is told by the key that the installation shows (`--key`).
"""

from collections.abc import Sequence
from pathlib import Path

from sightline.errors import BadInput, Damaged
from sightline.export.contents import DRAWING, WORDS
from sightline.export.exclusions import EXCLUSIONS
from sightline.export.package_tables import MADE, STORED, Part, tables_of
from sightline.export.page import check_page
from sightline.export.seal import CHECKPOINT, check_seal, read_seal
from sightline.export.verify.chain import ReplayedState, walk
from sightline.export.verify.checking import Checking, PackageCheck
from sightline.export.verify.derived import check_drawn
from sightline.export.verify.described import check_description, read_description
from sightline.infra.audit.anchors import Anchors
from sightline.infra.audit.checkpoints import checkpoint_problem
from sightline.infra.audit.records import AuditHead, survey_chain
from sightline.infra.csv_package.columns import check_words
from sightline.infra.csv_package.files import (
    Files,
    InFolder,
    checksum_lines,
    is_stray,
    listed_sums,
    missing,
    open_package,
    package_inside,
    read_whole,
    sum_of,
)
from sightline.infra.csv_package.forms import check_forms, read_json
from sightline.infra.csv_package.parquet import check_parquet
from sightline.infra.csv_package.schema import CHECKSUMS, CODE, Written
from sightline.infra.csv_package.verify import check_keys
from sightline.measurements.csv import CLICKS, CLICKS_FOLDER, REVISIONS
from sightline.messages import say


def verify_place(place: Path, anchors: Anchors | None = None) -> PackageCheck:
    """Check an exported folder or ZIP, in a ZIP also one that lies in a folder. Raises BadInput for anything
    else, and for a folder that holds a package one level down, which it names.
    """
    files = open_package(place)
    if CHECKSUMS in files.paths or (inner := package_inside(files.paths)) is None:
        return verify_package(files, anchors)
    if place.is_dir():
        raise BadInput("export-package-is-inside", inner=place / inner)
    if inner.lower().endswith(".zip"):
        raise BadInput("export-zip-in-zip", place=place, inner=inner)
    outcome = verify_package(InFolder(files, inner), anchors)
    outcome.notes.append(
        f"In the ZIP the package lies in the folder {inner}: this is not the file that Sightline wrote, but "
        "one that somebody packed anew."
    )
    return outcome


def verify_package(files: Files, anchors: Anchors | None = None) -> PackageCheck:
    """Check everything; the first problem found is told. `anchors`: what was kept elsewhere."""
    outcome = PackageCheck(ok=False, files=len(files.paths))
    try:
        _check(files, anchors or Anchors(), outcome)
        outcome.ok = True
    except (Damaged, BadInput) as error:
        outcome.problem = error.message
    except (KeyError, ValueError, TypeError, IndexError) as error:
        # Checksums agree, yet a column is missing or holds what it cannot: another version, or a forger's.
        problem = f"A table lacks or cannot hold {error}; export the survey again with this version."
        outcome.problem = " ".join(problem.split())
    return outcome


def _check(files: Files, anchors: Anchors, outcome: PackageCheck) -> None:
    written = checksums(files)
    described = read_description(files)
    check_forms(files, {CLICKS_FOLDER: CLICKS.key})
    seal = read_seal(files)
    state = walk(files, seal, described.headers)
    outcome.checked, outcome.head_hash = state.count, state.hashes[-1]
    check_seal(seal, written)
    outcome.signed_at, outcome.key, keys = _signed(files, state, seal.survey_id)
    if anchors:
        outcome.vouched = anchors.hold_in_package(survey_chain(seal.survey_id), state.hashes, keys)
        if outcome.vouched < state.count:
            outcome.notes.append(say("export-continues-event", {"event": outcome.vouched}))
    outcome.notes += _of_key(outcome.key, anchors.key)
    tables = tables_of(described.most_frames)
    checking = Checking(described.read_in_its_format(files, tables), described, state, written, outcome)
    _check_rows(checking)
    outcome.tell("description", check_description(files, described, state, written, tables))
    _check_parts(MADE, checking)
    same_drawing = described.is_made_alike(DRAWING)
    if checking.statistics is not None and same_drawing:
        outcome.drawings = check_drawn(files, seal.as_of, checking.statistics, written, described.language)
    else:
        outcome.tell("drawings", [say("export-drawings-sealed-only", {})])
    resources = described.document["resources"]
    check_parquet(files, {one["path"]: one["schema"] for one in resources if "schema" in one})
    carried = (described.tables, written, described.language)
    if not check_page(files, described.made_with, *carried, same_program=same_drawing):
        outcome.tell("page", [say("export-page-sealed-only", {})])


def _check_rows(checking: Checking) -> None:
    """Every row against its audit events, and every height from its clicks."""
    described, outcome, recomputing = checking.described, checking.found, checking.recomputing
    same_words = described.is_made_alike(WORDS)
    if same_words:
        # what is excluded has the words of people too; it is derived, and held against its sources
        headers = {path: one for path, one in described.headers.items() if path != EXCLUSIONS.key}
        check_words(checking.files, headers)
    _check_parts(STORED, checking)
    outcome.keys = check_keys(checking.files, described.tables)
    if recomputing.differing:
        values: dict[str, str | int] = {"count": recomputing.differing, "first": recomputing.first}
        outcome.tell("heights", [say("export-heights-of-another-version", values)])
    if not same_words and f"reason{CODE}" in described.headers[REVISIONS.key]:
        outcome.tell("words", [say("export-words-sealed-only", {})])


def _check_parts(parts: Sequence[Part], checking: Checking) -> None:
    for part in parts:
        if part.check is not None:
            part.check(checking)


def _signed(files: Files, told: ReplayedState, survey_id: int) -> tuple[str, str, list[str]]:
    """When the end of the chain was signed, with which key, and all keys until then. Raises Damaged."""
    document = read_json(files, CHECKPOINT)
    end = AuditHead(told.count, told.hashes[-1])
    if (problem := checkpoint_problem(document, survey_chain(survey_id), end)) is not None:
        raise problem
    return str(document["at"]), str(document["key"]), [one["key"] for one in document["keys"]]


def _of_key(signing_key: str, key: str | None) -> list[str]:
    """What the signature does not prove."""
    if key is not None:
        return [
            "The signature proves what the holder of that key signed, not that it is true or when it was."
        ]
    return [
        f"Signed with key {signing_key[:16]}: who forges a package can sign it with a key of their own. "
        "Compare it with the one that the installation shows, or give that as --key."
    ]


def checksums(files: Files) -> dict[str, Written]:
    """Every file is there with the bytes it was written with, and no other. Raises Damaged."""
    there = files.paths
    if CHECKSUMS not in there:
        raise BadInput("export-no-checksums", checksums=CHECKSUMS)
    listed = listed_sums(files)
    strange = sorted(there - set(listed) - {CHECKSUMS})
    if stray := [path for path in strange if is_stray(path)]:
        raise Damaged("export-stray-files", count=len(stray), names=", ".join(stray))
    awaited = {path.lower(): path for path in set(listed) - there}
    if renamed := [path for path in strange if path.lower() in awaited]:
        raise Damaged("export-file-renamed", path=awaited[renamed[0].lower()], there=renamed[0])
    if strange:
        raise Damaged("export-file-not-listed", strange=strange[0])
    written: dict[str, Written] = {}
    for path, sum_ in listed.items():
        if path not in there:
            raise missing(path)
        written[path] = sum_of(files, path)
        if written[path].sha256 != sum_:
            raise Damaged("export-file-changed", path=path)
    if read_whole(files, CHECKSUMS) != checksum_lines(written):
        raise Damaged("export-file-changed", path=CHECKSUMS)
    return written
