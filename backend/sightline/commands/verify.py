"""`sightline verify`: the audit chain of a database, or a whole export."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from sightline.commands.files import read_json
from sightline.commands.options import FILE, json_option, print_json, progress_told
from sightline.errors import BadInput, Damaged, SightlineError
from sightline.infra.audit.anchors import Anchors
from sightline.infra.audit.records import Verification
from sightline.messages.said import Said
from sightline.settings import sqlite_url

DATABASE = "sightline.db"
BACKUP = "manifest.json"
PACKAGE = ("SHA256SUMS", "datapackage.json")
_KINDS = "a database, a package, a backup or an evidence file"
#: From the best to the worst.
_EXIT: dict[str, int] = {"holds": 0, "unanchored": 3, "refused": 2, "broken": 1}


@click.command()
@click.argument("places", metavar="PATH...", nargs=-1, required=True)
@click.option("--key", help="Signing key of the installation (16 characters or more), as you kept it.")
@click.option(
    "--head",
    "heads",
    multiple=True,
    help="Audit head that you kept, of this or an earlier package (16 characters or more). May be repeated.",
)
@click.option(
    "--checkpoint",
    "checkpoints",
    multiple=True,
    type=FILE,
    help="Checkpoint that you kept: of sightline checkpoint, or of a package. May be repeated.",
)
@json_option
def verify(
    places: tuple[str, ...],
    key: str | None,
    heads: tuple[str, ...],
    checkpoints: tuple[Path, ...],
    as_json: bool,
) -> int:
    """Check databases, packages (folder or ZIP), backups or evidence files with their audit chains.

    A database is given as its file, its data folder or its postgresql:// address; an evidence file ends in
    .html. For a package, this includes its seal (by which the chain names every file), every height and
    statistic (recomputed), every row against the audit chain, and the signature of the chain's end. A
    chain that was rewritten and signed again is detected with --key (of packages and evidence files, if the
    forger does not have the key), --head or --checkpoint: each must hold in every place.

    Exit status: 0 holds; 1 does not; 2 cannot be read, or an option that means nothing there; 3 nothing
    contradicts, but another version made it, so that some checks were not made, and nothing that was kept
    elsewhere vouches for the whole. Of several places that of the worst, in the order 0, 3, 2, 1.
    """
    anchors = Anchors(key, heads, [read_json(one, "a checkpoint") for one in checkpoints])
    found = [_checked(place, anchors) for place in places]
    status = max((one["status"] for one in found), key=list(_EXIT).index)
    broken = [(place, one) for place, one in zip(places, found, strict=True) if one["problems"]]
    problems = [_problem_words(place, one) for place, one in broken]
    if as_json and len(found) > 1:
        not_checked = list(dict.fromkeys(part for one in found for part in one["not_checked"]))
        listed = [{"place": place, **one} for place, one in zip(places, found, strict=True)]
        print_json({"status": status, "problems": problems, "not_checked": not_checked, "places": listed})
    elif as_json:
        print_json(found[0])
    for place, one in zip(places, found, strict=True):
        if not as_json and not one["problems"]:
            click.echo(_describe_check(place, one))
    for problem in problems:
        click.echo(problem, err=True)
    return _EXIT[status]


def _checked(place: str, anchors: Anchors) -> dict[str, Any]:
    """What was checked, as the contract names it, and further counts."""
    try:
        checked = check(place, anchors)
    except Damaged as error:
        return _not_checked("broken", error.message)
    except SightlineError as error:
        return _not_checked("refused", error.message)
    except OSError as error:
        path, why = error.filename or place, error.strerror or str(error)
        said = Said("commands-cannot-read-give", path=path, strerror=why, what=_KINDS)
        return _not_checked("refused", str(said))
    ok, problem, vouched = checked.pop("ok"), checked.pop("problem"), checked.get("vouched")
    not_checked, count = checked.pop("not_checked", []), checked.pop("checked", None)
    whole = not not_checked or (vouched is not None and vouched == count)
    return {
        "status": "broken" if not ok else "holds" if whole else "unanchored",
        "problems": [] if ok else [str(problem)],
        "not_checked": not_checked,
        "key": checked.pop("key", None) or None,
        "head": checked.pop("head_hash", None) or None,
        "count": count,
        **checked,
    }


def _not_checked(status: str, problem: str) -> dict[str, Any]:
    nothing = dict.fromkeys(("key", "head", "count"))
    return {"status": status, "problems": [problem], "not_checked": [], **nothing}


def _problem_words(place: str, checked: dict[str, Any]) -> str:
    """One line; what cannot be read is named in its sentence already."""
    (problem,) = checked["problems"]
    if checked["status"] == "broken" or place not in problem:
        problem = str(Said("commands-problem-2", place=place, problem=problem))
    return " ".join(problem.split())


def check(place: str, anchors: Anchors) -> dict[str, Any]:
    """What was checked, with `ok` and `problem`. Raises BadInput for a place that is none of them, and for
    an anchor that it is not held against.
    """
    path, is_url = Path(place), "://" in place
    if not is_url and not path.exists():
        raise BadInput("commands-place-missing", place=place)
    _require_one_thing(path)
    if (path / DATABASE).is_file():
        path = path / DATABASE
    is_backup = (path / BACKUP).is_file()
    if not is_backup and (path.is_dir() or path.suffix.lower() == ".zip"):
        return check_export(path, anchors)
    if path.suffix.lower() in (".html", ".htm") and path.is_file():
        _require_none("--key", head=anchors.heads, checkpoint=anchors.checkpoints)
        return check_evidence(path, anchors.key)
    _require_none("--checkpoint", key=anchors.key)
    if is_backup:
        return check_backup_folder(path, anchors)
    return check_database(place if is_url else sqlite_url(path.absolute()), place, anchors)


def _require_one_thing(folder: Path) -> None:
    """Raises BadInput for a folder in which a database, a backup or a package hides another of them."""
    names = [name for name in (DATABASE, BACKUP, *PACKAGE) if (folder / name).is_file()]
    if len(names) > 1 and names != list(PACKAGE):
        raise BadInput("commands-place-ambiguous", place=folder, names=", ".join(names))


def _require_none(instead: str, **given: object) -> None:
    """Raises BadInput for the first option that was given although it means nothing here."""
    for name, value in given.items():
        if value:
            raise BadInput("commands-option-without-effect", name=name, instead=instead)


def check_export(path: Path, anchors: Anchors | None = None) -> dict[str, Any]:
    """An exported folder or ZIP, with the SHA-256 of the ZIP."""
    from sightline.export.verify.package import verify_place
    from sightline.media.store.local import sha256_of

    found = asdict(verify_place(path, anchors))
    return {"kind": "export", **found, "sha256": sha256_of(path) if path.is_file() else None}


def check_evidence(path: Path, key: str | None) -> dict[str, Any]:
    """The evidence file of a vehicle: signature, hashes, events, numbers, decision."""
    from sightline.export.evidence.page import MOST_BYTES
    from sightline.export.evidence.verify import verify_evidence

    if path.stat().st_size > MOST_BYTES:
        raise Damaged("evidence-not-one")
    return {"kind": "evidence", **asdict(verify_evidence(path.read_bytes(), key))}


def check_backup_folder(path: Path, anchors: Anchors) -> dict[str, Any]:
    """A folder of `sightline backup`: every file by its hash, of SQLite the audit chains too."""
    from sightline.commands.backup import read_words
    from sightline.infra.backup.restore import check_backup

    found = check_backup(path, progress_told(), anchors)
    audit = {"ok": True, "problem": None} if found.audit is None else _with_notes(found.audit)
    return {"kind": "backup", **audit, "said": read_words(path, found)}


def check_database(url: str, name: str, anchors: Anchors) -> dict[str, Any]:
    """A database; nothing in it is changed."""
    from sightline.infra.audit.verification import verify_database

    return {"kind": "database", **_with_notes(verify_database(url, name, anchors))}


def _with_notes(found: Verification) -> dict[str, Any]:
    """What was found, and up to where something kept elsewhere vouches for it."""
    notes = [str(note) for note in found.notes()]
    return asdict(found) | ({"notes": notes} if notes else {})


def _describe_check(place: str, checked: dict[str, Any]) -> str:
    if checked["kind"] == "backup":
        return " ".join([checked["said"], *checked.get("notes", [])])
    if checked["kind"] == "evidence":
        return _evidence_words(place, checked)
    sentence = f"{place}: the audit chain of {checked['count']} events is intact, head {checked['head'][:16]}"
    if checked["kind"] != "export":
        return " ".join([sentence + ".", *checked.get("notes", [])])
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
