"""What every child process of this program is started with, and what a process holds."""

import os
import resource
from pathlib import Path


def child_environment(**changed: str) -> dict[str, str]:
    """Ours with what is `changed`, so that the child finds this very package."""
    package = str(Path(__file__).resolve().parents[1])
    paths = os.pathsep.join(path for path in (package, os.environ.get("PYTHONPATH", "")) if path)
    return {**os.environ, "PYTHONPATH": paths, **changed}


def resident_bytes() -> int | None:
    """What this process has in memory now, by Linux's account of it; None where it cannot be told."""
    try:
        return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()
    except (OSError, IndexError, ValueError):
        return None
