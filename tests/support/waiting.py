"""How tests wait for what must come."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

#: A busy machine is slow, not wrong: only what never comes fails. A run that passes never waits this long.
NEVER_S = 120.0
LOOK_S = 0.02
Found = TypeVar("Found")


def until(
    condition: Callable[[], Found | None],
    said: Callable[[], object] = lambda: "it never came",
    seconds: float = NEVER_S,
) -> Found:
    """What the condition gives once it is true; fails with what is `said` where it never is."""
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, said()
        time.sleep(LOOK_S)
    return found


def alive(pid: int) -> bool:
    """Whether a process runs; where nobody reaps orphans an ended one stays as a dead entry."""
    try:
        status = Path(f"/proc/{pid}/stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return False
    return status.rpartition(")")[2].split()[0] != "Z"
