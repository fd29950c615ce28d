"""The processes below a server, told apart (Linux), to be killed one at a time."""

import os
import random
import signal
from contextlib import suppress
from pathlib import Path


def children_of(pid: int) -> list[int]:
    """Direct children that still live."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            state, parent = stat.read_text().rsplit(")", 1)[1].split()[:2]
            if int(parent) == pid and state != "Z":
                found.append(int(stat.parent.name))
    return found


def processes_of(server_pid: int) -> dict[str, list[int]]:
    """Its supervisor, that one's workers, and the children that decode."""
    found: dict[str, list[int]] = {"supervisor": [], "worker": [], "decoder": []}
    for child in children_of(server_pid):
        with suppress(OSError):
            words = Path(f"/proc/{child}/cmdline").read_bytes().split(b"\0")
            kind = "supervisor" if b"worker" in words else "decoder"
            found[kind].append(child)
            if kind == "supervisor":
                found["worker"] += children_of(child)
    return found


def kill_one(server_pid: int, kind: str, drawn: random.Random) -> bool:
    """SIGKILL one process of this kind; False where there is none."""
    known = sorted(processes_of(server_pid)[kind])
    if not known:
        return False
    with suppress(ProcessLookupError):
        os.kill(drawn.choice(known), signal.SIGKILL)
        return True
    return False
