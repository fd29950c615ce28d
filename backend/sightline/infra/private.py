"""What lies in the data folder is for the account that runs the program, and for no other of the machine."""

import logging
import os
import secrets
import stat
from contextlib import suppress
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


def made_once(path: Path) -> bytes:
    """The random text of a file (64 hexadecimal digits), which is made where it is not there."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        fresh = made_beside(path)
        with suppress(FileExistsError):  # two processes that start together end up with one secret
            os.link(fresh, path)
        fresh.unlink()
    return path.read_bytes()


def made_beside(path: Path) -> Path:
    """A file with such a text, for its owner alone and safe from a power cut, named after `path`."""
    fresh = path.with_name(f"{path.name}.{os.getpid()}-{secrets.token_hex(4)}")
    handle = os.open(fresh, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(handle, "wb") as file:
        file.write(secrets.token_hex(32).encode())
        file.flush()
        os.fsync(file.fileno())
    return fresh


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
