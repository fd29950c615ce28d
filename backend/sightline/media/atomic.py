"""Writing a file so that it is there whole or not at all."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from uuid import uuid4

#: How the name of a file that is being written ends; one that a killed process left may go.
PART = ".part"


@contextmanager
def atomic_file(target: Path, *, lasting: bool = True) -> Iterator[Path]:
    """A path beside `target` to write to, which takes its place at the end, or is gone after an error.

    The folder is made. With `lasting`, content and name survive a power cut; without, for caches that can be
    made again, the disk is not waited for. Raises OSError.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    part = target.with_name(f".{uuid4().hex}{PART}")
    try:
        yield part
        if lasting:
            sync_to_disk(part)
        os.replace(part, target)
        if lasting:
            sync_to_disk(target.parent)
    finally:
        with suppress(OSError):
            part.unlink()


def sync_to_disk(path: Path) -> None:
    """Make a file's content, or the names in a folder, survive a power cut."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
