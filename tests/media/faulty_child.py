"""A decoding process that crashes, hangs or eats memory at certain frames of files called so."""

from __future__ import annotations

import ctypes
import os
import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from sightline.media.video import decode_child, seeker, window

AT = 40
HELD: list[bytearray] = []


def notes_of(path: Path) -> list[str]:
    """What children noted of their slow work at a recording."""
    notes = path.with_suffix(".notes")
    return notes.read_text().splitlines() if notes.exists() else []


def _note(path: Path, words: str) -> None:
    with path.with_suffix(".notes").open("a") as notes:
        notes.write(words + "\n")


def _take_long(path: Path, n: int, wanted: Callable[[], bool]) -> bool:
    """A second, or ("endless") until it is no longer wanted; whether it still is."""
    _note(path, f"{n} begun by {os.getpid()}")
    left = 10
    while left or path.name.startswith("endless"):
        time.sleep(0.1)
        left = max(0, left - 1)
        if not wanted():
            _note(path, f"{n} given up")
            return False
    return True


def _eat(name: str) -> None:
    """Memory that stays, all that there is or some for each frame."""
    while name.startswith("greedy"):
        HELD.append(bytearray(b"x") * 16_000_000)
    if name.startswith("heavy"):
        HELD.append(bytearray(b"x") * 90_000_000)


def _end(name: str) -> None:
    """Crash, at once or after a while, or be killed."""
    if name.startswith("late"):
        time.sleep(0.6)
    if name.startswith(("crash", "late")):
        ctypes.string_at(0)
    if name.startswith("killed"):
        os.kill(os.getpid(), signal.SIGKILL)


def main() -> None:
    """The child's own main with a seeker that has faults."""
    find = seeker.Seeker.find

    def faulty(self: seeker.Seeker, n: int, *rest: Any, **more: Any) -> Any:
        name = self._media.path.name
        if n >= AT:
            _end(name)
        if n >= AT and name.startswith("hang"):
            time.sleep(3600)
        if n >= AT and name.startswith("stuck"):
            ctypes.PyDLL(None).sleep(3600)  # and nothing else in the process gets on either
        if n >= AT:
            _eat(name)
        if n >= AT and name.startswith(("slow", "endless")) and not _take_long(self._media.path, n, rest[0]):
            return None
        return find(self, n, *rest, **more)

    image = window.Window.image

    def faulty_image(self: window.Window, data: bytes, name: str, **wanted: Any) -> Any:
        if name.startswith("crash"):
            ctypes.string_at(0)
        return image(self, data, name, **wanted)

    seeker.Seeker.find = faulty  # type: ignore[method-assign]
    window.Window.image = faulty_image  # type: ignore[method-assign]
    decode_child.TICK_S = 0.1
    decode_child.main()


if __name__ == "__main__":
    main()
