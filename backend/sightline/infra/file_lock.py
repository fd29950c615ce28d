"""A file that one process holds at a time; the system lets go of it when that process ends."""

import fcntl
from pathlib import Path
from typing import IO


def take_lock(path: Path) -> IO[bytes] | None:
    """The file, open and held until it is closed (forks hold it too), or None where another holds it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    file = path.open("ab")
    if not hold(file):
        file.close()
        return None
    return file


def hold(file: IO[bytes]) -> bool:
    """Whether this open file is held now; not where it was opened and held before, here or elsewhere."""
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True
