"""What every child process of this program is started with."""

import os
from pathlib import Path


def child_environment(**changed: str) -> dict[str, str]:
    """Ours with what is `changed`, so that the child finds this very package."""
    package = str(Path(__file__).resolve().parents[1])
    paths = os.pathsep.join(path for path in (package, os.environ.get("PYTHONPATH", "")) if path)
    return {**os.environ, "PYTHONPATH": paths, **changed}
