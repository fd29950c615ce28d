"""`sightline backup` and `sightline restore`: a running installation into a folder, and back."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sightline.commands.options import data_dir_option, progress_told, require_database, settings_of
from sightline.errors import Damaged

if TYPE_CHECKING:
    from sightline.infra.backup.manifest import Manifest
    from sightline.infra.backup.restore import ReadBackup

_MISSING_SHOWN = 3


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(file_okay=False, path_type=Path))
@click.option("--verify", "reading_back", is_flag=True, help="Read everything back from DIR afterwards.")
@click.option("--prune", is_flag=True, help="Remove media from DIR that the installation no longer has.")
@data_dir_option
def backup(folder: Path, reading_back: bool, prune: bool, data_dir: Path | None) -> None:
    """Back up the database, the media and the keys into DIR, while the server runs.

    Into an existing backup only new files are copied. An interrupted backup can be continued; until it is
    complete, DIR remains the earlier backup. The database is checked first; if it is damaged, no backup is
    made and the last good one is kept. DIR keeps the last two states. It contains the signing key and
    everyone's data: protect it accordingly.
    """
    from sightline.infra.backup.make import make_backup
    from sightline.infra.backup.restore import check_backup
    from sightline.infra.services import open_services

    settings = settings_of(data_dir=data_dir)
    require_database(settings)
    services = open_services(settings, decode_in_child=False)
    try:
        new_backup = make_backup(services, folder, progress_told(), pruning=prune)
    finally:
        services.close()
    removed = f", {new_backup.pruned} old ones removed" if prune else ""
    click.echo(f"{folder}: {_summary(new_backup.manifest)}; {new_backup.fresh} media files are new{removed}.")
    if reading_back:
        click.echo(read_words(folder, check_backup(folder, progress_told())))
    if missing := new_backup.manifest.missing:
        raise Damaged("backup-media-missing", count=len(missing), names=", ".join(missing[:_MISSING_SHOWN]))


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(exists=True, file_okay=False, path_type=Path))
@click.option(
    "--data-dir",
    required=True,
    type=click.Path(file_okay=False, path_type=Path),
    help="New or empty folder for the installation.",
)
@click.option("--earlier", is_flag=True, help="Restore the state before the last; DIR keeps the last two.")
def restore(folder: Path, data_dir: Path, earlier: bool) -> None:
    """Restore the backup in DIR into an empty place: data folder, database, media store.

    The database is SQLite unless SIGHTLINE_DATABASE_URL names an empty PostgreSQL database; a backup of
    either kind can be restored into either. The hash of every file and the audit chains are checked first;
    if anything is wrong, nothing is restored.
    """
    from sightline.infra.backup.restore import restore_backup

    settings = settings_of(data_dir=data_dir)
    restored = restore_backup(folder, settings, progress_told(), earlier=earlier)
    assert restored.audit is not None
    click.echo(
        f"{data_dir}: {_summary(restored.manifest)}; the audit chain of {restored.audit.checked} events is "
        f"intact, head {restored.audit.head_hash[:16]}."
    )
    for name, where in restored.manifest.keys.items():
        if where == "environment":
            click.echo(f"{name} was a setting and is not in the backup: set it to the same value.", err=True)


def read_words(folder: Path, backup_read: ReadBackup) -> str:
    """What reading a backup showed, as one sentence."""
    said = f"{folder}: {_summary(backup_read.manifest)}; every file is the one that was backed up"
    if backup_read.audit is None:
        return f"{said}. The audit chains of PostgreSQL are checked when it is restored."
    return f"{said}, and the audit chain of {backup_read.audit.checked} events is intact."


def _summary(manifest: Manifest) -> str:
    size = sum(one.size for one in (*manifest.files.values(), *manifest.media.values()))
    return f"backup of {manifest.at[:19]} UTC, {len(manifest.media)} media files, {size / 1e6:.1f} MB"
