"""A process's own folder for files on their way to somewhere else, gone when the process is."""

import shutil
from contextlib import suppress
from pathlib import Path
from threading import Lock
from typing import IO
from uuid import uuid4

from sightline.infra.file_lock import hold

_HELD = ".lock"


class Scratch:
    """One folder of this process, made when it is first asked for, removed by `close`.

    A process that is killed removes nothing: its lock falls, and whoever comes next removes what it left.
    """

    def __init__(self, root: Path) -> None:
        self._root = root
        self._held: tuple[Path, IO[bytes]] | None = None
        self._making = Lock()

    def folder(self) -> Path:
        """The folder; there while this process lives."""
        with self._making:
            if self._held is None:
                self._root.mkdir(parents=True, exist_ok=True)
                self._held = _own_folder(self._root)
            return self._held[0]

    def close(self) -> None:
        """Remove the folder with all that is in it."""
        with self._making:
            if self._held is not None:
                _remove(*self._held)
                self._held = None


def sweep(root: Path) -> None:
    """Remove the folders of processes that are gone, and what is no process's."""
    if not root.is_dir():
        return
    for path in root.glob(f"*{_HELD}"):
        with suppress(FileNotFoundError):  # somebody else sweeps too
            file = path.open("rb+")
            if hold(file):
                _remove(path.with_suffix(""), file)
            else:
                file.close()
    for folder in root.iterdir():
        # a lock stands before its folder and goes after it
        if folder.is_dir() and not folder.with_suffix(_HELD).exists():
            shutil.rmtree(folder, ignore_errors=True)


def _own_folder(root: Path) -> tuple[Path, IO[bytes]]:
    """The lock is held before it has the name that others look for, and stands before its folder."""
    folder = root / uuid4().hex
    lock = folder.with_suffix(_HELD)
    made = folder.with_suffix(".new")
    file = made.open("ab")
    if not hold(file):
        raise RuntimeError(f"{made} is locked, though nobody knows its name")
    made.rename(lock)
    folder.mkdir()
    return folder, file


def _remove(folder: Path, lock: IO[bytes]) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.with_suffix(_HELD).unlink(missing_ok=True)
    lock.close()
