"""`sightline verify`: the audit chain of a database, or a whole export."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from backend.commands.options import json_option, print_json
from backend.errors import BadInput, Damaged
from backend.settings import sqlite_url

DATABASE = "sightline.db"


@click.command()
@click.argument("place", metavar="DIR_OR_DATABASE")
@json_option
def verify(place: str, as_json: bool) -> None:
    """Check the audit chain of a database (file, data folder or postgresql:// address) or a whole export.

    Of an export also the checksums of its files, and every height, computed again from clicks and pose.
    """
    found = check(place)
    if as_json:
        print_json(found)
    if not found["ok"]:
        raise Damaged(f"{place}: {found['problem']}")
    if not as_json:
        click.echo(_words(place, found))


def check(place: str) -> dict[str, Any]:
    """What was checked, with `ok` and `problem`. Raises BadInput for a place that is neither."""
    if "://" in place:
        return check_database(place)
    path = Path(place)
    if not path.exists():
        raise BadInput(f"{place} does not exist; name a database, a data folder or an exported folder.")
    if path.is_dir() and (path / DATABASE).is_file():
        path = path / DATABASE
    if path.is_dir() or path.suffix == ".zip":
        return check_export(path)
    return check_database(sqlite_url(path.absolute()), str(path))


def check_export(path: Path) -> dict[str, Any]:
    """An exported folder or ZIP."""
    from backend.work.verifying import read_package, verify_package

    return {"kind": "export", **asdict(verify_package(read_package(path)))}


def check_database(url: str, name: str | None = None) -> dict[str, Any]:
    """A database; nothing in it is changed."""
    from sqlalchemy import inspect
    from sqlalchemy.exc import DatabaseError

    from backend.storage import audit, database

    engine = database.make_engine(url)
    stranger = (
        f"{name or 'This address'} is not a Sightline database; name the sightline.db of a data folder."
    )
    try:
        if not inspect(engine).has_table("audit_events"):
            raise BadInput(stranger)
        with database.reading(database.session_factory(engine)) as session:
            found = audit.verify(session)
    except DatabaseError as error:
        raise BadInput(stranger) from error
    finally:
        engine.dispose()
    return {"kind": "database", **asdict(found)}


def _words(place: str, found: dict[str, Any]) -> str:
    said = f"{place}: the audit chain of {found['checked']} events holds, head {found['head_hash'][:16]}"
    if found["kind"] == "export":
        said += f"; {found['files']} files unchanged, {found['heights']} heights computed again and equal"
    return said + "."
