"""`sightline verify`: the audit chain of a database, or a whole export."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from sightline.commands.files import read_json
from sightline.commands.options import FILE, json_option, print_json, progress_told
from sightline.errors import BadInput, Damaged
from sightline.infra.audit.anchors import Anchors
from sightline.messages.said import Said
from sightline.settings import sqlite_url

DATABASE = "sightline.db"
BACKUP = "manifest.json"
#: From the best to the worst.
_EXIT: dict[str, int] = {"holds": 0, "unanchored": 3, "broken": 1}


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
    chain that was rewritten and signed again is detected with --key (if the forger does not have the key),
    --head or --checkpoint: each must hold in one of the places, and one of each kind in every place.

    Exit status: 0 holds; 1 does not; 2 cannot be read; 3 nothing contradicts, but another version made it, so
    that some checks were not made, and nothing that was kept elsewhere vouches for it.
    """
    anchors = Anchors(key, heads, [read_json(one, "a checkpoint") for one in checkpoints])
    found = [_checked(place, anchors) for place in places]
    status = max((one["status"] for one in found), key=list(_EXIT).index)
    problems = [problem for one in found for problem in one["problems"]]
    broken = [place for place, one in zip(places, found, strict=True) if one["problems"]] or places
    if anchors.unheld and status != "broken":
        status, problems = "broken", [str(Said("commands-anchors-unheld", anchors=", ".join(anchors.unheld)))]
    if as_json:
        not_checked = list(dict.fromkeys(part for one in found for part in one["not_checked"]))
        told = {"status": status, "problems": problems, "not_checked": not_checked}
        print_json({**found[0], **told} if len(found) == 1 else {**told, "places": found})
    for place, one in zip(places, found, strict=True):
        if not as_json and one["status"] != "broken":
            click.echo(_describe_check(place, one))
    if status == "broken":
        raise Damaged("commands-problem-2", place=", ".join(broken), problem=" ".join(problems))
    return _EXIT[status]


def _checked(place: str, anchors: Anchors) -> dict[str, Any]:
    """What was checked, as the contract names it, and further counts."""
    try:
        checked = check(place, anchors)
    except Damaged as damage:
        checked = {"ok": False, "problem": damage.said}
    ok, problem = checked.pop("ok"), checked.pop("problem")
    not_checked = checked.pop("not_checked", [])
    status = "broken" if not ok else "unanchored" if not_checked and not anchors else "holds"
    return {
        "status": status,
        "problems": [] if ok else [str(problem)],
        "not_checked": not_checked,
        "key": checked.pop("key", None) or None,
        "head": checked.pop("head_hash", None) or None,
        "count": checked.pop("checked", None),
        **checked,
    }


def check(place: str, anchors: Anchors) -> dict[str, Any]:
    """What was checked, with `ok` and `problem`. Raises BadInput for a place that is none of them, and for
    an anchor that it is not held against.
    """
    path, is_url = Path(place), "://" in place
    if not is_url and not path.exists():
        raise BadInput("commands-place-missing", place=place)
    if (path / DATABASE).is_file():
        path = path / DATABASE
    if (path / BACKUP).is_file():
        return check_backup_folder(path, anchors)
    if path.is_dir() or path.suffix.lower() == ".zip":
        return check_export(path, anchors)
    if path.suffix.lower() in (".html", ".htm") and path.is_file():
        return check_evidence(path, anchors)
    return check_database(place if is_url else sqlite_url(path.absolute()), place, anchors)


def check_export(path: Path, anchors: Anchors | None = None) -> dict[str, Any]:
    """An exported folder or ZIP, with the SHA-256 of the ZIP."""
    from sightline.export.verify.package import verify_place
    from sightline.media.store.local import sha256_of

    found = asdict(verify_place(path, anchors))
    return {"kind": "export", **found, "sha256": sha256_of(path) if path.is_file() else None}


def check_evidence(path: Path, anchors: Anchors) -> dict[str, Any]:
    """The evidence file of a vehicle: signature, hashes, events, numbers, decision."""
    from sightline.export.evidence.page import MOST_BYTES
    from sightline.export.evidence.verify import verify_evidence

    if anchors.of_chains:
        raise BadInput(
            "commands-option-without-effect", name=anchors.of_chains[0], instead="--key with an evidence file"
        )
    if path.stat().st_size > MOST_BYTES:
        raise Damaged("evidence-not-one")
    return {"kind": "evidence", **asdict(verify_evidence(path.read_bytes(), anchors.key))}


def check_backup_folder(path: Path, anchors: Anchors) -> dict[str, Any]:
    """A folder of `sightline backup`: every file by its hash, of SQLite the audit chains too."""
    from sightline.commands.backup import read_words
    from sightline.infra.backup.restore import check_backup

    found = check_backup(path, progress_told(), anchors)
    audit = {} if found.audit is None else asdict(found.audit)
    return {"kind": "backup", "ok": True, "problem": None, **audit, "said": read_words(path, found)}


def check_database(url: str, name: str = "This address", anchors: Anchors | None = None) -> dict[str, Any]:
    """A database; nothing in it is changed."""
    from sightline.infra.audit.verification import verify_database

    return {"kind": "database", **asdict(verify_database(url, name, anchors))}


def _describe_check(place: str, checked: dict[str, Any]) -> str:
    if checked["kind"] == "backup":
        return str(checked["said"])
    if checked["kind"] == "evidence":
        return _evidence_words(place, checked)
    sentence = f"{place}: the audit chain of {checked['count']} events is intact, head {checked['head'][:16]}"
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
