"""What lies in the data folder is for the account that runs the program, and for no other of the machine."""

import logging
import os
import stat
from pathlib import Path

from sightline.infra.database.engine import sqlite_file
from sightline.settings import Settings

log = logging.getLogger(__name__)

OTHERS = 0o077


def keep_private(settings: Settings) -> None:
    """What this process makes from now on is private, and what an older version left open is closed."""
    os.umask(OTHERS)
    settings.data_dir.mkdir(parents=True, exist_ok=True)
    media = Path(settings.media_url.removeprefix("file://"))
    for folder in (settings.data_dir, media):
        if folder.is_dir() and _mode(folder) & OTHERS:
            close_to_others(folder)
    database = sqlite_file(settings.database_url)
    if database is not None:
        for name in (database, *(Path(f"{database}{end}") for end in ("-wal", "-shm"))):
            if name.is_file():
                _close(name)


def close_to_others(folder: Path) -> None:
    """Take a folder and all in it from group and others; what belongs to another account stays as it is."""
    _close(folder)
    for place, folders, files in os.walk(folder):
        for name in (*folders, *files):
            _close(Path(place, name))


def _close(path: Path) -> None:
    try:
        mode = _mode(path)
        if mode & OTHERS and not path.is_symlink():
            path.chmod(mode & ~OTHERS)
    except OSError as error:
        log.warning("%s stays readable for others: %s", path, error.strerror)


def _mode(path: Path) -> int:
    return stat.S_IMODE(path.lstat().st_mode)
