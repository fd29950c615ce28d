"""`sightline verify`: the audit chain of a database, or a whole export."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from sightline.commands.options import json_option, print_json, progress_told
from sightline.errors import BadInput, Damaged
from sightline.settings import sqlite_url

DATABASE = "sightline.db"
BACKUP = "manifest.json"


@click.command()
@click.argument("place", metavar="DIR_OR_DATABASE")
@click.option("--head", help="Audit head that you kept (last hash, 16 characters or more), for a package.")
@click.option(
    "--key", help=("Signing key of the installation (16 characters or more), for a package or evidence file.")
)
@json_option
def verify(place: str, head: str | None, key: str | None, as_json: bool) -> None:
    """Check a database, a package (folder or ZIP), a backup or an evidence file with its audit chain.

    A database is given as its file, its data folder or its postgresql:// address; an evidence file ends in
    .html. For a package, this includes its seal (by which the chain names every file), every height and
    statistic (recomputed), every row against the audit chain, and the signature of the chain's end. A
    chain that was rewritten and signed again is detected with --key (if the forger does not have the key)
    or --head.
    """
    checked = check(place, head, key)
    if as_json:
        print_json(checked)
    if not checked["ok"]:
        raise Damaged("commands-problem-2", place=place, problem=checked["problem"])
    if not as_json:
        click.echo(_describe_check(place, checked))


def check(place: str, head: str | None = None, key: str | None = None) -> dict[str, Any]:
    """What was checked, with `ok` and `problem`. Raises BadInput for a place that is none of them, and for
    an anchor that it is not held against.
    """
    path, is_url = Path(place), "://" in place
    if not is_url and not path.exists():
        raise BadInput("commands-place-missing", place=place)
    if (path / DATABASE).is_file():
        path = path / DATABASE
    is_backup = (path / BACKUP).is_file()
    if not is_backup and (path.is_dir() or path.suffix.lower() == ".zip"):
        return check_export(path, head, key)
    is_evidence = path.suffix.lower() in (".html", ".htm") and path.is_file()
    for name, kept in (("head", head), ("key", None if is_evidence else key)):
        if kept is not None:
            raise BadInput("commands-option-without-effect", name=name, instead="it with a package")
    if is_evidence:
        return check_evidence(path, key)
    if is_backup:
        return check_backup_folder(path)
    return check_database(place) if is_url else check_database(sqlite_url(path.absolute()), str(path))


def check_export(path: Path, head: str | None = None, key: str | None = None) -> dict[str, Any]:
    """An exported folder or ZIP, with the SHA-256 of the ZIP."""
    from sightline.export.verify.package import verify_place
    from sightline.media.store.local import sha256_of

    found = asdict(verify_place(path, head, key))
    return {"kind": "export", **found, "sha256": sha256_of(path) if path.is_file() else None}


def check_evidence(path: Path, key: str | None = None) -> dict[str, Any]:
    """The evidence file of a vehicle: signature, hashes, events, numbers, decision."""
    from sightline.export.evidence.page import MOST_BYTES
    from sightline.export.evidence.verify import verify_evidence

    if path.stat().st_size > MOST_BYTES:
        raise Damaged("evidence-not-one")
    return {"kind": "evidence", **asdict(verify_evidence(path.read_bytes(), key))}


def check_backup_folder(path: Path) -> dict[str, Any]:
    """A folder of `sightline backup`: every file by its hash, of SQLite the audit chains too."""
    from sightline.commands.backup import read_words
    from sightline.infra.backup.restore import check_backup

    found = check_backup(path, progress_told())
    return {"kind": "backup", "ok": True, "problem": None, "said": read_words(path, found)}


def check_database(url: str, name: str = "This address") -> dict[str, Any]:
    """A database; nothing in it is changed."""
    from sightline.infra.audit.verification import verify_database

    return {"kind": "database", **asdict(verify_database(url, name))}


def _describe_check(place: str, checked: dict[str, Any]) -> str:
    if checked["kind"] == "backup":
        return str(checked["said"])
    if checked["kind"] == "evidence":
        return _evidence_words(place, checked)
    sentence = (
        f"{place}: the audit chain of {checked['checked']} events is intact, head {checked['head_hash'][:16]}"
    )
    if checked["kind"] != "export":
        return sentence + "."
    sentence += (
        f"; {checked['files']} files unchanged, {checked['heights']} heights and {checked['statistics']} "
        f"statistics recomputed and equal, {checked['keys']} references between tables checked, "
        f"{checked['crops']} crops compared, {checked['drawings']} drawings made again; the end of the chain "
        f"was signed on {checked['signed_at'][:19]} UTC with key {checked['key'][:16]}."
    )
    if checked["sha256"] is not None:
        sentence += f" SHA-256 {checked['sha256']}; compare it with the one on the page Package."
    return " ".join([sentence, *checked["notes"]])


def _evidence_words(place: str, checked: dict[str, Any]) -> str:
    sentences = [
        f"{place}: signature, hashes, audit events, numbers and decision are valid; made on "
        f"{checked['made_at'][:19]} UTC by Sightline {checked['program']}.",
        checked["decision"],
    ]
    if checked["lines"] is not None:
        v, a, length = (checked["lines"][name] for name in ("speed_mps", "acceleration_mps2", "length_m"))
        sentences.append(
            f"For comparison, the four boundary lines alone give {v:.3f} m/s, {a:.2f} m/s2, {length:.3f} m."
        )
    return " ".join([*sentences, *checked["notes"]])
